// Boxes thrown into a corner of three walls: their points jam each other before they slip.
#include "tests/engine/contact/contact_fixtures.h"
#include "tests/engine/mixed_scenes.h"

#include <algorithm>

namespace cylon::engine {
namespace {

Model thrown_box(std::uint32_t number) {
  Dice dice(number);
  const Real friction = std::array<Real, 3>{Real(0.3), Real(0.5), 1}[dice.below(3)];
  const Real restitution = std::array<Real, 3>{0, Real(0.3), Real(0.6)}[dice.below(3)];
  const auto tilt = [&] { return dice.between(Real(-0.2), Real(0.2)); };
  Model model = with_plane({0, 1, 0}, 0, {restitution, friction});
  const Real floor = tilt(), wall = tilt(), side = tilt();
  model.planes = {{Vector3(floor, 1, tilt()).normalized(), 0},
                  {Vector3(-1, wall, tilt()).normalized(), -1},
                  {Vector3(side, tilt(), -1).normalized(), -1}};
  model.plane_surfaces.assign(3, 1);
  const Vector3 half = Vector3(Real(0.25), Real(0.25), Real(0.25)) + dice.vector(Real(0.15));
  const Vector3 inertia = (half.squaredNorm() - half.array().square()).matrix() / 3;
  const Body body = make_body(1, inertia.asDiagonal());
  const Vector3 at = Vector3(0, 1, 0) + dice.vector(Real(0.1));
  const Quaternion turn = exponential(dice.vector(2));
  const Vector3 velocity = Vector3(Real(1.5), Real(-1.5), Real(1.5)) + dice.vector(Real(1.5));
  add(model, body, Box{half}, make_motion(body, at, turn, velocity, dice.vector(4)));
  return model;
}

// Forces of points that jam were taken from the edge of their cones, which they left every 1e-7 s; where all of them slipped at
// once friction was left out for the rest of a step; and every second throw told of a search for contacts that had not seen
// all, for a corner that left its wall too slowly to be told from one that comes.
TEST(EventCorner, ThrownBoxesAreFollowed) {
  constexpr std::uint32_t throws = 24;
  int lost = 0;
  for (std::uint32_t number = 0; number < throws; ++number) {
    Trial run(thrown_box(number), 0.01);
    Real energy = run.energy();
    while (run.time < 1.5) {
      run.step();
      if (run.stepper.gave_up()) break;  // and says so
      ASSERT_LE(run.energy(), energy + 1e-9) << number << " at " << run.time;
      energy = run.energy();
    }
    const std::vector<Diagnostic> told = run.stepper.diagnostics();
    const auto tells = [&](DiagnosticKind kind) {
      return std::ranges::any_of(told, [kind](const Diagnostic& d) { return d.kind == kind; });
    };
    EXPECT_FALSE(tells(DiagnosticKind::meeting_not_searched)) << number;
    EXPECT_FALSE(tells(DiagnosticKind::frictionless)) << number;
    if (run.stepper.gave_up()) ++lost;
  }
  EXPECT_LE(lost, 2);
}

}  // namespace
}  // namespace cylon::engine
