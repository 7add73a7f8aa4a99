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
///
/// Where rows depend on each other it matters which of them stand for the others.  The pivot of a row is sin^2 of
/// its angle to the span of those before it: where that is small, what comes after it loses digits, and a motion
/// that keeps the rows before it may leave for another branch (a Bennett linkage near the pose in which its
/// links are in line).  So where joints are closed rows with a small pivot go to the end, where others may do for
/// them, and stay there while that helps.  Between, where a stage has opened the joints a little, rows that depended
/// on others before seem to be new ones by that much: they stay dependent until their pivot is clearly more.
class SparseFactor {
 public:
  /// The bodies that a row acts on; none: it acts on one or on none.
  using Ends = std::array<int, 2>;
  static constexpr int none = -1;

  /// Two rows couple if they share a body.  Does nothing where the rows are those of before.
  void set_pattern(const std::vector<Ends>&);

  /// Sets A: coupling(i, j) is called for rows that may couple, and factors it.  A row whose pivot is at most
  /// `dependent` of its diagonal, or of what small pivots before it make of that in rounding, follows from those before it: D = 0 there; a row of which that was so before, where
  /// joints were closed, up to the root of that.  `closed`: whether they are, so that this may choose anew.
  template <class Coupling>
  void factor(Coupling coupling, Real dependent, bool closed) {
    const auto try_order = [&] {
      for (std::size_t k = 0; k < order_.size(); ++k)
        for (std::size_t e = start_[k]; e < start_[k + 1]; ++e)
          value_[e] = couples_[e] ? coupling(order_[k], order_[column_[e]]) : 0;
      eliminate(dependent);
    };
    try_order();
    if (!closed && !fresh_) return;
    fresh_ = false;
    if (!is_weak(dependent)) settled_ = 1;
    for (int tries = 0; tries < most_tries && is_weak(dependent) && 8 * weakest_ < settled_; ++tries) {
      const std::vector<std::size_t> before = order_;
      const Real weakest = weakest_;
      set_order(weak_last(dependent)), try_order();
      if (weakest_ >= 2 * weakest) continue;
      set_order(before), try_order();
      settled_ = weakest_;
    }
    for (std::size_t k = 0; k < order_.size(); ++k) depended_[order_[k]] = !(value_[start_[k + 1] - 1] > 0);
  }

  /// x <- A^-1 x, by the numbers of the rows; 0 for dependent rows.
  void solve(std::vector<Real>& x);

  /// The least pivot of the last factor(), as a share of its diagonal, among rows that do not follow from others; 1: no rows.
  Real weakest() const { return weakest_; }

  /// The entries of L, the diagonal included.
  std::size_t entries() const { return column_.size(); }

 private:
  using Graph = std::vector<std::vector<std::size_t>>;

  static std::vector<std::size_t> least_degree_first(const std::vector<Ends>&);
  void find_fill(const Graph& coupled, std::vector<std::size_t> order);
  void set_order(std::vector<std::size_t> order);
  void eliminate(Real dependent);
  Real weak_share(Real dependent) const;
  bool is_weak(Real dependent) const { return weakest_ < weak_share(dependent); }
  std::vector<std::size_t> weak_last(Real dependent) const;

  static constexpr int most_tries = 4;

  std::vector<Ends> ends_;
  std::vector<std::size_t> order_;   // the row that is eliminated k-th
  std::vector<std::size_t> start_;   // of each eliminated row's entries
  std::vector<std::size_t> column_;  // ascending within a row, the diagonal last
  std::vector<char> couples_;        // whether A may have the entry; else elimination fills it
  std::vector<Real> value_;          // A, then L with D on the diagonal
  std::vector<Real> share_;          // of each eliminated row's diagonal, what is left of it as pivot
  Real weakest_ = 1;                 // the least share of those that are no dependent rows
  bool any_dependent_ = false, fresh_ = true;
  std::vector<char> depended_;  // each row, where joints were closed
  Real settled_ = 1;            // what weakest_ was when no other order helped; 1 where none was asked for
  std::vector<Real> scaled_, turned_;
};

}  // namespace cylon::engine
