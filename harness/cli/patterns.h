// "bounce*:-*/ode": globs over scenarios and engines, some of which exclude.
#pragma once

#include <string>
#include <vector>

namespace cylon::cli {

struct Pattern {
  std::string scenario;      ///< Glob over names, or the path of a file.
  std::string engine = "*";  ///< Glob over engine ids.
  bool exclude = false;
};

/// Whether the word has a '*' or '?'.
bool is_glob(const std::string& word);

/// Splits each word at ':' (unless it is a file), takes a leading '-' as exclusion, and splits
/// SCENARIO/ENGINE at the first '/', behind the ".toml" of a file.  Throws core::InputError for a file that
/// is not there.
std::vector<Pattern> parse_patterns(const std::vector<std::string>& words);

/// Whether the patterns take a scenario on an engine; with no including pattern, all that are not excluded.
/// `scenario` is the path as given for a file, else the name.
bool taken(const std::vector<Pattern>&, const std::string& scenario, const std::string& engine);

/// Whether they may take it on some engine.
bool may_be_taken(const std::vector<Pattern>&, const std::string& scenario);

}  // namespace cylon::cli
