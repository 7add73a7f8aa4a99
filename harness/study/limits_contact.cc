// Limit families with contact: piles, walls, bounces, rest.
#include "harness/study/limits_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::study {
namespace {

using core::Recording;
using core::Scene;
using core::Vector3;

constexpr double fastest = 1e12;  // [m/s] or [m]; nothing here comes near

// A pile of cubes of 1 m on a floor; nothing should move.
Probed stands(const Runner& run, const std::vector<double>& masses, double dt, std::int64_t steps,
              double allowed) {
  Scene scene;
  for (std::size_t i = 0; i < masses.size(); ++i)
    scene.bodies.push_back(
        box_body(fmt::format("cube{}", i), masses[i], {0.5, 0.5, 0.5}, {0, static_cast<double>(i) + 0.5, 0}));
  add_floor(scene, 0, 0.5);
  add_gravity(scene);
  const Recording r = run(scene, dt, steps, std::max<std::int64_t>(1, steps / 60));
  if (const auto what = nonsense(r, fastest)) return broken(*what);
  const double far = strayed(r);
  if (far <= allowed) return {};
  return broken(fmt::format("a cube moved by {:.2g} m", far));
}

// A ball of radius 0.1 m flies at a wall without gravity; the speed after, over that before.
double rebound(const Runner& run, double speed, double restitution) {
  constexpr double dt = 1.0 / 240;
  constexpr std::int64_t steps = 180;
  Scene scene = lone_ball({0, 0.1 + 0.317 * speed, 0}, {0, -speed, 0});
  add_floor(scene, restitution, 0);
  return run(scene, dt, steps, steps).states.back()[0].velocity.y() / speed;
}

}  // namespace

Probed mass_ratio_probe(const Runner& run, double ratio) {
  return stands(run, {1, ratio}, 1.0 / 240, 480, 5e-3);
}

Probed stack_probe(const Runner& run, double cubes) {
  return stands(run, std::vector<double>(static_cast<std::size_t>(cubes), 1.0), 1.0 / 60, 120, 0.05);
}

// Eight balls of 0.1 m at a wall of 0.1 m, each an eighth of a step's way further back, so that one of
// them meets the wall at the worst place within its step.
Probed tunnel_probe(const Runner& run, double speed) {
  constexpr double dt = 1.0 / 60, radius = 0.1, half_wall = 0.05;
  constexpr int balls = 8;
  Scene scene;
  core::Body wall = box_body("wall", 1, {half_wall, 100, 5}, Vector3::Zero());
  wall.locked = true;
  scene.bodies.push_back(wall);
  for (int i = 0; i < balls; ++i) {
    const int place = i - balls / 2;
    const double back = (1.5 + static_cast<double>(i) / balls) * speed * dt;
    core::Body ball =
        lone_ball({-half_wall - radius - back, 10.0 * place + 5, 0.1 * i}, {speed, 0, 0}).bodies[0];
    ball.name = fmt::format("ball{}", i);
    ball.collide = true;
    scene.bodies.push_back(ball);
  }
  scene.materials.push_back({{"*", "*"}, 0.5, 0});
  const Recording r = run(scene, dt, 8, 1);
  if (const auto what = nonsense(r, fastest)) return broken(*what);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i)
    if (const core::BodyState& s = r.states.back()[i]; s.position.x() > 0)
      return broken(
          fmt::format("the ball that starts {}/8 of a step farther away ends behind the wall", i - 1));
  return {};
}

// A ball falls four radii and rises to e^2 of that: the same motion at every size when the step goes with
// the root of it.
Probed size_probe(const Runner& run, double radius) {
  constexpr double e = 0.8, part = 0.1;
  constexpr std::int64_t steps_of_fall = 256;
  const double height = 4 * radius, fall = std::sqrt(2 * height / gravity);
  Scene scene = lone_ball({0, radius + height, 0}, Vector3::Zero());
  scene.bodies[0].shape = core::Sphere{radius};
  scene.bodies[0].inertia = 0.4 * radius * radius * core::Matrix3::Identity();
  add_floor(scene, e, 0);
  add_gravity(scene);
  const Recording r = run(scene, fall / steps_of_fall, 5 * steps_of_fall / 2, 1);
  if (const auto what = nonsense(r, 1e6 * std::max(radius, 1.0))) return broken(*what);
  double apex = 0, deepest = 0;
  for (std::size_t i = 0; i < r.states.size(); ++i) {
    const double gap = r.states[i][0].position.y() - radius;
    deepest = std::min(deepest, gap);
    if (r.steps[i] > 3 * steps_of_fall / 2) apex = std::max(apex, gap);
  }
  const double rises = apex / (e * e * height);
  if (deepest < -0.5 * radius)
    return broken(fmt::format("sinks {:.2g} radii into the floor", -deepest / radius));
  if (std::abs(rises - 1) > part) return broken(fmt::format("rebounds to {:.3g} e^2 h", rises));
  return {};
}

Probed low_restitution_probe(const Runner& run, double restitution) {
  const double ratio = rebound(run, 1, restitution);
  if (std::abs(ratio / restitution - 1) <= 0.1) return {};
  return broken(fmt::format("rebounds with {:.3g} of the speed", ratio));
}

Probed high_restitution_probe(const Runner& run, double loss) {
  const double lost = 1 - rebound(run, 1, 1 - loss);
  if (std::abs(lost / loss - 1) <= 0.1) return {};
  return broken(fmt::format("loses {:.3g} of the speed", lost));
}

Probed slow_bounce_probe(const Runner& run, double speed) {
  constexpr double e = 0.8;
  const double ratio = rebound(run, speed, e);
  if (std::abs(ratio - e) <= 0.02) return {};
  return broken(fmt::format("rebounds with {:.3g} of the speed; the scene has {}", ratio, e));
}

// A box at rest, looked at every fiftieth of the run.
Probed rest_run_probe(const Runner& run, double steps) {
  constexpr double allowed = 1e-3;
  Scene scene;
  scene.bodies.push_back(box_body("box", 1, {0.5, 0.5, 0.5}, {0.3, 0.5, -0.2}));
  add_floor(scene, 0, 0.5);
  add_gravity(scene);
  const auto n = static_cast<std::int64_t>(steps);
  const Recording r = run(scene, 1.0 / 60, n, std::max<std::int64_t>(1, n / 50));
  if (const auto what = nonsense(r, fastest)) return broken(*what);
  const double far = strayed(r);
  if (far <= allowed) return {};
  return broken(fmt::format("creep: {:.2g} m in {} steps", far, n));
}

}  // namespace cylon::study
