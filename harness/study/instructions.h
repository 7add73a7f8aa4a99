// How many instructions an engine's steps take: a cost that does not depend on what else the machine does.
// Counted by the processor where the kernel lets us, else by callgrind, else not at all; which of them is
// said.
#pragma once

#include "harness/core/scene.h"
#include "harness/process/client.h"
#include "harness/process/engines.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cylon::study {

enum class Counter { off, perf_event, callgrind };

/// "off", "perf_event", "callgrind".
std::string_view name(Counter);
std::optional<Counter> counter_from(std::string_view);

struct CounterFound {
  Counter counter = Counter::off;
  std::string why;  ///< Why none of the better ones: "perf_event_open: No such file or directory".
};

/// The best counter of this machine, found out once.
const CounterFound& find_counter();

struct InstructionRequest {
  const core::Scene* scene = nullptr;
  double dt = 0;           ///< [s]
  std::int64_t steps = 0;  ///< >= 1; counted are the second `steps` of twice as many.
  /// Steps between samples, where the steps can be counted alone; else only the end is recorded.  An engine
  /// may go from sample to sample in one stride.
  std::int64_t every = 1;
  double tolerance = 0;  ///< As core::Setup has it.
};

struct InstructionCount {
  Counter counter = Counter::off;
  /// Instructions in user space of steps n + 1 … 2n; absent: `remark` says why.
  std::optional<std::int64_t> instructions;
  std::int64_t steps = 0;  ///< n
  /// Nothing but the engine's steps was counted, so that runs agree to the last instruction; else what the
  /// worker prints too, and runs differ by some hundred in all.
  bool steps_alone = false;
  std::string remark;  ///< One sentence: what was counted, or why nothing.
};

/// The steps that are worth counting in a scene, a function of the scene alone, so that counts of different
/// days may be compared: at most half of `steps`, 1000 body-steps where that is 20 steps or more.
std::int64_t steps_to_count(std::size_t bodies, std::int64_t steps);

/// count = I(2n) - I(n), with I(m) the instructions that the worker process executes in user space for a run
/// of m steps: what does not belong to steps - the dynamic linker, reading the scene, load, what the first
/// steps set up - is in both and drops out, whatever the engine.
///
/// Under callgrind only Simulator::advance is collected where the worker has that symbol, as all of ours do:
/// what the worker prints (times, as decimal digits) then does not count either, and the count is the same to
/// the last instruction.  A worker that has not is counted whole.  Callgrind takes some 40 times as long, so
/// the limit of the run is that much longer too.  Throws what process::run throws.
InstructionCount count_instructions(const process::EngineChoice&, const InstructionRequest&,
                                    const process::Limits& = {}, Counter = find_counter().counter);

}  // namespace cylon::study
