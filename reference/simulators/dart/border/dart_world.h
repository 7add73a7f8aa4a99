// A world of DART behind plain numbers, in a shared library of its own.
//
// DART's types hold Eigen's.  Debian builds DART for x86-64, where Eigen aligns to 16 bytes; the rest of this program is
// built for x86-64-v3, where it aligns to 32.  Objects of the one must not meet functions of the other, so no type of
// Eigen crosses this border, and the linker keeps the functions apart (cmake/engines.cmake).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace cylon::simulators::dart_border {

using Vector = std::array<double, 3>;
using Turn = std::array<double, 4>;  ///< Unit quaternion w, x, y, z, body to world.

struct Motion {
  Vector position{};  ///< Of the centre of mass.
  Turn orientation{1, 0, 0, 0};
  Vector velocity{}, spin{};  ///< World axes.
};

enum class Hang { freely, by_ball, by_gimbal, by_hinge, by_slider, by_screw, by_universal, in_plane, fixed };

/// What holds a coordinate of a joint, which is 0 at the start [m, rad].
struct Held {
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  double friction = 0;  ///< Dry [N, N m].
};

struct Body {
  double mass = 1;
  std::array<double, 9> inertia{};  ///< About the centre of mass, body axes.
  Motion start;
  bool moves = true;
  bool falls = true;  ///< The gravity of the scene acts on it.
  Hang hang = Hang::freely;
  int parent = -1;  ///< A body that moves; -1: the world.
  Vector point{};   ///< Of the joint, world, at the start.
  Vector axis{};  ///< Of a hinge, slider or screw, world, at the start; the normal of a plane; of a universal
                  ///< joint and a gimbal the one that is fixed in the parent.
  Vector
      axis_2{};  ///< The other axis of a universal joint or a gimbal, or the first displacement in a plane.
  double pitch = 0;  ///< Of a screw [m/rad].
  /// In the order of turns and slides: of a universal joint about axis and axis_2; of a gimbal about these and then
  /// axis x axis_2; in a plane along axis_2 and axis x axis_2, and then about axis.
  std::array<Held, 3> held{};
  Vector turn_rate{};   ///< Against the parent, world axes, at the start.
  Vector slide_rate{};  ///< The same of the velocity of the body at the point.
};

/// A joint that closes a loop; bodies of which the first moves, the second moves or is -1, the world.
struct Loop {
  bool turns = true;
  int body = 0, to = -1;
  Vector point{};  ///< World, at the start.
};

/// A sphere or a box, on a body; only what meets is asked whether it touches.
struct Shape {
  int body = 0;
  bool sphere = true;
  Vector size{};  ///< Edges; of a sphere its radius first.
  Vector position{};
  Turn orientation{1, 0, 0, 0};  ///< Shape to body.
  double restitution = 0, friction = 0;
};

enum class Solver { dantzig, dantzig_alone, pgs };

struct Settings {
  double dt = 1e-3;
  Vector gravity{};
  Solver solver = Solver::dantzig;
  int sweeps = 30;
  double change = 1e-6, relative_change = 1e-3;
  double contact_erp = 0.01, contact_correction = 1e-3, contact_cfm = 1e-5;
  double loop_erp = 0.01, loop_cfm = 1e-9;
};

struct Contact {
  int first = 0, second = 0;          ///< Shapes.
  Vector point{}, normal{}, force{};  ///< World; the normal towards the first, the force on it [N].
};

/// Solver failures since the start, one system of contacts and loops each.  DART's own calls do not report them.
struct Unsolved {
  std::int64_t given_up = 0;    ///< Dantzig's method failed, and sweeps took over.
  std::int64_t left = 0;        ///< The last method failed too; the step uses its unconverged impulses.
  std::int64_t not_finite = 0;  ///< Of these: impulses that were not finite, which DART sets to zero.
};

class World {
 public:
  using Meets = std::function<bool(int shape, int other)>;

  World(const std::vector<Body>&, const std::vector<Shape>&, const std::vector<Loop>&, const Settings&,
        Meets);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// During the next step; world axes, the force through the centre of mass.
  void push(std::size_t body, const Vector& force, const Vector& torque);
  void set_mass(std::size_t body, double mass);
  void step();

  /// Of a body that moves.
  Motion motion(std::size_t body) const;
  /// Of the last step.
  std::vector<Contact> contacts() const;
  Unsolved unsolved() const;

  /// What DART holds, for tests.
  double mass(std::size_t body) const;
  std::array<double, 9> inertia(std::size_t body) const;
  std::size_t freedoms() const;

  /// DART's own values of what a run may set.
  static Settings defaults();
  static const char* version();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cylon::simulators::dart_border
