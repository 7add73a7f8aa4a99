// A body that a fixed joint holds, pushed by a thrust, without gravity: the run ended after 0.02 s with
// NaN.  The speeds were the rounding of the joint's force and error control was relative to these.  A speed
// below the rounding of what the forces give over the scene's length is now measured by that.
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

TEST(HeldBodyWithoutGravity, StaysAtRest) {
  for (const Real rate : {Real(0), Real(0.2)}) {
    Model model;
    add_body(model, make_body(Real(1.3), general_inertia(Real(0.02), Real(0.03), Real(0.04))),
             {Real(0.2), Real(0.1), Real(0.3)}, {Real(0.5), Real(-0.3), Real(0.7)}, {0, 0, 0}, {0, 0, 0});
    model.forces.thrusts.push_back(
        {.body = 0, .force = {Real(1.7), Real(-2.9), Real(3.1)}, .mass_rate = rate});
    model.bodies[0].mass_rate = rate;
    const Vector3 point = {Real(0.5), Real(-0.1), Real(0.2)};
    const Quaternion turn = model.motions[0].orientation;
    model.joints.push_back({.type = joint_types::fixed,
                            .body = 0,
                            .anchor = turn.conjugate() * (point - model.motions[0].position),
                            .to_anchor = point,
                            .relative = turn});
    const Outcome end = run(model, with("auto", Real(0.1)), 20);
    EXPECT_TRUE(end.remarks.empty()) << end.remarks[0];
    EXPECT_LT(distance(end.motions, model.motions), 1e-12);
  }
}

}  // namespace
}  // namespace cylon::engine
