// A pole on a cart of a millionth of its mass turns round under itself within a microsecond.  `auto` ended there: it
// went on to ever finer tolerances until rounding left no step small enough for one of them, and took that run, which
// had ended, for the finest.  The two finest runs that go on are taken, and a diagnostic says how far they part.
#include "tests/engine/joint_scenes.h"

#include <numbers>

namespace cylon::engine {
namespace {

constexpr Real cart = 1e-6, bob = 1, g = 9.81;

Model light_cart_pole() {
  Model model;
  add_body(model, make_body(cart, Matrix3::Identity()), {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  add_body(model, make_body(bob, Matrix3::Identity()), {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  model.forces.gravity = {0, -g, 0};
  model.joints.push_back({.type = joint_types::slider, .body = 0, .to_axis = Vector3::UnitX()});
  model.joints.push_back({.type = joint_types::distance, .body = 1, .to = 0, .length = 1});
  return model;
}

// With theta from the lowest place, theta'^2 = 2 g cos(theta)/(1 - m/(M + m) cos^2(theta)).  Over theta = pi/2 - s^2,
//   T/4 = int_0^sqrt(pi/2) 2 s sqrt((1 - m/(M + m) sin^2 s^2)/(2 g sin s^2)) ds,
// by Simpson's rule, finer than the thousandth of a radian in which the root bends.
double quarter() {
  const double share = bob / (bob + cart), end = std::sqrt(std::numbers::pi / 2);
  constexpr int parts = 1 << 20;
  const auto f = [&](double s) {
    const double c = std::sin(s * s);
    return s == 0 ? std::sqrt(2 / g) : 2 * s * std::sqrt((1 - share * c * c) / (2 * g * c));
  };
  double sum = f(0) + f(end);
  for (int i = 1; i < parts; ++i) sum += (i % 2 == 0 ? 2 : 4) * f(end * i / parts);
  return sum * end / parts / 3;
}

TEST(LightCartPole, IsFollowedThroughItsCrossings) {
  const double quarter_period = quarter();
  EXPECT_NEAR(quarter_period, 0.451524535681658864, 1e-12);  // the quadrature at 30 digits
  int crossings = 0;
  double was = 1;
  const Outcome end = run(light_cart_pole(), with("auto", 1.0 / 256), 2560, [&](const World& world) {
    const auto motions = world.motions();
    const double side = motions[1].position.x() - motions[0].position.x();
    if (side * was < 0) ++crossings;
    was = side;
    ASSERT_NEAR((motions[1].position - motions[0].position).norm(), 1, 1e-9) << world.time();
    // It is on the side of its swing.
    const auto swing = static_cast<long>(std::floor(world.time() / quarter_period));
    EXPECT_GT(side * ((swing + 1) / 2 % 2 == 0 ? 1 : -1), 0) << world.time();
  });
  EXPECT_EQ(crossings, 11);
  ASSERT_EQ(end.remarks.size(), 1u) << "the tolerance that rounding does not allow";
  EXPECT_NE(end.remarks.front().find("is not reached"), std::string::npos) << end.remarks.front();
  EXPECT_EQ(end.remarks.front().find("inf"), std::string::npos) << end.remarks.front();
}

}  // namespace
}  // namespace cylon::engine
