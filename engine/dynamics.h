// The right-hand side: state -> rates, and the way back onto the constraints.  Integrators see nothing else.
#pragma once

#include "engine/body.h"
#include "engine/contact.h"
#include "engine/forces.h"
#include "engine/joint.h"

#include <vector>

namespace cylon::engine {

/// The bodies and all that acts on them.
struct Model {
  std::vector<Body> bodies;
  Forces forces;
  std::vector<BallJoint> joints;
  std::vector<Contact> contacts;
};

class Dynamics {
 public:
  /// The motion at t = 0 decides, with the model, which bodies can ever turn.
  Dynamics(Model, const std::vector<Motion>&);

  /// dp/dt = v, dK/dt = F, dR/dt = w x R, dL/dt = torque (seed eq. 57-60, 72), the forces of joints and
  /// resting contacts included.  Time in [s].
  void rates(Real time, const std::vector<Motion>&, std::vector<Rate>&);

  /// Moves a state that has drifted off its joints and resting contacts back onto them, positions and then
  /// velocities.  The correction is as small as the scheme's own error of one step, so its order stays.
  void project(std::vector<Motion>&);

  std::vector<Body> bodies;
  Forces forces;
  std::vector<BallJoint> joints;
  std::vector<Contact> contacts;

  /// Whether a resting contact pushed when rates() was last called.
  bool pressed(std::size_t contact) const { return pressed_[contact]; }

 private:
  void gather(const std::vector<Motion>&, bool pressed_only);

  void find_turning(const std::vector<Motion>&);
  void constrain(const std::vector<Motion>&, std::vector<Rate>&);

  bool any_locked_ = false;
  bool constrained_ = false;
  Rows rows_;
  std::vector<char> pressed_;
};

}  // namespace cylon::engine
