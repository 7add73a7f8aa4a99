#include "harness/study/probes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace cylon::study {
namespace {

using core::BodyState;
using core::Recording;
using core::Scene;
using core::Vector3;

constexpr double g = 9.81;  // [m/s^2]

Scene ball(const Vector3& position, const Vector3& velocity,
           const Vector3& angular_velocity = Vector3::Zero()) {
  Scene scene;
  core::Body body;
  body.name = "ball";
  body.shape = core::Sphere{0.1};
  body.inertia = 0.004 * core::Matrix3::Identity();
  body.initial = {position, core::Quaternion::Identity(), velocity, angular_velocity};
  scene.bodies.push_back(body);
  return scene;
}

Scene over_floor(Scene scene, double restitution, double friction, double gravity) {
  for (core::Body& body : scene.bodies) body.collide = true;
  scene.planes.push_back({"floor", Vector3::UnitY(), 0});
  scene.materials.push_back({{"*", "*"}, restitution, friction});
  if (gravity > 0) scene.forces.emplace_back(core::UniformGravity{{0, -gravity, 0}});
  return scene;
}

const BodyState& end(const Recording& r) { return r.states.back().front(); }

// ---- Free fall ---------------------------------------------------------------------------------------
// n steps of dt: explicit Euler ends g T dt/2 too high, semi-implicit Euler as much too low, k sub-steps a
// k-th of it, integrators of second order and above exactly.
Finding fall(const Runner& run) {
  constexpr double dt = 1.0 / 64, T = 1;
  Scene scene = ball({0, 10, 0}, {0.3, 1.1, -0.4});
  scene.forces.emplace_back(core::UniformGravity{{0, -g, 0}});
  const Recording r = run(scene, dt, 64, 64);
  const double residual = (end(r).position.y() - (10 + 1.1 * T - g * T * T / 2)) / (g * T * dt);
  const std::string evidence = fmt::format("final offset from the parabola: {:+.4f} g T dt", residual);
  if (std::abs(residual) < 1e-3) return {"second order or better", evidence};
  const double k = 1 / (2 * std::abs(residual));
  const std::string integrator = residual > 0 ? "explicit Euler" : "semi-implicit Euler";
  if (std::abs(k - 1) < 0.01) return {integrator, evidence};
  if (k > 1 && std::abs(k - std::round(k)) < 0.02 * k)
    return {fmt::format("{} with {:.0f} sub-steps", integrator, k), evidence};
  return {"first order, not an Euler integrator", evidence};
}

// ---- A spring --------------------------------------------------------------------------------------
// Order from the error at dt, dt/2, dt/4; where energy goes from its largest error in the first and the
// second half: a symplectic integrator keeps it within a band.
Finding spring(const Runner& run) {
  constexpr double k = 100, T = 2;
  const double w = std::sqrt(k);
  const Vector3 x0(0.6, -0.3, 0.2), v0(1, 2, -3);
  Scene scene = ball(x0, v0);
  scene.forces.emplace_back(core::Spring{0, Vector3::Zero(), core::world, Vector3::Zero(), k, 0, 0});
  const double energy0 = v0.squaredNorm() / 2 + k * x0.squaredNorm() / 2;
  std::vector<double> error, early, late;
  double drift = 0;
  for (const int halvings : {0, 1, 2}) {
    const std::int64_t n = std::int64_t{512} << halvings;
    const Recording r = run(scene, T / static_cast<double>(n), n, 1);
    double worst = 0, first = 0, second = 0;
    for (std::size_t i = 0; i < r.states.size(); ++i) {
      const double t = r.time(i);
      const BodyState& s = r.states[i].front();
      worst = std::max(worst, (s.position - (x0 * std::cos(w * t) + v0 / w * std::sin(w * t))).norm());
      const double off = (s.velocity.squaredNorm() + k * s.position.squaredNorm()) / (2 * energy0) - 1;
      double& half = t <= T / 2 ? first : second;
      half = std::max(half, std::abs(off));
      drift = off;
    }
    error.push_back(worst), early.push_back(first), late.push_back(second);
  }
  const double order = std::log2(error[0] / error[2]) / 2;
  const std::string evidence = fmt::format(
      "errors {:.2g}, {:.2g}, {:.2g} m at dt = 1/256, 1/512, 1/1024 s; relative energy error {:.2g} in the "
      "first second, {:.2g} in the second",
      error[0], error[1], error[2], early[0], late[0]);
  const bool rounding = error[2] > error[1] / 1.5 || error[0] < 1e-8;
  if (rounding && error[0] < 1e-3) return {"exact within rounding or tolerance", evidence};
  const std::string energy = late[0] < 1.3 * early[0] ? "energy bounded"
                             : drift > 0              ? "energy grows"
                                                      : "energy decays";
  return {fmt::format("order {:.1f}, {}", order, energy), evidence};
}

// ---- A spinning brick ----------------------------------------------------------------------------------
// Without the gyroscopic torque the angular velocity stays; an explicit one feeds energy, an implicit one
// takes it, both by the first power of the step.
Finding gyroscopic(const Runner& run) {
  const Vector3 moments(0.4, 0.68, 0.9), w0(1.3, 2.1, -3.2);
  Scene scene = ball(Vector3::Zero(), Vector3::Zero(), w0);
  scene.bodies[0].shape = std::monostate();
  scene.bodies[0].inertia = moments.asDiagonal();
  const double energy0 = w0.dot(moments.cwiseProduct(w0)) / 2, spin0 = moments.cwiseProduct(w0).norm();
  std::vector<double> energy, spin;
  double turned = 0;
  for (const std::int64_t n : {480, 960}) {
    const BodyState s = end(run(scene, 2.0 / static_cast<double>(n), n, n));
    const Vector3 l = core::world_inertia(scene.bodies[0], s.orientation) * s.angular_velocity;
    energy.push_back(s.angular_velocity.dot(l) / 2 / energy0 - 1);
    spin.push_back((l - moments.cwiseProduct(w0)).norm() / spin0);
    turned = (s.angular_velocity - w0).norm() / w0.norm();
  }
  const std::string evidence = fmt::format(
      "error after 2 s: energy {:+.2g}, angular momentum {:.2g} at dt = 1/240 s; {:+.2g} and {:.2g} at dt = "
      "1/480 s",
      energy[0], spin[0], energy[1], spin[1]);
  if (turned < 1e-5) return {"off", fmt::format("the angular velocity changes by at most {:.1g}", turned)};
  if (std::abs(energy[0]) < 1e-5 && spin[0] < 1e-5) {
    const double slope = std::log2(spin[0] / spin[1]);
    return {spin[0] < 1e-9 || !(slope > 0.5) ? "on, exact within rounding"
                                             : fmt::format("on, order {:.0f}", slope),
            evidence};
  }
  const double slope = std::log2(std::abs(energy[0] / energy[1]));
  if (std::abs(slope - 1) > 0.25) return {fmt::format("on, order {:.1f} in energy", slope), evidence};
  return {energy[0] > 0 ? "explicit: adds energy" : "implicit: removes energy", evidence};
}

// ---- An elastic bounce -----------------------------------------------------------------------------------
// Speed in the last step before, and in the first after: v' = |v|: the target is the speed before the step's
// gravity; v' = |v| + g dt: after it; energy kept at any fraction of the step: at the impact's own instant.
Finding bounce(const Runner& run) {
  constexpr double dt = 1.0 / 256;
  const Recording r = run(over_floor(ball({0, 1.137, 0}, {0, -0.4, 0}), 1, 0, g), dt, 200, 1);
  for (std::size_t i = 1; i < r.states.size(); ++i) {
    const BodyState &a = r.states[i - 1].front(), &b = r.states[i].front();
    if (!(a.velocity.y() < 0 && b.velocity.y() > 0)) continue;
    const double before = -a.velocity.y(), after = b.velocity.y();
    const double gain = (after - before) / (g * dt);
    const double energy = (after * after - before * before) / 2 + g * (b.position.y() - a.position.y());
    const double scaled = energy / (g * dt * before);
    const std::string evidence = fmt::format(
        "at {:.3f} m/s the speed changes by {:+.3f} g dt over the step, energy by {:+.3f} m g dt v", before,
        gain, scaled);
    if (std::abs(scaled) < 1e-3) return {"speed at the time of impact", evidence};
    if (std::abs(gain) < 0.02) return {"speed before gravity acts in the step", evidence};
    if (std::abs(gain - 1) < 0.02) return {"speed after gravity acts in the step", evidence};
    return {"neither the speed before nor after gravity acts in the step", evidence};
  }
  return {"does not bounce", "the body never moves upward after it moved downward"};
}

// ---- The slowest bounce ----------------------------------------------------------------------------------
// Without gravity a ball drifts onto a wall: v' = e v at any speed.
Finding slow_bounce(const Runner& run) {
  constexpr std::array speeds = {0.01, 0.03, 0.1, 0.3, 1.0, 3.0};
  constexpr double e = 0.8;
  std::vector<std::string> ratios;
  double lost = 0;
  for (const double v : speeds) {
    const Recording r =
        run(over_floor(ball({0, 0.1 + 0.317 * v, 0}, {0, -v, 0}), e, 0, 0), 1.0 / 240, 180, 180);
    const double ratio = end(r).velocity.y() / v;
    ratios.push_back(fmt::format("{:.2f} at {}", ratio, v));
    if (std::abs(ratio - e) > 0.02) lost = v;
  }
  const std::string evidence =
      fmt::format("rebound over approach speed: {} m/s; the scene has {}", fmt::join(ratios, ", "), e);
  if (lost == 0) return {"restitution is applied down to 0.01 m/s", evidence};
  if (lost == speeds.back()) return {"restitution is not applied", evidence};
  return {fmt::format("no restitution at {} m/s and below", lost), evidence};
}

// ---- Friction --------------------------------------------------------------------------------------------
// A flat box slides at 0, 22.5 and 45 degrees: mu g against its motion under Coulomb's cone; up to sqrt(2)
// times that, and sideways, under a pyramid on the axes.
Finding friction(const Runner& run) {
  constexpr double mu = 0.3, v = 2, T = 0.25;
  std::vector<double> along, across;
  for (const double degrees : {0.0, 22.5, 45.0}) {
    const double a = degrees * std::numbers::pi / 180;
    const Vector3 way(std::cos(a), 0, std::sin(a)), side(-std::sin(a), 0, std::cos(a));
    Scene scene = ball({0, 0.05, 0}, v * way);
    scene.bodies[0].shape = core::Box{{0.5, 0.05, 0.5}};
    scene.bodies[0].inertia = Vector3(0.25 + 0.0025, 0.5, 0.25 + 0.0025).asDiagonal() * (1.0 / 3);
    const Vector3 end_velocity = end(run(over_floor(scene, 0, mu, g), 1.0 / 480, 120, 120)).velocity;
    along.push_back((v - end_velocity.dot(way)) / (mu * g * T));
    across.push_back(end_velocity.dot(side) / (mu * g * T));
  }
  const std::string evidence = fmt::format(
      "deceleration {:.3f}, {:.3f}, {:.3f} mu g at 0, 22.5, 45 degrees; sideways {:+.3f} mu g at 22.5 "
      "degrees",
      along[0], along[1], along[2], across[1]);
  const double least = std::min({along[0], along[1], along[2]}),
               most = std::max({along[0], along[1], along[2]});
  if (most < 0.02) return {"none", evidence};
  if (most - least < 0.03 && std::abs(most - 1) < 0.05) return {"Coulomb cone", evidence};
  if (most - least < 0.03) return {"isotropic, but not of Coulomb's magnitude", evidence};
  return {"friction pyramid: depends on the direction", evidence};
}

// ---- Clamps ----------------------------------------------------------------------------------------

Finding speed_limit(const Runner& run) {
  for (const double v : {1e2, 1e3, 1e4, 1e5}) {
    const double kept =
        end(run(ball(Vector3::Zero(), {0.6 * v, 0, -0.8 * v}), 1.0 / 60, 6, 6)).velocity.norm();
    if (std::abs(kept / v - 1) > 1e-3)
      return {fmt::format("{:.4g} m/s", kept), fmt::format("{} m/s becomes {:.4g} in 0.1 s", v, kept)};
  }
  return {"none up to 1e5 m/s", "100, 1e3, 1e4 and 1e5 m/s are kept for 0.1 s"};
}

Finding spin_limit(const Runner& run) {
  for (const double w : {10.0, 1e2, 1e3, 1e4}) {
    const Scene scene = ball(Vector3::Zero(), Vector3::Zero(), {0, 0.6 * w, -0.8 * w});
    const double kept = end(run(scene, 1.0 / 60, 6, 6)).angular_velocity.norm();
    if (std::abs(kept / w - 1) > 1e-3)
      return {fmt::format("{:.4g} rad/s", kept), fmt::format("{} rad/s becomes {:.4g} in 0.1 s", w, kept)};
  }
  return {"none up to 1e4 rad/s", "10, 100, 1e3 and 1e4 rad/s are kept for 0.1 s"};
}

// The turn of one step, which some engines make by a linear or a limited formula.
Finding turn_per_step(const Runner& run) {
  constexpr double dt = 1.0 / 60;
  std::vector<std::string> turns;
  double exact = 0;
  bool all = true;
  for (const double turn : {0.1, 0.3, 1.0, 2.0, 3.0}) {
    const BodyState s = end(run(ball(Vector3::Zero(), Vector3::Zero(), {0, turn / dt, 0}), dt, 1, 1));
    const double made = 2 * std::atan2(s.orientation.vec().norm(), std::abs(s.orientation.w()));
    turns.push_back(fmt::format("{:.4f} for {}", made, turn));
    all = all && std::abs(made - turn) < 1e-4 * turn;
    if (all) exact = turn;
  }
  const std::string evidence = fmt::format("measured angles: {} rad", fmt::join(turns, ", "));
  if (exact == 0) return {"approximate at every angle", evidence};
  return {fmt::format("exact up to {} rad per step", exact), evidence};
}

// ---- What happens when nothing acts ----------------------------------------------------------------

Finding damping(const Runner& run) {
  const BodyState s = end(run(ball(Vector3::Zero(), {0.6, 0, -0.8}, {0.36, -0.48, 0.8}), 1.0 / 64, 64, 64));
  const auto lost = [](double left) { return std::abs(1 - left) < 1e-5 ? 0 : 1 - left; };  // single precision
  const double linear = lost(s.velocity.norm()), angular = lost(s.angular_velocity.norm());
  const std::string evidence =
      fmt::format("decrease in 1 s: {:.2g} of 1 m/s, {:.2g} of 1 rad/s", linear, angular);
  if (linear == 0 && angular == 0) return {"none", evidence};
  return {fmt::format("linear {:.3g}/s, angular {:.3g}/s", linear, angular), evidence};
}

Finding sleeping(const Runner& run) {
  constexpr double v = 1e-3;
  const BodyState s = end(run(ball(Vector3::Zero(), {v, 0, 0}, {0, v, 0}), 1.0 / 60, 600, 600));
  const double way = s.position.x() / (v * 10);
  const std::string evidence =
      fmt::format("a body at 1 mm/s covers {:.4f} of the expected distance in 10 s", way);
  return {std::abs(way - 1) < 1e-2 ? "never" : "slow bodies are stopped", evidence};
}

// Every number that comes back fits a float exactly, or not.
Finding precision(const Runner& run) {
  const Recording r = run(ball({0.1, 0.7, -0.3}, {0.37, 1.3, -2.1}), 0.01, 20, 1);
  int doubles = 0, numbers = 0;
  for (std::size_t i = 1; i < r.states.size(); ++i)
    for (const double x : r.states[i].front().position) {
      ++numbers;
      doubles += static_cast<double>(static_cast<float>(x)) != x;
    }
  return {doubles > 0 ? "double" : "single",
          fmt::format("{} of {} coordinates are not single-precision numbers", doubles, numbers)};
}

constexpr std::array table = {
    Probe{"precision", "floating-point type of the state", precision},
    Probe{"free fall", "integrator, from the position error relative to g T dt/2", fall},
    Probe{"spring", "order of the integrator and trend of the energy", spring},
    Probe{"gyroscopic torque", "whether and how the gyroscopic torque is integrated", gyroscopic},
    Probe{"rotation per step", "largest angle that one step rotates exactly", turn_per_step},
    Probe{"restitution", "approach speed that restitution uses", bounce},
    Probe{"slow bounces", "approach speed below which there is no restitution", slow_bounce},
    Probe{"friction", "friction cone or friction pyramid", friction},
    Probe{"speed limit", "hidden limit of the speed", speed_limit},
    Probe{"spin limit", "hidden limit of the angular velocity", spin_limit},
    Probe{"damping", "speed that a free body loses", damping},
    Probe{"sleeping", "whether slow bodies are stopped", sleeping},
};

}  // namespace

std::span<const Probe> probes() { return table; }

std::vector<Finding> find_out(const Runner& run) {
  std::vector<Finding> findings;
  for (const Probe& probe : table) {
    try {
      findings.push_back(probe.ask(run));
    } catch (const RunFailed& failed) {
      findings.push_back({std::string(results::name(failed.outcome.status)), failed.outcome.reason});
    }
  }
  return findings;
}

}  // namespace cylon::study
