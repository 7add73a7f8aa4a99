// The table of C functions as a Simulator: what it hands over, what it refuses for an engine, what it says of a bad table.
#include "cylon/c_engine.h"

#include "cylon/worker.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace cylon::worker {
namespace {

using core::Scene;
using core::Vector3;

// Remembers what it got, and answers with what it is told to.
struct Fake {
  const cylon_scene* scene = nullptr;
  double dt = 0;
  int steps = 0;
  const char* refusal = nullptr;
};
Fake& fake(void* self) { return *static_cast<Fake*>(self); }

constexpr std::uint32_t everything = CYLON_ROTATION | CYLON_CONTACTS | CYLON_SPRINGS | CYLON_DRAGS |
                                     CYLON_DRIVES | CYLON_ATTRACTIONS | CYLON_JOINTS;

cylon_engine table(Fake& of, std::uint32_t takes = everything) {
  return {.version = CYLON_ENGINE_VERSION,
          .takes = takes,
          .name = "fake",
          .engine_version = "7",
          .precision = "float",
          .integrator = "leapfrog",
          .order = 2,
          .conserves = nullptr,
          .self = &of,
          .load =
              [](void* self, const cylon_scene* scene, double dt) {
                fake(self).scene = scene, fake(self).dt = dt;
                return fake(self).refusal;
              },
          .step = [](void* self) { ++fake(self).steps; },
          .read =
              [](void* self, cylon_state* states) {
                for (std::size_t i = 0; i < fake(self).scene->bodies; ++i)
                  states[i] = fake(self).scene->body[i].initial;
              }};
}

core::Body body(const char* name, const Vector3& at) {
  core::Body made;
  made.name = name;
  made.mass = 1.7;
  made.inertia << 0.4, 0.01, -0.02, 0.01, 0.5, 0.03, -0.02, 0.03, 0.6;
  made.initial = {at, core::Quaternion(0.5, 0.1, -0.7, 0.5).normalized(), {0.3, -0.2, 0.9}, {0, 0, 0}};
  return made;
}

Scene still() {
  Scene scene;
  scene.bodies = {body("a", {0.1, 0.2, 0.3}), body("b", {3.1, 0.4, -0.6})};
  scene.forces = {core::UniformGravity{{0.1, -9.7, 0.2}}};
  return scene;
}

Scene with(const std::function<void(Scene&)>& change) {
  Scene scene = still();
  change(scene);
  return scene;
}

void collide(Scene& scene, const core::Shape& shape) {
  for (core::Body& b : scene.bodies) b.shape = shape, b.collide = true;
  scene.planes = {{.name = "floor", .normal = {0.6, 0.8, 0}, .offset = -2.5}};
  scene.materials = {{{"*", "*"}, 0.3, 0.4}, {{"a", "b"}, 0.7, 0.1}};
}

const Scene springs = with([](Scene& s) {
  s.forces.emplace_back(core::Spring{.to = 1, .stiffness = 12, .rest_length = 2, .damping = 0.3});
});
const Scene anchored = with([](Scene& s) {
  s.forces.emplace_back(core::Spring{.anchor = {0, 0.1, 0}, .stiffness = 12});
});
const Scene rod =
    with([](Scene& s) { s.joints = {{.type = core::JointType::distance, .body = 0, .to = 1, .length = 3}}; });
const Scene hinge = with([](Scene& s) {
  s.joints = {{.type = core::JointType::hinge, .body = 1, .point = {1, 2, 3}, .axis = {0.6, 0, 0.8}}};
});
const Scene boxes = with([](Scene& s) { collide(s, core::Box{{0.1, 0.2, 0.3}}); });
const Scene spinning = with([](Scene& s) { s.bodies[1].initial.angular_velocity = {0.1, 0, 0}; });

struct Refusal {
  const char* what;
  Scene scene;
  std::uint32_t takes;
  const char* reason;  // nullptr: taken
};
const Refusal refusals[] = {
    {"gravity alone", still(), 0, nullptr},
    {"a spring between centres", springs, CYLON_SPRINGS, nullptr},
    {"a spring", springs, CYLON_ROTATION | CYLON_JOINTS, "the engine does not take springs"},
    {"a spring beside the centre", anchored, CYLON_SPRINGS, "the engine does not take rotation"},
    {"both", anchored, CYLON_SPRINGS | CYLON_ROTATION, nullptr},
    {"spin", spinning, everything & ~std::uint32_t{CYLON_ROTATION}, "the engine does not take rotation"},
    {"spin of a locked body", with([](Scene& s) { s = spinning, s.bodies[1].locked = true; }), 0, nullptr},
    {"a rod between centres", rod, CYLON_JOINTS, nullptr},
    {"a hinge", hinge, CYLON_JOINTS, "the engine does not take rotation"},
    {"joints", hinge, CYLON_ROTATION, "the engine does not take joints"},
    {"contacts", boxes, everything & ~std::uint32_t{CYLON_CONTACTS}, "the engine does not take contacts"},
    {"drag", with([](Scene& s) { s.forces.emplace_back(core::Drag{.linear = 1}); }), 0,
     "the engine does not take drag"},
    {"a drive", with([](Scene& s) { s.forces.emplace_back(core::Drive{}); }), 0,
     "the engine does not take drives"},
    {"attraction", with([](Scene& s) { s.forces.emplace_back(core::Attraction{.to = 1}); }), 0,
     "the engine does not take attractions"},
    {"thrust", with([](Scene& s) { s.forces.emplace_back(core::Thrust{}); }), everything,
     "cylon/engine.h has no thrust"},
    {"water", with([](Scene& s) { s.forces.emplace_back(core::Water{}); }), everything,
     "cylon/engine.h has no water"},
    {"a frame", with([](Scene& s) { s.frame = core::Frame{}; }), everything,
     "cylon/engine.h has no frame that is not inertial"},
    {"a disc that touches", with([](Scene& s) { collide(s, core::Disc{0.2}); }), everything,
     "cylon/engine.h has no such shape as that of 'a'"},
    {"a disc that does not", with([](Scene& s) { s.bodies[0].shape = core::Disc{0.2}; }), everything,
     nullptr},
    {"no material", with([](Scene& s) { collide(s, core::Sphere{0.2}), s.materials.clear(); }), everything,
     "a pair may touch, and the scene states no material for it"},
    {"more pairs than are listed", with([](Scene& s) {
       s.bodies.resize(1500, s.bodies[0]);
       collide(s, core::Sphere{0.01});
     }),
     everything, "more than 1000000 pairs may touch"},
};

TEST(CEngine, RefusesForTheEngineWhatItDoesNotTake) {
  for (const Refusal& row : refusals) {
    Fake of;
    const cylon_engine engine = table(of, row.takes);
    const core::Loaded loaded = CEngine(engine).load_if_supported(row.scene, {.dt = 0.01});
    EXPECT_EQ(loaded.unsupported.value_or("taken"), row.reason ? row.reason : "taken") << row.what;
    EXPECT_EQ(of.scene == nullptr, row.reason != nullptr) << row.what;
  }
}

TEST(CEngine, HandsOverBodies) {
  Fake of;
  const cylon_engine engine = table(of);
  CEngine simulator(engine);
  const Scene scene =
      with([](Scene& s) { s.bodies[1].gravity = Vector3(1, 2, 3), s.bodies[1].locked = true; });
  const core::Loaded loaded = simulator.load_if_supported(scene, {.dt = 0.125, .integrator = "leapfrog"});
  EXPECT_EQ(loaded.terms.integrator, "leapfrog");
  EXPECT_EQ(loaded.terms.order, 2);
  EXPECT_EQ(of.dt, 0.125);
  ASSERT_EQ(of.scene->bodies, 2u);
  const cylon_body& a = of.scene->body[0];
  EXPECT_STREQ(a.name, "a");
  EXPECT_EQ(a.mass, 1.7);
  EXPECT_EQ(a.inertia[2], -0.02);
  EXPECT_EQ(a.inertia[5], 0.03);
  EXPECT_EQ(Vector3(a.gravity), Vector3(0.1, -9.7, 0.2));
  EXPECT_EQ(Vector3(of.scene->body[1].gravity), Vector3(1, 2, 3));
  EXPECT_EQ(a.locked, 0);
  EXPECT_EQ(of.scene->body[1].locked, 1);
  EXPECT_EQ(a.shape, CYLON_NO_SHAPE);
  core::State state(2);
  simulator.advance(3);
  simulator.read(state);
  EXPECT_EQ(of.steps, 3);
  for (std::size_t i = 0; i < 2; ++i) {
    const core::BodyState& start = scene.bodies[i].initial;
    EXPECT_EQ(state[i].position, start.position);
    EXPECT_EQ(state[i].orientation.coeffs(), start.orientation.coeffs());
    EXPECT_EQ(state[i].velocity, start.velocity);
    EXPECT_EQ(state[i].angular_velocity, start.angular_velocity);
  }
}

TEST(CEngine, HandsOverForcesAndJoints) {
  Fake of;
  const cylon_engine engine = table(of);
  CEngine simulator(engine);
  const Scene scene = with([](Scene& s) {
    s.forces.emplace_back(core::Spring{.body = 1,
                                       .anchor = {1, 2, 3},
                                       .to_anchor = {4, 5, 6},
                                       .stiffness = 7,
                                       .rest_length = 8,
                                       .damping = 9});
    s.forces.emplace_back(core::Drag{.body = 1, .linear = 2, .angular = 3, .momentum = 4});
    s.forces.emplace_back(core::Drive{.body = 1, .force = {1, 2, 4}, .frequency = 5});
    s.forces.emplace_back(core::Attraction{.body = 0, .to = 1, .strength = 6});
    s.joints = hinge.joints;
  });
  ASSERT_FALSE(simulator.load_if_supported(scene, {.dt = 0.01}).unsupported);
  ASSERT_EQ(of.scene->springs + of.scene->drags + of.scene->drives + of.scene->attractions + of.scene->joints,
            5u);
  const cylon_spring& spring = *of.scene->spring;
  EXPECT_EQ(spring.body, 1);
  EXPECT_EQ(spring.to, CYLON_WORLD);
  EXPECT_EQ(Vector3(spring.anchor), Vector3(1, 2, 3));
  EXPECT_EQ(Vector3(spring.to_anchor), Vector3(4, 5, 6));
  EXPECT_EQ(Vector3(spring.stiffness, spring.rest_length, spring.damping), Vector3(7, 8, 9));
  const cylon_drag& drag = *of.scene->drag;
  EXPECT_EQ(Vector3(drag.linear, drag.angular, drag.momentum), Vector3(2, 3, 4));
  EXPECT_EQ(Vector3(of.scene->drive->force), Vector3(1, 2, 4));
  EXPECT_EQ(of.scene->drive->frequency, 5);
  EXPECT_EQ(of.scene->attraction->to, 1);
  EXPECT_EQ(of.scene->attraction->strength, 6);
  EXPECT_EQ(of.scene->joint->kind, CYLON_HINGE);
  EXPECT_EQ(of.scene->joint->body, 1);
  EXPECT_EQ(Vector3(of.scene->joint->point), Vector3(1, 2, 3));
  EXPECT_EQ(Vector3(of.scene->joint->axis), Vector3(0.6, 0, 0.8));
}

TEST(CEngine, HandsOverPairsWithTheirMaterials) {
  Fake of;
  const cylon_engine engine = table(of);
  CEngine simulator(engine);
  ASSERT_FALSE(simulator.load_if_supported(boxes, {.dt = 0.01}).unsupported);
  ASSERT_EQ(of.scene->pairs, 3u);
  const cylon_pair& bodies = of.scene->pair[0];
  EXPECT_EQ(bodies.body, 0);
  EXPECT_EQ(bodies.other, 1);
  EXPECT_EQ(bodies.plane, CYLON_WORLD);
  EXPECT_EQ(bodies.restitution, 0.7);
  EXPECT_EQ(bodies.friction, 0.1);
  const cylon_pair& floor = of.scene->pair[2];
  EXPECT_EQ(floor.body, 1);
  EXPECT_EQ(floor.other, CYLON_WORLD);
  EXPECT_EQ(floor.plane, 0);
  EXPECT_EQ(floor.friction, 0.4);
  EXPECT_EQ(of.scene->body[1].shape, CYLON_BOX);
  EXPECT_EQ(Vector3(of.scene->body[1].size), Vector3(0.1, 0.2, 0.3));
  EXPECT_STREQ(of.scene->plane->name, "floor");
  EXPECT_EQ(of.scene->plane->offset, -2.5);
}

TEST(CEngine, KeepsTheSceneUntilTheNextLoad) {
  Fake of;
  const cylon_engine engine = table(of);
  CEngine simulator(engine);
  {
    const Scene gone =
        with([](Scene& s) { s.bodies[0].name = "a name that no short string holds in place"; });
    simulator.load_if_supported(gone, {.dt = 0.01});
  }
  EXPECT_STREQ(of.scene->body[0].name, "a name that no short string holds in place");
}

TEST(CEngine, PassesOnWhyTheEngineRefuses) {
  Fake of{.refusal = "two bodies are one too many"};
  const cylon_engine engine = table(of);
  CEngine simulator(engine);
  EXPECT_EQ(simulator.load_if_supported(still(), {.dt = 0.01}).unsupported, "two bodies are one too many");
  EXPECT_THROW(simulator.load(still(), {.dt = 0.01}), std::runtime_error);
}

TEST(CEngine, RefusesSettingsThatItDoesNotHave) {
  Fake of;
  const cylon_engine engine = table(of);
  CEngine simulator(engine);
  const core::Setup setups[] = {
      {.dt = 0.1, .path = "fast"}, {.dt = 0.1, .integrator = "rk4"}, {.dt = 0.1, .options = {{"erp", "0"}}}};
  for (const core::Setup& setup : setups)
    EXPECT_THROW(simulator.load_if_supported(still(), setup), std::invalid_argument);
  EXPECT_EQ(of.scene, nullptr);
}

TEST(CEngine, SaysWhatIsWrongWithATable) {
  const struct {
    void (*spoil)(cylon_engine&);
    const char* says;
  } rows[] = {
      {[](cylon_engine& t) { t.version = 2; }, "version is 2, and this library's is 1"},
      {[](cylon_engine& t) { t.takes = 1024; }, "takes has bits that are no cylon_part"},
      {[](cylon_engine& t) { t.name = nullptr; }, "name is NULL"},
      {[](cylon_engine& t) { t.integrator = nullptr; }, "integrator is NULL"},
      {[](cylon_engine& t) { t.read = nullptr; }, "read is NULL"},
      {[](cylon_engine& t) { t.precision = "half"; }, "precision is 'half', neither 'double' nor 'float'"},
      {[](cylon_engine& t) { t.order = 0; }, "order is 0, below 1"},
  };
  Fake of;
  for (const auto& row : rows) {
    cylon_engine engine = table(of);
    EXPECT_EQ(fault(&engine), std::nullopt);
    row.spoil(engine);
    EXPECT_EQ(fault(&engine).value_or("nothing"), row.says);
    EXPECT_EQ(cylon_worker_main(&engine), 2);
  }
  EXPECT_EQ(fault(nullptr), "there is no table");
}

TEST(Worker, RefusesAnotherLayoutOfAScene) {
  for (std::size_t i = 0; i < layout_here.size(); ++i) {
    Layout other = layout_here;
    other[i] += 8;
    EXPECT_EQ(run([]() -> std::unique_ptr<core::Simulator> { return nullptr; }, other), 2) << i;
  }
}

}  // namespace
}  // namespace cylon::worker
