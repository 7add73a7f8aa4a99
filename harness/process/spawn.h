// Starting a program with its standard streams on pipes.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::process {

/// Our ends of the pipes are non-blocking and close on exec; the caller closes them, and reaps the process.
struct Spawned {
  pid_t pid = -1;
  int in = -1, out = -1, err = -1;
};

/// What a child gets from this process beside its pipes.
struct Inherited {
  int descriptor = -1;                                ///< One that stays open in it; -1: none.
  bool (*variable)(std::string_view name) = nullptr;  ///< Whether it gets one of the environment; null: all.
};

/// Runs `command` (looked up in PATH) as leader of a new process group, with default signal dispositions, no
/// core dumps, killed by the kernel should the calling thread die.  RLIMIT_DATA is twice `memory_bytes`, the
/// backstop against growth faster than polling sees; not under AddressSanitizer, whose shadow is larger.
/// It inherits no descriptor but the first three and what `inherited` says.  `mark`, "NAME=value", is added to
/// its environment.  SIGPIPE is ignored in this process from the first call on, and orphans below it become its
/// children. Throws Failure(unsupported, "cannot start …: reason") where exec fails, std::system_error where
/// fork does.
Spawned spawn(const std::vector<std::string>& command, std::size_t memory_bytes, const std::string& mark,
              const Inherited& inherited = {});

}  // namespace cylon::process
