// Plane orbit about a pin on a spring with a rest length.  With k = stiffness/mass, l = |d x v|, d from the
// pin:
//
//     (r r')^2 = f(r) = r^2 (2 E - k (r - L)^2) - l^2 = k (r - r1)(r2 - r) Q(r)
//     Q(r) = r^2 + (r1 + r2 - 2 L) r + l^2/(k r1 r2)
//     r = (r1 + r2)/2 - (r2 - r1)/2 cos(phi),  dt/dphi = r/sqrt(k Q),  dtheta/dphi = l/(r sqrt(k Q))
//
// Both rates are even, analytic and periodic in phi: cosine series, found by the trapezoidal rule to the last
// digit and integrated term by term; t(phi) is inverted by Newton's method.
// Domain: each body on one undamped spring from its centre to the world, no gravity, l > 0 (a circle
// included).
#include "reference/exact/domain.h"
#include "reference/exact/flight.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"
#include "reference/exact/turning.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace cylon::exact {
namespace {

constexpr auto name = "spring_orbit";
constexpr Wide pi = std::numbers::pi_v<Wide>;

// a_0 + 2 sum a_k cos(k x), and its integral from 0.
struct CosineSeries {
  std::vector<Wide> a;

  // Clenshaw: sum_{k>0} b_k sin(k x) with b_k = 2 a_k/k, and the mean's part.
  Wide integral(Wide x) const {
    const Wide twice_cos = 2 * std::cos(x);
    Wide next = 0, here = 0;
    for (std::size_t k = a.size(); k-- > 1;) {
      const Wide sum = 2 * a[k] / static_cast<Wide>(k) + twice_cos * here - next;
      next = here;
      here = sum;
    }
    return a[0] * x + here * std::sin(x);
  }
};

class Orbit {
 public:
  Orbit(const core::Scene& scene, std::size_t index)
      : flight_(scene.bodies[index].initial, core::Vector3::Zero()) {
    for (const core::Force& force : scene.forces) {
      const auto* spring = std::get_if<core::Spring>(&force);
      if (!spring || spring->body != static_cast<int>(index)) continue;
      pin_ = widen(spring->to_anchor);
      rest_ = spring->rest_length;
      k_ = Wide(spring->stiffness) / Wide(scene.bodies[index].mass);
    }
    const WideVector d = flight_.position - pin_, turning = d.cross(flight_.velocity);
    l_ = turning.norm();
    start_ = d.norm();
    outward_ = d / start_;
    forward_ = turning.cross(d).normalized();
    find_turning_points(d.dot(flight_.velocity));
    find_series();
    phase_ = time_.integral(start_phi_);
    angle_ = theta_.integral(start_phi_);
  }

  bool converged() const { return converged_; }

  WideState at(Wide t) const {
    // Whole revolutions of phi taken out; what remains is solved to the last digit.
    const Wide mean = time_.a[0], goal = t + phase_, turns = std::floor(goal / (2 * pi * mean));
    const Wide rest = goal - turns * 2 * pi * mean;
    Wide phi = rest / mean, low = 0, high = 2 * pi;
    for (int i = 0; i < 60; ++i) {
      const Wide excess = time_.integral(phi) - rest;
      (excess > 0 ? high : low) = phi;
      Wide next = phi - excess / time_rate(phi);
      if (!(low <= next && next <= high)) next = (low + high) / 2;
      const bool done = std::abs(next - phi) < 4e-19L * (1 + phi);
      phi = next;
      if (done) break;
    }
    const Wide theta = theta_.integral(phi) + turns * 2 * pi * theta_.a[0] - angle_;
    const Wide r = radius(phi), radial = amplitude_ * std::sin(phi) / time_rate(phi), swing = l_ / r;
    const WideVector e = outward_ * std::cos(theta) + forward_ * std::sin(theta);
    const WideVector across = forward_ * std::cos(theta) - outward_ * std::sin(theta);
    WideState s = flight_.at(t);
    s.position = pin_ + r * e;
    s.velocity = radial * e + swing * across;
    return s;
  }

 private:
  static constexpr std::size_t most = 4096;  // samples of half a period: passes as near as r1/r2 = 1e-4

  // f about r0, its terms written with v^2 = 2 E - k (r0 - L)^2.
  void find_turning_points(Wide rv) {
    const Wide r = start_, stretch = r - rest_, v2 = flight_.velocity.squaredNorm();
    const std::array<Wide, 5> f = {rv * rv, 2 * r * v2 - 2 * k_ * stretch * r * r,
                                   v2 - 4 * k_ * stretch * r - k_ * r * r, -2 * k_ * stretch - 2 * k_ * r,
                                   -k_};
    const Wide widest = rest_ + std::sqrt(v2 / k_ + stretch * stretch);  // f(widest) = -l^2
    const auto [down, up] = turning_points(f, -r, std::max<Wide>(0, widest - r));
    middle_ = r + (down + up) / 2;
    amplitude_ = (up - down) / 2;
    const Wide r1 = r + down, r2 = r + up;
    slope_ = r1 + r2 - 2 * rest_;
    constant_ = l_ * l_ / (k_ * r1 * r2);
    // tan^2(phi/2) = (r0 - r1)/(r2 - r0)
    start_phi_ = amplitude_ == 0 ? 0 : std::copysign(2 * std::atan2(std::sqrt(-down), std::sqrt(up)), rv);
  }

  // a_k = mean of f(phi_j) cos(k phi_j), doubling the samples until the last harmonics vanish.
  void find_series() {
    for (std::size_t n = 32; n <= most && !converged_; n *= 2) {
      std::vector<Wide> cosine(2 * n), time(n + 1), theta(n + 1);
      for (std::size_t j = 0; j < 2 * n; ++j)
        cosine[j] = std::cos(pi * static_cast<Wide>(j) / static_cast<Wide>(n));
      for (std::size_t j = 0; j <= n; ++j) {
        const Wide phi = pi * static_cast<Wide>(j) / static_cast<Wide>(n), r = radius(phi);
        time[j] = time_rate(phi);
        theta[j] = l_ / (r * r) * time[j];
      }
      const auto series = [&](const std::vector<Wide>& values) {
        CosineSeries s;
        for (std::size_t k = 0; k <= n / 2; ++k) {
          Wide sum = (values[0] + values[n] * cosine[k * n % (2 * n)]) / 2;
          for (std::size_t j = 1; j < n; ++j) sum += values[j] * cosine[k * j % (2 * n)];
          s.a.push_back(sum / static_cast<Wide>(n));
          if (k > 3 && std::abs(s.a[k]) + std::abs(s.a[k - 1]) + std::abs(s.a[k - 2]) < 1e-19L * s.a[0]) {
            converged_ = true;
            break;
          }
          converged_ = false;
        }
        return s;
      };
      time_ = series(time);
      const bool time_converged = converged_;
      theta_ = series(theta);
      converged_ = converged_ && time_converged;
    }
  }

  Wide radius(Wide phi) const { return middle_ - amplitude_ * std::cos(phi); }

  Wide time_rate(Wide phi) const {
    const Wide r = radius(phi);
    return r / std::sqrt(k_ * ((r + slope_) * r + constant_));
  }

  Flight flight_;
  WideVector pin_, outward_, forward_;
  Wide rest_ = 0, k_ = 0, l_ = 0, start_ = 0;
  Wide middle_ = 0, amplitude_ = 0, slope_ = 0, constant_ = 0,
       start_phi_ = 0;  // Q = r^2 + slope r + constant
  CosineSeries time_, theta_;
  Wide phase_ = 0, angle_ = 0;
  bool converged_ = false;
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<Orbit> orbits;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) orbits.emplace_back(scene, i);
  return together(std::move(orbits));
}

void check_orbits(const core::Scene& scene) {
  std::vector<int> springs(scene.bodies.size(), 0);
  for (const core::Force& force : scene.forces) {
    const auto* spring = std::get_if<core::Spring>(&force);
    if (!spring) continue;
    const core::BodyState& s = scene.bodies[static_cast<std::size_t>(spring->body)].initial;
    if (++springs[static_cast<std::size_t>(spring->body)] > 1)
      refuse(name, named(scene, spring->body) + " has two springs");
    const core::Vector3 d = s.position - spring->to_anchor;
    if (d.cross(s.velocity).norm() <= 1e-9 * d.norm() * s.velocity.norm()) {
      refuse(name, named(scene, spring->body) + " moves through the pin of its spring or rests");
    }
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!Orbit(scene, i).converged()) {
      refuse(name, named(scene, static_cast<int>(i)) + " passes too near the pin of its spring");
    }
  }
}

}  // namespace

core::Truth spring_orbit(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity", "spring"});
  check_falls_alike(name, scene);
  check_springs(name, scene);
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  if (!common_gravity(scene).isZero(0.0)) refuse(name, "the scene has gravity");
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) check_steady_spin(name, scene, i, horizon);
  check_orbits(scene);
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = "Landau & Lifshitz, Mechanics, section 14: motion in a central field, by quadrature",
          .horizon = horizon};
}

}  // namespace cylon::exact
