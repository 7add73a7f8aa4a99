#include "harness/core/uncertain.h"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace cylon::core {
namespace {

using Entry = Eigen::Vector4d;
using Difference = Vector3;  // as many numbers as the observable has, then zeros

Difference of_vectors(const Entry& a, const Entry& b) { return (a - b).head<3>(); }

// The rotation vector of the turn from b to a, in world axes.
Difference of_orientations(const Entry& a, const Entry& b) {
  const auto turn = [](const Entry& e) { return Quaternion(e[0], e[1], e[2], e[3]); };
  Quaternion between = turn(a) * turn(b).conjugate();
  if (between.w() < 0) between.coeffs() = -between.coeffs();
  const Eigen::AngleAxisd around(between);
  return around.angle() * around.axis();
}

Difference of_angles(const Entry& a, const Entry& b) {
  return {std::remainder(a.x() - b.x(), 2 * std::numbers::pi), 0, 0};
}

struct Row {
  Quantity quantity;
  Difference (*difference)(const Entry&, const Entry&);
  int (*numbers)(const Observable&);
};

// What can be told from measured positions and orientations alone.
constexpr Row rows[] = {
    {Quantity::position, of_vectors,
     [](const Observable& q) { return static_cast<int>(axes(q.component).size()); }},
    {Quantity::orientation, of_orientations, [](const Observable&) { return 3; }},
    {Quantity::joint_angle, of_angles, [](const Observable&) { return 1; }},
};

const Row* row_of(Quantity quantity) {
  const auto found = std::ranges::find(rows, quantity, &Row::quantity);
  return found == std::end(rows) ? nullptr : &*found;
}

// r of an entry, and C.
struct Deviation {
  Difference r = Difference::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  void add(const Difference& column) { covariance += column * column.transpose(); }
};

class Deviations {
 public:
  Deviations(const Claim& claim, const Scene& scene, const Recording& run, std::span<const Pushed> pushed)
      : claim_(claim), scene_(scene), run_(run), pushed_(pushed), row_(*row_of(claim.observable.quantity)) {}

  // Those of all bodies or joints at a measured time.
  std::vector<Deviation> at(double t) const {
    const std::size_t sample = sample_at(t);
    const Values got = values(run_.states[sample]), want = values(claim_.truth->state(t));
    std::vector<Deviation> all(got.size());
    for (std::size_t k = 0; k < got.size(); ++k) all[k].r = row_.difference(got[k], want[k]);
    for (const auto& [up, down] : pushed_) {
      const Values above = values(up.states.at(sample)), below = values(down.states.at(sample));
      for (std::size_t k = 0; k < got.size(); ++k) {
        const Difference there = row_.difference(above[k], got[k]), back = row_.difference(below[k], got[k]);
        const Difference bend = there + back;
        all[k].add((there - back) / 2);
        all[k].add(bend / std::numbers::sqrt2);
        all[k].r += bend / 2;
      }
    }
    for (const auto& [up, down] : claim_.uncertainty->measured(t)) {
      const Values above = values(up), below = values(down);
      for (std::size_t k = 0; k < got.size(); ++k) all[k].add(row_.difference(above[k], below[k]) / 2);
    }
    return all;
  }

 private:
  std::size_t sample_at(double t) const {
    const auto found = std::ranges::find(run_.steps, std::llround(t / run_.dt));
    if (found == run_.steps.end())
      throw std::logic_error(fmt::format("{}: the run was not recorded at {} s", claim_.label, t));
    return static_cast<std::size_t>(found - run_.steps.begin());
  }

  Values values(const State& state) const {
    Values found;
    evaluate(claim_.observable, scene_, state, found);
    return found;
  }

  const Claim& claim_;
  const Scene& scene_;
  const Recording& run_;
  std::span<const Pushed> pushed_;
  const Row& row_;
};

constexpr double confidence = 0.95;

}  // namespace

std::string no_interval(const Claim& claim) {
  if (!row_of(claim.observable.quantity)) {
    std::string valid;
    for (const Row& row : rows) valid += fmt::format("{}{}", valid.empty() ? "" : ", ", name(row.quantity));
    return fmt::format("observable: '{}' was not measured, or its uncertainty is not stated; valid: {}",
                       name(claim.observable.quantity), valid);
  }
  if (claim.reduction != Reduction::max && claim.reduction != Reduction::end)
    return fmt::format("measure: '{}' of a measured motion has no interval; valid: max, end",
                       name(claim.reduction));
  if (claim.tolerance.order || claim.tolerance.relative > 0 || claim.tolerance.roundings > 0)
    return "tolerance: that of a measured motion is absolute alone";
  return "";
}

Measured measure_uncertain(const Claim& claim, const Scene& scene, const Recording& run,
                           std::span<const Pushed> pushed) {
  const Deviations deviations(claim, scene, run, pushed);
  std::vector<double> times = claim.truth->times;
  if (claim.reduction == Reduction::end) times.erase(times.begin(), times.end() - 1);
  std::vector<Deviation> all;
  for (const double t : times) std::ranges::move(deviations.at(t), std::back_inserter(all));

  const int n = row_of(claim.observable.quantity)->numbers(claim.observable);
  const double each = -std::expm1(std::log(confidence) / static_cast<double>(all.size()));
  const double q =
      boost::math::quantile(boost::math::complement(boost::math::chi_squared_distribution<double>(n), each));
  Measured result;
  result.allowed = claim.tolerance.absolute;
  result.interval.emplace(0, 0);
  auto& [low, high] = *result.interval;
  for (const Deviation& one : all) {
    const double size = one.r.norm(), largest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                                                    one.covariance, Eigen::EigenvaluesOnly)
                                                    .eigenvalues()[2];
    const double half = std::sqrt(q * std::max(0.0, largest));
    if (!std::isfinite(size + half)) {
      result.value = low = high = std::nan("");
      break;
    }
    result.value = std::max(result.value, size);
    low = std::max(low, size - half), high = std::max(high, size + half);
  }
  result.detail =
      fmt::format("against a measured motion: 95 % for all of {} deviations together", all.size());
  return result;
}

}  // namespace cylon::core
