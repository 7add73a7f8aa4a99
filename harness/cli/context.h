// Where things are on this machine, and what the console can show.
#pragma once

#include "harness/core/input_error.h"
#include "harness/process/engines.h"
#include "harness/scenario/expected.h"
#include "harness/scenario/scenario.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cylon::cli {

/// The exit codes; where several apply, the first of 2, 130, 141, 5, 1, 6, 3, 4.
enum Exit {
  ok = 0,
  differs = 1,
  bad_input = 2,
  inconclusive = 3,
  nothing_selected = 4,
  harness_failure = 5,
  incomplete = 6,
  interrupted = 130,
  no_reader = 141
};

class Farm;

/// Of what is written to a file or a pipe [columns].
inline constexpr int width_without_terminal = 160;

struct Context {
  std::filesystem::path scenarios;          ///< The folder with *.toml, expected.toml and suites/.
  std::filesystem::path workers;            ///< The folder with the worker executables.
  std::vector<process::EngineRow> engines;  ///< Built in, and what the user adds.
  std::string command_line;                 ///< As it was typed.
  bool utf8 = true;
  bool colour = false;    ///< On stdout: a terminal, and NO_COLOR is not set.
  bool progress = false;  ///< On stderr: a terminal, and CI is not set.
  int width = 100;        ///< Of the terminal [columns].
  Farm* farm = nullptr;   ///< Where `cylon farm` shares the command out.
};

/// From the place of this executable (folders.h), CYLON_SCENARIOS and CYLON_WORKERS.
Context make_context();

/// expected.toml of the folder; without one, every verdict is expected to pass.
scenario::Expectations expectations(const Context&);

/// Every scenario file of the folder and of its subfolders extremes/ and validation/, by name.
std::vector<std::filesystem::path> scenario_files(const Context&);

/// That of a name, or nothing.
std::optional<std::filesystem::path> own_scenario(const Context&, const std::string& name);

/// Whether a word names a file (it ends in .toml, or is one that `cylon import` takes) rather than a scenario of the
/// folder.
bool is_path(const std::string& word);

/// "no scenario 'x' in …, did you mean 'y'?"
core::InputError unknown_scenario(const Context&, const std::string& name);

/// A file by its path, or a scenario of the folder by its name; throws core::InputError with the nearest
/// name.
std::filesystem::path find_scenario(const Context&, const std::string& name_or_path);

}  // namespace cylon::cli
