// Energies of springs and forces on angles that turn many times: a motor at constant power and a spring wound up, with
// motions in closed form.
#include "harness/core/turns.h"

#include "harness/core/measure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace cylon::core;

constexpr double inertia = 0.4, start = 0.3;

// A wheel on an axle through its centre, turning at `rate`, with a law on its angle.
Scene wheel(JointAngle law, double rate) {
  Scene scene;
  Body body;
  body.mass = 2, body.inertia = inertia * Matrix3::Identity();
  body.initial.orientation = Quaternion(Eigen::AngleAxisd(0.8, Vector3(1, 2, -1).normalized()));
  body.initial.angular_velocity = rate * Vector3(2, -1, 2) / 3;
  scene.bodies = {body};
  law.start = start;
  scene.joints = {{.type = JointType::hinge, .body = 0, .axis = Vector3(2, -1, 2) / 3, .angles = {law}}};
  return scene;
}

// The wheel after it has turned by angle(t) at rate(t).
Recording recording(const Scene& scene, double dt, std::int64_t steps, double (*angle)(double),
                    double (*rate)(double)) {
  Recording all;
  all.dt = dt;
  const Vector3 axis = scene.joints[0].axis;
  for (std::int64_t n = 0; n <= steps; ++n) {
    const double t = static_cast<double>(n) * dt;
    State state = initial_state(scene);
    state[0].orientation = Quaternion(Eigen::AngleAxisd(angle(t), axis)) * state[0].orientation;
    state[0].angular_velocity = rate(t) * axis;
    all.steps.push_back(n), all.states.push_back(state);
  }
  return all;
}

Claim energy(Reduction reduction) {
  Claim claim;
  claim.observable.quantity = Quantity::energy;
  claim.reduction = reduction;
  claim.tolerance.absolute = 1e-9;
  return claim;
}

struct Case {
  const char* name;
  JointAngle law;
  double rate;
  double (*angle)(double);
  double (*rates)(double);
};

std::vector<Case> cases() {
  JointAngle motor, spring;
  motor.force = 0.8;                            // 2 rad/s^2
  spring.stiffness = 0.1, spring.target = 0.3;  // 0.5 rad/s, 14 rad wide
  return {{"motor", motor, -3, [](double t) { return t * t - 3 * t; }, [](double t) { return 2 * t - 3; }},
          {"spring", spring, 7, [](double t) { return 14 * std::sin(t / 2); },
           [](double t) { return 7 * std::cos(t / 2); }}};
}

// The angle within half a turn has jumps of up to 2 pi, and the energy with it: that was a rise of 5 J.
TEST(Turns, AreCountedInEnergies) {
  for (const Case& c : cases()) {
    const Scene scene = wheel(c.law, c.rate);
    for (const double dt : {0.01, 0.1}) {
      const Recording run = recording(scene, dt, std::llround(20 / dt), c.angle, c.rates);
      for (const Reduction reduction : {Reduction::max, Reduction::increase, Reduction::decrease}) {
        const Measured measured = measure(energy(reduction), scene, std::span(&run, 1), 20);
        EXPECT_LE(measured.value, 1e-10) << c.name << ' ' << dt;
        EXPECT_FALSE(measured.unanswered);
      }
    }
  }
}

// Who claims the wrong energy is found out: a motor that gives nothing.
TEST(Turns, DoNotHideWork) {
  const Case motor = cases().front();
  const Scene scene = wheel(motor.law, motor.rate);
  const Recording idle = recording(
      scene, 0.01, 2000, [](double t) { return -3 * t; }, [](double) { return -3.; });
  const Measured measured = measure(energy(Reduction::max), scene, std::span(&idle, 1), 20);
  EXPECT_NEAR(measured.value, 0.8 * 60, 1e-9);
}

TEST(Turns, AreLostWhereSamplesAreTooFarApart) {
  for (const Case& c : cases()) {
    const Scene scene = wheel(c.law, c.rate);
    const Recording run = recording(scene, 2.5, 8, c.angle, [](double) { return 0.; });
    EXPECT_TRUE(measure(energy(Reduction::max), scene, std::span(&run, 1), 20).unanswered) << c.name;
  }
}

// Where the truth's turns are lost, an engine that does not move is not accused of numbers that are none.
TEST(Turns, OfATruthMayBeLost) {
  const Case c = cases().front();
  const Scene scene = wheel(c.law, 0);
  const Recording still = recording(
      scene, 2.5, 8, [](double) { return 0.; }, [](double) { return 0.; });
  Claim claim = energy(Reduction::max);
  claim.truth.emplace();
  claim.truth->state = [&](double t) {
    State state = initial_state(scene);
    state[0].orientation =
        Quaternion(Eigen::AngleAxisd(c.angle(t), scene.joints[0].axis)) * state[0].orientation;
    return state;
  };
  EXPECT_TRUE(measure(claim, scene, std::span(&still, 1), 20).unanswered);
}

// Between stops within half a turn, and of what has no potential, a state tells all.
TEST(Turns, AreCountedWhereTheyMatter) {
  JointAngle damped, held;
  damped.damping = 1;
  held.force = 1, held.lower = start - 1, held.upper = start + 2;
  JointAngle half_held = held;
  half_held.upper.reset();
  const Observable q{.quantity = Quantity::energy}, other{.quantity = Quantity::kinetic_energy};
  EXPECT_FALSE(AlongMotion(q, wheel(damped, 1)).counts());
  EXPECT_FALSE(AlongMotion(q, wheel(held, 1)).counts());
  EXPECT_TRUE(AlongMotion(q, wheel(half_held, 1)).counts());
  EXPECT_FALSE(AlongMotion(other, wheel(half_held, 1)).counts());
}

}  // namespace
