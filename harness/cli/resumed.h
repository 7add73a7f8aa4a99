// What a command with --resume says before it begins.
#pragma once

#include "reports/text.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace cylon::cli {

/// "resumed: 3 runs are done already\n"; with none that there was nothing to resume.
inline std::string resumed(std::size_t done, std::string_view one, std::string_view many = "") {
  return done == 0 ? fmt::format("nothing to resume: this folder holds no {} of this command\n", one)
                   : fmt::format("resumed: {} {} done already\n", reports::counted(done, one, many),
                                 done == 1 ? "is" : "are");
}

}  // namespace cylon::cli
