// A loop with more conditions than its motion needs: which of them follow from the others changes as it turns.
#include "tests/engine/fixtures.h"
#include "tests/engine/joint_types.h"

#include <gtest/gtest.h>

#include <numbers>

namespace cylon::engine {
namespace {

// Bennett's linkage: four hinges in space, a/sin alpha = b/sin beta; its 20 rows have rank 17 in every pose.  The
// first hinge stands at `angle` from the pose in which all links are in line.  G. T. Bennett, Engineering 76
// (1903) 777.
Model bennett(Real angle) {
  constexpr Real a = Real(0.5), b = Real(0.6), degree = std::numbers::pi_v<Real> / 180;
  const Real alpha = 40 * degree, beta = std::asin(b * std::sin(alpha) / a);
  // tan(t1/2) tan(t2/2) = sin((beta + alpha)/2)/sin((beta - alpha)/2)
  const Real t1 = angle * degree, t2 = 2 * std::atan2(std::sin((beta + alpha) / 2),
                                                      std::sin((beta - alpha) / 2) * std::tan(t1 / 2));
  const Real turns[] = {t1, t2, -t1, -t2}, lengths[] = {a, b, a, b}, twists[] = {alpha, beta, alpha, beta};
  Vector3 at = Vector3::Zero();
  Quaternion turn = Quaternion::Identity();
  std::vector<Vector3> hinges, axes;
  for (int k = 0; k < 4; ++k) {
    hinges.push_back(at), axes.push_back(turn * Vector3::UnitZ());
    turn = turn * exponential(turns[k] * Vector3::UnitZ());
    at += turn * Vector3(lengths[k], 0, 0);
    turn = turn * exponential(twists[k] * Vector3::UnitX());
  }
  EXPECT_LT(at.norm(), 1e-14) << "the loop is closed";
  Model model;
  model.forces.gravity = {Real(0.3), Real(-9.81), Real(0.2)};
  for (std::size_t i = 0; i < 3; ++i)
    add_body(model, make_body(1 + Real(0.3) * static_cast<Real>(i), general_inertia(0.02, 0.03, 0.035)),
             (hinges[i] + hinges[i + 1]) / 2, Vector3::Zero(), Vector3::Zero(), Vector3::Zero());
  const auto add_hinge = [&](int body, int to, std::size_t k) {
    const auto place = [&](int i) -> Vector3 {
      return i == fixed_world ? hinges[k]
                              : Vector3(hinges[k] - model.motions[static_cast<std::size_t>(i)].position);
    };
    Joint hinge{
        .type = joint_types::hinge, .body = body, .anchor = place(body), .to = to, .to_anchor = place(to)};
    hinge.axis = hinge.to_axis = axes[k];
    model.joints.push_back(hinge);
  };
  add_hinge(0, fixed_world, 0), add_hinge(1, 0, 1), add_hinge(2, 1, 2), add_hinge(2, fixed_world, 3);
  return model;
}

// Rows that were one too many seemed new ones by what a stage had opened the loop, and those that stood for them
// became dependent where the links are in line: links flew 5000 m apart, or were NaN.
TEST(BennettLinkage, TurnsThroughThePoseInWhichItsLinksAreInLine) {
  for (const Real angle : {Real(70), Real(1)}) {
    const Model model = bennett(angle);
    const auto drift_of = [&](const char* integrator, int steps) {
      Real most = 0, widest = 0, least = 1, highest = -1;
      run(model, with(integrator, Real(2) / static_cast<Real>(steps)), steps, [&](const World& world) {
        most = std::max(most, std::abs(energy(model, world.motions()) - energy(model, model.motions)));
        for (const Joint& joint : model.joints) widest = std::max(widest, joint_gap(world.motions(), joint));
        const Real x = (world.motions()[0].orientation * Vector3::UnitX()).x();
        least = std::min(least, x), highest = std::max(highest, x);
      });
      EXPECT_LT(widest, 1e-11) << integrator << ' ' << angle;
      EXPECT_GT(highest - least, 1) << "it turns by more than a right angle";
      return most;
    };
    EXPECT_LT(drift_of("auto", 200), 1e-9) << angle;
    for (const auto& [integrator, order] :
         {std::pair("velocity-verlet", 2), std::pair("rk4", 4), std::pair("yoshida4", 4)})
      EXPECT_GT(std::log2(drift_of(integrator, 1000) / drift_of(integrator, 2000)), order - 0.3)
          << integrator << ' ' << angle;
  }
}

}  // namespace
}  // namespace cylon::engine
