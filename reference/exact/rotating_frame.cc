// A scene given in a moving frame: the solution of the inertial scene, seen from the frame.  With W(t) = W_0 + W' t
// the frame's angular velocity, W' along W_0, so that R(t) = rot(W_0 t + W' t^2/2), inertial quantities with a dash, the
// frame's origin at rest (Galilei: its velocity changes nothing in a scene that nothing ties to the world):
//
//     p = R^-1 p',  v = R^-1 v' - W x p,  q = R^-1 q',  w = R^-1 w' - W;   at t = 0  v' = v + W_0 x p,  w' = w
//     + W_0
//
// A frame that does not turn needs none of this: every solution serves its scene as it stands.
// Domain: scenes whose inertial form one of the solutions below serves; in a turning frame nothing that
// is fixed to the frame - gravity, pins, planes, joints, drag, drives, locked bodies - may act.
#include "reference/exact/domain.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"
#include "reference/exact/wide.h"

#include <limits>

namespace cylon::exact {
namespace {

constexpr auto name = "rotating_frame";
using Make = core::Truth (*)(const core::Scene&, double);

// In this order: the first that accepts the inertial scene serves.
constexpr Make turning[] = {projectile, free_symmetric_top, free_asymmetric_top, kepler, spring_chain};

class Frame {
 public:
  explicit Frame(const core::Scene& scene)
      : start_(widen(scene.frame->angular_velocity)), faster_(widen(scene.frame->angular_acceleration)) {}

  core::Scene inertial(core::Scene scene) const {
    scene.frame.reset();
    for (core::Body& body : scene.bodies) {
      core::BodyState& s = body.initial;
      s.velocity = (widen(s.velocity) + start_.cross(widen(s.position))).cast<double>();
      s.angular_velocity = (widen(s.angular_velocity) + start_).cast<double>();
    }
    return scene;
  }

  core::State seen(core::State state, double t) const {
    const Wide now(t);
    const WideQuaternion back = turn_by(start_ + now / 2 * faster_, -now);
    const WideVector spin = start_ + now * faster_;
    for (core::BodyState& s : state) {
      WideState w;
      w.position = back * widen(s.position);
      w.velocity = back * widen(s.velocity) - spin.cross(w.position);
      w.orientation = back * widen(s.orientation);
      w.angular_velocity = back * widen(s.angular_velocity) - spin;
      s = narrow(w);
    }
    return state;
  }

  // The fastest up to the horizon.
  double rate(double horizon) const {
    return static_cast<double>(std::max(start_.norm(), (start_ + Wide(horizon) * faster_).norm()));
  }

 private:
  WideVector start_, faster_;
};

// What stands still in the frame turns in space: no inertial solution has it.
void check_nothing_fixed(const core::Scene& scene) {
  for (const core::Body& body : scene.bodies) {
    if (body.locked) refuse(name, "body '" + body.name + "' is locked in a turning frame");
  }
  check_forces(name, scene, {"spring", "attraction"});
  for (const core::Force& force : scene.forces) {
    const auto* spring = std::get_if<core::Spring>(&force);
    if (spring && spring->to == core::world) {
      refuse(name, "the spring of " + named(scene, spring->body) + " is pinned to a turning frame");
    }
  }
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
}

core::Truth inertial_truth(const core::Scene& inertial, double horizon) {
  std::string reasons;
  for (const Make make : turning) {
    try {
      return make(inertial, horizon);
    } catch (const core::OutOfDomain& refusal) {
      reasons += std::string(reasons.empty() ? "" : "; ") + refusal.what();
    }
  }
  refuse(name, "no solution serves the inertial scene (" + reasons + ")");
}

std::function<core::State(double)> solve(const core::Scene& scene, double horizon) {
  const Frame frame(scene);
  return [frame, truth = inertial_truth(frame.inertial(scene), horizon)](double t) {
    return frame.seen(truth.state(t), t);
  };
}

// The frame's share of the bound.  Inertia tensors stay as they are: the inertial solution has counted them,
// and a ball that is none by 1e-8 is not in the domain of every solution.
core::StateError error_of_frame(const core::Scene& scene, double horizon) {
  const auto with_inertia = [&](core::Scene nudged) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) nudged.bodies[i].inertia = scene.bodies[i].inertia;
    return solve(nudged, horizon);
  };
  return rounding_error(scene, with_inertia, horizon);
}

}  // namespace

core::Truth rotating_frame(const core::Scene& scene, double horizon) {
  if (!scene.frame) refuse(name, "the scene has no frame");
  if (!(horizon > 0) || !std::isfinite(horizon)) refuse(name, "the horizon must be positive and finite");
  if (scene.bodies.empty()) refuse(name, "the scene has no body");
  if (!scene.frame->turns())
    refuse(name, "the frame does not turn: a velocity changes nothing, and an acceleration is a gravity");
  if (!scene.frame->acceleration.isZero(0)) refuse(name, "the origin of the frame accelerates");
  const core::Vector3 &turn = scene.frame->angular_velocity, &faster = scene.frame->angular_acceleration;
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();  // of numbers that a file states
  if (turn.cross(faster).norm() > rounding * turn.norm() * faster.norm())
    refuse(name, "the frame's angular acceleration is not along its angular velocity");
  check_nothing_fixed(scene);
  const Frame frame(scene);
  const core::Truth inertial = inertial_truth(frame.inertial(scene), horizon);
  core::StateError error = error_of_frame(scene, horizon);
  error.position += inertial.error.position;
  error.velocity += inertial.error.velocity + frame.rate(horizon) * inertial.error.position;
  error.orientation += inertial.error.orientation;
  error.angular_velocity += inertial.error.angular_velocity;
  return {.state = solve(scene, horizon),
          .error = error,
          .source = "seen from a frame that turns; in space: " + inertial.source,
          .horizon = horizon};
}

}  // namespace cylon::exact
