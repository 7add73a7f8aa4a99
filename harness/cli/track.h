// `cylon track`: the history of accuracy and speed.  A table of subcommands, one source each (track_*.cc).
#pragma once

#include "harness/cli/app.h"
#include "reports/store/store.h"

#include <string>

namespace cylon::cli {

Command add_track_record(CLI::App&, const Context&);
Command add_track_list(CLI::App&, const Context&);
Command add_track_compare(CLI::App&, const Context&);
Command add_track_gate(CLI::App&, const Context&);
Command add_track_history(CLI::App&, const Context&);
Command add_track_ack(CLI::App&, const Context&);
Command add_track_ignore(CLI::App&, const Context&);
Command add_track_import(CLI::App&, const Context&);
Command add_track_export(CLI::App&, const Context&);
Command add_track_check(CLI::App&, const Context&);
Command add_track_pin(CLI::App&, const Context&);

/// Where a folder's history is kept unless --store says otherwise.
inline constexpr const char* default_store = ".cylon/history.db";

/// `--store FILE`, default_store at first.
void add_store_option(CLI::App&, std::string& file);

/// The run that a user names: number, uid, label or revision; throws core::InputError where there is none.
store::RunInfo find_run(const store::Store&, const std::string& word);

}  // namespace cylon::cli
