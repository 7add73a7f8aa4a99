#include "tests/fuzz/targets/folder.h"

#include "tests/fuzz/targets/targets.h"

#include <stdlib.h>

#include <cstdlib>
#include <string>
#include <system_error>

namespace cylon::fuzz {

namespace fs = std::filesystem;

const fs::path& folder() {
  static const fs::path made = [] {
    const fs::path memory = "/dev/shm";
    std::string name =
        ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "cylon-fuzz-XXXXXX");
    if (!::mkdtemp(name.data())) throw Broken("a folder for files: " + name);
    static const std::string kept = name;
    std::atexit([] {
      std::error_code ignored;
      fs::remove_all(kept, ignored);
    });
    return fs::path(name);
  }();
  return made;
}

}  // namespace cylon::fuzz
