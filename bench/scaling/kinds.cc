#include "bench/scaling/kinds.h"

#include "bench/pile.h"
#include "bench/scaling/touching.h"
#include "harness/core/measure.h"
#include "harness/core/observable.h"
#include "reference/exact/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::bench::scaling {
namespace {

const core::Vector3 gravity = {0, -9.81, 0};

// A part of [0, 1) that belongs to body i: the golden ratio's multiples, a different stride for each use.
double part(std::int64_t i, int use) {
  return std::fmod(static_cast<double>(i + 1) * (0.6180339887498949 + 0.01 * use), 1.0);
}

// A lattice that nobody leaves or fills, so that positions stay of the size of the scene.
core::Body flying(std::int64_t i) {
  core::Body body;
  body.name = fmt::format("b{}", i);
  body.mass = 1.5;
  body.inertia = core::Vector3(0.2, 0.3, 0.4).asDiagonal();
  const std::int64_t row = i / 100 % 100, layer = i / 10'000;
  body.initial.position = {2.0 * static_cast<double>(i % 100), 2.0 * static_cast<double>(row),
                           2.0 * static_cast<double>(layer)};
  body.initial.velocity = {part(i, 0) - 0.5, part(i, 1) - 0.5, part(i, 2) - 0.5};
  return body;
}

core::Scene points(std::int64_t count) {
  core::Scene scene;
  scene.forces = {core::UniformGravity{gravity}};
  for (std::int64_t i = 0; i < count; ++i) scene.bodies.push_back(flying(i));
  return scene;
}

core::Scene rigid(std::int64_t count) {
  core::Scene scene = points(count);
  for (std::int64_t i = 0; i < count; ++i)
    scene.bodies[static_cast<std::size_t>(i)].initial.angular_velocity =
        core::Vector3(0.3, 1.1, -0.4) * (1 + part(i, 3));
  return scene;
}

// Knot i of a line that is folded into a cube of 100 m, 1 m from knot to knot: stretched out, 10^5 of them
// would lie where single precision has no millimetres.
core::Vector3 knot(std::int64_t i) {
  const auto turned = [](std::int64_t k, std::int64_t row) { return row % 2 == 0 ? k : 99 - k; };
  const std::int64_t layer = i / 10'000;
  return {static_cast<double>(turned(i % 100, i / 100)), static_cast<double>(turned(i / 100 % 100, layer)),
          static_cast<double>(layer)};
}

// Beads at rest length between two pins, every tenth of them pushed along the line and across.
core::Scene springs(std::int64_t count) {
  core::Scene scene;
  for (std::int64_t i = 0; i < count; ++i) {
    core::Body bead = flying(i);
    bead.initial.position = knot(i + 1);
    bead.initial.velocity = i % 10 == 0 ? core::Vector3(0.5, 0.2, -0.3) : core::Vector3::Zero();
    scene.bodies.push_back(bead);
  }
  for (std::int64_t i = 0; i <= count; ++i) {
    core::Spring spring;
    spring.body = static_cast<int>(std::min(i, count - 1));
    spring.to = i == 0 || i == count ? core::world : static_cast<int>(i - 1);
    if (i == 0 || i == count) spring.to_anchor = knot(i == 0 ? 0 : count + 1);
    spring.stiffness = 100, spring.rest_length = 1;
    scene.forces.emplace_back(spring);
  }
  return scene;
}

// As in pile_bench, but so close that all have met before the end, whatever the height.
core::Scene spheres(std::int64_t count) {
  const auto side = static_cast<std::int64_t>(std::ceil(std::cbrt(static_cast<double>(count))));
  return bench::pile(count, side, 0.505, 1.009);
}

core::Scene boxes(std::int64_t count) {
  core::Scene scene = spheres(count);
  for (core::Body& body : scene.bodies) {
    body.shape = core::Box{core::Vector3::Constant(radius)};
    body.inertia = core::Matrix3::Identity() * (mass * 4 * radius * radius / 6);
  }
  return scene;
}

constexpr double end = static_cast<double>(steps) * dt;

Seen off_the_parabola(const core::Scene& scene, const core::State& state) {
  Seen seen;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const core::BodyState& start = scene.bodies[i].initial;
    const core::Vector3 truth = start.position + end * start.velocity + 0.5 * end * end * gravity;
    seen.error = std::max(seen.error, (state[i].position - truth).norm());
  }
  return seen;
}

// Twenty of them against the closed form.
Seen turn_missed(const core::Scene& scene, const core::State& state) {
  core::Observable q;
  q.quantity = core::Quantity::orientation;
  const auto solutions = exact::catalogue();
  const auto top = std::find_if(solutions.begin(), solutions.end(),
                                [](const exact::Solution& s) { return s.name == "free_asymmetric_top"; });
  Seen seen;
  const std::size_t looked_at = std::min<std::size_t>(state.size(), 20);
  for (std::size_t k = 0; k < looked_at; ++k) {
    const std::size_t i = k * state.size() / looked_at;
    core::Scene one;
    one.bodies = {scene.bodies[i]};
    core::Values theirs, truth;
    core::evaluate(q, one, {state[i]}, theirs);
    core::evaluate(q, one, top->make(one, end).state(end), truth);
    seen.error = std::max(seen.error, core::distance(q, theirs, truth));
  }
  return seen;
}

Seen energy_drift(const core::Scene& scene, const core::State& state) {
  core::Observable q;
  q.quantity = core::Quantity::energy;
  core::State start;
  for (const core::Body& body : scene.bodies) start.push_back(body.initial);
  core::Values before, after;
  core::evaluate(q, scene, start, before);
  core::evaluate(q, scene, state, after);
  return {core::distance(q, before, after) / core::energy_scale(scene, start), 0};
}

Seen overlap_of(const core::Scene& scene, const core::State& state) {
  const Touching t = touching(scene, state, 1e-3);
  return {1e3 * t.deepest, t.pairs};
}

constexpr Kind table[] = {
    {"points", "point masses that fly freely", "off the parabola", "m", false, points, off_the_parabola},
    {"rigid", "rigid bodies that fly freely and spin", "turn missed", "rad", false, rigid, turn_missed},
    {"springs", "beads on a folded line of springs", "drift of energy", "of its size", false, springs,
     energy_drift},
    {"spheres", "spheres dropped into an open box", "overlap", "mm", true, spheres, overlap_of},
    {"boxes", "boxes dropped into an open box", "overlap", "mm", true, boxes, overlap_of},
};

}  // namespace

std::span<const Kind> kinds() { return table; }

}  // namespace cylon::bench::scaling
