// The physical situation as plain data: what every simulator gets, and all that it gets.
// Knows nothing of files, engines, claims or time steps.
//
// Conventions, fixed here once.  SI units; right-handed axes; y up.  The body frame sits at the
// centre of mass.  A quaternion is unit, (w, x, y, z), active, body to world.  Velocities are of
// the centre of mass, angular velocity in world axes.  Angular momentum is about the world origin.
#pragma once

#include "harness/core/joint_kinds.h"
#include "harness/core/shapes.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cylon::core {

/// Index of the fixed world where a body is asked for: the other end of a joint or a spring.
inline constexpr int world = -1;

/// Motion of one rigid body at one instant.
struct BodyState {
  Vector3 position = Vector3::Zero();               ///< Centre of mass [m].
  Quaternion orientation = Quaternion::Identity();  ///< Body to world, unit norm.
  Vector3 velocity = Vector3::Zero();               ///< Of the centre of mass [m/s].
  Vector3 angular_velocity = Vector3::Zero();       ///< World axes [rad/s].
};

/// One BodyState per body, in the order of Scene::bodies.
using State = std::vector<BodyState>;

// ---- Bodies, forces, constraints ---------------------------------------------------------------

struct Body {
  std::string name;
  double mass = 1;                        ///< [kg], > 0.
  Matrix3 inertia = Matrix3::Identity();  ///< About the centre of mass, body axes [kg m^2].
  BodyState initial;
  std::optional<Vector3> gravity;  ///< In place of the scene's uniform gravity [m/s^2].
  Shape shape;
  bool locked = false;   ///< Does not move, whatever acts on it.
  bool collide = false;  ///< Takes part in contacts; needs a shape.  False: in no group, with an empty mask.
  std::vector<std::string> collision_groups;  ///< In which it is; empty: in "default" (collision_filter.h).
  std::vector<std::string> collision_mask;    ///< Those that it touches; empty: all.
  std::string color;                          ///< For viewers, "#rrggbb" or empty.
};

/// F = m a on every body that states no gravity of its own.
struct UniformGravity {
  Vector3 acceleration = {0, -9.81, 0};  ///< [m/s^2]
};

/// F = (stiffness (|d| - rest_length) + damping d(|d|)/dt) d/|d| on `body`, -F on `to`, with d from
/// the anchor on `body` to the anchor on `to`.  At |d| = 0 with rest_length = 0 the force is zero.
struct Spring {
  int body = 0;
  Vector3 anchor = Vector3::Zero();  ///< Body axes [m].
  int to = world;
  Vector3 to_anchor = Vector3::Zero();  ///< Axes of `to`; of the world when `to` is the world [m].
  double stiffness = 0;                 ///< [N/m], >= 0.
  double rest_length = 0;               ///< [m], >= 0.
  double damping = 0;                   ///< [N s/m], >= 0.
};

/// F = -linear v; torque = -angular w - momentum L_spin.
struct Drag {
  int body = 0;
  double linear = 0;    ///< [kg/s], >= 0.
  double angular = 0;   ///< [kg m^2/s], >= 0.
  double momentum = 0;  ///< [1/s], >= 0.
};

/// Constant force in body axes, or a changing mass: dm/dt = mass_rate, the mass entering or leaving
/// with `exhaust_velocity` relative to the body (body axes) or with `exchanged_velocity` (world axes).
struct Thrust {
  int body = 0;
  Vector3 force = Vector3::Zero();            ///< Body axes [N].
  double mass_rate = 0;                       ///< [kg/s]; < 0 is a rocket.
  std::optional<Vector3> exhaust_velocity;    ///< Relative to the body, body axes [m/s].
  std::optional<Vector3> exchanged_velocity;  ///< World axes [m/s].
};

/// F = force cos(frequency t), world axes, at the centre of mass.
struct Drive {
  int body = 0;
  Vector3 force = Vector3::Zero();  ///< [N]
  double frequency = 0;             ///< [rad/s]
};

/// F = strength m_a m_b d/|d|^3 on `body`, -F on `to`, with d from `body` to `to`.
struct Attraction {
  int body = 0;
  int to = world;       ///< A body; the world is not allowed here.
  double strength = 0;  ///< [m^3/(kg s^2)]
};

/// Water below a surface.  Mode "volume": the surface is y = level + wave sin(x - speed t), level over the
/// width of a body; the displaced weight acts at the centroid of the submerged part, drag (V_sub/V) v against
/// the motion.  Mode "step": the surface is a table of 41 x 41 cells of 0.25 m around the origin, i =
/// trunc((x + 5)/0.25), j from z, y = level + wave/2 sin(speed t + i) + wave/2 sin(i j/2); on a body whose
/// centre is below it act a constant lift, -drag v and the torque -L.
struct Water {
  double level = 0;             ///< [m]
  double wave = 0;              ///< Amplitude [m].
  double speed = 0;             ///< Of the wave's phase [rad/s].
  double buoyancy = 0;          ///< mode step: force [N]; mode volume: density [kg/m^3].
  double drag = 0;              ///< [kg/s]
  std::string mode = "volume";  ///< "volume" (Archimedes) or "step" (constant lift below the surface).
};

/// A law in code of the user's own (cylon/force.h).  Nothing is known of it but the bodies on which it acts.
struct PluginForce {
  std::string plugin;                        ///< The name under which the user lets the library be loaded.
  std::string law;                           ///< Which of the laws in it.
  std::vector<int> bodies;                   ///< In the order that the law expects; each once.
  std::map<std::string, double> parameters;  ///< In the law's own units.
};

/// Closed on purpose: an adapter that misses a force does not compile.
using Force = std::variant<UniformGravity, Spring, Drag, Thrust, Drive, Attraction, Water, PluginForce>;

/// Which of the free coordinates of one kind.
enum class Ordinal { first, second, third };

/// What acts along one free coordinate q of a joint (joint_coordinates.h).  The generalised force
///   Q = force - stiffness (q - target(t)) - damping (q' - target'(t)) - quadratic_damping q' |q'|
/// acts on `body` along q, and its opposite on `to`: a spring, a damper, a motor or a servo.  Beside it: limits,
/// at which q' is reversed by `restitution`, and dry friction up to |Q| = `friction`, static = kinetic; and a rotor
/// geared to q, of kinetic energy armature q'^2/2 and no momentum of its own, so that Q moves it too.
/// Units are those of a displacement; of an angle rad in place of m, and N m in place of N.
struct JointCoordinate {
  Ordinal which = Ordinal::first;
  double start = 0;                    ///< q at t = 0 [m].
  std::optional<double> lower, upper;  ///< Of q [m]; absent: no limit.
  double restitution = 0;              ///< Of the limits, [0, 1].
  double force = 0;                    ///< [N]
  double stiffness = 0;                ///< [N/m], >= 0.
  double damping = 0;                  ///< [N s/m], >= 0.
  double quadratic_damping = 0;        ///< [N s^2/m^2], >= 0.
  double friction = 0;                 ///< [N], >= 0.
  double armature = 0;                 ///< [kg], >= 0.
  /// target(t) = target + target_amplitude cos(target_frequency t + target_phase)
  double target = 0, target_amplitude = 0;  ///< [m]
  double target_frequency = 0;              ///< [rad/s]
  double target_phase = 0;                  ///< [rad]
  std::vector<double> target_times;         ///< [s]; in place of the above: linear between these,
  std::vector<double> target_values;        ///< [m]; constant before the first and after the last.
};
struct JointDisplacement : JointCoordinate {};
struct JointAngle : JointCoordinate {};

struct Joint {
  JointType type = JointType::ball;
  int body = 0;
  int to = world;
  Vector3 point =
      Vector3::Zero();  ///< World coordinates at t = 0 [m]; unused by JointPlace::at_length of two bodies.
  Vector3 axis = Vector3::UnitY();  ///< World axes at t = 0, unit; JointKind::has_axis.
  double length = 0;                ///< [m]; JointKind::has_length.
  std::string name = {};            ///< For claims; empty: none.
  std::optional<Vector3> axis_2 =
      {};            ///< World axes at t = 0, unit, square to `axis`; JointKind::has_second_axis.
  double pitch = 0;  ///< Displacement by angle [m/rad], not 0; JointKind::screws.
  std::vector<JointDisplacement> displacements = {};  ///< Of the free ones those on which something acts.
  std::vector<JointAngle> angles = {};                ///< The same.
};

/// Solid where normal . x < offset.
struct Plane {
  std::string name;
  Vector3 normal = Vector3::UnitY();                          ///< Unit.
  double offset = 0;                                          ///< [m]
  std::vector<std::string> collision_groups, collision_mask;  ///< As those of a body.
};

/// Physics of a *pair* of surfaces; what an engine multiplies or averages to get there is its adapter's
/// affair.
struct Material {
  std::string between[2];  ///< Names of bodies or planes; "*" matches all, an exact pair wins.
  double restitution = 0;  ///< [0, 1]
  double friction = 0;     ///< Coulomb, static = kinetic, >= 0.
};

/// The frame in which the whole scene is given, as seen from the inertial frame: initial state, pins, planes,
/// gravity and the results are all expressed in it.  Its origin moves with `velocity` and it turns about that
/// origin; the axes agree with the inertial ones at t = 0.  A turning frame has fictitious forces,
///   F = -m (a + 2 w x v + w' x r + w x (w x r)),   the same law for each mass element;
/// one that only moves on has none (Galilei): gravity, springs and drag are those of the frame, and `velocity`
/// changes nothing in the results.
///   a(t) = acceleration cos(frequency t),   w(t) = angular_velocity + angular_acceleration t
/// Both in the axes of the frame.
struct Frame {
  Vector3 velocity = Vector3::Zero();              ///< [m/s]
  Vector3 angular_velocity = Vector3::Zero();      ///< At t = 0 [rad/s].
  Vector3 acceleration = Vector3::Zero();          ///< [m/s^2]
  double frequency = 0;                            ///< [rad/s], >= 0.
  Vector3 angular_acceleration = Vector3::Zero();  ///< [rad/s^2]

  Vector3 angular_velocity_at(double t) const { return angular_velocity + t * angular_acceleration; }
  bool turns() const { return !angular_velocity.isZero(0) || !angular_acceleration.isZero(0); }
  /// Whether it has fictitious forces.
  bool pushes() const { return turns() || !acceleration.isZero(0); }
};

/// How several impacts at one instant resolve.
enum class Impacts { sequential, simultaneous };

struct Scene {
  std::vector<Body> bodies;
  std::vector<Force> forces;
  std::vector<Joint> joints;
  std::vector<Plane> planes;
  std::vector<Material> materials;
  std::optional<Frame> frame;
  Impacts impacts = Impacts::sequential;
};

/// A body and a plane (other = world), or two bodies (plane < 0), that may touch.
struct Pair {
  int body = 0;
  int other = world;
  int plane = -1;
  friend bool operator==(const Pair&, const Pair&) = default;
};

/// Sum of the uniform gravities [m/s^2].  What falls may have its own: see gravity_of.
Vector3 gravity(const Scene&);

/// Whether the scene's frame has fictitious forces.
bool has_fictitious_forces(const Scene&);

/// What makes a body of the scene fall: its own gravity, else that of the scene [m/s^2].
Vector3 gravity_of(const Scene&, const Body&);

/// Whether a law in code of the user's own acts.
bool has_plugin_force(const Scene&);

/// Whether a body states a gravity of its own.
bool states_own_gravity(const Scene&);

/// Bound on what makes any body fall that can move [m/s^2].
double strongest_gravity(const Scene&);

/// The motion at t = 0, in the order of Scene::bodies.
State initial_state(const Scene&);

/// Every pair that may touch: colliding bodies of which at least one moves and that no joint ties, and
/// colliding bodies with planes, less what groups and masks keep apart; bodies first by index, then planes.
std::vector<Pair> touching_pairs(const Scene&);

/// Those of touching_pairs that `body` is in, in the same order; O(bodies).
std::vector<Pair> touching_pairs(const Scene&, int body);

/// Shows the pairs of touching_pairs, in the same order, until `found` says true; whether it did.
bool any_touching_pair(const Scene&, const std::function<bool(const Pair&)>& found);

/// The material of a pair: an exact match of both names, else one name with "*", else "*" with "*";
/// nothing when the scene states none.
std::optional<Material> material_of(const Scene&, const Pair&);

/// World-axes inertia R I R^T of a body in a given orientation [kg m^2].
Matrix3 world_inertia(const Body&, const Quaternion& orientation);

/// I = A diag(moments) A^T: principal moments in ascending-index order of the closest body axes and
/// the rotation A from principal to body axes.  A diagonal inertia gives the identity exactly.
struct PrincipalAxes {
  Vector3 moments;
  Quaternion rotation;
};
PrincipalAxes principal_axes(const Matrix3& inertia);

/// The shortest turn that takes one direction to another.
Quaternion turn_between(const Vector3& from, const Vector3& to);

}  // namespace cylon::core
