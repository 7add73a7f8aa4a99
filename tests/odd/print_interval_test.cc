// With a tolerance, and no step that was asked for, a step was as long as the time between two prints.  What was left out of
// the laws of contact was left out for the rest of it, two runs that did the same agreed, and `auto` said that it had
// nearly kept the tolerance 1e-8 where the motion was wrong by 0.09 to 0.26 m.
#include "engine/parted_steps.h"
#include "engine/world.h"
#include "harness/scenario/scenario.h"
#include "reference/simulators/in_house/in_house_model.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace cylon {
namespace {

struct End {
  engine::Vector3 position;
  std::vector<engine::Diagnostic> said;

  bool says(engine::DiagnosticKind kind) const {
    return std::ranges::any_of(said, [kind](const engine::Diagnostic& d) { return d.kind == kind; });
  }
};

engine::Model model_of(const std::string& name) {
  const auto file = std::filesystem::path(source_dir) / "tests/odd" / (name + ".toml");
  return simulators::in_house_model(scenario::load(file).scene).model;
}

End run_to(double end, const engine::Model& model, double every) {
  engine::Options options;
  options.dt = every, options.tolerance = 1e-8;
  engine::World world(model, options);
  for (std::int64_t k = std::llround(end / every); k > 0; --k) world.step();
  return {world.motions()[0].position, world.diagnostics()};
}

// What is followed event by event is the same whenever it is looked at: it was wrong by 0.26 m.
TEST(PrintInterval, MovesNothingThatIsFollowed) {
  const engine::Model model = model_of("box_with_ball_slides");
  const End often = run_to(1.5, model, 0.01), once = run_to(1.5, model, 1.5);
  EXPECT_LE((often.position - once.position).norm(), 1e-8) << "1.1e-13";
  EXPECT_FALSE(once.says(engine::DiagnosticKind::tolerance_unknown));
}

// No force obeys Coulomb's law: it is left, for much less than 1.5 s, and it is said that nothing is known of the error; a scene
// that jams was wrong by 0.09 m.
TEST(PrintInterval, DoesNotLengthenWhatIsLeftOut) {
  const engine::Model model = model_of("rod_digs_in");
  const End often = run_to(1.5, model, 0.01), once = run_to(1.5, model, 1.5);
  for (const End& end : {often, once}) {
    EXPECT_TRUE(end.says(engine::DiagnosticKind::tolerance_unknown));
    EXPECT_FALSE(end.says(engine::DiagnosticKind::tolerance_missed)) << "no number";
    EXPECT_FALSE(end.says(engine::DiagnosticKind::last_not_compared)) << "no number";
  }
  EXPECT_LE((often.position - once.position).norm(), 0.01) << "0.003 of the way of 0.1";
}

// Where two points jam each other the law is kept: it was left, and the end was known to 0.02 m.
TEST(PrintInterval, MovesNothingThatJams) {
  const engine::Model model = model_of("box_with_ball_jams");
  const End often = run_to(1.5, model, 0.01), once = run_to(1.5, model, 1.5);
  EXPECT_LE((often.position - once.position).norm(), 1e-6);
  EXPECT_FALSE(once.says(engine::DiagnosticKind::tolerance_unknown));
}

// Spin that dry friction of a joint and quadratic damping stop, on a stop: the angle is that of
//   I w' = -b - c w^2,  angle = I/(2 c) log(1 + c w_0^2/b)  in all.
TEST(PrintInterval, MovesNoSpinOnAStop) {
  const double inertia = 0.012284, b = 0.03, c = 0.002, w = 5;
  const double angle = inertia / (2 * c) * std::log1p(c * w * w / b);
  for (const double every : {0.01, 2.0}) {
    engine::Options options;
    options.dt = every, options.tolerance = 1e-8;
    const engine::Model model = model_of("weight_on_a_stop");
    engine::World world(model, options);
    for (std::int64_t k = std::llround(2 / every); k > 0; --k) world.step();
    const engine::Quaternion& q = world.motions()[0].orientation;
    const double turned = 2 * std::atan2(static_cast<double>(q.y()), static_cast<double>(q.w()));
    EXPECT_NEAR(std::remainder(turned - angle, 4 * std::acos(0.0)), 0, 1e-8) << every;
    EXPECT_TRUE(world.diagnostics().empty()) << every;
  }
}

// A half-width of 0.2 m at 9.81 m/s^2: steps of 0.036 s, and parts of 0.009 s of longer ones.  Nothing falls without gravity.
TEST(PrintInterval, GoesInPartsOfTheTimeOfFall) {
  engine::Model model = model_of("box_with_ball_jams");
  EXPECT_EQ(engine::parts_of_step(model, 0.01), 1);
  EXPECT_GT(engine::parts_of_step(model, 1.5), 100);
  EXPECT_LT(engine::parts_of_step(model, 1.5), 250);
  model.forces.gravity.setZero();
  EXPECT_EQ(engine::parts_of_step(model, 1.5), 1);
}

}  // namespace
}  // namespace cylon
