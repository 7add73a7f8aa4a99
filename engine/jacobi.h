// Cyclic Jacobi rotations: eigenvalues and eigenvectors of a symmetric matrix, in plain arithmetic, so that
// every compiler gives the same bits.
// G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., section 8.5.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

/// What lies between two diagonal entries is rounding.  |a_pq| <= eps sqrt(|a_pp a_qq|), which keeps the
/// digits of small eigenvalues beside great ones: J. Demmel, K. Veselic, Jacobi's method is more accurate
/// than QR, SIAM J. Matrix Anal. 13 (1992) 1204, section 3.  An eigenvalue that is none is known to rounding
/// of the greatest entry only, which is `scale`.
template <class Number>
bool negligible(Number between, Number p, Number q, Number scale) {
  constexpr Number eps = std::numeric_limits<Number>::epsilon();
  const Number x = std::abs(between);
  return x <= eps * std::sqrt(std::abs(p)) * std::sqrt(std::abs(q)) || x <= eps * eps * scale;
}

///   theta = (a_qq - a_pp)/2a_pq,  t = sgn(theta)/(|theta| + sqrt(theta^2 + 1)),  c = 1/sqrt(t^2 + 1),
///   s = t c;  a_pp -= t a_pq,  a_qq += t a_pq,  a_pq = 0;  the other rows and V are turned by (c, s).
/// Golub & Van Loan, eq. (8.5.1), (8.5.2), written as corrections so that small turns lose no digits.
/// Requires p < q and a_pq != 0.
template <class Matrix>
void rotate(Matrix& a, Matrix& axes, Eigen::Index p, Eigen::Index q) {
  using Number = typename Matrix::Scalar;
  const auto turn = [](Number& u, Number& v, Number s, Number tau) {
    const Number f = u, g = v;
    u = f - s * (g + tau * f);
    v = g + s * (f - tau * g);
  };
  const auto between = [&a](Eigen::Index i, Eigen::Index j) -> Number& { return i < j ? a(i, j) : a(j, i); };
  const Number x = a(p, q);
  const Number theta = (a(q, q) - a(p, p)) / (2 * x);
  // beyond 1/eps theta^2 + 1 is theta^2, which would overflow
  const Number size = std::abs(theta);
  const Number root = size > 1 / std::numeric_limits<Number>::epsilon() ? size : std::sqrt(theta * theta + 1);
  const Number t = (theta < 0 ? Number(-1) : Number(1)) / (size + root);
  const Number c = 1 / std::sqrt(t * t + 1), s = t * c, tau = s / (1 + c);
  a(p, p) -= t * x;
  a(q, q) += t * x;
  a(p, q) = 0;
  for (Eigen::Index r = 0; r < a.rows(); ++r) {
    if (r != p && r != q) turn(between(p, r), between(q, r), s, tau);
  }
  for (Eigen::Index i = 0; i < a.rows(); ++i) turn(axes(i, p), axes(i, q), s, tau);
}

/// A = V diag(d) V^T: `a` ends with d on its diagonal, `axes` with V in its columns, in no order.  Of `a`
/// only the diagonal and what lies above it are read.  Any finite symmetric A.
template <class Matrix>
void diagonalise(Matrix& a, Matrix& axes) {
  using Number = typename Matrix::Scalar;
  // Sweeps with turns of at most pi/4 converge (G. Forsythe, P. Henrici, Trans. AMS 94 (1960) 1), in the end
  // quadratically: five are enough for 3 x 3, nine for 64 x 64, so that only what is no number takes 32.
  constexpr int most_sweeps = 32;
  const Eigen::Index n = a.rows();
  Number scale = 0;
  for (Eigen::Index q = 0; q < n; ++q)
    for (Eigen::Index p = 0; p <= q; ++p) scale = std::max(scale, std::abs(a(p, q)));
  axes.setIdentity(n, n);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool done = true;
    for (Eigen::Index p = 0; p < n; ++p) {
      for (Eigen::Index q = p + 1; q < n; ++q) {
        if (negligible(a(p, q), a(p, p), a(q, q), scale)) continue;
        rotate(a, axes, p, q);
        done = false;
      }
    }
    if (done) return;
  }
}

}  // namespace cylon::engine
