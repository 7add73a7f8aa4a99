// The parts of a model while it is made.
#pragma once

#include "reference/certified/model.h"

#include <string>

namespace cylon::certified {

/// One body's motion as nodes: of constants at the start, of states afterwards.
struct Motion {
  Vector position, velocity, spin;  ///< spin: angular velocity in body axes, relative to the scene's frame.
  std::array<Expr, 4> orientation;
  Matrix rotation;               ///< Body to world, from the orientation.
  Vector force, torque;          ///< World axes; body axes.
  Vector acceleration, turning;  ///< dv/dt; d spin/dt in body axes.
};

/// What does not change with the motion.
struct Frozen {
  bool locked = false, turns = false;
  Expr mass;                ///< Of time, where mass comes or goes.
  Matrix inertia, inverse;  ///< About the centre of mass; of a pinned body the inverse is about the pivot, of
                            ///< one with one axis about that axis.
  int pin =
      -1;  ///< The joint that holds a point of the body in the world; no states for place and velocity then.
  bool one_axis = false;  ///< And the pin leaves one axis: no equations for what it forbids.
  Vector pivot, arm;      ///< That point of the world; from there to the centre of mass, body axes.
};

struct Builder {
  const core::Scene& scene;
  Graph& graph;
  const Numbers& numbers;
  std::vector<Frozen> bodies;
  std::vector<Motion> start;  ///< Constants alone.

  Expr number(double x) const { return {&graph, graph.constant(numbers(x))}; }
  Expr exact(double x) const { return {&graph, graph.constant(x)}; }
  Vector vector(const core::Vector3& v) const { return {number(v[0]), number(v[1]), number(v[2])}; }
  Vector zero() const { return {exact(0), exact(0), exact(0)}; }
};

[[noreturn]] void refuse(const std::string& condition);

/// R of q = (w, x, y, z), unit.
Matrix rotation(const std::array<Expr, 4>& q);

/// Throws core::OutOfDomain for what no equation here describes.
void check_domain(const core::Scene&, double horizon, Blows);

/// "body 'a' and plane 'b'"
std::string names_of(const core::Scene&, const core::Pair&);

/// The pairs that may touch; their nodes are of these motions.  Throws core::OutOfDomain for friction, other
/// shapes than spheres and planes, joints, and what depends on time.
void add_contacts(const Builder&, const std::vector<Motion>&, std::vector<Contact>&);

/// Adds every force of the scene to the motions.
void add_forces(const Builder&, std::vector<Motion>&);

/// A state variable beside those of the bodies.
struct Extra {
  Expr rate;
};

/// Adds what acts along the coordinates of joints.  What that needs of states is made here, in the order of `extras`.
void add_joint_forces(const Builder&, std::vector<Motion>&, std::vector<Extra>& extras,
                      std::vector<Ball>& initial);

/// One scalar equation sum_k linear_k . v'_k + angular_k . spin'_k + rest = 0, and the same sum over v and
/// spin for the rate of what is kept.
struct Row {
  struct Part {
    std::size_t body;
    Vector linear, angular;  ///< World axes; body axes.
  };
  std::vector<Part> parts;
  Expr rest;
  double rotor = 0;  ///< Of a row of rotor_rows(): its inertia [kg, kg m^2].
};

/// R (w x (w x r)): what r, fixed in a turning body, accelerates by, beside R (w' x r).
Vector centripetal(const Motion&, const Vector& r);

/// Where a pinned body's centre is, from its orientation and spin.
void place_on_pin(const Frozen&, Motion&);

/// The equations of all joints at these motions; their geometry is that of the start.
std::vector<Row> joint_rows(const Builder&, const std::vector<Motion>&);

/// Rows of which the sum is the acceleration q'' of a coordinate with a rotor, which pulls against it by rotor q''.
std::vector<Row> rotor_rows(const Builder&, const std::vector<Motion>&);

/// Nodes of the lower triangle of J M^-1 J^T, row by row.
std::vector<int> products(const Builder&, const std::vector<Row>&);

/// C rows, with parameters C, lower triangular: the same equations.  Where C J M^-1 J^T C^T is nearly 1 their elimination
/// does not multiply what a series leaves out, which it does a millionfold of a loop's rows as they come.
std::vector<Row> combined(const Builder&, const std::vector<Row>&, std::vector<int>& parameters);

/// x := x - M^-1 J^T (J M^-1 J^T + D)^-1 (J x + rest), on accelerations, or, at the start and without rest, on
/// velocities; D = 1/rotor on the diagonal of rows that have one, else 0.
void solve_joints(const Builder&, const std::vector<Row>&, std::vector<Vector>& linear,
                  std::vector<Vector>& angular, bool with_rest);

}  // namespace cylon::certified
