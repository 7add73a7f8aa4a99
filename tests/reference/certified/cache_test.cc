// What a cached solution's bytes must be before anybody asks it for a state.
#include "reference/certified/cache.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace cylon::certified {
namespace {

template <class T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
void put(std::string& bytes, const std::vector<T>& values) {
  put(bytes, std::uint64_t{values.size()});
  for (const T value : values) put(bytes, value);
}

// One body, two steps: of two coefficients, then of three, for each number.
struct Body {
  std::uint64_t bodies = 1;
  std::vector<double> starts = {0, 0.25};
  std::vector<std::uint64_t> first = {0, 2 * Dense::numbers, 5 * Dense::numbers};
  std::vector<double> coefficients = std::vector<double>(5 * Dense::numbers, 0.5);
  double horizon = 0.75;
  std::uint8_t lost = 0;
  std::string behind;

  std::string bytes() const {
    std::string all;
    put(all, bodies), put(all, starts), put(all, first), put(all, coefficients), put(all, horizon);
    for (int i = 0; i < 5; ++i) put(all, 1e-12);  // the error
    put(all, std::uint64_t{0});                   // no growth of errors
    put(all, lost), put(all, 1e6);                // and the work
    return all + behind;
  }
};

TEST(CacheBody, GivesStatesOfEveryStep) {
  const auto dense = parse_body(Body{}.bytes());
  ASSERT_TRUE(dense.has_value());
  // 1/2 + t/2 in the first step, 1/2 + s/2 + s^2/2 with s = t - 1/4 in the second.
  EXPECT_DOUBLE_EQ(dense->at(0.125).front().position.x(), 0.5625);
  EXPECT_DOUBLE_EQ(dense->at(0.75).front().position.x(), 0.875);
}

TEST(CacheBody, RefusesWhatCannotBeAsked) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::uint64_t n = Dense::numbers;
  const struct {
    const char* what;
    Body body;
  } table[] = {
      {"no body", {.bodies = 0}},
      {"bodies without coefficients", {.bodies = 4}},
      {"bodies whose numbers overflow", {.bodies = std::numeric_limits<std::uint64_t>::max() / n + 1}},
      {"a start that is no time", {.starts = {0, nan}}},
      {"steps against time", {.starts = {0.25, 0}}},
      {"a step without coefficients", {.first = {0, 0, 5 * n}}},
      {"a step before the first coefficient", {.first = {n, 2 * n, 5 * n}}},
      {"numbers of unlike degree", {.first = {0, 2 * n + 1, 5 * n}}},
      {"a step behind the last coefficient", {.first = {0, 2 * n, 6 * n}}},
      {"no end", {.horizon = std::numeric_limits<double>::infinity()}},
      {"a truth value that is neither", {.lost = 2}},
      {"bytes behind the end", {.behind = "x"}},
  };
  for (const auto& row : table) EXPECT_FALSE(parse_body(row.body.bytes()).has_value()) << row.what;
  const std::string whole = Body{}.bytes();
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(parse_body(std::string_view(whole).substr(0, length)).has_value()) << length;
}

}  // namespace
}  // namespace cylon::certified
