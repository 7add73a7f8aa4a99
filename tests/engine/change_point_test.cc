// Mechanisms of bars that lie in one line for an instant: conditions of joints say the same there.
#include "tests/engine/fixtures.h"
#include "tests/engine/joint_types.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cylon::engine {
namespace {

const Quaternion tilt(exponential({0.4, -0.9, 0.6}));  // of the plane of the mechanism
const Vector3 axis = tilt * Vector3::UnitZ();
constexpr Real length = 0.7, span = 0.9;

Vector3 along(Real angle) { return tilt * Vector3(std::sin(angle), -std::cos(angle), 0); }

void hinge(Model& model, int body, int to, const Vector3& point) {
  const auto from = [&](int i) -> Vector3 {
    return i == fixed_world ? point : Vector3(point - model.motions[static_cast<std::size_t>(i)].position);
  };
  Joint joint{
      .type = joint_types::hinge, .body = body, .anchor = from(body), .to = to, .to_anchor = from(to)};
  joint.axis = joint.to_axis = axis;
  model.joints.push_back(joint);
}

// Cranks of one length at `angle` from hanging, beside one another, and a bar from the tip of each to that of the next:
// with s of a crank's centre from its hinge,
//   sum(A + m s^2) + sum(m L^2) = I,   sum(m s) + sum(m L) = m l   of the pendulum that moves as the cranks do.
struct Parallelograms {
  Model model;
  Real inertia = 0, couple = 0;
};

Parallelograms parallelograms(int bays, Real angle, Real rate) {
  Parallelograms all;
  all.model.forces.gravity = tilt * Vector3(1.3, -9.7, 0.8);
  const auto hang = [&](int k) -> Vector3 { return tilt * Vector3(span * static_cast<Real>(k), 0.1, -0.2); };
  for (int k = 0; k <= bays; ++k) {
    const Real mass = Real(0.8) + Real(0.5) * static_cast<Real>(k),
               s = Real(0.3) + Real(0.07) * static_cast<Real>(k);
    const Body crank = make_body(mass, general_inertia(0.02, 0.03, 0.035));
    add_body(all.model, crank, hang(k) + s * along(angle), Vector3::Zero(),
             rate * s * axis.cross(along(angle)), rate * axis);
    all.inertia += axis.dot(general_inertia(0.02, 0.03, 0.035) * axis) + mass * s * s;
    all.couple += mass * s;
  }
  for (int k = 0; k < bays; ++k) {
    const Real mass = Real(0.6) + Real(0.4) * static_cast<Real>(k);
    add_body(all.model, make_body(mass, general_inertia(0.03, 0.05, 0.04)),
             hang(k) + length * along(angle) + tilt * Vector3(span / 3, 0.05, 0), Vector3::Zero(),
             rate * length * axis.cross(along(angle)), Vector3::Zero());
    all.inertia += mass * length * length;
    all.couple += mass * length;
  }
  for (int k = 0; k <= bays; ++k) hinge(all.model, k, fixed_world, hang(k));
  for (int k = 0; k < bays; ++k)
    for (const int crank : {k, k + 1})
      hinge(all.model, bays + 1 + k, crank, hang(crank) + length * along(angle));
  return all;
}

// The pendulum with that inertia and couple, its centre 0.2 m from its hinge.
Model pendulum(const Parallelograms& all, Real angle, Real rate) {
  Model model;
  model.forces.gravity = all.model.forces.gravity;
  const Real l = 0.2, mass = all.couple / l, own = all.inertia - mass * l * l;
  EXPECT_GT(own, 0);
  add_body(model, make_body(mass, Vector3::Constant(own).asDiagonal()), l * along(angle), Vector3::Zero(),
           rate * l * axis.cross(along(angle)), rate * axis);
  hinge(model, 0, fixed_world, Vector3::Zero());
  return model;
}

// Steps shortened until they met the tolerance, and ended where the bars lie in line: states were NaN from there on.  The cranks
// swing below, turn over and over, and swing through the places in line.
TEST(ChangePoint, ParallelogramsMoveAsAPendulum) {
  struct Start {
    Real angle, rate;
    int least_in_line;  // so often are all bars in one line
  };
  for (const int bays : {1, 2, 3})
    for (const Start start : {Start{1.1, 2.5, 0}, Start{0.3, 9, 4}, Start{-1.9, 0, 4}}) {
      const Parallelograms all = parallelograms(bays, start.angle, start.rate);
      World mechanism(all.model, with("auto", 0.01)),
          single(pendulum(all, start.angle, start.rate), with("auto", 0.01));
      const auto turned = [](const World& world) { return world.motions()[0].orientation; };
      int in_line = 0;
      Real off = 0, open = 0, before = 0;
      for (int i = 0; i < 400; ++i) {
        mechanism.step(), single.step();
        const Real now = angle(turned(mechanism), turned(single));
        ASSERT_TRUE(std::isfinite(now)) << bays << ' ' << start.angle << ' ' << i;
        off = std::max(off, now);
        for (const Joint& joint : all.model.joints)
          open = std::max(open, joint_gap(mechanism.motions(), joint));
        const Real height = (turned(single) * along(start.angle)).dot(along(0));  // 0: all bars in one line
        in_line += before * height < 0;
        before = height;
      }
      EXPECT_GE(in_line, start.least_in_line);
      EXPECT_EQ(in_line == 0, start.least_in_line == 0) << in_line;
      // What steps over the place leave of rounding: 4e-9 at most was measured.
      EXPECT_LT(off, 1e-8) << bays << ' ' << start.angle;
      EXPECT_LT(open, 1e-12) << bays << ' ' << start.angle;
      EXPECT_LT(mechanism.operations(), 1'000'000) << bays << ' ' << start.angle;
      EXPECT_TRUE(off < 1e-9 || !mechanism.remarks().empty()) << "what is not kept is said";
    }
}

}  // namespace
}  // namespace cylon::engine
