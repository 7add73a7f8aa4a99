// Bodies each on one joint to the world whose free coordinates do not couple, with what acts along them: springs,
// dampers, constant and harmonically driven forces, stops, dry friction (coordinate_motion.h), and a rotor of inertia A.
// With the joint's
// point o, the directions e_i and values q_i of its displacements, the axis n and the angle a, and the arm r from
// the point to the centre at t = 0, all since t = 0:
//
//     x = o + sum q_i e_i + R(n, a) r,   J = n.I n + m |n x r|^2
//
//     kind         coordinates            inertia M - A          pull of gravity G
//     slider       displacement           m                      m g.n
//     cylindrical  displacement, angle    m; J                   m g.n; 0
//     planar       two, angle; n x r = 0  m, m; n.I n            m g.e_i; 0
//     hinge        angle                  J                      0
//     screw        angle a, q = pitch a   J + m pitch^2          m pitch g.n
//
// Gravity has no torque about the axis: it is along it, or the centre is on it.  Domain: one joint for each body;
// no quadratic damping, no table of targets; moving targets only without stops and dry friction; finitely many bounces.
#include "reference/exact/coordinate_motion.h"
#include "reference/exact/domain.h"
#include "reference/exact/pieces.h"
#include "reference/exact/solutions.h"

#include "harness/core/joint_coordinates.h"

#include <algorithm>
#include <memory>
#include <set>

namespace cylon::exact {
namespace {

constexpr auto name = "jointed_body";

const core::Joint& joint_of(const core::Scene& scene, std::size_t index) {
  return *std::ranges::find(scene.joints, static_cast<int>(index), &core::Joint::body);
}

template <class Coordinate>
core::JointCoordinate law_of(const std::vector<Coordinate>& laws, core::Ordinal which) {
  const auto law = std::ranges::find(laws, which, &core::JointCoordinate::which);
  if (law == laws.end()) return {};
  return *law;
}

WideVector across(const WideVector& axis, const WideVector& v) { return v - axis.dot(v) * axis; }

// Geometry of a body on its joint, and its motion from there.
class Jointed {
 public:
  Jointed(const core::Scene& scene, std::size_t index, Wide horizon) {
    const core::Body& body = scene.bodies[index];
    const core::Joint& joint = joint_of(scene, index);
    const core::JointKind& kind = core::kind_of(joint.type);
    axis_ = widen(joint.axis).normalized();
    orientation_ = widen(body.initial.orientation);
    point_ = widen(joint.point);
    arm_ = widen(body.initial.position) - point_;
    const Wide mass = body.mass;
    const WideVector fall = widen(gravity(scene, index)), w = widen(body.initial.angular_velocity);
    const WideVector own = orientation_.conjugate() * axis_;
    turning_ = own.dot(body.inertia.cast<Wide>() * own) + mass * across(axis_, arm_).squaredNorm();
    if (kind.screws) pitch_ = joint.pitch;

    if (kind.has_second_axis()) {
      const WideVector second = widen(*joint.axis_2).normalized();
      directions_ = {second, axis_.cross(second)};
    } else if (kind.displacements() == 1) {
      directions_ = {axis_};
    }
    const WideVector slides = widen(body.initial.velocity) - w.cross(arm_);
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const auto which = i == 0 ? core::Ordinal::first : core::Ordinal::second;
      add(law_of(joint.displacements, which), mass, mass * fall.dot(directions_[i]),
          slides.dot(directions_[i]), horizon);
    }
    turns_ = kind.angles() == 1;
    if (!turns_) return;
    inertia_ = turning_ + mass * pitch_ * pitch_;
    add(law_of(joint.angles, core::Ordinal::first), inertia_, mass * pitch_ * fall.dot(axis_), w.dot(axis_),
        horizon);
    inertia_ += law_of(joint.angles, core::Ordinal::first).armature;
  }

  Wide inertia_of_turn() const { return inertia_; }

  /// A track of one piece for each time at which a coordinate begins one.
  Track track() const {
    std::set<Wide> starts;
    for (const CoordinateMotion& motion : motions_)
      for (const Wide start : motion.starts()) starts.insert(start);
    Track track;
    const auto self = std::make_shared<const Jointed>(*this);
    for (const Wide start : starts) {
      std::vector<std::size_t> pieces;
      for (const CoordinateMotion& motion : motions_) pieces.push_back(motion.piece_at(start));
      track.add(start, [self, start, pieces](Wide s) { return self->at(pieces, start + s); });
    }
    return track;
  }

 private:
  void add(const core::JointCoordinate& law, Wide inertia, Wide pull, Wide rate, Wide horizon) {
    motions_.emplace_back(law, inertia + Wide(law.armature), pull, rate, horizon);
    from_.push_back(law.start);
  }

  WideState at(const std::vector<std::size_t>& pieces, Wide t) const {
    WideState s{.position = point_, .velocity = WideVector::Zero(), .angular_velocity = WideVector::Zero()};
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const auto [place, rate] = motions_[i].at(pieces[i], t);
      s.position += (place - from_[i]) * directions_[i];
      s.velocity += rate * directions_[i];
    }
    WideQuaternion turned = WideQuaternion::Identity();
    if (turns_) {
      const auto [place, rate] = motions_.back().at(pieces.back(), t);
      const Wide angle = place - from_.back();
      turned = turn(axis_, angle);
      s.position += pitch_ * angle * axis_;
      s.velocity += pitch_ * rate * axis_;
      s.angular_velocity = rate * axis_;
    }
    const WideVector arm = turned * arm_;
    s.position += arm;
    s.velocity += s.angular_velocity.cross(arm);
    s.orientation = turned * orientation_;
    return s;
  }

  WideVector axis_, point_, arm_;
  WideQuaternion orientation_;
  Wide turning_ = 0, inertia_ = 0, pitch_ = 0;  // J, M of the angle
  bool turns_ = false;
  std::vector<WideVector> directions_;     // of the displacements
  std::vector<CoordinateMotion> motions_;  // displacements, then the angle
  std::vector<Wide> from_;                 // their values at t = 0
};

void check_coordinate(const std::string& of, const core::JointCoordinate& law) {
  if (law.quadratic_damping != 0) refuse(name, "the joint of " + of + " has quadratic damping");
  if (!law.target_times.empty()) refuse(name, "the joint of " + of + " has a table of targets");
  if (core::target_moves(law) && (law.friction != 0 || core::has_limit(law)))
    refuse(name, "the joint of " + of + " has a moving target and stops or dry friction");
}

void check_velocity(const core::Scene& scene, std::size_t index) {
  const core::Joint& joint = joint_of(scene, index);
  const core::BodyState& start = scene.bodies[index].initial;
  const core::Vector3 arm = start.position - joint.point;
  const core::RelativeMotion moves = {.velocity = start.velocity - start.angular_velocity.cross(arm),
                                      .spin = start.angular_velocity};
  const core::RelativeMotion broken = core::forbidden(joint, core::Vector3::Zero(), moves);
  if (broken.velocity.norm() > 1e-9 * (1 + moves.velocity.norm()) ||
      broken.spin.norm() > 1e-9 * (1 + moves.spin.norm()))
    refuse(name, "the initial velocity of " + named(scene, static_cast<int>(index)) + " breaks its joint");
}

void check_body(const core::Scene& scene, int body) {
  const auto index = static_cast<std::size_t>(body);
  const std::string of = named(scene, body);
  int joints = 0;
  for (const core::Joint& joint : scene.joints) {
    if (joint.body != body && joint.to != body) continue;
    ++joints;
    if (joint.to != core::world) refuse(name, "the joint of " + of + " does not end on the world");
    const core::JointKind& kind = core::kind_of(joint.type);
    if (kind.displacements() + kind.angles() == 0 || kind.turns_between_axes())
      refuse(name, "the joint of " + of + " is of kind " + std::string(kind.name));
    core::for_each_coordinate(joint, [&](const core::JointCoordinate& law) { check_coordinate(of, law); });
  }
  if (joints != 1) refuse(name, of + " must have exactly one joint");
  check_velocity(scene, index);

  const core::Joint& joint = joint_of(scene, index);
  const core::JointKind& kind = core::kind_of(joint.type);
  if (kind.angles() == 0) return;
  const core::Vector3 n = joint.axis.normalized(), fall = gravity(scene, index),
                      arm = scene.bodies[index].initial.position - joint.point;
  const bool off = n.cross(arm).norm() > 1e-14 * arm.norm();
  if (kind.has_second_axis() && off)
    refuse(name, "the centre of " + of + " is off the axis of its planar joint");
  if (off && n.cross(fall).norm() > 1e-14 * fall.norm())
    refuse(name, "gravity turns " + of + " about its joint: it is a pendulum");
  if (!(Jointed(scene, index, 0).inertia_of_turn() > 0))
    refuse(name, of + " has no moment of inertia about its joint");
}

Course solve(const core::Scene& scene, double horizon) {
  Course course;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    try {
      course.tracks.push_back(Jointed(scene, i, horizon).track());
    } catch (const std::domain_error& why) {
      refuse(name, named(scene, static_cast<int>(i)) + " " + why.what());
    }
  }
  return course;
}

}  // namespace

core::Truth jointed_body(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces_beside_joints(name, scene, {"gravity"});
  check_no_contacts(name, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) check_body(scene, i);
  return truth_of(
      name, scene, [horizon](const core::Scene& s) { return solve(s, horizon); }, horizon,
      "Landau & Lifshitz, Mechanics, sections 25 and 26: linear oscillations, from event to event");
}

}  // namespace cylon::exact
