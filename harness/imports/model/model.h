// A foreign model as its own library reads it: bodies, their surfaces, what may move between them, and what was lost.
// In the axes of the file (z up), with all poses of the start.  The importers write it, harness/imports makes a scene of
// it.  Knows neither a format nor a scene.
#pragma once

#include "harness/core/shapes.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cylon::foreign {

using core::Matrix3;
using core::Quaternion;
using core::Vector3;

/// Where the file says it, as far as the library tells.
struct Place {
  std::string element;  ///< "joint 'hip'"
  std::string file;     ///< Empty: that which was asked for.
  int line = 0;         ///< 0: not told.
};

struct Pose {
  Vector3 position = Vector3::Zero();
  Quaternion turn = Quaternion::Identity();

  Pose operator*(const Pose& inner) const { return {position + turn * inner.position, turn * inner.turn}; }
  Pose inverse() const { return {-(turn.conjugate() * position), turn.conjugate()}; }
};

/// What can be touched.  Axis of revolution along z.
struct Solid {
  Place place;
  std::string
      kind;  ///< sphere, box, capsule, cylinder, hull, mesh, plane (solid below z = 0), or one that no scene has.
  Vector3 size =
      Vector3::Zero();            ///< Half extents, or radius and length (of a capsule, of its cylinder) [m].
  std::vector<Vector3> vertices;  ///< Of hulls and meshes [m].
  std::vector<std::array<std::int32_t, 3>> faces;
  Pose pose;        ///< In the body, from its centre of mass.
  int surface = 0;  ///< Its kind in Model::meetings.
};

/// A rigid body.  Its frame sits at the centre of mass, with the axes of the file's own frame.
struct Body {
  Place place;
  std::string name;
  double mass = 0;                     ///< [kg]; 0: only a frame, which must be fixed to another body.
  Matrix3 inertia = Matrix3::Zero();   ///< About the centre of mass, body axes [kg m^2].
  Pose pose;                           ///< In the world.
  Vector3 velocity = Vector3::Zero();  ///< Of the centre of mass [m/s].
  Vector3 spin = Vector3::Zero();      ///< World axes [rad/s].
  bool locked = false;
  std::optional<Vector3> gravity;            ///< In place of the model's [m/s^2].
  double linear_drag = 0, angular_drag = 0;  ///< [N s/m], [N m s/rad].
  std::vector<Solid> solids;
};

/// One motion that a joint leaves, and what acts along it.
struct Freedom {
  std::string kind;  ///< turn and slide (of `body` against `to`, about or along `axis`), screw, ball
  Vector3 axis = Vector3::UnitZ();  ///< World axes at the start, unit.
  double pitch = 0;                 ///< Of a screw [m/rad].
  double start = 0;                 ///< Value of the coordinate in the pose of the model.
  std::optional<double> lower{}, upper{};
  double stiffness = 0, rest = 0, damping = 0, friction = 0, force = 0;
  double armature = 0;  ///< Inertia of a rotor that turns with the coordinate [kg, kg m^2].
  double moved = 0;     ///< All that moves with it in the pose of the model, the rotor too; of a rotor.
};

/// In the order from `to` to `body`; none: fixed.
struct Joint {
  Place place;
  std::string name;
  int body = 0;
  int to = -1;                      ///< -1: the world.
  Vector3 point = Vector3::Zero();  ///< World, at the start.
  /// Of two turns about axes that do not meet: how far the second is along first x second from `point` of the first [m].
  double offset = 0;
  std::vector<Freedom> freedoms;
  bool one_body = false;   ///< Of fixed joints: the format itself takes both for one rigid body.
  bool may_touch = false;  ///< In the format its two bodies touch each other where their surfaces do.
};

/// Two kinds of surface that touch.
struct Meeting {
  int a = 0, b = 0;
  double friction = 0, restitution = 0;
};

/// What the model has and a scene has not; `what` is a row of harness/imports/losses.h.
struct Loss {
  std::string what;
  Place place;
  std::string detail;
};

struct Model {
  std::string library;  ///< "MuJoCo 2.2.2"
  Vector3 gravity = {0, 0, -9.81};
  double step = 0.001;  ///< [s]
  std::vector<Body> bodies;
  std::vector<Joint> joints;
  std::vector<Meeting> meetings;
  std::vector<Loss> losses;
};

}  // namespace cylon::foreign
