// The rows of reference/simulators/engines.txt, as CMake generates them.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace cylon::process {

struct BuiltEngine {
  const char *id, *build, *path;
  bool compared;           ///< By commands that compare engines, when none is named.
  const char* brought_by;  ///< Command that installs and builds it where it is missing; "": always built.
  bool takes_plugins;      ///< Its worker takes the words `--plugin NAME FILE`.
  const char* npm;         ///< The npm package that its worker, a script of Node, needs; "": none.
  bool packaged;  ///< Its worker is a program that an installation can have, and not a script of the sources.
};

std::span<const BuiltEngine> engine_table();

/// The ids of the engines that are compared.
std::vector<std::string> compared_engines();

}  // namespace cylon::process
