// Boxes that rest stay where they are: 10^6 steps, over an hour of their time.
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace cylon::engine {
namespace {

class PileCreep : public testing::TestWithParam<int> {};

TEST_P(PileCreep, IsLessThanANanometreInAMillionSteps) {
  Model model = pile_model(0, Real(0.5));
  for (int i = 0; i < GetParam(); ++i)
    add_box(model, 1, Vector3::Constant(Real(0.5)),
            Vector3(Real(0.3), Real(0.5) + static_cast<Real>(i), Real(-0.2)));
  const auto stepper = make_pile(model, 1. / 240);
  const auto start = after(*stepper, 1000);  // settled
  const auto end = after(*stepper, 1000000);
  Real worst = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    Vector3 d = end[i].position - start[i].position;
    d.y() = 0;
    worst = std::max(worst, d.norm());
  }
  EXPECT_LT(worst, Real(1e-9));  // along the floor nothing pulls: what moves them is rounding
}

INSTANTIATE_TEST_SUITE_P(Boxes, PileCreep, testing::Values(1, 10));

}  // namespace
}  // namespace cylon::engine
