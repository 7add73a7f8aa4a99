// What forces, or impulses, at points of contact do to the motion there: the matrix J M^-1 J^T, with the
// joints' own answer already in it.
#pragma once

#include "engine/constraint.h"
#include "engine/contact/coulomb.h"
#include "engine/contact/touch.h"

#include <span>
#include <utility>
#include <vector>

namespace cylon::engine {

/// Columns n, s, t: right-handed, unit.
Matrix3 contact_frame(const Vector3& normal);

/// Rows n, s, t of the point: directions, levers about the reference points and the spins they cause; of a
/// coordinate its row and two that are zero.
void append_rows(const TouchPoint&, const std::vector<Body>&, const Motion*, std::vector<Row>&);

/// Rows of contacts, three per point, and of joints after them.  Joints pull and push as they must, so they
/// are eliminated: with G = J M^-1 J^T in blocks c (contacts) and j (joints, with the yields of their rotors),
///   A = G_cc - G_cj G_jj^+ G_jc,   q = q_c - G_cj G_jj^+ q_j,   lambda = -G_jj^+ (q_j + G_jc f).
/// Along rows that joints alone keep, A and q are exactly 0: of their rounding forces would be made that are no numbers.
class Response {
 public:
  /// `joints`: rows with their directions and levers; biases are the caller's.
  Response(std::span<const TouchPoint>, std::span<const Row> joints, const std::vector<Body>&, const Motion*);

  const std::vector<Row>& rows() const { return rows_; }
  std::vector<Row> take_rows() { return std::move(rows_); }
  Eigen::Index contact_rows() const { return contacts_; }
  const MatrixX& matrix() const { return matrix_; }

  /// q from what every row (contacts, then joints) would do without contact and joint forces.
  VectorX offset(const VectorX& free) const;

  /// f and the joints' lambda, one per row.
  VectorX multipliers(const VectorX& free, const VectorX& contact_force) const;

 private:
  std::vector<Row> rows_;
  Eigen::Index contacts_ = 0;
  MatrixX matrix_;         // A
  MatrixX joint_inverse_;  // G_jj^+
  MatrixX cross_;          // G_cj
  std::vector<Eigen::Index> kept_;
};

/// Momenta change by lambda times each row.  K_a += lambda n, L_a += lambda s_a, and the opposite on `to`.
void apply_impulses(std::span<const Row>, const VectorX& lambda, const std::vector<Body>&, Motion*);

/// The problem of Coulomb's law at these points, holds not given.
CoulombProblem coulomb_problem(const Response&, std::span<const TouchPoint>, VectorX offset);

}  // namespace cylon::engine
