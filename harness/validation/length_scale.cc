#include "harness/validation/length_scale.h"

#include "harness/core/input_error.h"
#include "harness/core/solid.h"
#include "harness/tracking/statistics/bootstrap.h"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <cmath>
#include <cstdlib>
#include <variant>

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

double gravity_of(const Experiment& e) {
  const core::Scene& scene = e.model.scene;
  const double g = -plane_of(e).normal.dot(core::gravity_of(scene, scene.bodies[e.bodies[0]]));
  if (!(g > 0)) throw core::InputError(fmt::format("{}: nothing falls onto the plane", e.model.file));
  return g;
}

const core::Shape& shape_of(const Experiment& e) { return e.model.scene.bodies[e.bodies[0]].shape; }

// Half the thickness of the body below its centre, along the plane's normal.
double below(const Experiment& e, const BodyState& s) {
  return core::support(shape_of(e), s.orientation.conjugate() * -plane_of(e).normal);
}

double height(const Experiment& e, const BodyState& s) {
  const core::Plane& plane = plane_of(e);
  return plane.normal.dot(s.position) - plane.offset;
}

// Powers of time and heights of the frames before the first touch; no rows where they are too few.
struct Flight {
  Eigen::MatrixX3d powers;
  Eigen::VectorXd heights;
};

Flight flight_of(const Experiment& e, const measured::Run& run, double clearance) {
  std::size_t n = 0;
  while (n < run.states.size() && gap(e, run.states[n][0]) > clearance) ++n;
  const auto rows = static_cast<Eigen::Index>(n < least_flight ? 0 : n);
  Flight made{Eigen::MatrixX3d(rows, 3), Eigen::VectorXd(rows)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double t = static_cast<double>(i) / e.rate;
    made.powers.row(i) << 1, t, t * t;
    made.heights[i] = height(e, run.states[static_cast<std::size_t>(i)][0]);
  }
  return made;
}

// h = a + b t + c t^2, by least squares: -2 c / g.
void add_flight(const Flight& flight, double g, RunLengths& found) {
  if (flight.heights.size() == 0) return;
  const Eigen::Vector3d fit = flight.powers.colPivHouseholderQr().solve(flight.heights);
  found.flight = -2 * fit[2] / g;
  found.roughness =
      (flight.heights - flight.powers * fit).norm() / std::sqrt(static_cast<double>(flight.heights.size()));
}

bool is_at_rest(const Experiment& e, const measured::Run& run) {
  const auto frames = static_cast<std::size_t>(std::ceil(0.1 * e.rate));
  if (run.states.size() <= frames) return false;
  for (std::size_t i = run.states.size() - frames; i < run.states.size(); ++i)
    if ((run.states[i][0].position - run.states.back()[0].position).norm() > 1e-3) return false;
  return true;
}

void add_rest(const Experiment& e, const measured::Run& run, RunLengths& found) {
  if (!is_at_rest(e, run)) return;
  const BodyState& last = run.states.back()[0];
  found.height = height(e, last), found.half = below(e, last);
  found.side = axis_towards(last, plane_of(e).normal);
  if (const auto* box = std::get_if<core::Box>(&shape_of(e))) {
    const int axis = std::abs(found.side) - 1;
    const double along = (last.orientation.conjugate() * plane_of(e).normal)[axis];
    found.half = box->half_extents[axis];
    found.tilt = std::acos(std::min(1.0, std::abs(along)));
  }
}

Estimate mean_of(const std::vector<double>& values) {
  return {statistics::mean(values), statistics::bootstrap(values, statistics::mean, 0.025, 1), values.size()};
}

}  // namespace

double gap(const Experiment& e, const BodyState& s) { return height(e, s) - below(e, s); }

int axis_towards(const BodyState& s, const Vector3& direction) {
  const Vector3 in_body = s.orientation.conjugate() * direction;
  Eigen::Index axis = 0;
  in_body.cwiseAbs().maxCoeff(&axis);
  return static_cast<int>(axis + 1) * (in_body[axis] > 0 ? 1 : -1);
}

LengthScale length_scale(const Experiment& e, double clearance) {
  LengthScale all;
  all.gravity = gravity_of(e);
  std::vector<double> flights, rests, heights, tilts;
  for (const measured::Run& run : e.runs) {
    RunLengths found;
    found.run = run.name;
    add_flight(flight_of(e, run, clearance), all.gravity, found);
    add_rest(e, run, found);
    if (std::isfinite(found.flight)) flights.push_back(found.flight);
    if (std::isfinite(found.height))
      rests.push_back(found.height / found.half), heights.push_back(found.height);
    if (std::isfinite(found.tilt)) tilts.push_back(found.tilt * found.tilt);
    all.each.push_back(found);
  }
  all.flight = mean_of(flights), all.rest = mean_of(rests), all.height = mean_of(heights);
  all.tilt = std::sqrt(statistics::mean(tilts));
  return all;
}

std::vector<double> off_the_fall(const Experiment& e, std::size_t run, double clearance) {
  const Flight flight = flight_of(e, e.runs[run], clearance);
  if (flight.heights.size() == 0) return {};
  const Eigen::VectorXd rest = flight.heights + gravity_of(e) / 2 * flight.powers.col(2);
  const Eigen::MatrixX2d line = flight.powers.leftCols<2>();
  const Eigen::VectorXd off = rest - line * line.colPivHouseholderQr().solve(rest);
  return {off.begin(), off.end()};
}

}  // namespace cylon::validation
