// The certified solution in double: as close as it says, known again from the cache, and honest about chaos.
#include "reference/certified/truth.h"
#include "reference/certified/cache.h"
#include "reference/certified/solve.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace cylon::certified {
namespace {

namespace fs = std::filesystem;

class CertifiedTruth : public testing::Test {
 protected:
  void SetUp() override { ::setenv("CYLON_CACHE", folder_.c_str(), 1); }
  void TearDown() override { ::unsetenv("CYLON_CACHE"); }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    if (fs::exists(folder_ / "certified"))
      for (const auto& entry : fs::directory_iterator(folder_ / "certified")) found.push_back(entry.path());
    return found;
  }
  const TemporaryFolder own_;
  const fs::path& folder_ = own_.path();
};

core::Scene pendulum(double length = 0.8) {
  core::Scene scene;
  core::Body bob;
  bob.name = "bob";
  bob.mass = 0.9;
  bob.inertia = core::Vector3(0.02, 0.03, 0.04).asDiagonal();
  bob.initial.position = {length, 0.3, -0.2};
  bob.initial.angular_velocity = {0.3, 1.7, -0.6};
  scene.bodies = {bob};
  scene.forces.emplace_back(core::UniformGravity{});
  scene.joints.push_back({core::JointType::ball, 0, core::world, {0.1, 0.4, 0.2}});
  return scene;
}

TEST_F(CertifiedTruth, IsWithinItsErrorOfTheBalls) {
  const Solution found = solution(pendulum(), 3);
  std::vector<double> times;
  for (int i = 0; i <= 37; ++i) times.push_back(3.0 * i / 37);
  const Certificate balls = certify(pendulum(), times);
  double position = 0, velocity = 0, spin = 0, angle = 0;
  for (const Sampled& sample : balls.samples) {
    const core::BodyState s = found.truth.state(sample.time)[0];
    const BodyBalls& b = sample.bodies[0];
    const auto off = [](const core::Vector3& got, const std::array<Ball, 3>& want) {
      return (got - core::Vector3(want[0].middle(), want[1].middle(), want[2].middle())).norm();
    };
    position = std::max(position, off(s.position, b.position));
    velocity = std::max(velocity, off(s.velocity, b.velocity));
    spin = std::max(spin, off(s.angular_velocity, b.angular_velocity));
    const core::Quaternion q(b.orientation[0].middle(), b.orientation[1].middle(), b.orientation[2].middle(),
                             b.orientation[3].middle());
    angle = std::max(angle, 2 * (q.coeffs() - s.orientation.coeffs()).norm());
  }
  constexpr double half_ulp = 0x1p-53;  // of the balls' midpoints as doubles, for lengths and rates up to 8
  EXPECT_LE(position, found.truth.error.position + 2 * half_ulp);
  EXPECT_LE(velocity, found.truth.error.velocity + 8 * half_ulp);
  EXPECT_LE(spin, found.truth.error.angular_velocity + 16 * half_ulp);
  EXPECT_LE(angle, found.truth.error.orientation + 4 * half_ulp);
  // And the error is no excuse: some roundings of numbers of about one.
  EXPECT_LT(found.truth.error.position, 1e-14);
  EXPECT_LT(found.truth.error.orientation, 1e-14);
  EXPECT_THROW(found.truth.state(3.1), std::invalid_argument);
}

TEST_F(CertifiedTruth, IsReadBackFromCache) {
  const Solution first = solution(pendulum(), 1);
  ASSERT_EQ(files().size(), 1u);
  const auto written = fs::last_write_time(files()[0]);
  const Solution second = solution(pendulum(), 1);
  EXPECT_EQ(files().size(), 1u);
  EXPECT_EQ(fs::last_write_time(files()[0]), written);
  EXPECT_EQ(first.truth.error.position, second.truth.error.position);
  EXPECT_EQ(first.ulp.size(), second.ulp.size());
  for (const double t : {0.0, 0.37, 1.0})
    EXPECT_EQ(first.truth.state(t)[0].position, second.truth.state(t)[0].position);

  core::Scene renamed = pendulum();
  renamed.bodies[0].name = "another";
  solution(renamed, 1);
  EXPECT_EQ(files().size(), 1u) << "a name is no physics";
  solution(pendulum(std::nextafter(0.8, 1)), 1);
  EXPECT_EQ(files().size(), 2u) << "a unit in the last place is";
  solution(pendulum(), 1.5);
  EXPECT_EQ(files().size(), 3u) << "and so is the horizon";
}

TEST_F(CertifiedTruth, RewritesDamagedCacheFile) {
  const core::State want = solution(pendulum(), 1).truth.state(0.6);
  const fs::path file = files().at(0);
  std::string bytes;
  {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    bytes = text.str();
  }
  std::string flipped = bytes;
  flipped[bytes.size() / 2] = static_cast<char>(flipped[bytes.size() / 2] ^ 1);
  for (const std::string& damaged :
       {std::string(), bytes.substr(0, bytes.size() - 5), flipped, bytes + "x"}) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << damaged;
    EXPECT_FALSE(load(file.stem().string()).has_value());
    EXPECT_EQ(solution(pendulum(), 1).truth.state(0.6)[0].position, want[0].position);
    EXPECT_TRUE(load(file.stem().string()).has_value());
  }
}

TEST_F(CertifiedTruth, WorksWithoutCache) {
  ::setenv("CYLON_CACHE", "off", 1);
  EXPECT_FALSE(cache_folder().has_value());
  const core::Vector3 want = solution(pendulum(), 1).truth.state(0.6)[0].position;
  EXPECT_TRUE(files().empty());
  std::ofstream(folder_ / "file") << "in the way";
  ::setenv("CYLON_CACHE", (folder_ / "file").c_str(), 1);
  EXPECT_EQ(solution(pendulum(), 1).truth.state(0.6)[0].position, want);
}

// Lengths grow with the motion's own rate: a pendulum upright multiplies an error by cosh(sqrt(g/l) t).
TEST_F(CertifiedTruth, ReportsErrorGrowth) {
  core::Scene scene = pendulum();
  scene.bodies[0].initial.position = {0.1, 0.4 + 0.5, 0.2};
  scene.bodies[0].initial.angular_velocity = {0, 1e-3, 0};
  const Solution found = solution(scene, 4);
  const core::Matrix3& inertia = scene.bodies[0].inertia;
  const double l = 0.5, m = 0.9, rate = std::sqrt(m * 9.81 * l / (inertia(0, 0) + m * l * l));
  const core::StateError first = found.ulp.front().error, last = found.ulp.back().error;
  const double growth =
      std::log(last.orientation / first.orientation) / (found.ulp.back().time - found.ulp.front().time);
  EXPECT_NEAR(growth, rate, 0.15 * rate);  // the start is not yet exponential
  EXPECT_FALSE(found.lost);
}

}  // namespace
}  // namespace cylon::certified
