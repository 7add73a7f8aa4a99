#include "harness/process/family.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <linux/magic.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

namespace cylon::process {
namespace {

constexpr std::size_t longest_file = std::size_t{1} << 20;  // of /proc [bytes]

// "" where it is gone, or not ours to read.
std::string read_proc(pid_t pid, const char* file) {
  const int fd = ::open(fmt::format("/proc/{}/{}", pid, file).c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return "";
  std::string text;
  char piece[4096];
  ssize_t n = 0;
  while (text.size() < longest_file && (n = ::read(fd, piece, sizeof piece)) > 0)
    text.append(piece, static_cast<std::size_t>(n));
  ::close(fd);
  return text;
}

// What the first read of a file gives: all of one as short as /proc/PID/stat.
std::string beginning(int folder, const char* file) {
  const int fd = ::openat(folder, file, O_RDONLY | O_CLOEXEC);
  if (fd < 0) return "";
  char piece[1024];
  const ssize_t n = ::read(fd, piece, sizeof piece);
  ::close(fd);
  return {piece, static_cast<std::size_t>(std::max<ssize_t>(n, 0))};
}

// Whether the mark is one of the strings of an environment.
bool bears(const std::string& all, const std::string& mark) {
  for (std::size_t at = 0; at < all.size(); at = all.find('\0', at) + 1) {
    if (all.compare(at, mark.size() + 1, mark.c_str(), mark.size() + 1) == 0) return true;
    if (all.find('\0', at) == std::string::npos) break;
  }
  return false;
}

// Of a line "Pss:   1234 kB" [bytes].
std::size_t kibibytes(const std::string& text, std::string_view key) {
  const std::size_t at = text.find(key);
  return at == std::string::npos ? 0 : std::strtoull(text.c_str() + at + key.size(), nullptr, 10) << 10;
}

// Memory of processes [bytes].
struct Held {
  std::size_t resident = 0, of_files = 0;  // of_files: the part of it that a file in memory may be
  std::map<std::pair<dev_t, ino_t>, std::size_t> open;  // files in memory without a name, whole

  // `alone`: it shares with no other.  The kernel counts the share of each in more time.
  void add(pid_t pid, bool alone) {
    const std::string text = read_proc(pid, alone ? "status" : "smaps_rollup");
    resident += kibibytes(text, alone ? "\nVmRSS:" : "\nPss:");
    of_files += kibibytes(text, alone ? "\nRssShmem:" : "\nPss_Shmem:");
    add_open(pid);
  }

  // What is resident of an open file is counted once.
  std::size_t bytes() const {
    std::size_t files = 0;
    for (const auto& [file, size] : open) files += size;
    return resident + files - std::min(files, of_files);
  }

 private:
  // Those of memfd_create, and those in a file system in memory whose name is gone: nobody but the process's family
  // has them.
  void add_open(pid_t pid) {
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(::opendir(fmt::format("/proc/{}/fd", pid).c_str()),
                                                     ::closedir);
    if (!folder) return;
    const int here = ::dirfd(folder.get());
    while (const dirent* entry = ::readdir(folder.get())) {
      char name[4096];
      const ssize_t length = ::readlinkat(here, entry->d_name, name, sizeof name);
      if (length <= 0 || !std::string_view(name, static_cast<std::size_t>(length)).ends_with(" (deleted)"))
        continue;
      struct stat file = {};
      struct statfs system = {};
      if (::fstatat(here, entry->d_name, &file, 0) != 0 || !S_ISREG(file.st_mode) ||
          ::statfs(fmt::format("/proc/{}/fd/{}", pid, entry->d_name).c_str(), &system) != 0 ||
          (system.f_type != TMPFS_MAGIC && system.f_type != HUGETLBFS_MAGIC))
        continue;
      open[{file.st_dev, file.st_ino}] = static_cast<std::size_t>(file.st_blocks) * 512;
    }
  }
};

// CPU time of a process by its clock, and of its children that ended and were waited for in ticks of the kernel (10 ms) [s].  Fields of
// /proc/PID/stat, counted from 1: 16 cutime, 17 cstime.
double cpu_seconds_of(pid_t pid) {
  clockid_t clock = 0;
  timespec time = {};
  if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  const std::string text = read_proc(pid, "stat");
  const std::size_t behind = text.rfind(')');  // the name may hold anything
  std::uint64_t user_below = 0, system_below = 0;
  if (behind != std::string::npos)
    std::sscanf(text.c_str() + behind + 1,
                " %*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %*u %*u %" SCNu64 " %" SCNu64, &user_below,
                &system_below);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec) +
         static_cast<double>(user_below + system_below) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

// Guarded by births().
std::set<pid_t>& owned() {
  static std::set<pid_t> pids;
  return pids;
}

}  // namespace

void adopt_orphans() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }

std::mutex& births() {
  static std::mutex mutex;
  return mutex;
}

Owned::Owned(pid_t pid) : pid_(pid) { owned().insert(pid_); }

Owned::~Owned() {
  const std::scoped_lock lock(births());
  owned().erase(pid_);
}

std::string new_mark() {
  static std::atomic<unsigned> count = 0;
  return fmt::format("CYLON_WORKER={}.{}", ::getpid(), ++count);
}

std::vector<Family::Relative> Family::processes() {
  std::vector<Relative> all;
  DIR* proc = ::opendir("/proc");
  if (!proc) return all;
  while (const dirent* entry = ::readdir(proc)) {
    Relative one;
    const std::string_view name = entry->d_name;
    if (std::from_chars(name.data(), name.data() + name.size(), one.pid).ec != std::errc()) continue;
    // "12 (a name) S 1 12 …": the name, of at most 64 bytes, may hold anything.
    const std::string stat = beginning(::dirfd(proc), (std::string(name) + "/stat").c_str());
    const std::size_t behind = stat.rfind(')');
    char state = 0;
    if (behind == std::string::npos ||
        std::sscanf(stat.c_str() + behind + 1, " %c %d %d", &state, &one.parent, &one.group) != 3)
      continue;
    one.dead = state == 'Z' || state == 'X';
    all.push_back(one);
  }
  ::closedir(proc);
  return all;
}

std::vector<Family::Relative> Family::living() const {
  // While nothing is born, a child of this process that nobody owns is an orphan.
  const std::scoped_lock lock(births());
  std::vector<Relative> all = processes();
  const pid_t self = ::getpid();
  std::set<pid_t> known = {worker_};
  for (Relative& one : all) {
    if (one.group == worker_) known.insert(one.pid);
    if (one.parent != self || one.dead || owned().contains(one.pid)) continue;
    // Between the start of a program and its first instruction, and when it ends, there is none to read.
    const std::string environment = read_proc(one.pid, "environ");
    one.unknown = environment.empty();
    if (bears(environment, mark_)) known.insert(one.pid);
  }
  // Children of those that are known, and so on.
  for (std::size_t before = 0; before != known.size();) {
    before = known.size();
    for (const Relative& one : all)
      if (known.contains(one.parent)) known.insert(one.pid);
  }
  std::vector<Relative> result;
  for (Relative& one : all) {
    if (known.contains(one.pid)) one.unknown = false;
    if (one.pid != worker_ && (one.unknown || known.contains(one.pid))) result.push_back(one);
  }
  return result;
}

std::size_t Family::memory() const {
  const std::vector<Relative> others = living();
  Held held;
  held.add(worker_, others.empty());
  for (const Relative& one : others)
    if (!one.unknown) held.add(one.pid, false);
  return held.bytes();
}

double Family::cpu_seconds() const {
  double sum = cpu_seconds_of(worker_);
  for (const Relative& one : living())
    if (!one.unknown) sum += cpu_seconds_of(one.pid);
  return sum;
}

void Family::kill() {
  ::kill(worker_, SIGKILL);  // it may have left its group
  ::kill(-worker_, SIGKILL);
  const pid_t self = ::getpid();
  constexpr int rounds = 2000;    // a family that grows as fast as it dies
  constexpr int patience = 1000;  // rounds until an orphan that shows no environment is killed
  for (int round = 0; round < rounds; ++round) {
    bool alive = false;
    for (const Relative& one : living()) {
      if (!one.dead && (!one.unknown || round >= patience)) ::kill(one.pid, SIGKILL);
      // Killed, it ends soon; then it is a zombie that only its parent can take away.
      alive = alive || (one.parent == self ? ::waitpid(one.pid, nullptr, WNOHANG) == 0 : !one.dead);
    }
    if (!alive) return;
    ::usleep(500);
  }
}

void Family::reap_orphans() {
  // No look through all processes where no child at all has ended.
  siginfo_t ended = {};
  if (::waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid == 0) return;
  const pid_t self = ::getpid();
  const std::scoped_lock lock(births());
  for (const Relative& one : processes())
    if (one.parent == self && one.dead && !owned().contains(one.pid)) ::waitpid(one.pid, nullptr, WNOHANG);
}

}  // namespace cylon::process
