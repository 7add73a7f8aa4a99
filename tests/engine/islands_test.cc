// Parts of a scene that cannot act on each other move as each does alone, to the last bit, and with the
// method of each; parts that may meet become one.
#include "tests/engine/fixtures.h"
#include "tests/engine/mixed_scenes.h"
#include "tests/engine/rail_and_wheel.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

// A body's place moves by `by`, and all that is fastened to the world with it.
Model moved(Model model, const Vector3& by) {
  for (Motion& m : model.motions) m.position += by;
  for (Joint& joint : model.joints) {
    if (joint.to == fixed_world) joint.to_anchor += by;
    if (joint.body == fixed_world) joint.anchor += by;
  }
  for (Spring& spring : model.forces.springs) {
    if (spring.to == fixed_world) spring.to_anchor += by;
    if (spring.body == fixed_world) spring.anchor += by;
  }
  for (CoordinateLaw& law : model.forces.coordinate_laws)
    if (law.at.to == fixed_world) law.at.to_anchor += by;
  return model;
}

// Adds the bodies, joints and forces of `part`; gravity, planes and materials must be those of `whole`.
void add(Model& whole, const Model& part) {
  const int n = static_cast<int>(whole.bodies.size());
  const auto shift = [&](int& body) { body += body == fixed_world ? 0 : n; };
  const auto append = [](auto& list, const auto& more) { list.insert(list.end(), more.begin(), more.end()); };
  append(whole.bodies, part.bodies);
  append(whole.motions, part.motions);
  append(whole.shapes, part.shapes);
  append(whole.surfaces, part.surfaces);
  append(whole.filters, part.filters);
  for (Joint joint : part.joints) shift(joint.body), shift(joint.to), whole.joints.push_back(joint);
  for (Spring s : part.forces.springs) shift(s.body), shift(s.to), whole.forces.springs.push_back(s);
  for (Drag d : part.forces.drags) shift(d.body), whole.forces.drags.push_back(d);
  for (Thrust t : part.forces.thrusts) shift(t.body), whole.forces.thrusts.push_back(t);
  for (Drive d : part.forces.drives) shift(d.body), whole.forces.drives.push_back(d);
  for (Attraction a : part.forces.attractions)
    shift(a.body), shift(a.to), whole.forces.attractions.push_back(a);
  for (CoordinateLaw law : part.forces.coordinate_laws)
    shift(law.at.body), shift(law.at.to), whole.forces.coordinate_laws.push_back(law);
}

const Vector3 fall = {Real(0.1), Real(-9.81), Real(-0.2)};

// Above a floor at y = 0 that all parts share.
Model on_floor(Model model) {
  model.forces.gravity = fall;
  model.planes = {{Vector3::UnitY(), 0}};
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    model.surfaces[i] = std::holds_alternative<std::monostate>(model.shapes[i]) ? no_surface : 0;
  model.plane_surfaces = {0};
  model.surface_count = 1;
  model.materials = {{Real(0.6), Real(0.3)}};
  return model;
}

Model box_stack(int count) {
  Model model;
  for (int i = 0; i < count; ++i)
    add_body(model, make_body(1, Matrix3::Identity() / 6),
             {Real(0.1) * static_cast<Real>(i % 2), Real(0.5) + static_cast<Real>(i), 0}, {0, 0, 0},
             {0, 0, 0}, {0, 0, 0}, Box{{0.5, 0.5, 0.5}});
  return on_floor(model);
}

Model bouncing_ball() {
  Model model;
  add_body(model, make_body(0.7, Matrix3::Identity() * 0.03), {0.2, 1.7, 0.3}, {0.1, 0.2, 0.3},
           {0.4, 0.1, -0.3}, {1, 2, -0.5}, Sphere{0.25});
  return on_floor(model);
}

Model tumbling_box() {
  Model model;
  add_body(model, make_body(1.2, general_inertia(0.2, 0.3, 0.35)), {0.1, 1.1, 0.2}, {0.3, 0.5, -0.2},
           {0.3, 0, 0.2}, {1, -2, 0.7}, Box{{0.3, 0.4, 0.25}});
  return on_floor(model);
}

Model sprung() {
  Model model = coupled_bodies(Real(0.3));
  return on_floor(moved(model, {0, 3, 0}));
}

Model hanging() { return on_floor(moved(linked_bodies(true), {0, 4, 0})); }

struct Part {
  const char* name;
  Model model;
  Path path;
};

std::vector<Part> parts() {
  return {{"stack", box_stack(3), Path::stepping},      {"ball", bouncing_ball(), Path::ballistic},
          {"box", tumbling_box(), Path::events},        {"two bodies on a spring", sprung(), Path::bodies},
          {"double pendulum", hanging(), Path::bodies}, {"a second stack", box_stack(2), Path::stepping}};
}

// Every part alone, and all together 60 m apart.
TEST(Islands, MoveBitForBitAsEachAlone) {
  for (const char* integrator : {"auto", "rk8"}) {
    SCOPED_TRACE(integrator);
    Options options = with(integrator, 0.01);
    std::vector<std::unique_ptr<World>> worlds;
    Model whole = on_floor({});
    whole.surfaces.clear();
    Real at = -150;
    for (const Part& part : parts()) {
      if (options.integrator != "auto" && part.path == Path::stepping) continue;
      const Model there = moved(part.model, {at, 0, Real(0.3) * at});
      worlds.push_back(std::make_unique<World>(there, options));
      const bool automatic = options.integrator == "auto";
      EXPECT_TRUE(!automatic || worlds.back()->plan().path == part.path) << part.name;
      add(whole, there);
      at += 60;
    }
    ASSERT_EQ(unsupported(whole, options), "");
    World all(whole, options);
    EXPECT_EQ(all.island_count(), worlds.size());
    std::size_t impacts = 0;
    for (int n = 0; n < 100; ++n) {
      all.step();
      std::size_t first = 0, own_impacts = 0;
      for (const auto& world : worlds) {
        world->step();
        for (std::size_t i = 0; i < world->motions().size(); ++i)
          ASSERT_TRUE(same_bits(world->motions()[i], all.motions()[first + i]))
              << "body " << first + i << " step " << n;
        first += world->motions().size();
        own_impacts += world->impacts().size();
      }
      ASSERT_EQ(all.impacts().size(), own_impacts);
      impacts += own_impacts;
    }
    EXPECT_GT(impacts, 0u);
  }
}

// With the whole model as one island the same parts do act on each other's method: what the test above is
// about.
TEST(Islands, FullModelIsOneIsland) {
  Model whole = on_floor({});
  add(whole, box_stack(2));
  add(whole, moved(hanging(), {60, 0, 0}));
  Options options = with("auto", 0.01);
  World parted(whole, options);
  options.full = true;
  World one(whole, options);
  EXPECT_EQ(parted.island_count(), 2u);
  EXPECT_EQ(one.island_count(), 1u);
  EXPECT_EQ(one.plan().path, Path::stepping);
}

// Random mixes of forces, joints and shapes without a surface to meet, put together two by two.
TEST(Islands, RandomPartsMoveBitForBitAsAlone) {
  int tried = 0;
  for (std::uint32_t k = 0; k < 240; ++k) {
    MixedScene one = mixed_scene(2 * k), other = mixed_scene(2 * k + 1);
    const auto framed = [](const Model& m) { return m.frame || !m.forces.frame_forces.empty(); };
    if (framed(one.model) || framed(other.model) || !one.model.forces.waters.empty() ||
        !other.model.forces.waters.empty())
      continue;
    other.model.forces.gravity = one.model.forces.gravity;
    for (Model* m : {&one.model, &other.model}) {
      m->planes = one.model.planes, m->plane_surfaces = one.model.plane_surfaces;
      m->materials = one.model.materials, m->surface_count = one.model.surface_count;
      if (one.model.surface_count == 0) std::fill(m->surfaces.begin(), m->surfaces.end(), no_surface);
      if (one.model.filters.empty())
        m->filters.clear();
      else
        m->filters.resize(m->bodies.size());
      m->plane_filters = one.model.plane_filters;
    }
    if (one.surface == Surface::near) continue;
    const auto locks = [](const Model& m) {
      return std::any_of(m.bodies.begin(), m.bodies.end(), [](const Body& b) { return b.locked; });
    };
    if (locks(one.model) || locks(other.model))
      continue;  // all parts share what is locked, as they do planes
    const Model far = moved(other.model, {0, 0, 800});
    Model whole = one.model;
    add(whole, far);
    const Options options = with("auto", 0.05);
    if (!unsupported(whole, options).empty() || !unsupported(one.model, options).empty() ||
        !unsupported(far, options).empty())
      continue;
    SCOPED_TRACE(one.text + " |" + other.text);
    World a(one.model, options), b(far, options), all(whole, options);
    a.advance(10), b.advance(10), all.advance(10);
    std::vector<Motion> expected = a.motions();
    expected.insert(expected.end(), b.motions().begin(), b.motions().end());
    ASSERT_TRUE(same_bits(expected, all.motions())) << k;
    ++tried;
  }
  EXPECT_GT(tried, 40);
}

// I q'' = -k q, q = W/w sin(w t), over two turns to each side, while balls come near it one after another: it becomes
// one island with each of them and parts from it.  A scene with such a spring was one island for ever, in which a top
// 50 m from a limited door went wrong by 10 rad/s.
TEST(Islands, KeepTheTurnsOfAWoundSpring) {
  for (const bool by_steps : {false, true}) {
    Wheel w = wheel_that_turns(40);
    CoordinateLaw law;
    law.at = w.angle, law.stiffness = Real(0.3);
    w.model.forces.coordinate_laws.push_back(law);
    w.model.forces.gravity.setZero();
    w.model.shapes[0] = Sphere{Real(0.1)};
    for (int i = 0; i < 3; ++i)
      add_body(w.model, make_body(1, Matrix3::Identity()),
               w.model.motions[0].position + Vector3(Real(0.25), 0, Real(-3 - 9 * i)), {0, 0, 0}, {0, 0, 10},
               {0, 0, 0}, Sphere{Real(0.1)});
    make_touchable(w.model, 1);
    const Real rate = std::sqrt(law.stiffness / w.inertia);
    Options options = with("auto", by_steps ? 1e-4 : 2e-3);
    if (by_steps) options.path = "stepping";
    World world(w.model, options);
    EXPECT_GT(world.island_count(), 1u);
    const int steps = by_steps ? 30000 : 1500;
    for (int i = 0; i < steps; ++i) world.step();
    EXPECT_NEAR(rail_axis.dot(angular_velocity(w.model.bodies[0], world.motions()[0])),
                40 * std::cos(rate * 3), by_steps ? Real(0.1) : Real(1e-6));
    std::string all;
    for (const std::string& said : world.remarks()) all += said;
    EXPECT_NE(all.find("are one island"), std::string::npos) << all;
  }
}

// A box slides without friction towards one at rest, from far enough that they start as two islands.
Model two_boxes(Real gap, Real speed) {
  Model model;
  const auto box = [&](Real x, Real v) {
    add_body(model, make_body(1, Matrix3::Identity() / 6), {x, 0.5, 0}, {0, 0, 0}, {v, 0, 0}, {0, 0, 0},
             Box{{0.5, 0.5, 0.5}});
  };
  box(0, speed), box(1 + gap, 0);
  model = on_floor(model);
  model.forces.gravity = {0, Real(-9.81), 0};
  model.materials = {{0, 0}};
  return model;
}

TEST(Islands, MergeBeforeTheyMeet) {
  const Time dt = 0.005;
  World world(two_boxes(12, 4), with("auto", dt));
  ASSERT_EQ(world.island_count(), 2u);
  int merged_at = 0, met_at = 0;
  for (int n = 1; n <= 800; ++n) {
    world.step();
    if (merged_at == 0 && world.island_count() == 1) merged_at = n;
    for (const Impact& impact : world.impacts())
      if (met_at == 0 && impact.other != fixed_world) met_at = n;
  }
  EXPECT_GT(merged_at, 100);
  EXPECT_LT(merged_at, met_at);
  EXPECT_NEAR(met_at, 12 / 4. / dt, 2);
  // Restitution 0: both go on at half the speed.
  for (const Motion& m : world.motions()) EXPECT_NEAR(m.momentum.x(), 2, 1e-9);
  EXPECT_FALSE(world.remarks().empty());
}

// Two boxes that bounce off each other part again, each with its own method.
TEST(Islands, PartAgain) {
  Model model = two_boxes(Real(0.2), 6);
  model.forces.gravity.setZero();
  model.materials = {{1, 0}};
  World world(model, with("auto", 0.005));
  ASSERT_EQ(world.island_count(), 1u);
  EXPECT_EQ(world.plan().path, Path::stepping);
  for (int n = 0; n < 1000; ++n) world.step();
  EXPECT_EQ(world.island_count(), 2u);
  EXPECT_NE(world.plan().path, Path::stepping);
  EXPECT_NEAR(world.motions()[0].momentum.x(), 0, 1e-9);
  EXPECT_NEAR(world.motions()[1].momentum.x(), 6, 1e-9);
}

// Drives that cancel at t = 0 and push a ball 40 m within the first step, through the place of the box:
// nothing at the start of the step tells that they meet in it.
TEST(Islands, SeesWhatMeetsWithinOneStep) {
  Model model = two_boxes(30, 0);
  model.shapes[0] = Sphere{0.5};
  model.forces.drives.push_back({0, {Real(1.6e6), 0, 0}, 0});
  model.forces.drives.push_back({0, {Real(-1.6e6), 0, 0}, 300});
  World world(model, with("auto", 0.01));
  ASSERT_EQ(world.island_count(), 2u);
  world.step();
  EXPECT_EQ(world.island_count(), 1u);
  int met = 0;
  for (const Impact& impact : world.impacts()) met += impact.other != fixed_world;
  EXPECT_GT(met, 0);
  EXPECT_GT(world.motions()[1].momentum.x(), 0);
}

// The ball strikes a second one within the step, and that one flies on to a third in the steps after: the step
// that is made again may lead to others.
TEST(Islands, LooksForOthersAfterAStepThatIsMadeAgain) {
  Model model = two_boxes(200, 0);
  add(model, moved(two_boxes(1000, 0), {90000, 0, 0}));
  for (Shape& shape : model.shapes) shape = Sphere{0.5};
  model.bodies[0] = make_body(1000, Matrix3::Identity());
  model.motions[0].momentum.setZero();
  model.materials = {{1, 0}};
  model.forces.drives.push_back({0, {Real(1e10), 0, 0}, 100});
  model.forces.drives.push_back({0, {Real(-1e10), 0, 0}, 300});
  Options options = with("auto", 0.01);
  World parted(model, options);
  options.full = true;
  World whole(model, options);
  ASSERT_EQ(parted.island_count(), 4u);
  parted.advance(100), whole.advance(100);
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    EXPECT_NEAR(static_cast<double>(parted.motions()[i].position.x()),
                static_cast<double>(whole.motions()[i].position.x()), 10)
        << i << " of places up to 1.4e5 m";
}

// A rocket that becomes one with what it meets has burnt some of its mass: a late start knows how much.
TEST(Islands, MassesGoOnWhereIslandsMerge) {
  for (const bool stepped : {false, true})
    for (const char* name : {"auto", "rk4", "velocity-verlet", "yoshida4"}) {
      if (stepped && std::string(name) != "auto") continue;
      Model model = two_boxes(12, 0);
      if (!stepped)
        for (Shape& shape : model.shapes) shape = Sphere{0.5};
      model.bodies[0] = make_body(4, Matrix3::Identity());
      model.bodies[0].mass_rate = -1;
      model.motions[0].momentum.setZero();
      model.forces.thrusts.push_back({0, {20, 0, 0}});
      model.forces.drags.push_back({.body = 0, .linear = 1});
      Options options = with(name, stepped ? 0.001 : 0.005);
      World parted(model, options);
      options.full = true;
      World whole(model, options);
      ASSERT_EQ(parted.island_count(), 2u);
      for (World* world : {&parted, &whole})
        while (world->time() < 2.5) world->step();
      EXPECT_EQ(parted.island_count(), 1u);
      EXPECT_NEAR(static_cast<double>(parted.motions()[0].position.x()),
                  static_cast<double>(whole.motions()[0].position.x()), stepped ? 2e-2 : 1e-3)
          << name << (stepped ? ", stepped" : "");
    }
}

// Nothing reaches the floor: the motion is that without one, to the last bit.
TEST(Islands, UnreachableFloorChangesNothing) {
  Model bare = linked_bodies(true);
  Model above = bare;
  for (std::size_t i = 0; i < 2; ++i) above.shapes[i] = Box{{Real(0.1), Real(0.15), Real(0.2)}};
  above.planes = {{Vector3(Real(0.1), 1, 0).normalized(), -110}};
  make_touchable(above, 0, Real(0.5));
  above.apart = {{0, 1}};
  const Options options = with("auto", 0.01);
  World one(bare, options), other(above, options);
  EXPECT_EQ(other.plan().path, Path::bodies);
  one.advance(100), other.advance(100);
  EXPECT_TRUE(same_bits(one.motions(), other.motions()));
  // A floor within reach is met.
  above.planes[0].offset = Real(-0.2);
  World low(above, options);
  low.advance(100);
  EXPECT_FALSE(same_bits(one.motions(), low.motions()));
}

// A hinged plank that can touch nothing keeps its reduced coordinates though it has a shape.
TEST(Islands, PlankThatTouchesNothingKeepsReducedCoordinates) {
  Model plank = heavy_top();
  plank.shapes[0] = Box{{Real(0.1), Real(0.3), Real(0.1)}};
  plank.planes = {{Vector3::UnitY(), -5}};
  make_touchable(plank, 0, Real(0.5));
  const World world(plank, with("auto", 0.01));
  int reduced = 0;
  for (const Stage& stage : world.plan().stages) reduced += stage.name == "reduced coordinates" && stage.in;
  EXPECT_EQ(reduced, 1);
}

// Locked bodies that hold nothing and that nothing can touch are in no island; frames keep them.
TEST(Islands, LockedBodiesOfNoUseChangeNothing) {
  const Model bare = coupled_bodies();
  Model more = bare;
  add_body(more, make_body(3, Matrix3::Identity(), true), {50, 60, 70}, {0.1, 0, 0}, {0, 0, 0}, {0, 0, 0});
  World one(bare, with("auto", 0.05)), other(more, with("auto", 0.05));
  one.advance(20), other.advance(20);
  ASSERT_EQ(other.motions().size(), 3u);
  EXPECT_TRUE(same_bits(std::span(one.motions()), std::span(other.motions()).first(2)));
  EXPECT_TRUE(same_bits(other.motions()[2], more.motions[2]));
}

}  // namespace
}  // namespace cylon::engine
