// The free coordinates of joints: how far a body has gone along an axis, or turned about one.
#pragma once

#include "engine/constraint.h"
#include "engine/numbering.h"

#include <optional>
#include <vector>

namespace cylon::engine {

/// One end of a joint: where its anchor is, how it moves, and the part of its acceleration that the spin makes,
///   a = a_0 + alpha x r + w x (w x r).
struct JointEnd {
  Vector3 arm = Vector3::Zero(), place = Vector3::Zero(), velocity = Vector3::Zero(),
          centripetal = Vector3::Zero(), angular_velocity = Vector3::Zero();
  Quaternion orientation = Quaternion::Identity();
  Matrix3 rotation = Matrix3::Identity();
};
JointEnd end_of(int body, const Vector3& anchor, const std::vector<Body>&, const Motion*);
/// The same from kinematics; the world has none.
JointEnd end_of(int body, const Vector3& anchor, const Motion*, const Kinematics*);

/// With u carried by `to` and d from the anchor on `to` to that on `body`:  c = u.d,
///   c' = u.(v_a - v_b) + (r_a x u).w_a - ((r_b + d) x u).w_b,
///   bias = u.(centripetal_a - centripetal_b) + 2 (w_b x u).d' + (w_b x (w_b x u)).d.
/// The force is that of a's point on b's matter there.  Directions, levers, bias, offset and its rounding.
void set_row_along(const Vector3& u, const JointEnd& a, const JointEnd& b, Row&);

/// With the axis h, square to the relative spin of neither:  c' = h.(w_a - w_b),  bias = h'.(w_a - w_b).
void set_row_about(const Vector3& h, const Vector3& change, const JointEnd& a, const JointEnd& b, Row&);

/// A displacement:  q = origin + h.d,  the axis h carried by `to`, d as above.
/// An angle:        q = origin + the angle about h from `zero`, which h's carrier carries too, to `mark`,
/// which the other end carries; against that angle where `body` is the carrier, so that q' = h.(w_a - w_b)
/// for both.  It is continued over any number of turns: of all values that the orientation allows, which are
/// 2 pi apart, q is the one nearest to `near`.
/// An azimuth: the same of a mark that need not be square to the axis, of which the part that is counts.  Not a number
/// where there is none.
/// An inclination: q = origin + the angle from the axis, which `to` carries, to the mark, less `zero_inclination`.
struct Coordinate {
  enum class Kind { displacement, angle, azimuth, inclination };
  Kind kind = Kind::displacement;
  int body = 0;
  Vector3 anchor = Vector3::Zero();  ///< Body axes [m]; of a displacement.
  int to = fixed_world;
  Vector3 to_anchor = Vector3::Zero();  ///< Axes of `to`; world coordinates where `to` is the world [m].
  bool on_body = false;                 ///< `body` carries the axis, not `to`; of an angle.
  Vector3 axis = Vector3::UnitX();      ///< h: unit, axes of its carrier.
  Vector3 zero = Vector3::UnitY();      ///< Unit, square to the axis, axes of its carrier.
  Vector3 mark = Vector3::UnitY();      ///< Unit, axes of the other end.
  Real origin = 0;                      ///< [m, rad]
  Real zero_inclination = 0;            ///< [rad]
  /// Of an angle that has turned already: what q is near to at the start [rad]; absent: near the origin.
  std::optional<Real> start = {};
  Real near = 0;  ///< Of an angle: what q is near to now [rad]; kept by who moves bodies.

  bool is_angle() const { return kind != Kind::displacement; }
  void shift_anchors(int end, const Vector3& arm) {
    if (end == body) anchor -= arm;
    if (end == to) to_anchor -= arm;
  }
  void renumber(const Numbering& part) { body = part(body), to = part(to); }
};

/// The row of q' and q'', with q as its offset.
Row row_of(const Coordinate&, const JointEnd& body, const JointEnd& to);
Row row_of(const Coordinate&, const std::vector<Body>&, const Motion*);

/// c' of a row.  n.(v_a - v_b) + s_a.w_a - s_b.w_b
Real rate_of(const Row&, const Kinematics*);
Real speed_of(const Row&, const std::vector<Body>&, const Motion*);

/// The value nearest to `near` of those that are 2 pi apart.
Real nearest_turn(Real angle, Real near);

}  // namespace cylon::engine
