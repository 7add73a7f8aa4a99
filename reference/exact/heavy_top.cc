// Symmetric top on a ball joint (Lagrange).  J = I1 + m l^2 about the pivot, u = cos(theta) the axis d
// against the vertical, a = I3 w3/J, b = L_z/J, beta = 2 m g l/J, V = |d'|^2:
//
//     u'^2 = f(u) = V(u)(1 - u^2) - (b - a u)^2,  V(u) = V0 - beta (u - u0)
//     u = u1 cn^2 + u2 sn^2 of lam t + s0,  lam = sqrt(beta (u3 - u1))/2,  m = (u2 - u1)/(u3 - u1)
//     P- = (b - a)/2 int dt/(1 - u),   P+ = (b + a)/2 int dt/(1 + u)          (two integrals Pi)
//     phi + psi = (w3 - a) t + 2 P+,   phi - psi = (a - w3) t + 2 P-          (Euler's angles z-x-z)
//
// and the orientation is Cayley's and Klein's: with S = sin(theta/2), C = cos(theta/2),
//
//     q = (C cos (phi+psi)/2, S cos (phi-psi)/2, S sin (phi-psi)/2, C sin (phi+psi)/2)
//
// which has no pole: where the axis passes exactly through the vertical above (b = a, u2 = 1) S becomes
// sqrt((1 - u1)/2) cn with its sign and P- = 0; below (b = -a, u1 = -1) C becomes sqrt((1 + u2)/2) sn and P+
// = 0.
#include "reference/exact/domain.h"
#include "reference/exact/flight.h"
#include "reference/exact/heavy_top_axis.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"
#include "reference/exact/symmetry.h"

namespace cylon::exact {
namespace {

constexpr auto name = "heavy_top";

const core::Joint& joint_of(const core::Scene& scene, std::size_t index) {
  for (const core::Joint& joint : scene.joints) {
    if (joint.body == static_cast<int>(index)) return joint;
  }
  refuse(name, named(scene, static_cast<int>(index)) + " has no joint");
}

class HeavyTop {
 public:
  HeavyTop(const core::Scene& scene, std::size_t index) {
    const core::Body& body = scene.bodies[index];
    const WideQuaternion q = widen(body.initial.orientation);
    const WideVector g = widen(gravity(scene, index)), up = -g.normalized();
    pivot_ = widen(joint_of(scene, index).point);
    const WideVector arm = q.conjugate() * (widen(body.initial.position) - pivot_);  // body axes
    length_ = arm.norm();
    const Symmetry s = symmetry(body.inertia, arm.cast<double>());
    const WideVector axis = s.axis.dot(arm) < 0 ? WideVector(-s.axis) : s.axis;
    misfit_ = (arm / length_ - axis).norm();

    const WideVector d = q * axis, w = widen(body.initial.angular_velocity);
    const Wide inertia = s.transverse + Wide(body.mass) * length_ * length_;
    spin_ = w.dot(d);
    spin_left_ = spin_ * (1 - s.axial / inertia);
    axis_ = HeavyTopAxis({.direction = d,
                          .rate = w.cross(d),
                          .up = up,
                          .a = s.axial * spin_ / inertia,
                          .beta = 2 * Wide(body.mass) * g.norm() * length_ / inertia});
    if (!axis_.periodic()) return;

    // q = World rot_z(phi0) E(t) rot_z(psi0) Body^-1, with E(0) = (C, S, 0, 0).
    world_ = turn_between(WideVector::UnitZ(), up);
    body_ = turn_between(WideVector::UnitZ(), axis).conjugate();
    const AxisState start = axis_.at(0);
    const WideQuaternion e = world_.conjugate() * q * body_.conjugate();
    const Wide half_sum = std::atan2(e.z() * start.cosine, e.w() * start.cosine);
    const Wide half_difference = std::atan2(e.y() * start.sine, e.x() * start.sine);
    // Near a pole one of the two angles is lost.  The velocity gives it, where it moves the axis faster than
    // the axis is off the pole:  w_1 + i w_2 = (theta' + i phi' sin theta) exp(-i psi).
    Wide psi = half_sum - half_difference;
    const WideVector across = body_ * (q.conjugate() * w);
    if (std::hypot(across.x(), across.y()) >
        axis_.rate() * std::min(std::abs(start.sine), std::abs(start.cosine))) {
      psi = std::atan2(start.azimuth_rate, start.tilt_rate) - std::atan2(across.y(), across.x());
    }
    psi_ = psi;
    phi_ = std::abs(start.cosine) > std::abs(start.sine) ? 2 * half_sum - psi : 2 * half_difference + psi;
  }

  bool periodic() const { return axis_.periodic(); }
  double misfit() const { return static_cast<double>(misfit_); }
  double length() const { return static_cast<double>(length_); }

  WideState at(Wide t) const {
    const AxisState a = axis_.at(t);
    const Wide half_sum = spin_left_ * t / 2 + a.plus + (phi_ + psi_) / 2;
    const Wide half_difference = -spin_left_ * t / 2 + a.minus + (phi_ - psi_) / 2;
    const WideQuaternion e(a.cosine * std::cos(half_sum), a.sine * std::cos(half_difference),
                           a.sine * std::sin(half_difference), a.cosine * std::sin(half_sum));
    const Wide psi = half_sum - half_difference, c = std::cos(psi), s = std::sin(psi);
    const WideVector w = {a.azimuth_rate * s + a.tilt_rate * c, a.azimuth_rate * c - a.tilt_rate * s, spin_};
    WideState state;
    state.orientation = (world_ * e).normalized() * body_;
    state.angular_velocity = world_ * (e.normalized() * w);
    const WideVector arm = state.orientation * (body_.conjugate() * WideVector(0, 0, length_));
    state.position = pivot_ + arm;
    state.velocity = state.angular_velocity.cross(arm);
    return state;
  }

 private:
  WideVector pivot_;
  Wide length_ = 0, spin_ = 0, spin_left_ = 0;  // l, w3, w3 - a
  Wide misfit_ = 0;                             // angle between the axis and the way to the centre of mass
  HeavyTopAxis axis_;
  WideQuaternion world_, body_;  // third axis to the vertical; symmetry axis to the third axis
  Wide phi_ = 0, psi_ = 0;
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<HeavyTop> tops;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) tops.emplace_back(scene, i);
  return together(std::move(tops));
}

void check_joint(const core::Scene& scene, int index) {
  int joints = 0;
  for (const core::Joint& joint : scene.joints) {
    if (joint.body != index && joint.to != index) continue;
    ++joints;
    if (joint.type != core::JointType::ball)
      refuse(name, "the joint of " + named(scene, index) + " is not a ball joint");
    if (joint.to != core::world)
      refuse(name, "the joint of " + named(scene, index) + " does not end on the world");
  }
  if (joints != 1) refuse(name, named(scene, index) + " must have exactly one joint");
}

void check_top(const core::Scene& scene, int index) {
  const core::Body& body = scene.bodies[static_cast<std::size_t>(index)];
  const std::string of = named(scene, index);
  const core::Vector3 arm = body.initial.position - joint_of(scene, static_cast<std::size_t>(index)).point;
  if (arm.isZero(1e-12)) refuse(name, "the centre of mass of " + of + " is at its pivot");
  const Symmetry s = symmetry(body.inertia);
  if (s.difference > 1e-12L) refuse(name, of + " has no two equal principal moments");
  if (!(s.axial >= 0 && s.transverse >= 0)) refuse(name, of + " has a negative moment of inertia");
  const HeavyTop top(scene, static_cast<std::size_t>(index));
  if (top.misfit() > 1e-12) refuse(name, "the centre of mass of " + of + " is not on its symmetry axis");
  const core::Vector3 velocity = body.initial.angular_velocity.cross(arm);
  if ((body.initial.velocity - velocity).norm() > 1e-9 * (1 + velocity.norm())) {
    refuse(name, "the initial velocity of " + of + " breaks its joint");
  }
  if (!top.periodic())
    refuse(name, of + " is on the separatrix or too near it: its axis comes to rest upright");
}

}  // namespace

core::Truth heavy_top(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_no_contacts(name, scene);
  check_all_fall(name, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    check_joint(scene, i);
    check_top(scene, i);
  }
  core::StateError error = rounding_error(scene, solve, horizon);
  add_difference(scene, horizon, error);
  return {.state = solve(scene),
          .error = error,
          .source =
              "Goldstein, Classical Mechanics, section 5.7; Whittaker, Analytical Dynamics, section 72 "
              "(Cayley-Klein)",
          .horizon = horizon};
}

}  // namespace cylon::exact
