// What the tests of joints' laws share: joints in general positions, and how many of their scenes each engine takes.
#pragma once

#include "harness/core/later_parts.h"
#include "tests/conformance/adapters_fixture.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::conformance {

inline const Vector3 axis = Vector3(1, -2, 0.5).normalized();
inline const Vector3 axis_2 = Vector3(0.3, 1, -0.2).cross(axis).normalized();
inline const Vector3 point(0.2, -0.1, 0.4);

inline core::Joint joint_of(core::JointType type, int body = 0, int to = core::world,
                            const Vector3& at = point) {
  core::Joint joint{.type = type, .body = body, .to = to, .point = at, .axis = axis};
  if (core::kind_of(type).has_second_axis())
    joint.axis_2 =
        core::kind_of(type).has_square_axes() ? axis_2 : Vector3((axis_2 + 0.5 * axis).normalized());
  if (core::kind_of(type).screws) joint.pitch = 0.15;
  if (core::kind_of(type).place == core::JointPlace::along_normal) joint.length = 0.2;
  return joint;
}

/// Bodies at rest in general poses, no two alike; nothing acts.
inline core::Scene at_rest(int count) {
  core::Scene scene = three_bodies(29);
  scene.bodies.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    core::BodyState& start = scene.bodies[static_cast<std::size_t>(i)].initial;
    start.position = point + Vector3(0.3, 0.2, -0.4) + i * Vector3(0.5, -0.3, 0.2);
    start.velocity = start.angular_velocity = Vector3::Zero();
  }
  return scene;
}

/// How many scenes of each test an engine takes.  A refusal that is new, or gone, is a difference to this table.
struct Taken {
  std::string_view engine;
  int machines = 0;   ///< Of 9 joints with springs, dampers and motors (adapters_joint_laws_test.cc).
  int stops = 0;      ///< Of 40 limits: half of them bounce (adapters_joint_stops_test.cc).
  int frictions = 0;  ///< Of 6 joints with dry friction (the same).
  int rotors = 0;     ///< Of 6 joints with rotors (the same).
};

inline constexpr Taken taken[] = {
    {"in-house", 9, 40, 6, 6},
    {"in-house-float", 9, 40, 6, 6},
    {"ode", 5, 24, 4},
    {"ode-quick", 5, 24, 4},  // neither planar joints nor screws
    {"mujoco", 8, 20, 6, 6},  // no screws, and no coefficient of restitution
    {"bullet", 7, 16, 4},     // no screws, no single stop of an angle
    {"bullet-float", 7, 16, 4},
    // neither screws nor joints of two freedoms, and stops without restitution
    {"bullet-multibody", 4, 12, 4},
    {"bullet-multibody-float", 4, 12, 4},
    {"simbody", 7},
    {"dart", 6, 16, 6},  // nothing that turns about an axis and slides along it, and no stop that gives back
    {"mujoco3", 8, 20, 6, 6},  // as mujoco
    // no screws, no single stop of an angle, no stop that gives back; Rapier also no universal joint
    {"jolt", 7, 8, 4},
    {"rapier", 6, 8, 4},
    {"rapier-deterministic", 6, 8, 4},
    {"rapier-simd", 6, 8, 4},
    {"crashcat", 7, 8, 4},
    {"physx", 7, 8, 4},
};

inline const Taken& taken_by(const Subject& subject) {
  const std::string_view id = subject.id;
  return *std::ranges::find(taken, id.substr(0, id.find('/')), &Taken::engine);
}

inline std::vector<Subject> subjects_with_dart() {
  std::vector<Subject> all(std::begin(subjects), std::end(subjects));
  all.push_back(dart);
  return all;
}

/// Why an engine refuses a scene, as one that it does not know or in its adapter's words; nothing where it takes it.
inline std::optional<std::string> refusal(const core::Engine& engine, const process::EngineChoice& choice,
                                          const core::Scene& scene) {
  if (auto reason = core::not_known(engine, scene)) return reason;
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = 1e-3;
  request.steps = 1;
  const process::RunOutcome outcome = process::run(choice, request, limits);
  if (results::name(outcome.status) != "unsupported") return {};
  return outcome.reason;
}

}  // namespace cylon::conformance
