// What is simulated, as plain data: bodies, their motion at t = 0, and all that acts on them.
#pragma once

#include "engine/body.h"
#include "engine/forces.h"
#include "engine/shape.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace cylon::engine {

/// Holds two bodies together, or one to the world.  Anchors and axes in body axes; world coordinates where
/// `to` is the world.  What acts on the coordinates that a joint leaves free is a force (CoordinateLaw).
struct Joint {
  enum class Place {
    together,     ///< The anchors coincide.
    at_length,    ///< The anchors keep the distance `length`.
    along_axis,   ///< The anchor on `body` stays on the line of `to_axis` through the anchor on `to`.
    in_plane,     ///< It stays in the plane square to `to_axis` there.
    along_normal  ///< It stays `length` along  to_axis x axis  from there.
  };
  enum class Turn {
    freely,
    about_axis,       ///< The axes coincide.
    about_two_axes,   ///< The axes stay square to each other.
    never,            ///< The bodies do not turn against each other.
    about_three_axes  ///< Freely; its angles are about the axes and the line square to both.
  };
  /// What a joint keeps; every kind of joint is a place and a turn.
  struct Type {
    Place place = Place::together;
    Turn turn = Turn::freely;
    /// It keeps the bodies from some turn.
    bool twists() const { return turn != Turn::freely && turn != Turn::about_three_axes; }
    bool couples = false;  ///< along_axis and about_axis: the displacement is `pitch` times the angle.
    friend bool operator==(const Type&, const Type&) = default;
  };
  Type type;
  int body = 0;
  Vector3 anchor = Vector3::Zero();  ///< [m]
  int to = fixed_world;
  Vector3 to_anchor = Vector3::Zero();           ///< [m]
  Vector3 axis = Vector3::UnitY();               ///< Of axes: unit.
  Vector3 to_axis = Vector3::UnitY();            ///< Of axes, along_axis and in_plane: unit.
  Quaternion relative = Quaternion::Identity();  ///< R_to^T R_body: of never always, of couples at angle 0.
  Real length = 0;                               ///< Of at_length and along_normal: [m], > 0.
  Real pitch = 0;                                ///< Of couples: [m/rad], not 0.
};

/// Physics of a pair of surfaces.
struct Material {
  Real restitution = 0;  ///< Newton's, [0, 1].
  Real friction = 0;     ///< Coulomb's, static = kinetic, >= 0.
};

/// How several impacts at one instant resolve: one after another (Newton's cradle), or all at once.  The
/// points of one pair of bodies always act at once.
enum class Impacts { sequential, simultaneous };

/// The scene is given, and computed, in a frame that turns about the origin of the inertial frame.  A frame
/// that only moves changes nothing (Galilei). Momenta are those of the inertial frame, in the axes of this
/// one.
struct RotatingFrame {
  Vector3 angular_velocity = Vector3::Zero();  ///< Of the frame [rad/s].
};

inline constexpr int no_surface = -1;

/// Two bodies, the lower first.
using BodyPair = std::array<int, 2>;

/// Groups of a body or a plane, and those that it touches, as bits.
struct Filter {
  std::uint32_t groups = 1, mask = ~std::uint32_t{0};
  // NOLINTNEXTLINE(modernize-use-nullptr): the literal that the compiler compares with
  friend auto operator<=>(const Filter&, const Filter&) = default;
};

/// Two things touch only if the mask of each has a group of the other.
constexpr bool may_meet(const Filter& a, const Filter& b) {
  return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0;
}

struct Model {
  std::vector<Body> bodies;
  std::vector<Motion> motions;  ///< At t = 0, one per body.
  Forces forces;
  std::vector<Joint> joints;
  bool reduce_joints = true;  ///< Joints to the world in reduced coordinates where the scene allows it.

  std::vector<Shape> shapes;  ///< One per body.
  std::vector<int> surfaces;  ///< One per body: its surface, or no_surface where it never touches.
  std::vector<Plane> planes;
  std::vector<int> plane_surfaces;  ///< One per plane.
  std::vector<Material> materials;  ///< surface_count x surface_count, symmetric.
  int surface_count = 0;
  std::vector<BodyPair>
      apart;  ///< Ascending: pairs that do not touch each other, such as jointed neighbours.
  std::vector<Filter> filters, plane_filters;  ///< One per body and one per plane, or both empty: all touch.
  Impacts impacts = Impacts::sequential;

  std::optional<RotatingFrame> frame;

  /// Whether an end of a joint or a force is a body that can move.
  bool moves(int body) const { return body != fixed_world && !bodies[static_cast<std::size_t>(body)].locked; }

  /// Whether two bodies may touch each other, as far as `apart` and the filters say.
  bool may_touch(int a, int b) const {
    if (!filters.empty() &&
        !may_meet(filters[static_cast<std::size_t>(a)], filters[static_cast<std::size_t>(b)]))
      return false;
    return apart.empty() ||
           !std::binary_search(apart.begin(), apart.end(), BodyPair{std::min(a, b), std::max(a, b)});
  }
  /// The same of a body and a plane.
  bool may_touch_plane(int body, int plane) const {
    return filters.empty() ||
           may_meet(filters[static_cast<std::size_t>(body)], plane_filters[static_cast<std::size_t>(plane)]);
  }

  /// What makes a body fall [m/s^2]: its own gravity, else that of all.
  const Vector3& gravity_of(std::size_t body) const {
    return bodies[body].gravity ? *bodies[body].gravity : forces.gravity;
  }
  /// Bound on what makes any body fall [m/s^2]; O(bodies).
  Real strongest_gravity() const {
    Real most = forces.gravity.norm();
    for (const Body& body : bodies)
      if (body.gravity && !body.locked) most = std::max(most, body.gravity->norm());
    return most;
  }
  /// Whether a body that can move has a gravity of its own.
  bool has_own_gravity() const {
    return std::any_of(bodies.begin(), bodies.end(), [](const Body& b) { return b.gravity && !b.locked; });
  }

  const Material& material(int surface, int other) const {
    const auto row = static_cast<std::size_t>(surface) * static_cast<std::size_t>(surface_count);
    return materials[row + static_cast<std::size_t>(other)];
  }
};

}  // namespace cylon::engine
