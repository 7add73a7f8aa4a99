// cylon track export
#include "harness/cli/output.h"
#include "harness/tracking/track.h"

#include "harness/tracking/store/google_benchmark.h"
#include "harness/tracking/store/json_lines.h"
#include "harness/tracking/store/samples_csv.h"

#include <fmt/format.h>

#include <filesystem>
#include <ostream>
#include <system_error>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

struct Options {
  std::string store, target, format = "jsonl", run;
};

int write(const Options& options) {
  require_writable(options.target);
  std::error_code ignored;
  if (std::filesystem::equivalent(options.target, options.store, ignored))
    throw core::InputError(fmt::format("{}: is the history itself; give another file", options.target));
  const bool one_run = options.format == "gbench";
  if (one_run == options.run.empty())
    throw core::InputError(one_run
                               ? "--format gbench writes one run: choose it with --run"
                               : "--run is for --format gbench; the other formats write the whole history");
  const store::Store store = store::Store::open(options.store, store::Mode::read);
  if (one_run) {
    const store::RunInfo run = find_run(store, options.run);
    write_whole(options.target, [&](std::ostream& out) { store::write_google_benchmark(store, run, out); });
  } else {
    const auto writer = options.format == "csv" ? store::write_samples_csv : store::write_json_lines;
    write_whole(options.target, [&](std::ostream& out) { writer(store, out); });
  }
  return ok;
}

}  // namespace

Command add_track_export(App& app, const Context&) {
  const auto options = std::make_shared<Options>();
  app.add_option("file", options->target, "Where to; - is stdout")->type_name("FILE")->required();
  app.add_option("--format", options->format,
                 "jsonl: everything, for import without loss; csv: the samples, one per line; gbench: the "
                 "times of one run in Google Benchmark's format, for its compare.py")
      ->check(one_of({"jsonl", "csv", "gbench"}))
      ->capture_default_str();
  app.add_option("--run", options->run,
                 "The run to write with --format gbench: number, uid, label or revision")
      ->type_name("RUN");
  add_store_option(app, options->store);
  return [options] { return write(*options); };
}

}  // namespace cylon::tracking
