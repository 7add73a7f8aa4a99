// Free rigid body with two equal moments I1 and the third I3 about the body axis a.  L is fixed in space:
//
//     q(t) = rot(L/|L|, |L| t/I1) q0 rot(a, w3 (1 - I3/I1) t),   w(t) = rot(L/|L|, |L| t/I1) w0
//
// Oblate, prolate or spherical, a in any direction; the centre of mass moves uniformly or falls.
#include "reference/exact/domain.h"
#include "reference/exact/flight.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"
#include "reference/exact/symmetry.h"

namespace cylon::exact {
namespace {

struct SymmetricTop {
  Flight flight;
  Symmetry body;
  WideVector momentum;
  Wide own_spin;  // rate of the rotation about the axis that precession leaves

  SymmetricTop(const core::Body& b, const core::Vector3& g)
      : flight(b.initial, g), body(symmetry(b.inertia)) {
    const WideQuaternion& q = flight.orientation;
    const WideVector w = q.conjugate() * flight.angular_velocity;
    const Wide w3 = w.dot(body.axis);
    momentum = q * WideVector(body.transverse * (w - w3 * body.axis) + body.axial * w3 * body.axis);
    own_spin = w3 * (1 - body.axial / body.transverse);
  }

  WideState at(Wide t) const {
    WideState s = flight.at(t);
    const WideQuaternion precession = turn_by(momentum / body.transverse, t);
    s.orientation = precession * flight.orientation * turn(body.axis, own_spin * t);
    s.angular_velocity = precession * flight.angular_velocity;
    return s;
  }
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<SymmetricTop> tops;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) tops.emplace_back(scene.bodies[i], gravity(scene, i));
  return together(std::move(tops));
}

}  // namespace

core::Truth free_symmetric_top(const core::Scene& scene, double horizon) {
  constexpr auto name = "free_symmetric_top";
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) check_symmetric(name, scene, static_cast<int>(i));
  core::StateError error = rounding_error(scene, solve, horizon);
  add_difference(scene, horizon, error);
  return {.state = solve(scene),
          .error = error,
          .source = "Landau & Lifshitz, Mechanics, section 33: regular precession",
          .horizon = horizon};
}

}  // namespace cylon::exact
