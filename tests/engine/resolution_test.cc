// Scenes beyond the precision of the number type are rejected, by the same multiples of its epsilon.
#include "engine/resolution.h"

#include "engine/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace cylon::engine {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Real half = Real(0.37);  // half-width of what touches, and length of what is linked [m]

// A unit in the last place of x is between epsilon x/2 and epsilon x.  `units`: the error in these units.
constexpr Real held(Real units) { return Real(0.9) * largest_error * half / (units * epsilon); }
constexpr Real lost(Real units) { return Real(2.1) * largest_error * half / (units * epsilon); }
constexpr Real balance = 2 * largest_error / epsilon;  // ratio of masses
constexpr Real carried = Real(0.9) * balance, crushing = Real(1.1) * balance;

Options automatic() { return {.dt = 0.01}; }

void add_ball(Model& model, Real mass, const Vector3& position, bool touches) {
  const Body body = make_body(mass, Matrix3::Identity() * (mass * half * half * Real(0.4)));
  model.bodies.push_back(body);
  model.motions.push_back(
      make_motion(body, position, Quaternion::Identity(), {Real(0.1), Real(0.2), 0}, Vector3::Zero()));
  model.shapes.emplace_back(Sphere{half});
  model.surfaces.push_back(touches ? 0 : no_surface);
  model.surface_count = 1;
  model.materials = {{Real(0.5), 0}};
}

void add_floor(Model& model, Real offset) {
  model.planes.push_back({Vector3::UnitY(), offset});
  model.plane_surfaces.push_back(0);
  model.forces.gravity = {0, Real(-9.81), 0};
}

// One thing of each kind, x away from the origin.
Model ball(Real x) {
  Model model;
  add_ball(model, Real(1.3), {Real(0.2), x, Real(0.3)}, true);
  add_floor(model, 0);
  return model;
}
Model ball_along_the_floor(Real x) {
  Model model;
  add_ball(model, Real(1.3), {Real(0.2), 2, -x}, true);
  add_floor(model, 0);
  return model;
}
Model balls(Real x) {
  Model model = ball_along_the_floor(x);
  add_ball(model, Real(1.3), {Real(0.2), 4, -x}, true);
  return model;
}
Model ball_alone(Real x) {
  Model model;
  add_ball(model, Real(1.3), {Real(0.2), 2, -x}, true);
  model.forces.gravity = {0, Real(-9.81), 0};
  return model;
}
Model floor_far_below(Real x) {
  Model model;
  add_ball(model, Real(1.3), {Real(0.2), 2, Real(0.3)}, true);
  add_floor(model, -x);
  return model;
}
Model wall(Real x) {
  Model model = ball(1);
  add_ball(model, 1, {x, 0, 0}, true);
  model.bodies.back() = make_body(1, Matrix3::Identity(), true);
  return model;
}
Model spring(Real x) {
  Model model;
  add_ball(model, Real(1.3), {x, Real(0.1), 0}, false);
  model.forces.springs.push_back({0, Vector3::Zero(), fixed_world, {x, Real(0.1), half}, 5, 0, 0});
  return model;
}
Model spring_at_rest(Real x) {
  Model model;
  add_ball(model, Real(1.3), {x, Real(0.1), 0}, false);
  model.forces.springs.push_back({0, Vector3::Zero(), fixed_world, {x, Real(0.1), 0}, 5, half, 0});
  return model;
}
Model attraction(Real x) {
  Model model;
  add_ball(model, Real(1.3), {x, Real(0.1), 0}, false);
  add_ball(model, Real(0.7), {x, Real(0.1), half}, false);
  model.forces.attractions.push_back({0, 1, Real(0.3)});
  return model;
}
Model pendulum(Real x) {
  Model model;
  add_ball(model, Real(1.3), {x, Real(0.1), 0}, false);
  model.motions[0].momentum.setZero();
  model.joints.push_back({.body = 0, .anchor = {0, 0, half}, .to_anchor = {x, Real(0.1), half}});
  return model;
}

struct Far {
  const char *name, *says;
  Model (*model)(Real);
  Real units;
};
constexpr Far far_things[] = {
    {"ball", "body 0 is ", ball, Real(0.5)},
    {"balls", "body 0 is ", balls, 1},
    {"plane", "plane 0 is ", floor_far_below, Real(0.5)},
    {"wall", "body 1 is ", wall, 1},
    {"spring", "a spring of body 0 is ", spring, 1},
    {"spring at rest", "a spring of body 0 is ", spring_at_rest, 1},
    {"attraction", "an attraction of body 0 is ", attraction, 1},
    {"joint", "a joint of body 0 is ", pendulum, 1},
};

TEST(Resolution, RejectsOnlyLengthsBelowPrecision) {
  for (const Far& row : far_things) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(unsupported(row.model(held(row.units)), automatic()), "");
    const std::string reason = unsupported(row.model(lost(row.units)), automatic());
    EXPECT_EQ(reason.find(row.says), 0u) << reason;
    EXPECT_NE(reason.find(sizeof(Real) == 4 ? "single precision" : "double precision"), std::string::npos);
    EXPECT_NE(reason.find("more than a tenth of "), std::string::npos) << reason;
    EXPECT_NE(reason.find("0.37 m"), std::string::npos) << reason;
  }
}

#ifdef CYLON_ENGINE_FLOAT  // in double the places would have to be drawn in a wider type
// The bound is the largest error of the stored distance itself: places drawn over a unit in the last place.
TEST(Resolution, TheErrorOfADistanceIsBelowTheBoundAndComesNearIt) {
  constexpr Real x = lost(1);
  const Real unit = std::nextafter(x, 2 * x) - x;
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const double from = static_cast<double>(x) + static_cast<double>(unit) * std::fmod(0.6180339887 * i, 1);
    const double to = from + 7.3 * static_cast<double>(unit) * (1 + std::fmod(0.4142135623 * i, 1));
    const Real stored = static_cast<Real>(to) - static_cast<Real>(from);
    worst = std::max(worst, std::abs(static_cast<double>(stored) - (to - from)));
  }
  EXPECT_LE(worst, static_cast<double>(unit));
  EXPECT_GE(worst, 0.9 * static_cast<double>(unit));
}
#endif

TEST(Resolution, ABallMayBeAnywhereAlongAPlane) {
  EXPECT_EQ(unsupported(ball_along_the_floor(1000 * lost(1)), automatic()), "");
}

TEST(Resolution, ForceRunsWhatPrecisionRejects) {
  Options forced = automatic();
  forced.force = true;
  for (const Far& row : far_things)
    EXPECT_EQ(unsupported(row.model(lost(row.units)), forced), "") << row.name;
}

TEST(Resolution, SingleBodyMayBeAnywhere) {
  EXPECT_EQ(unsupported(ball_alone(1000 * lost(1)), automatic()), "");
}

// A joint at the centre of a body has a lever of rounding alone, which is no length that the motion needs.
TEST(Resolution, AJointAtTheCentreOfABodyIsAccepted) {
  for (const Real rounding : {Real(0), Real(1), Real(3)}) {
    const Real x = Real(0.5);
    Model model = pendulum(x);
    model.joints[0].anchor = {0, 0, rounding * epsilon * x};
    model.joints[0].to_anchor = {x, Real(0.1), rounding * epsilon * x};
    EXPECT_EQ(unsupported(model, automatic()), "") << rounding;
  }
}

// Two ends in one place, and no rest length: nothing says how fine the motion will be.
TEST(Resolution, SpringOfZeroLengthIsAccepted) {
  Model model = spring(lost(1));
  model.forces.springs[0].to_anchor = model.motions[0].position;
  EXPECT_EQ(unsupported(model, automatic()), "");
}

#ifndef CYLON_ENGINE_FLOAT
TEST(Resolution, InDoubleTenMillionMetresAreNearAndAHundredBillionKilometresFar) {
  EXPECT_EQ(unsupported(balls(1e7), automatic()), "");
  EXPECT_EQ(unsupported(balls(1e14), automatic()), "");
  EXPECT_EQ(unsupported(balls(1e15), automatic()),
            "body 0 is 1e+15 m from the origin, where double precision knows distances to 0.125 m: more than "
            "a tenth of its half-width, 0.37 m");
}
#else
TEST(Resolution, InFloatTenKilometresAreNearAndTenThousandFar) {
  EXPECT_EQ(unsupported(balls(1e4F), automatic()), "");
  EXPECT_EQ(unsupported(balls(1e7F), automatic()),
            "body 0 is 1e+07 m from the origin, where single precision knows distances to 1 m: more than a "
            "tenth of its half-width, 0.37 m");
}
#endif

// ---- Masses ------------------------------------------------------------------------------------------

Model two_balls(Real ratio) {
  Model model;
  add_ball(model, Real(0.7), {0, 2, 0}, true);
  add_ball(model, Real(0.7) * ratio, {Real(0.1), 4, 0}, true);
  add_floor(model, 0);
  return model;
}

// A heavy body hangs on a light one, which hangs on the world.
Model hanging(Real ratio) {
  Model model;
  add_ball(model, Real(0.7), {half, 0, 0}, false);
  add_ball(model, Real(0.7) * ratio, {2 * half, 0, 0}, false);
  for (Motion& m : model.motions) m.momentum.setZero();
  model.joints.push_back({.body = 0, .anchor = {-half, 0, 0}});
  model.joints.push_back({.body = 1, .anchor = {-half, 0, 0}, .to = 0});
  return model;
}

TEST(Resolution, RejectsOnlyMassRatiosBeyondPrecision) {
  for (const auto& model : {two_balls, hanging}) {
    EXPECT_EQ(unsupported(model(carried), automatic()), "");
    const std::string reason = unsupported(model(crushing), automatic());
    EXPECT_EQ(reason.find("body 1 weighs "), 0u) << reason;
    EXPECT_NE(reason.find("as much as body 0"), std::string::npos) << reason;
  }
}

TEST(Resolution, AnyMassesWithoutContact) {
  Model weightless = two_balls(1000 * crushing);
  weightless.forces.gravity.setZero();
  EXPECT_EQ(unsupported(weightless, automatic()), "");

  Model leaf = hanging(1000 * crushing);  // the light one at the end of the heavy one
  leaf.joints.erase(leaf.joints.begin());
  EXPECT_EQ(unsupported(leaf, automatic()), "");

  Model locked = two_balls(1000 * crushing);
  locked.bodies[1] = make_body(locked.bodies[1].mass, Matrix3::Identity(), true);
  EXPECT_EQ(unsupported(locked, automatic()), "");

  Options stepping = automatic();  // impulses go by the mass of each body alone
  stepping.path = "stepping";
  EXPECT_EQ(unsupported(two_balls(1000 * crushing), stepping), "");
}

TEST(Resolution, ReasonUsesGivenNames) {
  const Names names = [](Thing thing, int i) {
    return (thing == Thing::body ? "stone " : "ground ") + std::to_string(i);
  };
  EXPECT_EQ(unsupported(ball(lost(Real(0.5))), automatic(), names).find("stone 0 is "), 0u);
  EXPECT_EQ(unsupported(floor_far_below(lost(Real(0.5))), automatic(), names).find("ground 0 is "), 0u);
}

}  // namespace
}  // namespace cylon::engine
