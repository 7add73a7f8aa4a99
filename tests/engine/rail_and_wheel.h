// One body on a rail, and one that turns about an axis through its centre of mass; both to the world, in general places.
#pragma once

#include "tests/engine/joint_scenes.h"

namespace cylon::engine {

inline constexpr Real rail_mass = 1.3;
inline const Vector3 rail_axis = Vector3(0.3, -0.5, 0.8).normalized(), rail_start = {0.2, 0.4, -0.3};

/// Along the rail, from its start.
inline Coordinate along_rail() {
  Coordinate q;
  q.to_anchor = rail_start;
  q.axis = rail_axis;
  return q;
}
inline Real along_rail(const std::vector<Motion>& motions) {
  return rail_axis.dot(motions[0].position - rail_start);
}

inline Model body_on_rail(Real speed) {
  Model model;
  add_body(model, make_body(rail_mass, general_inertia(0.05, 0.07, 0.1)), rail_start, {0.5, 1.1, -0.6},
           speed * rail_axis, {0, 0, 0});
  model.joints.push_back({.type = joint_types::slider,
                          .body = 0,
                          .to_anchor = rail_start,
                          .to_axis = rail_axis,
                          .relative = model.motions[0].orientation});
  return model;
}

struct Wheel {
  Model model;
  Real inertia;  ///< About its axis.
  Coordinate angle;
};
inline Wheel wheel_that_turns(Real speed) {
  Wheel w;
  const Vector3 turn = {0.5, 1.1, -0.6};
  add_body(w.model, make_body(rail_mass, general_inertia(0.05, 0.07, 0.1)), rail_start, turn, {0, 0, 0},
           speed * rail_axis);
  const Vector3 own = exponential(turn).conjugate() * rail_axis;
  w.inertia = own.dot(w.model.bodies[0].inertia * own);
  w.model.joints.push_back(
      {.type = joint_types::hinge, .body = 0, .to_anchor = rail_start, .axis = own, .to_axis = rail_axis});
  w.angle.kind = Coordinate::Kind::angle;
  w.angle.axis = rail_axis;
  w.angle.zero = rail_axis.unitOrthogonal();
  w.angle.mark = exponential(turn).conjugate() * w.angle.zero;
  return w;
}

}  // namespace cylon::engine
