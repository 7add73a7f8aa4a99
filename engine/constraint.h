// Constraints in their common form: one row per scalar condition c(state) = 0 on one body, or between two.
// Every kind of joint writes its rows; solving them is the same for all.
#pragma once

#include "engine/body.h"
#include "engine/sparse_factor.h"

#include <vector>

namespace cylon::engine {

/// One scalar condition.  Its rate is  c' = n.(v_a - v_b) + s_a.w_a - s_b.w_b  and
/// c'' = n.(a_a - a_b) + s_a.alpha_a - s_b.alpha_b + bias,  with v and a of the reference points.  A
/// condition on points has s = r x n; one on orientations has n = 0.  A row with a rotor is none: c is free, and moves the
/// rotor too, which pulls by lambda = -rotor c''.
struct Row {
  int body = 0;
  int to = fixed_world;
  Vector3 direction =
      Vector3::Zero();                 ///< n, world axes; the force on `body` is lambda n, on `to` -lambda n.
  Vector3 lever = Vector3::Zero();     ///< s_a [m]; the torque on `body` is lambda s_a.
  Vector3 to_lever = Vector3::Zero();  ///< s_b [m]; the torque on `to` is -lambda s_b.
  Real bias = 0;                       ///< The part of c'' that the velocities alone make [m/s^2].
  Real offset = 0;                     ///< c [m, rad].
  Real rounding = 0;                   ///< |c| below this is closed.
  Real rotor = 0;                      ///< [kg, kg m^2]; 0: the row is a condition.

  // Filled by the solver.
  Vector3 spin = Vector3::Zero();     ///< I_a^-1 s_a, world axes.
  Vector3 to_spin = Vector3::Zero();  ///< I_b^-1 s_b
  Real residual = 0;                  ///< What lambda has to cancel.
  Real lambda = 0;                    ///< The multiplier found.
};

/// Entry of J M^-1 J^T: what a unit multiplier on one row does to the other [1/kg, 1/(kg m), 1/(kg m^2)].
Real coupling(const Row&, const Row&, const std::vector<Body>&);

/// What the rotor of a row yields to a unit multiplier, beside what the bodies do: 1/rotor; 0 for a condition.
inline Real yield(const Row& row) { return row.rotor > 0 ? 1 / row.rotor : Real(0); }

/// Rows and the linear system (J M^-1 J^T + D) lambda = -residual that they share, D the yields of rotors; sparse: for
/// chains and trees the work is linear in the number of rows.  Rows that follow from others (two ball joints on one axis)
/// get lambda = 0.  Arrays of motion, kinematics and loads have one entry per body.
class Rows {
 public:
  std::vector<Row> rows;

  /// Makes c'' = 0, and lambda = -rotor c'' on rows with a rotor: adds the forces and torques to the loads.
  void constrain_accelerations(const std::vector<Body>&, const Motion*, const Kinematics*, Load*);

  /// How near the rows solved last are to saying the same: SparseFactor::weakest().
  Real weakest() const { return factor_.weakest(); }

  /// Whether every |c| is below its rounding.
  bool closed() const;

  /// The largest |c| that is more than 1000 times its rounding, which is no rounding any more, or not a number; 0:
  /// there is none.
  Real opening() const;
  /// The largest offset, in roundings; NaN where one is.
  Real widest() const;

  /// c -> 0 to first order, by the shortest way in the metric of the masses: p += lambda n/m, R turned by
  /// I^-1 s lambda.
  void project_positions(const std::vector<Body>&, Motion*);

  /// Makes c' = 0 by impulses at the constraint; seed eq. 88, 89 and 94-97 (errata 25, 33).  Of a row with a rotor, which
  /// turned at the rate `offset` before: lambda = -rotor (c' - offset).
  void project_velocities(const std::vector<Body>&, Motion*);

  /// Finds the impulses that change each c by -change (to first order after a time h) and adds them to the
  /// momenta of `motion`, at which the rows were written and measured: a step of SHAKE's iteration.
  void measure(const std::vector<Body>&, const Motion*, bool closed = false);
  void push(const std::vector<Real>& change, Real h, const std::vector<Body>&, Motion*);

  /// Takes from the loads what would change c' at once: J M^-1 load = 0, or of a row with a rotor, what that takes of it.
  /// Linear in the loads.  The rows must have been measured.
  void project_loads(const std::vector<Body>&, Load*);

 private:
  void solve();
  void add_forces(Load*) const;

  SparseFactor factor_;
  std::vector<SparseFactor::Ends> ends_;
  std::vector<Real> lambda_;
  std::vector<char> kept_;  // rows that reduced coordinates keep by themselves
};

}  // namespace cylon::engine
