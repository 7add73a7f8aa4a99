// Orders in single precision: observable only between too large steps and the rounding floor.
#include "tests/engine/float/fixtures.h"

namespace cylon::engine {
namespace {

class FloatOrder : public EveryIntegrator {};

// Errors against the best that float has, rk8 with steps that leave truncation below rounding.  A run of n
// steps rounds some sqrt(n) times, thirty of which are clear of it: the bound of what counts as rounding.
Real rounded(int n) { return 30 * std::sqrt(static_cast<Real>(n)) * rounding; }

// Two steps in a row that are clear of rounding, the finer of them below 0.05 (places and momenta are of size
// 1), lie where the first term of the error leads.  Orders 6 and 8 have no such two: what a step of 1/16
// leaves is rounding.
TEST_P(FloatOrder, IsObservedAboveRounding) {
  const Integrator& integrator = GetParam();
  const Model model = coupled_bodies();
  const auto exact = run(model, "rk8", 1, 256).motions;
  const auto error_of = [&](int n) { return distance(run(model, integrator.name, 1, n).motions, exact); };
  if (integrator.order >= 6) {
    EXPECT_LT(error_of(64), rounded(64));
    return;
  }
  Real slope = 0, last = 0;
  for (int n = 4; n <= 4096; n *= 2) {
    const Real error = error_of(n);
    if (error < rounded(n)) break;
    if (last > 0 && error < real(0.05)) slope = std::log2(last / error);
    last = error;
  }
  EXPECT_GT(slope, static_cast<Real>(integrator.order) - real(0.6));
  if (integrator.order <= 2) {
    EXPECT_NEAR(slope, integrator.order, 0.15);
  }
}

CYLON_EVERY_SCHEME(FloatOrder);

}  // namespace
}  // namespace cylon::engine
