// `cylon track`: the history of accuracy and speed.  A table of subcommands, one source each (track_*.cc).
#pragma once

#include "harness/cli/app.h"
#include "reports/store/store.h"

#include <string>

namespace cylon::cli {

Command add_track_record(App&, const Context&);
Command add_track_list(App&, const Context&);
Command add_track_compare(App&, const Context&);
Command add_track_gate(App&, const Context&);
Command add_track_history(App&, const Context&);
Command add_track_ack(App&, const Context&);
Command add_track_ignore(App&, const Context&);
Command add_track_import(App&, const Context&);
Command add_track_export(App&, const Context&);
Command add_track_check(App&, const Context&);
Command add_track_pin(App&, const Context&);

/// Where a folder's history is kept unless --store says otherwise.
inline constexpr const char* default_store = ".cylon/history.db";

/// `--store FILE`, default_store at first.
void add_store_option(App&, std::string& file);

/// The run that a user names: number, uid, label or revision; throws core::InputError where there is none.
store::RunInfo find_run(const store::Store&, const std::string& word);

}  // namespace cylon::cli
