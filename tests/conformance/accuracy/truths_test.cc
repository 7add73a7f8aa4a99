// The engine against every reference solution that concerns motion: file x quantity, by its default
// integrator at a tolerance.  The files were computed twice in 40 to 60 digits, most with a rigorous
// enclosure; nothing of them shares code with the engine or with reference/exact.
#include "tests/conformance/accuracy/runner.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace cylon::accuracy {
namespace {

constexpr double tolerance = 1e-10;  // asked of the engine, relative to the scales of the motion
constexpr double bound = 1e-9;       // an engine may misjudge its own error by ten
// Rounding of the initial state, of the file's 21 digits to a double and of every step, some hundreds of eps,
// is amplified by the motion itself.
constexpr double rounding = 1e-13;

struct Exception {
  double bound;
  const char* reason;
};
const std::map<std::string, Exception> exceptions = {
    {"dzhanibekov",
     {1e-7,
      "errors made on the way grow up to 2e4 times and more than the end value shows; stepping integrators "
      "in "
      "double reach 3e-9 to 8e-9 at best"}},
};

double allowed(const std::string& file, const TruthScene& scene) {
  const auto exception = exceptions.find(file);
  return exception != exceptions.end() ? exception->second.bound
                                       : std::max(bound, rounding * scene.conditioning);
}

class Truths : public testing::TestWithParam<std::string> {};

TEST_P(Truths, EngineAgreesWithFile) {
  const auto simulator = core::make_simulator();
  core::Setup setup;
  setup.integrator = "auto";
  setup.tolerance = tolerance;
  for (const TruthScene& truth : truth_scenes(GetParam())) {
    SCOPED_TRACE(truth.name);
    ASSERT_FALSE(truth.samples.empty());
    setup.dt = grids(truth.samples).front().spacing;
    const auto reason = simulator->unsupported(truth.scene, setup);
    if (reason) {
      ADD_FAILURE() << "the engine cannot express it: " << *reason;
      continue;
    }
    Deviations found;
    std::vector<std::string> remarks;
    for (const Grid& grid : grids(truth.samples))
      run(*simulator, truth.scene, setup, grid, 1, found, &remarks);
    const auto check = [&](const char* what, const Deviation& d) {
      if (!d.seen) return;
      fmt::print("{:28} {:17} error {:8.1e}  of {:8.1e}  relative {:8.1e}  allowed {:8.1e}\n", truth.name,
                 what, d.error, d.scale, d.relative(), allowed(GetParam(), truth));
      EXPECT_LE(d.relative(), allowed(GetParam(), truth)) << what;
    };
    check("position", found.position);
    check("velocity", found.velocity);
    check("orientation", found.orientation);
    check("angular velocity", found.angular_velocity);
    for (const std::string& remark : remarks) fmt::print("{:28} remark: {}\n", truth.name, remark);
  }
}

// composite_body holds no motion: composite_test.cc.
std::vector<std::string> moving() {
  std::vector<std::string> names = truth_names();
  std::erase(names, "composite_body");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Files, Truths, testing::ValuesIn(moving()),
                         [](const auto& parameter) { return parameter.param; });

TEST(TruthFiles, AllExist) {
  EXPECT_EQ(truth_names().size(), 46u);
  for (const auto& [name, exception] : exceptions)
    EXPECT_EQ(std::ranges::count(truth_names(), name), 1) << name;
}

// The comparison itself is tested on motions that are wrong by a known amount.
TEST(TruthFiles, DetectsError) {
  for (const std::string& name : moving()) {
    for (const TruthScene& truth : truth_scenes(name)) {
      const Sample& sample = truth.samples.back();
      core::State state(truth.scene.bodies.size());
      for (const Expected& e : sample.bodies)
        state[static_cast<std::size_t>(e.body)] = {
            e.position.value(), e.orientation.value_or(core::Quaternion::Identity()), e.velocity.value(),
            e.angular_velocity.value_or(core::Vector3::Zero())};
      Deviations none, shifted;
      compare(sample, state, none);
      EXPECT_LE(none.worst(), 1e-15) << truth.name;
      state[0].position += core::Vector3(0.6e-6, 0, 0.8e-6);
      state[0].velocity.y() -= 2e-6;
      compare(sample, state, shifted);
      EXPECT_NEAR(shifted.position.error, 1e-6, 1e-13) << truth.name;
      EXPECT_NEAR(shifted.velocity.error, 2e-6, 1e-13) << truth.name;
    }
  }
}

}  // namespace
}  // namespace cylon::accuracy
