// Lengths of right data were said to be 1 % short: the measured tilt of a cube that lies flat is an error of the measurement, and
// its corners counted as thickness.  Of the 275 tosses this made 0.965 of 0.978.
#include "harness/validation/length_scale.h"
#include "harness/validation/normal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace cylon::validation {
namespace {

// Cubes that fall from 0.3 m and then lie, seen with a tilt of 8 mrad about each level axis.
measured::Experiment tilted(double lengths) {
  constexpr double half = 0.05, rate = 100, g = 9.81;
  measured::Experiment e;
  e.rate = rate, e.bodies = {0};
  core::Body cube;
  cube.shape = core::Box{core::Vector3::Constant(half)};
  e.model.scene.bodies = {cube};
  e.model.scene.planes = {core::Plane{.name = "table", .normal = core::Vector3::UnitY(), .offset = 0.1}};
  e.model.scene.forces = {core::UniformGravity{{0, -g, 0}}};
  for (std::uint64_t run = 0; run < 40; ++run) {
    Normal normal(1, run, 0);
    const core::Quaternion lies(
        Eigen::AngleAxisd(std::numbers::pi / 2 * static_cast<double>(run % 4), core::Vector3::UnitX()));
    measured::Run& made = e.runs.emplace_back(measured::Run{std::to_string(run), {}});
    for (int i = 0; i < 60; ++i) {
      const double t = i / rate, fall = std::min(0.3, g / 2 * t * t);
      const core::Vector3 tilt = core::Vector3(normal(0.008), 0, normal(0.008));
      core::BodyState s;
      s.position = {0.2, 0.1 + lengths * (half + 0.3 - fall), 0};
      s.orientation = core::Quaternion(Eigen::AngleAxisd(tilt.norm(), tilt.normalized())) * lies;
      made.states.push_back({s});
    }
  }
  return e;
}

TEST(TiltCountedAsThickness, DoesNotAccuseRightLengths) {
  for (const double lengths : {1.0, 0.98}) {
    const LengthScale found = length_scale(tilted(lengths));
    EXPECT_EQ(found.rest.runs, 40u);
    EXPECT_NEAR(found.rest.value, lengths, 1e-9);
    EXPECT_NEAR(found.flight.value, lengths, 1e-3);
    EXPECT_NEAR(found.height.value, lengths * 0.05, 1e-9);
    EXPECT_NEAR(found.tilt, 0.008 * std::sqrt(2), 0.002);
    std::set<int> sides;
    for (const RunLengths& run : found.each) sides.insert(run.side);
    EXPECT_EQ(sides, (std::set<int>{-3, -2, 2, 3}));
  }
}

TEST(TiltCountedAsThickness, FallsOfWrongLengthsBend) {
  const auto bent = [](double lengths) {
    const std::vector<double> off = off_the_fall(tilted(lengths), 3);
    double most = 0;
    for (const double h : off) most = std::max(most, std::abs(h));
    EXPECT_GE(off.size(), 15u);
    return most;
  };
  EXPECT_LT(bent(1), 1e-9);
  EXPECT_GT(bent(0.98), 2e-4);
}

}  // namespace
}  // namespace cylon::validation
