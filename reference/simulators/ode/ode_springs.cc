#include "reference/simulators/ode/ode_springs.h"

#include <ode/ode.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace cylon::simulators {
namespace {

using core::Vector3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// An end of a spring.
struct End {
  dBodyID id = nullptr;              // of what moves
  Vector3 anchor = Vector3::Zero();  // body axes; of the world where there is no body
  Vector3 place = Vector3::Zero();   // of the world
};

End end_of(const core::Scene& scene, const std::vector<dBodyID>& bodies, int body, const Vector3& anchor) {
  if (body == core::world) return {nullptr, anchor, anchor};
  const core::BodyState& s = scene.bodies[at(body)].initial;
  const Vector3 place = s.position + s.orientation * anchor;
  return {bodies[at(body)], bodies[at(body)] ? anchor : place, place};
}

}  // namespace

bool ode_stiff(const core::Spring& spring, const core::Scene& scene, double dt) {
  double mass = std::numeric_limits<double>::infinity();
  for (const int i : {spring.body, spring.to})
    if (i != core::world && !scene.bodies[at(i)].locked) mass = std::min(mass, scene.bodies[at(i)].mass);
  return dt * dt * spring.stiffness + dt * spring.damping > mass;
}

void ode_add_spring(dWorldID world, const core::Spring& spring, const core::Scene& scene,
                    const std::vector<dBodyID>& bodies, double dt) {
  End a = end_of(scene, bodies, spring.body, spring.anchor);
  End b = end_of(scene, bodies, spring.to, spring.to_anchor);
  if (!a.id) std::swap(a, b);  // ODE reverses a joint whose first body is the world
  const double stiffness = dt * spring.stiffness + spring.damping;
  if (!a.id || !(stiffness > 0)) return;
  const double erp = dt * spring.stiffness / stiffness, cfm = 1 / stiffness;
  if (spring.rest_length > 0) {
    dJointID id = dJointCreateDBall(world, nullptr);
    dJointAttach(id, a.id, b.id);
    dJointSetDBallAnchor1(id, a.place.x(), a.place.y(), a.place.z());
    dJointSetDBallAnchor2(id, b.place.x(), b.place.y(), b.place.z());
    dJointSetDBallDistance(id, spring.rest_length);
    dJointSetDBallParam(id, dParamERP, erp);
    dJointSetDBallParam(id, dParamCFM, cfm);
    return;
  }
  dJointID id = dJointCreateBall(world, nullptr);
  dJointAttach(id, a.id, b.id);
  dJointSetBallAnchor(id, a.place.x(), a.place.y(), a.place.z());
  dJointSetBallAnchor2(id, b.anchor.x(), b.anchor.y(), b.anchor.z());
  dJointSetBallParam(id, dParamERP, erp);
  dJointSetBallParam(id, dParamCFM, cfm);
}

}  // namespace cylon::simulators
