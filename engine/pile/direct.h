// All blocks of a small scene solved at once, to rounding, whatever the ratios of the masses.
#pragma once

#include "engine/pile/block.h"
#include "engine/pile/block_factor.h"

#include <Eigen/LU>

#include <cstdint>
#include <limits>
#include <vector>

namespace cylon::engine::pile {

/// Augmented Lagrangian.  With lambda the impulses so far, D a stiffness far above all masses, limits s =
/// friction lambda_n:
///   y = lambda - D (J V - b),  f = (max(y_n, 0), y_t shortened to s)   (joints: f = P y)
///   V minimises (V - V*)^T M (V - V*)/2 + sum psi(y): smooth and convex, f = -d psi/d(J V);  Newton's method
///   lambda <- f,  V <- V* + M^-1 J^T lambda, until f = lambda: then all of Coulomb's and Signorini's laws
///   hold
/// Where M has no inverse a heavy mass N stands in for it, and c = V - N^-1 J^T lambda for V*, so that the
/// laws are met with M itself.  After two rounds the limits are unknowns as well (couple): of bodies that
/// slide on two faces at once the rounds alone run away; from the fifth on they are extrapolated (take).  As
/// D exceeds the masses the error falls by orders of magnitude in every round, and rows that say the same
/// twice (four corners of a face) do no harm.  J. C. Simo, T. A. Laursen, Comput. Struct. 42 (1992) 97; the
/// limits taken from the round before: A. Curnier. Double in both builds: with masses of 1 : 10^6 the matrix
/// has a condition of 10^8 and more.
class Direct {
 public:
  /// In: V* in the movers, impulses of the step before in the blocks.  Out: V and the impulses.  False where
  /// the laws hold only to more than a thousand times the rounding.
  bool solve(std::vector<Block>&, const std::vector<Body>&, std::vector<Mover>&);

  /// From here on solutions end after so many operations, solved or not.
  void give_up_after(std::int64_t operations) { last_ = operations_ + operations; }

  /// The largest violation that the last solution left [m/s].
  double residual() const { return residual_; }

  /// Speeds that the last solution leaves by its own error, as far as the laws held [m/s, rad/s]: what approaches no faster
  /// does not approach.
  double unsure() const;

  /// Of all solutions so far (Stepper::operations()).
  std::int64_t operations() const { return operations_; }

 private:
  using Vector = Eigen::VectorXd;
  using V3 = Eigen::Vector3d;
  using M3 = Eigen::Matrix3d;
  using M6 = Eigen::Matrix<double, 6, 6>;
  struct Row {
    Block* block;
    int a, b;           // where their six velocities begin, or -1
    std::size_t where;  // of two that move: the block of the matrix
    V3 arm, to_arm, n, bias, lambda, best, f;
    V3 before, change;  // of the round before: its f, and f - lambda
    M3 space;
    M3 turn, to_turn;  // u = v_a + turn w_a - (v_b + to_turn w_b) + bias
    double stiffness, limit, start_limit, target, pitch;
    M3 slope;   // the symmetric part of -df/du; the rest is
    V3 skewed;  // skewed n^T
  };

  void set_up(std::vector<Block>&, const std::vector<Body>&, const std::vector<Mover>&);
  void place(const std::vector<Block>&, const std::vector<Mover>&);
  bool holds_in_loops() const;
  bool begins_at_rest() const;
  void make_consistent(std::vector<V3>& x);
  void reconcile_biases();
  void leave_out_balanced();
  V3 velocity(const Row&, const Vector&) const;
  void forces(const Vector& v, bool slopes, bool coupled = false);
  void fill_gradient();  // M (V - c) - J^T f
  double slope_along(const Vector& way);
  static M6 part(const Row&, const M3& turn, const M3& other);
  void factor();
  bool couple(double reach);
  double yielding(const Row&) const;
  double farthest(const Vector&, const Vector&) const;
  bool factor_skewed();
  void solve_skewed(Vector&);
  void subtract_product(const Vector& x, Vector& to);
  void take(bool extrapolated);
  void add_impulse(const Row&, const V3&, Vector&) const;
  void minimise();
  void velocities_of_impulses();

  std::vector<int> place_;  // of each body's six velocities
  std::vector<int> bodies_;
  std::vector<Row> rows_;
  std::vector<M6> masses_, inverses_, loose_;
  BlockFactor matrix_;
  Eigen::MatrixXd along_, unskewed_, few_;  // of solve_skewed()
  Eigen::PartialPivLU<Eigen::MatrixXd> few_factored_;
  std::vector<const Row*> skew_rows_;
  Vector few_rates_, column_, start_, free_, centre_, v_, gradient_, way_, push_;
  double residual_ = 0, allowed_ = 0, fastest_ = 0;  // of bodies, or of what impulses give them
  std::int64_t operations_ = 0, last_ = std::numeric_limits<std::int64_t>::max();  // no more than these
  double rounding_ = 0;  // of a velocity that impulses give [m/s]
};

}  // namespace cylon::engine::pile
