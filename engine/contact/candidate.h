// Where the bodies of a model may touch: every corner of a shape against every plane, every pair of bodies.
#pragma once

#include "engine/contact/touch.h"

namespace cylon::engine {

/// One place, or one pair of bodies, that may touch.
struct Candidate {
  enum class Kind {
    corner,   ///< A ball (radius 0: a point) fixed in `body`, against a plane.
    round,    ///< A sphere against a rounded box: one point.
    general,  ///< Any other pair: engine/geometry finds its points.
    lower,    ///< The lower limit of a coordinate of a joint,
    upper,    ///< or the upper one;
    dry       ///< its dry friction, which always touches.
  };
  Kind kind = Kind::corner;
  int body = 0;
  int other = fixed_world;
  int plane = -1;
  int law = -1;                      ///< Of a coordinate: index in Forces::coordinate_laws.
  int pair = 0;                      ///< Points of one pair act at once.
  Vector3 centre = Vector3::Zero();  ///< Of the ball, body axes [m].
  Real radius = 0;                   ///< Of the ball [m].
  Real reach = 0, other_reach = 0;   ///< Farthest point of the shapes from their reference points [m].
  Material material;
};

/// Whether it is one of a joint, not of surfaces.
inline bool is_of_joint(const Candidate& c) { return c.law >= 0; }

/// All candidates of a model, body by body, planes first, then the coordinates of joints.  A pair of which neither moves is none, nor is one
/// of model.apart.  `given`: per body its number in a model of another order, which the list then has; empty:
/// this one.
std::vector<Candidate> find_candidates(const Model&, const std::vector<std::size_t>& given = {});

/// The touch of any but a general candidate, whatever its gap, with its rates.  Centres c_a, c_b of the round
/// parts, s = |c_a - c_b|, W the angular velocity of what carries the normal:
///   g'' = n.(c_a'' - c_b'') + 2 n'.(c_a' - c_b') - s |n'|^2,   x' = c_a' - r_a n'.
TouchPoint touch_at(const Candidate&, const Model&, const Motion*);

/// Gap of any candidate [m].
Real gap_of(const Candidate&, const Model&, const Motion*);

/// Adds the points of a general pair nearer than margin; whether there were more than a manifold holds.
bool touches_of(const Candidate&, const Model&, const Motion*, Real margin, std::vector<TouchPoint>&);

/// What a shape is rounded by, about a point, a segment or a polytope [m].
Real core_radius(const Shape&);

/// dg/dt at a touch [m/s].
inline Real gap_rate(const TouchPoint& touch, const std::vector<Body>& bodies, const Motion* motion) {
  return touch.normal.dot(relative_velocity(touch, bodies, motion));
}

/// Lengths that the gap is computed from: its rounding is a few ulps of them [m].
Real gap_scale(const Candidate&, const Model&, const Motion*);

}  // namespace cylon::engine
