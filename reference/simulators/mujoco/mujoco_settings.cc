#include "reference/simulators/mujoco/mujoco_settings.h"

#include "reference/applied/forces.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

using core::Setting;
constexpr const char* asked_for = "asked for by the run";

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

// One setting of a path where a scene is of a kind; "integrator" is one here.
struct Rule {
  const char *path, *option, *value;
  bool (*holds)(const MujocoKind&);
  const char *where, *reason;
};

constexpr Rule rules[] = {
    {"as-expert", "integrator", "rk4", is_smooth, "where nothing can touch and no joint closes a loop",
     "of order 4, or 2 where a body turns freely"},
    {"as-expert", "cone", "elliptic", rubs, "where a pair has friction",
     "friction is then the same in all directions"},
    {"as-expert", "noslip-iterations", "10", rubs, "where a pair has friction", "what sticks must not creep"},
};

void set(MujocoSettings& run, const std::string& option, const std::string& value) {
  if (option == "integrator")
    run.integrator = value;
  else
    mujoco_set(run.values, option, value);
}

// A setting as reports show it.
Setting setting(const MujocoSettings& run, const std::string& option, const std::string& reason) {
  if (option == "integrator") return {"integrator", run.integrator, "euler", reason};
  const MujocoOption& one = mujoco_option(option);
  return {one.setting, mujoco_text(one, run.at(option)), mujoco_text(one, one.engine_default), reason};
}

core::Path path(const char* name, std::string summary) {
  core::Path result{name, std::move(summary), of_the_scene(), unforceable()};
  for (const Rule& rule : rules) {
    if (std::string_view(rule.path) != name) continue;
    MujocoSettings there;
    set(there, rule.option, rule.value);
    result.settings.push_back(setting(there, rule.option, fmt::format("{}: {}", rule.where, rule.reason)));
  }
  return result;
}

template <class Named>
std::vector<std::string> names(const std::vector<Named>& all) {
  std::vector<std::string> result;
  for (const Named& one : all) result.push_back(one.name);
  return result;
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
  engine.knows = {"collision_filters"};
  for (const MujocoOption& one : mujoco_options())
    engine.options.push_back({one.name, one.words, mujoco_text(one, one.engine_default), one.meaning});
  return engine;
}

MujocoSettings mujoco_settings(const core::Engine& engine, const core::Setup& setup, const MujocoKind& kind) {
  if (!setup.path.empty()) mujoco_require("path", setup.path, names(engine.paths));
  if (!setup.integrator.empty()) mujoco_require("integrator", setup.integrator, names(engine.integrators));
  MujocoSettings run;
  if (!setup.path.empty()) run.path = setup.path;
  for (const Rule& rule : rules)
    if (rule.path == run.path && rule.holds(kind)) {
      set(run, rule.option, rule.value);
      run.reasons[rule.option] = rule.reason;
    }
  if (!setup.integrator.empty()) {
    run.integrator = setup.integrator;
    run.reasons["integrator"] = asked_for;
  }
  for (const auto& [name, value] : setup.options) {
    mujoco_set(run.values, name, value);
    run.reasons[name] = asked_for;
  }
  return run;
}

core::Terms mujoco_terms(const MujocoSettings& run, const MujocoKind& kind) {
  core::Terms terms{run.path,         run.integrator,
                    order(run, kind), run.integrator == "implicit" ? "implicit" : "explicit",
                    of_the_scene(),   unforceable()};
  for (const auto& [option, reason] : run.reasons) terms.settings.push_back(setting(run, option, reason));
  return terms;
}

}  // namespace cylon::simulators
