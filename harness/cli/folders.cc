#include "harness/cli/folders.h"

#include <system_error>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

bool has_workers(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with("cylon-worker-")) return true;
  return false;
}

}  // namespace

Folders folders_of(const fs::path& program) {
  const fs::path here = program.parent_path();
  const fs::path prefix = (here / "..").lexically_normal();
  std::error_code ignored;
  const fs::path installed = prefix / "share" / "cylon" / "scenarios";
  if (here.filename() == "bin" && fs::is_directory(installed, ignored))
    return {installed, prefix / "libexec" / "cylon", true};
  return {(prefix / ".." / "scenarios").lexically_normal(), here, false};
}

fs::path workers_below(const fs::path& folder) {
  for (const fs::path& place : {folder, folder / "libexec" / "cylon"})
    if (has_workers(place)) return place;
  return {};
}

}  // namespace cylon::cli
