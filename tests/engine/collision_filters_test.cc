// Groups and masks on every path of the engine: what they keep apart moves as each part does without the other.
#include "engine/methods.h"
#include "engine/world.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace cylon::engine {
namespace {

enum class Bodies { spheres, boxes, mixed };

// Bodies that fall on a floor, a pillar and each other; `shift` moves them along the floor, less than their size.
Model pile(Bodies kind, int count, Real restitution, Real friction, Real shift) {
  Model model = pile_model(restitution, friction);
  add_ball(model, 1, Real(0.4), {Real(0.3), Real(0.4), Real(0.2)});
  model.bodies.back() = make_body(1, Matrix3::Identity(), true);  // the pillar
  for (int i = 0; i < count; ++i) {
    const int layer = i / 4;
    const Real x = Real(0.71) * static_cast<Real>(i % 4) + shift,
               y = Real(1.2) + Real(0.75) * static_cast<Real>(layer),
               z = Real(0.13) * static_cast<Real>(i % 3) - shift;
    const Vector3 v = {Real(0.3) - shift, Real(-0.2) * static_cast<Real>(i % 2), Real(0.1)};
    if (kind == Bodies::boxes || (kind == Bodies::mixed && i % 2 == 0))
      add_box(model, Real(1.3), {Real(0.25), Real(0.2), Real(0.3)}, {x, y, z}, v,
              {Real(0.1), Real(0.5), Real(-0.3)});
    else
      add_ball(model, Real(0.8), Real(0.31), {x, y, z}, v, {Real(0.4), 0, Real(0.2)});
  }
  return model;
}

// Both piles in one place, which share the floor and have a pillar each; the second's numbers come last.
Model together(const Model& a, const Model& b) {
  Model both = a;
  const auto add = [](auto& list, const auto& more) { list.insert(list.end(), more.begin(), more.end()); };
  add(both.bodies, b.bodies), add(both.motions, b.motions), add(both.shapes, b.shapes),
      add(both.surfaces, b.surfaces);
  both.filters.assign(a.bodies.size(), {2, 2 | 8});
  both.filters.resize(both.bodies.size(), {4, 4 | 8});
  both.plane_filters.assign(both.planes.size(), {8, 2 | 4});
  return both;
}

struct Row {
  const char* name;
  Bodies kind;
  int count;
  Real restitution, friction;
  const char* path;
  bool full;
  Path taken;
  Real allowed;  // [m]; sweeps over a crowd go in the order of all, and have not converged
};

const Row rows[] = {
    {"ballistic", Bodies::spheres, 3, Real(0.7), 0, "", false, Path::ballistic, Real(1e-9)},
    {"ballistic crowd", Bodies::spheres, 30, Real(0.7), 0, "", false, Path::ballistic, Real(1e-9)},
    {"events", Bodies::spheres, 2, Real(0.6), Real(0.3), "events", false, Path::events, Real(1e-8)},
    {"events, full", Bodies::mixed, 1, Real(0.6), Real(0.3), "events", true, Path::events, Real(1e-8)},
    {"spheres in steps", Bodies::spheres, 30, Real(0.5), Real(0.4), "stepping", false, Path::stepping,
     Real(1e-9)},
    {"a crowd of spheres", Bodies::spheres, 300, 0, Real(0.4), "stepping", true, Path::stepping, Real(0.05)},
    {"boxes in steps", Bodies::boxes, 8, 0, Real(0.4), "stepping", false, Path::stepping, Real(1e-6)},
    // Alone to second order; together they are a crowd.
    {"boxes and spheres", Bodies::mixed, 24, 0, Real(0.4), "stepping", true, Path::stepping, Real(1e-4)},
    {"by default", Bodies::mixed, 6, Real(0.3), Real(0.2), "", false, Path::stepping, Real(1e-6)},
};

class Filters : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(CollisionFilters, Filters, testing::ValuesIn(rows), [](const auto& of) {
  std::string name = of.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

std::vector<Motion> run(const Model& model, const Row& row, int steps) {
  const Options options{.dt = 1. / 512, .path = row.path, .full = row.full};
  EXPECT_EQ(unsupported(model, options), "");
  World world(model, options);
  world.advance(steps);
  return world.motions();
}

Real distance(const std::vector<Motion>& all, std::size_t first, const std::vector<Motion>& part) {
  Real most = 0;
  for (std::size_t i = 0; i < part.size(); ++i)
    most = std::max(most, (all[first + i].position - part[i].position).norm());
  return most;
}

TEST_P(Filters, MovePartsAsIfAlone) {
  const Row& row = GetParam();
  constexpr int steps = 230;  // 0.45 s: what starts at 1.2 m has struck, and little chaos has grown
  const Model a = pile(row.kind, row.count, row.restitution, row.friction, Real(0.05)),
              b = pile(row.kind, row.count, row.restitution, row.friction, Real(-0.11));
  const Model both = together(a, b);
  EXPECT_EQ(make_plan(both, {.dt = 1. / 512, .path = row.path, .full = row.full}).path, row.taken);
  const std::vector<Motion> alone = run(a, row, steps), other = run(b, row, steps),
                            all = run(both, row, steps);
  EXPECT_LE(distance(all, 0, alone), row.allowed);
  EXPECT_LE(distance(all, a.bodies.size(), other), row.allowed);
  // The control: without filters the piles are in each other's way.
  Model met = both;
  met.filters.clear(), met.plane_filters.clear();
  EXPECT_GT(distance(run(met, row, steps), 0, alone), std::max(Real(0.01), 4 * row.allowed));
}

// What touches nothing falls through everything, in closed form.
TEST(CollisionFilters, GhostsFly) {
  Model model = pile(Bodies::boxes, 3, Real(0.5), Real(0.4), 0);
  model.filters.assign(model.bodies.size(), {2, 2});
  model.plane_filters = {{2, 2}};
  for (std::size_t i = 1; i < model.bodies.size(); ++i) model.filters[i] = {4u << i, 1};
  EXPECT_FALSE(can_touch(model));
  EXPECT_EQ(make_plan(model, {.dt = 0.01}).path, Path::exact);
  World world(model, {.dt = 0.01});
  world.advance(100);
  for (std::size_t i = 1; i < model.bodies.size(); ++i) {
    const Vector3 v = velocity(model.bodies[i], model.motions[i]);
    const Vector3 at = model.motions[i].position + v + model.forces.gravity / 2;
    EXPECT_LE((world.motions()[i].position - at).norm(), Real(1e-5)) << i;
  }
  EXPECT_TRUE(world.impacts().empty());
}

TEST(CollisionFilters, AskForBothMasks) {
  constexpr Filter admits{1, 2 | 4}, refuses{2, 2}, all{4, ~0u};
  static_assert(!may_meet(admits, refuses) && !may_meet(refuses, admits));
  static_assert(may_meet(admits, all) == may_meet(all, admits) && may_meet(admits, all));
  static_assert(!may_meet(refuses, all) && may_meet(refuses, refuses) && !may_meet(admits, admits));
  static_assert(may_meet(Filter{}, Filter{}));
}

// A seam between two slabs hides nothing from a ball that touches one of them alone: it falls off the end.
TEST(CollisionFilters, SeamsHideNothingOfWhatIsNotTouched) {
  for (const char* path : {"events", "stepping"}) {
    Model model = pile_model(0, 0, false);
    for (const Real x : {Real(-1), Real(1)}) {
      add_box(model, 1, {1, Real(0.1), 1}, {x, Real(-0.1), 0});
      model.bodies.back() = make_body(1, Matrix3::Identity(), true);
    }
    add_ball(model, 1, Real(0.2), {Real(-0.5), Real(0.2), Real(0.1)}, {1, 0, 0});
    const Options options{.dt = 1. / 512, .path = path};
    const auto end = [&] {
      World world(model, options);
      world.advance(512);
      return world.motions()[2].position;
    };
    EXPECT_NEAR(end().y(), 0.2, 1e-3) << path << ": over the seam";
    model.filters = {{1, 1}, {2, 2}, {1, 1}};
    // It leaves the slab at x = 0 with 1 m/s, turns over the edge and falls for most of a second's second half.
    const Vector3 fallen = end();
    EXPECT_LT(fallen.y(), -0.3) << path;
    EXPECT_GT(fallen.x(), 0.4) << path << ": the edge holds nothing back";
  }
}

// Bodies of many groups stay one island each.
TEST(CollisionFilters, KeepIslandsApart) {
  Model model = pile(Bodies::spheres, 6, Real(0.5), 0, 0);
  EXPECT_LT(World(model, {.dt = 0.01}).island_count(), 6u);
  model.filters.assign(model.bodies.size(), {1, 1});
  for (std::size_t i = 1; i < model.bodies.size(); ++i) model.filters[i] = {2u << i, 1};
  model.plane_filters = {{1, ~0u}};
  EXPECT_EQ(World(model, {.dt = 0.01}).island_count(), 6u);
}

}  // namespace
}  // namespace cylon::engine
