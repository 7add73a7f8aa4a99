// Collisions of SDFormat: shapes, and how pairs of them touch as in gz-sim, whose engine is DART: the smaller friction
// and the product of the restitutions (dart/constraint/ContactSurface.cpp).  It reads the friction of <ode> and of no other
// engine (gz-physics, dartsim/src/SDFFeatures.cc, ConstructSdfCollision).
#include "reference/formats/sdformat/reader.h"

#include "reference/formats/resources/resources.h"

#include <algorithm>
#include <utility>

namespace cylon::formats {
namespace {

using foreign::Vector3;

Vector3 vector(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

// The element at the end of a path that exists without defaults; null where it does not.
sdf::ElementPtr below(sdf::ElementPtr element, std::initializer_list<const char*> path) {
  for (const char* name : path) {
    if (!element || !element->HasElement(name)) return nullptr;
    element = element->GetElement(name);
  }
  return element;
}

double number(const sdf::ElementPtr& element, const char* name, double otherwise) {
  return element && element->HasElement(name) ? element->Get<double>(name) : otherwise;
}

}  // namespace

void SdfReader::read_collision(const sdf::Collision& collision, const std::string& link,
                               const foreign::Pose& centre, Own own, foreign::Body& body) {
  foreign::Solid solid;
  solid.place = place("collision", link + "::" + collision.Name(), collision.Element());
  ignition::math::Pose3d at;
  const sdf::Errors errors = collision.SemanticPose().Resolve(at);
  if (!errors.empty()) throw Refused(solid.place.element + ": " + errors.front().Message());
  solid.pose =
      centre.inverse() *
      foreign::Pose{vector(at.Pos()),
                    foreign::Quaternion(at.Rot().W(), at.Rot().X(), at.Rot().Y(), at.Rot().Z()).normalized()};
  read_shape(collision, solid);
  if (solid.kind.empty()) return;
  const Surface surface = surface_of(collision, own, solid.place);
  solid.surface = surfaces_.try_emplace(surface, static_cast<int>(surfaces_.size())).first->second;
  body.solids.push_back(std::move(solid));
}

void SdfReader::read_shape(const sdf::Collision& collision, foreign::Solid& solid) {
  const sdf::Geometry& geometry = *collision.Geom();
  if (const sdf::Box* box = geometry.BoxShape()) {
    solid.kind = "box", solid.size = vector(box->Size()) / 2;
  } else if (const sdf::Sphere* sphere = geometry.SphereShape()) {
    solid.kind = "sphere", solid.size.x() = sphere->Radius();
  } else if (const sdf::Cylinder* cylinder = geometry.CylinderShape()) {
    solid.kind = "cylinder", solid.size = {cylinder->Radius(), cylinder->Length(), 0};
  } else if (const sdf::Capsule* capsule = geometry.CapsuleShape()) {
    solid.kind = "capsule", solid.size = {capsule->Radius(), capsule->Length(), 0};
  } else if (const sdf::Plane* plane = geometry.PlaneShape()) {  // endless: its size is what is drawn
    solid.kind = "plane";
    solid.pose.turn = solid.pose.turn * foreign::Quaternion::FromTwoVectors(
                                            Vector3::UnitZ(), vector(plane->Normal()).normalized());
  } else if (const sdf::Mesh* mesh = geometry.MeshShape()) {
    solid.kind = "mesh";
    if (!mesh->Submesh().empty()) {
      solid.kind = "submesh";
      return;
    }
    try {
      const std::string beside = mesh->FilePath().empty() ? file_ : mesh->FilePath();
      load_mesh(resolve(mesh->Uri(), beside, roots_), vector(mesh->Scale()), solid);
    } catch (const Refused& error) {
      throw Refused((solid.place.line > 0 ? "line " + std::to_string(solid.place.line) + ": " : "") +
                    solid.place.element + ": " + error.what());
    }
  } else if (const sdf::Ellipsoid* ellipsoid = geometry.EllipsoidShape()) {
    const Vector3 radii = vector(ellipsoid->Radii());
    solid.kind = radii.x() == radii.y() && radii.y() == radii.z() ? "sphere" : "ellipsoid";
    solid.size = radii;
  } else if (geometry.HeightmapShape()) {
    solid.kind = "heightfield";
  } else if (geometry.Type() != sdf::GeometryType::EMPTY) {
    solid.kind = "unknown";
  } else if (const sdf::ElementPtr element = collision.Element();
             below(element, {"geometry", "polyline"}) || below(element, {"geometry", "image"})) {
    solid.kind = below(element, {"geometry", "polyline"}) ? "polyline" : "image";
  }
}

SdfReader::Surface SdfReader::surface_of(const sdf::Collision& collision, Own own, const foreign::Place& at) {
  const sdf::ElementPtr surface = below(collision.Element(), {"surface"});
  const sdf::ElementPtr ode = below(surface, {"friction", "ode"}),
                        bullet = below(surface, {"friction", "bullet"});
  const double friction = number(ode, "mu", 1);
  // Two directions matter only where they differ.
  if (number(ode, "mu2", friction) != friction) lose("anisotropic_friction", at);
  for (const char* name : {"friction", "friction2"})
    if (const double other = number(bullet, name, friction); other != friction)
      lose("other_engine", at, std::string("<bullet> ") + name);
  if (number(ode, "slip1", 0) != 0 || number(ode, "slip2", 0) != 0) lose("soft_surface", at, "slip");
  if (const sdf::ElementPtr torsional = below(surface, {"friction", "torsional"});
      torsional && number(torsional, "coefficient", 1) != 0)
    lose("torsional_friction", at);
  if (below(surface, {"contact", "ode"}) || below(surface, {"contact", "bullet"}) ||
      below(surface, {"soft_contact"}))
    lose("soft_surface", at);
  const double restitution = number(below(surface, {"bounce"}), "restitution_coefficient", 0);
  int bits = 0xffff;
  if (const sdf::ElementPtr contact = below(surface, {"contact"})) {
    // It is found by sensors, and no force acts on it; a bitmask overrides that.
    if (contact->Get<bool>("collide_without_contact", false).first)
      bits = 0, lose("sensor", at, "collide_without_contact");
    if (contact->HasElement("collide_bitmask"))
      bits = static_cast<int>(contact->Get<unsigned>("collide_bitmask") & 0xffffu);
  }
  return {own.number, own.self, bits, friction, restitution};
}

void SdfReader::add_meetings() {
  constexpr std::size_t most = 2000;
  if (surfaces_.size() > most) throw Refused("more than 2000 kinds of surface");
  for (const auto& [a, i] : surfaces_)
    for (const auto& [b, j] : surfaces_) {
      const auto& [model_a, self_a, bits_a, friction_a, restitution_a] = a;
      const auto& [model_b, self_b, bits_b, friction_b, restitution_b] = b;
      const bool own = model_a == model_b && !self_a && !self_b;
      if (i <= j && !own && (bits_a & bits_b) != 0)
        model_.meetings.push_back({i, j, std::min(friction_a, friction_b), restitution_a * restitution_b});
    }
}

}  // namespace cylon::formats
