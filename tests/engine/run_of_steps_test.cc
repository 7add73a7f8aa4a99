// A run of steps equals the same number of single steps, for every integrator and kind of smooth model.
#include "engine/make_stepper.h"
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

Model points() {
  Model model;
  add_body(model, make_body(1.2, Matrix3::Zero()), {0.7, 0.2, 0.3}, {0, 0, 0}, {-0.3, 0.4, 0.1}, {0, 0, 0});
  add_body(model, make_body(0.9, Matrix3::Zero()), {-0.5, 0.9, 0.1}, {0, 0, 0}, {0.3, 0.6, -0.8}, {0, 0, 0});
  model.forces.gravity = {0.1, -9.81, 0.2};
  model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0.1, 0.3, -0.2}, 17.0, 0.35, 0});
  model.forces.springs.push_back({1, {0, 0, 0}, 0, {0, 0, 0}, 11.0, 0.6, 0});
  model.forces.drives.push_back({1, {0.9, 0.4, -1.1}, 2.3});
  return model;
}

struct Row {
  const char* name;
  Model model;
  Path path;
  bool joints, timed;
};

std::vector<Row> rows() {
  return {{"points", points(), Path::points, false, true},
          {"bodies", forced_bodies(), Path::bodies, false, true},
          {"top", heavy_top(), Path::bodies, false, false},
          {"linked", linked_bodies(true), Path::bodies, true, false}};
}

class RunOfSteps : public EveryIntegrator {};

TEST_P(RunOfSteps, IsTheMotionOfSingleSteps) {
  const Integrator& integrator = GetParam();
  constexpr int steps = 60;
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.name);
    const Options options = with(integrator.name, 0.01);
    if (!unsupported(row.model, options).empty()) {
      EXPECT_TRUE(row.joints && !integrator.constraints);
      continue;
    }
    const Plan plan = make_plan(row.model, options);
    ASSERT_EQ(plan.path, row.path);
    const auto single = make_stepper(row.model, options, plan), many = make_stepper(row.model, options, plan);
    std::vector<Motion> a, b;
    for (int i = 0; i < steps; ++i) single->step();
    many->advance(7);  // from 0, and from a later step
    many->advance(steps - 7);
    single->read(a);
    many->read(b);
    // 60 steps of at most 29 parts, each rounded by half an ulp of places and momenta up to 5, and grown
    // tenfold by the motion within 0.6 s.
    EXPECT_LT(distance(a, b), steps * 29 * 10 * 5 * 1.1e-16);
    const bool merges = integrator.kind == Kind::splitting && integrator.reversible && !row.joints;
    if (!merges && !row.timed) {
      for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same_bits(a[i], b[i]));
    }
    single->step();  // the measure itself
    single->read(a);
    EXPECT_GT(distance(a, b), 1e-3);
  }
}

CYLON_EVERY_SCHEME(RunOfSteps);

}  // namespace
}  // namespace cylon::engine
