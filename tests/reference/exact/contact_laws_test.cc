// The solutions with contacts obey mechanics for general parameters: Newton and Euler between events, with
// the contact's force in Coulomb's cone; Newton's restitution and Coulomb's cone at impacts; no penetration;
// energy that never grows; and the same answer however space is turned and wherever the watch is started.
#include "harness/core/observable.h"
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/contact_scenes.h"
#include "tests/reference/exact/reference_file.h"

#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

constexpr double horizon = 3;
constexpr unsigned seeds = 6;

core::Truth make(std::string_view name, const core::Scene& scene, double until = horizon) {
  for (const Solution& solution : catalogue()) {
    if (solution.name == name) return solution.make(scene, until);
  }
  throw std::runtime_error("no solution " + std::string(name));
}

core::Vector3 gravity_of(const core::Scene& scene) {
  core::Vector3 sum(0, 0, 0);
  for (const core::Force& force : scene.forces) sum += std::get<core::UniformGravity>(force).acceleration;
  return sum;
}

double radius_of(const core::Body& body) {
  const auto* sphere = std::get_if<core::Sphere>(&body.shape);
  return sphere ? sphere->radius : 0;
}

double energy(const core::Scene& scene, const core::State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const core::BodyState& s = state[i];
    sum +=
        scene.bodies[i].mass * (s.velocity.squaredNorm() / 2 - gravity_of(scene).dot(s.position)) +
        s.angular_velocity.dot(core::world_inertia(scene.bodies[i], s.orientation) * s.angular_velocity) / 2;
  }
  return sum;
}

// Whether something jumps near t: the acceleration, or what an event changes.
bool smooth_near(const core::Truth& truth, double t, double h) {
  for (std::size_t i = 0; i < truth.state(t).size(); ++i) {
    const auto v = [&](double s) -> core::Vector3 { return truth.state(s)[i].velocity; };
    if (((v(t + h) - v(t)) - (v(t) - v(t - h))).norm() > 1e-9) return false;
  }
  return true;
}

// The force of the plane on a body, from its acceleration, and the slip of the point of contact.
void expect_coulomb(const core::Scene& scene, std::size_t i, const core::BodyState& s,
                    const core::Vector3& force, const core::Vector3& torque) {
  if (force.norm() < 1e-6) return;
  ASSERT_FALSE(scene.planes.empty());
  const core::Pair pair = {static_cast<int>(i), core::world, 0};
  EXPECT_NEAR(core::gap(scene, pair, {s}), 0, 1e-12) << "a force without contact";
  const core::Vector3 n = scene.planes[0].normal;
  const double normal = n.dot(force), mu = core::material_of(scene, pair)->friction;
  const core::Vector3 friction = force - normal * n;
  EXPECT_GT(normal, 0);
  EXPECT_LE(friction.norm(), mu * normal + 1e-6);
  const core::Vector3 arm = -radius_of(scene.bodies[i]) * n, rest = s.velocity - n.dot(s.velocity) * n;
  const core::Vector3 slip = rest + s.angular_velocity.cross(arm);
  if (slip.norm() > 1e-6) {
    EXPECT_LE((friction + mu * normal * slip.normalized()).norm(), 1e-5);
  }
  if (radius_of(scene.bodies[i]) > 0) {
    EXPECT_LE((torque - arm.cross(force)).norm(), 1e-6);
  }
}

class ContactLaws : public testing::TestWithParam<const char*> {};

TEST_P(ContactLaws, motion_between_events) {
  const double h = 1e-4;
  int looked = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = ContactScenes(seed).scene(GetParam());
    const core::Truth truth = make(GetParam(), scene);
    for (int k = 1; k < 60; ++k) {
      const double t = horizon * k / 60.03;
      if (!smooth_near(truth, t, h)) continue;
      ++looked;
      const core::State before = truth.state(t - h), now = truth.state(t), after = truth.state(t + h);
      for (std::size_t i = 0; i < now.size(); ++i) {
        const auto rate = [&](auto part) -> core::Vector3 {
          return (part(after[i]) - part(before[i])) / (2 * h);
        };
        const core::BodyState& s = now[i];
        EXPECT_LE((rate([](const core::BodyState& x) { return x.position; }) - s.velocity).norm(), 1e-9);
        const core::Quaternion w(0, s.angular_velocity.x(), s.angular_velocity.y(), s.angular_velocity.z());
        const Eigen::Vector4d turn =
            (after[i].orientation.coeffs() - before[i].orientation.coeffs()) / (2 * h);
        EXPECT_LE((turn - (w * s.orientation).coeffs() / 2).norm(), 1e-5);
        const core::Vector3 force =
            scene.bodies[i].mass *
            (rate([](const core::BodyState& x) { return x.velocity; }) - gravity_of(scene));
        const core::Vector3 torque = rate([&](const core::BodyState& x) -> core::Vector3 {
          return core::world_inertia(scene.bodies[i], x.orientation) * x.angular_velocity;
        });
        expect_coulomb(scene, i, s, force, torque);
      }
    }
  }
  EXPECT_GT(looked, 50);
}

// J = m (v' - v) from states just before and after: the flight between them is 1e-7 s.
TEST_P(ContactLaws, impacts) {
  const double d = 1e-7;
  int looked = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = ContactScenes(seed).scene(GetParam());
    const core::Truth truth = make(GetParam(), scene);
    for (std::size_t k = 0; k < truth.events.size(); ++k) {
      const core::Event& e = truth.events[k];
      const bool crowded = (k > 0 && e.time - truth.events[k - 1].time < 1e-4) ||
                           (k + 1 < truth.events.size() && truth.events[k + 1].time - e.time < 1e-4);
      if (e.kind != core::EventKind::bounce || crowded || e.time + d > horizon) continue;
      ++looked;
      const core::State before = truth.state(e.time - d), after = truth.state(e.time + d);
      const auto i = static_cast<std::size_t>(e.pair.body);
      const core::Body& body = scene.bodies[i];
      core::Vector3 n, rate_before = -before[i].velocity, rate_after = -after[i].velocity;
      if (e.pair.plane >= 0) {
        n = -scene.planes[static_cast<std::size_t>(e.pair.plane)].normal;  // from the body outward
      } else {
        const auto j = static_cast<std::size_t>(e.pair.other);
        n = (after[j].position - after[i].position).normalized();
        rate_before += before[j].velocity, rate_after += after[j].velocity;
        EXPECT_LE((body.mass * (after[i].velocity - before[i].velocity) +
                   scene.bodies[j].mass * (after[j].velocity - before[j].velocity))
                      .norm(),
                  1e-4);
      }
      EXPECT_NEAR(core::gap(scene, e.pair, truth.state(e.time)), 0, 1e-12);
      const auto material = core::material_of(scene, e.pair);
      EXPECT_NEAR(n.dot(rate_after), -material->restitution * n.dot(rate_before), 1e-5);
      EXPECT_NEAR(n.dot(rate_after), e.speed, 1e-5);
      const core::Vector3 blow = body.mass * (after[i].velocity - before[i].velocity);
      const double normal = -n.dot(blow);
      EXPECT_GT(normal, 0);
      EXPECT_LE((blow + normal * n).norm(), material->friction * normal + 2e-5);
      const core::Vector3 arm = radius_of(body) * n;
      const core::Vector3 spin = core::world_inertia(body, after[i].orientation) *
                                 (after[i].angular_velocity - before[i].angular_velocity);
      EXPECT_LE((spin - arm.cross(blow)).norm(), 2e-5);
    }
  }
  EXPECT_GE(looked, std::string(GetParam()) == "sliding_block" ? 0 : 10);
}

TEST_P(ContactLaws, no_penetration_and_no_energy_gain) {
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = ContactScenes(seed).scene(GetParam());
    const core::Truth truth = make(GetParam(), scene);
    double before = energy(scene, truth.state(0));
    const double size = 1 + std::abs(before);
    for (int k = 1; k <= 300; ++k) {
      const core::State state = truth.state(horizon * k / 300);
      const double now = energy(scene, state);
      EXPECT_LE(now, before + 1e-12 * size);
      before = now;
      for (const core::Pair& pair : core::touching_pairs(scene)) {
        EXPECT_GE(core::gap(scene, pair, state), -1e-12);
      }
    }
  }
}

void expect_close(const core::State& a, const core::State& b, const core::StateError& bound, double factor,
                  bool velocities) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_LE((a[i].position - b[i].position).norm(), factor * bound.position);
    EXPECT_LE(angle_between(a[i].orientation, b[i].orientation), factor * bound.orientation);
    if (!velocities) continue;
    EXPECT_LE((a[i].velocity - b[i].velocity).norm(), factor * bound.velocity);
    EXPECT_LE((a[i].angular_velocity - b[i].angular_velocity).norm(), factor * bound.angular_velocity);
  }
}

TEST_P(ContactLaws, rotation_translation) {
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = ContactScenes(seed).scene(GetParam());
    RandomScenes random(seed + 50);
    const core::Quaternion s = random.rotation();
    const core::Vector3 a = random.vector(1);
    const core::Truth one = make(GetParam(), scene),
                      other = make(GetParam(), ContactScenes::moved(scene, s, a));
    EXPECT_LE(other.error.position, 1e-9);
    EXPECT_LE(other.error.velocity, 1e-9);
    ASSERT_EQ(one.events.size(), other.events.size());
    for (std::size_t k = 0; k < one.events.size(); ++k) {
      EXPECT_LE(std::abs(one.events[k].time - other.events[k].time), 2 * (one.error.time + other.error.time));
    }
    for (double t : {0.0, 0.37, 1.13, 2.91}) {
      core::State expected = one.state(t);
      for (core::BodyState& b : expected) {
        b = {s * b.position + a, s * b.orientation, s * b.velocity, s * b.angular_velocity};
      }
      expect_close(expected, other.state(t), other.error, 2, smooth_near(other, t, 1e-4));
    }
  }
}

// run(T1 + T2) = run(T2) after run(T1).
TEST_P(ContactLaws, flow) {
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    core::Scene scene = ContactScenes(seed).scene(GetParam());
    const core::Truth whole = make(GetParam(), scene);
    const core::State middle = whole.state(1.01);
    for (std::size_t i = 0; i < middle.size(); ++i) scene.bodies[i].initial = middle[i];
    const core::Truth rest = make(GetParam(), scene, horizon - 1.01);
    for (double t : {0.0, 0.7, 1.9}) {
      expect_close(whole.state(1.01 + t), rest.state(t), whole.error, 3, smooth_near(rest, t + 1e-4, 1e-4));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(all, ContactLaws,
                         testing::Values("sphere_two_walls", "sphere_row", "sliding_block", "rough_sphere"),
                         [](const auto& p) { return std::string(p.param); });

}  // namespace
}  // namespace cylon::exact
