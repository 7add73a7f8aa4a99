#include "harness/process/joint_hold.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>

namespace cylon::process {
namespace {

using core::HeldJoint;
using core::JointRow;
using core::Matrix3;
using core::Quaternion;
using core::Vector3;

constexpr int newton_steps = 10;
constexpr double rounding = 64 * 0x1p-52;  // of the lengths involved

std::vector<JointRow> rows_of(const std::vector<HeldJoint>& joints, const core::State& state) {
  std::vector<JointRow> rows;
  for (const HeldJoint& joint : joints) add_rows(joint, state, rows);
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
  System(const core::Scene& scene, const core::State& state, const std::vector<JointRow>& rows) {
    for (const JointRow& row : rows)
      for (const int body : {row.body, row.to})
        if (body != core::world) places_.try_emplace(body, 6 * static_cast<Eigen::Index>(places_.size()));
    const auto count = static_cast<Eigen::Index>(rows.size()),
               width = 6 * static_cast<Eigen::Index>(places_.size());
    j_.setZero(count, width);
    back_.setZero(width, count);
    gaps_.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const JointRow& row = rows[static_cast<std::size_t>(i)];
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

void fit(const core::Scene& scene, const std::vector<HeldJoint>& joints, core::State& state) {
  for (int step = 0; step < newton_steps && !joints.empty(); ++step) {
    const std::vector<JointRow> rows = rows_of(joints, state);
    if (std::all_of(rows.begin(), rows.end(),
                    [](const JointRow& row) { return std::abs(row.gap) <= rounding * row.scale; }))
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
          const Vector3& impulse, const Vector3& angular_impulse) {
  const auto b = static_cast<std::size_t>(body);
  if (scene.bodies[b].locked) return;
  state[b].velocity += impulse / scene.bodies[b].mass;
  if (!angular_impulse.isZero(0))
    state[b].angular_velocity +=
        mobility(scene.bodies[b], state[b].orientation).inverse_inertia * angular_impulse;
  fit_velocities(scene, joints, state);
}

}  // namespace cylon::process
