// Columns that do not go together: what a wrong line of the description makes of right data.
#include "harness/validation/kinematics.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <string>

namespace cylon::validation {
namespace {

using core::BodyState, core::Quaternion, core::Vector3;

// Bodies that fly on a parabola and spin about a fixed axis, at 100 frames a second.
measured::Experiment flights(const std::function<void(BodyState&)>& change) {
  measured::Experiment e;
  e.rate = 100, e.bodies = {0};
  for (int run = 0; run < 8; ++run) {
    const Vector3 v(0.4 + 0.05 * run, 1.5, -0.3), spin(3, -1 + 0.2 * run, 5);
    measured::Run& made = e.runs.emplace_back(measured::Run{.name = std::to_string(run)});
    for (int k = 0; k < 40; ++k) {
      const double t = 0.01 * k;
      BodyState s{.position = Vector3(0, 1, 0) + v * t - Vector3(0, 4.905 * t * t, 0),
                  .orientation = Quaternion(Eigen::AngleAxisd(spin.norm() * t, spin.normalized())) *
                                 Quaternion(0.5, 0.5, -0.5, 0.5),
                  .velocity = v - Vector3(0, 9.81 * t, 0),
                  .angular_velocity = spin};
      change(s);
      made.states.push_back({s});
    }
  }
  return e;
}

struct Mistake {
  const char* name;
  std::function<void(BodyState&)> change;
  Answer velocity, spin;
};

class Kinematic : public testing::TestWithParam<Mistake> {};

TEST_P(Kinematic, MistakesShow) {
  const Kinematics found = kinematics(flights(GetParam().change));
  EXPECT_EQ(goes_together(found.velocity), GetParam().velocity) << found.velocity.value;
  EXPECT_EQ(goes_together(found.spin), GetParam().spin) << found.spin.value;
}

constexpr Answer yes = Answer::inside, no = Answer::outside;

INSTANTIATE_TEST_SUITE_P(
    Columns, Kinematic,
    testing::Values(
        Mistake{"None", [](BodyState&) {}, yes, yes},
        Mistake{"DegreesAsRadians", [](BodyState& s) { s.angular_velocity *= 180 / std::numbers::pi; }, yes,
                no},
        Mistake{"BodyAxesAsWorld",
                [](BodyState& s) { s.angular_velocity = s.orientation.conjugate() * s.angular_velocity; },
                yes, no},
        Mistake{"QuaternionWithItsRealPartLast",
                [](BodyState& s) {
                  s.orientation.coeffs() =
                      Eigen::Vector4d(s.orientation.coeffs().tail<1>()[0], s.orientation.x(),
                                      s.orientation.y(), s.orientation.z());
                },
                yes, no},
        Mistake{"PositionsInMillimetres", [](BodyState& s) { s.position *= 1000; }, no, yes},
        Mistake{"AxesOfPositionsSwapped", [](BodyState& s) { std::swap(s.position.x(), s.position.y()); }, no,
                yes},
        Mistake{"TwiceTheRate", [](BodyState& s) { s.velocity *= 2, s.angular_velocity *= 2; }, no, no}),
    [](const auto& mistake) { return std::string(mistake.param.name); });

// One run has no interval, and a body that does not move says nothing.
TEST(Kinematic, OfOneRunAndOfNoMotion) {
  measured::Experiment e =
      flights([](BodyState& s) { s.angular_velocity.setZero(), s.orientation = Quaternion::Identity(); });
  e.runs.resize(1);
  const Kinematics found = kinematics(e);
  EXPECT_EQ(goes_together(found.velocity), Answer::inside);
  EXPECT_EQ(goes_together(found.spin), Answer::undecided);
}

}  // namespace
}  // namespace cylon::validation
