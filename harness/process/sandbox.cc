#include "harness/process/sandbox.h"

#include "harness/core/input_error.h"
#include "harness/process/child.h"

#include <fmt/format.h>

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

namespace cylon::process {
namespace {

namespace fs = std::filesystem;

#if defined(__x86_64__)
constexpr long refused_calls[] = {SYS_ptrace,
                                  SYS_process_vm_readv,
                                  SYS_process_vm_writev,
                                  SYS_mount,
                                  SYS_umount2,
                                  SYS_pivot_root,
                                  SYS_chroot,
                                  SYS_unshare,
                                  SYS_setns,
                                  SYS_keyctl,
                                  SYS_add_key,
                                  SYS_request_key,
                                  SYS_bpf,
                                  SYS_perf_event_open,
                                  SYS_userfaultfd,
                                  SYS_init_module,
                                  SYS_finit_module,
                                  SYS_delete_module,
                                  SYS_kexec_load,
                                  SYS_kexec_file_load,
                                  SYS_reboot,
                                  SYS_swapon,
                                  SYS_swapoff,
                                  SYS_quotactl,
                                  SYS_acct,
                                  SYS_settimeofday,
                                  SYS_clock_settime,
                                  SYS_adjtimex,
                                  SYS_clock_adjtime,
                                  SYS_iopl,
                                  SYS_ioperm,
                                  SYS_open_by_handle_at,
                                  SYS_io_uring_setup,
                                  SYS_io_uring_enter,
                                  SYS_io_uring_register,
                                  SYS_move_mount,
                                  SYS_open_tree,
                                  SYS_fsopen,
                                  SYS_fsmount,
                                  SYS_mount_setattr};

// Classic BPF over struct seccomp_data (seccomp(2)).
std::vector<sock_filter> filter() {
  const auto load = [](std::size_t offset) {
    return sock_filter{BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<std::uint32_t>(offset)};
  };
  const auto answer = [](std::uint32_t value) { return sock_filter{BPF_RET | BPF_K, 0, 0, value}; };
  const auto unless = [](std::uint16_t test, std::uint32_t k) {  // skips the next where the test fails
    return sock_filter{static_cast<std::uint16_t>(BPF_JMP | test | BPF_K), 0, 1, k};
  };
  const std::uint32_t refuse = SECCOMP_RET_ERRNO | EPERM;
  std::vector<sock_filter> program = {load(offsetof(seccomp_data, arch)),
                                      {BPF_JMP | BPF_JEQ | BPF_K, 1, 0, AUDIT_ARCH_X86_64},
                                      answer(SECCOMP_RET_KILL_PROCESS),
                                      load(offsetof(seccomp_data, nr)),
                                      unless(BPF_JGE, 0x40000000u),  // the x32 calls
                                      answer(refuse)};
  for (const long call : refused_calls) {
    program.push_back(unless(BPF_JEQ, static_cast<std::uint32_t>(call)));
    program.push_back(answer(refuse));
  }
  // Flags of clone3 are in memory, which a filter cannot read: the C library then takes clone.
  program.push_back(unless(BPF_JEQ, static_cast<std::uint32_t>(SYS_clone3)));
  program.push_back(answer(SECCOMP_RET_ERRNO | ENOSYS));
  program.push_back({BPF_JMP | BPF_JEQ | BPF_K, 0, 3, static_cast<std::uint32_t>(SYS_clone)});
  program.push_back(load(offsetof(seccomp_data, args[0])));
  program.push_back(unless(BPF_JSET, CLONE_NEWUSER));
  program.push_back(answer(refuse));
  program.push_back(answer(SECCOMP_RET_ALLOW));
  return program;
}
#else
std::vector<sock_filter> filter() { return {}; }
#endif

constexpr const char* scratch_bytes =
    "67108864";  // of /tmp and /dev/shm: memory that no process has resident

// All that engines and the interpreters of some need, and no place for a password.
bool is_needed(std::string_view variable) {
  constexpr std::string_view needed[] = {"PATH",
                                         "HOME",
                                         "LANG",
                                         "LANGUAGE",
                                         "TZ",
                                         "LD_LIBRARY_PATH",
                                         "PYTHONPATH",
                                         "PYTHONHOME",
                                         "NODE_PATH",
                                         "NODE_OPTIONS",
                                         "OMP_NUM_THREADS",
                                         "ASAN_OPTIONS",
                                         "LSAN_OPTIONS",
                                         "TSAN_OPTIONS",
                                         "UBSAN_OPTIONS"};
  return variable.starts_with("LC_") || std::ranges::find(needed, variable) != std::end(needed);
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  return std::ranges::mismatch(folder, path).in1 == folder.end();
}

// The home folder without symbolic links; empty where there is none.
fs::path home_folder() {
  const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe): nothing here sets it
  std::error_code error;
  const fs::path real = home && *home ? fs::canonical(home, error) : fs::path();
  return error ? fs::path() : real;
}

// Whether more lies in a folder than an engine that somebody put there: a home folder and all above it, the settings
// directly in it (~/.ssh, ~/.config), and folders of the system and of everybody.
bool holds_others(const fs::path& folder) {
  constexpr std::string_view itself[] = {"/",     "/boot", "/dev/shm", "/home", "/media", "/mnt",    "/opt",
                                         "/root", "/run",  "/srv",     "/tmp",  "/var",   "/var/tmp"};
  constexpr std::string_view with_all_in_it[] = {"/dev", "/etc", "/proc", "/sys"};
  const fs::path home = home_folder(), above = folder.parent_path();
  return std::ranges::find(itself, folder) != std::end(itself) || above == "/home" ||
         std::ranges::any_of(with_all_in_it, [&](const fs::path& one) { return is_inside(folder, one); }) ||
         (!home.empty() &&
          (is_inside(home, folder) || (above == home && folder.filename().string().starts_with('.'))));
}

// What the words of a command show of the disk: the folders of the files that they name, so that an engine has its
// modules, or a file alone where others' files lie beside it.
struct Named {
  std::set<fs::path> folders, files;
};

Named named_by(const std::vector<std::string>& command) {
  Named named;
  std::error_code error;
  for (const std::string& word : command) {
    const fs::path real = fs::weakly_canonical(fs::absolute(word), error);
    if (error || !fs::is_regular_file(real, error)) continue;
    // By both names: a link leads to the one, and the engine is started by the other.
    const bool alone = holds_others(real.parent_path());
    for (const fs::path& file : {real, fs::absolute(word).lexically_normal()})
      if (alone || holds_others(file.parent_path()))
        named.files.insert(file);
      else
        named.folders.insert(file.parent_path());
  }
  return named;
}

// Whether a file is to be shown by itself: not where a folder shows it, where the sandbox has files of its own, or where
// it must stay hidden.
bool is_to_be_shown(const fs::path& file, const std::set<fs::path>& folders) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  const auto holds = [](const fs::path& place) {
    return [&place](const fs::path& folder) { return is_inside(place, folder); };
  };
  return !error && std::ranges::none_of(folders, holds(file)) && !is_inside(file, "/proc") &&
         (!is_inside(file, "/dev") || is_inside(file, "/dev/shm")) &&
         std::ranges::none_of(hidden_in_sandboxes(), holds(real));
}

// Where what is hidden would be seen below the folders that are shown, and whether it is a folder.
std::map<fs::path, bool> masks(const std::set<fs::path>& shown) {
  std::map<fs::path, bool> places;
  std::error_code error;
  for (const fs::path& hidden : hidden_in_sandboxes())
    for (const fs::path& folder : shown)
      if (const fs::path real = fs::canonical(folder, error); !error && is_inside(hidden, real))
        places[hidden == real ? folder : folder / hidden.lexically_relative(real)] =
            fs::is_directory(hidden, error);
  std::erase_if(places, [&](const auto& inner) {
    return std::ranges::any_of(places, [&](const auto& outer) {
      return inner.first != outer.first && is_inside(inner.first, outer.first);
    });
  });
  return places;
}

}  // namespace

std::atomic<bool>& sandboxing() {
  static std::atomic<bool> on{false};
  return on;
}

std::vector<fs::path>& hidden_in_sandboxes() {
  static std::vector<fs::path> places;
  return places;
}

SandboxFilter::SandboxFilter() {
  const std::vector<sock_filter> program = filter();
  if (program.empty()) return;
  fd_ = ::memfd_create("cylon-seccomp", MFD_CLOEXEC);
  const std::size_t bytes = program.size() * sizeof(sock_filter);
  if (fd_ < 0 || ::write(fd_, program.data(), bytes) != static_cast<ssize_t>(bytes) ||
      ::lseek(fd_, 0, SEEK_SET) != 0)
    throw std::system_error(errno, std::generic_category(), "memfd");
}

Inherited SandboxFilter::inherited() const { return {fd_, is_needed}; }

SandboxFilter::~SandboxFilter() {
  if (fd_ >= 0) ::close(fd_);
}

std::vector<std::string> sandboxed(const std::vector<std::string>& command, const SandboxFilter& calls) {
  std::vector<std::string> words = {
      "bwrap",  "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL", "--dev", "/dev",
      "--proc", "/proc"};
  const auto add = [&words](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
  const auto show = [&](const fs::path& place) { add({"--ro-bind-try", place, place}); };
  std::set<fs::path> folders = {
      "/usr",      "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/etc/ld.so.cache", "/etc/alternatives",
      "/nix/store"};
  for (const fs::path& folder : folders) show(folder);
  for (const char* scratch : {"/tmp", "/dev/shm"}) add({"--size", scratch_bytes, "--tmpfs", scratch});
  const fs::path here = fs::current_path();
  Named own = named_by(command);
  if (here != "/") own.folders.insert(here);
  for (const fs::path& folder : own.folders) show(folder);  // parents before what is in them
  folders.merge(own.folders);
  for (const fs::path& file : own.files)
    if (is_to_be_shown(file, folders)) show(file);
  for (const auto& [place, is_folder] : masks(folders))
    if (is_folder)
      add({"--size", "4096", "--tmpfs", place, "--remount-ro", place});
    else
      add({"--ro-bind", "/dev/null", place});
  // What bubblewrap makes of its own is memory, too.
  add({"--remount-ro", "/dev", "--remount-ro", "/", "--chdir", here});
  if (calls.fd() >= 0) add({"--seccomp", fmt::format("{}", calls.fd())});
  words.emplace_back("--");
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

void require_sandbox_again(const std::string& what) {
  if (sandboxing()) return;
  throw core::InputError(
      fmt::format("{} with --sandbox, and its engines are not started without: repeat the command as `cylon "
                  "--sandbox …`",
                  what));
}

void require_sandbox() {
  try {
    const SandboxFilter calls;
    Child probe(sandboxed({"true"}, calls), 0, calls.inherited());
    probe.set_deadline(10, "sandbox");
    while (probe.receive()) {
    }
    if (const Failure ended = probe.ending(); std::string_view(ended.what()).starts_with("exited 0")) return;
    throw core::InputError(fmt::format("--sandbox: bubblewrap does not work here: {}", probe.complaints()));
  } catch (const Failure& failure) {
    throw core::InputError(
        fmt::format("--sandbox: {}; install bubblewrap (`apt-get install bubblewrap`), or run without it",
                    failure.what()));
  }
}

}  // namespace cylon::process
