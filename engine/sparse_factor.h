// A sparse symmetric matrix of rows that couple where they act on the same body, factored as L D L^T.
#pragma once

#include "engine/vector.h"

#include <array>
#include <cstddef>
#include <vector>

namespace cylon::engine {

/// A = L D L^T within the entries that elimination fills, found once for a pattern.  Rows of chains and trees
/// fill no other: the work is linear in their number.  T. A. Davis, Direct Methods for Sparse Linear Systems
/// (2006), sections 4.1 and 4.2.  Few rows, and rows that fill little, are eliminated as they come; else those
/// of least degree first.
class SparseFactor {
 public:
  /// The bodies that a row acts on; none: it acts on one or on none.
  using Ends = std::array<int, 2>;
  static constexpr int none = -1;

  /// Two rows couple if they share a body.  Does nothing where the rows are those of before.
  void set_pattern(const std::vector<Ends>&);

  /// Sets A: coupling(i, j) is called for rows that may couple, and factors it.  A row whose pivot is at most
  /// `dependent` of its diagonal follows from those before it: D = 0 there.
  template <class Coupling>
  void factor(Coupling coupling, Real dependent) {
    for (std::size_t k = 0; k < order_.size(); ++k)
      for (std::size_t e = start_[k]; e < start_[k + 1]; ++e)
        value_[e] = couples_[e] ? coupling(order_[k], order_[column_[e]]) : 0;
    eliminate(dependent);
  }

  /// x <- A^-1 x, by the numbers of the rows; 0 for dependent rows.
  void solve(std::vector<Real>& x);

  /// The entries of L, the diagonal included.
  std::size_t entries() const { return column_.size(); }

 private:
  using Graph = std::vector<std::vector<std::size_t>>;

  static std::vector<std::size_t> least_degree_first(const std::vector<Ends>&);
  void find_fill(const Graph& coupled, std::vector<std::size_t> order);
  void eliminate(Real dependent);

  std::vector<Ends> ends_;
  std::vector<std::size_t> order_;   // the row that is eliminated k-th
  std::vector<std::size_t> start_;   // of each eliminated row's entries
  std::vector<std::size_t> column_;  // ascending within a row, the diagonal last
  std::vector<char> couples_;        // whether A may have the entry; else elimination fills it
  std::vector<Real> value_;          // A, then L with D on the diagonal
  std::vector<Real> scaled_, turned_;
};

}  // namespace cylon::engine
