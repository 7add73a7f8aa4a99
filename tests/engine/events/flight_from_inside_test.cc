// A flight that begins inside a surface, by rounding or by more, and comes back within the step.
#include "tests/engine/contact/contact_fixtures.h"

namespace cylon::engine {
namespace {

struct FromInside {
  const char* name;
  Real depth;  // [m]
  Real speed;  // away from the surface [m/s]
};

class FlightFromInside : public testing::TestWithParam<FromInside> {};

const FromInside starts[] = {
    {"a_third_of_the_margin", 1e-12, 1e-4}, {"the_margin", Real(2.9e-12), 1e-4},
    {"far_beyond_it", Real(1e-9), 2e-3},    {"a_tenth_of_a_millimetre", Real(1e-4), 3e-2},
    {"it_does_not_come_out", 1e-4, 1e-3},
};

INSTANTIATE_TEST_SUITE_P(, FlightFromInside, testing::ValuesIn(starts),
                         [](const auto& row) { return row.param.name; });

// Surfaces meet again where they are as deep as they began: a corner that left a wedge of three planes at 2e-6 m/s, 2.9e-12 m
// deep, was watched at the end of its step alone, and was 6e-6 m deep by then, up to 1e-4 m later, and nothing told it.
TEST_P(FlightFromInside, IsWatched) {
  const auto [name, depth, speed] = GetParam();
  for (const bool ball : {true, false}) {
    Model model = with_plane(Vector3(0.2, 1, 0.1).normalized(), 0, {0.5, Real(0.3)});
    const Vector3 up = model.planes[0].normal;
    const Quaternion upright = Quaternion::FromTwoVectors(Vector3::UnitY(), up);
    model.forces.gravity = Real(-9.81) * up;
    const Vector3 at = (Real(0.3) - depth) * up;
    if (ball) {
      add_sphere(model, 1, Real(0.3), at, speed * up, Vector3::Zero());
    } else {
      add_box(model, 1, {0.4, 0.3, 0.5}, at, upright, speed * up, Vector3::Zero());
    }
    Trial run(model, 0.01);
    while (run.time < 0.05) {
      run.step();
      EXPECT_GE(up.dot(run.motion(0).position), 0.3 - depth - 1e-11) << ball << " at " << run.time;
    }
    ASSERT_FALSE(run.impacts.empty()) << ball;
    // It comes back to where it began:  t = 2 v/g
    EXPECT_NEAR(run.impacts[0].time, 2 * speed / 9.81, 1e-3 * speed / 9.81) << ball;
    EXPECT_NEAR(run.impacts[0].approach, speed, 1e-3 * speed) << ball;
    for (const std::string& told : sentences(run.stepper.diagnostics())) ADD_FAILURE() << ball << " " << told;
  }
}

}  // namespace
}  // namespace cylon::engine
