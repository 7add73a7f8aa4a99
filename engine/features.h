// What a model may ask of whatever carries it through time.  A method that does not name a feature does not
// support it (engine/methods.h).
#pragma once

#include <array>
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
  own_gravity,    ///< In place of that of all.
  pinned_body,    ///< In reduced coordinates: only turns, about a pivot;
  one_axis_body,  ///< only about an axis.
  guided_body,    ///< Only moves along a line or in a plane.
  // Forces, at least one per kind (engine/forces.h).
  spring,
  damped_spring,
  off_centre_spring,
  drag,
  thrust,
  drive,
  attraction,
  water,
  joint_law,                 ///< A spring, a damper, a motor or a servo on a coordinate of a joint.
  quadratic_damping,         ///< One that is not affine in the momenta.
  user_force,                ///< Its law is a plug-in's.
  user_force_of_velocities,  ///< One that is not affine in the momenta.
  frame_force,           ///< The frame of the scene turns or accelerates, and motions are those that it sees.
  unknown_displacement,  ///< A body under water of a shape without volume that is no point.
  // Joints.
  joint_together,
  joint_at_length,
  joint_along_axis,
  joint_in_plane,
  joint_along_normal,
  joint_about_axis,
  joint_about_two_axes,
  joint_never,
  joint_couples,   ///< A screw.
  joint_limit,     ///< A coordinate of a joint has an end.
  joint_friction,  ///< Dry friction on a coordinate of a joint.
  joint_rotor,     ///< A coordinate of a joint drives a rotor.
  // Contacts, and the shapes of bodies that may touch something.
  contact,
  lasting_contact,  ///< One that free flight and a plane under a body do not express.
  friction,
  sphere,
  box,
  capsule,
  hull,
  frustum,
  compound,
  compound_beside_bodies,  ///< Not only planes.
  pairs_apart,             ///< Pairs of bodies that do not touch each other.
  collision_filters,       ///< Groups and masks.
  // The frame, and what would have to know that it turns.
  turning_frame,
  contact_in_turning_frame,
  world_joint_in_turning_frame,
  force_in_turning_frame,
  // Of the run.
  chosen_integrator,
  account,        ///< The work of each force.
  late_start,     ///< The run begins at another time than 0: parts of a scene that meet begin anew.
  every_stage,    ///< Option model = full.
  path_events,    ///< This path was asked for.
  path_stepping,  ///< This one.
  count
};

/// What a feature is called, for a reader.
struct FeatureName {
  Feature feature;
  const char* text;
};

inline constexpr std::array feature_names = {
    FeatureName{Feature::locked_body, "locked bodies"},
    FeatureName{Feature::spin, "spinning bodies"},
    FeatureName{Feature::changing_mass, "changing masses"},
    FeatureName{Feature::own_gravity, "bodies with a gravity of their own"},
    FeatureName{Feature::pinned_body, "bodies pinned at a point"},
    FeatureName{Feature::one_axis_body, "bodies held on an axis"},
    FeatureName{Feature::guided_body, "bodies held on a line or in a plane"},
    FeatureName{Feature::spring, "springs"},
    FeatureName{Feature::damped_spring, "damped springs"},
    FeatureName{Feature::off_centre_spring, "springs that pull off centre"},
    FeatureName{Feature::drag, "drag"},
    FeatureName{Feature::thrust, "thrust"},
    FeatureName{Feature::drive, "drives"},
    FeatureName{Feature::attraction, "bodies that attract each other"},
    FeatureName{Feature::water, "water"},
    FeatureName{Feature::joint_law, "springs, dampers and motors in joints"},
    FeatureName{Feature::quadratic_damping, "quadratic damping in joints"},
    FeatureName{Feature::user_force, "forces of plug-ins"},
    FeatureName{Feature::user_force_of_velocities, "forces of plug-ins that read velocities"},
    FeatureName{Feature::frame_force, "a frame that turns or accelerates"},
    FeatureName{Feature::unknown_displacement, "what a rod displaces of water, as it has no volume"},
    FeatureName{Feature::joint_together, "joints at a point"},
    FeatureName{Feature::joint_at_length, "joints at a length"},
    FeatureName{Feature::joint_along_axis, "joints along an axis"},
    FeatureName{Feature::joint_in_plane, "joints in a plane"},
    FeatureName{Feature::joint_along_normal, "joints with an offset between their axes"},
    FeatureName{Feature::joint_about_axis, "joints about an axis"},
    FeatureName{Feature::joint_about_two_axes, "joints about two axes"},
    FeatureName{Feature::joint_never, "joints that keep the orientation"},
    FeatureName{Feature::joint_couples, "screws"},
    FeatureName{Feature::joint_limit, "limits of joints"},
    FeatureName{Feature::joint_friction, "dry friction in joints"},
    FeatureName{Feature::joint_rotor, "rotors on joints"},
    FeatureName{Feature::contact, "contacts"},
    FeatureName{Feature::lasting_contact, "contacts that persist"},
    FeatureName{Feature::friction, "friction"},
    FeatureName{Feature::sphere, "spheres that touch"},
    FeatureName{Feature::box, "boxes that touch"},
    FeatureName{Feature::capsule, "capsules that touch"},
    FeatureName{Feature::hull, "hulls that touch"},
    FeatureName{Feature::frustum, "cylinders and cones that touch"},
    FeatureName{Feature::compound, "compounds that touch"},
    FeatureName{Feature::compound_beside_bodies, "compounds that touch other bodies"},
    FeatureName{Feature::pairs_apart, "pairs of bodies that do not touch each other"},
    FeatureName{Feature::collision_filters, "collision groups"},
    FeatureName{Feature::turning_frame, "a rotating frame"},
    FeatureName{Feature::contact_in_turning_frame, "contacts, limits or dry friction in a rotating frame"},
    FeatureName{Feature::world_joint_in_turning_frame, "joints to the world in a rotating frame"},
    FeatureName{Feature::force_in_turning_frame,
                "drag, water, a spring damped against the world or a force along a joint to the world in a "
                "rotating frame"},
    FeatureName{Feature::chosen_integrator, "a chosen integrator"},
    FeatureName{Feature::account, "the work of each force"},
    FeatureName{Feature::late_start, "a start at another time than 0"},
    FeatureName{Feature::every_stage, "option model = full"},
    FeatureName{Feature::path_events, "the path events"},
    FeatureName{Feature::path_stepping, "the path stepping"},
};

constexpr bool one_name_each() {
  if (feature_names.size() != static_cast<std::size_t>(Feature::count)) return false;
  for (std::size_t i = 0; i < feature_names.size(); ++i)
    if (feature_names[i].feature != static_cast<Feature>(i)) return false;
  return true;
}
static_assert(one_name_each(), "every feature has a name, in the order of the enumeration");

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
  friend constexpr Features operator&(Features a, Features b) { return Features(a.bits_ & b.bits_); }
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
inline std::string names(Features features) {
  std::string text;
  for (const FeatureName& name : feature_names)
    if (features.has(name.feature)) text += (text.empty() ? "" : ", ") + std::string(name.text);
  return text;
}

}  // namespace cylon::engine
