// A cone that rolled on its side sank to 1.29e-5 m, the overlap that was left alone, whatever the step: each step ends off the
// plane by the square of the step, and only what was deeper was taken away.
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

// Rolls about its tip with the contact line turning; the height of its centre of mass is constant.
TEST(RollingCone, DoesNotSinkAsTheStepShrinks) {
  const Real r = Real(0.1), l = Real(0.3), mass = Real(1.3), half = std::atan2(r, l);
  const Frustum cone{r, 0, -l / 4, 3 * l / 4};
  const Real across = Real(3) / 80 * mass * (4 * r * r + l * l);
  const Body body =
      make_body(mass, Vector3(across, Real(0.3) * mass * r * r, across).asDiagonal().toDenseMatrix());
  // The tip at the origin, the line of contact along -x.
  const Real height = 3 * l / 4 * std::sin(half), spin = 2;
  const Quaternion lies(Eigen::AngleAxis<Real>(-(std::acos(Real(0)) + half), Vector3::UnitZ()));
  const Vector3 centre(-3 * l / 4 * std::cos(half), height, 0);
  const auto sunk = [&](double dt) {
    Model model = pile_model(0, Real(0.9));
    add_body(model, body, cone, centre, Vector3(spin, 0, 0).cross(centre), Vector3(spin, 0, 0), lies);
    const auto pile = make_pile(model, dt);
    Real most = 0;
    for (int k = 0; k < static_cast<int>(std::lround(1 / dt)); ++k) {
      const auto now = after(*pile, 1);
      most = std::max(most, std::abs(now[0].position.y() - height));
    }
    return most;
  };
  const Real a = sunk(0.01), b = sunk(0.005), c = sunk(0.0025);
  EXPECT_LT(c, 3e-6);
  EXPECT_GT(std::log2(a / b), 1.6) << a << ' ' << b << ' ' << c;
  EXPECT_GT(std::log2(b / c), 1.6) << a << ' ' << b << ' ' << c;
}

}  // namespace
}  // namespace cylon::engine
