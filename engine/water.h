// Water: lift and drag on what is below a moving surface.
#pragma once

#include "engine/body.h"
#include "engine/ends.h"
#include "engine/features.h"
#include "engine/numbering.h"
#include "engine/shape.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace cylon::engine {

/// How the lift follows from the depth.
enum class WaterMode {
  volume,  ///< Archimedes: what the submerged part displaces.  Points displace nothing.
  step     ///< The seed's: a constant lift on a body whose centre is below the surface.
};

/// Volume: surface  h = level + wave sin(x - speed t),  taken as level over the width of a body;
///   F = -density V_sub g at the centroid of the submerged part,  F = -drag (V_sub/V) v at the centre of
///   mass.
/// Step: the seed's surface, a table of 41 x 41 cells of 0.25 m around the origin, continued outside by its
/// outermost cells (the seed reads beyond its table, errata 51),
///   h_ij = level + wave/2 sin(speed t + i) + wave/2 sin(0.5 i j),  i = trunc((x + 5)/0.25),  j likewise from
///   z; below it  F = buoyancy up - drag v  and  dL/dt = -L  (without the factor dt of its program, errata
///   50).
struct Water {
  Real level = 0;     ///< [m]
  Real wave = 0;      ///< [m]
  Real speed = 0;     ///< [rad/s]
  Real buoyancy = 0;  ///< Volume: density [kg/m^3]; step: lift [N].
  Real drag = 0;      ///< [kg/s]
  WaterMode mode = WaterMode::volume;
  std::vector<Shape> shapes;  ///< Volume: one per body.
  std::vector<char>
      inside;  ///< Step: which bodies are below, where somebody follows the crossings; else empty.

  /// Height of the surface over a point [m].
  Real surface(Time, const Vector3& point) const;
  /// Step: whether the lift acts on a body.
  bool under(std::size_t body, Time time, const Vector3& centre) const {
    return inside.empty() ? centre.y() < surface(time, centre) : inside[body] != 0;
  }

  // Facts of this kind of force (engine/forces.h).
  static constexpr const char* stage = "water";
  static constexpr const char* one = "water";
  static constexpr Feature feature = Feature::water;
  void add_features(Features& features) const { features.add(feature); }
  bool reads_velocities() const { return drag != 0 || mode == WaterMode::step; }
  bool reads_time() const { return wave != 0 && speed != 0; }
  bool holds_in_turning_frame() const { return false; }
  void mark_turned(std::vector<char>& turns) const {
    if (mode == WaterMode::volume) std::fill(turns.begin(), turns.end(), char{1});
  }
  void shift_anchors(int, const Vector3&) {}
  std::optional<Ends> ends() const;
  std::optional<Acted> acts_on() const { return std::nullopt; }
  void renumber(const Numbering& part);
};

/// The part of a body below the horizontal plane y = height.
struct Submerged {
  Real volume = 0;                     ///< [m^3]
  Real whole = 0;                      ///< Volume of the body [m^3].
  Vector3 centroid = Vector3::Zero();  ///< World [m].
};

/// Sphere: cap.  Box and hull: the polyhedron cut by the plane.  Both exact.  Cylinder, cone and capsule: round_below(), to
/// rounding of the whole.  Compound: the sum of its parts.  A point displaces nothing, and neither does what displaces()
/// denies.
Submerged submerged(const Shape&, const Vector3& position, const Matrix3& rotation, Real height);
/// Whether the shape has a volume, or is a point: a rod has none.
bool displaces(const Shape&);

}  // namespace cylon::engine
