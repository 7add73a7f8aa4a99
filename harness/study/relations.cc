#include "harness/study/relations.h"

#include "harness/core/fields.h"
#include "harness/core/force_law.h"
#include "harness/core/joint_coordinates.h"
#include "harness/study/relations_composed.h"
#include "harness/study/restate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace cylon::study {
namespace {

using core::Body;
using core::BodyState;
using core::Force;
using core::Matrix3;
using core::Recording;
using core::Scene;
using core::State;
using core::Vector3;

// ---- What scenes hold -----------------------------------------------------------------------------

template <class F>
bool any(const Scene& scene) {
  return std::any_of(scene.forces.begin(), scene.forces.end(),
                     [](const Force& f) { return std::holds_alternative<F>(f); });
}

bool joined_to_world(const Scene& scene) {
  return std::any_of(scene.joints.begin(), scene.joints.end(),
                     [](const core::Joint& j) { return j.to == core::world; });
}

bool locked(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& b) { return b.locked; });
}

bool touching(const Scene& scene) {
  return core::any_touching_pair(scene, [](const core::Pair&) { return true; });
}

// What holds the scene to the world besides forces.
Reason held(const Scene& scene) {
  if (scene.frame) return "the frame turns or moves";
  if (joined_to_world(scene)) return "a joint ends at the world";
  if (locked(scene)) return "a body is locked";
  if (!scene.planes.empty()) return "planes are at rest";
  return {};
}

Reason anything_outside(const Scene& scene) {
  if (const Reason why = broken(scene, &core::Broken::boost)) return why;
  return held(scene);
}

Reason clocks(const Scene& scene) {
  if (const Reason why = broken(scene, &core::Broken::any_instant)) return why;
  if (scene.frame) return "the frame turns";
  return {};
}

Reason never(const Scene&) { return {}; }

// The run of the restated scene, told in the plain words again.
double restated(const Subject& s, const Runner& run, const Restatement& change) {
  Subject in_new_units = s;
  in_new_units.scales.length *= change.length;
  in_new_units.scales.speed *= change.length / change.time;
  in_new_units.scales.angular_velocity /= change.time;
  return worst(in_new_units, again(s, run, change(s.scene), change.time),
               [&](const State& plain, double) { return change(plain); });
}

// The scene from another state on.
Scene from(Scene scene, const State& start) {
  const std::vector<core::HeldJoint> held = core::held_joints(scene);
  for (std::size_t j = 0; j < held.size(); ++j) scene.joints[j] = core::joint_at(held[j], start);
  for (std::size_t i = 0; i < start.size(); ++i) scene.bodies[i].initial = start[i];
  return scene;
}

State turned_round(State state) {
  for (BodyState& b : state) b.velocity = -b.velocity, b.angular_velocity = -b.angular_velocity;
  return state;
}

Matrix3 rotation(double angle, const Vector3& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

// ---- The relations -----------------------------------------------------------------------------------

double translation(const Subject& s, const Runner& run) {
  Restatement change;
  change.move = s.scales.length * along;
  return restated(s, run, change);
}

double turning(const Subject& s, const Runner& run) {
  Restatement change;
  change.turn = rotation(0.9, {-0.2, 0.5, 0.3});
  return restated(s, run, change);
}

double mirror(const Subject& s, const Runner& run) {
  Restatement change;
  change.turn = change.own = Vector3(-1, 1, 1).asDiagonal();
  return restated(s, run, change);
}

double units(const Subject& s, const Runner& run) {
  Restatement change;
  change.length = 4, change.mass = 0.5, change.time = 2;
  return restated(s, run, change);
}

double heavier(const Subject& s, const Runner& run) {
  Restatement change;
  change.mass = 3.7;
  return restated(s, run, change);
}

// Axes in a body are a name; only where no shape has axes.
Reason shaped(const Scene& scene) {
  for (const Body& b : scene.bodies)
    if (!std::holds_alternative<std::monostate>(b.shape) && !std::holds_alternative<core::Sphere>(b.shape) &&
        !std::holds_alternative<core::Hull>(b.shape) && !std::holds_alternative<core::Mesh>(b.shape))
      return fmt::format("the shape of '{}' has axes", b.name);
  return {};
}

double body_axes(const Subject& s, const Runner& run) {
  Restatement change;
  change.own = rotation(1.1, {0.6, -0.3, 0.5});
  return restated(s, run, change);
}

// p + u t, v + u, the same turns.
double boost(const Subject& s, const Runner& run) {
  const Vector3 u = s.scales.speed * along;
  Scene scene = s.scene;
  for (Body& b : scene.bodies) b.initial.velocity += u;
  for (Force& f : scene.forces)
    std::visit(
        [&](auto& force) {
          core::for_each_field(force, [&]<class Value>(const auto& field, Value& value) {
            if (field.about.in != core::Expressed::world_vector || field.about.unit != "m/s") return;
            if constexpr (std::is_same_v<Value, Vector3>) value += u;
            if constexpr (std::is_same_v<Value, std::optional<Vector3>>)
              if (value) *value += u;
          });
        },
        f);
  return worst(s, again(s, run, scene), [&](State plain, double t) {
    for (BodyState& b : plain) b.position += t * u, b.velocity += u;
    return plain;
  });
}

Reason does_not_fall(const Scene& scene) {
  if (const Reason why = broken(scene, &core::Broken::free_fall)) return why;
  return held(scene);
}

// In uniform gravity an isolated system only falls: p + g t^2/2, v + g t.
double free_fall(const Subject& s, const Runner& run) {
  const double duration = s.plain.time(s.plain.steps.size() - 1);
  const Vector3 g = s.scales.speed / duration * along;
  Scene scene = s.scene;
  scene.forces.emplace_back(core::UniformGravity{g});
  for (Body& b : scene.bodies)
    if (b.gravity) *b.gravity += g;
  return worst(s, again(s, run, scene), [&](State plain, double t) {
    for (BodyState& b : plain) b.position += t * t / 2 * g, b.velocity += t * g;
    return plain;
  });
}

// Conservative and smooth: the film runs backwards.
Reason irreversible(const Scene& scene) {
  if (const Reason why = clocks(scene)) return why;
  if (const Reason why = broken(scene, &core::Broken::reversal)) return why;
  if (touching(scene)) return "bodies touch";
  return {};
}

double reversal(const Subject& s, const Runner& run) {
  const std::int64_t steps = s.plain.steps.back();
  const Recording back = again(s, run, from(s.scene, turned_round(s.plain.states.back())));
  Recording home = back;
  for (std::int64_t& step : home.steps) step = steps - step;
  for (State& state : home.states) state = turned_round(state);
  return worst(s, home, [](const State& plain, double) { return plain; });
}

// A run that stops half-way goes on from what was read.
double split(const Subject& s, const Runner& run) {
  const std::size_t half = s.plain.steps.size() / 2;
  const std::int64_t first = s.plain.steps[half];
  Recording rest =
      run(from(s.scene, s.plain.states[half]), s.plain.dt, s.plain.steps.back() - first, s.every);
  for (std::int64_t& step : rest.steps) step += first;
  return worst(s, rest, [](const State& plain, double) { return plain; });
}

double repetition(const Subject& s, const Runner& run) {
  return worst(s, again(s, run, s.scene), [](const State& plain, double) { return plain; });
}

// Springs without rest length, damped or not, and linear drag: motions about the equilibrium add up.
Reason not_linear(const Scene& scene) {
  if (const Reason why = clocks(scene)) return why;
  if (!any<core::Spring>(scene)) return "there is no spring";
  if (const Reason why = broken(scene, &core::Broken::superposition)) return why;
  if (!scene.joints.empty()) return "joints are not linear";
  if (touching(scene)) return "bodies touch";
  return {};
}

// The flow of places and velocities is affine: half-way between two starts it stays half-way.
double superposition(const Subject& s, const Runner& run) {
  Scene other = s.scene, between = s.scene;
  for (std::size_t i = 0; i < other.bodies.size(); ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    other.bodies[i].initial.position += sign * s.scales.length * along;
    other.bodies[i].initial.velocity -= sign * s.scales.speed * along;
    BodyState& mean = between.bodies[i].initial;
    mean.position = (mean.position + other.bodies[i].initial.position) / 2;
    mean.velocity = (mean.velocity + other.bodies[i].initial.velocity) / 2;
  }
  const Recording a = again(s, run, other), b = again(s, run, between);
  Recording half = s.plain;
  for (std::size_t k = 0; k < half.states.size() && k < a.states.size(); ++k)
    for (std::size_t i = 0; i < half.states[k].size(); ++i) {
      BodyState& mean = half.states[k][i];
      mean.position = (mean.position + a.states[k][i].position) / 2;
      mean.velocity = (mean.velocity + a.states[k][i].velocity) / 2;
    }
  return worst({s.scene, half, s.every, s.scales, s.until}, b,
               [](const State& plain, double) { return plain; });
}

constexpr std::array table = {
    Relation{"repetition", "a repeated run gives the same bits", never, repetition, true},
    Relation{"translation", "a translated scene has the translated motion", fixed_place, translation},
    Relation{"rotation", "a rotated scene has the rotated motion", placed, turning},
    Relation{"mirror", "a mirrored scene has the mirrored motion", placed, mirror},
    Relation{"boost", "a uniform velocity of an isolated scene is added to its motion", anything_outside,
             boost},
    Relation{"free fall", "additional uniform gravity makes an isolated scene fall and changes nothing else",
             does_not_fall, free_fall},
    Relation{"units", "other units of length, mass and time give the same motion in these units", placed,
             units},
    Relation{"mass", "masses, inertias and forces times the same factor give the same motion", placed,
             heavier},
    Relation{"body axes", "other body axes give the same motion", shaped, body_axes},
    Relation{"body order", "the order of the bodies has no effect", one_body, body_order},
    Relation{"part order", "the order of forces, joints and planes has no effect", one_part, part_order},
    Relation{"other points",
             "joints and springs named from the other end, or from another point that they keep, act alike",
             none_between, other_points},
    Relation{"far body", "a distant body has no effect", placed, far_body},
    Relation{"bystander", "a scene and its copy far away each move as the scene does alone", no_room,
             bystander},
    Relation{"removal", "without a body that nothing joins, pulls or touches, the others move as before",
             none_apart, removal},
    Relation{"weld", "a body moves as the two that a fixed joint makes of it", none_to_split, weld},
    Relation{"split run", "a run that is split in two halves gives the same motion", clocks, split},
    Relation{"time reversal", "without losses the motion is reversible in time", irreversible, reversal},
    Relation{"superposition",
             "with linear forces, the mean of two initial states follows the mean of the two motions",
             not_linear, superposition},
};

}  // namespace

std::span<const Relation> relations() { return table; }

}  // namespace cylon::study
