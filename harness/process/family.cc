#include "harness/process/family.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string_view>

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

// One of the strings of its environment, as it was when it started.
bool bears(pid_t pid, const std::string& mark) {
  const std::string all = read_proc(pid, "environ");
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

std::size_t own_share(pid_t pid) { return kibibytes(read_proc(pid, "smaps_rollup"), "\nPss:"); }

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
    // "12 (a name) S 1 12 …": the name may hold anything.
    const std::string stat = read_proc(one.pid, "stat");
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
  const std::vector<Relative> all = processes();
  const pid_t self = ::getpid();
  std::set<pid_t> known = {worker_};
  for (const Relative& one : all)
    if (one.group == worker_ ||
        (one.parent == self && one.pid != worker_ && !one.dead && bears(one.pid, mark_)))
      known.insert(one.pid);
  // Children of those that are known, and so on.
  for (std::size_t before = 0; before != known.size();) {
    before = known.size();
    for (const Relative& one : all)
      if (known.contains(one.parent)) known.insert(one.pid);
  }
  std::vector<Relative> result;
  for (const Relative& one : all)
    if (one.pid != worker_ && known.contains(one.pid)) result.push_back(one);
  return result;
}

std::size_t Family::resident() const {
  const std::vector<Relative> others = living();
  if (others.empty()) {
    std::size_t total = 0, pages = 0;
    if (std::sscanf(read_proc(worker_, "statm").c_str(), "%zu %zu", &total, &pages) != 2) return 0;
    return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  }
  std::size_t sum = own_share(worker_);
  for (const Relative& one : others) sum += own_share(one.pid);
  return sum;
}

void Family::kill() {
  ::kill(-worker_, SIGKILL);
  const pid_t self = ::getpid();
  constexpr int rounds = 1000;  // a family that grows as fast as it dies
  for (int round = 0; round < rounds; ++round) {
    bool alive = false;
    for (const Relative& one : living()) {
      if (!one.dead) ::kill(one.pid, SIGKILL);
      // Killed, it ends soon; then it is a zombie that only its parent can take away.
      alive = alive || (one.parent == self ? ::waitpid(one.pid, nullptr, WNOHANG) == 0 : !one.dead);
    }
    if (!alive) return;
    ::usleep(500);
  }
}

// An orphan that ends shows no environment any more, a little before it is a zombie; nobody else waits for it.
void Family::reap_orphans() {
  const pid_t self = ::getpid();
  constexpr int rounds = 1000;
  for (int round = 0; round < rounds; ++round) {
    bool dying = false;
    {
      const std::scoped_lock lock(births());
      for (const Relative& one : processes()) {
        if (one.parent != self || owned().contains(one.pid)) continue;
        if (one.dead)
          ::waitpid(one.pid, nullptr, WNOHANG);
        else
          dying = dying || read_proc(one.pid, "environ").empty();
      }
    }
    if (!dying) return;
    ::usleep(500);
  }
}

}  // namespace cylon::process
