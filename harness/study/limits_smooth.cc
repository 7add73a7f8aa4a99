// Limit families without contact: springs, dampers, spin, and positions far from the origin.
#include "harness/study/limits_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace cylon::study {
namespace {

using core::BodyState;
using core::Recording;
using core::Scene;
using core::Vector3;

constexpr double any_number = 1e300;
constexpr double oscillates =
    1e9;  // of amplitudes of 1 m and below: an engine may stop growth at its own bound

// Largest energy in the last quarter of a run over that in the first: an integrator that is stable turns
// within a few steps through all that its invariant ellipse holds, so the two agree; one that is not grows.
std::optional<std::string> grown(const Recording& r,
                                 const std::function<double(const core::State&)>& energy) {
  double early = 0, late = 0;
  const std::size_t quarter = r.states.size() / 4;
  for (std::size_t i = 0; i < quarter; ++i) early = std::max(early, energy(r.states[i]));
  for (std::size_t i = r.states.size() - quarter; i < r.states.size(); ++i)
    late = std::max(late, energy(r.states[i]));
  constexpr double band = 1.05;
  if (late <= band * early) return std::nullopt;
  return fmt::format("energy grew by a factor of {:.2g} in {} steps", late / early, r.steps.back());
}

Probed judged(const Recording& r, const std::function<double(const core::State&)>& energy) {
  if (const auto what = nonsense(r, oscillates)) return broken(*what);
  if (const auto what = grown(r, energy)) return broken(*what);
  return {};
}

constexpr std::int64_t oscillation_steps = 2000;

}  // namespace

// m = k = 1, so that w = 1 and dt is the parameter.
Probed spring_probe(const Runner& run, double w_dt) {
  Scene scene = lone_ball({0.6, -0.3, 0.2}, {0.5, 0.4, -0.7});
  scene.forces.emplace_back(core::Spring{0, Vector3::Zero(), core::world, Vector3::Zero(), 1, 0, 0});
  return judged(run(scene, w_dt, oscillation_steps, 1), [](const core::State& s) {
    return (s[0].velocity.squaredNorm() + s[0].position.squaredNorm()) / 2;
  });
}

// Two equal bodies on a spring of 1 m: w^2 = 2 k/m.  A small amplitude, so that it stays linear where
// a stable integrator's ellipse is long.
Probed stiffness_probe(const Runner& run, double k_dt2_over_m) {
  constexpr double amplitude = 1e-3, rest = 1;
  Scene scene = lone_ball({-rest / 2 - amplitude / 2, 0, 0}, Vector3::Zero());
  scene.bodies.push_back(lone_ball({rest / 2 + amplitude / 2, 0, 0}, Vector3::Zero()).bodies[0]);
  scene.bodies[1].name = "other";
  scene.forces.emplace_back(core::Spring{0, Vector3::Zero(), 1, Vector3::Zero(), 1, rest, 0});
  return judged(run(scene, std::sqrt(k_dt2_over_m), oscillation_steps, 1), [](const core::State& s) {
    const double stretch = (s[1].position - s[0].position).norm() - rest;
    return (s[0].velocity.squaredNorm() + s[1].velocity.squaredNorm() + stretch * stretch) / 2;
  });
}

// m = c = 1.
Probed damping_probe(const Runner& run, double c_dt_over_m) {
  Scene scene = lone_ball(Vector3::Zero(), {0.6, -0.3, 0.2});
  scene.forces.emplace_back(core::Drag{0, 1, 0, 0});
  const Recording r = run(scene, c_dt_over_m, oscillation_steps, 1);
  if (const auto what = nonsense(r, any_number)) return broken(*what);
  const double start = r.states.front()[0].velocity.norm(), end = r.states.back()[0].velocity.norm();
  if (end <= start) return {};
  return broken(fmt::format("speed grew by a factor of {:.2g} in {} steps", end / start, r.steps.back()));
}

// A circle about the pin at w dt = 0.1, until the place is half a radius off.
Probed spring_run_probe(const Runner& run, double steps) {
  constexpr double w_dt = 0.1, bound = 0.5;
  Scene scene = lone_ball({1, 0, 0}, {0, 1, 0});
  scene.forces.emplace_back(core::Spring{0, Vector3::Zero(), core::world, Vector3::Zero(), 1, 0, 0});
  const Recording r = run(scene, w_dt, static_cast<std::int64_t>(steps), 1);
  if (const auto what = nonsense(r, any_number)) return broken(*what);
  for (std::size_t i = 0; i < r.states.size(); ++i) {
    const double t = r.time(i);
    const double off = (r.states[i][0].position - Vector3(std::cos(t), std::sin(t), 0)).norm();
    if (off > bound) return broken(fmt::format("error of {:.2f} radii at step {}", off, r.steps[i]));
  }
  return {};
}

// One step about a fixed axis.
Probed turn_probe(const Runner& run, double turn) {
  constexpr double dt = 1.0 / 60, part = 0.01;
  const Vector3 axis = Vector3(0.6, 0, -0.8);
  const Recording r = run(lone_ball(Vector3::Zero(), Vector3::Zero(), turn / dt * axis), dt, 1, 1);
  if (const auto what = nonsense(r, any_number)) return broken(*what);
  const core::Quaternion exact(Eigen::AngleAxisd(turn, axis));
  const double off = r.states.back()[0].orientation.angularDistance(exact);
  const double kept = r.states.back()[0].angular_velocity.norm() * dt / turn;
  if (std::abs(kept - 1) > part) return broken(fmt::format("clamp: only {:.3g} of the spin remains", kept));
  if (off > part * std::min(turn, 1.0)) return broken(fmt::format("turns {:.2g} rad wrong", off));
  return {};
}

// Twenty radians of a tumbling brick.
Probed tumble_probe(const Runner& run, double turn) {
  constexpr double radians = 20, part = 0.05;
  const Vector3 moments(0.4, 0.68, 0.9), w = Vector3(1.3, 2.1, -3.2).normalized();
  Scene scene = lone_ball(Vector3::Zero(), Vector3::Zero(), w);
  scene.bodies[0].shape = std::monostate();
  scene.bodies[0].inertia = moments.asDiagonal();
  const auto steps = static_cast<std::int64_t>(std::ceil(radians / turn));
  const Recording r = run(scene, turn, steps, std::max<std::int64_t>(1, steps / 500));
  if (const auto what = nonsense(r, any_number)) return broken(*what);
  const double energy0 = w.dot(moments.cwiseProduct(w)) / 2, spin0 = moments.cwiseProduct(w).norm();
  for (std::size_t i = 0; i < r.states.size(); ++i) {
    const BodyState& s = r.states[i][0];
    const Vector3 l = core::world_inertia(scene.bodies[0], s.orientation) * s.angular_velocity;
    const double energy = s.angular_velocity.dot(l) / 2 / energy0;
    const double spin = (l - moments.cwiseProduct(w)).norm() / spin0;
    if (std::abs(energy - 1) > part)
      return broken(fmt::format("energy is {:.2f} of its initial value at step {}", energy, r.steps[i]));
    if (spin > part) return broken(fmt::format("angular momentum error {:.2g} at step {}", spin, r.steps[i]));
  }
  return {};
}

// The orbit on a spring, far away and at the origin.
Probed origin_probe(const Runner& run, double distance) {
  constexpr double dt = 1.0 / 64, part = 0.01;
  const auto orbit = [&](double x) {
    const Vector3 pin(x, 0, x);
    Scene scene = lone_ball(pin + Vector3(1.5, 0, 0), {0, 3, 0});
    scene.forces.emplace_back(core::Spring{0, Vector3::Zero(), core::world, pin, 10, 1, 0});
    Recording r = run(scene, dt, 256, 1);
    for (core::State& s : r.states) s[0].position -= pin;
    return r;
  };
  const Recording far = orbit(distance), near = orbit(0);
  if (const auto what = nonsense(far, any_number)) return broken(*what);
  for (std::size_t i = 0; i < far.states.size(); ++i) {
    const double off = (far.states[i][0].position - near.states[i][0].position).norm();
    if (off > part * 1.5)
      return broken(fmt::format("{:.2g} m from the orbit at the origin at step {}", off, far.steps[i]));
  }
  return {};
}

}  // namespace cylon::study
