// Where a program of ours finds its data: the one place that knows the layout of a build and of an installation
// (cmake/install.cmake writes the latter).
#pragma once

#include <filesystem>

namespace cylon::cli {

struct Folders {
  std::filesystem::path scenarios;  ///< *.toml, expected.toml and suites/.
  std::filesystem::path workers;    ///< cylon-worker-*.
  bool installed = false;
};

/// Those of the program at this place, by its place alone, so that an installation may be moved:
///
///     program                 scenarios                     workers
///     PREFIX/bin/cylon        PREFIX/share/cylon/scenarios  PREFIX/libexec/cylon   where the first is there
///     ROOT/build/PRESET/name  ROOT/scenarios                ROOT/build/PRESET      else
Folders folders_of(const std::filesystem::path& program);

/// The workers that lie in a folder or, where it is the prefix of an installation, in its libexec/cylon; empty where there
/// are none.
std::filesystem::path workers_below(const std::filesystem::path& folder);

}  // namespace cylon::cli
