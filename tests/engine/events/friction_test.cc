// Friction of any size never adds energy, in sliding and in sticking.
#include "tests/engine/contact/contact_fixtures.h"

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

// A box and a ball thrown at a corner of three rough planes.
TEST(EventFriction, CornerImpactAddsNoEnergy) {
  for (const Real mu : {Real(0.2), Real(1), Real(30), Real(1e6)}) {
    for (const bool ball : {false, true}) {
      Model model = with_plane(Vector3(0.2, 1, 0.1).normalized(), 0, {0.3, mu});
      model.planes.push_back({Vector3(-1, 0.1, 0.2).normalized(), -2});
      model.planes.push_back({Vector3(0.1, 0.2, -1).normalized(), -2});
      model.plane_surfaces.assign(3, 1);
      const Vector3 at(0.4, 1, 0.3), v(2, -1, 1.5), w(3, -2, 1);
      if (ball) {
        add_sphere(model, 1, Real(0.3), at, v, w);
      } else {
        add_box(model, 1, {0.3, 0.2, 0.25}, at, exponential(Vector3(0.3, 0.5, -0.2)), v, w);
      }
      Trial run(model, 0.01);
      Real energy = run.energy();
      const Real start = std::abs(energy) + 10;
      while (run.time < 3) {
        run.step();
        ASSERT_LE(run.energy(), energy + 1e-10 * start) << mu << ' ' << ball << " at " << run.time;
        energy = run.energy();
      }
    }
  }
}

}  // namespace
}  // namespace cylon::engine
