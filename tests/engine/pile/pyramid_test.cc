// A pyramid under a load stands, whatever the load: Newton's steps of a round were cut off at sixty, and the
// rounds ran away from impulses that balanced nothing. Ten rows under 300 times a box's mass, or under 1000.
#include "engine/pile/body_pile.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

struct Load {
  int rows;
  Real top;  // [kg]
};

Model pyramid(const Load& load) {
  Model model = pile_model(0, Real(0.5));
  for (int row = 0; row < load.rows; ++row)
    for (int k = 0; k < load.rows - row; ++k)
      add_box(model, row == load.rows - 1 ? load.top : 1, Vector3::Constant(Real(0.5)),
              Vector3(Real(1.1) * (static_cast<Real>(k) - Real(0.5) * static_cast<Real>(load.rows - 1 - row)),
                      Real(0.5) + static_cast<Real>(row), 0));
  return model;
}

class PilePyramid : public testing::TestWithParam<Load> {};

TEST_P(PilePyramid, Stands) {
  const Model model = pyramid(GetParam());
  pile::BodyPile pile(model, 1. / 60, PileSettings{});
  const auto end = after(pile, 12);
  // The load's impulse in a step is rounded by eps of itself at a body of a kilogram; eight contacts share it
  // and ten rows pass it on: measured 7e-14 m/s, and 7e-15 m after twelve steps, under 1000 kg.
  const Real rounding = 100 * eps * GetParam().top * g / 60;
  EXPECT_LT(pile.residual(), static_cast<double>(rounding));
  for (std::size_t i = 0; i < end.size(); ++i)
    EXPECT_LT((end[i].position - model.motions[i].position).norm(), rounding * Real(12. / 60)) << i;
}

INSTANTIATE_TEST_SUITE_P(All, PilePyramid,
                         testing::Values(Load{4, 37}, Load{9, 300}, Load{10, 100}, Load{10, 300},
                                         Load{10, 1000}));

}  // namespace
}  // namespace cylon::engine
