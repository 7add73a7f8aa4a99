// Two clouds without `seed` drew the same places: bodies without a shape lay in each other, and a large cloud found no
// place, with an error that did not say why.  The default seed is now the number of clouds before it.
#include "harness/core/input_error.h"
#include "harness/scenario/scenario.h"

#include <gtest/gtest.h>

#include <string>

namespace cylon {
namespace {

constexpr const char* head = "duration = 1\nstep = 0.125\n";
constexpr const char* ball = "shape = { type = \"sphere\", radius = 1e-4 }\n";
constexpr const char* material = "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n";

std::string cloud(const std::string& name, int count, const std::string& more) {
  return "[[cloud]]\nname = \"" + name + "\"\nmass = 1\ncount = " + std::to_string(count) +
         "\nlow = [-1, 0.5, -3]\nhigh = [1, 2, 1]\n" + more;
}

std::vector<core::Body> bodies(const std::string& clouds) {
  return scenario::parse(head + clouds, "clouds.toml").scene.bodies;
}

TEST(CloudsDrawApart, WithoutASeed) {
  const auto drawn = bodies(cloud("a", 20, "") + cloud("b", 20, "") + cloud("c", 20, ""));
  const auto stated =
      bodies(cloud("a", 20, "seed = 0\n") + cloud("b", 20, "seed = 1\n") + cloud("c", 20, "seed = 2\n"));
  ASSERT_EQ(drawn.size(), 60u);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    EXPECT_EQ(drawn[i].initial.position, stated[i].initial.position);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_NE(drawn[i].initial.position, drawn[j].initial.position) << i << ", " << j;
  }
}

// 10 000 tries in vain are the end of a search.
TEST(CloudsDrawApart, ASharedSeedIsNamedWhereNoPlaceIsFound) {
  const auto refusal = [](const std::string& second) -> std::string {
    try {
      bodies(cloud("a", 10'100, ball) + cloud("b", 1, second + ball) + material);
      return "";
    } catch (const core::InputError& error) {
      return error.what();
    }
  };
  const std::string said = refusal("seed = 0\n");
  EXPECT_NE(said.find("clouds.toml:13:9: count = 1"), std::string::npos) << said;
  EXPECT_NE(said.find("seed = 0 is that of 'a' too"), std::string::npos) << said;
  EXPECT_EQ(refusal(""), "");
}

}  // namespace
}  // namespace cylon
