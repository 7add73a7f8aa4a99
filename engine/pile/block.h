// Constraints between bodies of any shape: one block of up to three rows for each contact point, part of a joint, limit
// or dry friction in one, all solved alike.
#pragma once

#include "engine/geometry/point_name.h"
#include "engine/model.h"

#include <vector>

namespace cylon::engine::pile {

/// What an impulse does to a body.
struct Mover {
  Vector3 v = Vector3::Zero(), w = Vector3::Zero();
  Real inverse_mass = 0;
  Matrix3 inverse_inertia = Matrix3::Zero();  ///< World axes.
};
inline bool moves(const Mover& m) { return m.inverse_mass > 0 || !m.inverse_inertia.isZero(0); }

/// What a block keeps of the solution that gave it its impulse.
struct Past {
  Real acted = 0;                     ///< For how long, of what forces gave [s].
  bool known = false;                 ///< Whether that was a leap, or of a rotor any solution, which left:
  Vector3 u = Vector3::Zero();        ///< Of hold its part in `space`.
  Vector3 normal = Vector3::UnitY();  ///< Of a contact; of a rotor with its gearing, so that normal.u is q'.
};

/// With u the velocity of a's point against b's (angular: the angular velocity w of a against b's) and J the
/// impulse (angular: angular impulse) on a, -J on b; with a pitch u is less by pitch w, and J turns by -pitch J beside:
///   contact  u_n >= target, J_n >= 0, complementary; |J_t| <= friction J_n against u_t  (Coulomb)
///   hold     space u = 0, J in the image of `space`, a projection
///   stop     u_n >= target, J_n >= 0, complementary; J_t = 0
///   rub      |J_n| <= limit, against u_n;  J_t = 0
///   soft     J_n = push - drag u_n;  J_t = 0
struct Block {
  enum class Kind { contact, hold, stop, rub, soft };
  Kind kind = Kind::contact;
  bool angular = false;
  int a = 0;
  int b = fixed_world;
  Vector3 arm = Vector3::Zero(), to_arm = Vector3::Zero();  ///< From the reference points, world axes [m].
  Vector3 normal = Vector3::UnitY();                        ///< From b to a; of a joint the axis.
  Real gearing = 1;  ///< Of a law, an angle of a gimbal apart: q' = gearing n.u with n unit.
  Vector3 own_normal = Vector3::UnitY();  ///< The same in a's axes, of two bodies.
  Matrix3 space = Matrix3::Identity();
  Real pitch = 0;  ///< Of the part of a screw that couples its turn to its way [m/rad].
  bool offset =
      false;  ///< Of a joint whose points are apart: the arms end at one point that is no anchor of both.
  Real friction = 0, target = 0;  ///< Of rub: a force [N, N m].
  Real limit = 0;                 ///< Of rub, in this part of the step [N s, N m s].
  Real push = 0, drag = 0;        ///< Of soft, the same [N s, N m s; kg, kg m^2].
  Real rotor = 0, turned = 0;  ///< Of soft: of its drag the rotor's part, and u_n that the rotor had before.
  Vector3 impulse = Vector3::Zero();
  Vector3 before = Vector3::Zero();  ///< u before the forces of the step, of a direct solution.
  Vector3 bias = Vector3::Zero();    ///< A direct solution meets the laws with u + bias.
  Vector3 blow = Vector3::Zero();    ///< Of J what impacts gave that went one after another (InTurn).
  Real struck = 0;  ///< How fast the fastest of these was approached; 0: there was none [m/s].
  Past past;

  Real gap = 0;               ///< When the contact was found [m]; of a stop now [m, rad].
  Real gap_now = 0;           ///< When targets were set.
  Vector3 anchor, to_anchor;  ///< The point, body axes; world axes where b is the world.
  Real restitution = 0;
  int plane = -1;      ///< Index of the plane that b is.
  int law = -1;        ///< Of stop, rub and soft: index of the coordinate law.
  bool upper = false;  ///< Of a stop: which one.
  PointName feature = 0;
  bool impact = false;  ///< Meets within this part of the step.

  Real mass = 0;       ///< Along the normal.
  Matrix3 block_mass;  ///< In `space`; contact: across the normal.

  /// Whether both are contacts of the same two bodies, or of a body with the same plane.
  friend bool same_pair(const Block& x, const Block& y) {
    return x.kind == Kind::contact && y.kind == Kind::contact && x.a == y.a && x.b == y.b &&
           x.plane == y.plane;
  }

  bool is_along_normal() const { return kind != Kind::contact && kind != Kind::hold; }
  /// Whether it presses and never pulls.
  bool is_one_sided() const { return kind == Kind::contact || kind == Kind::stop; }
};

/// The velocity of a point at `arm` of a body, as a block that is not angular takes it, and the torque of an impulse there.
inline Vector3 velocity_at(const Block& block, const Mover& m, const Vector3& arm) {
  const Vector3 v = m.v + m.w.cross(arm);
  return block.pitch == 0 ? v : Vector3(v - block.pitch * m.w);
}
inline Vector3 torque_of(const Block& block, const Vector3& arm, const Vector3& j) {
  const Vector3 torque = arm.cross(j);
  return block.pitch == 0 ? torque : Vector3(torque - block.pitch * j);
}

inline Vector3 relative_velocity(const Block& block, const std::vector<Mover>& movers) {
  const Mover& a = movers[static_cast<std::size_t>(block.a)];
  Vector3 u = block.angular ? a.w : velocity_at(block, a, block.arm);
  if (block.b != fixed_world) {
    const Mover& b = movers[static_cast<std::size_t>(block.b)];
    u -= block.angular ? b.w : velocity_at(block, b, block.to_arm);
  }
  return u;
}

inline void push(const Block& block, const Vector3& impulse, std::vector<Mover>& movers) {
  const auto one = [&](int body, const Vector3& arm, const Vector3& j) {
    Mover& m = movers[static_cast<std::size_t>(body)];
    if (block.angular) {
      m.w += m.inverse_inertia * j;
    } else {
      m.v += m.inverse_mass * j;
      m.w += m.inverse_inertia * torque_of(block, arm, j);
    }
  };
  one(block.a, block.arm, impulse);
  if (block.b != fixed_world) one(block.b, block.to_arm, -impulse);
}

/// Fills mass and block_mass.  K = (1/m_a + 1/m_b) 1 + T_a I_a^-1 T_a^T + T_b I_b^-1 T_b^T,  T = [r] + pitch 1;  mass =
/// 1/(n.K n),  block_mass = P (P K P + 1 - P)^-1 P.
void set_effective_mass(Block&, const std::vector<Mover>&);

/// One sweep of projected Gauss-Seidel over one block: ends its own error, keeps J in the cone.
void relax(Block&, std::vector<Mover>&);

/// By how much another sweep would change the block's velocity, K dJ with dJ the change of the impulse [m/s,
/// align: rad/s]: zero where its laws hold.  Requires set_effective_mass().
Real unmet(const Block&, const std::vector<Mover>&);

}  // namespace cylon::engine::pile
