#include "reference/simulators/ode/ode_shapes.h"

#include "harness/core/overloaded.h"
#include "reference/applied/parts.h"

#include <ode/ode.h>

#include <array>
#include <vector>

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

Geom make(dSpaceID space, OdeSurfaces& surfaces, const core::Primitive& shape) {
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
                 [&](const core::Mesh& s) { return Geom{surfaces.make(space, s)}; }},
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

void add(dSpaceID space, OdeSurfaces& surfaces, const core::Part& part, const core::Body& body, dBodyID id,
         void* owner) {
  const Geom geom = make(space, surfaces, part.shape);
  if (!geom.id) return;
  dGeomSetData(geom.id, owner);
  place(geom, body, id, part.position, part.orientation);
}

// A shape that is larger by a factor; what ODE has no primitive for stays.
core::Primitive grown(core::Primitive shape, double factor) {
  std::visit(Overloaded{[&](core::Sphere& s) { s.radius *= factor; },
                        [&](core::Box& s) { s.half_extents *= factor; },
                        [&](core::Capsule& s) { s.radius *= factor, s.length *= factor; },
                        [&](core::Cylinder& s) { s.radius *= factor, s.length *= factor; },
                        [](std::monostate&) {}, [](core::Cone&) {}, [](core::Rod&) {}, [](core::Disc&) {},
                        [](core::Hull&) {}, [](core::Mesh&) {}},
             shape);
  return shape;
}

}  // namespace

bool ode_stacked(const core::Scene& scene) {
  constexpr double factor = 1 + 1e-6;
  OdeSurfaces surfaces;
  dSpaceID space = dHashSpaceCreate(nullptr);
  std::vector<std::size_t> owners(scene.bodies.size());  // geoms point at them
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    core::Body body = scene.bodies[i];
    if (body.locked || !body.collide) continue;
    owners[i] = i;
    for (core::Part& part : applied::parts_of(body.shape)) {
      part.shape = grown(part.shape, factor);
      add(space, surfaces, part, body, nullptr, &owners[i]);
    }
  }
  bool found = false;
  dSpaceCollide(space, &found, [](void* result, dGeomID a, dGeomID b) {
    dContactGeom contact;
    auto& touching = *static_cast<bool*>(result);
    touching =
        touching || (dGeomGetData(a) != dGeomGetData(b) && dCollide(a, b, 1, &contact, sizeof contact) > 0);
  });
  dSpaceDestroy(space);
  return found;
}

void ode_add_shape(dSpaceID space, OdeSurfaces& surfaces, const core::Body& body, dBodyID id, void* owner) {
  for (const core::Part& part : applied::parts_of(body.shape)) add(space, surfaces, part, body, id, owner);
}

OdeSurfaces::~OdeSurfaces() {
  for (const Triangles& one : all_) dGeomTriMeshDataDestroy(one.id);
}

dGeomID OdeSurfaces::make(dSpaceID space, const core::Mesh& mesh) {
  Triangles& one = all_.emplace_back();
  for (const Vector3& v : mesh.vertices) one.corners.insert(one.corners.end(), v.begin(), v.end());
  for (const auto& face : mesh.faces)
    for (const int k : face) one.indices.push_back(static_cast<dTriIndex>(k));
  one.id = dGeomTriMeshDataCreate();
  dGeomTriMeshDataBuildDouble(one.id, one.corners.data(), 3 * sizeof(double),
                              static_cast<int>(mesh.vertices.size()), one.indices.data(),
                              static_cast<int>(one.indices.size()), 3 * sizeof(dTriIndex));
  return dCreateTriMesh(space, one.id, nullptr, nullptr, nullptr);
}

}  // namespace cylon::simulators
