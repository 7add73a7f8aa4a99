#include "harness/tracking/run_lock.h"

#include "harness/cli/patience.h"
#include "harness/core/input_error.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace cylon::tracking {

RunLock::~RunLock() {
  if (fd_ >= 0) ::close(fd_);
}

void RunLock::hold(store::Store& store, std::int64_t id) {
  const core::InputError held(store_, 0, 0,
                              fmt::format("another cylon is recording run {}; wait for its end", id));
  if (!store.hold(id)) throw held;
  if (store::Store::is_on_server(store_)) return;
  fd_ = ::open(store_.c_str(), O_RDWR | O_CLOEXEC);
  struct flock byte = {};
  byte.l_type = F_WRLCK;
  byte.l_whence = SEEK_SET;
  byte.l_start = (off_t{1} << 61) + id;
  byte.l_len = 1;
  int why = fd_ < 0 ? errno : 0;
  if (fd_ >= 0)
    cli::locks_in_a_moment([&] {
      why = ::fcntl(fd_, F_OFD_SETLK, &byte) == 0 ? 0 : errno;
      return why != EAGAIN && why != EACCES;
    });
  if (why == 0) return;
  if (fd_ >= 0 && (why == EAGAIN || why == EACCES)) throw held;
  throw core::InputError(store_, 0, 0,
                         fmt::format("cannot be locked: {}", std::generic_category().message(why)));
}

}  // namespace cylon::tracking
