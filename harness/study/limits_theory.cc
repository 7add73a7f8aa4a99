#include "harness/study/limits_theory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <span>
#include <vector>

namespace cylon::study {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// ---- Explicit Runge-Kutta: R(z) = sum c_k z^k --------------------------------------------------------
// p = s = 1 and 4: c_k = 1/k! (Hairer, Wanner, Solving ODEs II, IV.2).
struct Polynomial {
  std::string_view integrator;
  std::array<double, 5> c;
};
constexpr std::array polynomials = {
    Polynomial{"explicit-euler", {1, 1, 0, 0, 0}},
    Polynomial{"rk4", {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24}},
};

// ---- Splittings: kicks v -= b h x and drifts x += a h v, by turns -------------------------------------
// Half of a palindrome, middle last; `kick`: the first part is one.
struct Splitting {
  std::string_view integrator;
  bool kick;
  std::vector<double> half;
  bool palindrome = true;
};

// Velocity Verlet over the weights of a composition, kicks that meet made one.
std::vector<double> verlets(std::initializer_list<double> half_weights) {
  std::vector<double> w(half_weights);
  for (std::size_t i = w.size() - 1; i-- > 0;) w.push_back(w[i]);
  std::vector<double> parts(2 * w.size() + 1, 0.0);
  for (std::size_t i = 0; i < w.size(); ++i)
    parts[2 * i] += w[i] / 2, parts[2 * i + 1] = w[i], parts[2 * i + 2] += w[i] / 2;
  return parts;
}

const std::vector<Splitting>& splittings() {
  static const std::vector<Splitting> table = {
      {"lie-trotter", true, {1, 1}, false},
      {"semi-implicit-euler", true, {1, 1}, false},
      {"velocity-verlet", true, {0.5, 1}},
      {"stormer-verlet", false, {0.5, 1}},
      // H. Yoshida, Phys. Lett. A 150 (1990) 262, eq. 2.11 and solution A of table 1.
      {"yoshida4", true, verlets({1.3512071919596578, -1.7024143839193153}), false},
      {"yoshida6", true,
       verlets({0.7845136104775573, 0.2355732133593581, -1.177679984178871, 1.3151863206839112}), false},
      // S. Blanes, P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313: S6, order 4, of table 2; SRKN 6b of 3.
      {"bm4",
       false,
       {0.07920369643119569, 0.209515106613362, 0.353172906049774, -0.143851773179818, -0.0420650803577195,
        0.434336666566456, 0.2193769557534998}},
      {"rkn4",
       true,
       {0.0829844064174052, 0.245298957184271, 0.396309801498368, 0.604872665711080, -0.0390563049223486,
        -0.350171622895351, 0.1195241940131508}},
  };
  return table;
}

Matrix2d power_series(const std::array<double, 5>& c, double h) {
  Matrix2d a;
  a << 0, h, -h, 0;
  Matrix2d sum = Matrix2d::Zero(), power = Matrix2d::Identity();
  for (const double ck : c) {
    sum += ck * power;
    power = power * a;
  }
  return sum;
}

Matrix2d product(const Splitting& s, double h) {
  std::vector<double> parts = s.half;
  if (s.palindrome)
    for (std::size_t i = s.half.size() - 1; i-- > 0;) parts.push_back(s.half[i]);
  Matrix2d m = Matrix2d::Identity();
  bool kick = s.kick;
  for (const double part : parts) {
    Matrix2d step = Matrix2d::Identity();
    (kick ? step(1, 0) : step(0, 1)) = kick ? -part * h : part * h;
    m = step * m;
    kick = !kick;
  }
  return m;
}

// The largest modulus of an eigenvalue: of l^2 - t l + d = 0.
double radius(const Matrix2d& m) {
  const std::complex<double> t = m.trace(), root = std::sqrt(t * t - 4.0 * m.determinant());
  return std::max(std::abs(t + root), std::abs(t - root)) / 2;
}

// The last value before `grows` is first true, over (0, 100] in steps of 1/1000, bisected.
std::optional<double> first(const std::function<bool(double)>& grows) {
  constexpr double step = 1e-3;
  if (grows(step)) return 0;
  for (int i = 1; i <= 100000; ++i) {
    double low = (i - 1) * step, high = i * step;
    if (!grows(high)) continue;
    while (high - low > 1e-12) (grows((low + high) / 2) ? high : low) = (low + high) / 2;
    return low;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<StepMatrix> step_matrix(std::string_view integrator) {
  for (const Polynomial& p : polynomials)
    if (p.integrator == integrator) return [&p](double h) { return power_series(p.c, h); };
  for (const Splitting& s : splittings())
    if (s.integrator == integrator) return [&s](double h) { return product(s, h); };
  return std::nullopt;
}

std::optional<double> stable_oscillation(std::string_view integrator) {
  const auto matrix = step_matrix(integrator);
  if (!matrix) return std::nullopt;
  constexpr double rounding = 1e-12;
  return first([&](double h) { return radius((*matrix)(h)) > 1 + rounding; });
}

std::optional<double> stable_damping(std::string_view integrator) {
  if (integrator == "semi-implicit-euler") return 2;  // the drag is a force before the step: v' = (1 - x) v
  for (const Polynomial& p : polynomials)
    if (p.integrator == integrator)
      return first([&](double x) {
        double r = 0;
        for (std::size_t k = p.c.size(); k-- > 0;) r = r * -x + p.c[k];
        return std::abs(r) > 1 + 1e-12;
      });
  return std::nullopt;
}

std::optional<double> steps_until(std::string_view integrator, double h, double distance) {
  const auto matrix = step_matrix(integrator);
  if (!matrix) return std::nullopt;
  const Matrix2d m = (*matrix)(h);
  Vector2d made(1, 0);
  for (int n = 1; n <= 10'000'000; ++n) {
    made = m * made;
    const Vector2d exact(std::cos(n * h), -std::sin(n * h));
    if ((made - exact).norm() > distance) return n - 1;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace cylon::study
