// A cart between two stops, with dry friction, that a pole swings on, was followed event by event only to 0.237 s of 1 s:
// operations of contacts were counted as if every row of a joint were a joint of four, so that what a run may
// spend was spent fifty times too early, and the rest went in steps of first order (the pole ended 6e-4 m off).
#include "tests/engine/joint_scenes.h"

#include <array>

namespace cylon::engine {
namespace {

constexpr Real cart = 1.5, pole = 0.4, about = 0.02, damping = 0.02, friction = 0.4, stop = 0.05,
               bounce = 0.5, g = 9.81;
const Vector3 arm = {0.3, 0.2, 0};

Model cart_and_pole() {
  Model model;
  add_body(model, make_body(cart, Vector3(0.1, 0.2, 0.15).asDiagonal()), {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
           {0, 0, 0});
  add_body(model, make_body(pole, Vector3(about, 0.002, about).asDiagonal()), arm, {0, 0, 0}, {0, 0, 0},
           {0, 0, 0});
  model.forces.gravity = {0, -g, 0};
  model.joints.push_back({.type = joint_types::slider, .body = 0, .to_axis = Vector3::UnitX()});
  model.joints.push_back({.type = joint_types::hinge,
                          .body = 1,
                          .anchor = -arm,
                          .to = 0,
                          .axis = Vector3::UnitZ(),
                          .to_axis = Vector3::UnitZ()});
  CoordinateLaw rail, pivot;
  rail.at.axis = Vector3::UnitX();
  rail.lower = -stop, rail.upper = stop, rail.restitution = bounce, rail.friction = friction;
  pivot.at.kind = Coordinate::Kind::angle;
  pivot.at.body = 1, pivot.at.to = 0;
  pivot.at.axis = Vector3::UnitZ(), pivot.at.zero = pivot.at.mark = Vector3::UnitX();
  pivot.damping = damping;
  model.forces.coordinate_laws = {rail, pivot};
  return model;
}

// The same by hand, in the place x of the cart and the angle a of the pole's arm of length l:
//   (M + m) x'' - m l sin a a'' - m l cos a a'^2 = -F sign(x'),   (I + m l^2) a'' - m l sin a x'' = -m g l cos a - c a',
// by small steps of the classical Runge-Kutta scheme; at a stop x' turns round to -e x', by an impulse along x alone.
struct ByHand {
  using State = std::array<double, 4>;  // x, a, x', a'
  State y = {0, std::atan2(arm.y(), arm.x()), 0, 0};
  const double l = arm.norm(), turning = about + pole * l * l;
  double way = 0;  // of the friction: the sign of x', 0: it holds
  int bounces = 0, turns = 0;

  double coupling(double a) const { return pole * l * std::sin(a); }
  // The force along x that keeps x'' = 0 is  -m l (sin a a'' + cos a a'^2).
  double held(const State& s) const {
    const double turned = (-pole * g * l * std::cos(s[1]) - damping * s[3]) / turning;
    return -coupling(s[1]) * turned - pole * l * std::cos(s[1]) * s[3] * s[3];
  }
  State rate(const State& s) const {
    const double k = coupling(s[1]), push = pole * l * std::cos(s[1]) * s[3] * s[3] - way * friction,
                 swing = -pole * g * l * std::cos(s[1]) - damping * s[3];
    if (way == 0) return {0, s[3], 0, swing / turning};
    const double det = (cart + pole) * turning - k * k;
    return {s[2], s[3], (turning * push + k * swing) / det, (k * push + (cart + pole) * swing) / det};
  }
  State after(double h) const {
    const auto plus = [&](const State& k, double part) {
      State z = y;
      for (std::size_t i = 0; i < 4; ++i) z[i] += part * k[i];
      return z;
    };
    const State k1 = rate(y), k2 = rate(plus(k1, h / 2)), k3 = rate(plus(k2, h / 2)), k4 = rate(plus(k3, h));
    State z = y;
    for (std::size_t i = 0; i < 4; ++i) z[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    return z;
  }
  // Whether something ends before such a state: a flight, a slip, a hold.
  bool over(const State& s) const {
    return way == 0 ? std::abs(held(s)) > friction : std::abs(s[0]) > stop || s[2] * way < 0;
  }
  void choose() {
    if (std::abs(y[0]) >= stop && y[2] * y[0] > 0) {
      const double k = coupling(y[1]), change = -(1 + bounce) * y[2];
      y[2] += change, y[3] += k * change / turning;
      y[0] = std::copysign(stop, y[0]);
      way = std::copysign(1, y[2]);
      ++bounces;
      return;
    }
    const double force = held(y);  // that friction has to give
    way = std::abs(force) > friction ? std::copysign(1, -force) : 0;
    y[2] = 0;
    ++turns;
  }
  void go(double h) {
    while (h > 0) {
      State end = after(h);
      if (!over(end)) {
        y = end;
        return;
      }
      double low = 0, high = h;
      while (high - low > 1e-15) {
        const double middle = (low + high) / 2;
        (over(after(middle)) ? high : low) = middle;
      }
      y = after(high), h -= high;
      choose();
    }
  }
};

TEST(CartAtItsStops, IsFollowedToTheEnd) {
  ByHand hand;
  hand.choose();
  std::vector<std::array<double, 4>> exact;
  for (int i = 0; i < 1000; ++i) {
    for (int k = 0; k < 20; ++k) hand.go(1e-3 / 20);
    exact.push_back(hand.y);
  }
  EXPECT_GE(hand.bounces, 2);
  EXPECT_GE(hand.turns, 2);
  for (const char* integrator : {"auto", "rk8"})
    for (const bool constraints : {false, true}) {
      Options options = with(integrator, 1e-3);
      options.constraints = constraints;
      std::size_t i = 0;
      const Outcome end = run(cart_and_pole(), options, 1000, [&](const World& world) {
        const auto& [x, a, u, w] = exact[i++];
        const Vector3 held = world.motions()[1].orientation * arm;
        ASSERT_NEAR(world.motions()[0].position.x(), x, 1e-10) << integrator << world.time();
        ASSERT_NEAR(std::atan2(held.y(), held.x()), a, 1e-9) << integrator << world.time();
      });
      EXPECT_TRUE(end.remarks.empty()) << end.remarks.front();
    }
}

}  // namespace
}  // namespace cylon::engine
