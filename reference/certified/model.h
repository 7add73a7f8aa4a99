// A smooth scene as an initial value problem: state variables, their rates of change, and what is read from
// them.
#pragma once

#include "harness/core/scene.h"
#include "harness/core/truth.h"
#include "reference/certified/graph.h"

#include <functional>
#include <string>

namespace cylon::certified {

/// What a number of the scene means.  The default takes each double as exactly itself.
using Numbers = std::function<Ball(double)>;
inline Ball exactly(double x) { return Ball(x); }

/// Nodes of one body's motion; world axes (of the scene's frame where it has one), as core::BodyState.
struct BodyNodes {
  std::array<int, 3> position, velocity;
  std::array<int, 4> orientation;  ///< (w, x, y, z)
  std::array<int, 3> angular_velocity;
};

/// A pair that may touch.
struct Contact {
  core::Pair pair;
  std::string names;  ///< Of the pair, for messages.
  int gap = -1;       ///< Positive where they are apart: [m], of two spheres the squares' difference [m^2].
  int rate = -1;      ///< d gap/dt.
  std::vector<std::array<int, 2>>
      after;  ///< State variables that a blow changes: index, node of the new value.
};

/// Whether blows between smooth arcs are described (Model::contacts) or refused.
enum class Blows { refused, described };

/// J M^-1 J^T of the equations of joints, from which their combinations are chosen.
struct Gram {
  explicit Gram(slong bits) : graph(bits) {}
  Graph graph;               ///< Of the same states in the same order as the model's, or the first of them.
  std::vector<int> entries;  ///< Of the lower triangle, row by row.
};

struct Model {
  Graph graph;
  std::vector<Ball> initial;      ///< One per state variable.
  std::vector<BodyNodes> bodies;  ///< In the order of the scene.
  std::vector<Contact> contacts;
  Gram gram;  ///< Empty where the equations are few.
  std::vector<int>
      combinations;  ///< Parameters C, lower triangular, row by row; best so that C gram C^T = 1.
};

/// Newton's and Euler's equations of a scene: p' = v, m v' = F, q' = q w/2, I w' = torque - w x I w with w in
/// body axes; joints by Lagrange's multipliers.  A body that nothing turns keeps its orientation and has no
/// state for it.  Quaternions are normalised.  A distance joint keeps the distance that the initial positions
/// have, hinges and balls keep their points in both bodies, and initial velocities lose what a joint forbids
/// (at most what the loader lets pass), by the least change in kinetic energy's norm. Throws
/// core::OutOfDomain for scenes that are not smooth: contacts (with Blows::described only those that are not
/// frictionless, between spheres without joints and planes), water; for joints whose equations depend on
/// each other; for a mass that vanishes before `horizon` [s].
Model make_model(const core::Scene&, double horizon, slong bits, const Numbers& = exactly,
                 Blows = Blows::refused);

}  // namespace cylon::certified
