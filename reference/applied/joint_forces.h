// The smooth law along the coordinates of joints, as forces on bodies of a state: for engines that have no such law.
#pragma once

#include "harness/core/joint_coordinates.h"
#include "reference/applied/wrench.h"

#include <vector>

namespace cylon::applied {

class JointForces {
 public:
  explicit JointForces(const core::Scene&);

  /// Whether any force acts along a joint; limits and dry friction are none.
  bool any() const { return !joints_.empty(); }

  /// Adds  Q = force - k (q - target(t)) - c (q' - target'(t)) - c2 q' |q'|  along each coordinate.  An angle is counted on
  /// from the state before: between two calls it changes by less than half a turn.
  void add(double t, const core::State&, std::vector<Wrench>&);

 private:
  struct Acting {
    core::HeldJoint joint;
    std::vector<double> angles;  // as they were last, one per HeldJoint::angles [rad]
  };
  std::vector<Acting> joints_;
};

}  // namespace cylon::applied
