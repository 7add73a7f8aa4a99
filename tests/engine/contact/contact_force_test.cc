// Forces of persistent contacts: statics in closed form, margins, and rates of contact points by
// differences.
#include "tests/engine/contact/contact_fixtures.h"

#include "engine/contact/candidate.h"
#include "engine/contact/contact_force.h"

namespace cylon::engine {
namespace {

ContactForces forces_of(const Model& model) {
  Bodies system(model);
  const std::vector<Real> y = system.initial();
  const Motion* motion = system.motions(y.data());
  std::vector<TouchPoint> touches;
  for (const Candidate& c : find_candidates(system.model())) {
    const TouchPoint t = touch_at(c, system.model(), motion);
    if (t.gap < 1e-12) touches.push_back(t);
  }
  system.load(0, y.data());
  return find_contact_forces(
      touches, {},
      {system.model().bodies, motion, system.kinematics().data(), system.loads().data(), system.count()},
      std::vector<Real>(touches.size(), 1e-12));
}

Model box_on_slope(Real theta, Real mu, const Vector3& half, Real heading,
                   const Vector3& v = Vector3::Zero()) {
  const Quaternion turn = exponential(Vector3(0, heading, 0)) * exponential(Vector3(0, 0, -theta));
  const Vector3 n = turn * Vector3::UnitY();
  Model model = with_plane(n, 0, {0, mu});
  add_box(model, 1, half, half.y() * n, turn * exponential(Vector3(0, 0.3, 0)), turn * v, Vector3::Zero());
  return model;
}

Vector3 total(const ContactForces& s) {
  Vector3 sum = Vector3::Zero();
  for (const ContactForce& p : s.points) sum += p.force;
  return sum;
}

// tan(th) against mu, to a part in 1e9 on both sides, in any direction: the cone is round.
TEST(ContactForce, StickEndsAtFrictionAngle) {
  const Real mu = 0.47;
  for (const Real heading : {0.0, 0.4, 0.9, 1.7, 2.6}) {
    for (const Real off : {-1e-9, 1e-9}) {
      const Real theta = std::atan(mu * (1 + off));
      const ContactForces s = forces_of(box_on_slope(theta, mu, {0.5, 0.1, 0.4}, heading));
      ASSERT_EQ(s.points.size(), 4u);
      EXPECT_TRUE(s.exact);
      for (const ContactForce& p : s.points) {
        EXPECT_EQ(p.holding.grip, off < 0 ? Grip::sticks : Grip::slides) << heading << " " << off;
        EXPECT_GT(p.normal, 0);
      }
      if (off < 0) {
        EXPECT_LT((total(s) - Vector3(0, 9.81, 0)).norm(), 1e-12);
      }
    }
  }
}

TEST(ContactForce, WithoutFrictionNothingSticks) {
  const ContactForces s = forces_of(box_on_slope(0.01, 0, {0.5, 0.1, 0.4}, 0.7));
  for (const ContactForce& p : s.points) EXPECT_EQ(p.holding.grip, Grip::slides);
  EXPECT_NEAR(total(s).norm(), 9.81 * std::cos(0.01), 1e-12);
}

TEST(ContactForce, FrictionOpposesSlip) {
  for (const Real heading : {0.0, 0.8, 2.1}) {
    const Model model = box_on_slope(0.2, 0.3, {0.5, 0.1, 0.4}, heading, {0.3, 0, -0.4});
    const ContactForces s = forces_of(model);
    const Vector3 n = model.planes[0].normal, v = velocity(model.bodies[0], model.motions[0]);
    const Vector3 f = total(s);
    EXPECT_NEAR(f.dot(n), 9.81 * std::cos(0.2), 1e-12);
    EXPECT_LT((f - f.dot(n) * n + 0.3 * f.dot(n) * v.normalized()).norm(), 1e-12);
  }
}

// A high box on a slope steeper than its base: two of its four points let go, and it turns.
TEST(ContactForce, HighBoxTips) {
  const Quaternion turn = exponential(Vector3(0, 0, -0.5));
  Model model = with_plane(turn * Vector3::UnitY(), 0, {0, 2});
  add_box(model, 1, {0.1, 0.5, 0.2}, turn * Vector3(0, 0.5, 0), turn, Vector3::Zero(), Vector3::Zero());
  const ContactForces s = forces_of(model);
  int parts = 0;
  for (const ContactForce& p : s.points) {
    parts += p.holding.grip == Grip::parts ? 1 : 0;
    if (p.holding.grip == Grip::parts) {
      EXPECT_GT(p.parting, 0.01);
    }
  }
  EXPECT_EQ(parts, 2);
  EXPECT_TRUE(s.exact);
}

// A ladder between a floor and a wall that sticks at both ends: how its two ends squeeze each other is not determined.  What
// lies inside the cones at all is not left at their edge, where whatever moves would end it at once.
TEST(ContactForce, SharesLieInsideTheCones) {
  int sought = 0;
  for (const Real mu : {0.3, 0.45, 0.7, 1.0}) {
    for (Real lean = 0.05; lean < 1.5; lean += 0.05) {  // of the ladder from upright
      constexpr Real half = 1, radius = 0.05;
      const Vector3 along(-std::sin(lean), std::cos(lean), 0);
      Model model = with_plane(Vector3::UnitY(), 0, {0, mu});
      model.planes.push_back({Vector3::UnitX(), 0});
      model.plane_surfaces.push_back(1);
      const Body body = make_body(1.3, Vector3(0.4, 0.01, 0.4).asDiagonal());
      const Vector3 at(radius + half * std::sin(lean), radius + half * std::cos(lean), 0);
      add(model, body, Capsule{radius, half},
          make_motion(body, at, exponential(Vector3(0, 0, lean)), Vector3::Zero(), Vector3::Zero()));
      const ContactForces s = forces_of(model);
      ASSERT_EQ(s.points.size(), 2u) << lean;
      EXPECT_TRUE(s.exact) << mu << ' ' << lean;
      if (s.points[0].holding.grip != Grip::sticks || s.points[1].holding.grip != Grip::sticks) continue;
      EXPECT_LT((total(s) - Vector3(0, 1.3 * 9.81, 0)).norm(), 1e-11);
      const Vector3 squeeze = (along + radius / (2 * half) * Vector3(-1, 1, 0)).normalized();
      const bool floor_first = s.points[0].force.y() > s.points[1].force.y();
      const Vector3 &floor = s.points[floor_first ? 0 : 1].force, &wall = s.points[floor_first ? 1 : 0].force;
      const auto part = [&](Real t) {
        const Vector3 f = floor + t * squeeze, w = wall - t * squeeze;
        const Real least = std::min(f.y(), w.x());
        return least > 0 ? std::max(std::abs(f.x()) / f.y(), std::abs(w.y()) / w.x()) / mu : Real(1e9);
      };
      Real best = 1e9;
      for (Real t = -30; t < 30; t += 0.01) best = std::min(best, part(t));
      const bool even = s.points[0].holding.share.isZero(0);
      EXPECT_LE(part(0), even ? Real(1) : std::max(best + Real(2e-3), Real(0.9)))
          << mu << ' ' << lean << ' ' << best;
      ++sought;
    }
  }
  EXPECT_GT(sought, 40);
}

// normal', path and curvature of round touches against central differences of touches on a free motion.
TEST(ContactForce, RatesOfContactPoints) {
  const Shape shapes[] = {Sphere{0.4},          Box{{0.5, 0.3, 0.6}}, Box{{0.5, 0.3, 0.6}},
                          Box{{0.5, 0.3, 0.6}}, Capsule{0.2, 0.5},    Capsule{0.2, 0.5}};
  const Vector3 places[] = {{0.4, 0.5, -0.3}, {0.1, 0.6, 0.2}, {0.8, 0.55, 0.2},
                            {0.8, 0.55, 0.9}, {0.5, 0.1, 0.1}, {0.3, 0.9, 0.1}};
  for (std::size_t i = 0; i < std::size(shapes); ++i) {
    Model model = without_plane({0, 0});
    const Body body = make_body(1, Matrix3::Identity());
    add(model, body, Sphere{0.25},
        make_motion(body, places[i], Quaternion::Identity(), {0.3, -0.2, 0.5}, {1, -2, 0.5}));
    add(model, body, shapes[i],
        make_motion(body, Vector3::Zero(), Quaternion::Identity(), {-0.1, 0.4, 0.2}, {0.7, 0.6, -0.9}));
    const Candidate c = find_candidates(model)[0];
    const auto moved = [&](Real t) {  // spheres' inertias: constant spin
      std::vector<Motion> m = model.motions;
      for (Motion& one : m) {
        one.position += t * one.momentum;
        one.orientation = turned(one.orientation, t * one.angular_momentum);
      }
      return touch_at(c, model, m.data());
    };
    const Real h = 1e-4;
    const TouchPoint t = moved(0), plus = moved(h), minus = moved(-h);
    const Vector3 normal_rate = (plus.normal - minus.normal) / (2 * h);
    EXPECT_LT((t.turning - normal_rate).norm(), 1e-7) << i;
    EXPECT_NEAR(gap_rate(t, model.bodies, model.motions.data()), (plus.gap - minus.gap) / (2 * h), 1e-7) << i;
    EXPECT_NEAR(t.curvature, (plus.gap - 2 * t.gap + minus.gap) / (h * h), 1e-6) << i;
  }
}

}  // namespace
}  // namespace cylon::engine
