#include "reference/formats/sdformat/includes.h"

#include "reference/formats/resources/resources.h"

#include <sdf/sdf.hh>

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

namespace cylon::formats {
namespace {

namespace fs = std::filesystem;
using Find = std::function<std::string(const std::string&)>;

// What one file includes: the library is told that nothing of it is there, and goes no deeper.
std::vector<std::string> included_by(const std::string& file, const Find& find) {
  std::vector<std::string> files;
  sdf::ParserConfig config;
  config.SetWarningsPolicy(sdf::EnforcementPolicy::LOG);
  config.SetFindCallback([&](const std::string& uri) -> std::string {
    std::string found = find(uri);
    if (fs::is_directory(found)) found = sdf::getModelFilePath(found);
    if (fs::is_regular_file(found)) files.push_back(fs::canonical(found).string());
    return "";
  });
  sdf::Errors of_no_concern;  // the library tells them when it reads the file
  sdf::readFile(file, config, of_no_concern);
  return files;
}

class Walk {
 public:
  explicit Walk(const Find& find) : find_(find) {}

  void visit(const std::string& file) {
    if (const auto begin = std::ranges::find(way_, file); begin != way_.end()) {
      std::string text = "a file includes itself: ";
      for (auto it = begin; it != way_.end(); ++it) text += *it + " → ";
      throw Refused(text + file);
    }
    if (!seen_.insert(file).second) return;
    way_.push_back(file);
    for (const std::string& other : included_by(file, find_)) visit(other);
    way_.pop_back();
  }

 private:
  const Find& find_;
  std::vector<std::string> way_;
  std::set<std::string> seen_;
};

}  // namespace

void require_no_circle(const std::string& file, const Find& find) {
  if (fs::is_regular_file(file)) Walk(find).visit(fs::canonical(file).string());
}

}  // namespace cylon::formats
