// Friction of any size never adds energy, in sliding and in sticking.
#include "tests/engine/contact/contact_fixtures.h"

#include <algorithm>
#include <string>
#include <variant>

namespace cylon::engine {
namespace {

// A ball rolls, slips and leaves a locked ball; friction grows without bound.
TEST(EventFriction, SeparationAddsNoEnergy) {
  for (const Real mu : {Real(1), Real(10), Real(50), Real(1e3), Real(1e4), Real(1e5), Real(1e6)}) {
    Model model = with_plane(Vector3::UnitY(), -50, {0, mu});
    add_sphere(model, 1, 1, Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), true);
    add_sphere(model, 1, Real(0.2), Real(1.2) * Vector3(std::sin(0.3), std::cos(0.3), 0), Vector3::Zero(),
               Vector3::Zero());
    Trial run(model, 0.005);
    const Real start = run.energy();
    Real energy = start;
    while (run.time < 2) {
      run.step();
      // 1e-11: the flow's tolerance of 1e-13 a step, 400 steps, in parts of 12 J
      ASSERT_LE(run.energy(), energy + 1e-11 * start) << mu << " at " << run.time;
      energy = std::min(energy, run.energy());
    }
    EXPECT_TRUE(run.stepper.held().empty()) << mu;
    EXPECT_LT(run.motion(1).position.y(), -1) << mu;
    // 10/17 cos(0.3) in the limit of rolling to the end; slip before it ends takes a part of order 1/mu
    EXPECT_GT(energy, start * (1 - 1 / mu)) << mu;
  }
}

// A thin rod on a rough floor, tilted and pushed so that friction digs it in (Painleve): above mu = 4/3 there
// are slips for which no finite force keeps the contact.
TEST(EventFriction, JammingAddsNoEnergy) {
  for (const Real mu : {Real(0.5), Real(1), Real(2), Real(5), Real(100), Real(1e6)}) {
    for (const Real speed : {Real(0.3), Real(3), Real(-3)}) {
      Model model = with_plane(Vector3::UnitY(), 0, {0, mu});
      const Real half = 1, thin = Real(0.001), lean = Real(1.0);
      const Quaternion q = exponential(Vector3(0, 0, -(lean - Real(M_PI) / 2) - Real(M_PI) / 2));
      // lowest corner on the floor
      const Vector3 corner = q * Vector3(thin, -half, thin);
      const Vector3 other = q * Vector3(-thin, -half, thin);
      const Real low = std::min(corner.y(), other.y());
      add_box(model, 1, {thin, half, thin}, Vector3(0, -low, 0), q, {speed, 0, 0}, Vector3::Zero());
      Trial run(model, 0.01);
      Real energy = run.energy();
      const Real start = energy + 10;
      while (run.time < 1.5) {
        run.step();
        ASSERT_LE(run.energy(), energy + 1e-10 * start) << mu << ' ' << speed << " at " << run.time;
        energy = run.energy();
      }
      EXPECT_LT(run.motion(0).position.y(), 0.9) << mu << ' ' << speed;
      EXPECT_GT(run.motion(0).position.y(), 0) << mu << ' ' << speed;
    }
  }
}

// How deep the one body of a scene lies in the planes at most [m].
Real depth(const Trial& run) {
  Real deepest = 0;
  const Motion& m = run.motion(0);
  for (const Plane& plane : run.model.planes) {
    const Vector3 down = m.orientation.conjugate() * plane.normal;
    const Real reach = std::holds_alternative<Sphere>(run.model.shapes[0])
                           ? std::get<Sphere>(run.model.shapes[0]).radius
                           : std::get<Box>(run.model.shapes[0]).half_extents.dot(down.cwiseAbs());
    deepest = std::max(deepest, reach + plane.offset - plane.normal.dot(m.position));
  }
  return deepest;
}

Model corner(Real mu, bool ball, const Vector3& v, const Vector3& w) {
  Model model = with_plane(Vector3(0.2, 1, 0.1).normalized(), 0, {0.3, mu});
  model.planes.push_back({Vector3(-1, 0.1, 0.2).normalized(), -2});
  model.planes.push_back({Vector3(0.1, 0.2, -1).normalized(), -2});
  model.plane_surfaces.assign(3, 1);
  const Vector3 at(0.4, 1, 0.3);
  if (ball) {
    add_sphere(model, 1, Real(0.3), at, v, w);
  } else {
    add_box(model, 1, {0.3, 0.2, 0.25}, at, exponential(Vector3(0.3, 0.5, -0.2)), v, w);
  }
  return model;
}

void expect_no_rise(const Model& model, const std::string& which) {
  Trial run(model, 0.01);
  Real energy = run.energy(), sunk = 0;
  const Real start = std::abs(energy) + 10, weight = model.forces.gravity.norm();
  while (run.time < 3) {
    run.step();
    ASSERT_LE(run.energy(), energy + weight * sunk + 1e-10 * start) << which << " at " << run.time;
    energy = run.energy();
    sunk = depth(run);
    const bool unlocated = std::ranges::any_of(
        run.stepper.diagnostics(), [](const Diagnostic& d) { return d.kind == DiagnosticKind::not_located; });
    ASSERT_LE(sunk, unlocated ? weight * 0.0025 * 0.0025 : 1e-11) << which << " at " << run.time;
  }
}

// A box and a ball thrown at a corner of three rough planes.  The box rattles between them, for up to hundreds of impacts
// in a millisecond; where a step has more events than are followed, which is told, the rest of it goes in four parts and
// leaves overlaps of g (h/4)^2 at most.  What lies too deep has less potential energy than it should, and gets it back when
// the overlap is closed.
TEST(EventFriction, CornerImpactAddsNoEnergy) {
  for (const Real mu : {Real(0.2), Real(1), Real(30), Real(1e6)})
    for (const bool ball : {false, true})
      expect_no_rise(corner(mu, ball, {2, -1, 1.5}, {3, -2, 1}),
                     std::to_string(mu) + (ball ? " ball" : " box"));
}

// Friction that jams a ball has no bound, and jumps: steps over the jump at which error control gave up gave a third of
// such throws energy, up to 1e6 J of 20 J.
TEST(EventFriction, JamsAddNoEnergy) {
  for (int k = 0; k < 16; ++k) {
    const Real x = Real(0.02) * static_cast<Real>(k);
    expect_no_rise(corner(Real(1e6), true, {2 + x, -1 - x / 3, Real(1.5) - x / 2}, {3 - x, -2 + 2 * x, 1}),
                   "throw " + std::to_string(k));
  }
}

}  // namespace
}  // namespace cylon::engine
