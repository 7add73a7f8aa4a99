#include "harness/process/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <limits>
#include <system_error>

namespace cylon::process {
namespace {

constexpr std::size_t chunk = std::size_t{256} << 10;       // per read [bytes]
constexpr std::size_t errors_kept = std::size_t{64} << 10;  // of stderr [bytes]
constexpr std::size_t errors_chunk = std::size_t{16} << 10;
constexpr std::size_t errors_reported = std::size_t{4} << 10;
constexpr int tick_ms = 20;              // between two looks at memory, deadline and interruption
constexpr int count_ms = 250;            // between two counts of its descendants' memory
constexpr double goodbye_seconds = 0.5;  // from the end of output to the exit

// A year stands for "no limit": the clock's range is finite.
std::chrono::steady_clock::duration in_seconds(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(std::clamp(seconds, 0.0, 3.2e7)));
}

void close_fd(int& fd) {
  if (fd >= 0) ::close(fd);
  fd = -1;
}

std::string signal_name(int number) {
  const char* name = sigabbrev_np(number);
  return name ? fmt::format("SIG{}", name) : fmt::format("signal {}", number);
}

/// Resident size [bytes], 0 when it is gone.
std::size_t resident(pid_t pid) {
  std::ifstream file(fmt::format("/proc/{}/statm", pid));
  std::size_t total = 0, pages = 0;
  file >> total >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::string last_line(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  const std::size_t end = text.rfind('\n');
  std::string_view line = end == std::string_view::npos ? text : text.substr(end + 1);
  return std::string(line.substr(0, 300));
}

}  // namespace

Child::Child(const std::vector<std::string>& command, std::size_t memory_bytes, const Inherited& inherited)
    : command_(command), memory_bytes_(memory_bytes) {
  const std::scoped_lock lock(births());
  const Spawned child = spawn(command, memory_bytes, mark_, inherited);
  pid_ = child.pid, in_ = child.in, out_ = child.out, err_ = child.err;
  next_count_ = Clock::now() + std::chrono::milliseconds(count_ms);
  try {
    owned_.emplace(pid_);
  } catch (...) {  // no memory
    end_group();
    close_fd(in_), close_fd(out_), close_fd(err_);
    throw;
  }
}

Child::~Child() {
  try {
    kill();
  } catch (const std::exception&) {  // no memory to look for its descendants
    end_group();
  }
  close_fd(in_), close_fd(out_), close_fd(err_);
}

void Child::set_deadline(double seconds, std::string task) {
  deadline_ = Clock::now() + in_seconds(seconds);
  deadline_seconds_ = seconds;
  task_ = std::move(task);
}

void Child::check_limits() {
  if (interrupted()) throw Interrupted();
  const Clock::time_point now = Clock::now();
  if (now >= deadline_)
    throw Failure(results::Status::timeout,
                  fmt::format("'{}' did not end within {:g} s", task_, deadline_seconds_));
  if (now < next_check_) return;
  next_check_ = now + std::chrono::milliseconds(tick_ms);
  if (memory_bytes_ == 0) return;
  std::size_t size = resident(pid_);
  if (now >= next_count_) {  // all processes are looked through for its descendants
    size = std::max(size, Family(pid_, mark_).memory());
    next_count_ = Clock::now() + std::chrono::milliseconds(count_ms);
  }
  if (size > memory_bytes_)
    throw Failure(results::Status::crash, fmt::format("memory limit: {} MiB in use, {} MiB allowed",
                                                      size >> 20, memory_bytes_ >> 20));
}

bool Child::receive() {
  const std::size_t before = output_.size();
  while (!output_ended_ && output_.size() == before) {
    check_limits();
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
    const bool gone = has_exited();  // asked first: what it wrote before is in the pipe by now
    poll_once(gone ? 0 : static_cast<int>(std::clamp<std::int64_t>(left, 0, tick_ms)));
    if (gone && output_.size() == before) output_ended_ = true;
  }
  return output_.size() > before;
}

void Child::poll_once(int timeout_ms) {
  // A negative descriptor is skipped by poll.
  const bool writing = sent_ < unsent_.size();
  pollfd fds[3] = {
      {writing ? in_ : -1, POLLOUT, 0}, {output_ended_ ? -1 : out_, POLLIN, 0}, {err_, POLLIN, 0}};
  if (::poll(fds, 3, timeout_ms) <= 0) return;
  if (fds[0].revents) write_some();
  if (fds[1].revents) read_output();
  if (fds[2].revents) read_errors();
}

void Child::write_some() {
  const ssize_t n = ::write(in_, unsent_.data() + sent_, unsent_.size() - sent_);
  if (n < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (n < 0 && errno != EPIPE) throw std::system_error(errno, std::generic_category(), "write to the worker");
  // It closed its stdin: what it says, or how it ends, is the news.
  sent_ = n < 0 ? unsent_.size() : sent_ + static_cast<std::size_t>(n);
  if (sent_ == unsent_.size()) unsent_.clear(), unsent_.shrink_to_fit(), sent_ = 0;
}

void Child::read_output() {
  const ssize_t n = ::read(out_, output_.room(chunk), chunk);
  output_.added(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) output_ended_ = true;
}

void Child::read_errors() {
  char bytes[errors_chunk];
  const ssize_t n = ::read(err_, bytes, sizeof bytes);
  if (n < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (n <= 0) return close_fd(err_);
  errors_.append(bytes, static_cast<std::size_t>(n));
  if (errors_.size() > 2 * errors_kept) errors_.erase(0, errors_.size() - errors_kept);
}

// It stays a zombie until kill(), so that its id, and its group's, cannot be taken by another.
bool Child::has_exited() {
  siginfo_t info = {};
  if (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0) return false;
  if (info.si_pid != pid_) return false;
  signal_ = info.si_code == CLD_EXITED ? 0 : info.si_status;
  code_ = info.si_code == CLD_EXITED ? info.si_status : 0;
  return true;
}

bool Child::exited_within(double seconds) {
  const Clock::time_point end = Clock::now() + in_seconds(seconds);
  for (;;) {
    if (has_exited()) {
      drain_errors();
      return true;
    }
    if (interrupted()) throw Interrupted();
    if (Clock::now() >= end) return false;
    poll_once(1);  // a full pipe would keep it alive
    if (output_ended_ && err_ < 0) ::usleep(1000);
    output_.clear();  // nothing that it still says counts
  }
}

// What is still in the pipe, and no waiting: a grandchild may hold the other end open.
void Child::drain_errors() {
  for (std::size_t i = 0; i < 2 * errors_kept / errors_chunk && err_ >= 0; ++i) {
    pollfd fd = {err_, POLLIN, 0};
    if (::poll(&fd, 1, 0) <= 0) return;
    read_errors();
  }
}

// without_last_words() knows these forms.
Failure Child::ending() {
  if (!exited_within(goodbye_seconds))
    return {results::Status::protocol, "closed its output before the end and kept running"};
  const std::string said = last_line(complaints());
  const std::string last_words = said.empty() ? "" : ": " + said;
  // SIGKILL is not ours here: the kernel's out-of-memory killer, or someone at a shell.
  if (signal_)
    return {results::Status::crash, fmt::format("killed by {}{}", signal_name(signal_), last_words)};
  // 126 and 127 are how shells and env say that there was nothing to run.
  if ((code_ == 126 || code_ == 127) && task_ == "hello")
    return {results::Status::unsupported, fmt::format("cannot start '{}'{}", command_.front(), last_words)};
  return {results::Status::crash, fmt::format("exited {} before done{}", code_, last_words)};
}

std::string Child::finish(double seconds) {
  const Clock::time_point end = Clock::now() + in_seconds(seconds);
  while (sent_ < unsent_.size() && !output_ended_ && Clock::now() < end) poll_once(tick_ms);
  unsent_.clear(), sent_ = 0;
  close_fd(in_);
  output_.clear();
  const std::string ended = exited_within(seconds) && signal_ ? signal_name(signal_) : "";
  kill();
  return ended;
}

void Child::kill() {
  if (pid_ < 0) return;
  Family(pid_, mark_).kill();
  end_group();
  Family::reap_orphans();
  drain_errors();
}

void Child::end_group() {
  if (pid_ < 0) return;
  ::kill(pid_, SIGKILL);
  ::kill(-pid_, SIGKILL);
  owned_.reset();
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
}

// Not getrusage's, which begins with what the process that forked it had resident.
std::size_t Child::peak_bytes() const {
  std::ifstream file(fmt::format("/proc/{}/status", pid_));
  std::size_t kibibytes = 0;
  for (std::string word; kibibytes == 0 && file >> word;)
    if (word == "VmHWM:") file >> kibibytes;
  return kibibytes << 10;
}

double Child::cpu_seconds() const {
  clockid_t clock = 0;
  timespec time{};
  if (clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &time) != 0)
    return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double Child::family_cpu_seconds() const { return Family(pid_, mark_).cpu_seconds(); }

std::string Child::complaints() const {
  if (errors_.size() <= errors_reported) return errors_;
  const std::size_t start = errors_.size() - errors_reported;
  const std::size_t line = errors_.find('\n', start);
  return errors_.substr(line == std::string::npos || line + 1 >= errors_.size() ? start : line + 1);
}

}  // namespace cylon::process
