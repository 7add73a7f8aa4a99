// Contacts that last: the forces with which surfaces that touch and do not approach press, rub and hold.
//
// At the level of accelerations, per point:  N >= 0, g'' >= 0, N g'' = 0;  a point that slips, u_t != 0, has
// the force -mu N u_t/|u_t|;  one that does not has |T| <= mu N, and T = -mu N a_t/|a_t| where it starts to
// slip.  P. Loetstedt, SIAM J. Appl. Math. 42 (1982) 281; J. J. Moreau (1988), section 8.
#pragma once

#include "engine/constraint.h"
#include "engine/contact/coulomb.h"
#include "engine/contact/touch.h"

#include <span>

namespace cylon::engine {

/// How a point that touches is held: what a smooth piece of the motion keeps.
struct Holding {
  Grip grip = Grip::sticks;
  Vector3 slip = Vector3::Zero();  ///< Unit direction of slip where it slides, world axes.
  /// Where the force could be shared with other points in many ways: the force, world axes, that the sharing
  /// stays near to [N]; zero at all points: shared evenly.
  Vector3 share = Vector3::Zero();
};

/// What a point does and how far it is from doing something else.
struct ContactForce {
  Holding holding;
  Vector3 force = Vector3::Zero();  ///< On `body`, world axes [N].
  Real normal = 0;                  ///< N [N]; < 0: it ought to part.
  Real reserve = 0;                 ///< b + mu N - |T| where it sticks [N]; < 0: it ought to slip.
  Real slip_speed = 0;              ///< u.d where it slides [m/s]; < 0: it ought to stick or to turn round.
  Real parting = 0;                 ///< g'' with all forces [m/s^2].
  bool of_joint = false;            ///< It is a coordinate of a joint,
  Real bound = 0;                   ///< with dry friction of at most this.
};

struct ContactForces {
  std::vector<ContactForce> points;
  VectorX multipliers;  ///< Of all rows, contacts first.
  std::vector<Row> rows;
  bool exact = true;
  Real violation = 0;           ///< Where it is not exact: how far accelerations are from the law [m/s^2].
  Real undecided = 0;           ///< undecided_rate() of what was decided anew [m/s^2].
  std::int64_t operations = 0;  ///< Of CoulombSolution.
};

/// The bodies at an instant: loads without contact and joint forces.
struct Instant {
  const std::vector<Body>& bodies;
  const Motion* motion;
  const Kinematics* kinematics;
  const Load* loads;
  std::size_t count;  ///< The bodies after so many are locked.
};

/// What the acceleration of a coordinate of a joint is made of at most, from the loads and its own dry friction:
///   |n| (|F_a| + |T_a|/k_a)/m_a + |I_a^-1 s_a| (|T_a| + k_a |F_a|),  the same of b,  and b A   [unit of the coordinate/s^2],
/// k the radius of gyration: joints make torques of forces (a pendulum at its stop: g l/(k^2 + l^2) <= g/(2 k)) and forces of
/// torques.  What is small beside it, times a time, is no rate of the coordinate.
Real pull_of(const TouchPoint& coordinate, const Instant&);

/// Decides how every point is held.  `slow`, one per point: those that move slower across the surface [m/s; a
/// coordinate: its unit/s] count as not slipping.  `guess`, one per point or none: how they were held before, which is kept if it still obeys.
/// The shares of the result are such that held_contact_forces() finds the same forces.
ContactForces find_contact_forces(std::span<const TouchPoint>, std::span<const Row> joints, const Instant&,
                                  std::span<const Real> slow, std::span<const Holding> guess = {});

/// The forces when that is decided: smooth functions of the state.  A sliding point that has come to move
/// backwards keeps its force, so that slip goes through zero smoothly and its end can be found.  `slow` > 0
/// [m/s]: slip u slower than that turns the force less than it should,
///   d = w/|w|,  w = u_p + sqrt(s^2 + slow^2) d_0,  s = u.d_0,  u_p = u - s d_0,  d_0 the slip of the
///   holding:
/// the rate at which friction turns slip grows with 1/|u|, and so does the work to follow it.  A coordinate has one
/// direction each way, d = d_0, which nothing turns.
ContactForces held_contact_forces(std::span<const TouchPoint>, std::span<const Holding>,
                                  std::span<const Row> joints, const Instant&, Real slow);

/// g'' of each point under the loads and the joints alone [m/s^2].
std::vector<Real> free_partings(std::span<const TouchPoint>, std::span<const Row> joints, const Instant&);

/// The largest radius of gyration [m].
inline Real gyration(const Body& body) {
  return body.mass > 0 ? std::sqrt(body.inertia.diagonal().maxCoeff() / body.mass) : Real(0);
}

/// Whether loads and support leave every body that can move without force and torque, to rounding.
bool balanced(const ContactForces&, const Instant&);

/// Adds the forces to the loads of the first `count` bodies; what is left of a sum that cancels to rounding is made exactly zero, so that
/// what rests stays.
void add_forces(const ContactForces&, std::span<const Body>, Load*, std::size_t count);

}  // namespace cylon::engine
