#include "engine/free_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cylon::engine {

namespace {

using Rotation = Eigen::Quaternion<double, Eigen::DontAlign>;
using Vector = Eigen::Vector3d;

Rotation in_double(const Quaternion& q) { return q.cast<double>(); }

// cos and sin of an angle; below 1/2 by their series, whose first term left out is 1e-18.
struct Turn {
  double cosine = 1, sine;
  explicit Turn(double x) : sine(x) {
    const double xx = x * x;
    if (xx < 0.25) {
      cosine = 1 - xx / 2 * (1 - xx / 12 * (1 - xx / 30 * (1 - xx / 56 * (1 - xx / 90 * (1 - xx / 132)))));
      sine =
          x * (1 - xx / 6 * (1 - xx / 20 * (1 - xx / 42 * (1 - xx / 72 * (1 - xx / 110 * (1 - xx / 156))))));
    } else {
      cosine = std::cos(x), sine = std::sin(x);
    }
  }
};

Rotation about(int axis, double angle) {
  const Turn half(angle / 2);
  Rotation q(half.cosine, 0, 0, 0);
  q.vec()[axis] = half.sine;
  return q;
}

// The frame whose third axis is along l and whose first is the part of axis p across it.
Eigen::Matrix3d frame(const Vector& l, int p) {
  Eigen::Matrix3d f;
  const Vector z = l.normalized();
  Vector x = -z[p] * z;
  x[p] += 1;
  f.col(0) = x.normalized();
  f.col(1) = z.cross(f.col(0));
  f.col(2) = z;
  return f;
}

Quaternion result(const Rotation& q) { return q.normalized().cast<Real>(); }

// ---- The short step.

// Gauss-Legendre on [0, 1].
template <int M>
struct Nodes;
template <>
struct Nodes<4> {
  static constexpr std::array<double, 4> at = {0.069431844202973712388, 0.3300094782075718676,
                                               0.6699905217924281324, 0.93056815579702628761};
  static constexpr std::array<double, 4> weight = {0.17392742256872692869, 0.32607257743127307131,
                                                   0.32607257743127307131, 0.17392742256872692869};
};
template <>
struct Nodes<6> {
  static constexpr std::array<double, 6> at = {0.033765242898423986094, 0.16939530676686774317,
                                               0.38069040695840154568,  0.61930959304159845432,
                                               0.83060469323313225683,  0.96623475710157601391};
  static constexpr std::array<double, 6> weight = {0.08566224618958517252, 0.18038078652406930378,
                                                   0.23395696728634552369, 0.23395696728634552369,
                                                   0.18038078652406930378, 0.08566224618958517252};
};
template <>
struct Nodes<8> {
  static constexpr std::array<double, 8> at = {
      0.019855071751231884158, 0.1016667612931866302,  0.23723379504183550709, 0.40828267875217509753,
      0.59171732124782490247,  0.76276620495816449291, 0.8983332387068133698,  0.98014492824876811584};
  static constexpr std::array<double, 8> weight = {
      0.050614268145188129576, 0.11119051722668723527, 0.15685332293894364367, 0.18134189168918099148,
      0.18134189168918099148,  0.15685332293894364367, 0.11119051722668723527, 0.050614268145188129576};
};

// One more coefficient of the series of l' = l x (X l); d holds h (x_{i+2} - x_{i+1}).  Written out: as a
// loop it would be vectorised along m, across what was just stored.
template <int n, int N>
inline void extend(double (&a)[N + 1][3], const double (&d)[3]) {
  double even[3] = {}, odd[3] = {};  // two chains of additions
  [&]<int... m>(std::integer_sequence<int, m...>) {
    const auto add = [&](double(&sum)[3], int k) {
      sum[0] += a[k][1] * a[n - k][2];
      sum[1] += a[k][2] * a[n - k][0];
      sum[2] += a[k][0] * a[n - k][1];
    };
    (add(m % 2 == 0 ? even : odd, m), ...);
  }
  (std::make_integer_sequence<int, n + 1>{});
  for (int i = 0; i < 3; ++i) a[n + 1][i] = (1.0 / (n + 1)) * d[i] * (even[i] + odd[i]);
}

// The turn of the principal axes over h, seen from where they start; not of unit length.  l by its Taylor
// series to order N, coefficients with h^n in them; phi by Gauss quadrature on M nodes about the principal
// axis p on which l is least, so that G^2 - l_p^2 >= 2/3 G^2:
//   phi = h G int_0^1 x_p + (2 H - x_p G^2)/(G^2 - l_p^2) ds
// The turn is phi about l after the one that carries e = l(h) to l and keeps e_p in the same half plane: the
// shortest turn from e to l, (G^2 + l.e, e x l), and after it the angle chi about l by which it misses e_p.
// Of the spherical triangle l, e, e_p, chi is pi less the angles at l and e; by Napier's analogies
//   tan chi/2 = (l_p + e_p)(e x l)_p G / ((G^2 + l_p e_p + S)(l.e - l_p e_p + S)),
//   S^2 = (G^2 - l_p^2)(G^2 - e_p^2)
template <int N, int M>
Rotation short_turn(const Vector& x, const Vector& l, double h) {
  double a[N + 1][3];
  for (int i = 0; i < 3; ++i) a[0][i] = l[i];
  const double d[3] = {h * (x[2] - x[1]), h * (x[0] - x[2]), h * (x[1] - x[0])};
  [&]<int... n>(std::integer_sequence<int, n...>) { (extend<n, N>(a, d), ...); }
  (std::make_integer_sequence<int, N>{});
  Vector change;  // e - l
  for (int i = 0; i < 3; ++i) {
    change[i] = a[N][i];
    for (int n = N - 1; n > 0; --n) change[i] += a[n][i];
  }
  const Vector e = l + change;

  int p = 0;
  for (int i = 1; i < 3; ++i) p = std::abs(l[i]) < std::abs(l[p]) ? i : p;
  const int q = (p + 1) % 3, r = (p + 2) % 3;
  const double gg = l.squaredNorm();
  const double excess = (x[q] - x[p]) * l[q] * l[q] + (x[r] - x[p]) * l[r] * l[r];
  double mean = 0;
  [&]<std::size_t... m>(std::index_sequence<m...>) {
    double value[] = {(static_cast<void>(m), a[N][p])...};
    for (int n = N; n-- > 0;) ((value[m] = value[m] * Nodes<M>::at[m] + a[n][p]), ...);
    ((mean += Nodes<M>::weight[m] / (gg - value[m] * value[m])), ...);
  }
  (std::make_index_sequence<M>{});
  const double g = std::sqrt(gg), phi = h * g * (x[p] + excess * mean);

  const double le = l.dot(e), lp = l[p], ep = e[p];
  const double s = std::sqrt((gg - lp * lp) * (gg - ep * ep));
  const double chi_cosine = (gg + lp * ep + s) * (le - lp * ep + s);
  const double chi_sine = (lp + ep) * (l[r] * change[q] - l[q] * change[r]);  // over g
  const Turn half(phi / 2);
  const double cosine = half.cosine * chi_cosine - half.sine * chi_sine * g;
  const double sine = half.sine * chi_cosine + half.cosine * chi_sine * g;
  Rotation about_l(g * cosine, 0, 0, 0), shortest(gg + le, 0, 0, 0);
  about_l.vec() = sine * l;
  shortest.vec() = change.cross(l);
  return about_l * shortest;
}

}  // namespace

Quaternion asymmetric_free_flow(const Body& body, const Quaternion& orientation,
                                const Vector3& angular_momentum, Real h) {
  const Rotation start = in_double(orientation), axes = in_double(body.principal_axes);
  Vector x = body.inverse_moments.cast<double>();
  Vector l = axes.conjugate() * (start.conjugate() * angular_momentum.cast<double>());
  // The turn below goes as |l|^7, and its square would underflow: l/2^n and 2^n X turn alike, to the last bit.
  if (const double size = l.norm(); size > 0 && std::isfinite(size)) {
    const int n = std::ilogb(size);
    l *= std::scalbn(1, -n), x *= std::scalbn(1, n);
  }

  // The nearest pole of l lies at least pi/(2 G spread) away in the complex plane, so that the terms of the
  // series fall as reach^n; each row keeps what is above 1e-17.
  const double spread = x.maxCoeff() - x.minCoeff();
  const double reach = std::abs(h) * l.norm() * spread * (2 / 3.14159265358979323846);
  if (reach == 0) return turned(orientation, h * body.inverse_moments[1] * angular_momentum);
  // To first order where the next one is below rounding: powers of what is smaller by far would underflow.
  if (reach < 1e-17) {
    const Vector turn = start * (axes * x.cwiseProduct(l));
    return turned(orientation, (h * turn).cast<Real>());
  }
  Rotation turn;
  if (reach < 1.4e-3)
    turn = short_turn<5, 4>(x, l, h);
  else if (reach < 0.0128)
    turn = short_turn<8, 4>(x, l, h);
  else if (reach < 0.049)
    turn = short_turn<12, 6>(x, l, h);
  else if (reach < 0.124)
    turn = short_turn<18, 8>(x, l, h);
  else
    return FreeRotation(body, orientation, angular_momentum).at(h);
  Rotation in_body(turn.w(), 0, 0, 0);
  in_body.vec() = axes * turn.vec();
  return result(start * in_body);
}

FreeRotation::FreeRotation(const Body& body, const Quaternion& orientation, const Vector3& angular_momentum)
    : start_(in_double(orientation).normalized() * in_double(body.principal_axes)),
      to_body_(in_double(body.principal_axes).conjugate()),
      l_(start_.conjugate() * angular_momentum.cast<double>()),
      magnitude_(l_.norm()) {
  const Vector3& x = body.inverse_moments;
  const bool low = same_moment(x[0], x[1]), high = same_moment(x[2], x[1]);
  if (low || high || magnitude_ == 0) {
    axis_ = low ? 2 : 0;
    precession_ = magnitude_ * static_cast<double>(x[1]);
    spin_ = low && high ? 0 : (static_cast<double>(x[axis_]) - static_cast<double>(x[1])) * l_[axis_];
  } else {
    set_up_asymmetric(x.cast<double>());
  }
}

void FreeRotation::set_up_asymmetric(const Vector& x) {
  asymmetric_ = true;
  std::array<int, 3> order = {0, 1, 2};  // x descending
  std::sort(order.begin(), order.end(), [&](int a, int b) { return x[a] > x[b]; });
  i_ = order[0], j_ = order[1], k_ = order[2];
  if ((x[i_] - x[j_]) * l_[i_] * l_[i_] >= (x[j_] - x[k_]) * l_[k_] * l_[k_]) std::swap(i_, k_);
  const double xij = x[i_] - x[j_], xik = x[i_] - x[k_], xjk = x[j_] - x[k_];
  const double li = l_[i_] * l_[i_], lj = l_[j_] * l_[j_], lk = l_[k_] * l_[k_];
  const double aai = li + lj * (xjk / xik), aaj = aai * (xik / xjk), aak = lk + lj * (xij / xik);
  const double sign = std::copysign(1.0, l_[k_]);
  const bool even = (j_ - i_ + 3) % 3 == 1;
  amplitude_[i_] = std::sqrt(aai);
  amplitude_[j_] = sign * (even == (xik > 0) ? 1 : -1) * std::sqrt(aaj);
  amplitude_[k_] = sign * std::sqrt(aak);
  // 1 - k^2, what the least l_k^2 is of the largest
  jacobi_ = Jacobi((lk - li * (xij / xjk)) / aak);
  lambda_ = std::sqrt(aak * (xik * xjk));

  pole_ = aai >= aak ? k_ : i_;
  if (pole_ == k_) {
    n_ = -xij / xjk;
    steady_ = magnitude_ * x[i_];
    swing_ = -magnitude_ * xij * (xik / xjk) / lambda_;
  } else {
    n_ = -aai / aak;
    steady_ = magnitude_ * x[k_];
    swing_ = magnitude_ * xik * (aai / aak) / lambda_;
  }
  const double kk = jacobi_.complement();
  half_turn_ = carlson_rj(0, kk, 1, 1 - n_) / 3;

  // u_0 and J(u_0), from |u| <= K: half a turn more where cn < 0
  JacobiValues at{0, 1, 1};
  if (aai > 0) {
    const double norm = std::hypot(l_[i_] / amplitude_[i_], l_[j_] / amplitude_[j_]);
    at.sn = l_[j_] / amplitude_[j_] / norm;
    at.cn = l_[i_] / amplitude_[i_] / norm;
  }
  at.dn = std::sqrt(at.cn * at.cn + kk * at.sn * at.sn);
  const bool behind = at.cn < 0;
  if (behind) at.sn = -at.sn, at.cn = -at.cn;
  u_ = at.sn * carlson_rf(at.cn * at.cn, at.dn * at.dn, 1);
  phase_ = phase_integral(at);
  if (behind) u_ += 2 * jacobi_.quarter_period(), phase_ += 2 * half_turn_;
  start_ = start_ * Rotation(frame(l_, pole_));
}

double FreeRotation::phase_integral(const JacobiValues& v) const {
  const double ss = v.sn * v.sn;
  return ss * v.sn / 3 * carlson_rj(v.cn * v.cn, v.dn * v.dn, 1, 1 - n_ * ss);
}

Quaternion FreeRotation::at(Time t) const {
  if (!asymmetric_) {
    Rotation about_l(1, 0, 0, 0);
    if (magnitude_ > 0) {
      const Turn half(t * precession_ / 2);
      about_l.w() = half.cosine;
      about_l.vec() = half.sine / magnitude_ * l_;
    }
    return result(start_ * about_l * about(axis_, t * spin_) * to_body_);
  }
  const double u = u_ + lambda_ * t, period = 2 * jacobi_.quarter_period();
  const double turns = std::nearbyint(u / period);
  const double sign = std::fmod(turns, 2) == 0 ? 1 : -1;
  const JacobiValues v = jacobi_(u - turns * period);
  Vector l;
  l[i_] = amplitude_[i_] * sign * v.cn;
  l[j_] = amplitude_[j_] * sign * v.sn;
  l[k_] = amplitude_[k_] * v.dn;
  const double phi = steady_ * t + swing_ * (phase_integral(v) + 2 * turns * half_turn_ - phase_);
  return result(start_ * about(2, phi) * Rotation(frame(l, pole_)).conjugate() * to_body_);
}

}  // namespace cylon::engine
