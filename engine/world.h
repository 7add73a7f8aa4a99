// A running simulation: carries a model through time by the plan that its scene asks for.
#pragma once

#include "engine/changing_masses.h"
#include "engine/plan.h"
#include "engine/reduce.h"
#include "engine/stepper.h"

#include <cstdint>
#include <memory>

namespace cylon::engine {

class Ballistic;

class World {
 public:
  /// Starts at t = 0.  Requires unsupported(model, options) to be empty, options.dt > 0, one motion and one
  /// shape per body.
  World(Model, const Options&);
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World();

  /// Advances by exactly one step.
  void step();

  /// Advances by n steps, n >= 1: the bits of as many step(), for less, as nothing is read between them.
  /// impacts() are then those of the last.
  void advance(std::int64_t n);

  Time time() const { return static_cast<Time>(steps_) * options_.dt; }
  const Plan& plan() const { return plan_; }

  /// The bodies as given, with their masses now; velocity() and angular_velocity() of a motion that was read
  /// need them.
  const std::vector<Body>& bodies() const { return model_.bodies; }

  /// The motion now, of centres of mass.
  const std::vector<Motion>& motions() const { return motions_; }

  /// The impacts of the last step, in order of time.
  const std::vector<Impact>& impacts() const { return impacts_; }

  /// Whether contacts() is wanted of the steps to come; the motion is the same.
  void keep_contacts(bool keep) { stepper_->keep_contacts(keep_contacts_ = keep); }

  /// The contacts of the last step, if it was made with contacts kept.
  const std::vector<Contact>& contacts() const { return stepper_->contacts(); }

  /// The work done by each force since t = 0 [J], gravity first, in the order of Forces; null where not
  /// accounted.
  const Real* works() const { return stepper_->works(); }

  /// What a user must know of the run so far.
  std::vector<std::string> remarks() const;

 private:
  void hand_over();

  Model model_;
  ChangingMasses masses_;
  Options options_;
  Plan plan_;
  std::unique_ptr<Stepper> stepper_;
  Ballistic* ballistic_ = nullptr;  // stepper_, while it is one
  std::vector<std::string> remarks_;
  std::vector<Motion> motions_;
  std::vector<Impact> impacts_;
  std::int64_t steps_ = 0;
  bool keep_contacts_ = false;
};

}  // namespace cylon::engine
