// A sphere that strikes a box off its centre: the reference file, and for boxes in any position what the blow
// must keep, momentum and angular momentum, and with e = 1 energy.
#include "reference/exact/solutions.h"
#include "tests/paths.h"
#include "tests/reference/exact/random_scenes.h"
#include "tests/reference/exact/reference_file.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

core::Scene scene_of(const core::Vector3& half, double box_mass, double sphere_mass, double radius,
                     double e) {
  core::Scene scene;
  core::Body sphere, box;
  sphere.name = "sphere";
  sphere.mass = sphere_mass;
  sphere.shape = core::Sphere{radius};
  sphere.inertia = 0.4 * sphere_mass * radius * radius * core::Matrix3::Identity();
  box.name = "rod";
  box.mass = box_mass;
  box.shape = core::Box{half};
  const core::Vector3 square = half.cwiseProduct(half);
  box.inertia =
      box_mass / 3 *
      core::Vector3(square.y() + square.z(), square.x() + square.z(), square.x() + square.y()).asDiagonal();
  sphere.collide = box.collide = true;
  scene.bodies = {sphere, box};
  scene.materials = {{{"*", "*"}, e, 0}};
  return scene;
}

core::Scene from(const json& data) {
  const json& p = data["params"];
  core::Scene scene =
      scene_of(vector(p["half"]), number(p["mr"]), number(p["ms"]), number(p["r"]), number(p["e"]));
  scene.bodies[0].initial.position = vector(p["pS"]);
  scene.bodies[0].initial.velocity = vector(p["vS"]);
  return scene;
}

json reference() {
  std::ifstream in(std::string(source_dir) + "/tests/data/truth/rod_offcentre_hit.json");
  return json::parse(in);
}

// Towards a point on the box's surface, off its centre; the box in any position.
core::Scene random_scene(unsigned seed, double e) {
  RandomScenes random(seed);
  const core::Vector3 half = {random.between(0.1, 0.3), random.between(0.6, 1.2), random.between(0.2, 0.5)};
  core::Scene scene =
      scene_of(half, random.between(0.5, 3), random.between(0.5, 3), random.between(0.05, 0.2), e);
  core::BodyState &sphere = scene.bodies[0].initial, &box = scene.bodies[1].initial;
  const core::Vector3 drift = random.vector(1);
  box.position = random.vector(2);
  box.orientation = random.rotation();
  box.velocity = drift;
  const core::Vector3 aim =
      box.position + box.orientation * core::Vector3(0, half.y() * random.between(-0.9, 0.9),
                                                     half.z() * random.between(-0.9, 0.9));
  const core::Vector3 from =
      box.orientation * core::Vector3(2, random.between(-0.5, 0.5), random.between(-0.5, 0.5));
  sphere.position = aim + from;
  sphere.velocity = drift - random.between(2, 4) * from.normalized();
  sphere.angular_velocity = random.vector(5);
  scene.forces.emplace_back(core::UniformGravity{random.vector(10)});
  return scene;
}

void expect_bounded(const char* what, double difference, double bound) {
  fmt::print("rod_offcentre_hit {:20} difference {:8.1e}  bound {:8.1e}\n", what, difference, bound);
  EXPECT_LE(difference, 1e-13) << what;
  EXPECT_LE(difference, bound) << what;
  EXPECT_LE(bound, 2e-12) << what;
}

TEST(RodOffcentreHit, reference_file) {
  const json data = reference();
  const core::Scene scene = from(data);
  const double horizon = number(data["horizon"]);
  const core::Truth truth = rod_offcentre_hit(scene, horizon);
  const core::State end = truth.state(horizon);
  const json &hit = data["events"][0], &last = data["final_state_at_T"];
  ASSERT_EQ(truth.events.size(), 1u);
  expect_bounded("time", std::abs(truth.events[0].time - number(hit["t"])), truth.error.time);
  expect_bounded("sphere velocity", (end[0].velocity - vector(hit["sphere_velocity_after"])).norm(),
                 truth.error.velocity);
  expect_bounded("rod velocity", (end[1].velocity - vector(hit["rod_velocity_after"])).norm(),
                 truth.error.velocity);
  expect_bounded("rod spin", (end[1].angular_velocity - vector(last["rod_angular_velocity"])).norm(),
                 truth.error.angular_velocity);
  expect_bounded("sphere position", (end[0].position - vector(last["sphere_position"])).norm(),
                 truth.error.position);
  expect_bounded("rod position", (end[1].position - vector(last["rod_position"])).norm(),
                 truth.error.position);
  expect_bounded("rod orientation", angle_between(end[1].orientation, quaternion(last["rod_orientation"])),
                 truth.error.orientation);
}

TEST(RodOffcentreHit, impact_conserves_momenta) {
  const double horizon = 2;
  int hits = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const double e = seed % 2 ? 1 : 0.6;
    const core::Scene scene = random_scene(seed, e);
    core::Truth truth;
    try {
      truth = rod_offcentre_hit(scene, horizon);
    } catch (const core::OutOfDomain& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("touch again"), std::string::npos) << refusal.what();
      continue;
    }
    EXPECT_LE(truth.error.orientation, 1e-11);
    if (truth.events.empty()) continue;
    ++hits;
    const double t = truth.events[0].time, d = 1e-9;
    const core::State before = truth.state(t - d), after = truth.state(t + d), at = truth.state(t);
    core::Vector3 momentum(0, 0, 0), spin(0, 0, 0);
    double energy = 0;
    for (std::size_t i : {0u, 1u}) {
      const core::Body& body = scene.bodies[i];
      const auto l = [&](const core::BodyState& s) -> core::Vector3 {
        return body.mass * at[i].position.cross(s.velocity) +
               core::world_inertia(body, s.orientation) * s.angular_velocity;
      };
      const auto k = [&](const core::BodyState& s) {
        return body.mass * s.velocity.squaredNorm() / 2 +
               s.angular_velocity.dot(core::world_inertia(body, s.orientation) * s.angular_velocity) / 2;
      };
      momentum += body.mass * (after[i].velocity - before[i].velocity);
      spin += l(after[i]) - l(before[i]);
      energy += k(after[i]) - k(before[i]);
    }
    EXPECT_LE(momentum.norm(), 1e-6);
    EXPECT_LE(spin.norm(), 1e-6);
    if (e == 1) {
      EXPECT_NEAR(energy, 0, 1e-6);
    } else {
      EXPECT_LT(energy, -1e-3);
    }
    // The sphere touches the box, and its centre leaves the point it touched at e times the speed.
    const core::Vector3 half = std::get<core::Box>(scene.bodies[1].shape).half_extents;
    const core::Vector3 p = at[1].orientation.conjugate() * (at[0].position - at[1].position);
    const core::Vector3 x = p.cwiseMax(-half).cwiseMin(half);
    EXPECT_NEAR((p - x).norm(), std::get<core::Sphere>(scene.bodies[0].shape).radius, 1e-12);
    const core::Vector3 arm = at[1].orientation * x, n = at[1].orientation * (p - x).normalized();
    const auto rate = [&](const core::State& s) {
      return n.dot(s[0].velocity - s[1].velocity - s[1].angular_velocity.cross(arm));
    };
    EXPECT_NEAR(rate(after), -e * rate(before), 1e-6);
    EXPECT_NEAR(rate(after), truth.events[0].speed, 1e-6);
  }
  EXPECT_GE(hits, 4);
}

TEST(RodOffcentreHit, refusals) {
  const core::Scene good = from(reference());
  const auto refuses = [&](const std::string& reason, auto&& change, double horizon = 1) {
    core::Scene scene = good;
    change(scene);
    try {
      rod_offcentre_hit(scene, horizon);
      ADD_FAILURE() << "accepted: " << reason;
    } catch (const core::OutOfDomain& refusal) {
      EXPECT_EQ(std::string(refusal.what()).find("rod_offcentre_hit: "), 0u);
      EXPECT_NE(std::string(refusal.what()).find(reason), std::string::npos) << refusal.what();
    }
  };
  using S = core::Scene;
  refuses("two bodies", [](S& s) { s.bodies.pop_back(); });
  refuses("plane 'floor'", [](S& s) { s.planes.push_back({"floor", {0, 1, 0}, -9}); });
  refuses("does not collide", [](S& s) { s.bodies[0].collide = false; });
  refuses("turns before it is struck", [](S& s) { s.bodies[1].initial.angular_velocity = {0, 1, 0}; });
  refuses("neither a sphere nor a box", [](S& s) { s.bodies[0].shape = core::Capsule{0.1, 0.2}; });
  refuses("one sphere and one box", [](S& s) { s.bodies[1].shape = core::Sphere{0.3}; });
  refuses("friction of", [](S& s) { s.materials[0].friction = 0.1; });
  refuses("no material", [](S& s) { s.materials.clear(); });
  refuses("overlap", [](S& s) { s.bodies[0].initial.position = {0, 0, 0.15}; });
  refuses("may stay in touch", [](S& s) { s.materials[0].restitution = 0; });
  // The sphere follows nearly as fast as the rod flies, whose other end comes round after half a turn.
  refuses(
      "touch again", [](S& s) { s.bodies[0].mass = 1.5; }, 2);
  refuses("a joint", [](S& s) { s.joints.emplace_back(); });
}

}  // namespace
}  // namespace cylon::exact
