// What is said beside costs that are not those of native code.  Knows no table.
#pragma once

#include "reports/console_options.h"

#include <map>
#include <string>

namespace cylon::reports {

/// A line for each engine whose version says in brackets what runs it, "1.1.0 (WebAssembly in Node 20.20.2)": its costs
/// are of that, and not those of its native library.  Versions by engine; of a variant its engine is named.
std::string costs_of_another_build(const std::map<std::string, std::string>& versions, const ConsoleOptions&);

}  // namespace cylon::reports
