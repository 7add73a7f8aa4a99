#include "harness/cli/cores.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

namespace cylon::cli {
namespace {

// "0,4" or "0-1": the threads of one core.
int first_thread_of_core(int thread) {
  std::ifstream file(fmt::format("/sys/devices/system/cpu/cpu{}/topology/thread_siblings_list", thread));
  int first = thread;
  file >> first;
  return first;
}

bool overlap(const Cores& a, const Cores& b) {
  return a.host == b.host && std::ranges::any_of(a.cores, [&](int core) { return b.cores.contains(core); });
}

}  // namespace

Cores own_cores() {
  Cores own;
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) == 0) own.host = name.data();
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(0, sizeof set, &set) == 0)
    for (int thread = 0; thread < CPU_SETSIZE; ++thread)
      if (CPU_ISSET(thread, &set)) own.cores.insert(first_thread_of_core(thread));
  return own;
}

std::string to_text(const Cores& cores) {
  return fmt::format("{} {}", cores.host, fmt::join(cores.cores, " "));
}

Cores cores_from(const std::string& text) {
  std::istringstream words(text);
  Cores cores;
  words >> cores.host;
  for (int core = 0; words >> core;) cores.cores.insert(core);
  return cores;
}

std::size_t share_of_cores(std::span<const Cores> all, std::size_t i) {
  const auto sharing = std::ranges::count_if(all, [&](const Cores& other) { return overlap(all[i], other); });
  return std::max<std::size_t>(
      1, all[i].cores.size() / static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, sharing)));
}

std::string shared_core(std::span<const Cores> all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j)
      for (const int core : all[i].cores)
        if (all[i].host == all[j].host && all[j].cores.contains(core))
          return fmt::format("ranks {} and {} share core {} of {}", i, j, core, all[i].host);
  return "";
}

}  // namespace cylon::cli
