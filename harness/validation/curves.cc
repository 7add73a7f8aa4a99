#include "harness/validation/curves.h"

#include "reference/measured/coordinates.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace cylon::validation {

using measured::Coordinates, measured::Experiment;

std::vector<std::string> curve_names(const Experiment& e) {
  if (e.coordinates == Coordinates::free) return {"x", "y", "z"};
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= e.bodies.size(); ++i) names.push_back(fmt::format("angle {}", i));
  return names;
}

const char* curve_unit(const Experiment& e) { return e.coordinates == Coordinates::free ? "m" : "rad"; }

Eigen::VectorXd curve_noise(const Experiment& e) {
  if (e.coordinates == Coordinates::free) return Eigen::Vector3d::Constant(e.length * e.noise);
  return measured::noise(e);
}

Eigen::MatrixXd curves(const Experiment& e, const std::vector<core::State>& states,
                       const core::State& beside) {
  Eigen::MatrixXd all(static_cast<Eigen::Index>(states.size()),
                      static_cast<Eigen::Index>(curve_names(e).size()));
  if (e.coordinates == Coordinates::free) {
    for (Eigen::Index i = 0; i < all.rows(); ++i)
      all.row(i) = e.length * states[static_cast<std::size_t>(i)][0].position.transpose();
    return all;
  }
  Eigen::VectorXd last = measured::chain_angles(e.model.scene, e.bodies, beside);
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    const Eigen::VectorXd now =
        measured::chain_angles(e.model.scene, e.bodies, states[static_cast<std::size_t>(i)]);
    last += (now - last).unaryExpr([](double turn) { return std::remainder(turn, 2 * std::numbers::pi); });
    all.row(i) = last.transpose();
  }
  return all;
}

}  // namespace cylon::validation
