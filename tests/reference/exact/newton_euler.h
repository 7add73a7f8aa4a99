// An independent check: Newton's and Euler's equations of a scene, integrated by extrapolation in 80-bit
// arithmetic.  Inertia tensors as they stand (no principal axes), rotation by quaternion and angular
// momentum.
#pragma once

#include "harness/core/scene.h"

#include <array>
#include <cmath>
#include <vector>

namespace cylon::exact {

/// One body, free, on springs to the world, or on a ball joint to the world; gravity.
class NewtonEuler {
 public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 3, 1>;
  using Matrix = Eigen::Matrix<Real, 3, 3>;
  using Coordinates =
      Eigen::Matrix<Real, 13, 1>;  // p, v, q (x, y, z, w), L about the centre of mass or pivot

  NewtonEuler(const core::Scene& scene, std::size_t index) : scene_(scene), index_(static_cast<int>(index)) {
    const core::Body& body = scene.bodies[index];
    const core::BodyState& s = body.initial;
    const auto q = s.orientation.cast<Real>().normalized();
    inertia_ = body.inertia.cast<Real>();
    mass_ = body.mass;
    for (const core::Force& force : scene.forces) {
      if (const auto* g = std::get_if<core::UniformGravity>(&force)) gravity_ += g->acceleration.cast<Real>();
    }
    if (!scene.joints.empty()) {
      pivot_ = scene.joints[index].point.cast<Real>();
      arm_ = q.conjugate() * (s.position.cast<Real>() - pivot_);
      inertia_ += mass_ * (arm_.squaredNorm() * Matrix::Identity() - arm_ * arm_.transpose());
      pinned_ = true;
    }
    inverse_ = inertia_.inverse();
    const Matrix r = q.toRotationMatrix();
    x_ << s.position.cast<Real>(), s.velocity.cast<Real>(), q.coeffs(),
        r * inertia_ * r.transpose() * s.angular_velocity.cast<Real>();
  }

  /// Advances to t in steps of about h: Gragg's midpoint rule with 2, 4, …, 12 substeps, extrapolated.
  core::BodyState at(Real t, Real h) {
    const int steps = static_cast<int>(std::ceil((t - t_) / h));
    for (int i = 0; i < steps; ++i)
      step((t - t_) / static_cast<Real>(steps - i)), t_ += (t - t_) / static_cast<Real>(steps - i);
    return state();
  }

 private:
  Coordinates rate(const Coordinates& x) const {
    const Eigen::Quaternion<Real> q = Eigen::Quaternion<Real>(x[9], x[6], x[7], x[8]).normalized();
    const Vector l = x.segment<3>(10), w = q * (inverse_ * (q.conjugate() * l));
    const Eigen::Quaternion<Real> turn = Eigen::Quaternion<Real>(0, w.x(), w.y(), w.z()) * q;
    Coordinates dx;
    dx.segment<4>(6) = turn.coeffs() / 2;
    if (pinned_) {
      const Vector weight = mass_ * gravity_;
      dx.segment<3>(0).setZero();
      dx.segment<3>(3).setZero();
      dx.segment<3>(10) = (q * arm_).cross(weight);
      return dx;
    }
    Vector force = mass_ * gravity_;
    for (const core::Force& f : scene_.forces) {
      const auto* spring = std::get_if<core::Spring>(&f);
      if (!spring || spring->body != index_) continue;
      const Vector d = spring->to_anchor.cast<Real>() - x.segment<3>(0);
      force += Real(spring->stiffness) * (1 - Real(spring->rest_length) / d.norm()) * d;
    }
    dx.segment<3>(0) = x.segment<3>(3);
    dx.segment<3>(3) = force / mass_;
    dx.segment<3>(10).setZero();
    return dx;
  }

  void step(Real h) {
    constexpr int columns = 6;  // more would amplify roundings: the weights grow with the order
    std::array<Coordinates, columns> table;
    for (int k = 0; k < columns; ++k) {
      const int n = 2 * (k + 1);
      const Real s = h / static_cast<Real>(n);
      Coordinates before = x_, here = x_ + s * rate(x_);
      for (int i = 1; i < n; ++i) {
        const Coordinates next = before + 2 * s * rate(here);
        before = here, here = next;
      }
      Coordinates row = (before + here + s * rate(here)) / 2;
      for (int j = 1; j <= k; ++j) {  // Aitken-Neville in s^2
        const Real ratio = static_cast<Real>(k + 1) / static_cast<Real>(k + 1 - j);
        const Coordinates better = row + (row - table[static_cast<std::size_t>(j - 1)]) / (ratio * ratio - 1);
        table[static_cast<std::size_t>(j - 1)] = row;
        row = better;
      }
      table[static_cast<std::size_t>(k)] = row;
    }
    x_ = table[columns - 1];
    x_.segment<4>(6).normalize();
  }

  core::BodyState state() const {
    const Eigen::Quaternion<Real> q(x_[9], x_[6], x_[7], x_[8]);
    const Vector l = x_.segment<3>(10), w = q * (inverse_ * (q.conjugate() * l));
    Vector p = x_.segment<3>(0), v = x_.segment<3>(3);
    if (pinned_) {
      p = pivot_ + q * arm_;
      v = w.cross(p - pivot_);
    }
    return {p.cast<double>(), q.cast<double>(), v.cast<double>(), w.cast<double>()};
  }

  const core::Scene& scene_;
  int index_;
  Matrix inertia_, inverse_;
  Vector gravity_ = Vector::Zero(), pivot_ = Vector::Zero(), arm_ = Vector::Zero();
  Real mass_ = 1, t_ = 0;
  bool pinned_ = false;
  Coordinates x_;
};

}  // namespace cylon::exact
