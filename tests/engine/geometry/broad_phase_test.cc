// The broad phase against a test of all pairs.
#include "engine/geometry/broad_phase.h"

#include "tests/engine/geometry/geometry_shapes.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

using namespace geometry_test;

std::vector<BroadPhase::Pair> slow_pairs(const std::vector<Bounds>& all) {
  std::vector<BroadPhase::Pair> pairs;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const Bounds &a = all[i], &b = all[j];
      bool meet = true;
      for (int k = 0; k < 3; ++k)
        meet = meet && a.low[k] <= a.high[k] && b.low[k] <= b.high[k] && a.low[k] <= b.high[k] &&
               b.low[k] <= a.high[k];
      if (meet) pairs.emplace_back(static_cast<int>(i), static_cast<int>(j));
    }
  return pairs;
}

struct Scene {
  std::string name;
  int count;
  Real width;        // of the positions
  Real least, most;  // half extents, spread over their logarithm
  Vector3 flatten = Vector3::Ones();
};

std::vector<Bounds> scene(const Scene& s, std::uint64_t seed) {
  Sequence random(seed);
  std::vector<Bounds> all;
  for (int i = 0; i < s.count; ++i) {
    const Vector3 x = s.width * random.vector().cwiseProduct(s.flatten) + Vector3(-7, 100, 3);
    Vector3 half;
    for (int k = 0; k < 3; ++k) half[k] = s.least * std::pow(s.most / s.least, (random.next() + 1) / 2);
    all.push_back({x - half, x + half});
  }
  return all;
}

TEST(GeometryBroadPhase, AgreesWithAllPairsTest) {
  BroadPhase phase;  // one for all scenes: nothing of one is left in the next
  const Real infinity = std::numeric_limits<Real>::infinity();
  for (const Scene& s :
       {Scene{"equal", 800, 5, Real(0.4), Real(0.4)}, Scene{"sparse", 500, 300, Real(0.4), 1},
        Scene{"sizes over five decades", 600, 5, Real(1e-4), 10},
        Scene{"flat", 700, 20, Real(0.3), 1, {1, Real(0.001), 1}},
        Scene{"crowded", 200, Real(0.1), Real(0.4), Real(0.5)},
        Scene{"points", 300, 1, Real(1e-30), Real(1e-29)},
        Scene{"points and a giant", 300, Real(1e6), Real(1e-6), Real(1e6)}, Scene{"one", 1, 1, 1, 1},
        Scene{"none", 0, 1, 1, 1}})
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      std::vector<Bounds> all = scene(s, seed);
      EXPECT_EQ(phase.pairs(all), slow_pairs(all)) << s.name;
      if (all.size() < 100) continue;
      all[7] = {Vector3::Constant(infinity), Vector3::Constant(-infinity)};  // without shape
      all[20] = {Vector3(-infinity, 90, -infinity), Vector3(infinity, 100, infinity)};
      all[90] = {Vector3(0, -infinity, 0), Vector3(1, infinity, 1)};
      EXPECT_EQ(phase.pairs(all), slow_pairs(all)) << s.name << " with unbounded ones";
    }
}

// A lattice of touching cubes: neighbours share planes exactly, and all of them are pairs.
TEST(GeometryBroadPhase, TouchingBoxesAreAPair) {
  std::vector<Bounds> all;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      for (int z = 0; z < 6; ++z) {
        const Vector3 low(static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z));
        all.push_back({low, low + Vector3::Ones()});
      }
  BroadPhase phase;
  EXPECT_EQ(phase.pairs(all), slow_pairs(all));
  // ordered neighbours: (3 n - 2)^3 less the cube itself, halved
  EXPECT_EQ(phase.pairs(all).size(), (16u * 16u * 16u - 216u) / 2);
}

}  // namespace
}  // namespace cylon::engine
