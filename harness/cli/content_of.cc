#include "harness/cli/content_of.h"

#include "harness/core/content_hash.h"
#include "harness/core/files.h"
#include "harness/study/modules.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <string_view>
#include <system_error>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view between("\0", 1);

// What a program loads from its own folder: the shared libraries whose names stand in its bytes, by name.  Libraries of the
// system are those of the machine, and a stored answer may come from another (study::content_hash counts them).
std::vector<fs::path> own_libraries(const fs::path& program, std::string_view bytes) {
  std::vector<fs::path> found;
  std::error_code ignored;
  for (const fs::directory_entry& entry : core::entries_of(program.parent_path()))
    if (entry.path().extension() == ".so" && entry.is_regular_file(ignored) &&
        bytes.find(entry.path().filename().string()) != std::string_view::npos)
      found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

void add_file(core::ContentHash& content, const std::string& word) {
  const fs::path file = fs::canonical(word);  // a worker may be a link to that of all engines of its kind
  const std::string bytes = core::whole_file(file);
  content.add(bytes);
  std::vector<fs::path> others = own_libraries(file, bytes);
  std::ranges::copy(study::modules_beside(file), std::back_inserter(others));
  for (const fs::path& other : others) {
    for (const std::string& part : {other.filename().string(), core::whole_file(other)}) {
      content.add(between);
      content.add(part);
    }
  }
}

}  // namespace

std::string content_of(const std::vector<std::string>& command) {
  static std::map<std::vector<std::string>, std::string> known;
  auto found = known.find(command);
  if (found == known.end()) {
    core::ContentHash content;
    for (const std::string& word : command) {
      content.add(between);
      std::error_code ignored;
      if (fs::is_regular_file(word, ignored)) {
        add_file(content, word);
      } else {
        content.add(word);
      }
    }
    found = known.emplace(command, content.hex()).first;  // kept only when it is whole
  }
  return found->second;
}

}  // namespace cylon::cli
