#include "harness/study/probes.h"

#include "harness/core/solid.h"

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

// ---- Damping ------------------------------------------------------------------------------------------
// Some engines damp by default.  The other probes are asked of what such an engine does besides:  v' = a - c v  with the
// rates c of a free body (damping_of), so that  v = r v0 + a (1 - r)/c,  r = exp(-c t).

// Single precision rounds a thousand times on the way.
double rate(double left, double t) { return std::abs(1 - left) < 1e-4 ? 0 : -std::log(left) / t; }

Finding damping(const Runner&, const Damping& damped) {
  const auto lost = [](double rate) { return 1 - Damping::left(rate, 1); };
  const std::string evidence = fmt::format("decrease in 1 s: {:.2g} of 1 m/s, {:.2g} of 1 rad/s",
                                           lost(damped.linear), lost(damped.angular));
  if (damped.linear == 0 && damped.angular == 0) return {"none", evidence};
  return {fmt::format("linear {:.3g}/s, angular {:.3g}/s", damped.linear, damped.angular), evidence};
}

// ---- Free fall ---------------------------------------------------------------------------------------
// n steps of dt: explicit Euler ends g T dt/2 too high, semi-implicit Euler as much too low, k sub-steps a
// k-th of it, integrators of second order and above exactly.
Finding fall(const Runner& run, const Damping& damped) {
  constexpr double dt = 1.0 / 512, T = 1.0 / 8, v = 1.1;
  const double c = damped.linear;
  Scene scene = ball({0, 1, 0}, {0.3, v, -0.4});
  scene.forces.emplace_back(core::UniformGravity{{0, -g, 0}});
  const Recording r = run(scene, dt, 64, 64);
  const double exact = 1 + v * Damping::gained(c, T) - g * Damping::moved(c, T);
  const double residual = (end(r).position.y() - exact) / (g * T * dt);
  const std::string evidence = fmt::format("final offset from the parabola: {:+.4f} g T dt", residual);
  if (std::abs(residual) < 2e-3) return {"second order or better", evidence};
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
Finding spring(const Runner& run, const Damping& damped) {
  constexpr double k = 100, T = 2;
  // x = exp(-b t) (x0 cos w t + (v0 + b x0)/w sin w t)
  const double b = damped.linear / 2, w = std::sqrt(k - b * b);
  const Vector3 x0(0.6, -0.3, 0.2), v0(1, 2, -3), y0 = (v0 + b * x0) / w;
  Scene scene = ball(x0, v0);
  scene.forces.emplace_back(core::Spring{0, Vector3::Zero(), core::world, Vector3::Zero(), k, 0, 0});
  std::vector<double> error, early, late;
  double drift = 0;
  for (const int halvings : {0, 1, 2}) {
    const std::int64_t n = std::int64_t{512} << halvings;
    const Recording r = run(scene, T / static_cast<double>(n), n, 1);
    double worst = 0, first = 0, second = 0;
    for (std::size_t i = 0; i < r.states.size(); ++i) {
      const double t = r.time(i);
      const BodyState& s = r.states[i].front();
      const double cos = std::exp(-b * t) * std::cos(w * t), sin = std::exp(-b * t) * std::sin(w * t);
      const Vector3 x = x0 * cos + y0 * sin, v = w * (y0 * cos - x0 * sin) - b * x;
      worst = std::max(worst, (s.position - x).norm());
      const double off = (s.velocity.squaredNorm() + k * s.position.squaredNorm()) /
                             (v.squaredNorm() + k * x.squaredNorm()) -
                         1;
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
// Without the gyroscopic torque the angular velocity keeps its direction; an explicit one feeds energy, an implicit one
// takes it, both by the first power of the step.  Damping shortens all vectors alike.
Finding gyroscopic(const Runner& run, const Damping& damped) {
  const Vector3 moments(0.4, 0.68, 0.9), w0(1.3, 2.1, -3.2);
  Scene scene = ball(Vector3::Zero(), Vector3::Zero(), w0);
  // With the surface of its brick: an engine may look at that to see whether a body still moves.
  const Vector3 squares = 1.5 * (Vector3::Constant(moments.sum()) - 2 * moments);
  scene.bodies[0].shape = core::Box{squares.cwiseSqrt()};
  scene.bodies[0].collide = true;
  scene.bodies[0].inertia = moments.asDiagonal();
  const double energy0 = w0.dot(moments.cwiseProduct(w0)) / 2, spin0 = moments.cwiseProduct(w0).norm();
  const double left = Damping::left(damped.angular, 2);
  std::vector<double> energy, spin;
  double turned = 0;
  for (const std::int64_t n : {480, 960}) {
    const BodyState s = end(run(scene, 2.0 / static_cast<double>(n), n, n));
    const Vector3 l = core::world_inertia(scene.bodies[0], s.orientation) * s.angular_velocity;
    energy.push_back(s.angular_velocity.dot(l) / 2 / energy0 / (left * left) - 1);
    spin.push_back((l / left - moments.cwiseProduct(w0)).norm() / spin0);
    turned = (s.angular_velocity.normalized() - w0.normalized()).norm();
  }
  const std::string evidence = fmt::format(
      "error after 2 s: energy {:+.2g}, angular momentum {:.2g} at dt = 1/240 s; {:+.2g} and {:.2g} at dt = "
      "1/480 s",
      energy[0], spin[0], energy[1], spin[1]);
  if (turned < 1e-5) return {"off", fmt::format("the angular velocity turns by at most {:.1g} rad", turned)};
  if (std::abs(energy[0]) < 1e-5 && spin[0] < 1e-5) {
    const double slope = std::log2(spin[0] / spin[1]);
    constexpr double rounding = 1e-12;  // of 1000 steps in double precision
    return {spin[0] < rounding || !(slope > 0.5) ? "on, exact within rounding"
                                                 : fmt::format("on, order {:.0f}", slope),
            evidence};
  }
  const double slope = std::log2(std::abs(energy[0] / energy[1]));
  if (!(slope > 0.25)) return {"on, with an error that does not fall with the step", evidence};
  if (std::abs(slope - 1) > 0.25) return {fmt::format("on, order {:.1f} in energy", slope), evidence};
  return {energy[0] > 0 ? "explicit: adds energy" : "implicit: removes energy", evidence};
}

// ---- An elastic bounce -----------------------------------------------------------------------------------
// Speed in the last step before, and in the first after: v' = |v|: the target is the speed before the step's
// gravity; v' = |v| + g dt: after it; energy kept at any fraction of the step: at the impact's own instant.
Finding bounce(const Runner& run, const Damping& damped) {
  constexpr double dt = 1.0 / 256;
  const double left = Damping::left(damped.linear, dt);
  const Recording r = run(over_floor(ball({0, 1.137, 0}, {0, -0.4, 0}), 1, 0, g), dt, 200, 1);
  for (std::size_t i = 1; i < r.states.size(); ++i) {
    const BodyState &a = r.states[i - 1].front(), &b = r.states[i].front();
    if (!(a.velocity.y() < 0 && b.velocity.y() > 0)) continue;
    const double before = -a.velocity.y(), after = b.velocity.y() / left;
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
Finding slow_bounce(const Runner& run, const Damping& damped) {
  constexpr std::array speeds = {0.01, 0.03, 0.1, 0.3, 1.0, 3.0};
  constexpr double e = 0.8;
  const double left = Damping::left(damped.linear, 0.75);
  std::vector<std::string> ratios;
  double none = 0, lost = 0;  // up to which speeds it has none, and another than the scene's
  for (const double v : speeds) {
    const Recording r =
        run(over_floor(ball({0, 0.1 + 0.317 * v, 0}, {0, -v, 0}), e, 0, 0), 1.0 / 240, 180, 180);
    const double ratio = end(r).velocity.y() / v / left;
    ratios.push_back(fmt::format("{:.2f} at {}", ratio, v));
    if (ratio < 0.02) none = v;
    if (std::abs(ratio - e) > 0.02) lost = v;
  }
  const std::string evidence =
      fmt::format("rebound over approach speed: {} m/s; the scene has {}", fmt::join(ratios, ", "), e);
  if (lost == 0) return {"restitution is applied down to 0.01 m/s", evidence};
  if (none == speeds.back()) return {"restitution is not applied", evidence};
  if (none == lost) return {fmt::format("no restitution at {} m/s and below", none), evidence};
  const std::string other = lost == speeds.back() ? "at any speed" : fmt::format("up to {} m/s", lost);
  if (none == 0) return {"another restitution than the scene's " + other, evidence};
  return {fmt::format("no restitution at {} m/s and below, another than the scene's {}", none, other),
          evidence};
}

// ---- Friction --------------------------------------------------------------------------------------------
// A flat box slides at 0, 22.5 and 45 degrees: mu g against its motion under Coulomb's cone; up to sqrt(2)
// times that, and sideways, under a pyramid on the axes.
Finding friction(const Runner& run, const Damping& damped) {
  constexpr double mu = 0.3, v = 2, T = 0.25;
  const double c = damped.linear, left = Damping::left(c, T), gained = Damping::gained(c, T);
  std::vector<double> along, across;
  for (const double degrees : {0.0, 22.5, 45.0}) {
    const double a = degrees * std::numbers::pi / 180;
    const Vector3 way(std::cos(a), 0, std::sin(a)), side(-std::sin(a), 0, std::cos(a));
    Scene scene = ball({0, 0.05, 0}, v * way);
    scene.bodies[0].shape = core::Box{{0.5, 0.05, 0.5}};
    scene.bodies[0].inertia = Vector3(0.25 + 0.0025, 0.5, 0.25 + 0.0025).asDiagonal() * (1.0 / 3);
    const Vector3 end_velocity = end(run(over_floor(scene, 0, mu, g), 1.0 / 480, 120, 120)).velocity;
    along.push_back((v * left - end_velocity.dot(way)) / (mu * g * gained));
    across.push_back(end_velocity.dot(side) / (mu * g * gained));
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

// The largest speed of all steps, as damping acts before or after the limit; a start that an engine does not even hold is a
// limit, too.
template <class Start, class Speed>
Finding limit(const Runner& run, std::array<double, 4> speeds, double left, const char* unit,
              const Start& start, const Speed& speed) {
  for (const double v : speeds) {
    double kept = 0;
    try {
      const Recording r = run(start(v), 1.0 / 60, 6, 1);
      for (std::size_t i = 1; i < r.states.size(); ++i) kept = std::max(kept, speed(r.states[i].front()));
    } catch (const RunFailed& failed) {
      return {fmt::format("less than {:g} {}, a start that it does not hold", v, unit),
              failed.outcome.reason};
    }
    if (kept < (1 - 1e-3) * left * v || kept > (1 + 1e-3) * v)
      return {fmt::format("{:.4g} {}", kept, unit), fmt::format("{:g} {} becomes {:.4g}", v, unit, kept)};
  }
  return {fmt::format("none up to 1e{:.0f} {}", std::log10(speeds.back()), unit),
          fmt::format("{:g} {} are kept for 0.1 s", fmt::join(speeds, ", "), unit)};
}

Finding speed_limit(const Runner& run, const Damping& damped) {
  return limit(
      run, {1e2, 1e3, 1e4, 1e5}, Damping::left(damped.linear, 0.1), "m/s",
      [](double v) {
        return ball(Vector3::Zero(), {0.6 * v, 0, -0.8 * v});
      },
      [](const BodyState& s) { return s.velocity.norm(); });
}

Finding spin_limit(const Runner& run, const Damping& damped) {
  return limit(
      run, {10, 1e2, 1e3, 1e4}, Damping::left(damped.angular, 0.1), "rad/s",
      [](double w) {
        return ball(Vector3::Zero(), Vector3::Zero(), {0, 0.6 * w, -0.8 * w});
      },
      [](const BodyState& s) { return s.angular_velocity.norm(); });
}

// The turn of one step, which some engines make by a linear or a limited formula.
Finding turn_per_step(const Runner& run, const Damping& damped) {
  constexpr double dt = 1.0 / 60;
  const double left = Damping::left(damped.angular, dt);  // of the spin, before or after it turns the body
  std::vector<std::string> turns;
  double exact = 0;
  bool all = true;
  for (const double turn : {0.1, 0.3, 1.0, 2.0, 3.0}) {
    BodyState s;
    try {
      s = end(run(ball(Vector3::Zero(), Vector3::Zero(), {0, turn / dt, 0}), dt, 1, 1));
    } catch (const RunFailed&) {  // it takes no such spin
      turns.push_back(fmt::format("no start for {}", turn));
      break;
    }
    const double made = 2 * std::atan2(s.orientation.vec().norm(), std::abs(s.orientation.w()));
    turns.push_back(fmt::format("{:.4f} for {}", made, turn));
    all = all && (std::abs(made - turn) < 1e-4 * turn || std::abs(made - left * turn) < 1e-4 * turn);
    if (all) exact = turn;
  }
  const std::string evidence = fmt::format("measured angles: {} rad", fmt::join(turns, ", "));
  if (exact == 0) return {"approximate at every angle", evidence};
  return {fmt::format("exact up to {} rad per step", exact), evidence};
}

// ---- What happens when nothing acts ----------------------------------------------------------------

Finding sleeping(const Runner& run, const Damping& damped) {
  constexpr double v = 1e-3;
  const BodyState s = end(run(ball(Vector3::Zero(), {v, 0, 0}, {0, v, 0}), 1.0 / 60, 600, 600));
  const double way = s.position.x() / (v * Damping::gained(damped.linear, 10));
  const std::string evidence =
      fmt::format("a body at 1 mm/s covers {:.4f} of the expected distance in 10 s", way);
  return {std::abs(way - 1) < 1e-2 ? "never" : "slow bodies are stopped", evidence};
}

// A cylinder that lies on a box.
Finding rest(const Runner& run, const Damping&) {
  Scene scene = ball({0, 0.2, 0}, Vector3::Zero());
  core::Body& top = scene.bodies[0];
  top.shape = core::Cylinder{0.2, 0.5};
  top.inertia = core::mass_properties(top.shape, top.mass).inertia;
  top.initial.orientation = core::Quaternion(std::sqrt(0.5), std::sqrt(0.5), 0, 0);
  core::Body& base = scene.bodies.emplace_back(top);
  base.name = "base", base.shape = core::Box{{1, 0.5, 1}}, base.locked = true;
  base.initial = {{0, -0.5, 0}, core::Quaternion::Identity(), Vector3::Zero(), Vector3::Zero()};
  scene = over_floor(scene, 0, 0.5, g), scene.planes.clear();
  const Recording r = run(scene, 1.0 / 240, 240, 1);
  double moved = 0, turned = 0;
  for (const core::State& s : r.states) {
    moved = std::max(moved, (s[0].position - r.states[0][0].position).norm());
    turned = std::max(turned, s[0].orientation.angularDistance(r.states[0][0].orientation));
  }
  const std::string evidence = fmt::format("it moves {:.2g} m and turns {:.2g} rad in 1 s", moved, turned);
  if (moved < 1e-6 && turned < 1e-5) return {"stays", evidence};
  if (turned < 1e-5) return {fmt::format("sinks {:.1g} mm", 1e3 * moved), evidence};
  return {fmt::format("moves {:.1g} mm, turns {:.0e} rad", 1e3 * moved, turned), evidence};
}

// Every number that comes back fits a float exactly, or not.
Finding precision(const Runner& run, const Damping&) {
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
    Probe{"rest", "whether a cylinder that lies on a box stays where it is", rest},
    Probe{"speed limit", "hidden limit of the speed", speed_limit},
    Probe{"spin limit", "hidden limit of the angular velocity", spin_limit},
    Probe{"damping", "speed that a free body loses", damping},
    Probe{"sleeping", "whether slow bodies are stopped", sleeping},
};

}  // namespace

Damping damping_of(const Runner& run) {
  const BodyState s = end(run(ball(Vector3::Zero(), {0.6, 0, -0.8}, {0.36, -0.48, 0.8}), 1.0 / 64, 64, 64));
  return {rate(s.velocity.norm(), 1), rate(s.angular_velocity.norm(), 1)};
}

std::span<const Probe> probes() { return table; }

std::vector<Finding> find_out(const Runner& run) {
  const auto failure = [](const RunFailed& failed) {
    return Finding{std::string(results::name(failed.outcome.status)), failed.outcome.reason};
  };
  std::vector<Finding> findings;
  Damping damped;
  try {
    damped = damping_of(run);
  } catch (const RunFailed& failed) {  // it does not even let a ball fly
    findings.assign(table.size(), failure(failed));
    return findings;
  }
  for (const Probe& probe : table) {
    try {
      findings.push_back(probe.ask(run, damped));
    } catch (const RunFailed& failed) {
      findings.push_back(failure(failed));
    }
  }
  return findings;
}

}  // namespace cylon::study
