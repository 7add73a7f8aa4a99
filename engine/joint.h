// Joints, as rows of constraints.
#pragma once

#include "engine/constraint.h"
#include "engine/model.h"

namespace cylon::engine {

/// How many rows a joint has: the degrees of freedom that it takes.
int row_count(Joint::Type);

/// What a joint is off by, and the space of what it forbids (a projection): of its place, with `apart` [m]
/// from the anchor on `to` to that on `body`, or of its turn, a rotation vector.  Not of what couples.
struct Misfit {
  Vector3 error = Vector3::Zero();
  Matrix3 space = Matrix3::Identity();
};
/// Of a joint with an offset as of one at a point: its blocks are two (engine/pile/body_contacts.cc).
Misfit misfit_of_place(const Joint&, const Vector3& apart, const Quaternion& to);
Misfit misfit_of_turn(const Joint&, const Quaternion& body, const Quaternion& to);

/// Adds the rows of a joint.  Solving c'' = 0 for their forces turns the mechanism into an ordinary
/// differential equation that any integrator can integrate: E. Hairer, G. Wanner, Solving Ordinary
/// Differential Equations II, section VII.1, index reduction.
void add_rows(const Joint&, const std::vector<Body>&, const Motion*, std::vector<Row>&);

/// Adds the rows of all rotors on coordinates of joints.
void add_rotor_rows(const Model&, const Motion*, std::vector<Row>&);

}  // namespace cylon::engine
