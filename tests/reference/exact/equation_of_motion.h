// What is left of the equations of motion when a truth is put into them: its states differentiated by central
// differences of tenth order against the forces and torques of the scene, written down once more from the
// definitions in harness/core/scene.h.  Joints to the world may exert what they can, and nothing else.
#pragma once

#include "harness/core/overloaded.h"
#include "harness/core/scene.h"
#include "harness/core/truth.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cylon::exact {

class EquationOfMotion {
 public:
  EquationOfMotion(const core::Scene& scene, const core::Truth& truth) : scene_(scene), truth_(truth) {}

  /// Largest relative violation over the bodies at time t [s], 5 h <= t, of p' = v, K' = F, q' = w q/2,
  /// L' = torque, and of the joints; each in units of the largest of its terms, p/s, q/s, K/s, L/s.
  double violation(double t, double h) const {
    double worst = 0;
    const core::State here = truth_.state(t);
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (scene_.bodies[i].locked) continue;
      const Change change = derivatives(i, t, h);
      const core::BodyState& s = here[i];
      const auto compare = [&](const core::Vector3& left, const core::Vector3& right, double scale) {
        if (scale > 0) worst = std::max(worst, (left - right).norm() / scale);
      };
      const core::Vector3 v = s.velocity, w = s.angular_velocity + spin(t);
      compare(change.position, v, std::max(v.norm(), s.position.norm() / second));
      const core::Quaternion half(0, w.x() / 2, w.y() / 2, w.z() / 2);
      const core::Quaternion turned = core::Quaternion(0, spin(t).x() / 2, spin(t).y() / 2, spin(t).z() / 2);
      const Eigen::Vector4d rate = (half * s.orientation).coeffs() - (turned * s.orientation).coeffs();
      worst = std::max(worst, (change.orientation - rate).norm() / std::max(rate.norm(), 1 / second));

      Load load = load_on(i, here, t);
      load.size = std::max(load.size, mass(i, t) * v.norm() / second);
      load.turning_size = std::max(load.turning_size, angular(i, s, t).norm() / second);
      const core::Vector3 reaction = change.momentum - load.force, twist = change.spin - load.torque;
      worst = std::max(worst, joint_violation(i, s, reaction, twist, load));
    }
    return worst;
  }

 private:
  static constexpr double second = 1;

  struct Change {
    core::Vector3 position, momentum, spin;
    Eigen::Vector4d orientation;
  };

  // Sums, and the largest of the terms.
  struct Load {
    core::Vector3 force = core::Vector3::Zero(), torque = core::Vector3::Zero();
    double size = 0, turning_size = 0;
    void push(const core::Vector3& f) { force += f, size = std::max(size, f.norm()); }
    void twist(const core::Vector3& m) { torque += m, turning_size = std::max(turning_size, m.norm()); }
  };

  // Of the frame.
  core::Vector3 spin(double t) const {
    return scene_.frame ? scene_.frame->angular_velocity_at(t) : core::Vector3(0, 0, 0);
  }
  core::Vector3 faster() const {
    return scene_.frame ? scene_.frame->angular_acceleration : core::Vector3(0, 0, 0);
  }

  double mass(std::size_t i, double t) const {
    double m = scene_.bodies[i].mass;
    for (const core::Force& force : scene_.forces) {
      const auto* thrust = std::get_if<core::Thrust>(&force);
      if (thrust && thrust->body == static_cast<int>(i)) m += thrust->mass_rate * t;
    }
    return m;
  }

  // I (w + W): of the inertial motion, in the frame's axes.
  core::Vector3 angular(std::size_t i, const core::BodyState& s, double t) const {
    return core::world_inertia(scene_.bodies[i], s.orientation) * (s.angular_velocity + spin(t));
  }

  Change derivatives(std::size_t i, double t, double h) const {
    constexpr double weights[] = {5.0 / 6, -5.0 / 21, 5.0 / 84, -5.0 / 504, 1.0 / 1260};
    Change sum = {core::Vector3::Zero(), core::Vector3::Zero(), core::Vector3::Zero(),
                  Eigen::Vector4d::Zero()};
    const Eigen::Vector4d middle = truth_.state(t)[i].orientation.coeffs();
    for (int k = 1; k <= 5; ++k) {
      for (int side : {-1, 1}) {
        const double time = t + side * k * h, weight = side * weights[k - 1] / h;
        const core::BodyState s = truth_.state(time)[i];
        sum.position += weight * s.position;
        sum.momentum += weight * mass(i, time) * s.velocity;
        sum.spin += weight * angular(i, s, time);
        sum.orientation +=
            weight * (s.orientation.coeffs().dot(middle) < 0 ? -1 : 1) * s.orientation.coeffs();
      }
    }
    return sum;
  }

  Load load_on(std::size_t index, const core::State& state, double t) const {
    Load load;
    const int self = static_cast<int>(index);
    const core::BodyState& s = state[index];
    const double m = mass(index, t);
    const core::Vector3 spin_momentum =
        core::world_inertia(scene_.bodies[index], s.orientation) * s.angular_velocity;
    for (const core::Force& force : scene_.forces) {
      std::visit(core::Overloaded{
                     [&](const core::UniformGravity& f) { load.push(m * f.acceleration); },
                     [&](const core::Spring& f) {
                       if (f.body == self) pull(load, f, s, f.anchor, end_of(f.to, f.to_anchor, state));
                       if (f.to == self) pull(load, f, s, f.to_anchor, end_of(f.body, f.anchor, state));
                     },
                     [&](const core::Drag& f) {
                       if (f.body != self) return;
                       load.push(-f.linear * s.velocity);
                       load.twist(-f.angular * s.angular_velocity);
                       load.twist(-f.momentum * spin_momentum);
                     },
                     [&](const core::Thrust& f) {
                       if (f.body != self) return;
                       load.push(s.orientation * f.force);
                       if (f.exhaust_velocity)
                         load.push(f.mass_rate * (s.velocity + s.orientation * *f.exhaust_velocity));
                       if (f.exchanged_velocity) load.push(f.mass_rate * *f.exchanged_velocity);
                     },
                     [&](const core::Drive& f) {
                       if (f.body == self) load.push(f.force * std::cos(f.frequency * t));
                     },
                     [&](const core::Attraction& f) {
                       if (f.body != self && f.to != self) return;
                       const auto other = static_cast<std::size_t>(f.body == self ? f.to : f.body);
                       const core::Vector3 d = state[other].position - s.position;
                       load.push(f.strength * m * mass(other, t) / std::pow(d.norm(), 3) * d);
                     },
                     [](const core::PluginForce&) { throw std::logic_error("no truth has one"); },
                     [&](const core::Water& f) {
                       const auto cell = [](double x) { return std::trunc((x + 5) / 0.25); };
                       const double i = cell(s.position.x()), j = cell(s.position.z());
                       if (s.position.y() >=
                           f.level + f.wave / 2 * (std::sin(f.speed * t + i) + std::sin(i * j / 2)))
                         return;
                       load.push({0, f.buoyancy, 0});
                       load.push(-f.drag * s.velocity);
                       load.twist(-spin_momentum);
                     },
                 },
                 force);
    }
    // A turning frame: Coriolis, Euler's and centrifugal forces; the axes turn under the angular momentum.
    load.push(-2 * m * spin(t).cross(s.velocity));
    load.push(-m * faster().cross(s.position));
    load.push(-m * spin(t).cross(spin(t).cross(s.position)));
    load.twist(-spin(t).cross(angular(index, s, t)));
    return load;
  }

  struct End {
    core::Vector3 position, velocity;
  };

  static End end_of(int body, const core::Vector3& anchor, const core::State& state) {
    if (body == core::world) return {anchor, core::Vector3(0, 0, 0)};
    const core::BodyState& s = state[static_cast<std::size_t>(body)];
    const core::Vector3 arm = s.orientation * anchor;
    return {s.position + arm, s.velocity + s.angular_velocity.cross(arm)};
  }

  static void pull(Load& load, const core::Spring& spring, const core::BodyState& s,
                   const core::Vector3& anchor, const End& end) {
    const core::Vector3 arm = s.orientation * anchor, d = end.position - s.position - arm;
    const double length = d.norm();
    if (length == 0) return;
    const double rate = d.dot(end.velocity - s.velocity - s.angular_velocity.cross(arm)) / length;
    const core::Vector3 f =
        (spring.stiffness * (length - spring.rest_length) + spring.damping * rate) / length * d;
    load.push(f);
    load.twist(arm.cross(f));
  }

  // What remains of force and torque must be what the body's joints can exert.
  double joint_violation(std::size_t i, const core::BodyState& s, const core::Vector3& reaction,
                         const core::Vector3& twist, const Load& load) const {
    const double size = std::max(load.size, reaction.norm());
    const auto joint = std::ranges::find(scene_.joints, static_cast<int>(i), &core::Joint::body);
    const auto relative = [](double x, double scale) { return scale > 0 ? x / scale : 0; };
    if (joint == scene_.joints.end()) {
      const double turning = std::max(load.turning_size, twist.norm());
      return std::max(relative(reaction.norm(), size), relative(twist.norm(), turning));
    }
    const core::Vector3 arm = joint->point - s.position;
    if (joint->type == core::JointType::distance) {  // along the rod
      return std::max({relative(reaction.cross(arm).norm(), size * arm.norm()),
                       relative(twist.norm(), load.turning_size), std::abs(arm.norm() / joint->length - 1)});
    }
    const core::Vector3 free_twist = twist - arm.cross(reaction);  // a ball exerts no torque about its point
    const double turning = std::max({load.turning_size, twist.norm(), arm.norm() * reaction.norm()});
    return joint->type == core::JointType::hinge ? relative(std::abs(free_twist.dot(joint->axis)), turning)
                                                 : relative(free_twist.norm(), turning);
  }

  const core::Scene& scene_;
  const core::Truth& truth_;
};

}  // namespace cylon::exact
