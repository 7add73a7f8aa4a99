#include "reference/measured/coordinates.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>

namespace cylon::measured {
namespace {

using core::BodyState, core::Quaternion, core::Scene, core::State, core::Vector3;

// The rotation vector of a turn of less than pi.
Vector3 rotation_vector(const Quaternion& turn) {
  const Eigen::AngleAxisd around(turn.w() < 0 ? Quaternion(-turn.coeffs()) : turn);
  return around.angle() * around.axis();
}

Quaternion turned(const Vector3& by, const Quaternion& q) {
  const double angle = by.norm();
  return angle > 0 ? Quaternion(Eigen::AngleAxisd(angle, by / angle) * q).normalized() : q;
}

const Vector3& axis_of(const Scene& scene, std::span<const std::size_t> bodies) {
  return joint_of(scene, bodies[0])->axis;
}

}  // namespace

std::string no_chain(const Scene& scene, std::span<const std::size_t> bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string& name = scene.bodies[bodies[i]].name;
    const core::Joint* joint = joint_of(scene, bodies[i]);
    if (!joint || joint->type != core::JointType::hinge)
      return fmt::format("'{}' is the body of no hinge", name);
    if (joint->to != (i == 0 ? core::world : static_cast<int>(bodies[i - 1])))
      return fmt::format("the hinge of '{}' does not go to {}", name,
                         i == 0 ? "the world" : "'" + scene.bodies[bodies[i - 1]].name + "'");
    if (joint->axis.cross(axis_of(scene, bodies)).norm() > 1e-12 ||
        joint->axis.dot(axis_of(scene, bodies)) < 0)
      return fmt::format("the axis of '{}' is not that of the first hinge", name);
  }
  return "";
}

State chain_state(const Scene& scene, std::span<const std::size_t> bodies, const Eigen::VectorXd& angles,
                  const Eigen::VectorXd& rates) {
  const Vector3 axis = axis_of(scene, bodies);
  State state;
  Vector3 pivot = joint_of(scene, bodies[0])->point, pivot_velocity = Vector3::Zero();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const Vector3 at_rest = joint_of(scene, bodies[i])->point, spin = rates[k] * axis;
    const Quaternion turn(Eigen::AngleAxisd(angles[k], axis));
    const BodyState& model = scene.bodies[bodies[i]].initial;
    const Vector3 arm = turn * (model.position - at_rest);
    state.push_back({.position = pivot + arm,
                     .orientation = (turn * model.orientation).normalized(),
                     .velocity = pivot_velocity + spin.cross(arm),
                     .angular_velocity = spin});
    if (i + 1 == bodies.size()) break;
    const Vector3 next = turn * (joint_of(scene, bodies[i + 1])->point - at_rest);
    pivot += next, pivot_velocity += spin.cross(next);
  }
  return state;
}

Eigen::VectorXd chain_angles(const Scene& scene, std::span<const std::size_t> bodies, const State& state) {
  Eigen::VectorXd angles(static_cast<Eigen::Index>(bodies.size()));
  const Vector3 axis = axis_of(scene, bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    angles[static_cast<Eigen::Index>(i)] = axis.dot(
        rotation_vector(state[i].orientation * scene.bodies[bodies[i]].initial.orientation.conjugate()));
  return angles;
}

Eigen::VectorXd chain_rates(const Scene& scene, std::span<const std::size_t> bodies, const State& state) {
  Eigen::VectorXd rates(static_cast<Eigen::Index>(bodies.size()));
  for (std::size_t i = 0; i < bodies.size(); ++i)
    rates[static_cast<Eigen::Index>(i)] = axis_of(scene, bodies).dot(state[i].angular_velocity);
  return rates;
}

Eigen::Index coordinates(const Experiment& e) {
  return e.coordinates == Coordinates::free ? 12 : 2 * static_cast<Eigen::Index>(e.bodies.size());
}

State moved(const Experiment& e, const State& state, const Eigen::VectorXd& by) {
  if (e.coordinates == Coordinates::chain) {
    const auto n = static_cast<Eigen::Index>(e.bodies.size());
    return chain_state(e.model.scene, e.bodies, chain_angles(e.model.scene, e.bodies, state) + by.head(n),
                       chain_rates(e.model.scene, e.bodies, state) + by.tail(n));
  }
  State made = state;
  BodyState& s = made[0];
  s.position += by.segment<3>(0);
  s.orientation = turned(by.segment<3>(3), s.orientation);
  s.velocity += by.segment<3>(6);
  s.angular_velocity += by.segment<3>(9);
  return made;
}

Eigen::VectorXd difference(const Experiment& e, const State& measured, const State& predicted) {
  if (e.coordinates == Coordinates::chain) {
    Eigen::VectorXd angles(static_cast<Eigen::Index>(e.bodies.size()));
    for (std::size_t i = 0; i < e.bodies.size(); ++i)
      angles[static_cast<Eigen::Index>(i)] =
          axis_of(e.model.scene, e.bodies)
              .dot(rotation_vector(measured[i].orientation * predicted[i].orientation.conjugate()));
    return angles;
  }
  const Vector3 place = e.length * (measured[0].position - predicted[0].position);
  if (!(e.angle_noise > 0)) return place;
  Eigen::VectorXd all(6);
  all << place, rotation_vector(measured[0].orientation * predicted[0].orientation.conjugate());
  return all;
}

Eigen::VectorXd noise(const Experiment& e) {
  if (e.coordinates == Coordinates::chain)
    return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(e.bodies.size()), e.angle_noise);
  Eigen::VectorXd all = Eigen::VectorXd::Constant(e.angle_noise > 0 ? 6 : 3, e.length * e.noise);
  all.tail(all.size() - 3).setConstant(e.angle_noise);
  return all;
}

Scene started(const Experiment& e, const State& start) {
  Scene scene = e.model.scene;
  if (e.coordinates == Coordinates::free) {
    scene.bodies[e.bodies[0]].initial = start[0];
    return scene;
  }
  // Angles and rates were measured: where they put the bodies is the model's, whose centres may be fitted.
  const State state = chain_state(e.model.scene, e.bodies, chain_angles(e.model.scene, e.bodies, start),
                                  chain_rates(e.model.scene, e.bodies, start));
  for (std::size_t i = 0; i < e.bodies.size(); ++i) scene.bodies[e.bodies[i]].initial = state[i];
  for (std::size_t i = 0; i < e.bodies.size(); ++i)
    for (core::Joint& joint : scene.joints)
      if (joint.body == static_cast<int>(e.bodies[i])) {
        const BodyState& at_rest = e.model.scene.bodies[e.bodies[i]].initial;
        joint.point = state[i].position + state[i].orientation * (at_rest.orientation.conjugate() *
                                                                  (joint.point - at_rest.position));
      }
  return scene;
}

State measured_of(const Experiment& e, const State& whole) {
  State state;
  for (const std::size_t i : e.bodies) state.push_back(whole[i]);
  return state;
}

}  // namespace cylon::measured
