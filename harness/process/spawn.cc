#include "harness/process/spawn.h"

#include "harness/process/child.h"
#include "harness/process/family.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <system_error>

namespace cylon::process {
namespace {

constexpr int pipe_bytes = 1 << 20;  // room for some frames while the parent is elsewhere

// Sanitizers map terabytes.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // gcc
constexpr bool limit_data = false;
#elif defined(__has_feature)  // clang
// NOLINTNEXTLINE(misc-redundant-expression): the same only where neither is on
constexpr bool limit_data = !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool limit_data = true;
#endif

/// A descriptor that closes with its owner.
class Fd {
 public:
  explicit Fd(int fd = -1) : fd_(fd) {}
  Fd(Fd&& other) noexcept : fd_(other.release()) {}
  Fd(const Fd&) = delete;
  Fd& operator=(const Fd&) = delete;
  Fd& operator=(Fd&&) = delete;
  ~Fd() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  int release() {
    const int fd = fd_;
    fd_ = -1;
    return fd;
  }

 private:
  int fd_;
};

struct Pipe {
  Fd read, write;
};

// Never 0, 1 or 2, which the child is about to replace.
Fd above_stdio(Fd fd) {
  if (fd.get() > 2) return fd;
  const int copy = ::fcntl(fd.get(), F_DUPFD_CLOEXEC, 3);
  if (copy < 0) throw std::system_error(errno, std::generic_category(), "fcntl");
  return Fd(copy);
}

Pipe make_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  Fd read(ends[0]), write(ends[1]);
  return {above_stdio(std::move(read)), above_stdio(std::move(write))};
}

// Between fork and exec: async-signal-safe calls only.  Returns when exec failed.
void become(char* const* argv, char* const* environment, int in, int out, int err, std::size_t memory_bytes,
            int kept) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD, SIGXFSZ})
    ::signal(number, SIG_DFL);
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  if (limit_data && memory_bytes > 0) {
    const rlimit data = {2 * memory_bytes, 2 * memory_bytes};
    ::setrlimit(RLIMIT_DATA, &data);
  }
  if (::dup2(in, STDIN_FILENO) < 0 || ::dup2(out, STDOUT_FILENO) < 0 || ::dup2(err, STDERR_FILENO) < 0)
    return;
  ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);  // what libraries opened without the flag: sockets of a server
  if (kept >= 0) ::fcntl(kept, F_SETFD, 0);
  ::execvpe(argv[0], argv, environment);
}

}  // namespace

Spawned spawn(const std::vector<std::string>& command, std::size_t memory_bytes, const std::string& mark,
              int kept) {
  if (command.empty()) throw Failure(results::Status::unsupported, "cannot start: the command is empty");
  static std::once_flag once;
  std::call_once(once, [] {
    ::signal(SIGPIPE, SIG_IGN);
    adopt_orphans();
  });

  std::vector<char*> argv;
  argv.reserve(command.size() + 1);
  for (const std::string& word : command)
    argv.push_back(const_cast<char*>(word.c_str()));  // NOLINT(*-const-cast): POSIX says exec reads only
  argv.push_back(nullptr);
  std::vector<char*> environment;
  for (char** word = environ; *word; ++word) environment.push_back(*word);
  environment.push_back(const_cast<char*>(mark.c_str()));  // NOLINT(*-const-cast)
  environment.push_back(nullptr);
  Pipe in = make_pipe(), out = make_pipe(), err = make_pipe(), failed = make_pipe();
  ::fcntl(out.read.get(), F_SETPIPE_SZ, pipe_bytes);

  const pid_t pid = ::fork();
  if (pid < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (pid == 0) {
    become(argv.data(), environment.data(), in.read.get(), out.write.get(), err.write.get(), memory_bytes,
           kept);
    const int error = errno;
    [[maybe_unused]] const ssize_t told = ::write(failed.write.get(), &error, sizeof error);
    ::_exit(127);
  }
  ::close(failed.write.release());
  // Closed by exec without a word, or the error number.
  int error = 0;
  ssize_t told = 0;
  while ((told = ::read(failed.read.get(), &error, sizeof error)) < 0 && errno == EINTR) {
  }
  if (told > 0) {
    while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
    }
    throw Failure(results::Status::unsupported, fmt::format("cannot start '{}': {}", command.front(),
                                                            std::generic_category().message(error)));
  }
  for (const int fd : {in.write.get(), out.read.get(), err.read.get()})
    ::fcntl(fd, F_SETFL, ::fcntl(fd, F_GETFL) | O_NONBLOCK);
  return {pid, in.write.release(), out.read.release(), err.read.release()};
}

}  // namespace cylon::process
