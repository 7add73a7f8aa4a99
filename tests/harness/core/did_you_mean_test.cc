// The nearest name of a word that is none: by letters, else by a long common beginning.
#include "harness/core/input_error.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace cylon::core {
namespace {

TEST(DidYouMean, TakesTheNearestNameOrACommonBeginning) {
  const std::vector<std::string> names = {"bouncing_sphere", "bouncing_sphere_elastic", "heavy_top",
                                          "kepler"};
  const struct {
    const char *word, *says;
  } rows[] = {{"kepller", ", did you mean 'kepler'?"},
              {"bounce", ", did you mean 'bouncing_sphere'?"},
              {"bouncing", ", did you mean 'bouncing_sphere'?"},
              {"heavy", ", did you mean 'heavy_top'?"},
              {"bou", ""},       // too short
              {"boundary", ""},  // less than most of the word
              {"top", ""},
              {"", ""}};
  for (const auto& row : rows) EXPECT_EQ(did_you_mean(row.word, names), row.says) << row.word;
}

}  // namespace
}  // namespace cylon::core
