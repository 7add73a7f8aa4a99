// The line of the forces of contacts and joints: what is told comes back, and what is not told stays absent.
#include "harness/process/json_fields.h"
#include "harness/process/run_messages.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace cylon;
using core::Contact;
using core::Reaction;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

core::Scene scene() {
  core::Scene scene;
  scene.bodies.resize(3), scene.planes.resize(2), scene.joints.resize(2);
  return scene;
}

TEST(ConstraintForcesMessage, KeepsContactsAsTold) {
  Contact full{{1, 2, -1}, {0.3, -0.2, 0.7}, {0.6, 0.8, 0}, 0.25, core::Vector3(-0.08, 0.06, 0.1)};
  Contact normal_only{{0, core::world, 1}, {1, 2, 3}, {0, 1, 0}, 0.5, {}};
  Contact place_only{{0, core::world, 0}, {1, 2, 3}, {0, 1, 0}, {}, {}};
  Contact broken_friction = full;
  broken_friction.friction->x() = nan;
  const auto back =
      process::constraint_forces_from_json(
          process::constraint_forces_json({{full, normal_only, place_only, broken_friction}, {}}), scene())
          .contacts;
  ASSERT_EQ(back.size(), 4U);
  EXPECT_EQ(back[0].pair, full.pair);
  EXPECT_EQ(back[0].impulse, full.impulse);
  EXPECT_EQ(back[0].friction, full.friction);
  EXPECT_EQ(back[1].impulse, 0.5);
  EXPECT_FALSE(back[1].friction);
  EXPECT_FALSE(back[2].impulse);
  EXPECT_FALSE(back[3].friction) << "a number that is none is not told";
}

TEST(ConstraintForcesMessage, KeepsReactionsAsTold) {
  const Reaction full{1, {0.3, -0.2, 0.7}, {0.6, 0.8, -3}, {0.25, 0.1, 7}};
  const Reaction broken{0, {0, 0, 0}, {nan, 0, 0}, {0, 0, 0}};
  const auto told = process::constraint_forces_from_json(
      process::constraint_forces_json({{}, std::vector<Reaction>{full, broken}}), scene());
  ASSERT_TRUE(told.reactions);
  ASSERT_EQ(told.reactions->size(), 1U) << "a number that is none is not told";
  EXPECT_EQ(told.reactions->front().joint, 1U);
  EXPECT_EQ(told.reactions->front().point, full.point);
  EXPECT_EQ(told.reactions->front().impulse, full.impulse);
  EXPECT_EQ(told.reactions->front().moment, full.moment);
  EXPECT_FALSE(process::constraint_forces_from_json(process::constraint_forces_json({}), scene()).reactions)
      << "an engine that tells none is not one without joints";
}

TEST(ConstraintForcesMessage, RefusesWhatIsNoForceOfTheScene) {
  const nlohmann::json line =
      process::constraint_forces_json({{{{0, core::world, 0}, {1, 2, 3}, {0, 1, 0}, 1.0, {}}},
                                       std::vector<Reaction>{{1, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}});
  process::constraint_forces_from_json(line, scene());
  const struct {
    const char *list, *key;
    nlohmann::json wrong;
  } rows[] = {
      {"contacts", "friction", "much"}, {"contacts", "friction", {1, 2}}, {"contacts", "friction", 0.3},
      {"contacts", "plane", 2},         {"contacts", "body", 3},          {"reactions", "joint", 2},
      {"reactions", "joint", -1},       {"reactions", "joint", 0.5},      {"reactions", "impulse", nullptr},
      {"reactions", "moment", {1, 2}},  {"reactions", "more", 1},
  };
  for (const auto& row : rows) {
    nlohmann::json changed = line;
    changed[row.list][0][row.key] = row.wrong;
    EXPECT_THROW(process::constraint_forces_from_json(changed, scene()), process::MalformedMessage)
        << row.list << " " << row.key << " " << row.wrong;
  }
}

}  // namespace
