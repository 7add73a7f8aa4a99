// Many free bodies in vector form move like single bodies: exactly where nothing is split, else to the order
// of the integrator, with the same bits on any number of threads.
#include "engine/free_bodies.h"

#include "tests/engine/fixtures.h"

#include <random>

namespace cylon::engine {
namespace {

enum class Kind { points, spheres, symmetric_high, symmetric_low, asymmetric };

// General bodies, motions and turns; `spin` [rad/s] in size.
Model free_bodies(Kind kind, std::size_t count, Real spin) {
  std::mt19937 generator(5);
  const auto any = [&] { return static_cast<Real>(generator()) / static_cast<Real>(2147483648.0) - 1; };
  Model model;
  model.forces.gravity = {Real(0.4), Real(-9.81), Real(0.7)};
  for (std::size_t i = 0; i < count; ++i) {
    const Real a = 2 + any(), b = 3 + any() / 2, c = Real(3.9) + any() / 3;
    Matrix3 inertia = general_inertia(a, b, c);
    if (kind == Kind::spheres) inertia = a * Matrix3::Identity();
    if (kind == Kind::symmetric_high) inertia = general_inertia(a, a, c);
    if (kind == Kind::symmetric_low) inertia = general_inertia(a, c, c);
    const Vector3 w =
        kind == Kind::points ? Vector3::Zero() : Vector3(spin * any(), spin * any(), spin * any());
    add_body(model, make_body(Real(1.5) + any(), inertia), {any(), any(), any()}, {any(), any(), any()},
             {any(), any(), any()}, w);
  }
  return model;
}

struct Difference {
  Real position = 0, velocity = 0, turn = 0, spin = 0;
};

Difference difference(const Model& model, const std::vector<Motion>& a, const std::vector<Motion>& b) {
  Difference d;
  for (std::size_t i = 0; i < a.size(); ++i) {
    d.position = std::max(d.position, (a[i].position - b[i].position).norm());
    d.velocity = std::max(d.velocity, (a[i].momentum - b[i].momentum).norm() / model.bodies[i].mass);
    d.turn = std::max(d.turn, 2 * (a[i].orientation.conjugate() * b[i].orientation).vec().norm());
    d.spin = std::max(d.spin, (a[i].angular_momentum - b[i].angular_momentum).norm());
  }
  return d;
}

std::vector<Motion> carried(const Model& model, std::string_view integrator, Time dt, int steps,
                            int threads = 1) {
  FreeBodies bodies(model, *find_integrator(integrator), dt, threads);
  bodies.advance(steps);
  std::vector<Motion> motions;
  bodies.read(motions);
  return motions;
}

// In closed form, by the plan for integrator auto.
std::vector<Motion> exact(const Model& model, Time t) {
  World world(model, {.dt = t});
  world.step();
  EXPECT_EQ(world.plan().path, Path::exact);
  return world.motions();
}

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

class Exactly : public testing::TestWithParam<Kind> {};

TEST_P(Exactly, SmoothSceneIsExactToRounding) {
  // 37 bodies: the last block is not full
  for (const Real spin : {Real(2), Real(60)}) {
    const Model model = free_bodies(GetParam(), 37, spin);
    constexpr int steps = 200;
    constexpr Time dt = 0.01;
    for (const char* integrator : {"velocity-verlet", "stormer-verlet", "bm4", "rkn6"}) {
      const Difference d = difference(model, carried(model, integrator, dt, steps), exact(model, steps * dt));
      // positions reach 25 m, speeds 20 m/s, phases 2 s of 60 rad/s times up to 3 (the ratio of moments) and
      // sqrt 3 (three components); each step rounds a handful of times
      EXPECT_LT(d.position, 4 * steps * epsilon * 25) << integrator;
      EXPECT_LT(d.velocity, 4 * steps * epsilon * 20) << integrator;
      EXPECT_LT(d.turn, 4 * steps * epsilon * (1 + Real(0.01) * 6 * spin)) << integrator;
      EXPECT_EQ(d.spin, 0) << integrator;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Exactly,
                         testing::Values(Kind::points, Kind::spheres, Kind::symmetric_high,
                                         Kind::symmetric_low));

struct Order {
  const char* integrator;
  int order;
  int steps;  // over 2 s
};

class FreeBodiesOrder : public testing::TestWithParam<Order> {};

TEST_P(FreeBodiesOrder, AsymmetricBodiesHaveOrderOfIntegrator) {
  const Model model = free_bodies(Kind::asymmetric, 37, 5);
  const auto end = exact(model, 2);
  const auto error = [&](int steps) {
    return difference(model, carried(model, GetParam().integrator, 2.0 / steps, steps), end).turn;
  };
  const Real coarse = error(GetParam().steps), fine = error(2 * GetParam().steps);
  EXPECT_NEAR(std::log2(coarse / fine), GetParam().order, 0.15);
  EXPECT_GT(coarse, 1e-9);  // negative control: there is an error to see
}

INSTANTIATE_TEST_SUITE_P(Integrators, FreeBodiesOrder,
                         testing::Values(Order{"velocity-verlet", 2, 200}, Order{"bm4", 4, 60},
                                         Order{"bm6", 6, 25}),
                         [](const auto& row) {
                           std::string name = row.param.integrator;
                           std::erase(name, '-');
                           return name;
                         });

TEST(FreeBodies, SymplecticEulerAgreesWithSingleSteps) {
  const Model model = free_bodies(Kind::points, 9, 0);
  constexpr Time dt = 0.02;
  constexpr int steps = 50;
  World world(model, {.integrator = "lie-trotter", .dt = dt});
  for (int i = 0; i < steps; ++i) world.step();
  const Difference d = difference(model, carried(model, "lie-trotter", dt, steps), world.motions());
  EXPECT_LT(d.position, 4 * steps * epsilon * 10);
  EXPECT_LT(d.velocity, 4 * steps * epsilon * 10);
  // and not as the others do
  const Difference other = difference(model, carried(model, "velocity-verlet", dt, steps), world.motions());
  EXPECT_GT(other.position, Real(0.05));  // g h T/2
}

TEST(FreeBodies, SpinsThatNeedReductionOfAnglesConserveEnergyOnAverage) {
  // up to 1.6 rad a step and more
  const Model model = free_bodies(Kind::asymmetric, 16, 400);
  const auto end = carried(model, "velocity-verlet", Time(1) / 240, 1000);
  for (std::size_t i = 0; i < end.size(); ++i) {
    const auto energy = [&](const Motion& m) {
      return m.angular_momentum.dot(
                 inverse_inertia_times(model.bodies[i], m.orientation, m.angular_momentum)) /
             2;
    };
    EXPECT_NEAR(end[i].orientation.norm(), 1, 4 * epsilon);
    EXPECT_EQ((end[i].angular_momentum - model.motions[i].angular_momentum).norm(), 0);
    // between those of the least and the largest moment whatever the step; a wrong turn leaves |L| as it is
    EXPECT_GT(energy(end[i]), 0);
  }
  // finer steps come to the exact motion: large angles are turned right
  const Model one = free_bodies(Kind::asymmetric, 16, 400);
  const Time t = 0.05;
  const Real coarse = difference(one, carried(one, "bm6", t / 128, 128), exact(one, t)).turn;
  EXPECT_LT(coarse, Real(1e-3));
}

TEST(FreeBodies, BitsDoNotDependOnThreadsOrRuns) {
  for (const Kind kind : {Kind::points, Kind::symmetric_high, Kind::asymmetric}) {
    const Model model = free_bodies(kind, 3000, 3);
    const auto run = carried(model, "velocity-verlet", 0.01, 20);
    const auto threads = carried(model, "velocity-verlet", 0.01, 20, 0);
    FreeBodies stepped(model, *find_integrator("velocity-verlet"), 0.01);
    for (int i = 0; i < 20; ++i) stepped.step();
    std::vector<Motion> one_by_one;
    stepped.read(one_by_one);
    EXPECT_TRUE(same_bits(run, threads));
    EXPECT_TRUE(same_bits(run, one_by_one));
  }
}

TEST(FreeBodies, PlanVectorizesOnlyManyBodies) {
  const auto path = [](const Model& model, const char* integrator) {
    return make_plan(model, {.integrator = integrator, .dt = 0.01}).path;
  };
  const Model many = free_bodies(Kind::asymmetric, 65, 3);
  EXPECT_EQ(path(many, "velocity-verlet"), Path::free);
  EXPECT_EQ(path(many, "rk4"), Path::bodies);
  EXPECT_EQ(path(many, "auto"), Path::exact);
  EXPECT_EQ(path(free_bodies(Kind::asymmetric, 64, 3), "velocity-verlet"), Path::bodies);
  Model held = many;
  held.forces.springs.push_back({.body = 3, .stiffness = 2});
  EXPECT_EQ(path(held, "velocity-verlet"), Path::bodies);
  Model locked = many;
  locked.bodies[5].locked = true;
  EXPECT_EQ(path(locked, "velocity-verlet"), Path::bodies);
}

TEST(FreeBodies, HoldsLessThan300BytesABody) {
  const Model model = free_bodies(Kind::asymmetric, 4096, 3);
  const FreeBodies bodies(model, *find_integrator("velocity-verlet"), 0.01);
  EXPECT_LT(bodies.memory() / 4096, 300u);
}

}  // namespace
}  // namespace cylon::engine
