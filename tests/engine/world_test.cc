// A run of steps between which nothing is read has the bits of as many single steps, whatever carries the
// model.
#include "engine/world.h"

#include "tests/engine/fixtures.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

Model many_free() {
  Model model;
  model.forces.gravity = {Real(0.4), Real(-9.81), Real(0.7)};
  for (int i = 0; i < 70; ++i) {
    const auto part = [&](int a, int b) { return Real(0.1) * static_cast<Real>(i * a % b + 1); };
    add_body(model, make_body(part(3, 7), general_inertia(part(1, 3), part(1, 3) + Real(0.1), Real(0.35))),
             {part(2, 5), part(3, 5), part(4, 7)}, {part(2, 9), part(4, 9), part(5, 9)},
             {part(1, 5), part(5, 7), part(3, 11)}, {part(9, 11), part(7, 13), part(5, 17)});
  }
  return model;
}

struct Row {
  const char* name;
  Model model;
  const char* integrator;
  Path path;
};

std::vector<Row> rows() {
  return {
      {"free bodies side by side", many_free(), "velocity-verlet", Path::free},
      {"closed form", many_free(), "auto", Path::exact},
      {"a splitting whose kicks meet", coupled_bodies(), "velocity-verlet", Path::bodies},
      {"forces of time", forced_bodies(), "rk4", Path::bodies},
      {"two runs that agree", coupled_bodies(), "auto", Path::bodies},
      {"impacts in closed form, handed over", ball_over_plane(Real(0.7), Real(0.6)), "auto", Path::ballistic},
      {"events", ball_over_plane(Real(0.7), Real(0.6)), "rk4", Path::events}};
}

TEST(World, AdvancesInRunsAsInSteps) {
  for (const Row& row : rows()) {
    const Options options = with(row.integrator, 0.013);
    World runs(row.model, options), steps(row.model, options);
    ASSERT_EQ(runs.plan().path, row.path) << row.name;
    int taken = 0;
    for (const int n : {1, 2, 5, 40, 3, 64}) {
      runs.advance(n);
      for (int i = 0; i < n; ++i) steps.step();
      taken += n;
      ASSERT_EQ(runs.time(), steps.time()) << row.name;
      ASSERT_EQ(runs.impacts().size(), steps.impacts().size()) << row.name << " after " << taken;
      for (std::size_t i = 0; i < row.model.bodies.size(); ++i)
        ASSERT_TRUE(same_bits(runs.motions()[i], steps.motions()[i])) << row.name << " after " << taken;
      ASSERT_EQ(runs.operations(), steps.operations()) << row.name << " after " << taken;
    }
    EXPECT_FALSE(same_bits(runs.motions()[0], row.model.motions[0])) << row.name << ": nothing moved";
  }
}

// Steps of whatever carries the model are counted, and nothing else decides how many there are.
TEST(World, CountsOperationsInEveryStep) {
  std::vector<Row> all = rows();
  all.push_back({"steps", ball_over_plane(Real(0.7), Real(0.6)), "auto", Path::stepping});
  for (const Row& row : all) {
    Options options = with(row.integrator, 0.013);
    if (row.path == Path::stepping) options.path = "stepping";
    World world(row.model, options), again(row.model, options);
    ASSERT_EQ(world.plan().path, row.path) << row.name;
    std::int64_t before = world.operations();
    for (int i = 0; i < 60; ++i) {
      world.step(), again.step();
      // Steps of an error-controlled run may span many of these.
      EXPECT_GE(world.operations(), before + (row.integrator != std::string("auto"))) << row.name << i;
      before = world.operations();
    }
    EXPECT_GT(before, 0) << row.name;
    EXPECT_EQ(before, again.operations()) << row.name;
  }
}

// What ends is counted still: bodies that are kicked begin anew.
TEST(World, CountsOperationsOfRunsThatEnded) {
  for (const Row& row : rows()) {
    const Options options = with(row.integrator, 0.013);
    World world(row.model, options);
    if (!world.no_kick().empty()) continue;
    world.advance(50);
    const std::int64_t before = world.operations();
    world.kick(0, Vector3::UnitX(), Vector3::Zero());
    EXPECT_GE(world.operations(), before) << row.name;
  }
}

}  // namespace
}  // namespace cylon::engine
