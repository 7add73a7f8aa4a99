#include "harness/study/instructions.h"

#include <fmt/format.h>

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>
#include <utility>

namespace cylon::study {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<Counter, std::string_view>, 3> names = {
    {{Counter::off, "off"}, {Counter::perf_event, "perf_event"}, {Counter::callgrind, "callgrind"}}};

constexpr double callgrind_slowness = 50;  // 40 times was measured, and the start of valgrind itself

// ---- The processor's own counter -------------------------------------------------------------------

/// Counts what the children of this thread execute in user space, each from its exec on; itself not at all.
class PerfEvent {
 public:
  PerfEvent() {
    perf_event_attr attr{};
    attr.size = sizeof attr;
    attr.type = PERF_TYPE_HARDWARE;
    attr.config = PERF_COUNT_HW_INSTRUCTIONS;
    attr.disabled = 1;
    attr.inherit = 1;         // a fork takes it along,
    attr.enable_on_exec = 1;  // and it starts to count there
    attr.exclude_kernel = 1;
    attr.exclude_hv = 1;
    fd_ = static_cast<int>(syscall(SYS_perf_event_open, &attr, 0, -1, -1, PERF_FLAG_FD_CLOEXEC));
    if (fd_ < 0) error_ = errno;
  }
  ~PerfEvent() {
    if (fd_ >= 0) ::close(fd_);
  }
  PerfEvent(const PerfEvent&) = delete;
  PerfEvent& operator=(const PerfEvent&) = delete;

  bool is_open() const { return fd_ >= 0; }
  std::string reason() const { return std::generic_category().message(error_); }

  /// Of all children that have been reaped.
  std::optional<std::int64_t> read() const {
    std::int64_t count = 0;
    if (::read(fd_, &count, sizeof count) != static_cast<ssize_t>(sizeof count) || count <= 0)
      return std::nullopt;
    return count;
  }

 private:
  int fd_ = -1, error_ = 0;
};

// ---- Callgrind ---------------------------------------------------------------------------------------

bool has_valgrind() {
  const char* path = std::getenv("PATH");
  std::string folders = path ? path : "/usr/bin:/bin";
  for (std::size_t at = 0; at <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', at), folders.size());
    if (::access((fs::path(folders.substr(at, end - at)) / "valgrind").c_str(), X_OK) == 0) return true;
    at = end + 1;
  }
  return false;
}

/// A file of our own that is gone with this object.
class TemporaryFile {
 public:
  TemporaryFile() : path_((fs::temp_directory_path() / "cylon-count-XXXXXX").string()) {
    const int fd = ::mkstemp(path_.data());
    if (fd < 0) throw std::system_error(errno, std::generic_category(), path_);
    ::close(fd);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// "totals: 9740442" ends the file that callgrind writes at exit; nothing where it never got there.
std::optional<std::int64_t> total_in(const std::string& file) {
  std::ifstream in(file);
  std::optional<std::int64_t> total;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("totals:")) total = std::strtoll(line.c_str() + 7, nullptr, 10);
  return total;
}

process::EngineChoice under_callgrind(process::EngineChoice engine, const std::string& file,
                                      bool steps_alone) {
  std::vector<std::string> command = {"valgrind", "-q", "--tool=callgrind", "--callgrind-out-file=" + file};
  if (steps_alone)
    for (const char* function :
         {"cylon::simulators::*::advance(long)", "cylon::core::Simulator::advance(long)"})
      command.push_back(fmt::format("--toggle-collect={}", function));
  engine.row.started_by = std::move(command);
  return engine;
}

// ---- One run -----------------------------------------------------------------------------------------

struct Counted {
  std::optional<std::int64_t> instructions;
  std::string why;  // not
};

Counted count_run(const process::EngineChoice& engine, const process::RunRequest& request,
                  const process::Limits& limits, Counter counter, bool steps_alone) {
  const TemporaryFile file;
  const auto perf = counter == Counter::perf_event ? std::make_unique<PerfEvent>() : nullptr;
  if (perf && !perf->is_open()) return {std::nullopt, "perf_event_open: " + perf->reason()};
  const process::RunOutcome outcome =
      process::run(perf ? engine : under_callgrind(engine, file.path(), steps_alone), request, limits);
  if (outcome.status != results::Status::pass)
    return {std::nullopt, fmt::format("{}: {}", results::name(outcome.status), outcome.reason)};
  if (const auto count = perf ? perf->read() : total_in(file.path())) return {count, ""};
  return {std::nullopt, fmt::format("{} reported no count", name(counter))};
}

}  // namespace

std::string_view name(Counter counter) {
  return std::find_if(names.begin(), names.end(), [&](const auto& row) { return row.first == counter; })
      ->second;
}

std::optional<Counter> counter_from(std::string_view text) {
  for (const auto& [counter, word] : names)
    if (word == text) return counter;
  return std::nullopt;
}

const CounterFound& find_counter() {
  static const CounterFound found = [] {
    const PerfEvent perf;
    if (perf.is_open()) return CounterFound{Counter::perf_event, ""};
    const std::string why = "perf_event_open: " + perf.reason();
    if (has_valgrind()) return CounterFound{Counter::callgrind, why};
    return CounterFound{Counter::off, why + "; valgrind is not installed"};
  }();
  return found;
}

std::int64_t steps_to_count(std::size_t bodies, std::int64_t steps) {
  const auto worthwhile = static_cast<std::int64_t>(1000 / std::max<std::size_t>(1, bodies));
  return std::clamp<std::int64_t>(std::max<std::int64_t>(20, worthwhile), 1,
                                  std::max<std::int64_t>(1, steps / 2));
}

InstructionCount count_instructions(const process::EngineChoice& engine, const InstructionRequest& asked,
                                    const process::Limits& limits, Counter counter) {
  InstructionCount result{.counter = counter, .steps = asked.steps};
  if (counter == Counter::off) {
    result.remark = "instructions are not counted: " + find_counter().why;
    return result;
  }
  process::RunRequest request;
  request.scene = asked.scene;
  request.setup.dt = asked.dt, request.setup.tolerance = asked.tolerance;
  process::Limits longer = limits;
  if (counter == Counter::callgrind) {
    longer.run_seconds *= callgrind_slowness, longer.hello_seconds *= 6;
    longer.quit_seconds = 30;  // it writes its file between quit and exit
  }

  // I(2n) and I(n); a worker whose steps cannot be told from the rest counts nothing, and is counted whole.
  for (const bool steps_alone : {true, false}) {
    if (steps_alone && counter != Counter::callgrind) continue;
    request.every = steps_alone ? asked.every : 2 * asked.steps;
    request.steps = 2 * asked.steps;
    const Counted twice = count_run(engine, request, longer, counter, steps_alone);
    if (twice.instructions && *twice.instructions == 0) continue;
    request.steps = asked.steps;
    const Counted once =
        twice.instructions ? count_run(engine, request, longer, counter, steps_alone) : Counted{};
    if (!twice.instructions || !once.instructions) {
      result.remark = twice.instructions ? once.why : twice.why;
      return result;
    }
    result.instructions = *twice.instructions - *once.instructions;
    result.steps_alone = steps_alone;
    result.remark = fmt::format("{}: {} of steps {} to {}", name(counter),
                                steps_alone ? "the engine's instructions" : "all instructions of the worker",
                                asked.steps + 1, 2 * asked.steps);
    return result;
  }
  result.remark = fmt::format("{} counted no instruction", name(counter));
  return result;
}

}  // namespace cylon::study
