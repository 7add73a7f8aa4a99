#include "harness/study/modules.h"

#include "harness/core/files.h"

#include <algorithm>
#include <array>
#include <system_error>

namespace cylon::study {

namespace fs = std::filesystem;

std::vector<fs::path> modules_beside(const fs::path& script) {
  constexpr std::array extensions = {".mjs", ".cjs", ".js", ".py"};
  std::error_code ignored;
  const fs::path file = fs::canonical(script);
  const fs::path folder = file.parent_path(), extension = file.extension();
  if (std::ranges::find(extensions, extension) == extensions.end()) return {};
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : core::entries_of(folder))
    if (entry.path().extension() == extension && entry.path() != file && entry.is_regular_file(ignored))
      found.push_back(entry.path());
  std::ranges::sort(found);
  for (const char* lock : {"package-lock.json", "node_modules/.package-lock.json"})
    if (fs::is_regular_file(folder / lock, ignored)) found.push_back(folder / lock);
  return found;
}

}  // namespace cylon::study
