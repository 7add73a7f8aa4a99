// A symmetric positive definite matrix whose rows begin late: Cholesky within the envelope.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace cylon::engine::pile {

/// A = L L^T; row i is kept from column first[i].  Work: the sum of the squares of the rows' lengths.
/// A. George, J. W. Liu, Computer Solution of Large Sparse Positive Definite Systems (1981), section 4.2.
class Envelope {
 public:
  using Vector = Eigen::VectorXd;

  void resize(const std::vector<int>& first) {
    first_ = first;
    start_.resize(first.size());
    std::size_t total = 0;
    work_ = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      start_[i] = total - static_cast<std::size_t>(first[i]);
      const std::size_t length = i + 1 - static_cast<std::size_t>(first[i]);
      total += length, work_ += static_cast<std::int64_t>(length * length);
    }
    values_.assign(total, 0);
  }
  void clear() { values_.assign(values_.size(), 0); }
  /// Multiplications of factor(), about.
  std::int64_t work() const { return work_; }
  int size() const { return static_cast<int>(first_.size()); }
  /// column <= row, within the envelope.
  double& at(int row, int column) { return values_[start_[index(row)] + index(column)]; }

  void factor() {
    for (int i = 0; i < size(); ++i)
      for (int j = first_[index(i)]; j <= i; ++j) {
        const int from = std::max(first_[index(i)], first_[index(j)]);
        const double whole = at(i, j), rest = whole - dot(i, j, from, j);
        // A pivot below the rounding of its row is rounding: a matrix a little stiffer is solved.
        at(i, j) = j < i ? rest / at(j, j) : std::sqrt(std::max(rest, 1e-14 * whole));
      }
  }

  /// x = A^-1 x.  Requires factor().
  void solve(Vector& x) {
    for (int i = 0; i < size(); ++i) {
      for (int k = first_[index(i)]; k < i; ++k) x[i] -= at(i, k) * x[k];
      x[i] /= at(i, i);
    }
    for (int i = size() - 1; i >= 0; --i) {
      x[i] /= at(i, i);
      for (int k = first_[index(i)]; k < i; ++k) x[k] -= at(i, k) * x[i];
    }
  }

 private:
  double dot(int i, int j, int from, int to) const {
    if (to <= from) return 0;
    using Row = Eigen::Map<const Vector>;
    return Row(values_.data() + start_[index(i)] + from, to - from)
        .dot(Row(values_.data() + start_[index(j)] + from, to - from));
  }

  std::vector<int> first_;
  std::vector<std::size_t> start_;
  std::vector<double> values_;
  std::int64_t work_ = 0;
};

}  // namespace cylon::engine::pile
