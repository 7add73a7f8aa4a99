#include "harness/process/pipes.h"

#include "harness/process/messages.h"

#include <unistd.h>

#include <cerrno>
#include <cstddef>

namespace cylon::process {

std::optional<std::string> Pipes::read_line() {
  std::size_t searched = 0;
  for (;;) {
    if (const std::size_t end = pending_.find('\n', searched); end != std::string::npos) {
      std::string text = pending_.substr(0, end);
      pending_.erase(0, end + 1);
      return text;
    }
    searched = pending_.size();
    char chunk[1 << 16];
    const ssize_t n = ::read(in_, chunk, sizeof chunk);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return std::nullopt;
    pending_.append(chunk, static_cast<std::size_t>(n));
  }
}

void Pipes::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(out_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) throw Abandoned();
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void Pipes::write(const nlohmann::json& message) { write(std::string_view(line(message))); }

}  // namespace cylon::process
