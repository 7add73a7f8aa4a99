#include "harness/cli/progress.h"

#include <iostream>

namespace cylon::cli {

void show_progress(bool on, std::string_view line) {
  if (on) std::cerr << '\r' << line << "\x1b[K" << std::flush;
}

}  // namespace cylon::cli
