// What a Taylor polynomial leaves out over a step: proven bounds for every node of a graph.
//
// Each node is a polynomial of degree N in time, whose coefficients are those of the exact solution, plus a
// rest of which only a bound is known.  Where two polynomials are multiplied, the coefficients up to N agree
// with the recurrence, so that the rest holds the coefficients beyond N alone: no cancellation, and double is
// enough for bounds of any smallness.  With m_k >= |a_k| h^k and |a| = sum_k m_k over the step h:
//
//     a + b:   R_a + R_b
//     a b:     sum_(j+k>N) m_a,j m_b,k + R_a |b| + |a| R_b + R_a R_b
//     c = a/b: (sum_(j+k>N) m_b,j m_c,k + R_a + R_b |c|) / min |b|
//     c = sqrt a: (sum_(j+k>N) m_c,j m_c,k + R_a) / (2 min c)
//
// The states' rests are guessed and then proven by Picard's operator: it maps {polynomial + rest} into itself
// when  h^(N+1) |f_N|/(N + 1) + h R_f <= R_x, and by Schauder's theorem the solution is in there.
#pragma once

#include "reference/certified/bounds.h"
#include "reference/certified/graph.h"

#include <vector>

namespace cylon::certified {

class Tails {
 public:
  Tails(const Graph&, int order);

  /// |coefficient k| of a node, to be filled in before prove().
  double& coefficient(int node, int k) { return given_[index(node, k)]; }
  /// |first coefficient| from below.
  double& least(int node) { return least_[static_cast<std::size_t>(node)]; }

  /// Whether the solution exists over [0, h] and every rest is bounded.
  bool prove(double h);

  double rest(int node) const { return rest_[static_cast<std::size_t>(node)]; }
  /// |coefficient k| h^k, and the sum over all k.
  double scaled(int node, int k) const { return scaled_[index(node, k)]; }
  double size(int node) const { return from_[index(node, 0)]; }
  /// min |node| over the step, rest included.
  double smallest(int node) const;
  /// sum_(j+k>N) of two nodes' scaled coefficients; the second by the sums of its last ones.
  double beyond(const double* a, const double* b_from) const;
  const double* scaled(int node) const { return &scaled_[index(node, 0)]; }
  const double* from(int node) const { return &from_[index(node, 0)]; }

  const Graph& graph() const { return graph_; }
  int order() const { return order_; }
  double step() const { return step_; }

 private:
  std::size_t index(int node, int k) const {
    return static_cast<std::size_t>(node) * stride_ + static_cast<std::size_t>(k);
  }
  void scale(double h);
  bool spread();

  const Graph& graph_;
  int order_;
  std::size_t stride_;
  double step_ = 0;
  std::vector<double> given_, scaled_, from_;  // from: sum of scaled from k on
  std::vector<double> least_, beyond_, rest_;
};

}  // namespace cylon::certified
