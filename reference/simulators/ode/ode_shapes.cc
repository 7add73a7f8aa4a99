#include "reference/simulators/ode/ode_shapes.h"

#include "harness/core/overloaded.h"

#include <ode/ode.h>

#include <array>

namespace cylon::simulators {
namespace {

using core::Overloaded;
using core::Quaternion;
using core::Vector3;

// ODE's axis of revolution is z, ours y: a turn by -90 degrees about x.
const Quaternion z_to_y = core::turn_between(Vector3::UnitZ(), Vector3::UnitY());

// A primitive in its own axes, and the turn from ODE's axes to ours.
struct Geom {
  dGeomID id = nullptr;
  Quaternion turn = Quaternion::Identity();
};

Geom make(dSpaceID space, const core::Primitive& shape) {
  return std::visit(
      Overloaded{[&](const core::Sphere& s) { return Geom{dCreateSphere(space, s.radius)}; },
                 [&](const core::Box& s) {
                   const Vector3 sides = 2 * s.half_extents;
                   return Geom{dCreateBox(space, sides.x(), sides.y(), sides.z())};
                 },
                 [&](const core::Capsule& s) {
                   return Geom{dCreateCapsule(space, s.radius, s.length), z_to_y};
                 },
                 [&](const core::Cylinder& s) {
                   return Geom{dCreateCylinder(space, s.radius, s.length), z_to_y};
                 },
                 [](const std::monostate&) { return Geom{}; },
                 // ode_limit refuses these.
                 [](const core::Cone&) { return Geom{}; }, [](const core::Rod&) { return Geom{}; },
                 [](const core::Disc&) { return Geom{}; }, [](const core::Hull&) { return Geom{}; },
                 [](const core::Mesh&) { return Geom{}; }},
      shape);
}

// p and q: the primitive in the body frame.
void place(const Geom& geom, const core::Body& body, dBodyID id, const Vector3& p, const Quaternion& q) {
  const auto turn = [](const Quaternion& r) { return std::array<dReal, 4>{r.w(), r.x(), r.y(), r.z()}; };
  if (id) {
    dGeomSetBody(geom.id, id);
    if (!p.isZero(0)) dGeomSetOffsetPosition(geom.id, p.x(), p.y(), p.z());
    const Quaternion offset = q * geom.turn;
    if (!offset.vec().isZero(0)) dGeomSetOffsetQuaternion(geom.id, turn(offset).data());
  } else {
    const Quaternion& r = body.initial.orientation;
    const Vector3 x = body.initial.position + r * p;
    dGeomSetPosition(geom.id, x.x(), x.y(), x.z());
    dGeomSetQuaternion(geom.id, turn(r * q * geom.turn).data());
  }
}

}  // namespace

void ode_add_shape(dSpaceID space, const core::Body& body, dBodyID id, void* owner) {
  const auto add = [&](const core::Primitive& shape, const Vector3& p, const Quaternion& q) {
    const Geom geom = make(space, shape);
    if (!geom.id) return;
    dGeomSetData(geom.id, owner);
    place(geom, body, id, p, q);
  };
  std::visit(Overloaded{[&](const core::Compound& compound) {
                          for (const core::Part& part : compound.parts)
                            add(part.shape, part.position, part.orientation);
                        },
                        [&](const auto& shape) { add(shape, Vector3::Zero(), Quaternion::Identity()); }},
             body.shape);
}

}  // namespace cylon::simulators
