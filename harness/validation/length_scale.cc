#include "harness/validation/length_scale.h"

#include "harness/core/input_error.h"
#include "harness/core/solid.h"
#include "harness/tracking/statistics/bootstrap.h"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <cmath>
#include <optional>

namespace cylon::validation {
namespace {

using core::BodyState, core::Vector3, measured::Experiment;

constexpr std::size_t least_flight = 8;  // frames: a parabola has three numbers

const core::Plane& plane_of(const Experiment& e) {
  if (e.model.scene.planes.size() != 1)
    throw core::InputError(fmt::format("{}: the scene has {} planes; the lengths are held against one",
                                       e.model.file, e.model.scene.planes.size()));
  return e.model.scene.planes[0];
}

// Half the thickness of the body below its centre, along the plane's normal.
double below(const Experiment& e, const BodyState& s) {
  return core::support(e.model.scene.bodies[e.bodies[0]].shape,
                       s.orientation.conjugate() * -plane_of(e).normal);
}

double height(const Experiment& e, const BodyState& s) {
  const core::Plane& plane = plane_of(e);
  return plane.normal.dot(s.position) - plane.offset;
}

// h = a + b t + c t^2, by least squares: -2 c / g.
std::optional<double> flight(const Experiment& e, const measured::Run& run, double g, double clearance) {
  std::size_t n = 0;
  while (n < run.states.size() && gap(e, run.states[n][0]) > clearance) ++n;
  if (n < least_flight) return std::nullopt;
  const auto rows = static_cast<Eigen::Index>(n);
  Eigen::MatrixX3d powers(rows, 3);
  Eigen::VectorXd heights(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) / e.rate;
    powers.row(i) << 1, t, t * t;
    heights[i] = height(e, run.states[static_cast<std::size_t>(i)][0]);
  }
  const Eigen::VectorXd fit = powers.colPivHouseholderQr().solve(heights);
  return -2 * fit[2] / g;
}

std::optional<double> rest(const Experiment& e, const measured::Run& run) {
  const BodyState& last = run.states.back()[0];
  const auto frames = static_cast<std::size_t>(std::ceil(0.1 * e.rate));
  if (run.states.size() <= frames) return std::nullopt;
  for (std::size_t i = run.states.size() - frames; i < run.states.size(); ++i)
    if ((run.states[i][0].position - last.position).norm() > 1e-3) return std::nullopt;
  return height(e, last) / below(e, last);
}

Estimate mean_of(const std::vector<double>& values) {
  return {statistics::mean(values), statistics::bootstrap(values, statistics::mean, 0.025, 1), values.size()};
}

}  // namespace

double gap(const Experiment& e, const BodyState& s) { return height(e, s) - below(e, s); }

LengthScale length_scale(const Experiment& e, double clearance) {
  const core::Scene& scene = e.model.scene;
  const double g = -plane_of(e).normal.dot(core::gravity_of(scene, scene.bodies[e.bodies[0]]));
  if (!(g > 0)) throw core::InputError(fmt::format("{}: nothing falls onto the plane", e.model.file));
  std::vector<double> flights, rests;
  for (const measured::Run& run : e.runs) {
    if (const auto ratio = flight(e, run, g, clearance)) flights.push_back(*ratio);
    if (const auto ratio = rest(e, run)) rests.push_back(*ratio);
  }
  return {mean_of(flights), mean_of(rests)};
}

}  // namespace cylon::validation
