#include "harness/hunt/recorded.h"

#include "harness/core/observable.h"
#include "harness/core/overloaded.h"
#include "harness/core/size.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cylon::hunt {
namespace {

using core::Vector3;

double kinetic_energy(const core::Scene& scene, const core::State& state) {
  double twice = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const core::Body& body = scene.bodies[i];
    if (body.locked) continue;
    const Vector3 w = state[i].angular_velocity;
    twice += body.mass * state[i].velocity.squaredNorm() +
             w.dot(core::world_inertia(body, state[i].orientation) * w);
  }
  return twice / 2;
}

// Largest size of the forces on each body.
std::vector<double> most_force(const core::Scene& scene) {
  std::vector<double> force(scene.bodies.size());
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] = scene.bodies[i].mass * core::gravity_of(scene, scene.bodies[i]).norm();
  const auto add = [&](int body, double size) { force[static_cast<std::size_t>(body)] += size; };
  for (const core::Force& one : scene.forces)
    std::visit(
        core::Overloaded{[&](const core::Drive& f) { add(f.body, f.force.norm()); },
                         [&](const core::Thrust& f) { add(f.body, f.force.norm()); }, [](const auto&) {}},
        one);
  return force;
}

}  // namespace

std::optional<Reading> read_locked(const core::Scene& scene, const core::Recording& run) {
  double most = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::Body& body = scene.bodies[i];
    if (!body.locked) continue;
    const core::BodyState& start = run.states.front()[i];
    const double size = std::max(core::size(body), 1e-3);
    for (const core::State& state : run.states)
      most = std::max({most, (state[i].position - start.position).norm() / size,
                       state[i].orientation.angularDistance(start.orientation)});
  }
  return Reading{most, 1, "1"};
}

std::optional<Reading> read_speed(const core::Scene& scene, const core::Recording& run) {
  double mass = 0, square = 0;
  const std::vector<double> force = most_force(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].locked) continue;
    mass += scene.bodies[i].mass;
    square += force[i] * force[i] / scene.bodies[i].mass;
  }
  if (mass == 0) return std::nullopt;
  const auto speed = [&](const core::State& state) {
    return std::sqrt(2 * kinetic_energy(scene, state) / mass);
  };
  const double start = speed(core::initial_state(scene)), gain = std::sqrt(square / mass);
  double above = 0;
  for (std::size_t k = 0; k < run.states.size(); ++k)
    above = std::max(above, speed(run.states[k]) - start - gain * run.time(k));
  const double end = start + gain * run.time(run.states.size() - 1);
  // Where nothing moves and no force acts, speeds are the rounding of places in a step.
  double length = 0;
  for (const core::Body& body : scene.bodies)
    length = std::max({length, core::size(body), body.initial.position.norm()});
  const double rounding = 1e-3 * length / run.dt;
  return Reading{above, std::max(end, rounding), "m/s"};
}

std::optional<Reading> read_rebound(const core::Scene& scene, const core::Recording& run) {
  const core::Plane& plane = scene.planes[0];
  const double radius = std::get<core::Sphere>(scene.bodies[0].shape).radius;
  const double g = -core::gravity_of(scene, scene.bodies[0]).dot(plane.normal);
  const auto material = core::material_of(scene, {0, core::world, 0});
  if (!material || !(g > 0)) return std::nullopt;
  const double e = material->restitution;
  const auto gap = [&](const core::BodyState& s) {
    return plane.normal.dot(s.position) - plane.offset - radius;
  };
  const auto energy = [&](const core::BodyState& s) {
    const double v = plane.normal.dot(s.velocity);
    return v * v / 2 + g * gap(s);
  };
  const core::BodyState& start = scene.bodies[0].initial;
  const double before = energy(start), speed = std::sqrt(2 * before);  // of the blow
  const double blow = (plane.normal.dot(start.velocity) + speed) / g;
  const double next = blow + 2 * e * speed / g;
  const double read = blow + 3 * run.dt;
  const auto sample = static_cast<std::size_t>(std::ceil(read / run.dt));
  if (sample >= run.states.size() || (e > 0 && read + 2 * run.dt > next)) return std::nullopt;
  return Reading{std::abs(energy(run.states[sample][0]) - e * e * before), before, "m^2/s^2"};
}

std::optional<Reading> read_spin(const core::Scene& scene, const core::Recording& run) {
  double farthest = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::BodyState& start = scene.bodies[i].initial;
    const double rate = start.angular_velocity.norm();
    const Vector3 axis = rate > 0 ? Vector3(start.angular_velocity / rate) : Vector3(Vector3::UnitX());
    for (std::size_t k = 0; k < run.states.size(); ++k) {
      const core::Quaternion turned(Eigen::AngleAxisd(rate * run.time(k), axis));
      farthest = std::max(farthest, run.states[k][i].orientation.angularDistance(turned * start.orientation));
    }
  }
  return Reading{farthest, 1, "rad"};
}

std::optional<Reading> read_statics(const core::Scene& scene, const core::Recording& run) {
  if (!run.contacts) return std::nullopt;
  std::vector<Vector3> impulse(scene.bodies.size(), Vector3::Zero());
  for (const core::Contact& contact : *run.contacts) {
    if (!contact.impulse || !contact.friction) return std::nullopt;
    const Vector3 on_first = *contact.impulse * contact.normal + *contact.friction;
    impulse[static_cast<std::size_t>(contact.pair.body)] += on_first;
    if (contact.pair.plane < 0) impulse[static_cast<std::size_t>(contact.pair.other)] -= on_first;
  }
  double worst = 0, weight = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Vector3 own = scene.bodies[i].mass * core::gravity_of(scene, scene.bodies[i]);
    worst = std::max(worst, (impulse[i] / run.dt + own).norm());
    weight += own.norm();
  }
  return Reading{worst, weight, "N"};
}

std::optional<Reading> read_slide(const core::Scene& scene, const core::Recording& run) {
  const core::BodyState& start = scene.bodies[0].initial;
  const double mu = core::material_of(scene, {0, core::world, 0})->friction;
  const double slowed = mu * core::gravity_of(scene, scene.bodies[0]).norm(), speed = start.velocity.norm();
  const Vector3 along = start.velocity / speed;
  const auto way = [&](double time) {
    const double t = slowed * time < speed ? time : speed / slowed;
    return speed * t - slowed * t * t / 2;
  };
  double farthest = 0;
  for (std::size_t k = 0; k < run.states.size(); ++k)
    farthest =
        std::max(farthest, (run.states[k][0].position - start.position - way(run.time(k)) * along).norm());
  return Reading{farthest, way(run.time(run.states.size() - 1)), "m"};
}

}  // namespace cylon::hunt
