// A world that can be written down, in place of an engine: a ball falls, bounces with restitution, slips with Coulomb friction and
// rolls.  Flights and the times of impacts are exact.  It can be made wrong in one way at a time.
#pragma once

#include "harness/study/runner.h"
#include "reference/measured/experiment.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <variant>

namespace cylon::ball_world {

/// What the world does wrong.
struct Fault {
  bool pyramid = false;  ///< Friction is bounded on each axis alone.
  bool no_restitution = false;
  double inertia = 1;  ///< Factor of the moment of inertia.
  bool in_steps =
      false;  ///< Impacts are met at the ends of steps, as most engines do: what it predicts has jumps.
};

inline core::Recording ran(const Fault& fault, const core::Scene& scene, double dt, std::int64_t steps,
                           std::int64_t every) {
  using core::Vector3;
  constexpr double slow = 0.02;  // a bounce slower than that is none [m/s]
  const core::Body& body = scene.bodies[0];
  const double r = std::get<core::Sphere>(body.shape).radius, m = body.mass,
               inertia = fault.inertia * body.inertia(0, 0), mu = scene.materials[0].friction,
               e = fault.no_restitution ? 0 : scene.materials[0].restitution,
               g = -std::get<core::UniformGravity>(scene.forces[0]).acceleration.y();
  core::BodyState s = body.initial;
  // A tangential impulse that ends the slip, as far as friction of a normal impulse goes.
  const auto rub = [&](double normal) {
    Vector3 slip = s.velocity + s.angular_velocity.cross(Vector3(0, -r, 0));
    slip.y() = 0;
    Vector3 blow = -m / (1 + m * r * r / inertia) * slip;
    const double most = mu * normal;
    if (fault.pyramid)
      blow = blow.cwiseMax(-most).cwiseMin(most);
    else if (const double size = blow.norm(); size > most)
      blow *= most / size;
    s.velocity += blow / m;
    s.angular_velocity += Vector3(0, -r, 0).cross(blow) / inertia;
  };
  const auto fly = [&](double t, double fall) {
    s.position += s.velocity * t, s.position.y() -= fall * t * t / 2, s.velocity.y() -= fall * t;
    if (const double turn = s.angular_velocity.norm() * t; turn > 0)
      s.orientation = (Eigen::AngleAxisd(turn, s.angular_velocity.normalized()) * s.orientation).normalized();
  };
  bool lies = false;
  const auto bounce = [&] {
    const double speed = -s.velocity.y(), rebound = e * speed > slow ? e * speed : 0;
    rub(m * (speed + rebound));
    s.velocity.y() = rebound, s.position.y() = r;
    lies = rebound == 0;
  };
  core::Recording recording;
  recording.dt = dt;
  for (std::int64_t step = 0; step <= steps; ++step) {
    if (step % every == 0) recording.steps.push_back(step), recording.states.push_back({s});
    double left = dt;
    if (fault.in_steps && !lies) {
      fly(left, g), left = 0;
      if (s.position.y() <= r && s.velocity.y() < 0) bounce();
    }
    while (left > 0 && !lies) {
      const double up = s.velocity.y(), height = std::max(0.0, s.position.y() - r);
      const double meet = (up + std::sqrt(up * up + 2 * g * height)) / g;
      if (meet > left) {
        fly(left, g), left = 0;
        break;
      }
      fly(meet, g), left -= meet;
      bounce();
    }
    if (lies && left > 0) rub(m * g * left), fly(left, 0);
  }
  return recording;
}

inline study::Runner world(const Fault& fault = {}) {
  return [=](const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
    return ran(fault, scene, dt, steps, every);
  };
}

inline constexpr double friction = 0.08, restitution = 0.55, inertia = 1.05, length = 0.98;

/// Throws of a ball, of which the true parameters are those above; `count` runs of 0.6 s in frames of 10 ms, without noise.  A state
/// errs by `errors` times 0.5 mm, 5 mrad, 20 mm/s and 0.1 rad/s.
inline measured::Experiment throws(int count, std::uint64_t seed, double errors = 0.3) {
  using core::Vector3;
  measured::Experiment e;
  e.title = "throws of a ball", e.file = "ball", e.model.file = "ball";
  e.rate = 100, e.model.step = 0.002;
  e.bodies = {0};
  core::Body ball;
  ball.name = "ball", ball.mass = 0.3, ball.shape = core::Sphere{0.05}, ball.collide = true;
  ball.inertia = 0.4 * 0.3 * 0.05 * 0.05 * core::Matrix3::Identity();
  e.model.scene.bodies = {ball};
  e.model.scene.planes = {core::Plane{.name = "table"}};
  e.model.scene.forces = {core::UniformGravity{}};
  e.model.scene.materials = {core::Material{{"ball", "table"}, 0.5, 0.3}};
  e.noise = errors * 0.0005, e.angle_noise = errors * 0.005;
  Eigen::VectorXd deviations(12);
  deviations << Vector3::Constant(0.0005), Vector3::Constant(0.005), Vector3::Constant(0.02),
      Vector3::Constant(0.1);
  e.start = (errors * deviations).asDiagonal();
  e.fit.horizon = 0.19;
  e.parameters = {{"friction", "friction", "", 0.02, 0.15, 0.3},
                  {"restitution", "restitution", "", 0.2, 0.4, 0.9},
                  {"inertia", "inertia", "", 0.7, 1, 1.5},
                  {"length", "length", "", 0.9, 1, 1.1}};
  std::mt19937_64 bits(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  };
  const auto vector = [&](double size) -> Vector3 {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  };
  for (int i = 0; i < count; ++i) {
    core::BodyState start;
    start.position = Vector3(0, 0.2, 0) + vector(0.05);
    start.velocity = Vector3(0.9, -0.3, 0.6) + vector(0.4);
    start.angular_velocity = vector(15);
    e.runs.push_back({std::to_string(i), std::vector<core::State>(60, core::State{start})});
  }
  return e;
}

inline std::vector<double> truth() { return {friction, restitution, inertia, length}; }

}  // namespace cylon::ball_world
