// What an engine that is not one's own may see and do: by bubblewrap, where that is installed.
#pragma once

#include "harness/process/spawn.h"

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace cylon::process {

/// Whether workers run in a sandbox from now on (`cylon --sandbox`).
std::atomic<bool>& sandboxing();

/// Files and folders, without symbolic links, that no sandbox shows, wherever they are: the user's key.  Set it
/// before workers start.
std::vector<std::filesystem::path>& hidden_in_sandboxes();

/// Throws core::InputError where bubblewrap is not installed, or may not make namespaces here.
void require_sandbox();

/// Throws core::InputError unless sandboxing(): for what goes on with what ran in a sandbox.  `what` begins the
/// sentence: ".cylon/journal.jsonl was written".
void require_sandbox_again(const std::string& what);

/// A descriptor that closes with its owner.
class SandboxFilter {
 public:
  /// A filter for bubblewrap's --seccomp: the system calls that no engine needs and that reach the kernel's
  /// administration give EPERM: tracing, mounting, namespaces, keys, modules, clocks, BPF, io_uring.  Without
  /// a descriptor where this processor has no list.
  SandboxFilter();
  ~SandboxFilter();
  SandboxFilter(const SandboxFilter&) = delete;
  SandboxFilter& operator=(const SandboxFilter&) = delete;
  int fd() const { return fd_; }  ///< -1: none.
  /// What bubblewrap gets: this, and of the environment what engines need to run.  An option of bubblewrap's own would come
  /// too late: the first process of the sandbox is bubblewrap, with the environment that it was started with.
  Inherited inherited() const;

 private:
  int fd_ = -1;
};

/// The command in namespaces of its own: no network, no other processes, no devices; system folders, the
/// working folder and the folders of the files that it names read-only, without hidden_in_sandboxes(); empty /tmp and
/// /dev/shm of 64 MiB each; everything else, the home folder among it, is not there.  Of a file in the home folder, above
/// it, among settings (~/.config, /etc) or in a folder of everybody (/tmp) nothing is shown but the file.  It ends with
/// its parent.
std::vector<std::string> sandboxed(const std::vector<std::string>& command, const SandboxFilter&);

}  // namespace cylon::process
