// The one seam between the harness and whatever computes the motion.
// A simulator gets a Scene and a Setup; it never learns which scenario it runs.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/scene.h"
#include "harness/told/diagnostic.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cylon::core {

/// A run that cannot go on, for a reason that what() says: a verdict, and no fault of the simulator.
struct GaveUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A machine that advances a Scene in fixed steps.
class Simulator {
 public:
  virtual ~Simulator() = default;

  virtual const Engine& engine() const = 0;

  /// Lets scenes name a plug-in, which is code in a shared library (cylon/force.h).  Throws std::invalid_argument where the
  /// name is taken, and where this simulator takes no plug-ins.
  virtual void admit(const std::string& name, const std::string& file) {
    throw std::invalid_argument(engine().name + " takes no plug-ins: " + name + " = " + file);
  }

  /// Why this simulator cannot express the scene, or nothing when it can.
  virtual std::optional<std::string> unsupported(const Scene&, const Setup&) const = 0;

  /// Starts over from the scene's initial state.  Requires unsupported(scene, setup) to be empty.
  /// Throws std::invalid_argument, naming the nearest valid one, for an unknown path, integrator or option.
  virtual Terms load(const Scene&, const Setup&) = 0;

  /// Both in one, for a simulator that translates the scene for either.
  virtual Loaded load_if_supported(const Scene& scene, const Setup& setup) {
    if (auto reason = unsupported(scene, setup)) return {.unsupported = std::move(reason)};
    return {.terms = load(scene, setup)};
  }

  /// Advances by exactly one dt.  Throws GaveUp where the run cannot go on.
  virtual void step() = 0;

  /// Advances by n steps, n >= 1, between which nothing is read: the bits of as many step().
  virtual void advance(std::int64_t n) {
    while (n-- > 0) step();
  }

  /// An impulse [N s] at the centre of mass of a body and an angular impulse [N m s] beside it, world axes, between two steps;
  /// joints answer at once.  Why it cannot be, or nothing when it is done.
  virtual std::optional<std::string> kick(int /*body*/, const Vector3& /*impulse*/,
                                          const Vector3& /*angular_impulse*/) {
    return engine().name + " takes no kicks between steps";
  }

  /// Current motion, read from the engine's own state, into one BodyState per body of the scene.
  virtual void read(State&) const = 0;

  /// What a user must know of the run so far, a sentence each: a tolerance that could not be kept, and the
  /// best that was reached.  Empty: nothing.
  virtual std::vector<std::string> remarks() const { return {}; }

  /// The same as data; each has a sentence of remarks() as its text.
  virtual std::vector<told::Diagnostic> diagnostics() const { return {}; }

  /// The work of each force since t = 0; empty: the run is not asked to account it, or the engine does not tell.
  virtual std::vector<Work> works() const { return {}; }

  /// Whether contacts() and reactions() will be asked for after the next step; some engines must know before
  /// it.  Changes nothing in the motion.
  virtual void keep_contacts(bool) {}

  /// Where surfaces pressed on each other in the last step, which began with contacts kept.  Empty: nowhere,
  /// or the engine does not tell.
  virtual std::vector<Contact> contacts() const { return {}; }

  /// What each joint that can move did in the last step, which began with contacts kept; absent: the engine
  /// does not tell.
  virtual std::optional<std::vector<Reaction>> reactions() const { return std::nullopt; }
};

/// The engine build that is linked into this executable; each sim_* library defines it once.
std::unique_ptr<Simulator> make_simulator();

}  // namespace cylon::core
