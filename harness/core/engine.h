// What harness and engine tell each other, as data: what an engine says of itself, what a run asks of it,
// with what terms it ran.  Knows no Simulator.
#pragma once

#include "harness/core/scene.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::core {

/// One setting of an engine: what it is here, what the engine would take by itself, and why they differ.
struct Setting {
  std::string name, value, engine_default, reason;
};

/// A named, complete table of an engine's settings, and a row of its own in every report.
struct Path {
  std::string name;  ///< "rigid", "rigid-bounce", "multibody", "step", …
  std::string summary;
  std::vector<Setting> settings;         ///< Everything that is forced.
  std::vector<std::string> unforceable;  ///< What the engine does all the same, one sentence each.
};

/// A time integrator that an engine offers.
struct Integrator {
  std::string name;
  int order = 1;          ///< Of the global error in smooth motion.
  std::string conserves;  ///< In words; "" for nothing in particular.
  bool adaptive = false;  ///< Chooses its own steps; takes a tolerance, and dt is then the sample grid alone.
};

/// A knob that a variant may turn: `bullet/gyro=none`.
struct Option {
  std::string name;
  std::vector<std::string> values;  ///< Allowed; empty: a number.
  std::string engine_default;
  std::string meaning;
};

/// What an engine says of itself before it has seen a scene.
struct Engine {
  std::string name;                     ///< "in-house", "bullet", "ode".
  std::string version;                  ///< "3.24"
  std::string precision;                ///< "double" or "float".
  std::vector<Path> paths;              ///< The first is the default where default_path says nothing else.
  std::string default_path_rule;        ///< How the default path follows from the Scene, in words.
  std::vector<Integrator> integrators;  ///< The first is the default.
  std::vector<Option> options;
  std::vector<std::string> knows = {};  ///< Words of core::later_parts, which engines may not know.

  /// The integrator of that name; null where the engine lists none.
  const Integrator* integrator(std::string_view called) const {
    const auto at = std::ranges::find(integrators, called, &Integrator::name);
    return at == integrators.end() ? nullptr : &*at;
  }
};

/// From 1 to the next number of that precision.
constexpr double epsilon_of_double = 0x1p-52, epsilon_of_float = 0x1p-23;
inline double epsilon(const Engine& engine) {
  return engine.precision == "float" ? epsilon_of_float : epsilon_of_double;
}

/// What a run asks of a simulator.
struct Setup {
  double dt = 0;                               ///< Step; of an adaptive integrator the sample grid [s], > 0.
  std::string path;                            ///< "": a published function of the Scene alone.
  std::string integrator;                      ///< "": the engine's default.
  std::map<std::string, std::string> options;  ///< Settings overridden by a variant or a suite.
  /// Of an adaptive integrator: bound on the global error at the samples, relative to the scales of the
  /// motion, > 0; 0: the engine's own.
  double tolerance = 0;
  bool force = false;  ///< Run what the engine would refuse as too hard for it, where it can express it.
};

/// A part of an engine's work on a scene, and why it is done or left out.
struct Stage {
  std::string name;    ///< "rotation", "broad phase", …
  bool in = false;     ///< Whether it is done.
  std::string reason;  ///< What in the scene decides it, one sentence.
};

/// What a run was really made with; stored with each verdict.
struct Terms {
  std::string path;
  std::string integrator;
  int order = 1;           ///< Of the integrator, in smooth motion.
  std::string gyroscopic;  ///< "exact", "implicit", "explicit", "none", …
  std::vector<Setting> settings;
  std::vector<std::string> unforceable;
  std::vector<Stage> plan;   ///< What the engine does for this scene, in its order; empty: it does not tell.
  bool closed_form = false;  ///< States are formulas of time: no steps, and dt is the sample grid alone.
  int substeps =
      1;  ///< Parts of each step, each with gravity of its own: the engine's real step is dt over this.
};

/// Whether a run on these terms chose its own steps.
inline bool controls_its_error(const Engine& engine, const Terms& terms) {
  const Integrator* ran = engine.integrator(terms.integrator);
  return ran && ran->adaptive;
}

/// What came of a scene that an engine was given.
struct Loaded {
  std::optional<std::string> unsupported = {};  ///< Why it cannot express the scene; else the terms hold.
  Terms terms = {};
};

/// A point at which two surfaces pressed on each other during a step.
struct Contact {
  Pair pair;
  Vector3 point = Vector3::Zero();    ///< World [m].
  Vector3 normal = Vector3::UnitY();  ///< World, unit, towards pair.body.
  std::optional<double>
      impulse;  ///< Along the normal, over the step [N s]; absent: the engine does not tell.
  std::optional<Vector3>
      friction;  ///< On pair.body, across the normal, over the step, world axes [N s]; absent: not told.
};

/// What a force did since t = 0.
struct Work {
  std::string force;  ///< In words, with the bodies on which it acts: "a spring on 'a', 'b'".
  double work = 0;    ///< On the bodies, of force and torque [J].
};

/// What a joint did to `Joint::body` during a step, world axes; to `Joint::to` the opposite, at the same point.
struct Reaction {
  std::size_t joint = 0;              ///< Index in Scene::joints.
  Vector3 point = Vector3::Zero();    ///< Where the impulse acts [m].
  Vector3 impulse = Vector3::Zero();  ///< Of the force, over the step [N s].
  Vector3 moment = Vector3::Zero();   ///< Of the torque beside that of the impulse, over the step [N m s].
};

}  // namespace cylon::core
