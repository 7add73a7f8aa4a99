// The line of contacts: what is told comes back, and what is not told stays absent.
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace cylon;
using core::Contact;

TEST(ContactsMessage, KeepsWhatIsTold) {
  Contact full{{1, 2, -1}, {0.3, -0.2, 0.7}, {0.6, 0.8, 0}, 0.25, core::Vector3(-0.08, 0.06, 0.1)};
  Contact normal_only{{0, core::world, 1}, {1, 2, 3}, {0, 1, 0}, 0.5, {}};
  Contact place_only{{0, core::world, 0}, {1, 2, 3}, {0, 1, 0}, {}, {}};
  Contact broken_friction = full;
  broken_friction.friction->x() = std::numeric_limits<double>::quiet_NaN();
  const auto back = process::contacts_from_json(
      process::contacts_json({full, normal_only, place_only, broken_friction}), 3, 2);
  ASSERT_EQ(back.size(), 4U);
  EXPECT_EQ(back[0].pair, full.pair);
  EXPECT_EQ(back[0].impulse, full.impulse);
  EXPECT_EQ(back[0].friction, full.friction);
  EXPECT_EQ(back[1].impulse, 0.5);
  EXPECT_FALSE(back[1].friction);
  EXPECT_FALSE(back[2].impulse);
  EXPECT_FALSE(back[3].friction) << "a number that is none is not told";
}

TEST(ContactsMessage, RefusesFrictionThatIsNoVector) {
  nlohmann::json line = process::contacts_json({{{0, core::world, 0}, {1, 2, 3}, {0, 1, 0}, 1.0, {}}});
  for (const nlohmann::json& wrong : {nlohmann::json("much"), nlohmann::json({1, 2}), nlohmann::json(0.3)}) {
    line["contacts"][0]["friction"] = wrong;
    EXPECT_THROW(process::contacts_from_json(line, 1, 1), process::MalformedMessage) << wrong;
  }
}

}  // namespace
