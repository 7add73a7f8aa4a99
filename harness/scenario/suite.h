// A named selection of scenarios, engines with their settings, and steps: the published tables are suites.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::scenario {

/// A number that someone published, as printed there.
struct Published {
  std::string engine;  ///< One of Suite::engines.
  std::string dt;      ///< One of Suite::steps, as written.
  std::string value;   ///< Its digits say how exactly it is known: "185.027".
  std::string source;
};

struct Suite {
  std::string name;  ///< The file's name without its ending.
  std::string title, story;
  std::string claim;                   ///< Glob over the claim labels that `published` speaks of.
  std::vector<std::string> scenarios;  ///< Globs over scenario names.
  std::vector<std::string> engines;    ///< Ids, with options where any: "ode/erp=0,cfm=0".
  std::vector<std::string> steps;      ///< As written: "0.001", "1/60"; empty: each scenario's nominal one.
  std::vector<Published> published;
};

/// Throws core::InputError with the place; a published row must name an engine and a step of the suite.
Suite load_suite(const std::filesystem::path&);
Suite parse_suite(std::string_view text, const std::string& file_name);

}  // namespace cylon::scenario
