// Durations and steps as a person reads them.
#include "harness/results/duration.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::results {
namespace {

TEST(Duration, HasALegibleUnit) {
  const struct {
    double seconds;
    int digits;
    const char* text;
  } rows[] = {
      {1, 3, "1 s"},        {0.1, 3, "0.1 s"},         {0.099, 3, "99 ms"},      {1.0 / 60, 3, "16.7 ms"},
      {1e-3, 3, "1 ms"},    {1e-3 / 8, 3, "0.125 ms"}, {1e-3 / 8, 2, "0.12 ms"}, {4.1e-5, 3, "41 µs"},
      {5.3e-8, 2, "53 ns"}, {1e-12, 3, "1 ps"},        {1234.5, 3, "1234 s"},    {0.0135, 2, "14 ms"},
      {0, 3, "0 s"},        {-0.002, 3, "-2 ms"},      {std::nan(""), 3, ""},    {HUGE_VAL, 3, ""}};
  for (const auto& row : rows) EXPECT_EQ(duration(row.seconds, row.digits), row.text) << row.seconds;
}

TEST(Duration, StepThatWasAskedForStaysExact) {
  const char* rows[][2] = {{"1/240", "1/240 s"},
                           {"5/1248", "5/1248 s"},
                           {"0.001", "1 ms"},
                           {"1/500", "2 ms"},
                           {"0.8/25", "32 ms"},
                           {"1/0", "1/0"},
                           {"5e-04", "0.5 ms"},
                           {"1e-3", "1 ms"},
                           {"0.0166667", "0.0166667 s"},
                           {"1.25e-4", "0.125 ms"},
                           {"2", "2 s"},
                           {"", ""},
                           {"rk4", "rk4"},
                           {"1/x", "1/x"},
                           {"0.001 s", "0.001 s"},
                           {"inf", "inf"},
                           {"1/60\x1b", "1/60\x1b"}};
  for (const auto& [asked, words] : rows) EXPECT_EQ(step_in_words(asked), words);
}

}  // namespace
}  // namespace cylon::results
