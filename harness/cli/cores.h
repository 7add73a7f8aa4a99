// Which cores of which machine a process may use, as processes of one farm tell each other.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace cylon::cli {

struct Cores {
  std::string host;
  std::set<int> cores;  ///< By their first hardware thread, so that two threads of one core are one.
  friend bool operator==(const Cores&, const Cores&) = default;
};

/// Of this process, by its affinity.
Cores own_cores();

std::string to_text(const Cores&);
Cores cores_from(const std::string&);

/// How many cores process `i` may keep busy: its cores, divided by the processes that may use one of them.  At least 1.
std::size_t share_of_cores(std::span<const Cores>, std::size_t i);

/// "" where each process has a core that no other may use, else "ranks 0 and 2 share core 5 of node7".
std::string shared_core(std::span<const Cores>);

}  // namespace cylon::cli
