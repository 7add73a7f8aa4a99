#include "reports/provenance.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <fstream>
#include <string_view>
#include <thread>

#ifndef CYLON_VERSION
#define CYLON_VERSION "unknown"
#endif
#ifndef CYLON_REVISION
#define CYLON_REVISION ""
#endif

namespace cylon::reports {
namespace {

// What follows `separator` in the first line that starts with `key`; else "".
std::string look_up(const char* path, std::string_view key, char separator) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const std::size_t at = line.find(separator);
    const std::size_t begin = at == std::string::npos ? at : line.find_first_not_of(" \t\"", at + 1);
    if (begin == std::string::npos) return "";
    return line.substr(begin, line.find_last_not_of(" \t\"") + 1 - begin);
  }
  return "";
}

std::string compiler() {
#if defined(__clang__)
  return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("gcc {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "unknown";
#endif
}

std::string flags() {
#ifdef CYLON_FLAGS
  return CYLON_FLAGS;
#else
  std::string found;
  const auto add = [&](std::string_view flag) { (found += found.empty() ? "" : " ") += flag; };
#ifdef __OPTIMIZE__
  add("optimized");
#else
  add("not optimized");
#endif
#ifdef NDEBUG
  add("NDEBUG");
#endif
#ifdef __AVX512F__
  add("AVX512F");
#elif defined(__AVX2__)
  add("AVX2");
#endif
#ifdef __FMA__
  add("FMA");
#endif
#ifdef __FAST_MATH__
  add("fast-math");
#endif
#ifdef __SANITIZE_ADDRESS__
  add("address-sanitizer");
#endif
#ifdef __SANITIZE_THREAD__
  add("thread-sanitizer");
#endif
  return found;
#endif
}

std::string machine() {
  const std::string processor = look_up("/proc/cpuinfo", "model name", ':');
  return fmt::format("{}, {} logical CPUs", processor.empty() ? "unknown processor" : processor,
                     std::thread::hardware_concurrency());
}

std::string os() {
  utsname kernel{};
  const bool known = uname(&kernel) == 0;
  const std::string system = look_up("/etc/os-release", "PRETTY_NAME", '=');
  return fmt::format("{}{}{}", system, system.empty() || !known ? "" : ", ",
                     known ? fmt::format("{} {} {}", kernel.sysname, kernel.release, kernel.machine) : "");
}

}  // namespace

Provenance build_and_machine() {
  return {.cylon = CYLON_VERSION,
          .revision = CYLON_REVISION,
          .compiler = compiler(),
          .flags = flags(),
          .machine = machine(),
          .os = os(),
          .date = "",
          .command_line = "",
          .tolerance_scale = 1};
}

}  // namespace cylon::reports
