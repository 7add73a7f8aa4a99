// Spheres with general parameters: the closed sums against a flight-by-flight recursion, and what a hit
// conserves.
#include "reference/exact/solutions.h"
#include "tests/reference/exact/random_scenes.h"
#include "tests/reference/exact/reference_file.h"

#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

TEST(Bounces, closed_sums_agree_with_the_recursion) {
  for (double e : {0.0, 0.3, 0.8, 0.999, 1.0}) {
    for (double rate : {-3.0, 0.0, 2.5}) {
      core::Scene scene = ReferenceFile("bouncing_sphere").scene;
      scene.materials[0].restitution = e;
      scene.bodies[0].initial.velocity = {0.7, rate, -0.2};
      const core::Truth truth = bouncing_sphere(scene, 5);
      double y = 2.5, v = rate, t = 0;
      const double g = 9.81, dt = 1.0 / 64;
      for (int k = 1; k <= 320; ++k) {  // flights cut at the samples and at the impacts
        double left = dt;
        for (int hits = 0; hits < 1000 && left > 0; ++hits) {
          const double impact = (v + std::sqrt(v * v + 2 * g * std::max(0.0, y - 0.5))) / g;
          if (v <= 1e-9 && y - 0.5 < 1e-12) {  // at rest
            y = 0.5, v = 0, left = 0;
          } else if (impact > left) {
            y += v * left - g * left * left / 2, v -= g * left, left = 0;
          } else {
            v = e * (g * impact - v), y = 0.5, left -= impact;
          }
        }
        t = k * dt;
        const core::BodyState s = truth.state(t)[0];
        EXPECT_NEAR(s.position.y(), y, 1e-9) << "e " << e << " rate " << rate << " t " << t;
        EXPECT_NEAR(s.position.x(), 0.7 * t, 1e-14);
      }
      EXPECT_EQ(!truth.events.empty() && truth.events[0].kind == core::EventKind::apex, rate > 0);
    }
  }
}

TEST(Bounces, impact_conserves_momentum) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    RandomScenes random(seed);
    core::Scene scene = ReferenceFile("two_sphere_oblique").scene;
    scene.materials[0].restitution = 0.6;
    for (core::Body& b : scene.bodies) b.initial.velocity = random.vector(1);
    scene.bodies[0].initial.velocity.x() += 5;
    const core::Truth truth = two_sphere_oblique(scene, 4);
    if (truth.events.empty()) continue;
    const double t = truth.events[0].time;
    const core::State start = core::initial_state(scene), hit = truth.state(t), end = truth.state(4);
    EXPECT_NEAR((hit[1].position - hit[0].position).norm(), 1.0, 1e-13);
    const core::Vector3 n = hit[1].position - hit[0].position;
    const double before = n.dot(start[1].velocity - start[0].velocity),
                 after = n.dot(end[1].velocity - end[0].velocity);
    EXPECT_NEAR(after, -0.6 * before, 1e-12);
    EXPECT_NEAR(truth.events[0].speed, after, 1e-12);
    const auto momenta = [&](const core::State& s) {
      core::Vector3 k(0, 0, 0), l(0, 0, 0);
      for (std::size_t i : {0u, 1u}) {
        k += scene.bodies[i].mass * s[i].velocity;
        l += scene.bodies[i].mass * s[i].position.cross(s[i].velocity);
      }
      return std::pair(k, l);
    };
    EXPECT_LE((momenta(start).first - momenta(end).first).norm(), 1e-13);
    EXPECT_LE((momenta(start).second - momenta(end).second).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace cylon::exact
