// The solutions with contacts against reference files that hold cases and events in place of trajectories.
#include "reference/exact/catalogue.h"
#include "tests/paths.h"
#include "tests/reference/exact/reference_file.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

core::Truth make(std::string_view name, const core::Scene& scene, double horizon) {
  for (const Solution& solution : catalogue()) {
    if (solution.name == name) return solution.make(scene, horizon);
  }
  throw std::runtime_error("no solution " + std::string(name));
}

json read(const std::string& name) {
  std::ifstream in(std::string(source_dir) + "/tests/data/truth/" + name + ".json");
  return json::parse(in);
}

core::Body ball(const std::string& name, double mass, double radius, const core::Vector3& position,
                const core::Vector3& velocity) {
  core::Body b;
  b.name = name;
  b.mass = mass;
  b.inertia = 0.4 * mass * radius * radius * core::Matrix3::Identity();
  b.shape = core::Sphere{radius};
  b.collide = true;
  b.initial.position = position;
  b.initial.velocity = velocity;
  return b;
}

// |difference| <= 1e-13 of the size, and <= the stated bound, which is no larger than 1e-12 of the size.
void expect_bounded(const std::string& what, double difference, double bound, double size) {
  fmt::print("{:40} difference {:8.1e}  bound {:8.1e}  ratio {:.3f}\n", what, difference, bound,
             bound > 0 ? difference / bound : 0);
  EXPECT_LE(difference, 1e-13 * std::max(1.0, size)) << what;
  EXPECT_LE(difference, bound) << what << ": the stated bound does not hold";
  EXPECT_LE(bound, 1e-12 * std::max(1.0, size)) << what << ": the stated bound is loose";
}

TEST(ContactFiles, sphere_two_walls_events) {
  const ReferenceFile file("sphere_two_walls");
  const core::Truth truth = make("sphere_two_walls", file.scene, file.horizon);
  const json& events = file.data["events"];
  ASSERT_EQ(truth.events.size(), events.size());
  double worst = 0;
  for (std::size_t k = 0; k < events.size(); ++k) {
    const core::Event& e = truth.events[k];
    worst = std::max(worst, std::abs(e.time - number(events[k]["t"])));
    EXPECT_EQ(e.pair, (core::Pair{0, core::world, events[k]["wall"] == "+x" ? 0 : 1}));
    EXPECT_EQ(e.index, static_cast<int>(k) / 2 + 1);
    EXPECT_NEAR(e.speed, std::abs(number(events[k]["vx_after"])), 1e-13);
  }
  expect_bounded("sphere_two_walls event time", worst, truth.error.time, file.horizon);
}

TEST(ContactFiles, slide_to_roll_event) {
  const ReferenceFile file("slide_to_roll");
  const core::Truth truth = make("slide_to_roll", file.scene, file.horizon);
  ASSERT_EQ(truth.events.size(), 1u);
  EXPECT_EQ(truth.events[0].kind, core::EventKind::roll);
  const json& end = file.data["events"][0];
  expect_bounded("slide_to_roll end of slip", std::abs(truth.events[0].time - number(end["t"])),
                 truth.error.time, 1);
  const core::BodyState s = truth.state(truth.events[0].time)[0];
  expect_bounded("slide_to_roll position there", (s.position - vector(end["position"])).norm(),
                 truth.error.position + s.velocity.norm() * truth.error.time, 2);
}

TEST(ContactFiles, two_sphere_head_on) {
  const json data = read("two_sphere_head_on");
  const json& p = data["params"];
  for (const json& impact : data["events"]) {
    core::Scene scene;
    scene.bodies = {
        ball("A", number(p["mA"]), number(p["rA"]), {number(p["xA"]), 0, 0}, {number(p["vA"]), 0, 0}),
        ball("B", number(p["mB"]), number(p["rB"]), {number(p["xB"]), 0, 0}, {number(p["vB"]), 0, 0})};
    const double e = number(impact["restitution"]), t = number(impact["t"]), horizon = 2;
    scene.materials = {{{"A", "B"}, e, 0}};
    const core::Truth truth = make("two_sphere_head_on", scene, horizon);
    const core::State end = truth.state(horizon);
    const std::string what = fmt::format("two_sphere_head_on e = {}", e);
    const double va = number(impact["vA_after"]), vb = number(impact["vB_after"]);
    expect_bounded(what + " velocity",
                   std::max(std::abs(end[0].velocity.x() - va), std::abs(end[1].velocity.x() - vb)),
                   truth.error.velocity, 4);
    const double xa = number(p["xA"]) + number(p["vA"]) * t + va * (horizon - t);
    expect_bounded(what + " position", std::abs(end[0].position.x() - xa), truth.error.position, 6);
    ASSERT_EQ(truth.events.size(), e > 0 ? 1u : 0u);
    if (e == 0) continue;
    expect_bounded(what + " time", std::abs(truth.events[0].time - t), truth.error.time, 1);
    EXPECT_NEAR(truth.events[0].speed, vb - va, 1e-13 * 8);
  }
}

// Touching: k balls come with speed v and k leave with it, in the order of impacts that a small gap has.
TEST(ContactFiles, newtons_cradle) {
  const json data = read("newtons_cradle");
  const double r = number(data["params"]["r"]), m = number(data["params"]["m"]);
  for (const json& cradle : data["events"]) {
    const int incoming = cradle["balls_incoming"];
    core::Scene scene;
    for (int i = 0; i < 5; ++i) {
      const bool moves = i < incoming;
      scene.bodies.push_back(ball(fmt::format("ball{}", i), m, r, {2 * r * i - (moves ? 1.5 : 0), 0, 0},
                                  {moves ? number(cradle["v"]) : 0, 0, 0}));
    }
    scene.materials = {{{"*", "*"}, number(cradle["restitution"]), 0}};
    const core::Truth truth = make("newtons_cradle", scene, 4);
    double worst = 0;
    for (int i = 0; i < 5; ++i) {
      const double v = number(cradle["final_vx"][static_cast<std::size_t>(i)]);
      worst = std::max(worst, std::abs(truth.state(4)[static_cast<std::size_t>(i)].velocity.x() - v));
    }
    expect_bounded(fmt::format("newtons_cradle {} incoming velocity", incoming), worst, truth.error.velocity,
                   1);
    EXPECT_EQ(truth.events.size(), static_cast<std::size_t>(cradle["pair_collisions"]));
  }
}

TEST(ContactFiles, newtons_cradle_gapped) {
  const json data = read("newtons_cradle");
  const json& gapped = data["gapped"];
  const double r = number(data["params"]["r"]), m = number(data["params"]["m"]),
               horizon = number(gapped["T"]);
  core::Scene scene;
  for (std::size_t i = 0; i < 5; ++i) {
    scene.bodies.push_back(ball(fmt::format("ball{}", i), m, r, {number(gapped["positions0_x"][i]), 0, 0},
                                {i == 0 ? number(gapped["v"]) : 0, 0, 0}));
  }
  scene.materials = {{{"*", "*"}, number(gapped["e"]), 0}};
  const core::Truth truth = make("newtons_cradle_gapped", scene, horizon);
  double position = 0, velocity = 0, time = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const core::BodyState s = truth.state(horizon)[i];
    position = std::max(position, std::abs(s.position.x() - number(gapped["final_x_at_T"][i])));
    velocity = std::max(velocity, std::abs(s.velocity.x() - number(gapped["final_vx"][i])));
  }
  const json& collisions = gapped["collisions"];
  ASSERT_EQ(truth.events.size(), collisions.size());
  for (std::size_t k = 0; k < collisions.size(); ++k) {
    time = std::max(time, std::abs(truth.events[k].time - number(collisions[k]["t"])));
    EXPECT_EQ(truth.events[k].pair.body, collisions[k]["pair"][0]);
    EXPECT_EQ(truth.events[k].pair.other, collisions[k]["pair"][1]);
  }
  expect_bounded("newtons_cradle_gapped position", position, truth.error.position, 6.5);
  expect_bounded("newtons_cradle_gapped velocity", velocity, truth.error.velocity, 1);
  expect_bounded("newtons_cradle_gapped time", time, truth.error.time, 3);
}

// The direction down a slope of theta degrees about z, its normal, and the turn of a box that lies on it.
struct Slope {
  core::Vector3 down, normal;
  core::Quaternion turn;

  explicit Slope(const json& degrees) {
    const double th = number(degrees) * 3.14159265358979323846 / 180;
    down = {std::cos(th), -std::sin(th), 0};
    normal = {std::sin(th), std::cos(th), 0};
    turn = core::Quaternion(std::cos(th / 2), 0, 0, -std::sin(th / 2));
  }
};

TEST(ContactFiles, block_on_incline) {
  const json data = read("block_on_incline");
  const core::Vector3 half = vector(data["params"]["half_extents"]);
  for (const json& block : data["cases"]) {
    const Slope slope(block["theta"]);
    const double horizon = number(block["T"]);
    core::Scene scene;
    core::Body body = ball("block", 1, 1, half.y() * slope.normal, number(block["v0"]) * slope.down);
    body.shape = core::Box{half};
    body.initial.orientation = slope.turn;
    scene.bodies = {body};
    scene.planes = {{"incline", slope.normal, 0}};
    scene.materials = {{{"*", "*"}, 0, number(block["mu"])}};
    scene.forces.emplace_back(core::UniformGravity{{0, -number(data["params"]["g"]), 0}});
    const core::Truth truth = make("sliding_block", scene, horizon);
    double position = 0, velocity = 0, size = 0, speed = 0;
    for (std::size_t k = 0; k < block["t"].size(); ++k) {
      const core::BodyState s = truth.state(number(block["t"][k]))[0];
      const double path = number(block["s"][k]), v = number(block["v"][k]);
      position = std::max(position, (s.position - body.initial.position - path * slope.down).norm());
      velocity = std::max(velocity, (s.velocity - v * slope.down).norm());
      size = std::max(size, std::abs(path)), speed = std::max(speed, std::abs(v));
      EXPECT_EQ(angle_between(s.orientation, slope.turn), 0);
    }
    const std::string what = fmt::format("block v0 {} mu {}", number(block["v0"]), number(block["mu"]));
    expect_bounded(what + " position", position, truth.error.position, size);
    expect_bounded(what + " velocity", velocity, truth.error.velocity, speed);
  }
}

// tan(theta) = 3/4: friction holds from 0.75 on, the bound included, where no rounding may be fatal.
TEST(ContactFiles, block_at_the_threshold) {
  for (const double mu : {0.7425, 0.75, 0.7575}) {
    core::Scene scene;
    core::Body body = ball("block", 1, 1, {0.06, 0.08, 0}, {0, 0, 0});
    body.shape = core::Box{{0.5, 0.1, 0.5}};
    body.initial.orientation = core::Quaternion(std::sqrt(0.9), 0, 0, -std::sqrt(0.1));
    scene.bodies = {body};
    scene.planes = {{"incline", {0.6, 0.8, 0}, 0}};
    scene.materials = {{{"*", "*"}, 0, mu}};
    scene.forces.emplace_back(core::UniformGravity{});
    const core::Truth truth = make("block_sticks", scene, 4);
    const double path = std::max(0.0, 9.81 * (0.6 - 0.8 * mu) * 8);
    const core::Vector3 moved = truth.state(4)[0].position - body.initial.position;
    expect_bounded(fmt::format("block at the threshold, mu {}", mu),
                   (moved - path * core::Vector3(0.8, -0.6, 0)).norm(), truth.error.position, 1);
  }
}

TEST(ContactFiles, rolling_sphere_incline) {
  const json data = read("rolling_sphere_incline");
  for (const json& roll : data["cases"]) {
    const Slope slope(roll["theta"]);
    const double horizon = number(roll["T"]), r = number(roll["r"]);
    core::Scene scene;
    scene.bodies = {ball("ball", 1, r, r * slope.normal, {0, 0, 0})};
    scene.planes = {{"incline", slope.normal, 0}};
    scene.materials = {{{"*", "*"}, 0, number(roll["mu"])}};
    scene.forces.emplace_back(core::UniformGravity{{0, -number(data["params"]["g"]), 0}});
    const core::Truth truth = make("rough_sphere", scene, horizon);
    double position = 0, velocity = 0, angle = 0, size = 0, speed = 0, turned = 0;
    for (std::size_t k = 0; k < roll["t"].size(); ++k) {
      const core::BodyState s = truth.state(number(roll["t"][k]))[0];
      const double path = number(roll["s"][k]), v = number(roll["v"][k]), a = number(roll["angle"][k]);
      position = std::max(position, (s.position - (r * slope.normal + path * slope.down)).norm());
      velocity = std::max(velocity, (s.velocity - v * slope.down).norm());
      const core::Quaternion q(std::cos(a / 2), 0, 0, -std::sin(a / 2));
      angle = std::max(angle, angle_between(s.orientation, q));
      size = std::max(size, path), speed = std::max(speed, v), turned = std::max(turned, a);
    }
    const std::string what = fmt::format("incline mu {}", number(roll["mu"]));
    expect_bounded(what + " position", position, truth.error.position, size);
    expect_bounded(what + " velocity", velocity, truth.error.velocity, speed);
    expect_bounded(what + " orientation", angle, truth.error.orientation, turned);
  }
}

TEST(ContactFiles, rough_ball_bounce) {
  const json data = read("rough_ball_bounce");
  const double m = number(data["params"]["m"]), r = number(data["params"]["r"]);
  for (const json& impact : data["events"]) {
    core::Scene scene;
    const core::Vector3 v = vector(impact["velocity_before"]);
    scene.bodies = {ball("ball", m, r, {0.3, r - v.y() / 4, -0.7}, v)};  // a quarter of a second away
    scene.bodies[0].initial.angular_velocity = vector(impact["angular_velocity_before"]);
    scene.planes = {{"floor", {0, 1, 0}, 0}};
    scene.materials = {{{"*", "*"}, number(impact["restitution"]), number(impact["mu"])}};
    const core::Truth truth = make("rough_ball_bounce", scene, 1);
    const core::BodyState s = truth.state(0.9)[0];
    const std::string what = fmt::format("rough_ball_bounce mu {} ", number(impact["mu"]));
    expect_bounded(what + "velocity", (s.velocity - vector(impact["velocity_after"])).norm(),
                   truth.error.velocity, v.norm());
    expect_bounded(what + "spin", (s.angular_velocity - vector(impact["angular_velocity_after"])).norm(),
                   truth.error.angular_velocity, 10);
    ASSERT_EQ(truth.events.size(), 1u);
    expect_bounded(what + "time", std::abs(truth.events[0].time - 0.25), truth.error.time, 1);
  }
}

}  // namespace
}  // namespace cylon::exact
