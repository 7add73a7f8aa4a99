#include "harness/process/cpu_witness.h"

#include "harness/process/conversation.h"
#include "harness/process/failure.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::process {
namespace {

constexpr double of_ticks = 0.05;         // [s]: what the kernel counts in ticks of 10 ms is good to that
constexpr double of_clocks = 2e-5;        // [s]: between the worker's clock and ours
constexpr double clock_of_step = 1e-6;    // [s]: read before and after each
constexpr double dearest_request = 1e-3;  // [s]
constexpr double dearest_body = 1e-5;     // [s]: a state packed by an interpreter
constexpr int runs_asked = 10;

[[noreturn]] void broken(const std::string& reason) { throw Failure(results::Status::protocol, reason); }

// What a run uses beside its steps.
double beside(const StepsTold& run) { return run.used - run.told; }
bool by_beside(const StepsTold& a, const StepsTold& b) { return beside(a) < beside(b); }

}  // namespace

CpuWitness::CpuWitness(const Conversation& worker, Asked asked)
    : worker_(worker), asked_(asked), before_(now()) {}

double CpuWitness::now() const {
  return asked_ == Asked::family ? worker_.family_cpu_seconds() : worker_.cpu_seconds();
}

double CpuWitness::used() const { return now() - before_; }

void CpuWitness::require_at_most_used(double told) const {
  const double own = used();
  if (!(told > own + of_ticks)) return;
  // A worker behind a shell, or with helpers: what its family used since it was started.
  if (told > worker_.family_cpu_seconds() + of_ticks)
    broken(fmt::format("step_ns: {:.3g} s of CPU time for the steps, but its processes used {:.3g} s in all",
                       told, own));
}

bool CpuWitness::confirms(double told) const {
  const double own = used();
  return told <= own + of_clocks && own <= 2 * told;
}

void require_no_hidden_work(const std::vector<StepsTold>& runs, std::size_t bodies, std::int64_t steps,
                            const std::function<StepsTold(std::int64_t, Asked)>& again) {
  if (runs.empty() || steps < 2) return;
  StepsTold least = *std::ranges::min_element(runs, {}, beside);
  const Asked asked = least.told > least.used ? Asked::family : Asked::process;
  const auto least_of = [&](std::int64_t count) {
    StepsTold found = again(count, asked);
    for (int i = 1; i < runs_asked; ++i) found = std::min(found, again(count, asked), by_beside);
    return found;
  };
  if (asked == Asked::family) least = least_of(steps);
  const double allowed = least.told + clock_of_step * static_cast<double>(steps) + of_clocks;
  if (beside(least) <= allowed) return;
  const double dearest = dearest_request + dearest_body * static_cast<double>(bodies);
  const double requests = std::min(dearest, beside(least_of(1)));
  if (const double hidden = beside(least) - requests; hidden > allowed)
    broken(fmt::format(
        "step_ns: {:.3g} s of CPU time for the steps, but its processes used {:.3g} s, {:.3g} s more than "
        "a run of one step uses",
        least.told, least.used, hidden));
}

}  // namespace cylon::process
