// The shortest valid time of several timings.
#include "harness/study/cost.h"

#include <gtest/gtest.h>

namespace cylon::study {
namespace {

TEST(Cost, IsShortestValidTime) {
  const process::Repetition t =
      typical_least({{3.1, 20.4}, {3.0, 20.0}, {9.9, 2.0}, {0.4, 21.7}, {3.3, 88.0}});
  EXPECT_EQ(t.load_seconds, 3.0);   // 0.4 is a clock that stood
  EXPECT_EQ(t.step_seconds, 20.0);  // and so is 2.0; 88 was disturbed
  const process::Repetition alone = typical_least({{1.5, 2.5}});
  EXPECT_EQ(alone.load_seconds, 1.5);
  EXPECT_EQ(alone.step_seconds, 2.5);
}

TEST(Cost, CountsLoadTimeOfAdaptiveIntegrators) {
  const process::Repetition time{0.25, 2};
  EXPECT_EQ(cost(time, false, 4), 0.5);
  EXPECT_EQ(cost(time, true, 4), 0.5625);
}

}  // namespace
}  // namespace cylon::study
