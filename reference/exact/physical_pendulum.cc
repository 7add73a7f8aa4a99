// Rigid body on a hinge (physical pendulum).  theta from the lowest position about the axis n, J the moment
// about the axis, l the distance of the centre of mass from it, g the part of gravity across it:
//
//     theta'' = -w0^2 sin theta,  w0^2 = m g l/J,  k^2 = sin^2(theta0/2) + (theta0'/(2 w0))^2
//     k < 1, swings:   sin(theta/2) = k sn(u|k^2),  cos(theta/2) = dn,   theta' = 2 w0 k cn,   u = w0 t + u0
//     k > 1, whirls:   sin(theta/2) = +-sn(u|1/k^2), cos(theta/2) = cn,  theta' = +-2 w0 k dn, u = w0 k t +
//     u0
//
// The half angles are the quaternion's components, so that nothing is inverted; 1 - k^2 is formed as a
// product of a sum and a difference.  Domain: one hinge to the world per body, gravity at any angle to the
// axis or none; not on the separatrix k = 1, nor nearer to it than 1e-14, where the starting values decide
// nothing.
#include "reference/exact/domain.h"
#include "reference/exact/elliptic.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"

#include <optional>

namespace cylon::exact {
namespace {

constexpr auto name = "physical_pendulum";

const core::Joint& hinge_of(const core::Scene& scene, std::size_t index) {
  for (const core::Joint& joint : scene.joints) {
    if (joint.body == static_cast<int>(index)) return joint;
  }
  refuse(name, named(scene, static_cast<int>(index)) + " must have exactly one joint");
}

class Pendulum {
 public:
  Pendulum(const core::Scene& scene, std::size_t index) {
    const core::Body& body = scene.bodies[index];
    const core::Joint& hinge = hinge_of(scene, index);
    axis_ = widen(hinge.axis).normalized();
    start_ = widen(body.initial.orientation);
    arm_ = widen(body.initial.position) - widen(hinge.point);
    pivot_ = widen(hinge.point);
    rate_ = axis_.dot(widen(body.initial.angular_velocity));
    const auto across = [this](const WideVector& v) -> WideVector { return v - axis_.dot(v) * axis_; };
    const WideVector arm = across(arm_), fall = across(widen(gravity(scene, index))),
                     n = start_.conjugate() * axis_;
    const Wide moment = n.dot(body.inertia.cast<Wide>() * n) + Wide(body.mass) * arm.squaredNorm();
    frequency_ = std::sqrt(Wide(body.mass) * fall.norm() * arm.norm() / moment);
    if (frequency_ == 0) return;

    // Half of the angle from `fall` to `arm` in (-pi, pi], by the chords to the lowest and highest points.
    const WideVector a = arm.normalized(), d = fall.normalized();
    sine_ = std::copysign((a - d).norm() / 2, axis_.dot(d.cross(a)));
    cosine_ = (a + d).norm() / 2;
    const Wide speed = rate_ / (2 * frequency_), k2 = sine_ * sine_ + speed * speed;
    const Wide below = (cosine_ - std::abs(speed)) * (cosine_ + std::abs(speed));  // 1 - k^2
    if (std::abs(below) < 1e-14L) return;
    modulus_ = std::sqrt(k2);
    whirls_ = below < 0;
    if (whirls_) {
      elliptic_.emplace(1 / k2, -below / k2);
      sense_ = rate_ < 0 ? -1 : 1;
      phase_ = elliptic_->first(sense_ * std::atan2(sine_, cosine_));
    } else {
      elliptic_.emplace(k2, below);
      phase_ = elliptic_->first(std::atan2(sine_, speed));
    }
  }

  bool on_separatrix() const { return frequency_ > 0 && !elliptic_; }

  WideState at(Wide t) const {
    Wide rate = rate_;
    WideQuaternion turned = turn(axis_, rate_ * t);
    if (elliptic_) {
      const Amplitude f = elliptic_->at(frequency_ * (whirls_ ? modulus_ : 1) * t + phase_);
      const Wide sine = whirls_ ? sense_ * f.sn : modulus_ * f.sn, cosine = whirls_ ? f.cn : f.dn;
      rate = 2 * frequency_ * modulus_ * (whirls_ ? sense_ * f.dn : f.cn);
      // theta - theta0, by half angles.
      const WideVector v = axis_ * (sine * cosine_ - cosine * sine_);
      turned = {cosine * cosine_ + sine * sine_, v.x(), v.y(), v.z()};
      turned.normalize();
    }
    WideState s;
    const WideVector arm = turned * arm_;
    s.orientation = turned * start_;
    s.angular_velocity = rate * axis_;
    s.position = pivot_ + arm;
    s.velocity = s.angular_velocity.cross(arm);
    return s;
  }

 private:
  WideVector axis_, pivot_, arm_;
  WideQuaternion start_;
  Wide rate_ = 0, frequency_ = 0;  // theta0', w0
  Wide sine_ = 0, cosine_ = 1;     // of theta0/2
  Wide modulus_ = 0, phase_ = 0, sense_ = 1;
  bool whirls_ = false;
  std::optional<Elliptic> elliptic_;
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<Pendulum> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.emplace_back(scene, i);
  return together(std::move(motions));
}

void check_hinge(const core::Scene& scene, int index) {
  const core::Body& body = scene.bodies[static_cast<std::size_t>(index)];
  const std::string of = named(scene, index);
  int joints = 0;
  for (const core::Joint& joint : scene.joints) {
    if (joint.body != index && joint.to != index) continue;
    ++joints;
    if (joint.type != core::JointType::hinge) refuse(name, "the joint of " + of + " is not a hinge");
    if (joint.to != core::world) refuse(name, "the joint of " + of + " does not end on the world");
  }
  if (joints != 1) refuse(name, of + " must have exactly one joint");
  const core::Joint& hinge = hinge_of(scene, static_cast<std::size_t>(index));
  const core::Vector3 w = body.initial.angular_velocity, n = hinge.axis.normalized();
  if (n.cross(w).norm() > 1e-12 * w.norm()) refuse(name, of + " does not turn about its hinge");
  const core::Vector3 velocity = w.cross(body.initial.position - hinge.point);
  if ((body.initial.velocity - velocity).norm() > 1e-9 * (1 + velocity.norm())) {
    refuse(name, "the initial velocity of " + of + " breaks its joint");
  }
  const core::Vector3 arm = body.initial.position - hinge.point,
                      axis = body.initial.orientation.conjugate() * n;
  if (!(axis.dot(body.inertia * axis) + body.mass * n.cross(arm).squaredNorm() > 0)) {
    refuse(name, of + " has no moment of inertia about its hinge");
  }
  if (Pendulum(scene, static_cast<std::size_t>(index)).on_separatrix()) {
    refuse(name, of + " is on the separatrix or too near it: it comes to rest upright");
  }
}

}  // namespace

core::Truth physical_pendulum(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_no_contacts(name, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) check_hinge(scene, i);
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = "Whittaker, Analytical Dynamics, section 44: the pendulum by Jacobi's functions",
          .horizon = horizon};
}

}  // namespace cylon::exact
