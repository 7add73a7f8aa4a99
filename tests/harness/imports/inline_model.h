// A model of a few lines in a test, imported by the library of its format.
#pragma once

#include "harness/core/input_error.h"
#include "harness/imports/imports.h"
#include "harness/imports/program.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace cylon::imports {

/// What became of it: the lines of what is left out and the scenario, or why it is refused.
struct Outcome {
  std::string refusal;  ///< "" where it is imported.
  std::string left_out;
  std::optional<scenario::Scenario> scenario;

  const core::Scene& scene() const { return scenario.value().scene; }
  bool refuses(const std::string& text) const { return refusal.find(text) != std::string::npos; }
  bool leaves_out(const std::string& text) const { return left_out.find(text) != std::string::npos; }
};

/// Whether the library of files with this ending is here, for MJCF the newer one.
inline bool can_import(const std::string& ending) {
  const Format& format = *format_of("model." + ending);
  const std::filesystem::path folder = binary_dir;
  return std::filesystem::exists(folder / (format.newer.empty() ? format.program : format.newer));
}

inline Outcome import_text(const std::string& text, const std::string& ending, const Options& options = {},
                           const std::filesystem::path& programs = binary_dir) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / ("model." + ending);
  std::ofstream(file) << text;
  Outcome outcome;
  try {
    const Imported imported = import_file(file, options, programs);
    for (const std::string& line : imported.left_out) outcome.left_out += line + '\n';
    outcome.scenario = scenario::parse(imported.toml, "imported.toml");
  } catch (const core::InputError& error) {
    outcome.refusal = error.what();
  }
  return outcome;
}

#define REQUIRE_IMPORT(ending) \
  if (!can_import(ending)) GTEST_SKIP() << "no library for ." ending

}  // namespace cylon::imports
