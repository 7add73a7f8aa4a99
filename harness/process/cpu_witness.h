// Whether a worker tells the CPU time of its steps right: its processes are asked too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace cylon::process {

class Conversation;

/// Whose CPU time: that of the process that the harness started, or that of all which descends from it too.
enum class Asked { process, family };

/// What a worker's processes use from here on, against what the worker tells.
class CpuWitness {
 public:
  explicit CpuWitness(const Conversation&, Asked = Asked::process);

  /// CPU time since then [s].
  double used() const;
  /// Throws Failure (protocol) where more is told [s] than its processes used meanwhile and 50 ms (ticks of the kernel).
  void require_at_most_used(double told) const;
  /// Whether the own process used at least what is told [s], but for the 20 us between two clocks, and at most twice that.
  /// Not in short runs, where requests and samples cost more than steps, nor where other processes work for this one.
  bool confirms(double told) const;

 private:
  double now() const;

  const Conversation& worker_;
  Asked asked_;
  double before_;
};

/// CPU time of one run [s]: told of its steps, and used from the request to the answer.
struct StepsTold {
  double told = 0, used = 0;
};

/// Throws Failure (protocol) where runs that are made for their times alone used more than twice what is told of their steps.
/// What requests cost is no work of the steps: it is what runs of one step use beside them, of which `again` makes some, but at most
/// a millisecond and ten microseconds a body; and up to a microsecond a step goes for reading clocks.  Of several runs the least
/// counts, which nothing else that the machine does disturbs.  Where more is told than the own process used, others work for it (behind
/// a shell, in the sandbox): then its family is asked, of some runs more.
void require_no_hidden_work(const std::vector<StepsTold>&, std::size_t bodies, std::int64_t steps,
                            const std::function<StepsTold(std::int64_t steps, Asked)>& again);

}  // namespace cylon::process
