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

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <set>
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

void show(std::vector<std::string>& words, const fs::path& folder) {
  words.insert(words.end(), {"--ro-bind-try", folder.string(), folder.string()});
}

}  // namespace

std::atomic<bool>& sandboxing() {
  static std::atomic<bool> on{false};
  return on;
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

SandboxFilter::~SandboxFilter() {
  if (fd_ >= 0) ::close(fd_);
}

std::vector<std::string> sandboxed(const std::vector<std::string>& command, const SandboxFilter& calls) {
  std::vector<std::string> words = {
      "bwrap",  "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL", "--dev", "/dev",
      "--proc", "/proc"};
  for (const char* folder : {"/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/etc/ld.so.cache",
                             "/etc/alternatives", "/nix/store"})
    show(words, folder);
  words.insert(words.end(), {"--tmpfs", "/tmp"});
  std::error_code error;
  const fs::path here = fs::current_path();
  std::set<fs::path> folders = {here};
  for (const std::string& word : command)
    if (const fs::path file = fs::weakly_canonical(fs::absolute(word), error);
        !error && fs::is_regular_file(file, error))
      folders.insert(file.parent_path()), folders.insert(fs::absolute(word).lexically_normal().parent_path());
  for (const fs::path& folder : folders)  // parents before what is in them
    if (folder != "/") show(words, folder);
  // The user's key is never there, even where the working folder is the home folder.
  for (const auto& [variable, below] :
       {std::pair("XDG_CONFIG_HOME", "cylon"), std::pair("HOME", ".config/cylon")})
    if (const char* value = std::getenv(variable); value && *value)
      if (const fs::path keys = fs::path(value) / below; fs::is_directory(keys, error))
        for (const fs::path& folder : folders)
          if (keys.lexically_relative(folder).native().substr(0, 2) != "..")
            words.insert(words.end(), {"--tmpfs", keys.string()});
  words.insert(words.end(), {"--chdir", here.string()});
  if (calls.fd() >= 0) words.insert(words.end(), {"--seccomp", fmt::format("{}", calls.fd())});
  words.emplace_back("--");
  words.insert(words.end(), command.begin(), command.end());
  return words;
}

void require_sandbox() {
  try {
    const SandboxFilter calls;
    Child probe(sandboxed({"true"}, calls), 0, calls.fd());
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
