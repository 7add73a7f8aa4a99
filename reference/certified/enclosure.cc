#include "reference/certified/enclosure.h"

#include <Eigen/QR>

#include <algorithm>
#include <numeric>

namespace cylon::certified {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Splits balls into exact points and radii.
VectorXd strip(std::vector<Ball>& points) {
  VectorXd radii(static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    radii[static_cast<Index>(i)] = above(points[i].radius());
    mag_zero(arb_radref(points[i].get()));
  }
  return radii;
}

// An orthogonal basis whose first axes lie along the longest edges r_j column_j, so that these are kept best.
MatrixXd basis(const MatrixXd& columns, const VectorXd& radii) {
  std::vector<Index> order(static_cast<std::size_t>(columns.cols()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return columns.col(a).norm() * radii[a] > columns.col(b).norm() * radii[b];
  });
  MatrixXd sorted(columns.rows(), columns.cols());
  for (std::size_t i = 0; i < order.size(); ++i) sorted.col(static_cast<Index>(i)) = columns.col(order[i]);
  return Eigen::HouseholderQR<MatrixXd>(sorted).householderQ();
}

VectorXd raised(const VectorXd& x) {
  return x.unaryExpr([](double v) { return above(v); });
}

}  // namespace

Enclosure::Enclosure(const std::vector<Ball>& start)
    : centre(start),
      axes(MatrixXd::Identity(static_cast<Index>(start.size()), static_cast<Index>(start.size()))) {
  radii = strip(centre);
}

std::vector<Near> Enclosure::hull() const {
  const VectorXd reach = raised(axes.cwiseAbs() * radii);
  std::vector<Near> box;
  for (std::size_t i = 0; i < centre.size(); ++i)
    box.push_back({centre[i].middle(), above(centre[i].radius_of_middle() + reach[static_cast<Index>(i)])});
  return box;
}

// With Q the new axes: Q z = tangents r + e gives z = Q^-1 (tangents r + e).  Q^T Q = 1 + E, so that
// |Q^-1 y| <= |Q^T y| + ||E||/(1 - ||E||) ||Q^T y|| in the maximum norm.
void Enclosure::move(const std::vector<Ball>& image, const MatrixXd& tangents, const MatrixXd& blur) {
  centre = image;
  const VectorXd error = strip(centre);
  const MatrixXd q = basis(tangents, radii), qt = q.transpose(), size = qt.cwiseAbs();
  const auto n = static_cast<double>(q.rows());
  const double rounding = (n + 4) * 0x1p-52;
  const MatrixXd product = (qt * tangents).cwiseAbs() + size * (blur + rounding * tangents.cwiseAbs());
  const VectorXd z = raised(product * radii + size * error);
  const MatrixXd defect =
      (qt * q - MatrixXd::Identity(q.rows(), q.cols())).cwiseAbs() + rounding * (size * q.cwiseAbs());
  const double skew = above(defect.rowwise().sum().maxCoeff());
  radii = raised(z.array() + 2 * skew * z.maxCoeff());
  axes = q;
}

}  // namespace cylon::certified
