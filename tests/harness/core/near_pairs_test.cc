// Pairs from a grid are those that overlap among all pairs, and the gaps that are measured over them are the
// same.
#include "harness/core/near_pairs.h"

#include "harness/core/observable.h"
#include "harness/core/worst.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cylon::core {
namespace {

struct Field {
  const char* name;
  double side, smallest, largest;  ///< Of the cube that holds the centres, and radii [m].
  double far_off;                  ///< Share of bodies that have been thrown out of it.
};

Scene scene_of(const Field& field, int count, std::mt19937& random) {
  const auto any = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  Scene scene;
  scene.planes = {{.name = "floor", .normal = Vector3(0.2, 0.9, -0.1).normalized(), .offset = 0.3},
                  {.name = "wall", .normal = {1, 0, 0}, .offset = -0.2}};
  const std::vector<std::vector<std::string>> lists = {{}, {"x"}, {"default"}, {"default", "x"}};
  scene.planes[1].collision_mask = lists[static_cast<std::size_t>(count) % 4];
  for (int i = 0; i < count; ++i) {
    Body body;
    if (i % 7 == 0) body.collision_groups = lists[static_cast<std::size_t>(i / 7) % 4];
    if (i % 5 == 0) body.collision_mask = lists[static_cast<std::size_t>(i / 5) % 4];
    body.name = std::to_string(i);
    body.shape = Sphere{field.smallest * std::pow(field.largest / field.smallest, any(0, 1))};
    body.collide = random() % 9 != 0;
    body.locked = random() % 5 == 0;
    body.initial.position = {any(0, field.side), any(0, field.side), any(0, field.side)};
    if (any(0, 1) < field.far_off) body.initial.position *= std::pow(10, any(3, 40));
    scene.bodies.push_back(body);
  }
  return scene;
}

// The gap of every pair, one after another.
std::vector<double> pair_by_pair(const Scene& scene, const State& state) {
  std::vector<double> gaps;
  for (const Pair& pair : touching_pairs(scene)) {
    const double g = gap(scene, pair, state);
    gaps.push_back(g >= 0 ? 0 : g);
  }
  return gaps;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(NearPairs, GapsAgreeWithAllPairs) {
  const Field fields[] = {{"dense", 3, 0.1, 0.3, 0},
                          {"one size", 4, 0.25, 0.25, 0},
                          {"a few giants", 9, 0.05, 6, 0},
                          {"sparse", 300, 0.1, 0.9, 0},
                          {"thrown far", 3, 0.1, 0.3, 0.2}};
  const Observable q{.quantity = Quantity::normal_gap};
  std::mt19937 random(7);
  int overlapping = 0, poisoned = 0;
  for (const Field& field : fields)
    for (int trial = 0; trial < 12; ++trial) {
      const Scene scene = scene_of(field, 120, random);
      const State start = initial_state(scene);
      State later = initial_state(scene_of(field, 120, random));
      if (trial == 10) later[7].position.y() = std::nan("");
      if (trial == 11) later[7].position.x() = later[8].position.x() = INFINITY;
      Values a, b;
      evaluate(q, scene, start, a), evaluate(q, scene, later, b);
      const std::vector<double> from = pair_by_pair(scene, start), to = pair_by_pair(scene, later);
      double parted = 0, deepest = 0;
      for (std::size_t i = 0; i < from.size(); ++i) {
        parted = worst(std::abs(to[i] - from[i]), parted), deepest = worst(std::abs(to[i]), deepest);
        overlapping += to[i] < 0;
      }
      EXPECT_TRUE(same(distance(q, b, a), parted)) << field.name << ' ' << distance(q, b, a) << ' ' << parted;
      EXPECT_TRUE(same(distance(q, a, b), parted)) << field.name;
      EXPECT_TRUE(same(magnitude(q, b), deepest)) << field.name;
      poisoned += std::isnan(parted);
    }
  EXPECT_GT(overlapping, 1000);
  EXPECT_GT(poisoned, 2);
}

TEST(NearPairs, AreFewForManyBodies) {
  std::mt19937 random(11);
  const Scene scene = scene_of({"gas", 40, 0.2, 0.4, 0}, 20000, random);
  const std::size_t pairs = near_pairs(scene, initial_state(scene)).size();
  EXPECT_LT(pairs, 20000u * 20);  // two planes, and half of 27 cells with a third of a ball in each
  EXPECT_GT(pairs, 20000u);
}

// A mesh that may touch a body has no gap; beside planes it has.  A box has one.
TEST(NearPairs, ShapesWithoutGapGiveReason) {
  std::mt19937 random(13);
  Scene scene = scene_of({"gas", 4, 0.2, 0.4, 0}, 10, random);
  const Observable q{.quantity = Quantity::normal_gap};
  EXPECT_FALSE(undefined_in(q, scene));
  scene.bodies[3].shape = Box{{0.1, 0.2, 0.3}}, scene.bodies[3].collide = true,
  scene.bodies[3].locked = false;
  EXPECT_FALSE(undefined_in(q, scene));
  scene.bodies[3].shape = Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
  EXPECT_TRUE(undefined_in(q, scene));
  for (Body& body : scene.bodies) body.collide = &body == &scene.bodies[3];
  EXPECT_FALSE(undefined_in(q, scene));
  scene.planes.clear();
  EXPECT_EQ(undefined_in(q, scene), "no two things in the scene may touch");
}

}  // namespace
}  // namespace cylon::core
