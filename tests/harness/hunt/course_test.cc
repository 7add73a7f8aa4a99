// What an error does under halvings of the step: faults are told from truncation, and one kind from another.
#include "harness/hunt/course.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace cylon::hunt {
namespace {

constexpr double relative = 1e-3, scale = 3, allowed = relative * scale;

// The fault of an error e(k) at dt/2^k, asked as an examination does.
std::optional<Kind> fault(const Expected& expected, const std::function<double(int)>& e) {
  Course course(expected, relative);
  for (int k = 0; k < static_cast<int>(halvings) && course.open(); ++k) course.add(e(k), allowed, 0);
  return course.fault();
}

Expected of_order(int order) { return {{order, false, 0, false}, true, true, 1e-7}; }

std::function<double(int)> falling(double first, double power) {
  return [=](int k) { return first * std::exp2(-power * k); };
}

TEST(Course, TakesTruncationForNoFault) {
  for (const int order : {1, 2, 4})
    for (const double first : {1e-6, 0.04, 0.5, 2.0})
      EXPECT_FALSE(fault(of_order(order), falling(first, order))) << order << ' ' << first;
  // Nor an error of first order that cannot grow beyond its scale at the coarse steps.
  EXPECT_FALSE(fault(of_order(1), [](int k) { return std::min(scale, 12 * std::exp2(-k)); }));
}

// What rests has no truncation: an error that rises and falls, but is as large at the finest steps, is a fault there.
TEST(Course, FindsWhatHasNoOrderWhereAStepMakesNoError) {
  struct Row {
    std::array<double, halvings> errors;  // of what is allowed
    std::optional<Kind> of_rest;
  };
  constexpr Row rows[] = {
      {{230, 145, 860, 2440, 10.4}, Kind::erratic},  // three cubes on each other in ODE
      {{40, 90, 4, 30, 60}, Kind::erratic},         {{40, 90, 4, 3, 2}, std::nullopt},  // gone in the end
      {{400, 200, 100, 50, 25}, std::nullopt},                                          // of first order
      {{9, 90, 900, 900, 900}, std::nullopt},  // a fault of fine steps, which is asked elsewhere
  };
  Expected rests = of_order(1), moves = rests;
  rests.smooth = moves.smooth = false, rests.stepless = true;
  for (const Row& row : rows) {
    const auto error = [&](int k) { return row.errors[static_cast<std::size_t>(k)] * allowed; };
    EXPECT_EQ(fault(rests, error), row.of_rest) << row.errors[0];
    EXPECT_FALSE(fault(moves, error)) << row.errors[0];
  }
}

TEST(Course, FindsWhatStays) {
  EXPECT_EQ(fault(of_order(1), falling(0.2, 0)), Kind::every_step);
  EXPECT_EQ(fault(of_order(4), falling(0.2, -0.1)), Kind::every_step);
  EXPECT_FALSE(fault(of_order(1), falling(9 * allowed, 0)));  // less than ten times what is allowed
  EXPECT_EQ(fault(of_order(1), [](int) { return std::numeric_limits<double>::quiet_NaN(); }),
            Kind::every_step);
}

// An error as large as its scale lets it be, of a scheme of first order: steps of a sixteenth do not tell, a 64th does.
TEST(Course, KnowsAnErrorThatCannotBeLarger) {
  const struct {
    double first;
    bool saturated;
  } rows[] = {{0.9 * scale, true}, {0.04 * scale, false}};
  for (const auto& row : rows) {
    Course course(of_order(1), relative);
    for (std::size_t k = 0; k < halvings; ++k)
      course.add(row.first * (1 - 0.01 * static_cast<double>(k)), allowed, 0);
    EXPECT_EQ(course.may_be_saturated(), row.saturated) << row.first;
    EXPECT_TRUE(course.falls_at_last(0.6 * row.first)) << row.first;
    EXPECT_FALSE(course.falls_at_last(0.9 * row.first)) << row.first;
  }
}

TEST(Course, HoldsASchemeToItsOrder) {
  EXPECT_EQ(fault(of_order(4), falling(0.01, 1)), Kind::own_promise);
  EXPECT_EQ(fault(of_order(2), falling(0.01, 1)), Kind::own_promise);
  EXPECT_FALSE(fault(of_order(2), falling(0.01, 1.7)));
  EXPECT_FALSE(fault(of_order(4), falling(1e-7, 1)));  // rounding
  Expected contact = of_order(4);
  contact.smooth = false;
  EXPECT_FALSE(fault(contact, falling(0.01, 1)));
}

TEST(Course, HoldsAnIntegratorToItsTolerance) {
  const Expected expected{{5, true, 1e-10, false}, true, true, 1e-7};
  EXPECT_EQ(fault(expected, falling(1e-6, 0)), Kind::own_promise);
  EXPECT_FALSE(fault(expected, falling(1e-8, 0)));
}

// A limit that the engine sets on a step: the error is there, and half the step has none.
TEST(Course, TellsAFaultOfTheCoarseStep) {
  const auto clamp = [](int k) { return k == 0 ? 0.5 : 1e-12; };
  EXPECT_EQ(fault(of_order(1), clamp), Kind::coarse_step);
  // A clamp of turns that half the step exceeds, too; not one that a quarter does: the steps left do not tell.
  EXPECT_EQ(fault(of_order(1), [](int k) { return k < 2 ? 0.5 : 1e-12; }), Kind::coarse_step);
  EXPECT_FALSE(fault(of_order(1), [](int k) { return k < 3 ? 0.5 / (1 << k) : 1e-12; }));
  EXPECT_FALSE(fault(of_order(1), falling(0.5, 3)));
  Expected stiff = of_order(1);
  stiff.resolved = false;
  EXPECT_FALSE(fault(stiff, clamp));
  EXPECT_FALSE(fault(of_order(1), [](int k) { return k == 0 ? 1e6 : 1e-12; }));  // an unstable scheme
  EXPECT_FALSE(fault(of_order(1), [](int k) { return k == 0 ? 0.5 : k == 1 ? 1e-6 : 0.4; }));
}

// What the engine says that it does not promise is not held against it; what no step mends is.
TEST(Course, HoldsNoPromiseThatTheEngineTakesBack) {
  const auto told = [](const Expected& expected, int order, const std::function<double(int)>& e) {
    Course course(expected, relative);
    course.not_promised(order);
    for (int k = 0; k < static_cast<int>(halvings) && course.open(); ++k) course.add(e(k), allowed, 0);
    return course.fault();
  };
  EXPECT_FALSE(told(of_order(4), 1, falling(0.01, 1)));
  EXPECT_EQ(told(of_order(4), 4, falling(0.01, 1)), Kind::own_promise);
  const Expected bounded{{8, true, 1e-10, false}, true, true, 1e-7};
  EXPECT_FALSE(told(bounded, 1, [](int k) { return k == 0 ? 0.5 : 1e-12; }));
  EXPECT_FALSE(told(bounded, 8, falling(1e-6, 0)));  // it says that it missed its tolerance
  EXPECT_EQ(told(of_order(4), 1, falling(0.2, 0)), Kind::every_step);
}

TEST(Course, KindsHaveNames) {
  for (const Kind kind : {Kind::every_step, Kind::own_promise, Kind::coarse_step})
    EXPECT_EQ(kind_from(name(kind)), kind);
  EXPECT_FALSE(kind_from("sometimes"));
}

Trial turning(const core::Vector3& moments, double spin, double step) {
  Trial trial;
  core::Body body;
  body.name = "b1", body.inertia = moments.asDiagonal();
  body.initial.angular_velocity = {0, spin, 0};
  trial.scene.bodies = {body};
  trial.step = step;
  return trial;
}

TEST(Resolved, KnowsTheRatesOfAScene) {
  EXPECT_EQ(resolves(turning({1, 1, 1}, 250, 0.01)), true);   // a ball by 2.5 rad a step
  EXPECT_EQ(resolves(turning({1, 1, 1}, 350, 0.01)), false);  // more than half a turn
  EXPECT_EQ(resolves(turning({1, 2, 3}, 250, 0.01)), false);  // a gyroscopic torque
  EXPECT_EQ(resolves(turning({1, 2, 3}, 25, 0.01)), true);
  Trial spring = turning({1, 1, 1}, 0, 0.01);
  spring.scene.forces = {core::Spring{0, {0, 0, 0}, core::world, {0, 1, 0}, 300, 0, 0}};
  EXPECT_EQ(resolves(spring), true);
  std::get<core::Spring>(spring.scene.forces[0]).stiffness = 3000;
  EXPECT_EQ(resolves(spring), false);
  spring.scene.forces = {core::Water{}};
  EXPECT_EQ(resolves(spring), std::nullopt);

  // A pendulum of 1 m: sqrt(9.81 (1 + 1)) = 4.4/s.  With 10 000 kg that hang on the same joint's other end it is 140 times
  // that, which a step of a hundredth does not resolve.
  Trial pendulum = turning({1, 1, 1}, 0, 0.01);
  pendulum.scene.forces = {core::UniformGravity{{0, -9.81, 0}}};
  core::Joint joint;
  joint.body = 0, joint.point = {0, 1, 0};
  pendulum.scene.joints = {joint};
  EXPECT_EQ(resolves(pendulum), true);
  core::Body heavy = pendulum.scene.bodies[0];
  heavy.name = "b2", heavy.mass = 1e4, heavy.inertia *= 1e4, heavy.initial.position = {0, -2, 0};
  pendulum.scene.bodies.push_back(heavy);
  joint.body = 1, joint.to = 0, joint.point = {0, -1, 0};
  pendulum.scene.joints.push_back(joint);
  EXPECT_EQ(resolves(pendulum), false);
  pendulum.step = 1e-4;
  EXPECT_EQ(resolves(pendulum), true);
}

}  // namespace
}  // namespace cylon::hunt
