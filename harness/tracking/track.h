// `cylon track`: the history of accuracy and speed.  A table of subcommands, one source each (track_*.cc).
#pragma once

#include "harness/cli/context.h"
#include "harness/cli/parser.h"
#include "harness/tracking/store/store.h"

#include <string>

namespace cylon::tracking {

/// `cylon track` itself.
cli::Command add_track(cli::App&, const cli::Context&);

cli::Command add_track_record(cli::App&, const cli::Context&);
cli::Command add_track_cards(cli::App&, const cli::Context&);
cli::Command add_track_list(cli::App&, const cli::Context&);
cli::Command add_track_compare(cli::App&, const cli::Context&);
cli::Command add_track_gate(cli::App&, const cli::Context&);
cli::Command add_track_history(cli::App&, const cli::Context&);
cli::Command add_track_ack(cli::App&, const cli::Context&);
cli::Command add_track_ignore(cli::App&, const cli::Context&);
cli::Command add_track_import(cli::App&, const cli::Context&);
cli::Command add_track_export(cli::App&, const cli::Context&);
cli::Command add_track_check(cli::App&, const cli::Context&);
cli::Command add_track_pin(cli::App&, const cli::Context&);

/// Where a folder's history is kept unless --store says otherwise.
inline constexpr const char* default_store = ".cylon/history.db";

/// `--store FILE`, default_store at first.
void add_store_option(cli::App&, std::string& file);

/// The run that a user names: number, uid, label or revision; throws core::InputError where there is none.
store::RunInfo find_run(const store::Store&, const std::string& word);

}  // namespace cylon::tracking
