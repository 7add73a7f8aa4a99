// Locked bodies are in no equation of motion and cost nothing in a step, whatever their place in the scene.
#include "tests/engine/contact/contact_fixtures.h"
#include "tests/engine/mixed_scenes.h"
#include "tests/engine/same_bits.h"

#include "engine/bodies.h"
#include "engine/world.h"

#include <algorithm>
#include <numeric>

namespace cylon::engine {
namespace {

// A ball that falls on a floor of n x n locked cubes with their tops at 0.5 m, near the middle, rolls and
// bounces; `last`: it comes after the cubes.
Model ball_on_floor(int n, bool last) {
  Model model = without_plane({0.6, 0.4});
  model.forces.gravity = {0, Real(-9.81), 0};
  const auto add_ball = [&] { add_sphere(model, 2, 0.4, {0.13, 1.3, 0.21}, {0.7, 0, -0.4}, {1, 2, 3}); };
  if (!last) add_ball();
  const int half = n / 2;
  for (int x = 0; x < n; ++x)
    for (int z = 0; z < n; ++z)
      add_box(model, 1, Vector3::Constant(0.5), {Real(x - half), 0, Real(z - half)}, Quaternion::Identity(),
              Vector3::Zero(), Vector3::Zero(), true);
  if (last) add_ball();
  return model;
}

struct Seen {
  Motion end;
  std::int64_t operations = 0;
  std::vector<Impact> impacts;
};

Seen follow(const Model& model, const std::string& path, int steps) {
  Options options;
  options.dt = 1e-3;
  options.path = path;
  World world(model, options);
  Seen seen;
  for (int k = 0; k < steps; ++k) {
    world.step();
    seen.impacts.insert(seen.impacts.end(), world.impacts().begin(), world.impacts().end());
  }
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (!model.bodies[i].locked) {
      seen.end = world.motions()[i];
      continue;
    }
    EXPECT_EQ(world.motions()[i].position, model.motions[i].position);
    EXPECT_EQ(world.motions()[i].orientation.coeffs(), model.motions[i].orientation.coeffs());
  }
  seen.operations = world.operations();
  return seen;
}

TEST(LockedBodies, AreInNoStateVector) {
  const Reduced reduced = reduce(ball_on_floor(5, true));
  const Bodies system(reduced.model);
  EXPECT_EQ(system.size(), motion_size);
  EXPECT_EQ(reduced.readings.front().body, 25);
  std::vector<Motion> motions;
  read(reduced.model.bodies, reduced.readings, reduced.model.motions.data(), motions);
  for (std::size_t i = 0; i < motions.size(); ++i)
    EXPECT_EQ(motions[i].position, ball_on_floor(5, true).motions[i].position);
}

// 961 cubes in place of 25: the same motion, and hardly more operations.
TEST(LockedBodies, FarFromAllThatMovesCostNothing) {
  for (const bool last : {false, true}) {
    const Seen few = follow(ball_on_floor(5, last), "events", 1000);
    const Seen many = follow(ball_on_floor(31, last), "events", 1000);
    EXPECT_LT((few.end.position - many.end.position).norm(), 1e-9);
    EXPECT_GT(few.impacts.size(), 2u);
    EXPECT_EQ(few.impacts.size(), many.impacts.size());
    EXPECT_LT(static_cast<double>(many.operations), 1.2 * static_cast<double>(few.operations));
  }
}

// Who is named first in a scene changes who is first in an impact, and nothing else.
TEST(LockedBodies, MayComeFirstOrLast) {
  const Seen first = follow(ball_on_floor(5, false), "events", 1000);
  const Seen last = follow(ball_on_floor(5, true), "events", 1000);
  EXPECT_LT((first.end.position - last.end.position).norm(), 1e-9);
  ASSERT_EQ(first.impacts.size(), last.impacts.size());
  for (std::size_t k = 0; k < first.impacts.size(); ++k) {
    EXPECT_NEAR(first.impacts[k].time, last.impacts[k].time, 1e-9);
    const auto cube = [](const Impact& impact, int ball) {
      EXPECT_TRUE(impact.body == ball || impact.other == ball);
      return impact.body == ball ? impact.other : impact.body;
    };
    EXPECT_EQ(cube(first.impacts[k], 0), cube(last.impacts[k], 25) + 1);
  }
}

// Springs to locked bodies, and a box pinned to one, in any order of the bodies.
TEST(LockedBodies, HoldSpringsAndJoints) {
  std::vector<Motion> ends;
  for (const bool first : {true, false}) {
    Model model = without_plane({0, 0});
    model.forces.gravity = {0, Real(-9.81), 0};
    const auto add_anchor = [&] {
      add_sphere(model, 1, 0.1, {1, 2, 3}, Vector3::Zero(), Vector3::Zero(), true);
    };
    if (first) add_anchor();
    add_box(model, 2, {0.1, 0.2, 0.3}, {1.5, 1.2, 2.9}, Quaternion::Identity(), {0.3, -0.2, 0.5}, {1, 2, -1});
    add_sphere(model, 1, 0.1, {0.2, 1.4, 3.1}, {0.1, 0.4, -0.3}, Vector3::Zero());
    if (!first) add_anchor();
    model.surfaces.assign(3, no_surface);
    const int anchor = first ? 0 : 2, box = first ? 1 : 0, ball = first ? 2 : 1;
    model.forces.springs.push_back({anchor, {0.1, 0, 0}, box, {0, 0.1, 0.2}, 40, 0.3, 0.2});
    Joint joint;
    joint.body = box, joint.anchor = {-0.1, 0.2, 0.1};
    joint.to = ball, joint.to_anchor = {0, 0, 0};
    joint.type.place = Joint::Place::at_length;
    joint.length = (model.motions[static_cast<std::size_t>(box)].position + joint.anchor -
                    model.motions[static_cast<std::size_t>(ball)].position)
                       .norm();
    model.joints.push_back(joint);
    for (const char* integrator : {"auto", "velocity-verlet", "rk4"}) {
      Options options;
      options.dt = 1e-3;
      options.integrator = integrator;
      World world(model, options);
      for (int k = 0; k < 700; ++k) world.step();
      ends.push_back(world.motions()[static_cast<std::size_t>(box)]);
      ends.push_back(world.motions()[static_cast<std::size_t>(ball)]);
    }
  }
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_GT(ends[k].position.norm(), 0.1);
    EXPECT_LT((ends[k].position - ends[k + 6].position).norm(), 1e-9) << k;
    EXPECT_LT((ends[k].angular_momentum - ends[k + 6].angular_momentum).norm(), 1e-8) << k;
  }
}

// Two hinged balls that a spring folds together while they fall on a slab: they do not touch each other.  With the slab before
// them they did, as the list of jointed pairs was numbered anew with numbers that were gone by then.
TEST(LockedBodies, BeforeJointedNeighboursKeepThemApart) {
  std::vector<Motion> ends;
  for (const bool first : {true, false}) {
    Model model = without_plane({0, 0.5});
    model.forces.gravity = {0, Real(-9.81), 0};
    const auto add_slab = [&] {
      add_box(model, 1, {3, 0.1, 3}, {0, -0.1, 0}, Quaternion::Identity(), Vector3::Zero(), Vector3::Zero(),
              true);
    };
    if (first) add_slab();
    const int a = first ? 1 : 0, b = a + 1;
    add_sphere(model, 1, 0.1, {0, 0.5, 0}, Vector3::Zero(), Vector3::Zero());
    add_sphere(model, 1, 0.1, {0.3, 0.5, 0}, Vector3::Zero(), Vector3::Zero());
    if (!first) add_slab();
    model.forces.springs.push_back({a, Vector3::Zero(), b, Vector3::Zero(), 50, 0, 0});
    Joint hinge{.type = joint_types::hinge, .body = b, .to = a};
    hinge.anchor = {-0.15, 0.1, 0}, hinge.to_anchor = {0.15, 0.1, 0};
    hinge.axis = hinge.to_axis = {0, 0, 1};
    model.joints.push_back(hinge);
    model.apart = {{a, b}};
    Options options;
    options.dt = 1. / 256;
    World world(model, options);
    world.advance(64);
    ends.push_back(world.motions()[static_cast<std::size_t>(a)]);
    ends.push_back(world.motions()[static_cast<std::size_t>(b)]);
    EXPECT_LT((ends.back().position - ends[ends.size() - 2].position).norm(), Real(0.2) + Real(1e-9));
    EXPECT_GT(ends[ends.size() - 2].position.x(), ends.back().position.x()) << "they went through each other";
  }
  EXPECT_TRUE(same_bits(std::span(ends).first(2), std::span(ends).last(2)));
}

// What the scene ties to the world, tied to a locked post at the origin in its place; jointed pairs do not touch.
Model with_post(Model m, bool first) {
  const int post = static_cast<int>(m.bodies.size());
  const auto tie = [&](int& end) { end = end == fixed_world ? post : end; };
  add_body(m, make_body(1, Matrix3::Identity(), true), Vector3::Zero(), Vector3::Zero(), Vector3::Zero(),
           Vector3::Zero());
  if (!m.filters.empty()) m.filters.push_back({});
  for (Water& water : m.forces.waters) water.shapes = m.shapes;
  for (Joint& joint : m.joints) tie(joint.to);
  for (Spring& spring : m.forces.springs) tie(spring.to);
  for (CoordinateLaw& law : m.forces.coordinate_laws) tie(law.at.to);
  for (const Joint& joint : m.joints)
    if (joint.to != post) m.apart.push_back({std::min(joint.body, joint.to), std::max(joint.body, joint.to)});
  std::ranges::sort(m.apart);
  if (!first) return m;
  std::vector<int> order(m.bodies.size());
  std::iota(order.begin() + 1, order.end(), 0);
  order.front() = post;
  const auto sort = [&](auto& list) {
    if (!list.empty()) std::rotate(list.begin(), list.end() - 1, list.end());
  };
  sort(m.bodies), sort(m.motions), sort(m.shapes), sort(m.surfaces), sort(m.filters);
  const Numbering numbering(order);
  for (Joint& joint : m.joints) joint.body = numbering(joint.body), joint.to = numbering(joint.to);
  each_force_list(m.forces, [&](auto& list) {
    for (auto& force : list) force.renumber(numbering);
  });
  for (BodyPair& pair : m.apart) pair = {numbering(pair[0]), numbering(pair[1])};
  std::ranges::sort(m.apart);
  return m;
}

// Random scenes that mix features, with and without a surface.
TEST(LockedBodies, HaveTheSameEffectFirstAndLast) {
  int compared = 0, jointed = 0;
  for (std::uint32_t k = 0; k < 400; ++k) {
    const MixedScene scene = mixed_scene(k);
    SCOPED_TRACE(std::to_string(k) + scene.text);
    const bool others = std::ranges::any_of(scene.model.bodies, &Body::locked);  // whose order would change
    if (others) continue;
    const Model first = with_post(scene.model, true), last = with_post(scene.model, false);
    for (const bool full : {false, true}) {
      Options options;
      options.dt = 1. / 64, options.full = full;
      if (!unsupported(last, options).empty()) {
        EXPECT_FALSE(unsupported(first, options).empty());
        continue;
      }
      World one(first, options), other(last, options);
      one.advance(16), other.advance(16);
      const std::size_t n = scene.model.bodies.size();
      EXPECT_TRUE(same_bits(std::span(one.motions()).last(n), std::span(other.motions()).first(n)))
          << "full: " << full << ", "
          << apart(scene.model.bodies, {one.motions().begin() + 1, one.motions().end()},
                   {other.motions().begin(), other.motions().end() - 1});
      ++compared, jointed += !scene.model.joints.empty();
    }
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(jointed, 150);
}

}  // namespace
}  // namespace cylon::engine
