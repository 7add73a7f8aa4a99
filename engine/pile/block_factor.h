// A sparse symmetric positive definite matrix of 6 x 6 blocks, one for each body and for each two that act on each other.
#pragma once

#include "engine/vector.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cylon::engine::pile {

/// A = L L^T by blocks, bodies of least degree first: of a tree elimination fills nothing, and the work is linear in its bodies.
/// A. George, J. W. Liu, Computer Solution of Large Sparse Positive Definite Systems (1981), chapter 5.
class BlockFactor {
 public:
  using Block = Eigen::Matrix<double, 6, 6>;
  using Vector = Eigen::VectorXd;
  using Pair = std::pair<int, int>;

  /// Of `bodies`, with what couples two of them.  Finds the order and what elimination fills, unless both are as before.
  void set_pattern(int bodies, std::vector<Pair> couples);

  void clear();
  Block& diagonal(int body) { return blocks_[index(place_[index(body)])]; }
  /// Where the block of two bodies that couple is, with the rows of the one that is eliminated later.
  std::size_t find(int body, int other) const;
  bool is_later(int body, int other) const { return place_[index(body)] > place_[index(other)]; }
  Block& at(std::size_t where) { return blocks_[where]; }

  void factor();
  /// x = A^-1 x, six numbers a body.  Requires factor().
  void solve(Vector& x) const;

  /// Multiplications of factor() and of solve(), about.
  std::int64_t work() const { return work_; }
  std::int64_t solve_work() const { return 72 * static_cast<std::int64_t>(blocks_.size()); }

 private:
  void find_order();
  void factor_diagonal(std::size_t k);

  int bodies_ = 0;
  std::vector<Pair> couples_;       // the first less than the second, ascending
  std::vector<int> order_, place_;  // the body that is eliminated k-th, and when each is
  std::vector<std::size_t> start_;  // of each column below its diagonal, in rows_
  std::vector<int> rows_;           // as they are eliminated, ascending within a column
  std::vector<Block> blocks_;       // the diagonal, then those of rows_
  Vector whole_;                    // the diagonal of A
  std::int64_t work_ = 0;
};

}  // namespace cylon::engine::pile
