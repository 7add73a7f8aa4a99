#include "harness/hunt/sensitivity.h"

#include "harness/hunt/dice.h"
#include "harness/study/relations.h"
#include "harness/study/runner.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

namespace cylon::hunt {
namespace {

using core::Scene;

constexpr double perturbation = 1e-6;

// Everything by a millionth, as far as joints and surfaces allow.
Scene perturbed(Scene scene, Dice& dice, double length, double speed) {
  const auto by = [&](double& x) { x *= 1 + perturbation * dice.between(-1, 1); };
  std::vector<bool> joined(scene.bodies.size());
  for (const core::Joint& joint : scene.joints)
    for (const int body : {joint.body, joint.to})
      if (body != core::world) joined[static_cast<std::size_t>(body)] = true;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    core::Body& body = scene.bodies[i];
    if (body.locked) continue;
    by(body.mass);
    body.inertia *= 1 + perturbation * dice.between(-1, 1);
    if (joined[i]) continue;
    core::BodyState& start = body.initial;
    start.position += perturbation * length * dice.vector(1);
    start.velocity += perturbation * speed * dice.vector(1);
    const core::Vector3 turn = perturbation * dice.vector(1);
    start.orientation =
        (core::Quaternion(1, turn.x() / 2, turn.y() / 2, turn.z() / 2) * start.orientation).normalized();
  }
  for (core::Force& force : scene.forces) {
    if (auto* spring = std::get_if<core::Spring>(&force)) by(spring->stiffness), by(spring->rest_length);
    if (auto* gravity = std::get_if<core::UniformGravity>(&force)) by(gravity->acceleration.y());
  }
  for (core::Material& material : scene.materials) {
    by(material.friction);
    if (material.restitution < 1) by(material.restitution);
  }
  return scene;
}

}  // namespace

double sensitivity(const Trial& trial, const process::EngineChoice& engine, const process::Limits& limits) {
  const study::Scales scales = study::scales(trial.scene, trial.step * static_cast<double>(trial.steps));
  const study::Runner run = study::worker_runner(engine, limits);
  double most = 0;
  try {
    const core::Recording plain = run(trial.scene, trial.step, 2 * trial.steps, 1);
    for (std::uint64_t n = 0; n < 3; ++n) {
      Dice dice(17, n);
      const core::Recording other =
          run(perturbed(trial.scene, dice, scales.length, scales.speed), trial.step, 2 * trial.steps, 1);
      for (std::size_t i = 0; i < plain.states.size(); ++i)
        most = std::max(most, study::apart(plain.states[i], other.states[i], scales));
    }
  } catch (const study::RunFailed&) {
    return std::numeric_limits<double>::infinity();
  }
  return most / perturbation;
}

}  // namespace cylon::hunt
