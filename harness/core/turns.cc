#include "harness/core/turns.h"

#include "harness/core/joint_coordinates.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace cylon::core {
namespace {

constexpr double turn = 2 * std::numbers::pi;

// Whether a potential of the angle depends on its turns: it has one, and no stops keep it within half a turn of its start.
bool winds(const JointAngle& angle) {
  const bool potential = angle.force != 0 || (angle.stiffness != 0 && !target_moves(angle));
  const auto near = [&](const std::optional<double>& stop) {
    return stop && std::abs(*stop - angle.start) < 0.9 * std::numbers::pi;
  };
  return potential && !(near(angle.lower) && near(angle.upper));
}

// Of one angle that has turned by so much since t = 0.
double potential(const JointAngle& angle, double turned) {
  const double q = angle.start + turned;
  const double spring = target_moves(angle) ? 0 : angle.stiffness / 2 * std::pow(q - target(angle, 0), 2);
  return spring - angle.force * q;
}

}  // namespace

AlongMotion::AlongMotion(const Observable& observable, const Scene& scene)
    : observable_(observable), scene_(scene) {
  if (observable.quantity != Quantity::energy) return;
  const State start = initial_state(scene);
  for (const Joint& joint : scene.joints) {
    bool winding = false;
    for (const JointAngle& angle : joint.angles) {
      if (!winds(angle)) continue;
      if (!winding) joints_.push_back(held_joint(scene, joint));
      winding = true;
      angles_.push_back({.joint = joints_.size() - 1,
                         .law = angle,
                         .rate = joint_angle_rate(joints_.back(), angle.which, start)});
    }
  }
}

void AlongMotion::evaluate(double time, const State& state, Values& values) {
  core::evaluate(observable_, scene_, state, values);
  if (!counts()) return;
  follow(time, state);
  values.front().x() += lost_ ? std::numeric_limits<double>::quiet_NaN() : beyond(state);
}

void AlongMotion::follow(double time, const State& state) {
  for (Angle& angle : angles_) {
    const HeldJoint& joint = joints_[angle.joint];
    const double rate = joint_angle_rate(joint, angle.law.which, state),
                 told = joint_angle(joint, angle.law.which, state),
                 led = angle.turned + (angle.rate + rate) / 2 * (time - time_),
                 off = std::remainder(told - led, turn);
    if (!(std::abs(off) <= turn / 4)) lost_ = true;
    angle.turned = led + off, angle.rate = rate;
  }
  time_ = time;
}

// What evaluate() has of an angle is that within half a turn.
double AlongMotion::beyond(const State& state) const {
  double sum = 0;
  for (const Angle& angle : angles_) {
    const double told = joint_angle(joints_[angle.joint], angle.law.which, state);
    // The same bits as without turns where there are none.
    if (std::abs(angle.turned - told) < turn / 2) continue;
    sum += potential(angle.law, angle.turned) - potential(angle.law, told);
  }
  return sum;
}

std::optional<std::string> untold_turns(const Claim& claim, const Scene& scene, const Recording& recording) {
  AlongMotion motion(claim.observable, scene), truth(claim.observable, scene);
  Values values;
  for (std::size_t i = 0; motion.counts() && i < recording.states.size(); ++i) {
    motion.evaluate(recording.time(i), recording.states[i], values);
    if (claim.truth) truth.evaluate(recording.time(i), claim.truth->state(recording.time(i)), values);
  }
  if (!motion.lost() && !truth.lost()) return std::nullopt;
  return "an angle on which a spring or a force acts turns too far from one sample to the next to be counted";
}

}  // namespace cylon::core
