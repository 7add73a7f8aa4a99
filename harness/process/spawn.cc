#include "harness/process/spawn.h"

#include "harness/process/child.h"
#include "harness/process/family.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <memory>
#include <mutex>
#include <system_error>

namespace cylon::process {
namespace {

constexpr int pipe_bytes = 1 << 20;  // room for some frames while the parent is elsewhere

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // gcc
constexpr bool sanitized = true;
#elif defined(__has_feature)  // clang
// NOLINTNEXTLINE(misc-redundant-expression): the same only where neither is on
constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool sanitized = false;
#endif
constexpr bool limit_data = !sanitized;  // sanitizers map terabytes

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

// What a child becomes.
struct Fate {
  char* const* argv;
  char* const* environment;
  int in, out, err, failed;  // `failed` gets the number of the error where exec fails
  std::size_t memory_bytes;
  int kept;
};

// Between clone and exec: async-signal-safe calls only.  Returns when exec failed.
void become(const Fate& fate) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD, SIGXFSZ})
    ::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  if (limit_data && fate.memory_bytes > 0) {
    const rlimit data = {2 * fate.memory_bytes, 2 * fate.memory_bytes};
    ::setrlimit(RLIMIT_DATA, &data);
  }
  if (::dup2(fate.in, STDIN_FILENO) < 0 || ::dup2(fate.out, STDOUT_FILENO) < 0 ||
      ::dup2(fate.err, STDERR_FILENO) < 0)
    return;
  ::close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);  // what libraries opened without the flag: sockets of a server
  if (fate.kept >= 0) ::fcntl(fate.kept, F_SETFD, 0);
  ::execvpe(fate.argv[0], fate.argv, fate.environment);
}

int meet(void* fate) {
  const auto& own = *static_cast<const Fate*>(fate);
  become(own);
  const int error = errno;
  [[maybe_unused]] const ssize_t told = ::write(own.failed, &error, sizeof error);
  ::_exit(127);
}

// A child that lives in this process's memory, on a stack of its own, until it executes; the calling thread waits for that.
// fork() would copy the page tables of a harness that holds a large run's results: longer than a short run takes.  No signal
// is handled meanwhile, as a handler would run in the child, too.  Sanitizers know nothing of such a child.
pid_t child_of(Fate fate) {
  if constexpr (sanitized) {
    const pid_t pid = ::fork();
    if (pid == 0) meet(&fate);
    return pid;
  }
  constexpr std::size_t stack_bytes = std::size_t{1} << 18;  // execvpe() puts paths on it
  const auto stack = std::make_unique_for_overwrite<std::byte[]>(stack_bytes);
  sigset_t all, before;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t pid = ::clone(meet, stack.get() + stack_bytes, CLONE_VM | CLONE_VFORK | SIGCHLD, &fate);
  const int error = errno;
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return pid;
}

}  // namespace

Spawned spawn(const std::vector<std::string>& command, std::size_t memory_bytes, const std::string& mark,
              const Inherited& inherited) {
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
  for (char** word = environ; *word; ++word)
    if (const std::string_view text = *word;
        !inherited.variable || inherited.variable(text.substr(0, text.find('='))))
      environment.push_back(*word);
  environment.push_back(const_cast<char*>(mark.c_str()));  // NOLINT(*-const-cast)
  environment.push_back(nullptr);
  Pipe in = make_pipe(), out = make_pipe(), err = make_pipe(), failed = make_pipe();
  ::fcntl(out.read.get(), F_SETPIPE_SZ, pipe_bytes);

  const pid_t pid = child_of({argv.data(), environment.data(), in.read.get(), out.write.get(),
                              err.write.get(), failed.write.get(), memory_bytes, inherited.descriptor});
  if (pid < 0) throw std::system_error(errno, std::generic_category(), "fork");
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
