// cylon track import
#include "harness/cli/read_whole.h"
#include "harness/tracking/track.h"

#include "harness/tracking/store/google_benchmark.h"
#include "harness/tracking/store/json_lines.h"
#include "harness/tracking/store/samples_csv.h"
#include "reports/provenance.h"

#include <fmt/format.h>

#include <iostream>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

using store::Imported;

constexpr std::size_t most_bytes = std::size_t{512} << 20;    ///< Of all files of one call.
constexpr std::size_t most_at_once = std::size_t{128} << 20;  ///< Of one whose values are held all at once.

struct Options {
  std::string store, revision, label;
  std::vector<std::string> files;
};

// Which format it is shows in its first bytes.
Imported import(store::Store& store, const std::string& text, const std::string& name,
                const Options& options) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const std::string_view head = start == std::string::npos ? "" : std::string_view(text).substr(start);
  if (head.starts_with("{\"cylon_history\"")) return store::read_json_lines(store, text, name);
  if (text.size() > most_at_once)
    throw core::InputError(
        fmt::format("{}: more than {} MB; only JSON Lines of `cylon track export` may have more", name,
                    most_at_once >> 20));
  if (!head.starts_with('{')) return store::read_samples_csv(store, text, name);
  const reports::Provenance build = reports::build_and_machine();
  store::RunInfo run;
  run.label = options.label;
  run.revision = options.revision.empty() ? build.revision : options.revision;
  run.compiler = build.compiler;
  run.flags = build.flags;
  run.os = build.os;
  return store::read_google_benchmark(store, text, name, run);
}

int import(const Options& options) {
  std::vector<std::pair<std::string, std::string>> texts;  // all read before the store is touched
  std::size_t left = most_bytes;
  for (const std::string& file : options.files) {
    texts.emplace_back(file == "-" ? "stdin" : file, read_whole(file, left));
    left -= texts.back().second.size();
  }
  store::Store store = store::Store::open(options.store, store::Mode::write);
  store.set_author(store::Author::import);
  Imported all;
  store.in_one_transaction([&] {
    for (const auto& [name, text] : texts) {
      const Imported one = import(store, text, name, options);
      all.runs += one.runs, all.results += one.results, all.here_already += one.here_already;
    }
  });
  std::cout << fmt::format("{}: {} runs and {} results added, {} were there already\n", options.store,
                           all.runs, all.results, all.here_already);
  return ok;
}

}  // namespace

Command add_track_import(App& app, const Context&) {
  const auto options = std::make_shared<Options>();
  app.add_option("files", options->files,
                 "Files from `cylon track export` (jsonl, csv), other CSV with the same columns, or Google "
                 "Benchmark files (--benchmark_out=FILE); - is stdin. Either all files are imported, or none")
      ->type_name("FILE")
      ->required();
  app.add_option("--revision", options->revision,
                 "Revision that a Google Benchmark file measured. Default: the revision of this program")
      ->type_name("TEXT");
  app.add_option("--label", options->label, "A label for the run of a Google Benchmark file")
      ->type_name("TEXT");
  add_store_option(app, options->store);
  app.footer(
      "Results that are already stored are skipped, so a repeated import adds nothing, and files of several "
      "machines merge into one history.");
  return [options] { return import(*options); };
}

}  // namespace cylon::tracking
