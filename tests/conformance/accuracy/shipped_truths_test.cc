// The truths of the shipped scenarios, whatever they come from: they start where their scenes start, and are
// known at times that a run visits.
#include "harness/scenario/scenario.h"
#include "tests/conformance/accuracy/runner.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace cylon::accuracy {
namespace {

namespace fs = std::filesystem;

std::vector<scenario::Scenario> shipped() {
  std::vector<scenario::Scenario> result;
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path(source_dir) / "scenarios"))
    if (entry.path().extension() == ".toml" && entry.path().stem() != "expected") files.insert(entry.path());
  for (const fs::path& file : files) result.push_back(scenario::load(file));
  return result;
}

TEST(ShippedTruths, StartWhereTheirScenesStart) {
  int seen = 0;
  for (const scenario::Scenario& scenario : shipped()) {
    for (const core::Claim& claim : scenario.claims) {
      if (!claim.truth) continue;
      if (!claim.truth->times.empty() && claim.truth->times.front() > 0) continue;
      SCOPED_TRACE(scenario.title + ": " + claim.label);
      ++seen;
      const core::State scene = core::initial_state(scenario.scene), truth = claim.truth->state(0);
      ASSERT_EQ(scene.size(), truth.size());
      for (std::size_t i = 0; i < scene.size(); ++i) {
        // What sixteen typed digits leave, at sizes up to 100.
        EXPECT_LE((scene[i].position - truth[i].position).norm(), 1e-13) << i;
        EXPECT_LE((scene[i].velocity - truth[i].velocity).norm(), 1e-13) << i;
        if (claim.observable.quantity == core::Quantity::orientation) {
          EXPECT_LE(angle_between(scene[i].orientation, truth[i].orientation), 1e-13) << i;
        }
        if (claim.observable.quantity == core::Quantity::angular_velocity) {
          EXPECT_LE((scene[i].angular_velocity - truth[i].angular_velocity).norm(), 1e-13) << i;
        }
      }
    }
  }
  EXPECT_GT(seen, 150);
}

TEST(ShippedTruths, LieOnNominalGrid) {
  for (const scenario::Scenario& scenario : shipped())
    for (const core::Claim& claim : scenario.claims) {
      if (!claim.truth) continue;
      for (const double t : claim.truth->times) {
        const double steps = t / scenario.step;
        EXPECT_LE(std::abs(steps - std::round(steps)), 1e-9 * (1 + steps)) << scenario.title << " at " << t;
      }
    }
}

}  // namespace
}  // namespace cylon::accuracy
