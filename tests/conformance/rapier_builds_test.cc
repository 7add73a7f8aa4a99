// Rapier's two builds: the plain one and that with enhanced-determinism.  Here both run as WebAssembly, on whose arithmetic no
// processor has a say, and the shipped scenes end in the same bits.
#include "tests/conformance/adapters_fixture.h"
#include "tests/conformance/fixture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace cylon::conformance {
namespace {

process::RunOutcome begun(const char* engine_id, const scenario::Scenario& scenario) {
  process::RunRequest request;
  request.scene = &scenario.scene;
  request.setup.dt = scenario.step;
  request.steps = std::clamp<std::int64_t>(std::llround(scenario.duration / scenario.step), 1, 200);
  request.every = 1;
  return process::run(engine(engine_id), request, limits);
}

// NaN has bits too.
bool same_bits(const core::Recording& a, const core::Recording& b) {
  const auto numbers = [](const core::Recording& recording) {
    std::vector<std::uint64_t> bits;
    const auto add = [&](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); };
    for (const core::State& state : recording.states)
      for (const core::BodyState& s : state)
        for (int k = 0; k < 4; ++k) {
          add(s.orientation.coeffs()[k]);
          if (k < 3) add(s.position[k]), add(s.velocity[k]), add(s.angular_velocity[k]);
        }
    return bits;
  };
  return numbers(a) == numbers(b);
}

TEST(RapierBuilds, HaveTheSameBits) {
  for (const char* id : {"rapier", "rapier-deterministic"})
    if (const auto reason = process::missing(engine(id).row)) GTEST_SKIP() << *reason;
  const process::KeptWorkers kept;
  int played = 0;
  for (const auto& file : std::filesystem::directory_iterator(source("scenarios"))) {
    if (file.path().extension() != ".toml" || file.path().stem() == "expected") continue;
    const scenario::Scenario scenario = scenario::load(file.path());
    const process::RunOutcome plain = begun("rapier", scenario),
                              deterministic = begun("rapier-deterministic", scenario);
    ASSERT_EQ(plain.recording.has_value(), deterministic.recording.has_value()) << scenario.name;
    if (!plain.recording) {
      EXPECT_EQ(plain.reason, deterministic.reason) << scenario.name;
      continue;
    }
    ++played;
    EXPECT_TRUE(same_bits(*plain.recording, *deterministic.recording)) << scenario.name;
  }
  EXPECT_GE(played, 100);
}

}  // namespace
}  // namespace cylon::conformance
