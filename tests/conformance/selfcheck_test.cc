// Published numbers are reproduced here, or the difference is explained.
// The rule for agreement is strict.
#include "harness/study/selfcheck.h"
#include "tests/conformance/fixture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::conformance {
namespace {

TEST(SelfCheck, PublishedNumbersAreReproducedOrExplained) {
  const auto rows =
      study::published_numbers([](const std::string& id) { return study::worker_runner(engine(id), {}); });
  int reproduced = 0;
  for (const study::Reproduction& row : rows) {
    EXPECT_TRUE(row.as_explained()) << row.source << ", " << row.what << ": published " << row.published
                                    << ", here " << row.here;
    reproduced += row.reproduced();
  }
  EXPECT_EQ(rows.size(), 28u);
  EXPECT_EQ(reproduced, 24) << "ODE's own fork of 2015 is not ours: four numbers";
}

TEST(SelfCheck, LastDigitIsTheLastShown) {
  const std::pair<const char*, double> table[] = {{"185.027", 5e-4},   {"18808.3", 0.05}, {"2.03326e6", 5},
                                                  {"0.0124501", 5e-8}, {"313419", 0.5},   {"-1.5e-3", 5e-5}};
  for (const auto& [text, half] : table) EXPECT_NEAR(study::last_digit(text) / half, 1, 1e-8) << text;
}

TEST(SelfCheck, DetectsDifferentDigitsAndMissingNumbers) {
  const auto row = [](double here, const char* explanation) {
    return study::Reproduction{"", "", "185.027", here, study::last_digit("185.027"), explanation};
  };
  EXPECT_TRUE(row(185.0270603, "").as_explained());
  EXPECT_FALSE(row(185.0276, "").as_explained());
  EXPECT_FALSE(row(std::nan(""), "").as_explained());
  EXPECT_TRUE(row(184.9, "another version").as_explained());
  EXPECT_FALSE(row(185.027, "another version").as_explained()) << "agreement that is not expected";
}

}  // namespace
}  // namespace cylon::conformance
