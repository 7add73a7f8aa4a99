// cylon track pin, and the pinned binaries of a recording.
#include "harness/tracking/track_anchor.h"

#include "harness/cli/command_line.h"
#include "harness/cli/provenance_now.h"
#include "harness/cli/workers.h"
#include "harness/process/client.h"
#include "harness/process/failure.h"
#include "harness/process/sandbox.h"
#include "harness/study/side.h"
#include "harness/tracking/track.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <sstream>
#include <string_view>
#include <system_error>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

namespace fs = std::filesystem;

struct Options {
  std::string store, name, engine = "in-house", note;
  Brought brought;
};

// Before the engine's name in the binary of an anchor that was pinned under --sandbox, as on a command line.
constexpr std::string_view in_sandbox = "--sandbox ";

// A script, or a program with libraries beside it, does not start elsewhere.
void require_start(process::EngineRow row) try {
  row.brought_by.clear();  // what brings it brings no copy
  process::describe({.id = row.id, .row = row, .path = "", .integrator = "", .options = {}});
} catch (const process::Failure& failure) {
  std::error_code ignored;
  fs::remove(row.command.front(), ignored);
  throw core::InputError(
      row.command.front(), 0, 0,
      fmt::format("the copy of the worker does not start ({}), so that no recording could be "
                  "timed against it; an anchor is one file, and needs no other beside it",
                  failure.what()));
}

// The binary is copied beside the store, as the next build would overwrite it.
int pin(const Context& context, const Options& options) {
  if (options.name.empty() || options.name.find_first_of("/*?[ =") != std::string::npos)
    throw core::InputError(fmt::format("'{}': the name of an anchor must not contain / * ? [ = or a space",
                                       plain(options.name)));
  process::EngineRow row = process::parse_engine(options.engine, with_brought(context, options.brought)).row;
  if (row.id != options.engine)
    throw core::InputError(
        fmt::format("--engine {}: an anchor is an engine without a variant", options.engine));
  if (store::Store::is_on_server(options.store))
    throw core::InputError(
        "track pin: an anchor's binary is copied beside the store, and beside a server there is no folder; "
        "keep anchors in a file (--store FILE)");
  store::Store store = store::Store::open(options.store, store::Mode::write);
  const fs::path relative =
      fs::path("anchors") / (options.name + "-" + fs::path(row.command.front()).filename().string());
  const fs::path copy = fs::path(options.store).parent_path() / relative;
  const fs::path staged = copy.string() + ".new";  // what was pinned before stays if this does not start
  std::error_code error;
  fs::create_directories(copy.parent_path(), error);
  if (!error) fs::copy_file(row.command.front(), staged, fs::copy_options::overwrite_existing, error);
  if (!error) row.command.front() = staged.string(), require_start(row), fs::rename(staged, copy, error);
  if (error)
    throw core::InputError(copy.string(), 0, 0,
                           fmt::format("the binary cannot be stored here: {}", error.message()));
  row.command.front() = copy.string();
  const std::string build = study::content_hash(row.command);
  row.command.front() = relative.string();
  store.pin({.name = options.name,
             .binary = fmt::format("{}{}={}", process::sandboxing() ? in_sandbox : "", row.id,
                                   fmt::join(row.command, " ")),
             .build = build,
             .date = now(),
             .note = options.note,
             .run = ""});
  std::cout << fmt::format("{}: {} is pinned as {}; every recording is timed against it\n", options.store,
                           row.id, options.name);
  return ok;
}

// Below the folder of the store's anchors, whatever the store says.
bool is_inside(const fs::path& program) {
  const fs::path plain_path = program.lexically_normal();
  return plain_path == program && program.is_relative() && program.begin() != program.end() &&
         *program.begin() == "anchors";
}

}  // namespace

std::vector<PinnedEngine> pinned_engines(const store::Store& store, const fs::path& store_file) {
  std::vector<PinnedEngine> engines;
  for (const store::Anchor& anchor : store.anchors()) {
    PinnedEngine engine{anchor.name, {}};
    const bool sandboxed = anchor.binary.starts_with(in_sandbox);
    const std::string binary = anchor.binary.substr(sandboxed ? in_sandbox.size() : 0);
    const std::size_t equals = binary.find('=');
    if (equals == std::string::npos) continue;  // a run of another machine, imported: nothing to start
    engine.row.id = binary.substr(0, equals);
    std::istringstream words(binary.substr(equals + 1));
    for (std::string word; words >> word;) engine.row.command.push_back(word);
    if (engine.row.command.empty()) continue;
    std::string& program = engine.row.command.front();
    if (!store.is_own(anchor) || !is_inside(program)) {
      std::cerr << plain_line(fmt::format(
                       "anchor '{0}' was not pinned by you here, so its program is not run; pin your "
                       "own: `cylon track pin {0}`",
                       anchor.name))
                << '\n';
      continue;
    }
    if (sandboxed) process::require_sandbox_again(fmt::format("anchor '{}' was pinned", anchor.name));
    program = (store_file.parent_path() / program).string();
    std::error_code ignored;
    if (!fs::is_regular_file(program, ignored) || study::content_hash(engine.row.command) != anchor.build)
      throw core::InputError(
          program, 0, 0,
          fmt::format("the pinned binary of anchor '{0}' is gone or changed; bring it back, or "
                      "pin another: `cylon track pin {0}`",
                      anchor.name));
    engines.push_back(std::move(engine));
  }
  return engines;
}

process::EngineChoice in_place_of(const process::EngineChoice& engine, const PinnedEngine& anchor) {
  process::EngineChoice choice = engine;
  if (engine.row.id != anchor.row.id) choice = {anchor.row.id, anchor.row, "", "", {}};
  choice.row.command = anchor.row.command;
  return choice;
}

Command add_track_pin(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("name", options->name, "Name of the anchor: v1, baseline")->type_name("NAME")->required();
  app.add_option("--engine", options->engine, "Engine whose present worker is kept")
      ->type_name("ID")
      ->capture_default_str();
  app.add_option("--note", options->note, "Reason for this choice")->type_name("TEXT");
  add_brought_options(app, options->brought);
  add_store_option(app, options->store);
  app.footer(
      "Copies the worker beside the store. From then on `cylon track record` times each cell in turn with it "
      "and stores the ratios, which do not change when the machine becomes slower. The same name again "
      "replaces it.");
  return [options, &context] { return pin(context, *options); };
}

}  // namespace cylon::tracking
