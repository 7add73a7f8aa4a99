#include "reference/simulators/bullet/bullet_shapes.h"

#include "harness/core/overloaded.h"
#include "reference/simulators/bullet/bullet_border.h"

#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <cmath>

namespace cylon::simulators {
namespace {

template <class Shape, class... Arguments>
Shape* add(Shapes& shapes, Arguments... arguments) {
  auto shape = std::make_unique<Shape>(arguments...);
  Shape* const raw = shape.get();
  shapes.push_back(std::move(shape));
  return raw;
}

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
  btCollisionShape* operator()(const core::Mesh&) const { return (*this)(std::monostate()); }
};

// Bullet's cone is centred half-way up, ours a quarter of the way up, at its centre of mass.
core::Vector3 centre_of(const core::Primitive& primitive) {
  const auto* cone = std::get_if<core::Cone>(&primitive);
  return cone ? core::Vector3(0, cone->length / 4, 0) : core::Vector3::Zero();
}

std::vector<core::Part> parts_of(const core::Shape& shape) {
  return std::visit(
      [](const auto& s) -> std::vector<core::Part> {
        if constexpr (std::is_same_v<std::decay_t<decltype(s)>, core::Compound>)
          return s.parts;
        else
          return {core::Part{s, 0, core::Vector3::Zero(), core::Quaternion::Identity()}};
      },
      shape);
}

}  // namespace

std::optional<std::string> untouchable(const core::Shape& shape) {
  for (const core::Part& part : parts_of(shape)) {
    if (std::holds_alternative<core::Disc>(part.shape)) return "Bullet has no disc without thickness.";
    if (std::holds_alternative<core::Mesh>(part.shape))
      return "Moving meshes need another collision algorithm of Bullet, which is not supported; use a hull.";
  }
  return std::nullopt;
}

double inner_radius(const core::Shape& shape) {
  // A cone of half-angle a: its centre is a quarter up, and its side is 3/4 length sin a away.
  const auto cone = [](const core::Cone& s) {
    return s.length / 4 * std::min(1.0, 3 * s.radius / std::hypot(s.radius, s.length));
  };
  return std::visit(core::Overloaded{
                        [](const core::Sphere& s) { return s.radius; },
                        [](const core::Box& s) { return s.half_extents.minCoeff(); },
                        [](const core::Capsule& s) { return s.radius; },
                        [](const core::Cylinder& s) { return std::min(s.radius, s.length / 2); },
                        cone,
                        [](const auto&) { return 0.0; },
                    },
                    shape);
}

btCollisionShape* make_shape(const core::Shape& shape, const core::Quaternion& rotation,
                             std::optional<double> margin, Shapes& shapes) {
  const std::vector<core::Part> parts = parts_of(shape);
  const core::Quaternion body_to_frame = rotation.conjugate();
  btCompoundShape* compound = nullptr;
  for (const core::Part& part : parts) {
    btCollisionShape* const child = std::visit(Make{shapes, margin}, part.shape);
    const core::Quaternion turn = body_to_frame * part.orientation;
    const core::Vector3 shift = body_to_frame * part.position + turn * centre_of(part.shape);
    const bool round = std::holds_alternative<core::Sphere>(part.shape);
    const bool turned = !round && !turn.isApprox(core::Quaternion::Identity(), 0.0);
    if (parts.size() == 1 && !turned && shift.isZero(0.0)) return child;
    if (!compound) compound = add<btCompoundShape>(shapes);
    compound->addChildShape(to_bullet(turn, shift), child);
  }
  return compound ? compound : Make{shapes, margin}(std::monostate());
}

btCollisionShape* make_shape(const core::Plane& plane, Shapes& shapes) {
  return add<btStaticPlaneShape>(shapes, to_bullet(plane.normal), to_bullet(plane.offset));
}

}  // namespace cylon::simulators
