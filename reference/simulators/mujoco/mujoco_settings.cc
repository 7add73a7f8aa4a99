#include "reference/simulators/mujoco/mujoco_settings.h"

#include "reference/applied/forces.h"
#include "reference/simulators/mujoco/mujoco_options.h"

#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

using core::Setting;

// ---- What holds on every path ---------------------------------------------------------------------

std::vector<Setting> of_the_scene() {
  return {
      {"timestep", "dt", "0.002", "one mj_step is one step"},
      {"inertial", "of the scene", "from the geoms and their density",
       "mass and inertia are those of the scene, whatever the shape; diaginertia in principal axes"},
      {"friction, condim", "of the pair", "the larger of both geoms', 3",
       "one coefficient on all geoms, or a <pair> each where pairs differ; condim 1 without friction"},
      {"filterparent", "disable", "enable",
       "bodies that a joint ties do not touch (<exclude>), all others do, also those that hang on one body"},
      {"njmax, nconmax, nstack", "for the scene", "500, 100, by the first",
       "room for all contacts; where it is too small, the run ends with a sentence"},
      {applied::applied_forces, "mjcb_passive, at each evaluation of the acceleration", "none",
       "the engine has no such forces; Runge-Kutta 4 evaluates them four times in a step, the others once"},
      {"after a bad state", "not a number", "qpos0 and rest",
       "MuJoCo resets a simulation that diverges, with a warning; here the run shows that it did"},
  };
}

// What MuJoCo does all the same; in brackets the place in the sources of 2.2.2, below src/.
std::vector<std::string> unforceable() {
  return {
      "There is no coefficient of restitution: a contact is a damped spring, and a bounce would be a choice "
      "of "
      "its stiffness (doc/modeling.rst:1357, engine/engine_core_constraint.c:1450).",
      "Force and separation need not exclude each other: where a body slides, the contact also pushes it "
      "off, "
      "and it hops (doc/computation.rst:38).",
      "Contacts and closed loops are soft: what is loaded yields, by an impedance below 1 "
      "(engine/engine_core_constraint.c:1023).",
      "Friction yields as well: what should stick creeps; noslip-iterations and impratio reduce it "
      "(engine/engine_core_constraint.c:1194).",
      "With euler the gyroscopic torque is explicit, as all velocities are but joint damping "
      "(engine/engine_forward.c:487).",
      "Runge-Kutta 4 is of order 2 where a body turns freely: it averages angular velocities of body axes "
      "that "
      "have turned in between (engine/engine_forward.c:639, engine/engine_support.c:1199).",
      "A coefficient of friction below 1e-5 acts as 1e-5 (engine/engine_collision_driver.c:720).",
      "A position or velocity beyond 1e10 counts as bad (engine/engine_util_misc.c:990).",
      "Contacts are detected at one instant, so an impact acts up to one step late; there is no continuous "
      "collision detection (engine/engine_forward.c:92).",
      "The vertices of hulls are stored in single precision (include/mujoco/mjmodel.h:734).",
      "A step runs on one thread.",
  };
}

// ---- What the paths set, as a table -----------------------------------------------------------------

bool is_smooth(const MujocoKind& kind) { return !kind.touches && !kind.loops; }
bool rubs(const MujocoKind& kind) { return kind.rubs; }

constexpr applied::RuleFor<MujocoKind> rules[] = {
    {{"as-expert", "integrator", "rk4", "where nothing can touch and no joint closes a loop",
      "of order 4, or 2 where a body turns freely"},
     is_smooth},
    {{"as-expert", "cone", "elliptic", "where a pair has friction",
      "friction is then the same in all directions"},
     rubs},
    {{"as-expert", "noslip-iterations", "10", "where a pair has friction", "what sticks must not creep"},
     rubs},
};

core::Path path(const char* name, std::string summary) {
  return applied::path(name, std::move(summary), mujoco_as_shipped(), mujoco_options(), applied::all(rules),
                       of_the_scene(), unforceable());
}

// Of the global error on this scene.
int order(const MujocoSettings& run, const MujocoKind& kind) {
  if (run.integrator != "rk4" || kind.touches || kind.changes) return 1;
  return kind.turns ? 2 : 4;
}

}  // namespace

core::Engine mujoco_engine(std::string version) {
  core::Engine engine{
      "mujoco",
      std::move(version),
      "double",
      {path("as-shipped", "every setting as MuJoCo has it by itself"),
       path("as-expert", "one rule for all scenes; its settings say where they hold")},
      "always 'as-shipped'",
      {{"euler", 1, "linear momentum"},
       {"implicit", 1, "linear momentum; velocities implicit, the gyroscopic torque too; not applied forces"},
       {"rk4", 4,
        "nothing in particular; order 2 where a body turns freely, 1 with contacts or a mass that changes"}},
      {}};
  engine.knows = {"collision_filters",  "frame_acceleration",      "body_gravity",     "slider_joints",
                  "cylindrical_joints", "planar_joints",           "universal_joints", "gimbal_joints",
                  "rectangular_joints", "offset_universal_joints", "joint_forces",     "joint_targets",
                  "joint_limits",       "joint_friction",          "joint_armature"};
  engine.options = mujoco_options().offered();
  return engine;
}

MujocoSettings mujoco_as_shipped() { return {"as-shipped", "euler", mujoco_options().defaults(), {}}; }

MujocoSettings mujoco_settings(const core::Engine& engine, const core::Setup& setup, const MujocoKind& kind) {
  return applied::chosen(mujoco_as_shipped(), mujoco_options(), engine, setup, applied::holding(rules, kind));
}

core::Terms mujoco_terms(const MujocoSettings& run, const MujocoKind& kind) {
  core::Terms terms{run.path,         run.integrator,
                    order(run, kind), run.integrator == "implicit" ? "implicit" : "explicit",
                    of_the_scene(),   unforceable()};
  for (const auto& [option, reason] : run.reasons)
    terms.settings.push_back(applied::shown(run, mujoco_as_shipped(), mujoco_options(), option, reason));
  return terms;
}

}  // namespace cylon::simulators
