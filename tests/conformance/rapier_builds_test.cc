// Rapier's three builds: the plain one, that with enhanced-determinism and that with SIMD.  Here all run as WebAssembly, on
// whose arithmetic no processor has a say: the shipped scenes end in the same bits with the first two, and those in which
// nothing turns with the third.
#include "tests/conformance/adapters_fixture.h"
#include "tests/conformance/fixture.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
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

std::optional<std::string> one_is_missing(std::initializer_list<const char*> ids) {
  for (const char* id : ids)
    if (auto reason = process::missing(engine(id).row)) return reason;
  return std::nullopt;
}

TEST(RapierBuilds, HaveTheSameBits) {
  if (const auto reason = one_is_missing({"rapier", "rapier-deterministic"})) GTEST_SKIP() << *reason;
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

TEST(RapierBuilds, DifferWithSimdWhereSomethingTurns) {
  if (const auto reason = one_is_missing({"rapier", "rapier-simd"})) GTEST_SKIP() << *reason;
  struct Row {
    const char* scenario;
    bool alike;
  };
  const process::KeptWorkers kept;
  for (const Row& row :
       {Row{"projectile", true}, Row{"bouncing_sphere_half", true}, Row{"kepler", true},
        Row{"two_sphere_oblique", true}, Row{"spring_pendulum", true}, Row{"water_step_force", true},
        Row{"rail_friction", true}, Row{"free_asymmetric_top", false}, Row{"heavy_top", false},
        Row{"hinge_tilted", false}, Row{"rolling_sphere_incline", false}, Row{"cube_stack", false}}) {
    const auto scenario = scenario::load(source(std::string("scenarios/") + row.scenario + ".toml"));
    const process::RunOutcome plain = begun("rapier", scenario), simd = begun("rapier-simd", scenario);
    ASSERT_TRUE(plain.recording && simd.recording) << row.scenario;
    EXPECT_EQ(same_bits(*plain.recording, *simd.recording), row.alike) << row.scenario;
  }
}

}  // namespace
}  // namespace cylon::conformance
