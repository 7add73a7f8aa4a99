// What a model may ask of whatever carries it through time.  A method that does not name a feature does not
// support it (engine/methods.h).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace cylon::engine {

enum class Feature : unsigned {
  // Bodies.
  locked_body,
  spin,  ///< A body has angular momentum at t = 0.
  changing_mass,
  pinned_body,    ///< In reduced coordinates: only turns, about a pivot;
  one_axis_body,  ///< only about an axis.
  // Forces, at least one per kind (engine/forces.h).
  spring,
  damped_spring,
  off_centre_spring,
  drag,
  thrust,
  drive,
  attraction,
  water,
  unknown_displacement,  ///< A body under water of a shape whose submerged volume has no formula.
  // Joints.
  joint_together,
  joint_at_length,
  joint_about_axis,
  joint_never,
  // Contacts, and the shapes of bodies that may touch something.
  contact,
  lasting_contact,  ///< One that free flight and a plane under a body do not express.
  friction,
  sphere,
  box,
  capsule,
  hull,
  // The frame, and what would have to know that it turns.
  turning_frame,
  contact_in_turning_frame,
  world_joint_in_turning_frame,
  force_in_turning_frame,
  // Of the run.
  chosen_integrator,
  account,        ///< The work of each force.
  every_stage,    ///< Option model = full.
  path_events,    ///< This path was asked for.
  path_stepping,  ///< This one.
  count
};

/// A set of features.
class Features {
 public:
  constexpr Features() = default;
  constexpr Features(std::initializer_list<Feature> list) {
    for (const Feature f : list) bits_ |= bit(f);
  }
  constexpr void add(Feature f) { bits_ |= bit(f); }
  constexpr bool has(Feature f) const { return (bits_ & bit(f)) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr std::size_t size() const { return static_cast<std::size_t>(std::popcount(bits_)); }

  friend constexpr Features operator|(Features a, Features b) { return Features(a.bits_ | b.bits_); }
  /// What is in `a` and not in `b`.
  friend constexpr Features operator-(Features a, Features b) { return Features(a.bits_ & ~b.bits_); }
  friend constexpr bool operator==(Features, Features) = default;

 private:
  static_assert(static_cast<unsigned>(Feature::count) <= 64);
  explicit constexpr Features(std::uint64_t bits) : bits_(bits) {}
  static constexpr std::uint64_t bit(Feature f) { return std::uint64_t{1} << static_cast<unsigned>(f); }

  std::uint64_t bits_ = 0;
};

/// In words: "drag, joints to the world in a rotating frame"; empty for none.
std::string names(Features);

}  // namespace cylon::engine
