// The exact solutions obey the equations of motion for general parameters, not only in the reference files:
// against independent integration, under the symmetries of mechanics, and in what they conserve.
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/newton_euler.h"
#include "tests/reference/exact/random_scenes.h"
#include "tests/reference/exact/reference_file.h"

#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

core::Truth make(std::string_view name, const core::Scene& scene, double horizon) {
  for (const Solution& solution : catalogue()) {
    if (solution.name == name) return solution.make(scene, horizon);
  }
  throw std::runtime_error("no solution " + std::string(name));
}

// Differences at most `factor` bounds.
void expect_close(const core::BodyState& a, const core::BodyState& b, const core::StateError& bound,
                  double factor) {
  EXPECT_LE((a.position - b.position).norm(), factor * bound.position);
  EXPECT_LE((a.velocity - b.velocity).norm(), factor * bound.velocity);
  EXPECT_LE(angle_between(a.orientation, b.orientation), factor * bound.orientation);
  EXPECT_LE((a.angular_velocity - b.angular_velocity).norm(), factor * bound.angular_velocity);
}

// The bounds must say something: three digits more than what claims ask of stepping schemes.
void expect_useful(const core::StateError& bound) {
  EXPECT_LE(bound.position, 1e-9);
  EXPECT_LE(bound.velocity, 1e-8);
  EXPECT_LE(bound.orientation, 1e-9);
  EXPECT_LE(bound.angular_velocity, 1e-8);
}

class Laws : public testing::TestWithParam<const char*> {};

TEST_P(Laws, integration_agrees) {
  const double horizon = 4;
  const long double h = std::string(GetParam()) == "heavy_top" ? 0.004L : 0.01L;  // spins of 40 rad/s
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = RandomScenes(seed).scene(GetParam());
    const core::Truth truth = make(GetParam(), scene, horizon);
    expect_useful(truth.error);
    NewtonEuler integration(scene, 0);
    for (double t : {0.0, 0.31, 1.7, 4.0})
      expect_close(truth.state(t)[0], integration.at(t, h), truth.error, 1);
  }
}

// All of space turned by s, shifted by a and, where nothing is fixed to the world, set in motion by u.
core::Scene transformed(core::Scene scene, const core::Quaternion& s, const core::Vector3& a,
                        const core::Vector3& u) {
  for (core::Body& body : scene.bodies) {
    core::BodyState& b = body.initial;
    b = {s * b.position + a, s * b.orientation, s * b.velocity + u, s * b.angular_velocity};
  }
  for (core::Joint& joint : scene.joints) joint.point = s * joint.point + a;
  for (core::Force& force : scene.forces) {
    if (auto* g = std::get_if<core::UniformGravity>(&force)) g->acceleration = s * g->acceleration;
    if (auto* spring = std::get_if<core::Spring>(&force)) spring->to_anchor = s * spring->to_anchor + a;
  }
  return scene;
}

TEST_P(Laws, rotation_translation_boost) {
  const double horizon = 6;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    RandomScenes random(100 + seed);
    const core::Scene scene = random.scene(GetParam());
    const std::string name = GetParam();
    const bool fixed = name == "heavy_top" || name.starts_with("spring");
    const core::Quaternion s = random.rotation();
    const core::Vector3 a = random.vector(2), u = fixed ? core::Vector3(0, 0, 0) : random.vector(2);
    const core::Truth one = make(name, scene, horizon),
                      other = make(name, transformed(scene, s, a, u), horizon);
    for (double t : {0.0, 0.4, 2.9, 6.0}) {
      const core::BodyState b = one.state(t)[0];
      expect_close(
          {s * b.position + a + u * t, s * b.orientation, s * b.velocity + u, s * b.angular_velocity},
          other.state(t)[0], other.error, 2);
    }
  }
}

// The body's axes relabelled: q' = q c, I' = c^T I c; the same motion.
TEST_P(Laws, body_axes) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    RandomScenes random(200 + seed);
    const core::Scene scene = random.scene(GetParam());
    core::Scene relabelled = scene;
    const core::Quaternion c = random.rotation();
    core::Body& body = relabelled.bodies[0];
    const core::Matrix3 r = c.toRotationMatrix();
    body.inertia = r.transpose() * body.inertia * r;
    body.inertia = ((body.inertia + body.inertia.transpose()) / 2).eval();
    body.initial.orientation = body.initial.orientation * c;
    const core::Truth one = make(GetParam(), scene, 5), other = make(GetParam(), relabelled, 5);
    for (double t : {0.0, 2.2, 5.0}) {
      core::BodyState expected = one.state(t)[0];
      expected.orientation = expected.orientation * c;
      expect_close(expected, other.state(t)[0], other.error, 2);
    }
  }
}

// run(T1 + T2) = run(T2) after run(T1).
TEST_P(Laws, flow) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    core::Scene scene = RandomScenes(300 + seed).scene(GetParam());
    const core::Truth whole = make(GetParam(), scene, 6);
    scene.bodies[0].initial = whole.state(2.3)[0];
    const core::Truth rest = make(GetParam(), scene, 6);
    for (double t : {0.0, 1.1, 3.7}) expect_close(whole.state(2.3 + t)[0], rest.state(t)[0], whole.error, 3);
  }
}

INSTANTIATE_TEST_SUITE_P(all, Laws,
                         testing::Values("projectile", "spring_zero_length", "spring_orbit",
                                         "free_symmetric_top", "free_asymmetric_top", "heavy_top"),
                         [](const auto& p) { return std::string(p.param); });

// E and L to the last digits, not only within the bound on the state.
TEST(Invariants, free_tops) {
  for (const char* name : {"free_symmetric_top", "free_asymmetric_top"}) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      core::Scene scene = RandomScenes(400 + seed).scene(name);
      scene.forces.clear();
      const core::Truth truth = make(name, scene, 50);
      const auto momentum = [&](const core::BodyState& s) -> core::Vector3 {
        return core::world_inertia(scene.bodies[0], s.orientation) * s.angular_velocity;
      };
      const core::BodyState start = scene.bodies[0].initial;
      const core::Vector3 l0 = momentum(start);
      const double e0 = l0.dot(start.angular_velocity);
      for (int k = 0; k <= 100; ++k) {
        const core::BodyState s = truth.state(0.5 * k)[0];
        EXPECT_LE((momentum(s) - l0).norm(), 1e-14 * l0.norm()) << name << seed;
        EXPECT_NEAR(momentum(s).dot(s.angular_velocity), e0, 1e-14 * e0) << name << seed;
      }
    }
  }
}

TEST(Invariants, heavy_top) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = RandomScenes(500 + seed).scene("heavy_top");
    const core::Truth truth = make("heavy_top", scene, 20);
    const core::Body& body = scene.bodies[0];
    const core::Vector3 g = std::get<core::UniformGravity>(scene.forces[0]).acceleration,
                        pivot = scene.joints[0].point;
    const auto invariants = [&](const core::BodyState& s) -> core::Vector3 {
      const core::Vector3 arm = s.position - pivot,
                          spin = core::world_inertia(body, s.orientation) * s.angular_velocity;
      const core::Vector3 l = spin + body.mass * arm.cross(s.velocity);
      const double energy =
          (spin.dot(s.angular_velocity) + body.mass * s.velocity.squaredNorm()) / 2 - body.mass * g.dot(arm);
      return {energy, l.dot(g.normalized()), l.dot(arm.normalized())};
    };
    const core::Vector3 start = invariants(body.initial);
    for (int k = 0; k <= 100; ++k) {
      const core::BodyState s = truth.state(0.2 * k)[0];
      EXPECT_LE((invariants(s) - start).cwiseAbs().maxCoeff(), 2e-14 * (1 + start.norm()));
      EXPECT_NEAR((s.position - pivot).norm(), (body.initial.position - pivot).norm(), 1e-15);
    }
  }
}

}  // namespace
}  // namespace cylon::exact
