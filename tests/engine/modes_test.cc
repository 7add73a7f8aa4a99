// Normal modes: against closed forms and against integration, and where they do not apply.
#include "tests/engine/fixtures.h"

#include "engine/normal_modes.h"

#include <functional>
#include <numbers>

namespace cylon::engine {
namespace {

void add_point(Model& model, Real mass, const Vector3& position, const Vector3& v, bool locked = false) {
  add_body(model, make_body(mass, Matrix3::Zero(), locked), position, {0, 0, 0}, v, {0, 0, 0});
}

void tie(Model& model, int from, int to, Real stiffness, Real rest_length = 0,
         const Vector3& pin = {0, 0, 0}) {
  model.forces.springs.push_back({.body = from,
                                  .to = to,
                                  .to_anchor = to == fixed_world ? pin : Vector3(0, 0, 0),
                                  .stiffness = stiffness,
                                  .rest_length = rest_length});
}

// Three points, a locked one and a pin, no rest lengths, gravity and two drives: all directions couple to
// all bodies.
Model net() {
  Model m;
  add_point(m, 1.3, {0.4, -0.2, 0.9}, {0.3, 0.8, -0.5});
  add_point(m, 0.7, {-0.9, 0.7, -0.3}, {-0.4, 0.1, 0.6});
  add_point(m, 5, {2, 2, 2}, {0, 0, 0}, true);
  add_point(m, 2.1, {0.1, 1.7, 0.3}, {0.9, -0.6, 0.2});
  tie(m, 0, 1, 9), tie(m, 1, 3, 17), tie(m, 2, 0, 5), tie(m, 3, fixed_world, 23, 0, {-1, 0.5, 0.2});
  m.forces.gravity = {0.3, -9.81, 0.7};
  m.forces.drives.push_back({1, {0.9, 0.4, -1.1}, 2.3});
  m.forces.drives.push_back({3, {-0.7, 1.3, 0.2}, 0});
  return m;
}

// Beads on one line between two pins, stretched: springs with rest lengths, one driven bead.
Model line(int axis) {
  Model m;
  const auto on = [axis](Real s) {
    Vector3 x(Real(0.3), Real(-0.8), Real(1.1));
    return x[axis] = s, x;
  };
  const auto along = [axis](Real s) { return Vector3(s * Vector3::Unit(axis)); };
  add_point(m, 1.3, on(0.9), along(0.2));
  add_point(m, 0.7, on(2.1), along(-0.3));
  add_point(m, 2.1, on(3.05), along(0.1));
  tie(m, 0, fixed_world, 30, 0.8, on(0));
  tie(m, 1, 0, 40, 1.1), tie(m, 1, 2, 50, 0.9);
  tie(m, 2, fixed_world, 60, 0.7, on(4));
  m.forces.gravity = along(-1.5);
  m.forces.drives.push_back({1, along(0.4), 3.3});
  return m;
}

// Nothing holds them: they move off as one.
Model adrift() {
  Model m;
  add_point(m, 1.3, {0.4, -0.2, 0.9}, {0.3, 0.8, -0.5});
  add_point(m, 0.7, {-0.9, 0.7, -0.3}, {-0.4, 0.1, 0.6});
  add_point(m, 2.1, {0.1, 1.7, 0.3}, {0.9, -0.6, 0.2});
  tie(m, 0, 1, 9), tie(m, 1, 2, 17);
  m.forces.gravity = {0.3, -9.81, 0.7};
  return m;
}

struct Network {
  const char* name;
  Model model;
};
void PrintTo(const Network& n, std::ostream* out) { *out << n.name; }

class Modes : public testing::TestWithParam<Network> {};

// rk8 at 1/512 s errs by 1e-14 of the motion in 7 s, and knows nothing of modes.
TEST_P(Modes, AgreeWithIntegration) {
  const Model& model = GetParam().model;
  ASSERT_EQ(make_plan(model, with("auto", 0.1)).path, Path::modes) << normal_modes(model).why_not;
  World exact(model, with("auto", 7.0 / 16));
  World integrated(model, with("rk8", 1.0 / 512));
  for (int k = 1; k <= 16; ++k) {
    exact.step();
    integrated.advance(224);
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      const Motion &a = exact.motions()[i], &b = integrated.motions()[i];
      EXPECT_LT((a.position - b.position).norm(), 1e-12 * (1 + b.position.norm())) << k << ' ' << i;
      EXPECT_LT((a.momentum - b.momentum).norm(), 1e-12 * (1 + b.momentum.norm())) << k << ' ' << i;
    }
  }
}

// A step is no more than a time to look at.
TEST_P(Modes, DoNotDependOnTheStep) {
  World fine(GetParam().model, with("auto", 1.0 / 64)), coarse(GetParam().model, with("auto", 4));
  fine.advance(256);
  coarse.step();
  for (std::size_t i = 0; i < fine.motions().size(); ++i) {
    EXPECT_EQ(fine.motions()[i].position, coarse.motions()[i].position);
    EXPECT_EQ(fine.motions()[i].momentum, coarse.motions()[i].momentum);
  }
}

INSTANTIATE_TEST_SUITE_P(Networks, Modes,
                         testing::Values(Network{"net", net()}, Network{"line along x", line(0)},
                                         Network{"line along y", line(1)}, Network{"line along z", line(2)},
                                         Network{"adrift", adrift()}));

TEST(Modes, KeepInitialStateExactly) {
  const auto stepper_start = [](const Model& model) { return World(model, with("auto", 0.1)).motions(); };
  const Model model = net();
  for (std::size_t i = 0; i < model.motions.size(); ++i)
    EXPECT_EQ(stepper_start(model)[i].position, model.motions[i].position);
}

// Two points on a spring: about the centre of mass, which moves evenly, at w^2 = k (1/a + 1/b).
TEST(Modes, OfTwoPointsAreTheTextbooks) {
  constexpr double a = 1.3, b = 0.7, k = 9;
  const Vector3 x(0.4, -0.2, 0.9), y(-0.9, 0.7, -0.3), u(0.3, 0.8, -0.5), v(-0.4, 0.1, 0.6);
  Model m;
  add_point(m, a, x, u), add_point(m, b, y, v), tie(m, 0, 1, k);
  const double t = 123.4, w = std::sqrt(k * (1 / a + 1 / b));
  World world(m, with("auto", t));
  world.step();
  const Vector3 d = (y - x) * std::cos(w * t) + (v - u) * (std::sin(w * t) / w);
  const Vector3 centre = (a * (x + u * t) + b * (y + v * t)) / (a + b);
  // 123 s are 525 rad: a rounding of w is 6e-14 m
  EXPECT_LT((world.motions()[0].position - (centre - b / (a + b) * d)).norm(), 5e-13);
  EXPECT_LT((world.motions()[1].position - (centre + a / (a + b) * d)).norm(), 5e-13);
  const Vector3 whole = world.motions()[0].momentum + world.motions()[1].momentum;
  EXPECT_LT((whole - a * u - b * v).norm(), 1e-14);
}

// At w = W the amplitude grows without end:  x = f t sin(w t)/(2 m w).
TEST(Modes, GrowAtResonance) {
  constexpr double mass = 1.3, w = 2.5;
  for (const double beside : {0., 1e-12, 1e-7}) {
    Model m;
    add_point(m, mass, {0, 0, 0}, {0, 0, 0});
    tie(m, 0, fixed_world, mass * w * w);
    const Vector3 f(0.9, 0.4, -1.1);
    m.forces.drives.push_back({0, f, w * (1 + beside)});
    const double t = 40;
    World world(m, with("auto", t));
    world.step();
    const Vector3 x = f * (t * std::sin(w * t) / (2 * mass * w));
    // beside resonance by e: the drive is out of step by e w t
    EXPECT_LT((world.motions()[0].position - x).norm(), (1e-13 + beside * w * t) * t) << beside;
  }
}

// A light point between two of a million times its mass: slow modes keep their digits beside the fast one,
// w^2 = 2 k/m + k/M, k/M, by symmetry about the light one.
TEST(Modes, SlowModesKeepPrecision) {
  constexpr double light = 1e-6, heavy = 1, k = 2;
  Model m;
  add_point(m, heavy, {-1, 0.2, 0}, {0, 0, 0});
  add_point(m, light, {0, 0.2, 0}, {0, 0, 0});
  add_point(m, heavy, {1, 0.2, 0}, {0, 0, 0});
  tie(m, 0, 1, k), tie(m, 1, 2, k);
  const double w = std::sqrt(k / heavy), t = 300;
  World world(m, with("auto", t));
  world.step();
  EXPECT_NEAR(world.motions()[2].position.x(), std::cos(w * t), 1e-12);
  EXPECT_NEAR(world.motions()[0].position.x(), -std::cos(w * t), 1e-12);
  EXPECT_NEAR(world.motions()[1].position.x(), 0, 1e-12);
}

struct Refused {
  const char* name;
  std::function<void(Model&)> change;
  const char* why;
};

// What is not linear is integrated.
TEST(Modes, ApplyToLinearForcesOnly) {
  const Refused table[] = {
      {"leaves the line", [](Model& m) { m.motions[1].momentum.y() = 1e-9; }, "rotate"},
      {"beside the line", [](Model& m) { m.motions[1].position.z() += 1e-9; }, "rotate"},
      {"pulled off the line", [](Model& m) { m.forces.gravity.y() = -1e-9; }, "rotate"},
      {"driven off the line", [](Model& m) { m.forces.drives[0].force.z() = 1e-9; }, "rotate"},
      {"passes through its neighbour", [](Model& m) { m.motions[1].momentum.x() = -9; }, "zero length"},
      {"drawn to the pin", [](Model& m) { m.forces.gravity.x() = -60; }, "zero length"},
      {"driven at resonance",
       [](Model& m) {
         const ModeGroup group = normal_modes(m).groups.at(0);
         m.forces.drives[0].frequency = group.frequencies[1];
       },
       "grow"},
      {"in one place", [](Model& m) { m.motions[0].position.x() = 0; }, "zero length"},
      {"damped", [](Model& m) { m.forces.springs[0].damping = 0.1; }, "damped"},
      {"attracted",
       [](Model& m) {
         m.forces.attractions.push_back({0, 1, 1});
       },
       "attract"},
  };
  for (const Refused& r : table) {
    Model m = line(0);
    r.change(m);
    EXPECT_NE(normal_modes(m).why_not.find(r.why), std::string::npos)
        << r.name << ": " << normal_modes(m).why_not;
    EXPECT_TRUE(normal_modes(m).groups.empty()) << r.name;
    EXPECT_NE(make_plan(m, with("auto", 0.1)).path, Path::modes) << r.name;
  }
  Model crowd;
  for (std::size_t i = 0; i <= most_tied; ++i) {
    add_point(crowd, 1, {Real(0.1) * static_cast<Real>(i), 0, 0}, {0, 0, 0});
    if (i > 0) tie(crowd, static_cast<int>(i), static_cast<int>(i) - 1, 1);
  }
  EXPECT_NE(normal_modes(crowd).why_not.find("more than 64"), std::string::npos);
  crowd.forces.springs.pop_back();
  EXPECT_EQ(normal_modes(crowd).groups.size(), 2u);
}

// One spring short of passing through: just below the speed that brings the bead to the pin it is linear.
TEST(Modes, LineEndsWherePositionsMeet) {
  constexpr double mass = 1.3, k = 30, rest = 0.8;
  const double w = std::sqrt(k / mass), limit = rest * w;  // from rest length: x = rest + v/w sin(w t)
  for (const double share : {0.999999, 1.000001}) {
    Model m;
    add_point(m, mass, {rest, 0, 0}, {share * limit, 0, 0});
    tie(m, 0, fixed_world, k, rest);
    EXPECT_EQ(normal_modes(m).why_not.empty(), share < 1) << share;
    World world(m, with("auto", 1.7));
    world.step();
    if (share < 1) {
      EXPECT_NEAR(world.motions()[0].position.x(), rest + share * rest * std::sin(w * 1.7), 1e-13);
    }
  }
}

}  // namespace
}  // namespace cylon::engine
