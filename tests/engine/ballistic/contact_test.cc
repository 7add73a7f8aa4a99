// Single contacts: grazing, several at one instant, rest, rolling, points, locked spheres; and what the
// stepper hands over because it does not know how it goes on.
#include "tests/engine/ballistic/ballistic_fixture.h"

#include "engine/rotation.h"

namespace cylon::engine::ballistic_test {
namespace {

constexpr Real rounding = 64 * ulp;  // some ten operations per event, a few events
const Vector3 down(0, Real(-9.81), 0);

// Two spheres of reach R pass at an impact parameter just below and just above R.  The approach speed of a
// grazing hit is v sqrt(1 - (b/R)^2), which amplifies the rounding of b/R: hence the square root of it.
TEST(BallisticContact, GrazingHitsAndMisses) {
  const Quaternion turn = exponential({Real(0.3), Real(0.9), Real(-0.5)});
  const Real reach = Real(0.8), speed = 3;
  for (const Real depth : {Real(1e-1), Real(1e-2), Real(1e-4), std::sqrt(ulp), 4096 * ulp}) {
    for (const int side : {-1, 1}) {
      Model model = spheres_of({1, 0});
      const Real b = reach * (1 + static_cast<Real>(side) * depth);
      add_sphere(model, 1, Real(0.3), turn * Vector3(-4, b, 0), turn * Vector3(speed, 0, 0));
      add_sphere(model, 2, Real(0.5), Vector3::Zero(), Vector3::Zero());
      const Outcome end = run(model, 0.5, 6);
      ASSERT_EQ(end.impacts.size(), side < 0 ? 1u : 0u) << depth;
      if (side > 0) continue;
      const Real angle = std::sqrt(depth * (2 - depth));
      EXPECT_NEAR(end.impacts[0].approach, speed * angle, speed * (rounding / angle)) << depth;
      EXPECT_NEAR(end.impacts[0].time, (4 - reach * angle) / speed, rounding / angle) << depth;
      EXPECT_LE(std::abs(energy(model, end.motions) - energy(model, model.motions)), 10 * rounding);
    }
  }
}

// One sphere hits two that touch, symmetrically (m = 1, e = 1): all at once gives the symmetric answer
//   J each = 2 v cos / (1/m + 2 cos^2/m),  cos = sqrt 3/2;   v0' = v (1 - 4 cos^2 / (1 + 2 cos^2)) = -v/5
// one after another does not; both keep momentum and energy.
TEST(BallisticContact, SimultaneousImpactOfThreeSpheres) {
  const Quaternion turn = exponential({Real(0.2), Real(-0.6), Real(1.1)});
  const Real cosine = std::sqrt(Real(3)) / 2, v = Real(1.7);
  Vector3 left, right;
  for (const Impacts impacts : {Impacts::simultaneous, Impacts::sequential}) {
    Model model = spheres_of({1, 0});
    model.impacts = impacts;
    add_sphere(model, 1, Real(0.5), turn * Vector3(Real(-0.1) - cosine, 0, 0), turn * Vector3(v, 0, 0));
    add_sphere(model, 1, Real(0.5), turn * Vector3(0, Real(0.5), 0), Vector3::Zero());
    add_sphere(model, 1, Real(0.5), turn * Vector3(0, Real(-0.5), 0), Vector3::Zero());
    const Outcome end = run(model, 0.5, 2);
    EXPECT_LE((momentum(end.motions) - momentum(model.motions)).norm(), rounding);
    EXPECT_NEAR(energy(model, end.motions), energy(model, model.motions), rounding);
    left = turn.conjugate() * velocity_of(model, end, 1);
    right = turn.conjugate() * velocity_of(model, end, 2);
    const Vector3 first = turn.conjugate() * velocity_of(model, end, 0);
    if (impacts == Impacts::simultaneous) {
      EXPECT_LE((first - Vector3(-v / 5, 0, 0)).norm(), 10 * rounding);
      EXPECT_LE((left - Vector3(right.x(), -right.y(), right.z())).norm(), 10 * rounding);
    } else {
      EXPECT_GT(std::abs(left.norm() - right.norm()), Real(0.1));
    }
  }
}

// Newton's cradle all at once: the complementarity problem of a chain, solved here by elimination.  With one
// ball in, J_1 = 2 (n-1)/n and the rest linear: v = (-1 + 2/n, 2/n, ..., 2/n).
TEST(BallisticContact, SimultaneousImpactsOfCradle) {
  Model model = spheres_of({1, 0});
  model.impacts = Impacts::simultaneous;
  const Vector3 line(Real(0.48), Real(-0.6), Real(0.64));
  const int n = 5;
  for (int i = 0; i < n; ++i)
    add_sphere(model, 1, Real(0.5), static_cast<Real>(i) * line, i == 0 ? line : Vector3(Vector3::Zero()));
  const Outcome end = run(model, 0.25, 2);
  for (int i = 0; i < n; ++i) {
    const Real expected = Real(2) / n - (i == 0 ? 1 : 0);
    EXPECT_LE((velocity_of(model, end, static_cast<std::size_t>(i)) - expected * line).norm(), 10 * rounding)
        << i;
  }
}

// A corner takes back both components, in either manner.
TEST(BallisticContact, CornerReflectsSphere) {
  for (const Impacts impacts : {Impacts::sequential, Impacts::simultaneous}) {
    Model model = spheres_of({1, 0});
    model.impacts = impacts;
    add_plane(model, Vector3::UnitX(), 0);
    add_plane(model, Vector3::UnitZ(), 0);
    add_sphere(model, 1, Real(0.5), {Real(1.5), 3, Real(1.5)}, {-2, Real(0.25), -2});
    const Outcome end = run(model, 0.25, 4);
    EXPECT_EQ(velocity_of(model, end, 0), Vector3(2, Real(0.25), 2));
    EXPECT_EQ(end.impacts.size(), 2u);
  }
}

// Without restitution a sphere stays on its plane: it slides on without friction, rolls on with it.
TEST(BallisticContact, NoRestitution) {
  for (const Real mu : {Real(0), Real(2)}) {
    Model model = spheres_of({0, mu}, down);
    add_plane(model, Vector3::UnitY(), Real(0.2));
    add_sphere(model, Real(1.3), Real(0.4), {1, Real(0.6) + Real(0.5) * Real(9.81), 2},
               {Real(1.4), 0, Real(-0.7)});
    const Outcome end = run(model, 0.5, 6);  // falls for 1 s
    ASSERT_EQ(end.impacts.size(), 1u);
    EXPECT_NEAR(end.impacts[0].time, 1, rounding);
    EXPECT_EQ(end.impacts[0].separation, 0);
    const Real kept = mu == 0 ? Real(1) : Real(5) / 7;  // it sticks at once
    EXPECT_LE((velocity_of(model, end, 0) - kept * Vector3(Real(1.4), 0, Real(-0.7))).norm(), 10 * rounding);
    EXPECT_NEAR(end.motions[0].position.y(), Real(0.6), rounding);
    EXPECT_NEAR(end.motions[0].position.x(), 1 + Real(1.4) * (1 + 2 * kept), 10 * rounding);
    const Vector3 rim = Real(0.4) * spin_of(model, end, 0).cross(Vector3::UnitY());
    EXPECT_LE((rim - (mu == 0 ? Vector3(Vector3::Zero()) : velocity_of(model, end, 0))).norm(),
              10 * rounding);
  }
}

// Newton's law for any angle of a plane, and a general inertia factor (hollow sphere 2/3): rolling starts
// when the slip has gone, at u0 / (g mu (1 + 1/factor)); the velocity lost is u0 / (1 + 1/factor).
TEST(BallisticContact, SlipEndsForAnyInertia) {
  for (const Real factor : {Real(0.4), Real(2) / 3, Real(0.1), Real(1)}) {
    const Real mu = Real(0.21), k = 1 + 1 / factor;
    Model model = spheres_of({Real(0.5), mu}, down);
    add_plane(model, Vector3::UnitY(), 0);
    const Vector3 v(Real(1.9), 0, Real(0.8)), w(Real(2.0), Real(3.0), Real(-5.0));
    add_sphere(model, Real(1.7), Real(0.25), {0, Real(0.25), 0}, v, w, factor);
    const Vector3 u = v - Real(0.25) * w.cross(Vector3::UnitY());
    const Time end = static_cast<Time>(u.norm() / (Real(9.81) * mu * k));
    const Outcome before = run(model, end * 0.999, 1), after = run(model, end * 1.001, 2);
    const auto slip_of = [&](const Outcome& o) {
      return Vector3(velocity_of(model, o, 0) - Real(0.25) * spin_of(model, o, 0).cross(Vector3::UnitY()));
    };
    EXPECT_NEAR(slip_of(before).norm(), u.norm() / 1000, rounding * 10) << factor;
    EXPECT_LE(slip_of(after).norm(), rounding) << factor;
    EXPECT_LE((velocity_of(model, after, 0) - (v - u / k)).norm(), rounding * 5) << factor;
    EXPECT_NEAR(spin_of(model, after, 0).y(), 3, rounding);  // nothing turns it about the normal
  }
}

// Its orientation under an angular velocity that changes direction: against small midpoint steps of the exact
// angular velocity, whose error falls as h^2.
TEST(BallisticContact, OrientationWhileSlipping) {
  Model model = spheres_of({Real(0.5), Real(0.3)}, down);
  add_plane(model, Vector3::UnitY(), 0);
  add_sphere(model, Real(1.7), Real(0.25), {0, Real(0.25), 0}, {Real(2.9), 0, Real(0.8)},
             {Real(9.0), Real(12.0), Real(-5.0)});
  const Time end = 0.125;  // it slips all the time
  Real errors[2];
  for (int level = 0; level < 2; ++level) {
    const int steps = 100 << level;
    const auto stepper = make_ballistic(model, end / (2 * steps));
    std::vector<Motion> motions;
    Quaternion q = Quaternion::Identity();
    for (int i = 0; i < steps; ++i) {
      stepper->step();
      stepper->read(motions);
      q = turned(q, static_cast<Real>(end / steps) * angular_velocity(model.bodies[0], motions[0]));
      stepper->step();
    }
    stepper->read(motions);
    errors[level] = angle_between(q, motions[0].orientation);
  }
  EXPECT_LT(errors[1], 1e-5);
  if constexpr (sizeof(Real) == 8) {
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.05);
  }
  const Outcome once = run(model, end, 1), often = run(model, end / 1024, 1024);
  EXPECT_LE(angle_between(once.motions[0].orientation, often.motions[0].orientation), 10 * rounding);
}

// Thrown up a slope with friction, along the line of steepest descent: it decelerates at g (sin + mu cos),
// and its spin grows until it rolls, up and down again.  In the end it has rolled: v = r w x n, whatever
// happened.
TEST(BallisticContact, UpAndDownASlope) {
  const Real angle = Real(0.35), mu = Real(0.25);
  const Vector3 n(std::sin(angle), std::cos(angle), 0), d(std::cos(angle), -std::sin(angle), 0);
  Model model = spheres_of({Real(0.5), mu}, down);
  add_plane(model, n, Real(0.3));
  add_sphere(model, 2, Real(0.5), Real(0.8) * n, -3 * d);
  const Real g = Real(9.81), braking = g * (std::sin(angle) + mu * std::cos(angle));
  const Time early = 0.03125;
  const Outcome start = run(model, early, 1), end = run(model, 0.125, 24);
  EXPECT_NEAR(velocity_of(model, start, 0).dot(d), -3 + braking * static_cast<Real>(early), rounding);
  EXPECT_NEAR(velocity_of(model, end, 0).dot(n), 0, 10 * rounding);
  const Real slowing = Real(3.5) * mu * g * std::cos(angle) + g * std::sin(angle), t1 = 3 / slowing;
  const Real v1 = -3 + braking * t1;  // where the slip ends; then 5/7 g sin, for the rest of 3 s
  EXPECT_NEAR(velocity_of(model, end, 0).dot(d), v1 + Real(5) / 7 * g * std::sin(angle) * (3 - t1),
              20 * rounding);
  EXPECT_LE((Real(0.5) * spin_of(model, end, 0).cross(n) - velocity_of(model, end, 0)).norm(), 10 * rounding);
  EXPECT_FALSE(end.handover);
}

// A point has nothing to roll on: it stays on the slope iff tan <= mu, else slides at g (sin - mu cos).
TEST(BallisticContact, PointOnASlope) {
  const Real angle = Real(0.4);
  const Vector3 n(std::sin(angle), std::cos(angle), 0), d(std::cos(angle), -std::sin(angle), 0);
  for (const Real mu : {Real(0.5), Real(0.3)}) {
    Model model = spheres_of({0, mu}, down);
    add_plane(model, n, 0);
    add_sphere(model, 1, 0, Vector3::Zero(), Vector3::Zero());
    const Outcome end = run(model, 0.5, 4);
    const Real a = mu > std::tan(angle) ? 0 : Real(9.81) * (std::sin(angle) - mu * std::cos(angle));
    EXPECT_LE((end.motions[0].position - 2 * a * d).norm(), 10 * rounding) << mu;
    EXPECT_LE((end.motions[0].momentum - 2 * a * d).norm(), 10 * rounding) << mu;
  }
}

// A rolling sphere catches one that lies on the plane: two accelerations, so the instant is a root of a
// quartic.  Against the closed form on the line: d = v t - a t^2/2.
TEST(BallisticContact, SlidingSphereMeetsARestingOne) {
  const Real mu = Real(0.2), g = Real(9.81), v = 4;
  Model model = spheres_of({1, mu}, down);
  model.surface_count = 2;  // friction with the plane only
  model.materials = {{1, 0}, {1, mu}, {1, mu}, {0, 0}};
  add_plane(model, Vector3::UnitY(), 0);
  model.plane_surfaces = {1};
  const Vector3 line(Real(0.6), 0, Real(0.8));
  add_sphere(model, 1, Real(0.5), {0, Real(0.5), 0}, v * line);
  add_sphere(model, 1, Real(0.5), Vector3(0, Real(0.5), 0) + 2 * line, Vector3::Zero());
  const Outcome end = run(model, 0.03125, 16);
  ASSERT_EQ(end.impacts.size(), 1u);
  const Real t = 2 / (v + std::sqrt(v * v - 2 * mu * g));  // v t - mu g t^2/2 = 1; still slipping
  EXPECT_NEAR(end.impacts[0].time, t, rounding);
  EXPECT_NEAR(end.impacts[0].approach, v - mu * g * t, 10 * rounding);
  // Equal masses swap their velocities; both go on along the line, at the height of the radius.
  EXPECT_NEAR(end.motions[0].position.y(), Real(0.5), rounding);
  EXPECT_NEAR(end.motions[1].position.y(), Real(0.5), rounding);
  EXPECT_GT(velocity_of(model, end, 1).dot(line), velocity_of(model, end, 0).dot(line));
  EXPECT_LE(velocity_of(model, end, 1).cross(line).norm(), rounding * 10);
  EXPECT_FALSE(end.handover);
}

// Falls on a locked sphere, off its top: the first hit is where the vertical parabola meets the circle.
TEST(BallisticContact, LockedSphereActsAsWall) {
  Model model = spheres_of({Real(0.8), 0}, down);
  add_sphere(model, 1, Real(0.2), {Real(0.3), 2, Real(0.1)}, Vector3::Zero());
  add_sphere(model, 5, Real(0.6), Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), Real(0.4), true);
  const Outcome end = run(model, 0.125, 8);
  ASSERT_GE(end.impacts.size(), 1u);
  const Real y = std::sqrt(Real(0.64) - Real(0.09) - Real(0.01)), fall = 2 - y;
  EXPECT_NEAR(end.impacts[0].time, std::sqrt(2 * fall / Real(9.81)), rounding);
  const Real speed = std::sqrt(2 * Real(9.81) * fall), approach = speed * y / Real(0.8);
  EXPECT_NEAR(end.impacts[0].approach, approach, 10 * rounding);
  EXPECT_NEAR(end.impacts[0].separation, Real(0.8) * approach, 10 * rounding);
  EXPECT_TRUE(same_bits(end.motions[1], model.motions[1]));
  const double loss = 0.5 * (1 - 0.64) * static_cast<double>(approach * approach);
  EXPECT_NEAR(energy(model, model.motions) - energy(model, end.motions), loss, 30 * rounding);
}

// Ever shorter bounces on a slope: when they end the velocity along the slope is that of a slide that gravity
// pulls all the time, because without friction nothing else acts along it.
TEST(BallisticContact, BouncesOnSlopeEndInSliding) {
  const Vector3 n = Vector3(Real(0.3), 1, Real(-0.2)).normalized();
  Model model = spheres_of({Real(0.5), 0}, down);
  add_plane(model, n, Real(0.7));
  add_sphere(model, 1, Real(0.3), Vector3(1, 2, Real(-1)) + (Real(1.2) - n.dot(Vector3(1, 2, -1))) * n,
             {Real(0.4), Real(0.1), Real(0.2)});
  const Outcome end = run(model, 1.0 / 64, 128);
  const Vector3 level = down - n.dot(down) * n, v0 = velocity(model.bodies[0], model.motions[0]);
  EXPECT_FALSE(end.handover);
  EXPECT_LE((velocity_of(model, end, 0) - (v0 - n.dot(v0) * n + 2 * level)).norm(), 10 * rounding);
  EXPECT_NEAR(n.dot(end.motions[0].position), 1, 10 * rounding);
  EXPECT_LT(end.impacts.back().time, 1);
  // Each bounce halves the speed along n.  Below the rounding of the velocity, whose other parts grow to some
  // 9 m/s, there is none to see: after 50 bounces in double, which ends them earlier, and 20 in float.
  const Real seen = std::log2(end.impacts.front().approach / (ulp * velocity_of(model, end, 0).norm()));
  EXPECT_GT(static_cast<Real>(end.impacts.size()), std::min(Real(20), seen - 4));
}

struct Limit {
  const char* name;
  const char* reason;
  Model model;
};

// What it does not know is detected and handed over with the state at that instant.
TEST(BallisticContact, HandsOverUnsupportedStates) {
  std::vector<Limit> limits;
  {
    Model model = spheres_of({Real(0.5), 0}, down);  // a ball in a groove
    add_plane(model, {1, 1, 0}, 0);
    add_plane(model, {-1, 1, 0}, 0);
    add_sphere(model, 1, Real(0.3), {Real(0.02), Real(1.1), 0}, Vector3::Zero());
    limits.push_back({"groove", "pressed against planes", model});
  }
  {
    Model model = spheres_of({Real(0.5), 0}, down);  // one ball balances on another
    add_plane(model, {0, 1, 0}, 0);
    add_sphere(model, 1, Real(0.5), {0, Real(0.5), 0}, Vector3::Zero());
    add_sphere(model, 1, Real(0.5), {0, Real(1.75), 0}, Vector3::Zero());
    limits.push_back({"stack", "has too many impacts", model});
  }
  {
    Model model = spheres_of({Real(0.5), 0}, down);  // the same, at rest from the beginning
    add_plane(model, {0, 1, 0}, 0);
    add_sphere(model, 1, Real(0.5), {0, Real(0.5), 0}, Vector3::Zero());
    add_sphere(model, 1, Real(0.5), {0, Real(1.5), 0}, Vector3::Zero());
    limits.push_back({"resting stack", "stay pressed together", model});
  }
  {
    Model model = spheres_of({Real(0.5), Real(0.2)}, down);
    add_plane(model, {Real(0.2), 1, 0}, 0);
    const Vector3 n = model.planes[0].normal;
    add_sphere(model, 1, Real(0.5), Real(0.5) * n, {0, 0, 2});
    limits.push_back({"across a slope", "across the slope", model});
  }
  {
    Model model = spheres_of({Real(0.5), 0});
    add_sphere(model, 1, Real(0.5), {0, 0, 0}, Vector3::Zero());
    add_sphere(model, 1, Real(0.5), {Real(0.9), 0, 0}, Vector3::Zero());
    limits.push_back({"overlap", "overlap at the start", model});
  }
  for (const Limit& limit : limits) {
    for (const Impacts impacts : {Impacts::sequential, Impacts::simultaneous}) {
      Model model = limit.model;
      model.impacts = impacts;
      const auto stepper = make_ballistic(model, 1.0 / 64);
      int steps = 0;
      for (; steps < 640 && !stepper->handover(); ++steps) stepper->step();
      ASSERT_TRUE(stepper->handover()) << limit.name;
      const Handover& handover = *stepper->handover();
      if (impacts == Impacts::sequential) {
        EXPECT_NE(handover.reason.find(limit.reason), std::string::npos)
            << limit.name << ": " << handover.reason;
      }
      EXPECT_LE(handover.time, steps / 64.0);
      EXPECT_GE(handover.time, std::max(0, steps - 1) / 64.0);
      ASSERT_EQ(handover.motions.size(), model.bodies.size());
      for (const Motion& m : handover.motions) EXPECT_TRUE(m.position.allFinite() && m.momentum.allFinite());
      EXPECT_LE(energy(model, handover.motions), energy(model, model.motions) + 100 * rounding);
      std::vector<Motion> now;
      stepper->step();  // nothing more
      stepper->read(now);
      for (std::size_t i = 0; i < now.size(); ++i) EXPECT_TRUE(same_bits(now[i], handover.motions[i]));
    }
  }
}

TEST(BallisticContact, GivesReasonWhereItDoesNotApply) {
  Model good = spheres_of({Real(0.5), Real(0.2)}, down);
  add_sphere(good, 1, Real(0.5), {0, 1, 0}, Vector3::Zero());
  EXPECT_TRUE(ballistic_applies(good));
  const auto reason = [&](auto&& change) {
    Model model = good;
    change(model);
    EXPECT_FALSE(ballistic_applies(model));
    return ballistic_unsupported(model).value_or("");
  };
  each_force_list(good.forces, [&]<class Kind>(const std::vector<Kind>&) {
    const std::string why = reason([](Model& m) {
      each_force_list(m.forces, []<class Other>(std::vector<Other>& list) {
        if constexpr (std::is_same_v<Kind, Other>) list.emplace_back();
      });
    });
    EXPECT_EQ(why, names({Kind::feature})) << Kind::stage;
  });
  EXPECT_EQ(reason([](Model& m) { m.bodies[0].mass_rate = Real(-0.1); }), "changing masses");
  EXPECT_EQ(reason([](Model& m) { m.joints.emplace_back(); }), "joints at a point");
  EXPECT_EQ(reason([](Model& m) { m.frame.emplace(); }), "a rotating frame");
  EXPECT_EQ(reason([](Model& m) { m.shapes[0] = Box{}; }), "body 0 is not a sphere");
  EXPECT_EQ(reason([](Model& m) { m.bodies[0].inverse_mass = 0; }), "body 0 is pinned");
  const auto lopsided = [](Model& m) {
    m.bodies[0] = make_body(1, Vector3(Real(0.1), Real(0.2), Real(0.25)).asDiagonal());
    m.motions[0].angular_momentum = {1, 2, 3};
    m.materials[0].friction = 0;
  };
  EXPECT_EQ(reason(lopsided), "body 0 spins and has three different principal moments");
  const auto rough = [&](Model& m) {
    lopsided(m);
    m.materials[0].friction = Real(0.1);
    add_plane(m, Vector3::UnitY(), 0);
  };
  EXPECT_EQ(reason(rough), "body 0 can be rotated by friction and its inertia is not that of a sphere");
}

// A symmetric top that cannot be turned by what it touches goes on as a free top, through the bounce.
TEST(BallisticContact, SymmetricTopBounces) {
  Model model = spheres_of({Real(0.8), 0}, down);
  add_plane(model, Vector3::UnitY(), 0);
  add_sphere(model, 1, Real(0.5), {0, 2, 0}, {Real(0.3), 0, 0});
  model.bodies[0] = make_body(1, Vector3(Real(0.1), Real(0.1), Real(0.16)).asDiagonal());
  model.motions[0].angular_momentum = {Real(0.3), Real(-0.2), Real(0.9)};
  const Time end = 2;
  const Outcome result = run(model, end / 64, 64);
  EXPECT_GE(result.impacts.size(), 2u);
  // q(t) = rot(L, |L| t/I1) q0 rot(axis, w3 (1 - I3/I1) t)
  const Vector3 l = model.motions[0].angular_momentum;
  const Real w3 = l.z() / Real(0.16), t = static_cast<Real>(end);
  const Quaternion q =
      exponential(t / Real(0.1) * l) * exponential(w3 * (1 - Real(1.6)) * t * Vector3::UnitZ());
  EXPECT_LE(angle_between(result.motions[0].orientation, q), 20 * rounding);  // it turns by 20 rad
  EXPECT_EQ(result.motions[0].angular_momentum, l);
}

}  // namespace
}  // namespace cylon::engine::ballistic_test
