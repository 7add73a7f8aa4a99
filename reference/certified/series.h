// Taylor coefficients in time of every node of a graph, by recurrence, in ball arithmetic.
#pragma once

#include "reference/certified/graph.h"

#include <span>

namespace cylon::certified {

class Series {
 public:
  /// Room for coefficients 0 … order.
  Series(const Graph&, int order, slong bits);
  ~Series();
  Series(const Series&) = delete;
  Series& operator=(const Series&) = delete;

  /// A parameter's value in the series that follow.
  void choose(int parameter, double value) { arb_set_d(row(parameter), value); }

  /// About `time` [s], from the states there: the series of the solution through each point of the balls.
  void expand(double time, std::span<const Ball> states);

  /// Coefficients of a node; only the first one of a constant.
  arb_srcptr operator[](int node) const { return row(node); }
  int order() const { return order_; }
  slong bits() const { return bits_; }

  /// The polynomial of a node at time + t.
  Ball at(int node, const Ball& t) const;

 private:
  arb_ptr row(int node) const { return coefficients_ + static_cast<std::size_t>(node) * stride_; }
  void next(int node, int k);

  const Graph& graph_;
  int order_;
  slong bits_;
  std::size_t stride_;
  arb_ptr coefficients_;
  double time_ = 0;
  std::vector<int> active_;  // all but constants
};

}  // namespace cylon::certified
