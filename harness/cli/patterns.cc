#include "harness/cli/patterns.h"

#include "harness/cli/context.h"
#include "harness/scenario/glob.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace cylon::cli {
namespace {

bool is_there(const std::string& path) {
  std::error_code ignored;
  return is_path(path) && std::filesystem::exists(path, ignored);
}

Pattern parse(std::string text) {
  Pattern pattern;
  if (text.starts_with('-')) pattern.exclude = true, text.erase(0, 1);
  const std::size_t ending = text.find(".toml/");
  const std::size_t slash =
      is_path(text) ? std::string::npos : text.find('/', ending == std::string::npos ? 0 : ending);
  pattern.scenario = text.substr(0, slash);
  if (slash != std::string::npos) pattern.engine = text.substr(slash + 1);
  if (is_path(pattern.scenario) && !is_there(pattern.scenario))
    throw core::InputError(fmt::format("{}: there is no such file", pattern.scenario));
  return pattern;
}

// A glob takes in no file, which is named by its path; it may exclude one by its name.
bool hits(const Pattern& p, const std::string& scenario) {
  if (p.scenario == scenario) return true;
  if (!is_path(scenario)) return scenario::glob_match(p.scenario, scenario);
  return p.exclude && scenario::glob_match(p.scenario, std::filesystem::path(scenario).stem().string());
}

}  // namespace

bool is_glob(const std::string& word) { return word.find_first_of("*?") != std::string::npos; }

std::vector<Pattern> parse_patterns(const std::vector<std::string>& words) {
  std::vector<Pattern> patterns;
  for (const std::string& word : words) {
    if (is_there(word)) {
      patterns.push_back({.scenario = word});
      continue;
    }
    std::istringstream parts(word);
    for (std::string part; std::getline(parts, part, ':');)
      if (!part.empty()) patterns.push_back(parse(part));
  }
  return patterns;
}

bool taken(const std::vector<Pattern>& patterns, const std::string& scenario, const std::string& engine) {
  bool any = false, in = false;
  for (const Pattern& p : patterns) {
    const bool hit = hits(p, scenario) && scenario::glob_match(p.engine, engine);
    if (p.exclude && hit) return false;
    if (!p.exclude) any = true, in = in || hit;
  }
  return !any || in;
}

bool may_be_taken(const std::vector<Pattern>& patterns, const std::string& scenario) {
  const auto excludes = [](const Pattern& p) { return p.exclude; };
  return std::all_of(patterns.begin(), patterns.end(), excludes) ||
         std::any_of(patterns.begin(), patterns.end(),
                     [&](const Pattern& p) { return !p.exclude && hits(p, scenario); });
}

}  // namespace cylon::cli
