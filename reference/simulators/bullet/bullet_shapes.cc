#include "reference/simulators/bullet/bullet_shapes.h"

#include "harness/core/overloaded.h"
#include "harness/core/polyhedron.h"
#include "reference/applied/parts.h"
#include "reference/simulators/bullet/bullet_border.h"

#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace cylon::simulators {
namespace {

template <class Shape, class... Arguments>
Shape* add(Shapes& shapes, Arguments... arguments) {
  auto shape = std::make_unique<Shape>(arguments...);
  Shape* const raw = shape.get();
  shapes.push_back(std::move(shape));
  return raw;
}

// A surface of triangles, for bodies that never move.
struct Triangles {
  explicit Triangles(const core::Mesh& mesh) {
    for (const auto& face : mesh.faces) {
      const auto corner = [&](std::size_t k) {
        return to_bullet(mesh.vertices[static_cast<std::size_t>(face[k])]);
      };
      all.addTriangle(corner(0), corner(1), corner(2));
    }
  }
  btTriangleMesh all;
};

class Surface final : private Triangles, public btBvhTriangleMeshShape {
 public:
  explicit Surface(const core::Mesh& mesh) : Triangles(mesh), btBvhTriangleMeshShape(&all, true) {}
};

struct Make {
  Shapes& shapes;
  std::optional<double> margin;

  // Bullet grows hulls and cones by a margin of 0.04 m, and rounds the edges of boxes and cylinders with it.
  btCollisionShape* with_margin(btCollisionShape* shape) const {
    if (margin) shape->setMargin(to_bullet(*margin));
    return shape;
  }

  btCollisionShape* operator()(std::monostate) const { return add<btEmptyShape>(shapes); }
  btCollisionShape* operator()(const core::Sphere& s) const {
    return add<btSphereShape>(shapes, to_bullet(s.radius));
  }
  btCollisionShape* operator()(const core::Box& s) const {
    return with_margin(add<btBoxShape>(shapes, to_bullet(s.half_extents)));
  }
  btCollisionShape* operator()(const core::Capsule& s) const {
    return add<btCapsuleShape>(shapes, to_bullet(s.radius), to_bullet(s.length));
  }
  btCollisionShape* operator()(const core::Cylinder& s) const {
    return with_margin(add<btCylinderShape>(
        shapes, btVector3(to_bullet(s.radius), to_bullet(s.length / 2), to_bullet(s.radius))));
  }
  btCollisionShape* operator()(const core::Cone& s) const {
    return with_margin(add<btConeShape>(shapes, to_bullet(s.radius), to_bullet(s.length)));
  }
  btCollisionShape* operator()(const core::Rod& s) const {
    return (*this)(core::Hull{{{0, -s.length / 2, 0}, {0, s.length / 2, 0}}});
  }
  btCollisionShape* operator()(const core::Hull& s) const {
    auto* hull = add<btConvexHullShape>(shapes);
    for (const core::Vector3& v : s.vertices) hull->addPoint(to_bullet(v), false);
    hull->recalcLocalAabb();
    return with_margin(hull);
  }
  btCollisionShape* operator()(const core::Disc&) const { return (*this)(std::monostate()); }
  btCollisionShape* operator()(const core::Mesh& s) const {
    auto surface = std::make_unique<Surface>(s);
    Surface* const raw = surface.get();
    shapes.push_back(std::move(surface));
    return with_margin(raw);
  }
};

// Bullet's cone is centred half-way up, ours a quarter of the way up, at its centre of mass.
core::Vector3 centre_of(const core::Primitive& primitive) {
  const auto* cone = std::get_if<core::Cone>(&primitive);
  return cone ? core::Vector3(0, cone->length / 4, 0) : core::Vector3::Zero();
}

// A part in Bullet's frame.
struct Placed {
  core::Primitive shape;
  core::Quaternion turn;
  core::Vector3 shift;

  // Whether Bullet's own shape stands for it as it is; else it is the child of a compound.
  bool alone() const {
    const bool round = std::holds_alternative<core::Sphere>(shape);
    return shift.isZero(0.0) && (round || turn.isApprox(core::Quaternion::Identity(), 0.0));
  }
};

// In a frame that is turned by `rotation` (frame to body axes).  Hulls and meshes are turned in their vertices.
std::vector<Placed> placed(const core::Shape& shape, const core::Quaternion& rotation) {
  std::vector<Placed> result;
  const core::Quaternion body_to_frame = rotation.conjugate();
  for (const core::Part& part : applied::parts_of(shape)) {
    const core::Quaternion turn = body_to_frame * part.orientation;
    Placed one{part.shape, turn, body_to_frame * part.position + turn * centre_of(part.shape)};
    std::visit(
        [&](auto& s) {
          if constexpr (requires { s.vertices; }) {
            for (core::Vector3& v : s.vertices) v = turn * v + one.shift;
            one.turn = core::Quaternion::Identity(), one.shift.setZero();
          }
        },
        one.shape);
    result.push_back(std::move(one));
  }
  return result;
}

// Of the largest sphere about the origin inside a shape that Bullet's own stands for [m]; 0: none.
struct InnerRadius {
  double operator()(const core::Sphere& s) const { return s.radius; }
  double operator()(const core::Box& s) const { return s.half_extents.minCoeff(); }
  double operator()(const core::Capsule& s) const { return s.radius; }
  double operator()(const core::Cylinder& s) const { return std::min(s.radius, s.length / 2); }
  // The nearest of the planes n.x = n.p that its faces lie in; 0 where the origin is outside, or no volume.
  double operator()(const core::Hull& s) const try {
    double least = std::numeric_limits<double>::infinity();
    for (const core::Triangle& face : core::convex_hull(s.vertices)) {
      const auto corner = [&](std::size_t i) { return s.vertices[static_cast<std::size_t>(face[i])]; };
      const core::Vector3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
      least = std::min(least, normal.dot(corner(0)));
    }
    return std::max(0.0, least);
  } catch (const std::invalid_argument&) {
    return 0;
  }
  double operator()(const core::Cone&) const { return 0; }  // a compound: its centre is not Bullet's
  double operator()(const core::Rod&) const { return 0; }
  double operator()(const core::Disc&) const { return 0; }
  double operator()(const core::Mesh&) const { return 0; }
  double operator()(const std::monostate&) const { return 0; }
};

}  // namespace

std::optional<std::string> untouchable(const core::Shape& shape, bool locked) {
  if (locked && std::holds_alternative<core::Mesh>(shape)) return std::nullopt;
  for (const core::Part& part : applied::parts_of(shape)) {
    if (std::holds_alternative<core::Disc>(part.shape))
      return "Bullet has no shape of a disc without thickness "
             "(BulletCollision/BroadphaseCollision/btBroadphaseProxy.h:27).";
    if (std::holds_alternative<core::Mesh>(part.shape))
      return "This adapter maps no moving mesh: it needs btGImpactMeshShape and its algorithm "
             "(BulletCollision/Gimpact/btGImpactShape.h:850); use a hull.";
  }
  return std::nullopt;
}

double swept_radius(const core::Shape& shape, const core::Quaternion& rotation) {
  const std::vector<Placed> parts = placed(shape, rotation);
  return parts.size() == 1 && parts[0].alone() ? std::visit(InnerRadius{}, parts[0].shape) : 0;
}

btCollisionShape* make_shape(const core::Shape& shape, const core::Quaternion& rotation,
                             std::optional<double> margin, Shapes& shapes) {
  const std::vector<Placed> parts = placed(shape, rotation);
  const Make make{shapes, margin};
  if (parts.size() == 1 && parts[0].alone()) return std::visit(make, parts[0].shape);
  if (parts.empty()) return make(std::monostate());
  auto* const compound = add<btCompoundShape>(shapes);
  for (const Placed& part : parts)
    compound->addChildShape(to_bullet(part.turn, part.shift), std::visit(make, part.shape));
  return compound;
}

btCollisionShape* make_shape(const core::Plane& plane, Shapes& shapes) {
  return add<btStaticPlaneShape>(shapes, to_bullet(plane.normal), to_bullet(plane.offset));
}

}  // namespace cylon::simulators
