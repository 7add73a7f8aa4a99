// Slip that turns round while it passes through small speeds, where friction turns it without bound in rate.
//
// Below a hundred-thousandth of g dt friction used to keep the direction in which it found the slip: the slip
// went round in circles of 1e-6 m/s, thousands of times in a step, and left them 1e-7 m/s off.
#include "tests/engine/contact/contact_fixtures.h"

#include <numbers>

namespace cylon::engine {
namespace {

constexpr double g = 9.81, theta = 0.4, start = 0.7;

/// Slip u of a point of contact, u_x down the slope:  u' = a e_x - b u/|u|.  With phi the angle of u to e_x
/// and x = tan(phi/2), p = b/a:  d(ln u)/d(phi) = -cot(phi) + p/sin(phi), so that
///   |u| = c x^p/sin(phi),   t = c/(2a) [y^(p-1)/(p-1) + y^(p+1)/(p+1)] from y = x to x_0.
/// A sphere: a = g sin(theta), b = 7/2 mu g cos(theta), for friction F makes u' = F/m (1 + r^2 m/I).
class Turn {
 public:
  Turn(double friction, double angle)
      : a_(g * std::sin(theta)),
        p_(3.5 * friction * g * std::cos(theta) / a_),
        ln_x0_(std::log(std::tan(angle / 2))),
        c_(start * std::sin(angle) / std::exp(p_ * ln_x0_)) {}

  /// When slip ends; infinite where it does not.
  double end() const {
    return p_ > 1 ? c_ / (2 * a_) * sum(ln_x0_) : std::numeric_limits<double>::infinity();
  }
  /// (u_x, u_z) at t; by bisection in ln x.
  std::array<double, 2> at(double t) const {
    if (t >= end()) return {0, 0};
    double low = -500, high = ln_x0_;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (c_ / (2 * a_) * (sum(ln_x0_) - sum(middle)) > t ? low : high) = middle;
    }
    const double phi = 2 * std::atan(std::exp(low)), u = c_ * std::exp(p_ * low) / std::sin(phi);
    return {u * std::cos(phi), u * std::sin(phi)};
  }

 private:
  double sum(double ln_y) const {
    return std::exp((p_ - 1) * ln_y) / (p_ - 1) + std::exp((p_ + 1) * ln_y) / (p_ + 1);
  }
  double a_, p_, ln_x0_, c_;
};

// A ball is thrown up an incline, all but straight.  Its slip u falls to nearly nothing and turns round, or
// ends and it rolls.  u_x changes by (1 + 5/2) F/m where v_x does by F/m, so
//   v = v_0 + g_t t + 2/7 (u - u_0 - g_t t).
TEST(EventTurning, SlipPassesThroughSmallSpeeds) {
  const Vector3 normal(std::sin(theta), std::cos(theta), 0), down(std::cos(theta), -std::sin(theta), 0);
  constexpr double time = 0.5, radius = 0.2;
  for (const double friction : {0.1, 0.13, 0.2}) {  // 0.83, 1.08 and 1.66 times what would end slip
    for (double aside = 1; aside > 1e-10; aside /= 10) {
      const double angle = std::numbers::pi - aside;
      Model model = with_plane(normal, 0, {0, friction});
      const Vector3 thrown = start * (std::cos(angle) * down + std::sin(angle) * Vector3::UnitZ());
      add_sphere(model, 1.3, radius, radius * normal, thrown, Vector3::Zero());
      const Turn turn(friction, angle);
      Trial run(model, 0.01);
      run.until(time);
      const auto [x, z] = turn.at(time);
      const Vector3 slip = x * down + z * Vector3::UnitZ(), pull = g * std::sin(theta) * time * down;
      const Vector3 v = thrown + pull + 2.0 / 7 * (slip - thrown - pull);
      const bool rolls = turn.end() < time;
      // How it came to roll is no matter then: rounding of 1 m/s.
      const double bound = rolls ? 1e-13 : 1e-10;
      const Vector3 u = run.velocity(0) - radius * run.spin(0).cross(normal);
      EXPECT_LT((u - slip).norm(), bound) << friction << ' ' << aside;
      EXPECT_LT((run.velocity(0) - v).norm(), bound) << friction << ' ' << aside;
      EXPECT_EQ(run.stepper.held().at(0).holding.grip, rolls ? Grip::sticks : Grip::slides);
      EXPECT_TRUE(sentences(run.stepper.diagnostics()).empty()) << sentences(run.stepper.diagnostics())[0];
    }
  }
}

}  // namespace
}  // namespace cylon::engine
