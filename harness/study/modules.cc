#include "harness/study/modules.h"

#include <algorithm>
#include <array>
#include <system_error>

namespace cylon::study {

namespace fs = std::filesystem;

std::vector<fs::path> modules_beside(const fs::path& script) {
  constexpr std::array extensions = {".mjs", ".cjs", ".js", ".py"};
  std::error_code ignored;
  const fs::path file = fs::canonical(script, ignored);
  const fs::path folder = file.parent_path(), extension = file.extension();
  if (std::ranges::find(extensions, extension) == extensions.end()) return {};
  std::vector<fs::path> found;
  std::error_code error;
  const fs::directory_iterator entries(folder, error);
  if (error == std::errc::not_enough_memory || error == std::errc::too_many_files_open)
    throw std::system_error(error);
  for (const fs::directory_entry& entry : entries)
    if (entry.path().extension() == extension && entry.path() != file && entry.is_regular_file(ignored))
      found.push_back(entry.path());
  std::ranges::sort(found);
  for (const char* lock : {"package-lock.json", "node_modules/.package-lock.json"})
    if (fs::is_regular_file(folder / lock, ignored)) found.push_back(folder / lock);
  return found;
}

}  // namespace cylon::study
