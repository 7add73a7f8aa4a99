#include "harness/view/whole_file.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>

namespace cylon::view {
namespace {

// A new file, whatever lies beside the path already: O_EXCL follows no link.  Not mkostemps(), whose files only their
// owner may read: the mask cannot be asked for without setting it for all threads.
int open_draft(const std::filesystem::path& path, std::string& name) {
  static std::atomic<unsigned> count = 0;
  constexpr int tries = 100;
  for (int i = 0; i < tries; ++i) {
    name = fmt::format("{}.{}-{}.partial", path.string(), ::getpid(), ++count);
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
  std::string draft;
  const int fd = open_draft(path, draft);
  bool whole = fd >= 0 && write_all(fd, bytes);
  int error = errno;
  if (fd >= 0 && ::close(fd) != 0 && whole) whole = false, error = errno;
  if (whole && ::rename(draft.c_str(), path.c_str()) == 0) return;
  if (whole) error = errno;
  if (fd >= 0) ::unlink(draft.c_str());
  throw core::InputError(
      fmt::format("{}: cannot be written: {}", path.string(), std::generic_category().message(error)));
}

}  // namespace cylon::view
