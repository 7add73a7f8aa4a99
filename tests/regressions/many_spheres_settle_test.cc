// Spheres that fall on each other and stay: what their closed forms cannot express was followed event by
// event however many there were, and a hundred of them had no end. Where many may touch it goes on in fixed
// steps.
#include "bench/pile.h"
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

namespace cylon::process {
namespace {

TEST(ManySpheresSettle, SwitchToFixedStepsAtFirstPersistentContact) {
  const core::Scene scene = bench::pile(100, 5, 0.6, 1.1);
  for (const char* id : {"in-house", "in-house-float"}) {
    RunRequest request;
    request.scene = &scene;
    request.setup.dt = 1. / 60;
    request.steps = request.every = 240;
    const RunOutcome outcome = run(parse_engine(id, default_engines(binary_dir)), request);
    ASSERT_TRUE(outcome.recording) << id << ": " << outcome.reason;
    ASSERT_FALSE(outcome.recording->remarks.empty());
    EXPECT_NE(outcome.recording->remarks.front().find(", then in fixed steps: "), std::string::npos)
        << outcome.recording->remarks.front();
    // The weight of four layers, taken away by a fifth of the overlap a step: well below a hundredth of a
    // radius.
    EXPECT_LT(bench::overlap(scene, outcome.recording->states.back()), 0.005) << id;
  }
}

}  // namespace
}  // namespace cylon::process
