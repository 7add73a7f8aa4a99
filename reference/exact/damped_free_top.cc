// Body of any inertia that is braked by a torque in proportion to its angular momentum, -gamma L.  L keeps
// its direction and decays, and the body goes through the positions of its free motion at another pace:
//
//     q(t) = q_free(s),  w(t) = exp(-gamma t) w_free(s),  s = (1 - exp(-gamma t))/gamma
//
// (Euler's equations with w = exp(-gamma t) W(s): the damping term cancels.)  The centre of mass falls, with
// linear drag or without.  A torque -c w is served where the body turns about a principal axis.
// Domain: gravity and drags, no joint or contact; not on the free motion's separatrix.
#include "reference/exact/domain.h"
#include "reference/exact/free_rotation.h"
#include "reference/exact/linear_motion.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"

namespace cylon::exact {
namespace {

constexpr auto name = "damped_free_top";

// Coefficients of the torque -angular w - momentum L on a body.
struct Brake {
  double angular = 0, momentum = 0;

  Brake(const core::Scene& scene, std::size_t index) {
    for (const core::Force& force : scene.forces) {
      const auto* drag = std::get_if<core::Drag>(&force);
      if (drag && drag->body == static_cast<int>(index)) angular += drag->angular, momentum += drag->momentum;
    }
  }
};

struct DampedTop {
  LinearMotion whole;  // all of the motion where the spin is steady
  std::function<WideState(Wide)> rotation;
  Brake brake;

  DampedTop(const core::Scene& scene, std::size_t index)
      : whole(scene, index), rotation(free_rotation(scene, index)), brake(scene, index) {}

  WideState at(Wide t) const {
    WideState s = whole.at(t);
    if (brake.angular > 0) return s;
    const Wide past = brake.momentum == 0 ? t : -std::expm1(-brake.momentum * t) / brake.momentum;
    const WideState turned = rotation(past);
    s.orientation = turned.orientation;
    s.angular_velocity = turned.angular_velocity * std::exp(-brake.momentum * t);
    return s;
  }
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<DampedTop> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.emplace_back(scene, i);
  return together(std::move(motions));
}

}  // namespace

core::Truth damped_free_top(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity", "drag"});
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    check_free_rotation(name, scene, i);
    if (Brake(scene, i).angular > 0) check_steady_spin(name, scene, static_cast<int>(i), horizon);
  }
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = "Euler's free motion at another pace; Landau & Lifshitz, Mechanics, section 37",
          .horizon = horizon};
}

}  // namespace cylon::exact
