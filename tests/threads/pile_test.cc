// The pile's threads: balls, and boxes in coloured contacts.
#include "tests/engine/pile/pile_fixtures.h"
#include "tests/engine/same_bits.h"

#include <gtest/gtest.h>

#include <vector>

namespace cylon::engine {
namespace {

constexpr int steps = 8;

std::vector<Motion> run(const Model& model, int threads) {
  PileSettings settings;
  settings.threads = threads, settings.direct_points = 0;
  return after(*make_pile(model, 1. / 120, settings), steps);
}

TEST(PileThreads, Balls) {
  const Model model = ball_pile(12, 16, 0, Real(0.5));
  EXPECT_TRUE(same_bits(run(model, 4), run(model, 1)));
}

TEST(PileThreads, Boxes) {
  Model model = pile_model(0, Real(0.5));
  for (int i = 0; i < 96; ++i)
    add_box(model, 1, Vector3(Real(0.5), Real(0.3), Real(0.4)),
            Vector3(Real(1.1) * static_cast<Real>(i % 8) + Real(0.05) * static_cast<Real>(i % 3),
                    Real(0.5) + Real(0.7) * static_cast<Real>(i / 32), static_cast<Real>(i / 8 % 4)),
            Vector3::Zero(), Vector3(Real(0.1), Real(0.2), 0));
  EXPECT_TRUE(same_bits(run(model, 4), run(model, 1)));
}

}  // namespace
}  // namespace cylon::engine
