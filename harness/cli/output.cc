#include "harness/cli/output.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <vector>

namespace cylon::cli {

namespace fs = std::filesystem;

namespace {

bool is_special(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// Where a symbolic link leads, so that the link stays one.
fs::path followed(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(fs::absolute(path), error);
  return error ? fs::path(path) : target;
}

// An empty file beside the target that nobody had a chance to name before, so that no link leads elsewhere; it goes
// unless it has taken the target's place.
class DraftFile {
 public:
  DraftFile(const fs::path& target, const std::string& path)
      : target_(target), name_(target.string() + ".XXXXXX.partial") {
    const int fd = ::mkostemps(name_.data(), 8, O_CLOEXEC);
    if (fd < 0)
      throw core::InputError(
          fmt::format("{}: cannot be written: {}", path, std::generic_category().message(errno)));
    // As any new file; where the target is there, as that.
    struct stat before = {};
    const mode_t mask = ::umask(0);
    ::umask(mask);
    const mode_t mode = ::stat(target_.c_str(), &before) == 0 ? before.st_mode & 07777u : 0666u & ~mask;
    [[maybe_unused]] const int changed = ::fchmod(fd, mode);
    ::close(fd);
  }
  ~DraftFile() { ::unlink(name_.c_str()); }
  DraftFile(const DraftFile&) = delete;
  DraftFile& operator=(const DraftFile&) = delete;

  const std::string& name() const { return name_; }
  bool takes_its_place() const { return ::rename(name_.c_str(), target_.c_str()) == 0; }

 private:
  fs::path target_;
  std::string name_;
};

// The files that are there and that the command line names, as often as it does: in words of their own, and in parts of
// words as `--worker name=python3 engine.py` has them.
std::vector<fs::path>& named_files() {
  static std::vector<fs::path> files;
  return files;
}

}  // namespace

void note_words(std::span<const std::string> words) {
  for (const std::string& word : words) {
    std::set<fs::path> of_word;
    const auto note = [&](const std::string& path) {
      std::error_code ignored;
      if (!path.empty() && fs::is_regular_file(path, ignored)) of_word.insert(followed(path));
    };
    note(word);
    std::string parts = word;
    std::ranges::replace(parts, '=', ' ');
    std::istringstream each(parts);
    for (std::string part; each >> part;) note(part);
    if (const std::size_t equals = word.find('='); equals != std::string::npos) note(word.substr(equals + 1));
    named_files().insert(named_files().end(), of_word.begin(), of_word.end());
  }
}

void require_writable(const std::string& path) {
  if (path.empty() || path == "-" || is_special(path)) return;
  const auto refuse = [&](const std::string& why) {
    return core::InputError(fmt::format("{}: {}", path, why));
  };
  if (fs::is_directory(path)) throw refuse("is a directory, a file is needed");
  if (std::ranges::count(named_files(), followed(path)) > 1)
    throw refuse("is named twice on the command line: what is read there would be replaced");
  const fs::path folder = followed(path).parent_path();
  if (!fs::is_directory(folder)) throw refuse(fmt::format("the folder {} is not there", folder.string()));
  if (access(folder.c_str(), W_OK) != 0)
    throw refuse(fmt::format("the folder {} cannot be written", folder.string()));
}

void require_writable(std::span<const std::string> paths) {
  std::set<fs::path> seen;
  for (const std::string& path : paths) {
    require_writable(path);
    if (path.empty() || (is_special(path) && path != "-")) continue;
    if (!seen.insert(path == "-" ? fs::path(path) : followed(path)).second)
      throw core::InputError(path == "-"
                                 ? "only one report can go to stdout: '-' is given twice"
                                 : fmt::format("{}: two reports cannot be written to the same file", path));
  }
}

void write_whole(const std::string& path, std::string_view text) {
  write_whole(path, [&](std::ostream& out) { out << text; });
}

void write_whole(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (path == "-") return write(std::cout);
  require_writable(path);
  std::optional<DraftFile> draft;
  if (!is_special(path)) draft.emplace(followed(path), path);
  std::ofstream out(draft ? draft->name() : path, std::ios::binary);
  write(out);
  out.close();
  if (!out || (draft && !draft->takes_its_place()))
    throw core::InputError(fmt::format("{}: cannot be written", path));
}

}  // namespace cylon::cli
