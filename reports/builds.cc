#include "reports/builds.h"

#include "harness/results/build.h"

#include <fmt/format.h>

namespace cylon::reports {

std::string costs_of_another_build(const std::map<std::string, std::string>& versions,
                                   const ConsoleOptions& options) {
  std::map<std::string, std::string> builds;
  for (const auto& [engine, version] : versions) {
    const std::string build = results::build_of(version);
    if (!build.empty()) builds[engine.substr(0, engine.find('/'))] = build;
  }
  std::string text;
  for (const auto& [engine, build] : builds)
    text += shown(fmt::format("{}: costs of {}, not of native code.", engine, build), options) + '\n';
  return text;
}

}  // namespace cylon::reports
