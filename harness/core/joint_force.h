// The force and the torque that a joint exerts on its body: what an engine tells of its last step, against what the
// required motion asks for.
//
// A part of the scene that one joint alone holds gets from it what its momenta lack (Newton, Euler).  Over the
// last step, from T - h to T, means of the force F and of the torque N about the joint's point are
//
//   F h = p(T) - p(T - h) - int F_a dt
//   N h = L(T) - L(T - h) - int (M_a - v x p) dt
//
// with p the momentum of the part, L its angular momentum about the point, which moves with the velocity v, and F_a,
// M_a all other forces on the part and their moment about the point.  The point is that which `Joint::body` carries;
// axes are those of the world.  F and N act on `body`, their opposites on `to`.
//
// No acceleration is needed, so that any truth serves that knows places and velocities at all times.
#pragma once

#include "harness/core/claim.h"
#include "harness/core/observable.h"

#include <optional>
#include <string>

namespace cylon::core {

struct Recording;

/// Why the motion does not say what the joints exert that are asked for: a loop, a contact between the part and the
/// rest, something that acts along the joint's own coordinate, a force whose law is not known, no joint that can move.
std::optional<std::string> joint_force_undefined(const Observable&, const Scene&);

/// What the recording lacks, in words, or nothing.
std::optional<std::string> joint_force_untold(const Observable&, const Scene&, const Recording&);

/// One entry for each joint that is asked for: the mean over the last step [N] or [N m], as the engine tells it.  Requires
/// that nothing is untold; NaN where a state is.
Values told_joint_forces(const Observable&, const Scene&, const Recording&);

struct RequiredForces {
  Values values;     ///< In the order of told_joint_forces.
  double error = 0;  ///< Bound on the error of each, of the truth and of the quadrature; grows as 1/h.
};

/// The same of a motion, over the step of h that ends at `end` [s].
RequiredForces required_joint_forces(const Observable&, const Scene&, const Truth&, double end, double h);

/// The largest size of any of them in the course of the motion: means over 256 equal parts of [0, until].
double largest_joint_force(const Observable&, const Scene&, const Truth&, double until);

}  // namespace cylon::core
