#include "tests/mutants/matrix/record.h"

#include "harness/core/event_watch.h"

#include <algorithm>

namespace cylon::mutants {

core::Recording record(core::Simulator& simulator, const core::Scene& scene, const core::Setup& setup,
                       const study::Sampling& plan) {
  core::Recording result;
  result.dt = setup.dt;
  result.terms = simulator.load(scene, setup);
  result.engine = simulator.engine();
  core::EventWatch watch(scene, plan.watch, setup.dt);
  core::State state(scene.bodies.size());
  for (std::int64_t step = 0; step <= plan.steps; ++step) {
    if (plan.contacts && step == plan.steps) simulator.keep_contacts(true);
    if (step > 0) simulator.step();
    const bool kept = step % plan.every == 0 || step == plan.steps ||
                      std::binary_search(plan.at.begin(), plan.at.end(), step);
    if (!kept && plan.watch.empty()) continue;
    simulator.read(state);
    if (!plan.watch.empty()) watch.observe(step, state);
    if (kept) result.steps.push_back(step), result.states.push_back(state);
  }
  result.events = watch.take();
  if (plan.contacts) result.contacts = simulator.contacts(), result.reactions = simulator.reactions();
  return result;
}

}  // namespace cylon::mutants
