// Options of the in-house engine that change what a step costs: through its worker.
#include "tests/conformance/adapters_fixture.h"

namespace cylon::conformance {
namespace {

// Cubes a little out of line, dropped on each other and on a floor.
core::Scene cubes(int side, int layers) {
  core::Scene scene;
  scene.forces = {core::UniformGravity{}};
  scene.planes = {{"floor", Vector3::UnitY(), 0}};
  scene.materials = {{{"*", "*"}, 0, 0.5}};
  for (int i = 0; i < side * side * layers; ++i) {
    core::Body body;
    body.name = fmt::format("cube{}", i);
    body.shape = core::Box{{0.5, 0.5, 0.5}};
    body.mass = 1, body.inertia = core::Matrix3::Identity() / 6;
    body.collide = true;
    const int x = i % side, z = i / side % side, y = i / side / side;
    body.initial.position = {1.05 * x + 0.01 * (i * 7 % 11), 0.51 + 1.02 * y, 1.05 * z + 0.01 * (i * 5 % 13)};
    scene.bodies.push_back(body);
  }
  return scene;
}

core::Scene field(int count) {
  core::Scene scene;
  scene.forces = {core::UniformGravity{}};
  for (int i = 0; i < count; ++i) {
    core::Body body;
    body.name = fmt::format("body{}", i);
    body.mass = 1 + 0.1 * (i % 7);
    body.inertia = Vector3(0.1 + 0.01 * (i % 5), 0.2, 0.25).asDiagonal();
    body.initial.position = {0.1 * i, 0.2 * (i % 3), 0};
    body.initial.velocity = {1, 0.1 * (i % 11), 0.3};
    body.initial.angular_velocity = {2, 0.1 * (i % 13), -1};
    scene.bodies.push_back(body);
  }
  return scene;
}

bool same(const core::State& a, const core::State& b) {
  const auto same_body = [](const core::BodyState& x, const core::BodyState& y) {
    return x.position == y.position && x.orientation.coeffs() == y.orientation.coeffs() &&
           x.velocity == y.velocity && x.angular_velocity == y.angular_velocity;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_body);
}

core::State end(const std::string& id, const core::Scene& scene, int steps) {
  return last(process::parse_engine(id, process::default_engines(binary_dir)), scene, 1. / 60, steps);
}

TEST(InHouseOptions, ThreadsChangeNoBit) {
  const struct {
    const char* options;
    core::Scene scene;
  } rows[] = {{"/path=stepping", cubes(5, 4)}, {"/integrator=velocity-verlet", field(2000)}};
  for (const std::string engine : {"in-house", "in-house-float"})
    for (const auto& row : rows) {
      const core::State one = end(engine + row.options + ",threads=1", row.scene, 30);
      EXPECT_TRUE(same(one, end(engine + row.options + ",threads=4", row.scene, 30)))
          << engine << row.options;
      EXPECT_FALSE(same(one, end(engine + row.options, row.scene, 29)));
    }
}

// Columns of four that stand: asleep they keep their place to the bit, awake the solver moves them a little.
TEST(InHouseOptions, SleepingKeepsWhatRests) {
  core::Scene scene = cubes(5, 1);
  for (int k = 1; k < 4; ++k)
    for (int i = 0; i < 25; ++i) {
      core::Body body = scene.bodies[static_cast<std::size_t>(i)];
      body.name += fmt::format("-{}", k);
      body.initial.position.y() = 0.5 + k;
      scene.bodies.push_back(body);
    }
  for (int i = 0; i < 25; ++i) {
    scene.bodies[static_cast<std::size_t>(i)].initial.position.y() = 0.5;
    const int column = i % 5, row = i / 5;
    for (int k = 0; k < 4; ++k) {
      const int body = 25 * k + i;
      core::Vector3& place = scene.bodies[static_cast<std::size_t>(body)].initial.position;
      place.x() = 1.5 * column, place.z() = 1.5 * row;
    }
  }
  const std::string id = "in-house/path=stepping";
  EXPECT_TRUE(same(end(id, scene, 60), end(id, scene, 90)));
  EXPECT_TRUE(same(end(id, scene, 60), end(id + ",sleeping=on", scene, 60)));
  EXPECT_FALSE(same(end(id + ",sleeping=off", scene, 60), end(id + ",sleeping=off", scene, 90)));
}

// What is not as usual is among the settings.
TEST(InHouseOptions, AreTold) {
  const auto settings = [](const char* id) {
    const auto engine = process::parse_engine(id, process::default_engines(binary_dir));
    std::vector<std::string> told;
    for (const core::Setting& s : play(engine, field(3), 0.01, 1).terms.settings)
      if (s.name != "tolerance") told.push_back(s.name + " " + s.value + " " + s.engine_default);
    return told;
  };
  EXPECT_EQ(settings("in-house/threads=1,sweeps=10,sleeping=on"), (std::vector<std::string>{"sweeps 10 10"}));
  EXPECT_EQ(settings("in-house/threads=4,sleeping=off,model=full"),
            (std::vector<std::string>{"threads 4 1", "model full planned", "sleeping off on"}));
}

}  // namespace
}  // namespace cylon::conformance
