#include "tests/levels/levels.h"

#include "harness/validation/fit.h"
#include "harness/validation/synthetic.h"
#include "tests/levels/ball_world.h"

#include <numeric>
#include <stdexcept>

namespace cylon::levels {

using validation::Fit, validation::interval;

Trial trial(const Case& what, std::uint64_t seed) {
  std::vector<std::size_t> runs(what.like.runs.size());
  std::iota(runs.begin(), runs.end(), 0);
  const measured::Experiment seen = validation::synthetic(what.like, runs, what.truth, what.world, seed);
  validation::Likelihood likelihood(seen, seen.parameters, runs, what.engine, 1);
  const Fit fit = validation::fit(likelihood);
  Trial found;
  const auto holds = [](const statistics::Interval& i, double x) { return i.low <= x && x <= i.high; };
  for (std::size_t j = 0; j < what.truth.size(); ++j) {
    found.held.push_back(holds(interval(fit.values[j], fit.known.error[j]), what.truth[j]));
    found.held_between.push_back(
        holds(interval(fit.values[j], fit.known.spread[j], fit.known.freedom), what.truth[j]));
  }
  found.told = validation::misfit_tail(fit) < 0.05;
  found.settled = fit.settled;
  return found;
}

std::vector<Case> ball_cases(int throws) {
  using ball_world::Fault, ball_world::world;
  const measured::Experiment e = ball_world::throws(throws, 1);
  const std::vector<double> truth = ball_world::truth();
  // The inertia that the ball has is the model's, and not fitted: an engine that computes with another cannot be put right.
  measured::Experiment known = e;
  known.model.scene.bodies[0].inertia *= ball_world::inertia;
  known.parameters.erase(known.parameters.begin() + 2);
  // Steps in which a ball falls further than it errs, as a box does in steps of 1/1480 s that is seen to half a millimetre.
  measured::Experiment stepped = ball_world::throws(throws, 1, 1);
  stepped.model.step = 0.001;
  const std::vector<double> rest = {truth[0], truth[1], truth[3]};
  return {{"ball", e, truth, world(), world()},
          {"ball, larger errors", ball_world::throws(throws, 1, 1), truth, world(), world()},
          {"ball, in steps", stepped, truth, world({.in_steps = true}), world({.in_steps = true})},
          {"ball, inertia known", known, rest, world(), world()},
          {"ball, pyramid", known, rest, world(), world({.pyramid = true})},
          {"ball, no restitution", known, rest, world(), world({.no_restitution = true})},
          {"ball, inertia +10 %", known, rest, world(), world({.inertia = 1.1})}};
}

const Case& find(const std::vector<Case>& cases, const std::string& name) {
  for (const Case& one : cases)
    if (one.name == name) return one;
  throw std::invalid_argument("no case '" + name + "'");
}

}  // namespace cylon::levels
