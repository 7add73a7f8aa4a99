// The direct solution was for whole scenes of at most 512 contact points: ten columns of twelve cubes stood
// exactly, thirteen leaned by 12 mm, and ten cubes under 1000 times their mass gave way once there were
// bystanders.  Now each group of bodies that touch is solved by itself.
#include "engine/pile/groups.h"
#include "engine/pile/body_pile.h"
#include "tests/engine/pile/pile_fixtures.h"
#include "tests/engine/same_bits.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

constexpr Real half = Real(0.5);

Model columns(int count, int height, Real top = 1) {
  Model model = pile_model(0, Real(0.5));
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < height; ++k)
      add_box(model, k + 1 < height ? 1 : top, Vector3::Constant(half),
              {Real(1.5) * static_cast<Real>(i), half + static_cast<Real>(k), 0});
  return model;
}

Real farthest(const std::vector<Motion>& from, const std::vector<Motion>& to) {
  Real most = 0;
  for (std::size_t i = 0; i < from.size(); ++i)
    most = std::max({most, (to[i].position - from[i].position).norm(), to[i].orientation.vec().norm()});
  return most;
}

TEST(PileGroups, ThirteenColumnsStand) {
  const Model model = columns(13, 12);
  const auto end = after(*make_pile(model, 1. / 60), 60);
  EXPECT_LT(farthest(model.motions, end), 1e-8);
}

TEST(PileGroups, BystandersDoNotMatterToALoad) {
  Model model = columns(1, 11, 1000);
  for (int i = 0; i < 130; ++i)
    add_box(model, 1, Vector3::Constant(half), {Real(1.5) * static_cast<Real>(i), half, 5});
  const auto end = after(*make_pile(model, 1. / 60), 60);
  EXPECT_LT(farthest(model.motions, end), 1e-8);
}

// A group that is too large is swept, while the others stand.
TEST(PileGroups, LargeGroupDoesNotDisturbSmallOnes) {
  Model model = columns(3, 12);
  const std::size_t small = model.bodies.size();
  for (int i = 0; i < 12; ++i)  // a wall whose boxes touch side by side
    for (int k = 0; k < 12; ++k)
      add_box(model, 1, Vector3::Constant(half),
              {static_cast<Real>(i) + (k % 2 == 0 ? 0 : half), half + static_cast<Real>(k), 5});
  auto end = after(*make_pile(model, 1. / 60), 30);
  auto start = model.motions;
  EXPECT_TRUE(std::all_of(end.begin(), end.end(), [](const Motion& m) { return m.position.allFinite(); }));
  EXPECT_LT(farthest(start, end), 0.1);
  start.resize(small), end.resize(small);
  EXPECT_LT(farthest(start, end), 1e-8);
}

// Seven squares on each other, of 7^2, 6^2, … 1 cubes: 140, on a plane that is tilted by `tilt` rad.
Model tilted_pyramid(double tilt, Real friction) {
  Model model = pile_model(0, friction);
  model.forces.gravity =
      g * Vector3(0, -static_cast<Real>(std::cos(tilt)), static_cast<Real>(std::sin(tilt)));
  for (int side = 7; side > 0; --side)
    for (int i = 0; i < side * side; ++i) {
      const int column = i % side, row = i / side;
      const Real from = Real(-0.55) * static_cast<Real>(side - 1);
      add_box(model, 1, Vector3::Constant(half),
              {from + Real(1.1) * static_cast<Real>(column), half + static_cast<Real>(7 - side),
               from + Real(1.1) * static_cast<Real>(row)});
    }
  return model;
}

TEST(PileGroups, APyramidStandsThatIsTooLargeForEveryStep) {
  for (const double tilt : {0.0, 0.1}) {
    const Model model = tilted_pyramid(tilt, Real(0.5));
    const auto end = after(*make_pile(model, 1. / 60), 60);
    EXPECT_LT(farthest(model.motions, end), 1e-8) << tilt;
  }
}

// The solution of a pyramid that slides did not end in minutes.  It gives up now, and the pyramid moves as if it had not been
// asked whether it stands.
TEST(PileGroups, WhatSlidesFromTheStartCostsABoundedStep) {
  const Model model = tilted_pyramid(0.3, Real(0.2));
  pile::BodyPile pile(model, 1. / 60, PileSettings{});
  const auto first = after(pile, 1);
  constexpr std::int64_t points = 16 * 140;  // at most: each box lies on four others, on four points of each
  EXPECT_LT(pile.operations(), PileSettings{}.standing_work * points);
  PileSettings unasked;
  unasked.standing_points = 0;
  pile::BodyPile other(model, 1. / 60, unasked);
  EXPECT_TRUE(same_bits(first, after(other, 1)));
  EXPECT_TRUE(same_bits(after(pile, 29), after(other, 29)));
}

TEST(PileGroups, AreTiedByMovingBodiesOnly) {
  std::vector<pile::Mover> movers(5);
  for (const std::size_t i : {0u, 1u, 2u, 4u}) movers[i].inverse_mass = 1;
  const auto block = [](int a, int b) {
    pile::Block made;
    made.a = a, made.b = b;
    return made;
  };
  // 3 is locked: 0 and 4 lie on it, 1 on 2.
  const auto groups = find_groups({block(0, 3), block(1, 2), block(3, 4), block(0, fixed_world)}, movers);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].bodies, (std::vector{0, 3}));
  EXPECT_EQ(groups[0].blocks, (std::vector{0, 3}));
  EXPECT_EQ(groups[1].bodies, (std::vector{1, 2}));
  EXPECT_EQ(groups[2].bodies, (std::vector{3, 4}));
}

}  // namespace
}  // namespace cylon::engine
