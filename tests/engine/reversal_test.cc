// A reversible integrator returns to its start when the momenta are reversed and the steps are repeated.
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

Model reversed(Model model, const std::vector<Motion>& from) {
  model.motions = from;
  for (Motion& m : model.motions) {
    m.momentum = -m.momentum;
    m.angular_momentum = -m.angular_momentum;
  }
  return model;
}

// How far the way back ends from the start.
Real astray(const Model& model, std::string_view integrator, Time dt, int steps) {
  const Outcome out = run(model, with(integrator, dt), steps);
  const Outcome back = run(reversed(model, out.motions), with(integrator, dt), steps);
  return distance(reversed(model, back.motions).motions, model.motions);
}

class Reversal : public EveryIntegrator {};

// Both ways round off at each part of each step, and the motion spreads what was rounded: within 1 s here by
// no more than 10.  Measured below a fifth of it.
Real rounding(const Integrator& integrator, int steps) {
  return 2 * steps * (integrator.evaluations + 1) * 10 * std::numeric_limits<Real>::epsilon();
}

TEST_P(Reversal, LeadsBackFromSprings) {
  const int steps = 100;
  const Real error = astray(coupled_bodies(), GetParam().name, 0.01, steps);
  if (GetParam().reversible) {
    EXPECT_LT(error, rounding(GetParam(), steps));
  } else if (GetParam().order < 8) {
    EXPECT_GT(error, 100 * rounding(GetParam(), steps));  // negative control
  }
}

TEST_P(Reversal, LeadsBackFromPoints) {
  Model model;
  add_body(model, make_body(1.2, Matrix3::Zero()), {0.7, 0.2, 0.3}, {0, 0, 0}, {-0.3, 0.4, 0.1}, {0, 0, 0});
  add_body(model, make_body(0.9, Matrix3::Zero()), {-0.5, 0.9, 0.1}, {0, 0, 0}, {0.3, 0.6, -0.8}, {0, 0, 0});
  model.forces.gravity = {0.1, -9.81, 0.2};
  model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0.1, 0.3, -0.2}, 17.0, 0.35, 0});
  model.forces.springs.push_back({1, {0, 0, 0}, 0, {0, 0, 0}, 11.0, 0.6, 0});
  if (GetParam().reversible) {
    EXPECT_LT(astray(model, GetParam().name, 0.01, 100), rounding(GetParam(), 100));
  }
}

TEST_P(Reversal, LeadsBackFromAHeavyTop) {
  if (GetParam().reversible) {
    EXPECT_LT(astray(heavy_top(), GetParam().name, 0.005, 100), rounding(GetParam(), 100));
  }
}

// RATTLE is reversible: both impulses of a step lie along constraints that the other way meets in turn.  Its
// Newton iterations stop some ulp from closed.
TEST_P(Reversal, LeadsBackFromJoints) {
  if (!GetParam().reversible || !GetParam().constraints) return;
  for (const bool pinned : {false, true}) {
    EXPECT_LT(astray(linked_bodies(pinned), GetParam().name, 0.005, 100), 10 * rounding(GetParam(), 100))
        << pinned;
  }
}

CYLON_EVERY_SCHEME(Reversal);

}  // namespace
}  // namespace cylon::engine
