#include "harness/hunt/oracle.h"

#include "harness/core/force_law.h"
#include "harness/core/input_error.h"
#include "harness/hunt/dice.h"
#include "harness/scenario/scenario.h"
#include "harness/study/cell.h"
#include "harness/study/metamorphic.h"
#include "harness/study/relations.h"
#include "harness/study/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace cylon::hunt {
namespace {

using core::Scene;
using Reason = std::optional<std::string>;
using results::Status;
using results::Verdict;

// ---- Where an oracle has nothing to say -----------------------------------------------------------------

Reason broken(const Scene& scene, const char* core::Broken::*law) {
  for (const core::Broken& force : core::broken_by(scene))
    if (force.*law) return force.*law;
  return {};
}

Reason held(const Scene& scene) {
  if (scene.frame) return "the frame moves";
  if (!scene.planes.empty()) return "planes are at rest";
  for (const core::Body& body : scene.bodies)
    if (body.locked) return "a body is locked";
  for (const core::Joint& joint : scene.joints)
    if (joint.to == core::world) return "a joint ends at the world";
  return {};
}

bool touching(const Scene& scene) {
  return core::any_touching_pair(scene, [](const core::Pair&) { return true; });
}

Reason not_isolated(const Scene& scene) {
  if (const Reason why = broken(scene, &core::Broken::momentum)) return why;
  return held(scene);
}

Reason loses_energy(const Scene& scene) {
  if (scene.frame) return "the frame moves";
  if (touching(scene)) return "blows and friction take energy";
  return broken(scene, &core::Broken::energy);
}

// Gravity, springs, attraction and drag give no energy; contacts and joints do not.
Reason may_gain_energy(const Scene& scene) {
  if (scene.frame) return "the frame moves";
  for (const core::Force& force : scene.forces)
    if (!std::holds_alternative<core::UniformGravity>(force) &&
        !std::holds_alternative<core::Spring>(force) && !std::holds_alternative<core::Attraction>(force) &&
        !std::holds_alternative<core::Drag>(force))
      return "a force does work";
  return {};
}

Reason touches_nothing(const Scene& scene) { return touching(scene) ? Reason() : Reason("nothing touches"); }

// A certified solution costs the cube of the number of its unknowns.
Reason too_dear(const Scene& scene) {
  if (touching(scene)) return "bodies touch";
  const auto moving = std::ranges::count_if(scene.bodies, [](const core::Body& b) { return !b.locked; });
  return moving > 2 ? Reason("more than two bodies move") : Reason();
}

Reason no_joints(const Scene& scene) { return scene.joints.empty() ? Reason("no joint") : Reason(); }

Reason no_axes(const Scene& scene) {
  for (const core::Joint& joint : scene.joints)
    if (core::kind_of(joint.type).turn != core::JointTurn::freely) return {};
  return "no joint keeps an axis";
}

// Boxes at rest, each with a face on the floor, or on a box with its middle within a tenth of that one's: so that no
// pile of less than twenty leans too far.
Reason not_at_rest(const Scene& scene) {
  if (scene.planes.size() != 1 || !scene.joints.empty() || scene.frame) return "not one floor";
  const core::Vector3 n = scene.planes[0].normal;
  if (scene.forces.size() != 1 || !std::holds_alternative<core::UniformGravity>(scene.forces[0]))
    return "not gravity alone";
  const core::Vector3 g = core::gravity(scene);
  if (!(g.dot(n) < 0) || g.cross(n).norm() > 1e-12 * g.norm()) return "gravity is not across the floor";
  std::vector<double> tops = {scene.planes[0].offset};
  std::vector<std::pair<double, const core::Body*>> by_height;
  for (const core::Body& body : scene.bodies) {
    const auto* box = std::get_if<core::Box>(&body.shape);
    if (!box || !body.collide || body.locked || body.gravity) return "not boxes alone";
    if (!body.initial.velocity.isZero(0) || !body.initial.angular_velocity.isZero(0))
      return "something moves";
    if (!body.collision_groups.empty() || !body.collision_mask.empty()) return "some do not touch";
    if (!body.initial.orientation.vec().isZero(0) || !n.isApprox(core::Vector3::UnitY()))
      return "a box is turned";
    by_height.emplace_back(body.initial.position.y(), &body);
  }
  for (const core::Body& body : scene.bodies) {
    const core::Vector3 half = std::get<core::Box>(body.shape).half_extents, at = body.initial.position;
    const double bottom = at.y() - half.y();
    if (std::abs(bottom - scene.planes[0].offset) < 1e-12) continue;
    const bool lies = std::ranges::any_of(scene.bodies, [&](const core::Body& below) {
      const core::Vector3 h = std::get<core::Box>(below.shape).half_extents, p = below.initial.position;
      return &below != &body && std::abs(p.y() + h.y() - bottom) < 1e-12 &&
             std::abs(at.x() - p.x()) < 0.1 * h.x() && std::abs(at.z() - p.z()) < 0.1 * h.z();
    });
    if (!lies) return "a box has nothing below it";
  }
  return {};
}

constexpr std::array all = {
    Oracle{"linear momentum", "what nothing holds keeps its momentum", "conserves = \"linear_momentum\"",
           1e-3, not_isolated},
    Oracle{"angular momentum", "what nothing holds keeps its angular momentum",
           "conserves = \"angular_momentum\"", 1e-3, not_isolated},
    Oracle{"energy", "without losses the energy stays", "conserves = \"energy\"\nsample = \"step\"", 1e-3,
           loses_energy},
    Oracle{"energy from nowhere", "the energy never rises: blows, friction, dampers and drag give none",
           "conserves = \"energy\"\nmeasure = \"increase\"\nsample = \"step\"", 1e-3, may_gain_energy},
    Oracle{"penetration", "solids do not pass into each other",
           "conserves = \"normal_gap\"\nsample = \"step\"", 5e-3, touches_nothing},
    Oracle{"joint gap", "what a joint joins stays together", "conserves = \"joint_gap\"\nsample = \"step\"",
           1e-3, no_joints},
    Oracle{"joint axis", "what a joint does not let turn does not turn",
           "conserves = \"angular_joint_gap\"\nsample = \"step\"", 1e-3, no_axes},
    Oracle{"rest", "what stands at rest stays there", "conserves = \"position\"\nsample = \"step\"", 1e-3,
           not_at_rest},
    Oracle{"place", "the places are those of the certified solution",
           "follows = \"certified\"\nobservable = \"position\"", 1e-3, too_dear, true},
    Oracle{"turn", "the turns are those of the certified solution",
           "follows = \"certified\"\nobservable = \"orientation\"", 1e-3, too_dear, true},
};

// ---- Asking -------------------------------------------------------------------------------------------------

// What is left of a fault when the step is halved; of an error of first order 1/2.  An error so large that it cannot
// grow falls slowly at first, so that more is asked of the last step.
constexpr double falls = 0.75, falls_in_the_end = 0.9;
constexpr double most_sensitive = 100;  // beyond it oracles of trajectories are silent
constexpr double perturbation = 1e-6;

std::string claim_of(const Oracle& oracle) {
  return fmt::format(
      "[[claim]]\n{}\ntolerance = {{ relative = {}, reason = \"convention: ten times this is a fault\" }}\n",
      oracle.claim, oracle.relative);
}

std::optional<scenario::Scenario> scenario_of(const Trial& trial, const std::string& claim) {
  try {
    scenario::Scenario scenario = scenario::parse(to_toml(trial, claim), "hunted.toml");
    if (!scenario::prepare_soon(scenario)) return std::nullopt;
    return scenario;
  } catch (const core::InputError&) {
    return std::nullopt;  // the claim cannot be made here
  }
}

class Examination {
 public:
  Examination(Trial trial, const process::EngineChoice& engine, const process::Limits& limits,
              const std::string& only)
      : trial_(std::move(trial)), engine_(engine), limits_(limits), only_(only) {}

  std::vector<Fault> faults() {
    const auto plain = scenario_of(trial_, "");
    if (!plain) return {};
    trial_.scene = plain->scene;  // as a reader of the file has it
    if (!runs()) return std::move(found_);
    ask_claims();
    ask_relations();
    return std::move(found_);
  }

 private:
  bool wanted(std::string_view name) const { return only_.empty() || only_ == name; }
  bool sensitive() {
    if (!sensitivity_) sensitivity_ = sensitivity(trial_, engine_, limits_);
    return !(*sensitivity_ <= most_sensitive);
  }

  // Whether the run comes to its end; else that is the fault, unless the engine refuses the scene.  Numbers that
  // end at a coarse step alone are an unstable scheme's, and no fault.
  bool runs() {
    const process::RunOutcome outcome = outcome_at(0);
    if (outcome.status == Status::unsupported || outcome.status == Status::fail) return false;
    Fault fault;
    fault.says = "a run comes to its end, with numbers";
    fault.detail = outcome.reason;
    if (outcome.status == Status::pass) {
      if (!core::first_bad_step(*outcome.recording)) return true;
      for (std::size_t i = 1; i < halvings; ++i)
        if (const process::RunOutcome finer = outcome_at(i);
            finer.status != Status::pass || !core::first_bad_step(*finer.recording))
          return false;
      fault.detail = "not a number, at every step";
    }
    fault.oracle = results::name(outcome.status == Status::pass ? Status::non_finite : outcome.status);
    if (wanted(fault.oracle)) found_.push_back(std::move(fault));
    return false;
  }

  process::RunOutcome outcome_at(std::size_t i) {
    process::RunRequest request;
    request.scene = &trial_.scene;
    request.setup.dt = trial_.step / static_cast<double>(1 << i), request.steps = trial_.steps << i;
    return process::run(engine_, request, limits_);
  }

  // All claims that can be made of the scene, of one run at each step.
  void ask_claims() {
    std::vector<const Oracle*> asked;
    std::string own, truths;
    for (const Oracle& oracle : all) {
      if (!wanted(oracle.name) || oracle.undefined_in(trial_.scene)) continue;
      const std::string claim = claim_of(oracle);
      if (!oracle.of_trajectories && !scenario_of(trial_, claim)) continue;  // none to be made here
      asked.push_back(&oracle);
      (oracle.of_trajectories ? truths : own) += claim;
    }
    std::optional<scenario::Scenario> scenario = scenario_of(trial_, own + truths);
    if (!scenario) {  // no certified solution
      scenario = scenario_of(trial_, own);
      std::erase_if(asked, [](const Oracle* oracle) { return oracle->of_trajectories; });
    }
    if (!scenario || asked.empty()) return;
    std::vector<Fault> open;
    for (const Oracle* oracle : asked)
      open.push_back(
          {std::string(oracle->name), std::string(oracle->says), {}, 0, "", claim_of(*oracle), ""});
    std::vector<bool> stays_open(asked.size(), true);
    for (std::size_t i = 0; i < halvings && std::ranges::count(stays_open, true) > 0; ++i) {
      const std::vector<Verdict> rows = ask(*scenario, i, study::Exam::claims);
      for (std::size_t k = 0; k < asked.size(); ++k)
        stays_open[k] = stays_open[k] && note(open[k], rows.at(k), i);
    }
    for (std::size_t k = 0; k < asked.size(); ++k)
      if (stays_open[k] && !(asked[k]->of_trajectories && sensitive())) found_.push_back(std::move(open[k]));
  }

  // Enters what came of the i-th step; whether the fault may still be one.
  static bool note(Fault& fault, const Verdict& row, std::size_t i) {
    if (row.status == Status::unsupported) return false;
    fault.measured[i] = row.measured, fault.allowed = row.allowed, fault.unit = row.unit;
    if (std::isnan(row.measured)) return true;
    if (!(row.measured > 10 * row.allowed)) return false;
    const double left = i + 1 < halvings ? falls : falls_in_the_end;
    return i == 0 || !(row.measured < left * fault.measured[i - 1]);
  }

  std::vector<Verdict> ask(const scenario::Scenario& scenario, std::size_t i, study::Exam exam) {
    study::Cell cell;
    cell.scenario = &scenario, cell.engine = engine_, cell.exam = exam;
    cell.dt = trial_.step / static_cast<double>(1 << i), cell.dt_text = fmt::format("{}", cell.dt);
    return exam == study::Exam::relations ? study::relate(cell, limits_, {}) : study::run(cell, limits_, {});
  }

  void ask_relations() {
    if (!only_.empty() && !only_.starts_with("relation ")) return;
    const auto scenario = scenario_of(trial_, "");
    if (!scenario) return;
    std::map<std::string, Fault> open;
    for (std::size_t i = 0; i < halvings && (i == 0 || !open.empty()); ++i) {
      std::map<std::string, Fault> still;
      for (const Verdict& row : ask(*scenario, i, study::Exam::relations)) {
        // A scheme that damps runs back as far as its truncation lets it, which need not fall from step to step.
        if (row.claim == "relation time reversal") continue;
        if (!wanted(row.claim) || (i > 0 && !open.contains(row.claim))) continue;
        Fault fault = i > 0 ? open[row.claim] : Fault{row.claim, row.tolerance_reason, {}, 0, "", "", ""};
        if (note(fault, row, i)) still[row.claim] = std::move(fault);
      }
      open = std::move(still);
    }
    for (auto& [name, fault] : open)
      if (fault.allowed == 0 || !sensitive()) found_.push_back(std::move(fault));
  }

  Trial trial_;
  const process::EngineChoice& engine_;
  const process::Limits& limits_;
  std::string only_;
  std::optional<double> sensitivity_;
  std::vector<Fault> found_;
};

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

std::span<const Oracle> oracles() { return all; }

std::vector<Fault> examine(const Trial& trial, const process::EngineChoice& engine,
                           const process::Limits& limits, const std::string& only) {
  return Examination(trial, engine, limits, only).faults();
}

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
