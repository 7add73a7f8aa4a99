// A fast ball in a corner meets the planes in the order of time. They were taken in the order of the scene,
// and on paths that went back to before the ball had turned: in a quarter of all crooked corners it was
// struck by a plane that it never came to, or missed one, and left with up to 1.2 of its speed to the wrong
// side.
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <random>

namespace cylon::engine {
namespace {

constexpr Time dt = 1. / 60;
constexpr Real radius = Real(0.5);

struct Flight {
  Vector3 position, velocity;
  int hits = 0;
};

// One reflection after another, by the nearest plane ahead.
Flight reflected(const std::vector<Plane>& planes, Real restitution, Flight f, Real time) {
  for (;;) {
    Real first = time;
    const Plane* next = nullptr;
    for (const Plane& plane : planes) {
      const Real toward = -plane.normal.dot(f.velocity);
      if (toward <= 1e-9 * f.velocity.norm()) continue;
      const Real t = std::max((plane.normal.dot(f.position) - plane.offset - radius) / toward, Real(0));
      if (t < first) first = t, next = &plane;
    }
    f.position += first * f.velocity, time -= first;
    if (!next) return f;
    f.velocity -= (1 + restitution) * next->normal.dot(f.velocity) * next->normal;
    ++f.hits;
  }
}

class PileCorner : public testing::TestWithParam<Real> {};
class PileCrookedCorner : public PileCorner {};

void expect_reflections(const std::vector<Vector3>& normals, Real restitution, const Vector3& position,
                        const Vector3& velocity) {
  Model model = pile_model(restitution, 0, false);
  model.forces.gravity.setZero();
  for (const Vector3& n : normals) model.planes.push_back({n, 0}), model.plane_surfaces.push_back(0);
  add_ball(model, 1, radius, position, velocity);
  constexpr int steps = 2;
  const Flight want =
      reflected(model.planes, restitution, {position, velocity}, static_cast<Real>(steps * dt));
  const auto pile = make_pile(model, dt);
  std::vector<Motion> now;
  int hits = 0;
  for (int k = 0; k < steps; ++k) pile->step(), hits += static_cast<int>(pile->impacts().size());
  pile->read(now);
  // a path of some metres, broken a few times
  EXPECT_LT((now[0].momentum - want.velocity).norm(), 1e4 * eps * velocity.norm());
  EXPECT_LT((now[0].position - want.position).norm(), 1e5 * eps);
  EXPECT_EQ(hits, want.hits);
}

TEST_P(PileCorner, ReflectsWhereThePlanesAreAtRightAngles) {
  for (const Real speed : {Real(20), Real(73), Real(200)})
    for (const std::size_t planes : {std::size_t(1), std::size_t(2), std::size_t(3)}) {
      const std::vector<Vector3> all{Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
      expect_reflections({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(planes)}, GetParam(),
                         Vector3(Real(0.61), Real(0.83), Real(0.55)),
                         speed * Vector3(Real(-0.5), Real(-0.7), Real(-0.4)).normalized());
    }
}

TEST_P(PileCrookedCorner, ReflectsInTheOrderOfTime) {
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return static_cast<Real>(low + (high - low) * static_cast<double>(random()) / 4294967296.);
  };
  for (int trial = 0; trial < 600; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<Vector3> normals;
    for (int k = 0; k < 2 + trial % 2; ++k)
      normals.push_back(Vector3(between(-1, 1), Real(1.2), between(-1, 1)).normalized());
    Matrix3 rows;
    for (std::size_t k = 0; k < 3; ++k)
      rows.row(static_cast<Eigen::Index>(k)) =
          (k < normals.size() ? normals[k] : Vector3(normals[0].cross(normals[1]).normalized())).transpose();
    Vector3 apart;
    for (int k = 0; k < 3; ++k) apart[k] = radius + between(0.02, 0.3);
    const Vector3 way = Vector3(between(-1, 1), -1, between(-1, 1)).normalized();
    const Real speed = between(20, 200);
    if (std::abs(rows.determinant()) < Real(0.05)) continue;  // planes next to parallel: far from the corner
    expect_reflections(normals, GetParam(), rows.inverse() * apart, speed * way);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PileCorner, testing::Values(Real(0), Real(0.5), Real(1)));
// Without restitution it slides on along the first plane.
INSTANTIATE_TEST_SUITE_P(All, PileCrookedCorner, testing::Values(Real(0.5), Real(1)));

}  // namespace
}  // namespace cylon::engine
