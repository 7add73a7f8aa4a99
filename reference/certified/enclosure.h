// A set that is known to hold the state: a point, and a small box around it whose axes turn with the flow.
#pragma once

#include "reference/certified/ball.h"
#include "reference/certified/bounds.h"

#include <Eigen/Core>

#include <vector>

namespace cylon::certified {

/// All x = centre + axes r, |r_i| <= radii_i, with `axes` orthogonal up to rounding.  (Lohner, Enclosing the
/// solutions of ordinary initial and boundary value problems, 1987: an interval box around a rotating set
/// grows by itself at every step, a box that turns with it does not.)
struct Enclosure {
  std::vector<Ball> centre;  ///< Exact points.
  Eigen::MatrixXd axes;
  Eigen::VectorXd radii;

  /// The balls themselves, axes along the coordinates.
  explicit Enclosure(const std::vector<Ball>& start);

  /// Its hull in double, a ball per coordinate.
  std::vector<Near> hull() const;

  /// The image of the set: `image` + tangents r + e, |e_i| <= the radii of `image`, where `tangents` encloses
  /// the derivative of the step along the axes.
  void move(const std::vector<Ball>& image, const Eigen::MatrixXd& tangents, const Eigen::MatrixXd& blur);
};

}  // namespace cylon::certified
