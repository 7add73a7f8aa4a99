// Whether a worker tells the CPU time of its steps right: its processes are asked too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace cylon::process {

class Conversation;

/// What a worker's processes use from here on, against what the worker tells.
class CpuWitness {
 public:
  explicit CpuWitness(const Conversation&);

  /// CPU time of the worker's own process [s].
  double used() const;
  /// Throws Failure (protocol) where more is told [s] than its processes used meanwhile and 50 ms (ticks of the kernel).
  void require_at_most_used(double told) const;

 private:
  const Conversation& worker_;
  double before_;
};

/// CPU time of one run [s]: told of its steps, and used by the worker's own process from the request to the answer.
struct StepsTold {
  double told = 0, used = 0;
};

/// Throws Failure (protocol) where runs that are made for their times alone used more than twice what is told of their steps.
/// What requests cost is no work of the steps: it is what runs of one step use beside them, of which `again` makes some, but at most
/// a millisecond and ten microseconds a body; and up to a microsecond a step goes for reading clocks.  Of several runs the least
/// counts, which nothing else that the machine does disturbs.  Where more is told than the own process used, others work for it (behind a shell): then all of them are asked, over
/// a quarter of a second.
void require_no_hidden_work(const Conversation&, const std::vector<StepsTold>&, std::size_t bodies,
                            std::int64_t steps, const std::function<StepsTold(std::int64_t steps)>& again);

}  // namespace cylon::process
