// Groups and masks reach every engine: what they keep apart goes through each other as if it were bare, what they let
// touch meets, and the rule asks for both masks.
#include "harness/core/collision_filter.h"
#include "tests/conformance/adapters_fixture.h"

namespace cylon::conformance {
namespace {

using Names = std::vector<std::string>;

class Filters : public EveryEngine {
 protected:
  // By the engine's own choice of an integrator: two boxes that may meet go in steps of the in-house engine's own.
  process::EngineChoice choice() const {
    const std::string id = subject().id;
    return process::parse_engine(id.substr(0, id.find('/')), process::default_engines(binary_dir));
  }
};
std::vector<Subject> that_touch() {
  std::vector<Subject> all(std::begin(subjects), std::end(subjects));
  std::erase_if(all, [](const Subject& subject) { return !subject.touches; });
  return all;
}
INSTANTIATE_TEST_SUITE_P(Adapters, Filters, testing::ValuesIn(that_touch()), test_name);

struct Rule {
  const char* name;
  Names groups, mask, other_groups, other_mask;
  bool touch;
};

const Rule rules[] = {
    {"groups without masks", {"x"}, {}, {"y"}, {}, true},
    {"both masks", {"x"}, {"y"}, {"y"}, {"x"}, true},
    {"the first mask alone", {"x"}, {"y"}, {"y"}, {"y"}, false},
    {"the second mask alone", {"x"}, {"x"}, {"y"}, {"x"}, false},
    {"neither", {"x"}, {"x"}, {"y"}, {"y"}, false},
    {"default", {}, {"y"}, {"y"}, {"default"}, true},
};

// A ball or box that flies at another, which may be locked, or at a plane.
core::Scene flying_at(const core::Shape& shape, bool locked, bool plane, double restitution) {
  core::Scene scene = three_bodies(41);
  scene.bodies.resize(plane ? 1 : 2);
  const Vector3 way = Vector3(0.3, -0.8, 0.5).normalized();
  for (core::Body& body : scene.bodies) body.shape = shape, body.collide = true;
  core::Body& first = scene.bodies[0];
  first.initial.velocity = 3 * way, first.initial.angular_velocity = Vector3::Zero();
  if (plane) {
    scene.planes = {{"wall", -way, -way.dot(first.initial.position) - 1}};
  } else {
    core::BodyState& other = scene.bodies[1].initial;
    other.position = first.initial.position + 1.2 * way;
    other.velocity = other.angular_velocity = Vector3::Zero();
    scene.bodies[1].locked = locked;
  }
  scene.materials = {{{"*", "*"}, restitution, 0.2}};
  scene.forces.emplace_back(core::UniformGravity{{0.1, -0.4, 0.2}});
  return scene;
}

TEST_P(Filters, DecideWhoTouches) {
  for (const core::Shape& shape : {core::Shape(core::Sphere{0.2}), core::Shape(core::Box{{0.2, 0.15, 0.1}})})
    for (const int kind : {0, 1, 2}) {  // two that move, one locked, a plane
      const core::Scene scene = flying_at(shape, kind == 1, kind == 2, pair_restitution());
      core::Scene bare = scene;
      for (core::Body& body : bare.bodies) body.collide = false;
      const core::State free = last(choice(), bare, 1. / 512, 400);
      for (const Rule& rule : rules) {
        core::Scene filtered = scene;
        filtered.bodies[0].collision_groups = rule.groups, filtered.bodies[0].collision_mask = rule.mask;
        const auto state = [&](auto& other) {
          other.collision_groups = rule.other_groups, other.collision_mask = rule.other_mask;
        };
        kind == 2 ? state(filtered.planes[0]) : state(filtered.bodies[1]);
        const core::State end = last(choice(), filtered, 1. / 512, 400);
        const double off = difference(end, free);
        if (rule.touch)
          EXPECT_GT(off, 0.1) << rule.name << ", kind " << kind;
        else
          EXPECT_EQ(off, 0) << rule.name << ", kind " << kind;
      }
    }
}

// Two bodies on a joint, one of which a third strikes through the other.
TEST_P(Filters, HoldInMechanisms) {
  core::Scene scene = three_bodies(43);
  for (core::Body& body : scene.bodies) {
    body.shape = core::Sphere{0.3}, body.collide = true;
    body.initial.velocity = body.initial.angular_velocity = Vector3::Zero();
  }
  scene.bodies[0].initial.position = {0, 0, 0}, scene.bodies[1].initial.position = {1, 0.1, 0};
  scene.bodies[2].initial.position = {-1.5, 0, 0.05}, scene.bodies[2].initial.velocity = {4, 0, 0};
  scene.joints = {{.body = 1, .to = 0, .point = {0.5, 0.2, 0.1}}};
  scene.materials = {{{"*", "*"}, pair_restitution(), 0}};
  scene.bodies[0].collision_groups = {"near"}, scene.bodies[1].collision_groups = {"far"};
  scene.bodies[2].collision_mask = {"near", "far", "default"};
  const core::State both = last(choice(), scene, 1. / 512, 250);
  EXPECT_LT(both[2].velocity.x(), 2) << "struck the first";
  scene.bodies[2].collision_mask = {"far"};
  const core::State one = last(choice(), scene, 1. / 512, 250);
  EXPECT_GT((one[2].position - both[2].position).norm(), 0.1);
  EXPECT_LT(one[2].velocity.x(), 3.5) << "struck the second";
  scene.bodies[2].collision_groups = {"ghost"}, scene.bodies[2].collision_mask = {"ghost"};
  const core::State none = last(choice(), scene, 1. / 512, 250);
  EXPECT_EQ(none[2].velocity, scene.bodies[2].initial.velocity);
  EXPECT_LE(difference({none[0], none[1]}, {scene.bodies[0].initial, scene.bodies[1].initial}),
            256 * subject().unit());
}

// The last of the groups that there may be is one as the others are.
TEST_P(Filters, KnowEveryGroup) {
  core::Scene scene = flying_at(core::Sphere{0.2}, false, false, pair_restitution());
  const std::string highest = "g" + std::to_string(core::most_groups - 1);
  for (std::size_t i = 1; i < core::most_groups; ++i)
    scene.bodies[1].collision_groups.push_back("g" + std::to_string(i));
  scene.bodies[0].collision_mask = {highest};
  core::Scene apart = scene;
  apart.bodies[1].collision_groups.pop_back();
  EXPECT_GT(difference(last(choice(), scene, 1. / 512, 400), last(choice(), apart, 1. / 512, 400)), 0.1);
}

}  // namespace
}  // namespace cylon::conformance
