#include "harness/cli/sparkline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::tracking {

using namespace cli;
namespace {

TEST(Sparkline, Rows) {
  struct Row {
    std::vector<double> values;
    double least;
    std::size_t width;
    const char *utf8, *ascii;
  };
  const Row rows[] = {
      {{1, 2, 3, 4, 5, 6, 7, 8}, 0, 40, "▁▂▃▄▅▆▇█", "_.-:=+*#"},
      {{3, 3, 3}, 0, 40, "▁▁▁", "___"},
      {{3, 3, 3}, 1, 40, "▅▅▅", "==="},       // flat: in the middle
      {{3, 3.1, 2.9}, 10, 40, "▅▅▄", "==:"},  // noise below the least range stays flat
      {{1, NAN, 8, INFINITY}, 0, 40, "▁?█?", "_?#?"},
      {{NAN, NAN}, 0, 40, "??", "??"},
      {{}, 0, 40, "", ""},
      {{1, 1, 1, 1, 9, 9, 9, 9}, 0, 4, "▁▁██", "__##"},  // two of each column
      {{1, NAN, NAN, NAN, 9, 9}, 0, 3, "▁?█", "_?#"},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(sparkline(row.values, row.least, true, row.width), row.utf8);
    EXPECT_EQ(sparkline(row.values, row.least, false, row.width), row.ascii);
  }
}

TEST(Sparkline, Letters) {
  EXPECT_EQ(letters({"x", "x", "y", "x", "z"}, 40), "aabac");
  EXPECT_EQ(letters({"x", "x", "y", "y"}, 2), "ab");
  EXPECT_EQ(letters({}, 40), "");
  std::vector<std::string> many;
  for (int i = 0; i < 30; ++i) many.push_back(std::to_string(i));
  EXPECT_EQ(letters(many, 40), "abcdefghijklmnopqrstuvwxyz####");
}

TEST(Sparkline, ColumnsCoverTheWidth) {
  for (const std::size_t n : {7U, 40U, 41U, 200U, 10001U}) {
    std::size_t last = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t column = column_of(i, n, 40);
      EXPECT_TRUE(column == last || column == last + 1) << n << ", " << i;
      last = column;
    }
    EXPECT_EQ(last, std::min<std::size_t>(n, 40) - 1);
  }
}

}  // namespace
}  // namespace cylon::tracking
