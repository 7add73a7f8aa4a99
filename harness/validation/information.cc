#include "harness/validation/information.h"

#include "harness/tracking/statistics/quantile.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace cylon::validation {

Known known(const Score& score, std::span<const measured::Parameter> parameters) {
  const auto k = static_cast<Eigen::Index>(parameters.size());
  Eigen::VectorXd range(k);
  for (Eigen::Index j = 0; j < k; ++j) {
    const measured::Parameter& p = parameters[static_cast<std::size_t>(j)];
    range[j] = p.high - p.low;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(range.asDiagonal() * score.information *
                                                             range.asDiagonal());
  Known found;
  found.covariance = Eigen::MatrixXd::Zero(k, k);
  std::vector<bool> unknown(parameters.size(), false);
  for (Eigen::Index i = 0; i < k; ++i) {
    Eigen::VectorXd way = eigen.eigenvectors().col(i);
    const double error = 1 / std::sqrt(std::max(0.0, eigen.eigenvalues()[i]));
    if (!(2 * statistics::student_quantile(0.025, HUGE_VAL) * error < 1)) {
      Eigen::Index greatest = 0;
      way.cwiseAbs().maxCoeff(&greatest);
      if (way[greatest] < 0) way = -way;
      found.blind.push_back({{way.begin(), way.end()}, error});
      for (Eigen::Index j = 0; j < k; ++j)
        if (std::abs(way[j]) > 0.1) unknown[static_cast<std::size_t>(j)] = true;
    } else {
      const Eigen::VectorXd scaled = range.cwiseProduct(way) * error;
      found.covariance += scaled * scaled.transpose();
    }
  }
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(k);
  Eigen::MatrixXd outer = Eigen::MatrixXd::Zero(k, k);
  double m = 0;
  for (const Eigen::VectorXd& one : score.of_run) {
    gradient += one, outer += one * one.transpose();
    ++m;
  }
  found.freedom = m - 1;
  const Eigen::VectorXd step = found.covariance * gradient;
  found.newton.assign(step.begin(), step.end());
  const Eigen::MatrixXd between = found.covariance * (outer * (m / (m - 1))) * found.covariance;
  for (Eigen::Index j = 0; j < k; ++j) {
    const bool none = unknown[static_cast<std::size_t>(j)];
    found.error.push_back(none ? std::nan("") : std::sqrt(found.covariance(j, j)));
    found.alone.push_back(1 / std::sqrt(score.information(j, j)));
    found.spread.push_back(none || m < 2 ? std::nan("") : std::sqrt(between(j, j)));
  }
  return found;
}

statistics::Interval interval(double value, double error, double freedom) {
  if (!std::isfinite(error)) return {};
  const double half = statistics::student_quantile(0.025, freedom) * error;
  return {value - half, value + half};
}

}  // namespace cylon::validation
