// How the solutions through a box spread: derivatives with respect to the starting point, over the whole box.
#pragma once

#include "reference/certified/tails.h"

#include <Eigen/Core>

#include <span>

namespace cylon::certified {

/// Taylor coefficients in balls of two doubles, of a low order: they multiply what is small.  For a direction
/// A_d of the starting points the tangent of a node is  sum_k t_k t^k + rest,  with
///
///     (a b)' = a' b + a b',   (a/b)' = (a' - b' c)/b,   (sqrt a)' = a'/(2 c),   c the node itself,
///
/// coefficients by recurrence and rests as in tails.h.
class Variation {
 public:
  Variation(const Graph&, int order);

  /// A parameter's value in the series that follow.
  void choose(int parameter, double value) { *this->value(parameter).middle = value; }

  /// Series about `time` through all points of the box at once.
  void expand(double time, std::span<const Near> box);

  /// Tangents of all nodes for starting points that move along the columns.
  void differentiate(const Eigen::MatrixXd& directions);

  /// Whether solutions from the whole box, and their tangents, exist and are bounded over [0, h].
  bool prove(double h);

  /// Tangent of a node in a direction, t after the start, 0 <= t <= h.
  Near tangent(int node, int direction, double t) const;
  /// |tangent| over [0, t] of the step.
  double largest(int node, int direction, double t) const;
  /// |tangent| over the whole step.
  double largest(int node, int direction) const;

 private:
  struct Field {  // middles and radii of one node's coefficients
    double* middle;
    double* radius;
  };
  Field value(int node) { return {&middle_[at(node)], &radius_[at(node)]}; }
  Field slope(int node, int direction) {
    const std::size_t i = block(direction) + at(node);
    return {&slope_middle_[i], &slope_radius_[i]};
  }
  std::size_t at(int node) const { return static_cast<std::size_t>(node) * stride_; }
  std::size_t block(int direction) const {
    return static_cast<std::size_t>(direction) * graph_.size() * stride_;
  }
  void next(int node, int k);
  void next_slope(int node, int direction, int k);
  void scale(int direction);
  void spread(int direction);
  bool prove(int direction);

  const Graph& graph_;
  int order_;
  std::size_t stride_;
  double time_ = 0;
  int directions_ = 0;
  std::vector<int> active_, moving_;
  std::vector<double> middle_, radius_, slope_middle_, slope_radius_;
  Tails tails_;
  std::vector<double> scaled_, from_, beyond_;  // of the direction at hand, as in tails.h
  std::vector<double> size_, rest_;             // of all directions
};

}  // namespace cylon::certified
