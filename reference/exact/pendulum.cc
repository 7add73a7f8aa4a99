#include "reference/exact/pendulum.h"

#include "reference/exact/domain.h"

#include <algorithm>
#include <limits>

namespace cylon::exact {

PendulumMotion::PendulumMotion(Wide frequency, const Value& start) : frequency_(frequency), start_(start) {
  const Wide speed = start.rate / (2 * frequency), k2 = start.sine * start.sine + speed * speed;
  const Wide below = (start.cosine - std::abs(speed)) * (start.cosine + std::abs(speed));  // 1 - k^2
  if (std::abs(below) < 1e-14L) return;
  modulus_ = std::sqrt(k2);
  whirls_ = below < 0;
  if (whirls_) {
    elliptic_.emplace(1 / k2, -below / k2);
    sense_ = start.rate < 0 ? -1 : 1;
    phase_ = elliptic_->first(sense_ * std::atan2(start.sine, start.cosine));
  } else {
    elliptic_.emplace(k2, below);
    phase_ = elliptic_->first(std::atan2(start.sine, speed));
  }
}

PendulumMotion::Value PendulumMotion::at(Wide t) const {
  const Amplitude f = elliptic_->at(frequency_ * (whirls_ ? modulus_ : 1) * t + phase_);
  return {whirls_ ? sense_ * f.sn : modulus_ * f.sn, whirls_ ? f.cn : f.dn,
          2 * frequency_ * modulus_ * (whirls_ ? sense_ * f.dn : f.cn)};
}

// u of an angle on the way up, or, where it whirls downwards, of its mirror image.
Wide PendulumMotion::phase_of(Wide theta) const {
  if (whirls_) return elliptic_->first(sense_ * theta / 2);
  // am by its sine and cosine: cos^2 am = (k^2 - sin^2(theta/2))/k^2
  const Wide sine = std::sin(theta / 2);
  return elliptic_->first(std::atan2(sine, std::sqrt((modulus_ - sine) * (modulus_ + sine))));
}

// Where it swings, am is within a quarter turn on the way up, theta rising, and so is its mirror image on the way down:
// then the angles change their signs, and the stops their places.
PendulumMotion::Arrival PendulumMotion::arrives(Wide lower, Wide upper) const {
  constexpr Wide never = std::numeric_limits<Wide>::infinity();
  const bool down = start_.rate < 0 || (start_.rate == 0 && start_.sine > 0);
  if (whirls_) {
    const Wide u = phase_of(down ? lower : upper) - phase_;
    return {u / (frequency_ * modulus_), !down};
  }
  const Wide ahead = down ? -lower : upper, behind = down ? -upper : lower;
  const Wide am = std::atan2((down ? -1 : 1) * start_.sine, std::abs(start_.rate) / (2 * frequency_));
  const Wide from = elliptic_->first(am);
  const auto reached = [&](Wide theta) { return std::abs(std::sin(theta / 2)) < modulus_; };
  if (reached(ahead)) return {(phase_of(ahead) - from) / frequency_, !down};
  if (reached(behind)) return {(2 * elliptic_->quarter() - phase_of(behind) - from) / frequency_, down};
  return {never, false};
}

const core::Joint& hinge_of(const core::Scene& scene, std::size_t index) {
  return *std::ranges::find(scene.joints, static_cast<int>(index), &core::Joint::body);
}

HingedBody::HingedBody(const core::Scene& scene, std::size_t index) {
  const core::Body& body = scene.bodies[index];
  const core::Joint& hinge = hinge_of(scene, index);
  axis = widen(hinge.axis).normalized();
  start = widen(body.initial.orientation);
  arm = widen(body.initial.position) - widen(hinge.point);
  pivot = widen(hinge.point);
  initial.rate = axis.dot(widen(body.initial.angular_velocity));
  const auto across = [this](const WideVector& v) -> WideVector { return v - axis.dot(v) * axis; };
  const WideVector lever = across(arm), fall = across(widen(gravity(scene, index))),
                   n = start.conjugate() * axis;
  Wide moment = n.dot(body.inertia.cast<Wide>() * n) + Wide(body.mass) * lever.squaredNorm();
  for (const core::JointAngle& law : hinge.angles) moment += Wide(law.armature);
  frequency = std::sqrt(Wide(body.mass) * fall.norm() * lever.norm() / moment);
  if (frequency == 0) return;

  // Half of the angle from `fall` to the lever in (-pi, pi], by the chords to the lowest and highest points.
  const WideVector a = lever.normalized(), d = fall.normalized();
  initial.sine = std::copysign((a - d).norm() / 2, axis.dot(d.cross(a)));
  initial.cosine = (a + d).norm() / 2;
}

WideState HingedBody::moved(const WideQuaternion& turn, Wide rate) const {
  WideState s;
  const WideVector now = turn * arm;
  s.orientation = turn * start;
  s.angular_velocity = rate * axis;
  s.position = pivot + now;
  s.velocity = s.angular_velocity.cross(now);
  return s;
}

WideState HingedBody::turned(Wide angle) const { return moved(turn(axis, angle), initial.rate); }

// theta - theta0, by half angles.
WideState HingedBody::state(const PendulumMotion::Value& now) const {
  const WideVector v = axis * (now.sine * initial.cosine - now.cosine * initial.sine);
  WideQuaternion turn(now.cosine * initial.cosine + now.sine * initial.sine, v.x(), v.y(), v.z());
  turn.normalize();
  return moved(turn, now.rate);
}

void check_hinge(std::string_view solution, const core::Scene& scene, int index) {
  const core::Body& body = scene.bodies[static_cast<std::size_t>(index)];
  const std::string of = named(scene, index);
  int joints = 0;
  for (const core::Joint& joint : scene.joints) {
    if (joint.body != index && joint.to != index) continue;
    ++joints;
    if (joint.type != core::JointType::hinge) refuse(solution, "the joint of " + of + " is not a hinge");
    if (joint.to != core::world) refuse(solution, "the joint of " + of + " does not end on the world");
  }
  if (joints != 1) refuse(solution, of + " must have exactly one joint");
  const core::Joint& hinge = hinge_of(scene, static_cast<std::size_t>(index));
  const core::Vector3 w = body.initial.angular_velocity, n = hinge.axis.normalized();
  if (n.cross(w).norm() > 1e-12 * w.norm()) refuse(solution, of + " does not turn about its hinge");
  const core::Vector3 velocity = w.cross(body.initial.position - hinge.point);
  if ((body.initial.velocity - velocity).norm() > 1e-9 * (1 + velocity.norm())) {
    refuse(solution, "the initial velocity of " + of + " breaks its joint");
  }
  const core::Vector3 arm = body.initial.position - hinge.point,
                      axis = body.initial.orientation.conjugate() * n;
  if (!(axis.dot(body.inertia * axis) + body.mass * n.cross(arm).squaredNorm() > 0)) {
    refuse(solution, of + " has no moment of inertia about its hinge");
  }
}

}  // namespace cylon::exact
