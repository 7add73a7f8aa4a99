// The forces that act without constraining: each adds its force and torque to the loads of its bodies.  A
// kind of force is a struct here with the facts that ForceKind asks for, a row of force_lists, and its law
// in forces.cc; a method that does not name its feature (engine/methods.cc) does not get it.
#pragma once

#include "engine/body.h"
#include "engine/coordinate_law.h"
#include "engine/features.h"
#include "engine/frame_force.h"
#include "engine/numbering.h"
#include "engine/user_force.h"
#include "engine/water.h"

#include <concepts>
#include <optional>
#include <tuple>
#include <vector>

namespace cylon::engine {

/// What else than its law must be known of a kind of force.
template <class F>
concept ForceKind = requires(F force, Features& features, std::vector<char>& turns, int body,
                             const Vector3& arm, const Numbering& part) {
  { F::stage } -> std::convertible_to<const char*>;  // its row in a plan
  { F::one } -> std::convertible_to<const char*>;    // "a spring"
  { F::feature } -> std::convertible_to<Feature>;    // of its own
  {force.add_features(features)};                    // all that it asks of a method, F::feature included
  // Affine in the momenta where it does, but for those of `not_affine`.
  { force.reads_velocities() } -> std::same_as<bool>;
  { force.reads_time() } -> std::same_as<bool>;  // other than by the motion
  // Its law is the same in a turning frame, for inertial velocities.
  { force.holds_in_turning_frame() } -> std::same_as<bool>;
  force.mark_turned(turns);                                   // sets what it may turn from rest
  force.shift_anchors(body, arm);                             // moves the reference point by `arm`, body axes
  { force.ends() } -> std::same_as<std::optional<Ends>>;      // where it acts between two places
  { force.acts_on() } -> std::same_as<std::optional<Acted>>;  // nothing: on every body
  force.renumber(part);                                       // as the force of a part of the model
};

/// F = (stiffness (|d| - rest_length) + damping d|d|/dt) d/|d| on `body`, -F on `to`, at the anchors; d from
/// the anchor on `body` to the anchor on `to`.  Seed eq. 19 (errata 5), pull towards the pin (errata 47),
/// damping added.  At |d| = 0 there is no direction and no force (errata 48).
struct Spring {
  int body = 0;
  Vector3 anchor = Vector3::Zero();  ///< Body axes, from the reference point [m].
  int to = fixed_world;
  Vector3 to_anchor = Vector3::Zero();  ///< Axes of `to`; world coordinates where `to` is the world [m].
  Real stiffness = 0;                   ///< [N/m], >= 0.
  Real rest_length = 0;                 ///< [m], >= 0.
  Real damping = 0;                     ///< [N s/m], >= 0.

  static constexpr const char* stage = "springs";
  static constexpr const char* one = "a spring";
  static constexpr Feature feature = Feature::spring;
  void add_features(Features& features) const {
    features.add(feature);
    if (damping != 0) features.add(Feature::damped_spring);
    if (pulls_off_centre(body, anchor) || pulls_off_centre(to, to_anchor))
      features.add(Feature::off_centre_spring);
  }
  bool reads_velocities() const { return damping != 0; }
  bool reads_time() const { return false; }
  bool holds_in_turning_frame() const { return damping == 0 || to != fixed_world; }
  void mark_turned(std::vector<char>& turns) const {
    if (pulls_off_centre(body, anchor)) turns[static_cast<std::size_t>(body)] = 1;
    if (pulls_off_centre(to, to_anchor)) turns[static_cast<std::size_t>(to)] = 1;
  }
  void shift_anchors(int end, const Vector3& arm) {
    if (end == body) anchor -= arm;
    if (end == to) to_anchor -= arm;
  }
  std::optional<Ends> ends() const { return Ends{body, anchor, to, to_anchor, rest_length}; }
  std::optional<Acted> acts_on() const { return Acted{body, to}; }
  void renumber(const Numbering& part) { body = part(body), to = part(to); }

 private:
  static bool pulls_off_centre(int end, const Vector3& at) { return end != fixed_world && !at.isZero(0); }
};

/// F = -linear v at the centre of mass, torque = -angular w - momentum L_spin.  Seed eq. 20, without the
/// factor dt of its program (errata 49).
struct Drag {
  int body = 0;
  Real linear = 0;    ///< [kg/s], >= 0.
  Real angular = 0;   ///< [kg m^2/s], >= 0.
  Real momentum = 0;  ///< [1/s], >= 0.

  static constexpr const char* stage = "drag";
  static constexpr const char* one = "drag";
  static constexpr Feature feature = Feature::drag;
  void add_features(Features& features) const { features.add(feature); }
  bool reads_velocities() const { return true; }
  bool reads_time() const { return false; }
  bool holds_in_turning_frame() const { return false; }
  void mark_turned(std::vector<char>&) const {}
  void shift_anchors(int, const Vector3&) {}
  std::optional<Ends> ends() const { return std::nullopt; }
  std::optional<Acted> acts_on() const { return Acted{body, fixed_world}; }
  void renumber(const Numbering& part) { body = part(body); }
};

/// A constant force in body axes at the centre of mass, or exchanged mass: dm/dt = Body::mass_rate brings in
/// the momentum mass_rate (v + R exhaust) where the velocity of the exchanged mass is given relative to the
/// body, or mass_rate exchanged where it is given in world axes.  dK/dt = F + (dm/dt) v_exchanged: seed eq.
/// 12 with the term that it leaves out (errata 2).
struct Thrust {
  int body = 0;
  Vector3 force = Vector3::Zero();  ///< Body axes [N].
  Real mass_rate = 0;               ///< [kg/s]; its part of Body::mass_rate.
  bool relative = false;  ///< `exchanged` is relative to the body, in body axes; else in world axes.
  Vector3 exchanged = Vector3::Zero();  ///< [m/s]

  static constexpr const char* stage = "thrust";
  static constexpr const char* one = "a thrust";
  static constexpr Feature feature = Feature::thrust;
  void add_features(Features& features) const { features.add(feature); }
  bool reads_velocities() const { return mass_rate != 0 && relative; }
  bool reads_time() const { return false; }
  /// Not where the exchanged mass has a velocity of its own, as the frame sees it.
  bool holds_in_turning_frame() const { return mass_rate == 0 || relative; }
  void mark_turned(std::vector<char>&) const {}
  void shift_anchors(int, const Vector3&) {}
  std::optional<Ends> ends() const { return std::nullopt; }
  std::optional<Acted> acts_on() const { return Acted{body, fixed_world}; }
  void renumber(const Numbering& part) { body = part(body); }
};

/// F = force cos(frequency t) at the centre of mass.
struct Drive {
  int body = 0;
  Vector3 force = Vector3::Zero();  ///< World axes [N].
  Real frequency = 0;               ///< [rad/s]

  static constexpr const char* stage = "drive";
  static constexpr const char* one = "a drive";
  static constexpr Feature feature = Feature::drive;
  void add_features(Features& features) const { features.add(feature); }
  bool reads_velocities() const { return false; }
  bool reads_time() const { return true; }
  bool holds_in_turning_frame() const { return true; }
  void mark_turned(std::vector<char>&) const {}
  void shift_anchors(int, const Vector3&) {}
  std::optional<Ends> ends() const { return std::nullopt; }
  std::optional<Acted> acts_on() const { return Acted{body, fixed_world}; }
  void renumber(const Numbering& part) { body = part(body); }
};

/// F = strength m_a m_b d/|d|^3 on `body`, -F on `to`, d from `body` to `to`, between centres of mass.  At
/// |d| = 0 there is no direction and no force.
struct Attraction {
  int body = 0;
  int to = 0;
  Real strength = 0;  ///< [m^3/(kg s^2)]

  static constexpr const char* stage = "attraction";
  static constexpr const char* one = "an attraction";
  static constexpr Feature feature = Feature::attraction;
  void add_features(Features& features) const { features.add(feature); }
  bool reads_velocities() const { return false; }
  bool reads_time() const { return false; }
  bool holds_in_turning_frame() const { return true; }
  void mark_turned(std::vector<char>&) const {}
  void shift_anchors(int, const Vector3&) {}
  std::optional<Ends> ends() const { return Ends{body, Vector3::Zero(), to, Vector3::Zero(), 0}; }
  std::optional<Acted> acts_on() const { return Acted{body, to}; }
  void renumber(const Numbering& part) { body = part(body), to = part(to); }
};

/// What reads velocities in a way for which no kick is exact.
inline constexpr Features not_affine = {Feature::quadratic_damping, Feature::user_force_of_velocities};

/// All forces of a model; F = sum F_i, torque = sum r_i x F_i (seed eq. 17, 57, 58; errata 4).
struct Forces {
  Vector3 gravity =
      Vector3::Zero();  ///< F = m g on every body without its own [m/s^2]; seed eq. 18 (errata 3).
  std::vector<Spring> springs;
  std::vector<Drag> drags;
  std::vector<Thrust> thrusts;
  std::vector<Drive> drives;
  std::vector<Attraction> attractions;
  std::vector<Water> waters;
  std::vector<CoordinateLaw> coordinate_laws;
  std::vector<UserForce> user_forces;
  std::vector<FrameForce> frame_forces;  ///< At most one.

  /// Gravity, then one per row above, in that order.
  std::size_t count() const;
  bool only_gravity() const { return count() == 1; }
  /// Whether any of them reads a velocity; all such are affine in the momenta, but for those of `not_affine`.
  bool read_velocities() const;

  /// The first time after t at which a force is not smooth as a function of the time; infinite: none [s].
  Time next_kink(Time t) const;
  /// Whether one jumps in time within [from, to]: a damper whose target changes its rate.
  bool jumps_within(Time from, Time to) const;
  /// Whether one jumps where a body passes a place.
  bool jumps_in_space() const;
  /// The angles of joints are what they are at the start.
  void start_turns();
  /// What the coordinate of each law is near to.
  void read_turns(std::vector<Real>&) const;
  /// The angles of joints by now, h [s] after they were last followed.
  void follow_turns(const std::vector<Body>&, const Motion*, Real h);
  /// From now on forces are those after the last kink up to t, at whatever time.
  void start_piece(Time t);
};

/// The lists of Forces: all of them, in the order in which forces are applied and their works are accounted.
inline constexpr std::tuple force_lists = {
    &Forces::springs,         &Forces::drags,       &Forces::thrusts,
    &Forces::drives,          &Forces::attractions, &Forces::waters,
    &Forces::coordinate_laws, &Forces::user_forces, &Forces::frame_forces};

/// Calls visit(list) for each list.
template <class AnyForces, class Visit>
constexpr void each_force_list(AnyForces& forces, Visit&& visit) {
  std::apply([&](auto... list) { (visit(forces.*list), ...); }, force_lists);
}

/// Calls visit(force) for each force but gravity.
template <class Visit>
void each_force(const Forces& forces, Visit&& visit) {
  each_force_list(forces, [&](const auto& list) {
    for (const auto& force : list) visit(force);
  });
}

/// Whether a force but gravity satisfies `predicate`.
template <class Predicate>
bool any_force(const Forces& forces, Predicate&& predicate) {
  bool any = false;
  each_force(forces, [&](const auto& force) { any = any || predicate(force); });
  return any;
}

inline std::size_t Forces::count() const {
  std::size_t n = 1;
  each_force_list(*this, [&](const auto& list) { n += list.size(); });
  return n;
}

inline bool Forces::read_velocities() const {
  return any_force(*this, [](const auto& force) { return force.reads_velocities(); });
}

// No list is left out, each kind states its facts, and no two share a feature.
struct ForcesByLists {
  Vector3 gravity;
  std::vector<Spring> lists[std::tuple_size_v<decltype(force_lists)>];
};
static_assert(sizeof(Forces) == sizeof(ForcesByLists));
static_assert(std::apply(
    []<class... Kind>(std::vector<Kind> Forces::*...) {
      return (ForceKind<Kind> && ...) && Features{Kind::feature...}.size() == sizeof...(Kind);
    },
    force_lists));

/// Sets the loads of the first `count` bodies; those after them are locked, and nothing is done to loads of
/// locked bodies but to clear them there.  Arrays have one entry per body.  `powers`, if any, has count()
/// entries and gets the power of each force [W]: F.v + torque.w, the integrand of seed eq. 84 (errata 23).
void apply(const Forces&, Time, const std::vector<Body>&, std::size_t count, const Motion*, const Kinematics*,
           Load*, Real* powers = nullptr);

}  // namespace cylon::engine
