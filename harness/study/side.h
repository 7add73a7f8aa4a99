// One of the two builds that are compared: the same engine ids, other workers behind them.
#pragma once

#include "harness/process/engines.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::study {

struct Side {
  std::string name;  ///< As the user knows it: "build/release", "main = 1a2b3c4d".
  std::vector<process::EngineRow> engines;
};

/// The engine with this side's worker; nothing where the side has none of that id, or its program is not
/// there.
std::optional<process::EngineChoice> on(const Side&, const process::EngineChoice&);

/// 16 hex digits of SHA-256 of all that decides what the worker does: the words of its command that are no
/// files, and the content of those that are, of the shared libraries that `ldd` finds for the program and of the
/// modules beside a script.  Where files lie does not count.
std::string content_hash(const std::vector<std::string>& command);

}  // namespace cylon::study
