// Restitution belongs to a pair.  Engines combine numbers of single bodies; the adapters must get each pair's
// own value through, whatever the others are.
#include "tests/conformance/adapters_fixture.h"

#include <cmath>
#include <map>
#include <string_view>

namespace cylon::conformance {
namespace {

constexpr double dt = 1e-3, approach_speed = 2.0;

// Spheres "A" and "B" over two planes "P" and "Q" in general directions, without gravity and friction.
core::Scene court(const std::vector<core::Material>& materials) {
  const Quaternion turn = exact::RandomScenes(41).rotation();
  core::Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].name = "A", scene.bodies[1].name = "B";
  scene.bodies[0].mass = 1.3, scene.bodies[1].mass = 2.9;
  scene.bodies[0].shape = core::Sphere{0.3}, scene.bodies[1].shape = core::Sphere{0.45};
  for (core::Body& body : scene.bodies) {
    const double radius = std::get<core::Sphere>(body.shape).radius;
    body.inertia = 0.4 * body.mass * radius * radius * core::Matrix3::Identity();
    body.collide = true;
    body.initial.position = turn * Vector3(20, 30, body.name == "A" ? 3 : -4);  // out of the way
  }
  scene.planes = {{"P", turn * Vector3::UnitX(), 0.7}, {"Q", turn * Vector3::UnitY(), -1.1}};
  scene.materials = materials;
  return scene;
}

// Lets the pair meet after 10.37 steps, along the line of centres or the normal, and gives the speed at which
// they part over the speed at which they met, 400 steps later.
double restitution(const process::EngineChoice& engine, core::Scene scene, std::string_view pair) {
  const double gap = 10.37 * dt * approach_speed;
  core::Body& a = scene.bodies[pair[0] == 'A' ? 0 : 1];
  const double radius = std::get<core::Sphere>(a.shape).radius;
  Vector3 normal;
  core::Body* b = nullptr;
  if (pair[1] == 'B') {
    b = &scene.bodies[1];
    normal = Vector3(2, -3, 1.5).normalized();
    a.initial.position =
        b->initial.position + (radius + std::get<core::Sphere>(b->shape).radius + gap) * normal;
    b->initial.velocity = Vector3(0.3, -0.2, 0.5);
    a.initial.velocity = b->initial.velocity - approach_speed * normal;
  } else {
    const core::Plane& plane = scene.planes[pair[1] == 'P' ? 0 : 1];
    normal = plane.normal;
    a.initial.position += (plane.offset + radius + gap - normal.dot(a.initial.position)) * normal;
    const Vector3 sideways = normal.unitOrthogonal();
    a.initial.velocity = -approach_speed * normal + 0.9 * sideways;
  }
  const core::State end = last(engine, scene, dt, 410);
  const std::size_t i = pair[0] == 'A' ? 0 : 1;
  return normal.dot(end[i].velocity - (b ? end[1].velocity : Vector3::Zero())) / approach_speed;
}

struct Table {
  const char* name;
  std::vector<core::Material> materials;
  std::map<std::string, double> expected;
  bool combined = false;  // there are numbers of single bodies whose least, or largest, is that of each pair
};

// In "no product" e(AP) e(BQ) = 0.63 and e(AQ) e(BP) = 0.1: no numbers of single bodies multiply to these.
// The next two are one table in two orders: a row with both names wins over one with a "*", and that over
// two.
const Table tables[] = {
    {"no product",
     {{{"A", "P"}, 0.9, 0},
      {{"Q", "A"}, 0.2, 0},
      {{"B", "P"}, 0.5, 0},
      {{"B", "Q"}, 0.7, 0},
      {{"B", "A"}, 0.35, 0}},
     {{"AP", 0.9}, {"AQ", 0.2}, {"BP", 0.5}, {"BQ", 0.7}, {"AB", 0.35}}},
    {"wildcards, general first",
     {{{"*", "*"}, 0.2, 0}, {{"*", "A"}, 0.6, 0}, {{"P", "A"}, 0.9, 0}},
     {{"AP", 0.9}, {"AQ", 0.6}, {"BP", 0.2}, {"BQ", 0.2}, {"AB", 0.6}}},
    {"wildcards, general last",
     {{{"A", "P"}, 0.9, 0}, {{"A", "*"}, 0.6, 0}, {{"*", "*"}, 0.2, 0}},
     {{"AP", 0.9}, {"AQ", 0.6}, {"BP", 0.2}, {"BQ", 0.2}, {"AB", 0.6}}},
    {"extremes",
     {{{"A", "P"}, 0, 0}, {{"A", "Q"}, 0.5, 0}, {{"B", "P"}, 1, 0}, {{"B", "Q"}, 0, 0}, {{"A", "B"}, 1, 0}},
     {{"AP", 0}, {"AQ", 0.5}, {"BP", 1}, {"BQ", 0}, {"AB", 1}}},
    {"nothing bounces", {{{"*", "*"}, 0, 0}}, {{"AP", 0}, {"BQ", 0}, {"AB", 0}}, true},
    // The least of A 0.9, B 0.5, P 0.7 and Q 0.2; the largest of A 0.3, B 0.6, P 0.1 and Q 0.8.
    {"least",
     {{{"A", "P"}, 0.7, 0}, {{"*", "Q"}, 0.2, 0}, {{"B", "P"}, 0.5, 0}, {{"B", "A"}, 0.5, 0}},
     {{"AP", 0.7}, {"AQ", 0.2}, {"BP", 0.5}, {"BQ", 0.2}, {"AB", 0.5}},
     true},
    {"largest",
     {{{"A", "P"}, 0.3, 0}, {{"Q", "*"}, 0.8, 0}, {{"B", "*"}, 0.6, 0}, {{"B", "Q"}, 0.8, 0}},
     {{"AP", 0.3}, {"AQ", 0.8}, {"BP", 0.6}, {"BQ", 0.8}, {"AB", 0.6}},
     true},
};

class Materials : public EveryEngine {
 protected:
  bool bullet() const { return std::string_view(subject().id).starts_with("bullet"); }
  bool crashcat() const { return std::string_view(subject().id).starts_with("crashcat"); }
  bool is_dart() const { return std::string_view(subject().id) == "dart"; }
  bool ode() const { return std::string_view(subject().id).starts_with("ode"); }

  // The engine without its push out of penetration, a share erp of the depth in each step.
  process::EngineChoice without_push() const {
    process::EngineChoice engine = subject().choice();
    if (bullet()) engine.options["erp2"] = "0";
    if (ode()) engine.options["erp"] = "0";
    if (is_dart()) engine.options["contact-erp"] = "0";
    return engine;
  }

  // An engine that combines numbers of single bodies refuses a table that no such numbers give.
  bool refuses(const Table& table) const {
    if (subject().any_pair) return false;
    const core::Scene scene = court(table.materials);
    process::RunRequest request;
    request.scene = &scene, request.setup.dt = dt, request.steps = 1;
    const process::RunOutcome outcome = process::run(subject().choice(), request, limits);
    EXPECT_EQ(outcome.recording.has_value(), table.combined) << table.name << ": " << outcome.reason;
    return !outcome.recording;
  }

  // Rounding, and what an engine's own softness takes:
  //   ODE gives way by cfm lambda = cfm m u (1 + e)/dt, with cfm = 1e-10 and m <= 2.9 kg;
  //   DART's contacts have the softness 1e-5 of the inverse mass there: an impulse is smaller by that share;
  //   Bullet may stop a body at the surface, before it is through, at gap/dt, and the gap is rounded at 40 m.
  double accuracy(double e) const {
    const double softness = ode() ? 1.1 * 1e-10 * 2.9 * (1 + e) / dt : is_dart() ? 1e-5 * (1 + e) : 0;
    // A contact without bounce lets a body come to the plane: gap/dt, with the rounding of a gap of metres.
    const double stopping =
        (bullet() || crashcat()) && e == 0 ? subject().unit() * 40 / dt / approach_speed : 0;
    return 32 * subject().unit() + softness + stopping;
  }
};
std::vector<Subject> that_bounce() {
  std::vector<Subject> all(std::begin(subjects), std::end(subjects));
  std::erase_if(all, [](const Subject& subject) { return !subject.bounces; });
  return all;
}
INSTANTIATE_TEST_SUITE_P(Adapters, Materials, testing::ValuesIn(that_bounce()), test_name);
INSTANTIATE_TEST_SUITE_P(Dart, Materials, testing::Values(dart), test_name);

TEST_P(Materials, EveryPairHasItsOwnRestitution) {
  for (const Table& table : tables) {
    if (refuses(table)) continue;
    for (const auto& [pair, e] : table.expected)
      expect_within(fmt::format("restitution {} of {} in '{}', {}", e, pair, table.name, subject().id),
                    std::abs(restitution(without_push(), court(table.materials), pair) - e), accuracy(e));
  }
}

// With the settings that reports speak of.  The push parts at erp depth/dt, and depth <= u dt: at most erp =
// 0.2 where nothing bounces, and nothing where a bounce is faster than that; DART's is 1e-3 m/s at most, of 2 m/s.
TEST_P(Materials, OnlyPenetrationCorrectionAddsEnergy) {
  for (const Table& table : tables) {
    if (refuses(table)) continue;
    for (const auto& [pair, e] : table.expected)
      expect_within(
          fmt::format("restitution {} of {} in '{}', {} as shipped", e, pair, table.name, subject().id),
          std::abs(restitution(subject().choice(), court(table.materials), pair) - e),
          e == 0 && (bullet() || ode()) ? 0.2 : accuracy(e) + (e == 0 && is_dart() ? 5e-4 : 0));
  }
}

}  // namespace
}  // namespace cylon::conformance
