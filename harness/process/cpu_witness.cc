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
constexpr double enough = 0.25;           // [s]
constexpr int requests_asked = 10, most_runs = 200;

[[noreturn]] void broken(const std::string& reason) { throw Failure(results::Status::protocol, reason); }

// What a run uses beside its steps.
double beside(const StepsTold& run) { return run.used - run.told; }

// Of the process that the harness started and all that it started in turn.
void ask_family(const Conversation& worker, std::int64_t steps,
                const std::function<StepsTold(std::int64_t)>& again) {
  constexpr int between = 10;  // looks into /proc, which cost a run each
  const double start = worker.family_cpu_seconds();
  double used = 0, told = 0;
  for (int runs = 0; runs < most_runs && used < enough; used = worker.family_cpu_seconds() - start)
    for (int i = 0; i < between; ++i, ++runs) told += again(steps).told;
  if (2 * told + of_ticks < used)
    broken(fmt::format("step_ns: {:.3g} s of CPU time for the steps, but its processes used {:.3g} s", told,
                       used));
}

}  // namespace

CpuWitness::CpuWitness(const Conversation& worker) : worker_(worker), before_(worker.cpu_seconds()) {}

double CpuWitness::used() const { return worker_.cpu_seconds() - before_; }

void CpuWitness::require_at_most_used(double told) const {
  const double own = used();
  if (!(told > own + of_ticks)) return;
  // A worker behind a shell, or with helpers: what its family used since it was started.
  if (told > worker_.family_cpu_seconds() + of_ticks)
    broken(fmt::format("step_ns: {:.3g} s of CPU time for the steps, but its processes used {:.3g} s in all",
                       told, own));
}

void require_no_hidden_work(const Conversation& worker, const std::vector<StepsTold>& runs,
                            std::size_t bodies, std::int64_t steps,
                            const std::function<StepsTold(std::int64_t)>& again) {
  if (runs.empty() || steps < 2) return;
  const auto least = std::ranges::min_element(runs, {}, beside);
  if (least->told > least->used) return ask_family(worker, steps, again);
  const double allowed = least->told + clock_of_step * static_cast<double>(steps) + of_clocks;
  if (beside(*least) <= allowed) return;
  const double dearest = dearest_request + dearest_body * static_cast<double>(bodies);
  double requests = dearest;
  for (int i = 0; i < requests_asked; ++i) requests = std::min(requests, beside(again(1)));
  if (const double hidden = beside(*least) - requests; hidden > allowed)
    broken(fmt::format(
        "step_ns: {:.3g} s of CPU time for the steps, but its process used {:.3g} s, {:.3g} s more than "
        "a run of one step uses",
        least->told, least->used, hidden));
}

}  // namespace cylon::process
