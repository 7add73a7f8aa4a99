// Constraints in their common form: one row per scalar condition c(state) = 0 on one body, or between two.
// Every kind of joint or contact writes its rows; solving them is the same for all.
#pragma once

#include "engine/body.h"

#include <vector>

namespace cylon::engine {

/// One scalar condition.  Its rate is  c' = n.(v_a - v_b) + s_a.w_a - s_b.w_b  and
/// c'' = n.(a_a - a_b) + s_a.alpha_a - s_b.alpha_b + bias, with n the direction and s = r x n the lever.
struct Row {
  int body = 0;
  int to = fixed_world;
  Vector3 direction =
      Vector3::UnitY();                ///< n, world axes; the force on `body` is lambda n, on `to` -lambda n.
  Vector3 lever = Vector3::Zero();     ///< s_a [m]; the torque on `body` is lambda s_a.
  Vector3 to_lever = Vector3::Zero();  ///< s_b [m]
  Real bias = 0;                       ///< The part of c'' that the velocities alone make [m/s^2].
  Real offset = 0;                     ///< c [m].
  bool pushes_only = false;            ///< lambda >= 0: a contact.

  // Filled by the solver.
  Vector3 spin = Vector3::Zero();     ///< I_a^-1 s_a, world axes.
  Vector3 to_spin = Vector3::Zero();  ///< I_b^-1 s_b
  Real residual = 0;                  ///< What lambda has to cancel.
  Real lambda = 0;                    ///< The multiplier found.
  bool active = true;                 ///< false: a contact that would have to pull.
};

/// Rows and the linear system (J M^-1 J^T) lambda = -residual that they share.  Dense: its work grows with
/// the cube of the number of rows.  Rows that follow from others (two ball joints on one axis) get lambda =
/// 0.
class Rows {
 public:
  std::vector<Row> rows;

  /// Makes c'' = 0: adds the constraint forces and torques to the rates.  Contacts that would pull are left
  /// out.
  void constrain_accelerations(const std::vector<Body>&, const std::vector<Motion>&, std::vector<Rate>&);

  /// Whether every |c| is below 1e-15 m, which no further sweep betters for lengths of a metre.
  bool closed() const;

  /// c -> 0 to first order, by the shortest way in the metric of the masses: p += lambda n/m, R turned by
  /// I^-1 s lambda.
  void project_positions(const std::vector<Body>&, std::vector<Motion>&);

  /// Makes c' = 0 by impulses at the constraint; seed eq. 88, 89 and 94-97 (errata 25, 33).
  void project_velocities(const std::vector<Body>&, std::vector<Motion>&);

 private:
  void measure(const std::vector<Body>&, const std::vector<Motion>&);
  void solve();

  std::vector<Real> matrix_, factor_;  // lower triangles, row-major
};

}  // namespace cylon::engine
