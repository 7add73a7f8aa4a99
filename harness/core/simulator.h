// The one seam between the harness and whatever computes the motion.
// A simulator gets a Scene and a Setup; it never learns which scenario it runs.
#pragma once

#include "harness/core/scene.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
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

/// A time-stepping scheme that an engine offers.
struct Scheme {
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
  std::string name;               ///< "in-house", "bullet", "ode".
  std::string version;            ///< "3.24"
  std::string precision;          ///< "double" or "float".
  std::vector<Path> paths;        ///< The first is the default where default_path says nothing else.
  std::string default_path_rule;  ///< How the default path follows from the Scene, in words.
  std::vector<Scheme> schemes;    ///< The first is the default.
  std::vector<Option> options;
};

/// What a run asks of a simulator.
struct Setup {
  double dt = 0;                               ///< Step; of an adaptive scheme the sample grid [s], > 0.
  std::string path;                            ///< "": a published function of the Scene alone.
  std::string integrator;                      ///< "": the engine's default.
  std::map<std::string, std::string> options;  ///< Settings overridden by a variant or a suite.
  /// Of an adaptive scheme: bound on the global error at the samples, relative to the scales of the motion,
  /// > 0; 0: the engine's own.
  double tolerance = 0;
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
  std::vector<Stage> plan;  ///< What the engine does for this scene, in its order; empty: it does not tell.
};

/// A point at which two surfaces pressed on each other during a step.
struct Contact {
  Pair pair;
  Vector3 point = Vector3::Zero();    ///< World [m].
  Vector3 normal = Vector3::UnitY();  ///< World, unit, towards pair.body.
  std::optional<double>
      impulse;  ///< Along the normal, over the step [N s]; absent: the engine does not tell.
};

/// A machine that advances a Scene in fixed steps.
class Simulator {
 public:
  virtual ~Simulator() = default;

  virtual const Engine& engine() const = 0;

  /// Why this simulator cannot express the scene, or nothing when it can.
  virtual std::optional<std::string> unsupported(const Scene&, const Setup&) const = 0;

  /// Starts over from the scene's initial state.  Requires unsupported(scene, setup) to be empty.
  /// Throws std::invalid_argument, naming the nearest valid one, for an unknown path, integrator or option.
  virtual Terms load(const Scene&, const Setup&) = 0;

  /// Advances by exactly one dt.
  virtual void step() = 0;

  /// Advances by n steps, n >= 1, between which nothing is read: the bits of as many step().
  virtual void advance(std::int64_t n) {
    while (n-- > 0) step();
  }

  /// Current motion, read from the engine's own state, into one BodyState per body of the scene.
  virtual void read(State&) const = 0;

  /// What a user must know of the run so far, a sentence each: a tolerance that could not be kept, and the
  /// best that was reached.  Empty: nothing.
  virtual std::vector<std::string> remarks() const { return {}; }

  /// Whether contacts() will be asked for after the next step; some engines must know before it.  Changes
  /// nothing in the motion.
  virtual void keep_contacts(bool) {}

  /// Where surfaces pressed on each other in the last step, which began with contacts kept.  Empty: nowhere,
  /// or the engine does not tell.
  virtual std::vector<Contact> contacts() const { return {}; }
};

/// The engine build that is linked into this executable; each sim_* library defines it once.
std::unique_ptr<Simulator> make_simulator();

}  // namespace cylon::core
