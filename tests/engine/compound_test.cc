// Compound bodies: the parallel-axis theorem with rotated parts, and the quantities that merging conserves.
#include "engine/compound.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <vector>

namespace cylon::engine {
namespace {

std::vector<CompoundPart> three_parts() {
  const auto part = [](Real mass, const Vector3& moments, const Vector3& p, const Vector3& turn,
                       const Vector3& v, const Vector3& w) {
    const Body body = make_body(mass, moments.asDiagonal());
    return CompoundPart{body, make_motion(body, p, exponential(turn), v, w)};
  };
  return {
      part(1.3, {0.5, 0.7, 1.0}, {0.4, -0.2, 0.9}, {0.5, 1.1, -0.6}, {0.3, 0.8, -0.5}, {1.2, -0.7, 0.9}),
      part(0.8, {0.2, 0.35, 0.4}, {-0.9, 0.7, -0.3}, {-1.3, 0.2, 0.8}, {-0.4, 0.1, 0.6}, {-0.8, 1.5, 0.4}),
      part(2.1, {0.9, 0.6, 0.8}, {0.2, 1.7, 0.1}, {0.1, 0.4, 2.0}, {1.4, -0.3, 0.2}, {0.3, 0.2, -1.1})};
}

Vector3 angular_momentum_about_origin(const Motion& m) {
  return m.position.cross(m.momentum) + m.angular_momentum;
}

// Errata 59, 60: the centre of mass is the mean weighted by mass, spins and arms both count.
TEST(Compound, MergingKeepsMassMomentumAndAngularMomentum) {
  const std::vector<CompoundPart> parts = three_parts();
  const CompoundPart whole = merge(parts);
  Real mass = 0;
  Vector3 k = Vector3::Zero(), l = Vector3::Zero(), p = Vector3::Zero();
  for (const CompoundPart& part : parts) {
    mass += part.body.mass;
    p += part.body.mass * part.motion.position;
    k += part.motion.momentum;
    l += angular_momentum_about_origin(part.motion);
  }
  EXPECT_NEAR(whole.body.mass, mass, 1e-15);
  EXPECT_LT((whole.motion.position - p / mass).norm(), 1e-15);
  EXPECT_LT((whole.motion.momentum - k).norm(), 1e-15);
  EXPECT_LT((angular_momentum_about_origin(whole.motion) - l).norm(), 4e-15);
  EXPECT_NEAR(whole.body.inverse_mass * mass, 1, 1e-15);  // errata 61
}

// A box cut in eight smaller boxes and put together again; the pieces' own axes lie anyhow (errata 15).
TEST(Compound, PartsOfBoxGiveInertiaOfBox) {
  const Vector3 half(0.3, 0.5, 0.9);
  const Real mass = 2.4;
  const auto moments = [](Real m, const Vector3& h) {
    return Vector3(m / 3 * (h.y() * h.y() + h.z() * h.z()), m / 3 * (h.x() * h.x() + h.z() * h.z()),
                   m / 3 * (h.x() * h.x() + h.y() * h.y()));
  };
  const Quaternion turn = exponential({0.4, -1.1, 0.7});
  const std::array<Vector3, 2> quarter_turns = {Vector3(0, 0, 0),
                                                Vector3(0, std::numbers::pi_v<Real> / 2, 0)};
  std::vector<CompoundPart> parts;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 place((corner & 1) ? 0.15 : -0.15, (corner & 2) ? 0.25 : -0.25,
                        (corner & 4) ? 0.45 : -0.45);
    // The same piece described in axes turned by a quarter: its x and z moments change places.
    const Quaternion own = exponential(quarter_turns[static_cast<std::size_t>(corner % 2)]);
    Vector3 piece = moments(mass / 8, half / 2);
    if (corner % 2) std::swap(piece.x(), piece.z());
    const Body body = make_body(mass / 8, piece.asDiagonal());
    parts.push_back({body, make_motion(body, Vector3(1, 2, 3) + turn * place, turn * own, Vector3::Zero(),
                                       Vector3::Zero())});
  }
  const CompoundPart whole = merge(parts);
  EXPECT_LT((whole.body.inertia - Matrix3(moments(mass, half).asDiagonal())).norm(), 1e-14);
  EXPECT_LT((whole.motion.position - Vector3(1, 2, 3)).norm(), 1e-15);
}

// Parts that move as one rigid body lose nothing; any others do.
TEST(Compound, ConservesEnergyIfPartsMoveTogether) {
  const auto energy = [](const CompoundPart& p) {
    return velocity(p.body, p.motion).dot(p.motion.momentum) / 2 +
           angular_velocity(p.body, p.motion).dot(p.motion.angular_momentum) / 2;
  };
  std::vector<CompoundPart> parts = three_parts();
  Real before = 0;
  for (const CompoundPart& part : parts) before += energy(part);
  EXPECT_LT(energy(merge(parts)), 0.9 * before);

  const Vector3 w(0.3, -0.8, 0.5), v(0.2, 0.1, -0.4), origin(0.3, 0.2, 0.1);
  before = 0;
  for (CompoundPart& part : parts) {
    const Vector3 p = part.motion.position;
    part.motion = make_motion(part.body, p, part.motion.orientation, v + w.cross(p - origin), w);
    before += energy(part);
  }
  const CompoundPart whole = merge(parts);
  EXPECT_NEAR(energy(whole), before, 1e-14 * before);
  EXPECT_LT((angular_velocity(whole.body, whole.motion) - w).norm(), 1e-14);
}

TEST(Compound, IsLockedIfOnePartIs) {
  std::vector<CompoundPart> parts = three_parts();
  parts[1].body = make_body(parts[1].body.mass, parts[1].body.inertia, true);
  EXPECT_TRUE(merge(parts).body.locked);
}

}  // namespace
}  // namespace cylon::engine
