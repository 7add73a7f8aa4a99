// One way to carry a model through time.  World holds the one that the plan chose.
#pragma once

#include "engine/body.h"
#include "engine/diagnostic.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace cylon::engine {

/// One impact.
struct Impact {
  Time time = 0;            ///< [s]
  int body = 0;             ///< The first body.
  int other = fixed_world;  ///< The second; the world where it is a plane.
  int plane = -1;           ///< Index in Model::planes, or -1.
  Real approach = 0;        ///< Speed at which the surfaces met [m/s], >= 0.
  Real separation = 0;      ///< Speed at which they part [m/s], >= 0.
};

/// Where surfaces pressed on each other in a step.
struct Contact {
  int body = 0;                       ///< The first body.
  int other = fixed_world;            ///< The second; the world where it is a plane.
  int plane = -1;                     ///< Index in Model::planes, or -1.
  Vector3 point = Vector3::Zero();    ///< World axes [m].
  Vector3 normal = Vector3::UnitY();  ///< Unit, towards `body`.
  std::optional<Real> impulse = {};   ///< Along the normal, over the step [N s]; absent: not known.
  std::optional<Vector3> friction =
      {};  ///< On `body`, across the normal, over the step [N s]; absent: not known.
};

class Stepper {
 public:
  virtual ~Stepper() = default;

  /// Advances from t_n = n dt to t_{n+1}.
  virtual void step() = 0;

  /// Advances by n steps, n >= 1, none of which is looked at: the same motion, where a stepper can for less.
  /// Impacts are those of the last step.
  virtual void advance(std::int64_t n) {
    while (n-- > 0) step();
  }

  /// The motion now, one per body of the model.  Resizes; what has that size already may keep the motions of
  /// bodies that are locked.
  virtual void read(std::vector<Motion>&) const = 0;

  /// For each law on a coordinate (Forces::coordinate_laws) what its angle is near to now, which the motions do not
  /// tell; empty where a method takes none.
  virtual void read_turns(std::vector<Real>&) const = 0;

  /// The impacts of the last step, in order of time; none where nothing can touch.
  virtual const std::vector<Impact>& impacts() const {
    static const std::vector<Impact> none;
    return none;
  }

  /// Whether velocities jumped in the last step.
  virtual bool struck() const { return !impacts().empty(); }

  /// Whether contacts() is wanted of the steps to come; the motion is the same.
  virtual void keep_contacts(bool keep) { keep_ = keep; }

  /// The contacts of the last step, if it was made with contacts kept: impacts, and what lasts.
  virtual const std::vector<Contact>& contacts() const { return contacts_; }

  /// The work done by each force since t = 0 [J], gravity first (engine/forces.h); null where it is not
  /// accounted.
  virtual const Real* works() const { return nullptr; }

  /// Work done so far, in operations of the computer to a factor of a few (engine/operations.h): the same for
  /// the same input, whatever the machine.  Grows with every step.
  virtual std::int64_t operations() const = 0;

  /// The order in dt of all steps so far, where what happens in them decides it; else nothing: it is the plan's.
  virtual std::optional<int> order_so_far() const { return std::nullopt; }

  /// Whether a part of the run so far went in a way that no smaller tolerance makes better.
  virtual bool gave_up() const { return false; }

  /// Whether it gave up for want of operations: a larger tolerance may need fewer.
  virtual bool ran_out() const { return false; }

  /// What a user must know of the run so far: a tolerance that could not be kept, a cap that was hit.  Empty:
  /// nothing.
  virtual std::vector<Diagnostic> diagnostics() const { return {}; }

 protected:
  bool keep_ = false;
  std::vector<Contact> contacts_;
};

}  // namespace cylon::engine
