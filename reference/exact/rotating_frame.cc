// A scene given in a moving frame: the solution of the inertial scene, seen from the frame.  With W the
// frame's angular velocity, R(t) = rot(W t), inertial quantities with a dash, the frame's origin at rest
// (Galilei: its velocity changes nothing in a scene that nothing ties to the world):
//
//     p = R^-1 p',  v = R^-1 v' - W x p,  q = R^-1 q',  w = R^-1 w' - W;   at t = 0  v' = v + W x p,  w' = w
//     + W
//
// A frame that does not turn needs none of this: every solution serves its scene as it stands.
// Domain: scenes whose inertial form one of the solutions below serves; in a turning frame nothing that
// is fixed to the frame - gravity, pins, planes, joints, drag, drives, locked bodies - may act.
#include "reference/exact/domain.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"
#include "reference/exact/wide.h"

namespace cylon::exact {
namespace {

constexpr auto name = "rotating_frame";
using Make = core::Truth (*)(const core::Scene&, double);

// In this order: the first that accepts the inertial scene serves.
constexpr Make turning[] = {projectile, free_symmetric_top, free_asymmetric_top, kepler, spring_chain};

class Frame {
 public:
  explicit Frame(const core::Scene& scene) : spin_(widen(scene.frame->angular_velocity)) {}

  core::Scene inertial(core::Scene scene) const {
    scene.frame.reset();
    for (core::Body& body : scene.bodies) {
      core::BodyState& s = body.initial;
      s.velocity = (widen(s.velocity) + spin_.cross(widen(s.position))).cast<double>();
      s.angular_velocity = (widen(s.angular_velocity) + spin_).cast<double>();
    }
    return scene;
  }

  core::State seen(core::State state, double t) const {
    const WideQuaternion back = turn_by(spin_, -Wide(t));
    for (core::BodyState& s : state) {
      WideState w;
      w.position = back * widen(s.position);
      w.velocity = back * widen(s.velocity) - spin_.cross(w.position);
      w.orientation = back * widen(s.orientation);
      w.angular_velocity = back * widen(s.angular_velocity) - spin_;
      s = narrow(w);
    }
    return state;
  }

  double rate() const { return static_cast<double>(spin_.norm()); }

 private:
  WideVector spin_;
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
  if (scene.frame->angular_velocity.isZero(0.0)) {
    refuse(name, "the frame does not turn: leave it out, its velocity changes nothing");
  }
  check_nothing_fixed(scene);
  const Frame frame(scene);
  const core::Truth inertial = inertial_truth(frame.inertial(scene), horizon);
  core::StateError error = error_of_frame(scene, horizon);
  error.position += inertial.error.position;
  error.velocity += inertial.error.velocity + frame.rate() * inertial.error.position;
  error.orientation += inertial.error.orientation;
  error.angular_velocity += inertial.error.angular_velocity;
  return {.state = solve(scene, horizon),
          .error = error,
          .source = "seen from a frame that turns; in space: " + inertial.source,
          .horizon = horizon};
}

}  // namespace cylon::exact
