// A world of Siconos behind plain numbers, in a library of its own: Siconos's headers are C++17, and not C++20 (its
// NSLawMatrix.hpp needs the `construct` of std::allocator).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cylon::simulators::siconos_border {

using Vector = std::array<double, 3>;

struct Motion {
  Vector position{};
  std::array<double, 4> orientation{1, 0, 0, 0};  ///< Unit quaternion w, x, y, z, body to world.
  Vector velocity{}, spin{};                      ///< The spin in body axes.
};

/// A body that moves.
struct Body {
  double mass = 1;
  std::array<double, 9> inertia{};  ///< Body axes.
  Motion start;
};

/// What a sphere may touch.
enum class Partner { plane, still_sphere, moving_sphere };

/// A sphere that moves, and what it may touch.
struct Contact {
  int body = 0;
  double radius = 0;
  Partner partner = Partner::plane;
  int other = -1;      ///< A moving sphere's body.
  Vector place{};      ///< The unit normal of a plane, the centre of a sphere that does not move.
  double measure = 0;  ///< The offset of a plane along its normal, the radius of a sphere.
  double restitution = 0, friction = 0;
};

/// A solver of contacts with friction.
struct FrictionSolver {
  std::string name;
  double tolerance = 0;  ///< Of its residual.
  int iterations = 0;    ///< At most, in a step.
};

/// Siconos's, by our names, with what each has by itself; NSGS, which Siconos takes by itself, is the first.
const std::vector<FrictionSolver>& friction_solvers();

struct Settings {
  double dt = 1e-3, theta = 0.5;
  std::size_t solver = 0;  ///< Place among friction_solvers().
  double newton_tolerance = 1e-6;
  int newton_iterations = 50;
  std::optional<double> solver_tolerance;  ///< Without a value, the solver's own; so with its iterations.
  std::optional<int> solver_iterations;
};

/// What pressed in the last step.
struct Pressed {
  int contact = 0;
  Vector point{}, normal{};  ///< World; the normal towards the contact's body.
  double along = 0;          ///< Impulse [N s].
  Vector across{};           ///< Of friction, on the contact's body, world axes [N s].
};

/// Solver failures since the start.  Siconos prints a warning and uses the unconverged result.
struct Complaints {
  std::int64_t of_solver = 0;  ///< The contact solver returned an error code.
  std::int64_t of_newton = 0;  ///< Newton's iteration of a step reached its bound.
};

class World {
 public:
  World(const std::vector<Body>&, const std::vector<Contact>&, const Settings&);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// During the next step: force through the centre of mass in world axes, torque about it in body axes.
  void push(std::size_t body, const Vector& force, const Vector& torque);
  void set_mass(std::size_t body, double mass);
  void step();

  Motion motion(std::size_t body) const;
  std::vector<Pressed> pressed() const;
  const Complaints& complaints() const;

  /// What Siconos holds, for tests.
  double mass(std::size_t body) const;
  std::array<double, 9> inertia(std::size_t body) const;
  std::optional<FrictionSolver> solver() const;  ///< None where no contact has friction.

  /// Siconos's own values of what a run may set.
  static Settings defaults();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cylon::simulators::siconos_border
