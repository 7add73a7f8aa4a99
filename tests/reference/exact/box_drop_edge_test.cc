// A box that falls on its edge: the reference file, other tilts and spins against what a blow keeps,
// refusals.
#include "reference/exact/solutions.h"
#include "tests/paths.h"
#include "tests/reference/exact/random_scenes.h"
#include "tests/reference/exact/reference_file.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

core::Scene scene_of(const core::Vector3& half, double mass, double tilt, double height, double e, double g) {
  core::Scene scene;
  core::Body box;
  box.name = "box";
  box.mass = mass;
  box.shape = core::Box{half};
  box.collide = true;
  const core::Vector3 square = half.cwiseProduct(half);
  box.inertia =
      mass / 3 *
      core::Vector3(square.y() + square.z(), square.x() + square.z(), square.x() + square.y()).asDiagonal();
  box.initial.position = {0, height, 0};
  box.initial.orientation = core::Quaternion(std::cos(tilt / 2), 0, 0, std::sin(tilt / 2));
  scene.bodies = {box};
  scene.planes = {{"floor", {0, 1, 0}, 0}};
  scene.materials = {{{"*", "*"}, e, 0}};
  scene.forces.emplace_back(core::UniformGravity{{0, -g, 0}});
  return scene;
}

json reference() {
  std::ifstream in(std::string(source_dir) + "/tests/data/truth/box_drop_edge.json");
  return json::parse(in);
}

core::Scene from(const json& data) {
  const json& p = data["params"];
  return scene_of(vector(p["half"]), number(p["m"]), number(p["tilt"]) * 3.14159265358979323846 / 180,
                  number(p["y0"]), number(p["e"]), number(p["g"]));
}

void expect_bounded(const char* what, double difference, double bound, double size) {
  fmt::print("box_drop_edge {:20} difference {:8.1e}  bound {:8.1e}\n", what, difference, bound);
  EXPECT_LE(difference, 1e-13 * size) << what;
  EXPECT_LE(difference, bound) << what;
  EXPECT_LE(bound, 2e-12 * size) << what;
}

TEST(BoxDropEdge, reference_file) {
  const json data = reference();
  const double horizon = 0.6;
  const core::Truth truth = box_drop_edge(from(data), horizon);
  const json& hit = data["events"][0];
  const double t = number(hit["t"]), g = number(data["params"]["g"]);
  ASSERT_EQ(truth.events.size(), 1u);
  expect_bounded("time", std::abs(truth.events[0].time - t), truth.error.time, 1);
  const core::BodyState s = truth.state(horizon)[0];
  expect_bounded("velocity", std::abs(s.velocity.y() - (number(hit["vy_after"]) - g * (horizon - t))),
                 truth.error.velocity, 5);
  expect_bounded("spin", std::abs(s.angular_velocity.z() - number(hit["wz_after"])),
                 truth.error.angular_velocity, 12);
  const double angle = number(hit["angle"]) + number(hit["wz_after"]) * (horizon - t);
  expect_bounded(
      "orientation",
      angle_between(s.orientation, core::Quaternion(std::cos(angle / 2), 0, 0, std::sin(angle / 2))),
      truth.error.orientation, 1);
  const double y = number(data["params"]["y0"]) - g * t * t / 2 + number(hit["vy_after"]) * (horizon - t) -
                   g * (horizon - t) * (horizon - t) / 2;
  expect_bounded("position", std::abs(s.position.y() - y), truth.error.position, 2);
}

// As the refusal of a horizon beyond it says, to a microsecond.
double second_contact(const core::Scene& scene) {
  try {
    box_drop_edge(scene, 5);
  } catch (const core::OutOfDomain& refusal) {
    const std::string text = refusal.what();
    const std::size_t at = text.find("second contact, at ");
    if (at != std::string::npos) return std::stod(text.substr(at + 19));
  }
  throw std::runtime_error("no second contact in 5 s");
}

// E and the angular momentum about the edge: kept with e = 1, and always.
TEST(BoxDropEdge, impact_conserves_momenta) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    RandomScenes random(seed);
    const double e = seed % 2 ? 1 : 0.4;
    core::Scene scene =
        scene_of({random.between(0.2, 0.6), random.between(0.2, 0.6), random.between(0.2, 0.6)},
                 random.between(0.5, 3), random.between(0.2, 1.3), random.between(1.5, 3), e, 9.81);
    scene.bodies[0].initial.angular_velocity = {0, 0, random.between(-3, 3)};
    scene.bodies[0].initial.velocity = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const core::Quaternion turn = random.rotation();
    for (core::Body& b : scene.bodies) {
      b.initial = {turn * b.initial.position, (turn * b.initial.orientation).normalized(),
                   turn * b.initial.velocity, turn * b.initial.angular_velocity};
    }
    scene.planes[0].normal = turn * scene.planes[0].normal;
    scene.forces = {core::UniformGravity{turn * core::Vector3(0, -9.81, 0)}};
    const core::Truth truth = box_drop_edge(scene, second_contact(scene) - 1e-5);
    ASSERT_EQ(truth.events.size(), 1u);
    const core::Body& body = scene.bodies[0];
    const double t = truth.events[0].time, d = 1e-9;
    const core::BodyState before = truth.state(t - d)[0], at = truth.state(t)[0],
                          after = truth.state(t + d)[0];
    const core::Vector3 n = scene.planes[0].normal;
    core::Vector3 arm(0, 0, 0);  // to the middle of the lowest edge
    for (int j = 0; j < 8; ++j) {
      const core::Vector3 half = std::get<core::Box>(body.shape).half_extents;
      const core::Vector3 corner(j & 1 ? half.x() : -half.x(), j & 2 ? half.y() : -half.y(),
                                 j & 4 ? half.z() : -half.z());
      const core::Vector3 c = at.orientation * corner;
      EXPECT_GE(n.dot(at.position + c), -1e-12);
      if (n.dot(at.position + c) < 1e-9) arm += c / 2;
    }
    EXPECT_NEAR(n.dot(at.position + arm), 0, 1e-12);
    const auto rate = [&](const core::BodyState& s) {
      return n.dot(s.velocity + s.angular_velocity.cross(arm));
    };
    EXPECT_NEAR(rate(after), -e * rate(before), 1e-6);
    EXPECT_NEAR(rate(after), truth.events[0].speed, 1e-6);
    const auto spin = [&](const core::BodyState& s) -> core::Vector3 {
      return core::world_inertia(body, s.orientation) * s.angular_velocity -
             body.mass * arm.cross(s.velocity);
    };
    EXPECT_LE((spin(after) - spin(before)).norm(), 1e-6);
    const auto energy = [&](const core::BodyState& s) {
      return (body.mass * s.velocity.squaredNorm() +
              s.angular_velocity.dot(core::world_inertia(body, s.orientation) * s.angular_velocity)) /
             2;
    };
    if (e == 1) {
      EXPECT_NEAR(energy(after), energy(before), 1e-5);
    } else {
      EXPECT_LT(energy(after), energy(before) - 1e-2);
    }
  }
}

TEST(BoxDropEdge, refusals) {
  const core::Scene good = from(reference());
  const auto refuses = [&](const std::string& reason, auto&& change, double horizon = 0.6) {
    core::Scene scene = good;
    change(scene);
    try {
      box_drop_edge(scene, horizon);
      ADD_FAILURE() << "accepted: " << reason;
    } catch (const core::OutOfDomain& refusal) {
      EXPECT_EQ(std::string(refusal.what()).find("box_drop_edge: "), 0u);
      EXPECT_NE(std::string(refusal.what()).find(reason), std::string::npos) << refusal.what();
    }
  };
  using S = core::Scene;
  refuses("one body and one plane", [](S& s) { s.planes.clear(); });
  refuses("is not a box", [](S& s) { s.bodies[0].shape = core::Sphere{0.3}; });
  refuses("friction of", [](S& s) { s.materials[0].friction = 0.1; });
  refuses("gravity does not point into", [](S& s) { s.forces.clear(); });
  refuses("no edge is parallel",
          [](S& s) { s.bodies[0].initial.orientation = core::Quaternion(0.9, 0.2, 0.3, 0.1).normalized(); });
  refuses("does not turn about that edge", [](S& s) { s.bodies[0].initial.angular_velocity = {1, 0, 0}; });
  refuses("principal axis", [](S& s) { s.bodies[0].inertia(0, 2) = s.bodies[0].inertia(2, 0) = 0.01; });
  refuses("does not start above", [](S& s) { s.bodies[0].initial.position.y() = 0.3; });
  refuses("two edges land at once",
          [](S& s) { s.bodies[0].initial.orientation = core::Quaternion::Identity(); });
  refuses("restitution 0", [](S& s) { s.materials[0].restitution = 0; });
  refuses(
      "second contact", [](S&) {}, 2);
}

}  // namespace
}  // namespace cylon::exact
