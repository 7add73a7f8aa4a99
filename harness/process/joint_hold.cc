#include "harness/process/joint_hold.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>

namespace cylon::process {
namespace {

using core::Matrix3;
using core::Quaternion;
using core::Vector3;

constexpr int newton_steps = 10;
constexpr double rounding = 64 * 0x1p-52;  // of the lengths involved

struct End {
  Vector3 position = Vector3::Zero();  // of the anchor [m]
  Vector3 arm = Vector3::Zero();       // from the centre of mass [m]
  Quaternion orientation = Quaternion::Identity();
};

End end_of(const core::State& state, int body, const Vector3& anchor) {
  if (body == core::world) return {anchor, Vector3::Zero(), Quaternion::Identity()};
  const core::BodyState& s = state[static_cast<std::size_t>(body)];
  const Vector3 arm = s.orientation * anchor;
  return {s.position + arm, arm, s.orientation};
}

// J v = d.v_a + s_a.w_a - d.v_b - s_b.w_b, and the gap that it changes.
struct Row {
  int body, to;
  Vector3 direction, spin, to_spin;
  double gap;
  double scale;  // of the numbers whose difference the gap is
};

Vector3 rotation_vector(Quaternion q) {
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  return sine > 0 ? Vector3(2 * std::atan2(sine, q.w()) / sine * q.vec()) : Vector3(Vector3::Zero());
}

void add_point_rows(const HeldJoint& j, const End& a, const End& b, std::vector<Row>& rows) {
  const Vector3 apart = a.position - b.position;
  const double scale = a.position.norm() + a.arm.norm() + b.position.norm() + b.arm.norm();
  if (j.type == core::JointType::distance) {
    const double length = apart.norm();
    const Vector3 n = length > 0 ? Vector3(apart / length) : Vector3(Vector3::UnitY());
    rows.push_back({j.body, j.to, n, a.arm.cross(n), b.arm.cross(n), length - j.length, scale});
    return;
  }
  for (int k = 0; k < 3; ++k) {
    const Vector3 e = Vector3::Unit(k);
    rows.push_back({j.body, j.to, e, a.arm.cross(e), b.arm.cross(e), apart[k], scale});
  }
}

void add_spin_row(const HeldJoint& j, const Vector3& about, const Vector3& error, std::vector<Row>& rows) {
  rows.push_back({j.body, j.to, Vector3::Zero(), about, about, about.dot(error), 1});
}

std::vector<Row> rows_of(const std::vector<HeldJoint>& joints, const core::State& state) {
  std::vector<Row> rows;
  for (const HeldJoint& j : joints) {
    const End a = end_of(state, j.body, j.anchor), b = end_of(state, j.to, j.to_anchor);
    add_point_rows(j, a, b, rows);
    if (j.type == core::JointType::hinge) {
      const Vector3 axis = a.orientation * j.axis, error = (b.orientation * j.to_axis).cross(axis);
      const Vector3 one = axis.unitOrthogonal();
      add_spin_row(j, one, error, rows);
      add_spin_row(j, axis.cross(one), error, rows);
    } else if (j.type == core::JointType::fixed) {
      const Vector3 error = rotation_vector(a.orientation * (b.orientation * j.turn).conjugate());
      for (int k = 0; k < 3; ++k) add_spin_row(j, Vector3::Unit(k), error, rows);
    }
  }
  return rows;
}

// What impulses do to a body; nothing to a locked one, nor about an axis without inertia.
struct Mobility {
  double inverse_mass = 0;
  Matrix3 inverse_inertia = Matrix3::Zero();  // world axes
};

Mobility mobility(const core::Body& body, const Quaternion& orientation) {
  if (body.locked) return {};
  const core::PrincipalAxes principal = core::principal_axes(body.inertia);
  Vector3 inverse;
  for (int k = 0; k < 3; ++k)
    inverse[k] = principal.moments[k] > 1e-12 * principal.moments.maxCoeff() ? 1 / principal.moments[k] : 0;
  const Matrix3 axes = (orientation * principal.rotation).toRotationMatrix();
  return {1 / body.mass, axes * inverse.asDiagonal() * axes.transpose()};
}

// The jointed bodies' rows as one matrix J, with M^-1 J^T beside it.
class System {
 public:
  System(const core::Scene& scene, const core::State& state, const std::vector<Row>& rows) {
    for (const Row& row : rows)
      for (const int body : {row.body, row.to})
        if (body != core::world) places_.try_emplace(body, 6 * static_cast<Eigen::Index>(places_.size()));
    const auto count = static_cast<Eigen::Index>(rows.size()),
               width = 6 * static_cast<Eigen::Index>(places_.size());
    j_.setZero(count, width);
    back_.setZero(width, count);
    gaps_.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Row& row = rows[static_cast<std::size_t>(i)];
      gaps_[i] = row.gap;
      add(scene, state, i, row.body, row.direction, row.spin);
      add(scene, state, i, row.to, -row.direction, -row.to_spin);
    }
    answer_.compute(j_ * back_);
  }

  /// Changes of velocity, six numbers a body, that change J v by -error.
  Eigen::VectorXd correction(const Eigen::VectorXd& error) const { return -(back_ * answer_.solve(error)); }
  Eigen::VectorXd rates(const core::State& state) const {
    Eigen::VectorXd v(j_.cols());
    for (const auto& [body, place] : places_) {
      const core::BodyState& s = state[static_cast<std::size_t>(body)];
      v.segment<3>(place) = s.velocity;
      v.segment<3>(place + 3) = s.angular_velocity;
    }
    return j_ * v;
  }
  const Eigen::VectorXd& gaps() const { return gaps_; }
  const std::map<int, Eigen::Index>& places() const { return places_; }

 private:
  void add(const core::Scene& scene, const core::State& state, Eigen::Index i, int body,
           const Vector3& direction, const Vector3& spin) {
    if (body == core::world) return;
    const auto b = static_cast<std::size_t>(body);
    const Eigen::Index place = places_.at(body);
    const Mobility m = mobility(scene.bodies[b], state[b].orientation);
    j_.block<1, 3>(i, place) += direction.transpose();
    j_.block<1, 3>(i, place + 3) += spin.transpose();
    back_.block<3, 1>(place, i) += m.inverse_mass * direction;
    back_.block<3, 1>(place + 3, i) += m.inverse_inertia * spin;
  }

  std::map<int, Eigen::Index> places_;
  Eigen::MatrixXd j_, back_;
  Eigen::VectorXd gaps_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> answer_;  // joints may say the same thing twice
};

}  // namespace

std::vector<HeldJoint> held_joints(const core::Scene& scene) {
  std::vector<HeldJoint> held;
  const auto of = [&](int body) {
    return body == core::world ? core::BodyState{} : scene.bodies[static_cast<std::size_t>(body)].initial;
  };
  for (const core::Joint& joint : scene.joints) {
    const core::BodyState a = of(joint.body), b = of(joint.to);
    HeldJoint h{.type = joint.type, .body = joint.body, .to = joint.to, .length = joint.length};
    if (joint.type == core::JointType::distance) {  // joins the centres, or a centre and a point of the world
      if (joint.to == core::world) h.to_anchor = joint.point;
    } else {
      h.anchor = a.orientation.conjugate() * (joint.point - a.position);
      h.to_anchor = b.orientation.conjugate() * (joint.point - b.position);
      h.axis = a.orientation.conjugate() * joint.axis;
      h.to_axis = b.orientation.conjugate() * joint.axis;
      h.turn = b.orientation.conjugate() * a.orientation;
    }
    held.push_back(h);
  }
  return held;
}

core::Joint joint_at(const HeldJoint& held, const core::State& state) {
  // The world's end, or the end on `to`, is the one that does not move with the body's own errors.
  const End a = end_of(state, held.body, held.anchor), b = end_of(state, held.to, held.to_anchor);
  core::Joint joint;
  joint.type = held.type;
  joint.body = held.body;
  joint.to = held.to;
  joint.point = b.position;
  if (held.type == core::JointType::hinge)
    joint.axis = held.to == core::world ? held.to_axis : (b.orientation * held.to_axis).normalized();
  joint.length = held.type == core::JointType::distance ? (a.position - b.position).norm() : held.length;
  return joint;
}

void fit(const core::Scene& scene, const std::vector<HeldJoint>& joints, core::State& state) {
  for (int step = 0; step < newton_steps && !joints.empty(); ++step) {
    const std::vector<Row> rows = rows_of(joints, state);
    if (std::all_of(rows.begin(), rows.end(),
                    [](const Row& row) { return std::abs(row.gap) <= rounding * row.scale; }))
      break;
    const System system(scene, state, rows);
    const Eigen::VectorXd change = system.correction(system.gaps());
    for (const auto& [body, place] : system.places()) {
      core::BodyState& s = state[static_cast<std::size_t>(body)];
      s.position += change.segment<3>(place);
      const Vector3 turn = change.segment<3>(place + 3);
      if (const double angle = turn.norm(); angle > 0)
        s.orientation = (Quaternion(Eigen::AngleAxisd(angle, turn / angle)) * s.orientation).normalized();
    }
  }
  fit_velocities(scene, joints, state);
}

void fit_velocities(const core::Scene& scene, const std::vector<HeldJoint>& joints, core::State& state) {
  if (joints.empty()) return;
  const System system(scene, state, rows_of(joints, state));
  for (int pass = 0; pass < 2; ++pass) {  // the second takes the rounding of the first
    const Eigen::VectorXd change = system.correction(system.rates(state));
    for (const auto& [body, place] : system.places()) {
      core::BodyState& s = state[static_cast<std::size_t>(body)];
      s.velocity += change.segment<3>(place);
      s.angular_velocity += change.segment<3>(place + 3);
    }
  }
}

void kick(const core::Scene& scene, const std::vector<HeldJoint>& joints, core::State& state, int body,
          const Vector3& impulse) {
  const auto b = static_cast<std::size_t>(body);
  if (scene.bodies[b].locked) return;
  state[b].velocity += impulse / scene.bodies[b].mass;
  fit_velocities(scene, joints, state);
}

}  // namespace cylon::process
