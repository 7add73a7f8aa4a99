// What acts on a free coordinate of a joint: a smooth force, dry friction, limits, and a rotor.
#pragma once

#include "engine/coordinate.h"
#include "engine/ends.h"
#include "engine/features.h"

#include <limits>
#include <optional>
#include <vector>

namespace cylon::engine {

/// Where a spring is without force, as a function of the time: with a table (times ascending) linear between
/// its rows and constant before and after, else  value + amplitude cos(frequency t + phase).
struct Target {
  Real value = 0;      ///< [m, rad]
  Real amplitude = 0;  ///< [m, rad]
  Real frequency = 0;  ///< [rad/s]
  Real phase = 0;      ///< [rad]
  std::vector<Time> times;
  std::vector<Real> values;  ///< One per time [m, rad].

  /// The value and its rate.  At a kink the rate is that of the piece which has been started, and outside that
  /// piece it is continued; before any is started, that of the piece after.
  struct Now {
    Real value = 0, rate = 0;
  };
  Now at(Time) const;
  bool moves() const { return amplitude != 0 || times.size() > 1; }
  Time next_kink(Time) const;
  void start_piece(Time);

 private:
  std::size_t piece_at(Time) const;
  std::optional<std::size_t> piece_;  // between times[piece - 1] and times[piece]
};

/// The generalised force on a coordinate q
///   Q = -stiffness (q - target(t)) - damping (q' - target'(t)) - quadratic_damping q' |q'| + force,
/// on `body` along the coordinate, on `to` against it, of power Q q' together.  Beside it, dry friction of at
/// most `friction` against q', and at rest against what would move it; limits, at which q' turns round to
/// -restitution q'; and a rotor that q drives through gears, of kinetic energy armature q'^2/2, which pulls by
/// -armature q''.  The forces apply() has Q alone; friction and limits are contacts of one row
/// (engine/contact/candidate.h), and the rotor is a row beside those of joints (engine/constraint.h).
struct CoordinateLaw {
  Coordinate at;
  Real stiffness = 0;          ///< [N/m, N m/rad], >= 0.
  Real damping = 0;            ///< [N s/m, N m s/rad], >= 0.
  Real quadratic_damping = 0;  ///< [N s^2/m^2, N m s^2/rad^2], >= 0.
  Real force = 0;              ///< [N, N m]
  Target target;
  Real friction = 0;  ///< The largest force of dry friction [N, N m], >= 0.
  Real armature = 0;  ///< Of the rotor [kg, kg m^2], >= 0.
  Real lower = -std::numeric_limits<Real>::infinity(), upper = std::numeric_limits<Real>::infinity();
  Real restitution = 0;  ///< Of the limits: Newton's, [0, 1].
  bool held = false;     ///< Q is a matter of who solves constraints, and no force of apply().

  bool has_lower() const { return lower > -std::numeric_limits<Real>::infinity(); }
  bool has_upper() const { return upper < std::numeric_limits<Real>::infinity(); }
  bool is_limited() const { return has_lower() || has_upper(); }
  /// Whether Q is anything at all, beside friction, limits and the rotor.
  bool has_smooth_force() const {
    return stiffness != 0 || damping != 0 || quadratic_damping != 0 || force != 0;
  }
  /// Whether it matters how many turns the coordinate has made.
  bool counts_turns() const {
    return at.is_angle() && at.kind != Coordinate::Kind::inclination && (stiffness != 0 || is_limited());
  }

  static constexpr const char* stage = "springs, dampers and motors in joints";
  static constexpr const char* one = "a force in a joint";
  static constexpr Feature feature = Feature::joint_law;
  void add_features(Features& features) const {
    features.add(feature);
    if (quadratic_damping != 0) features.add(Feature::quadratic_damping);
    if (is_limited()) features.add(Feature::joint_limit);
    if (friction != 0) features.add(Feature::joint_friction);
    if (armature != 0) features.add(Feature::joint_rotor);
    if (is_limited() || friction != 0) features.add(Feature::contact);
  }
  bool reads_velocities() const { return damping != 0 || quadratic_damping != 0; }
  bool reads_time() const { return target.moves() && (stiffness != 0 || damping != 0); }
  bool holds_in_turning_frame() const { return at.to != fixed_world; }
  void mark_turned(std::vector<char>& turns) const {
    for (const int end : {at.body, at.to})
      if (end != fixed_world) turns[static_cast<std::size_t>(end)] = 1;
  }
  void shift_anchors(int end, const Vector3& arm) { at.shift_anchors(end, arm); }
  std::optional<Ends> ends() const { return std::nullopt; }
  std::optional<Acted> acts_on() const { return Acted{at.body, at.to}; }
  void renumber(const Numbering& part) { at.renumber(part); }
};

}  // namespace cylon::engine
