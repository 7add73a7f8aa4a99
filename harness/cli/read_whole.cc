#include "harness/cli/read_whole.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace cylon::cli {
namespace {

constexpr int longest_silence = 5000;  // of a named pipe into which nobody writes yet [ms]

/// A descriptor that closes with its owner.
class Input {
 public:
  explicit Input(int opened) : fd(opened) {}
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;
  ~Input() {
    if (fd > STDIN_FILENO) ::close(fd);
  }

  const int fd;
};

}  // namespace

// Files are opened without waiting: what lies under /proc may never come, and a named pipe has perhaps no writer.
std::string read_whole(const std::string& path, std::size_t most) {
  const auto refuse = [&](const std::string& why) {
    return core::InputError(fmt::format("{}: {}", path, why));
  };
  const Input in(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status = {};
  if (in.fd < 0 || ::fstat(in.fd, &status) != 0) throw refuse("cannot be read");
  std::string text;
  std::array<char, 1 << 16> piece;
  for (bool written = !S_ISFIFO(status.st_mode);;) {
    const ssize_t n = ::read(in.fd, piece.data(), piece.size());
    if (n > 0) {
      written = true;
      text.append(piece.data(), static_cast<std::size_t>(n));
      if (text.size() > most) throw refuse(fmt::format("more than {} MB", most >> 20));
      continue;
    }
    if (n == 0 && written) return text;
    if (n < 0 && errno == EINTR) continue;
    const bool comes = n == 0 || (errno == EAGAIN && !S_ISREG(status.st_mode));
    if (!comes) throw refuse("cannot be read: " + std::generic_category().message(errno));
    pollfd ready = {in.fd, POLLIN, 0};
    if (::poll(&ready, 1, n == 0 ? longest_silence : -1) == 0)
      throw refuse("a pipe into which nobody writes");
    written = true;
  }
}

}  // namespace cylon::cli
