// Coulomb's law at one point, solved exactly: the local step of the iteration over many points, and the whole
// of a one-point impact.
#pragma once

#include "engine/contact/coulomb.h"

namespace cylon::engine {

struct PointForce {
  Vector3 force = Vector3::Zero();  ///< (n, s, t)
  Hold hold;
  bool found =
      true;  ///< false: no force obeys the law (a slip that jams); then the force is the frictionless.
};

/// Solves u = A f + q with Coulomb's law for one point.  Nothing presses where q_n >= 0.  Otherwise the force
/// of a point that sticks, u = 0, if it is in the cone.  Otherwise the point slides in a direction d that is
/// sought (d = u_t/|u_t|): with f = f_n (1, -mu d), f_n = -q_n/(A_nn - mu A_nt.d), the roots over the circle
/// of
///   d x u_t(d) = 0,  u_t.d > 0,
/// and of several the one that takes most energy, least f.q + f.A f/2.
PointForce solve_point(const Matrix3& response, const Vector3& offset, Real friction, const Hold& hold);

/// The same of dry friction that nothing presses, along s alone:  u = A f + q,  |f| <= bound.
PointForce solve_dry(Real response, Real offset, Real bound, const Hold& hold);

}  // namespace cylon::engine
