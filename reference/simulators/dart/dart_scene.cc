#include "reference/simulators/dart/dart_scene.h"

#include "harness/core/joint_coordinates.h"
#include "reference/applied/parts.h"

#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

namespace cylon::simulators {
namespace {

using core::JointType;
using core::Scene;
using dart_border::Hang;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

dart_border::Turn turn(const core::Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }

// Of the material point of a body that is at `point`.
core::Vector3 velocity_at(const core::BodyState& body, const core::Vector3& point) {
  return body.velocity + body.angular_velocity.cross(point - body.position);
}

Hang hang_of(const core::Joint& joint) {
  switch (joint.type) {
    case JointType::ball:
      return Hang::by_ball;
    case JointType::gimbal: {  // a ball, but where something holds one of its angles
      bool held = false;
      core::for_each_coordinate(
          joint, [&](const core::JointCoordinate& c) { held |= core::has_limit(c) || c.friction != 0; });
      return held ? Hang::by_gimbal : Hang::by_ball;
    }
    case JointType::hinge:
      return Hang::by_hinge;
    case JointType::slider:
      return Hang::by_slider;
    case JointType::screw:
      return Hang::by_screw;
    case JointType::universal:
      return Hang::by_universal;
    case JointType::planar:
      return Hang::in_plane;
    case JointType::fixed:
      return Hang::fixed;
    default:
      throw std::logic_error("dart_limit lets this joint through");
  }
}

// The place in Body::held of a coordinate.  From the other side, R(axis, first) R(axis_2, second) is
// R(axis_2, -second) R(axis, -first).
std::size_t place_of(const core::Joint& joint, const core::JointCoordinate& c, bool slides, bool reversed) {
  if (joint.type == JointType::planar && !slides) return 2;
  if (core::kind_of(joint.type).turns_between_axes() && c.which != core::Ordinal::third)
    return (c.which == core::Ordinal::second) != reversed ? 1 : 0;
  return static_cast<std::size_t>(c.which);
}

// What holds the coordinates of a joint; DART counts the child against its parent.
void hold(dart_border::Body& body, const core::Joint& joint, bool reversed) {
  const auto one = [&](core::JointCoordinate c, bool slides) {
    dart_border::Held& held = body.held[place_of(joint, c, slides, reversed)];
    // The third angle of a gimbal is that between its axes, from either side.
    if (reversed && c.which != core::Ordinal::third) core::reverse(c);
    if (c.lower) held.lower = *c.lower - c.start;
    if (c.upper) held.upper = *c.upper - c.start;
    held.friction = c.friction;
  };
  for (const core::JointCoordinate& c : joint.displacements) one(c, true);
  for (const core::JointCoordinate& c : joint.angles) one(c, false);
}

}  // namespace

std::vector<dart_border::Body> dart_bodies(const Scene& scene, const applied::Forest& forest) {
  std::vector<dart_border::Body> all;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::Body& body = scene.bodies[i];
    const core::BodyState& start = body.initial;
    dart_border::Body one;
    one.start = {to_dart(start.position), turn(start.orientation), to_dart(start.velocity),
                 to_dart(start.angular_velocity)};
    one.moves = !body.locked;
    one.falls = !body.gravity;  // its own is a force
    if (body.locked) {
      // Weightless in every sense: nothing asks for the mass of what does not move.
      one.inertia = {1, 0, 0, 0, 1, 0, 0, 0, 1};
      one.hang = Hang::fixed, one.point = one.start.position;
      all.push_back(one);
      continue;
    }
    one.mass = body.mass;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) one.inertia[at(3 * r + c)] = body.inertia(r, c);
    const applied::Node& node = forest.nodes[i];
    if (node.joint >= 0) {
      const core::Joint& joint = scene.joints[at(node.joint)];
      core::Vector3 spin = start.angular_velocity, slide = velocity_at(start, joint.point);
      if (node.parent != core::world) {
        const core::BodyState& parent = scene.bodies[at(node.parent)].initial;
        spin -= parent.angular_velocity, slide -= velocity_at(parent, joint.point);
      }
      one.hang = hang_of(joint), one.parent = node.parent;
      one.point = to_dart(joint.point), one.axis = to_dart(joint.axis);
      one.axis_2 = to_dart(joint.axis_2.value_or(joint.axis)), one.pitch = joint.pitch;
      // The first axis of a universal joint or a gimbal is fixed in `to`, which may be the child here.
      if (core::kind_of(joint.type).turns_between_axes() && joint.body != static_cast<int>(i))
        std::swap(one.axis, one.axis_2);
      one.turn_rate = to_dart(spin), one.slide_rate = to_dart(slide);
      hold(one, joint, joint.body != static_cast<int>(i));
    }
    all.push_back(one);
  }
  for (const core::Plane& plane : scene.planes) {
    dart_border::Body one;
    one.inertia = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    one.moves = false, one.hang = Hang::fixed;
    one.start.position = one.point = to_dart(plane.offset * plane.normal);
    one.start.orientation = turn(core::turn_between(core::Vector3::UnitY(), plane.normal));
    all.push_back(one);
  }
  return all;
}

std::vector<dart_border::Loop> dart_loops(const Scene& scene, const applied::Forest& forest) {
  const auto moves = [&](int body) { return body != core::world && !scene.bodies[at(body)].locked; };
  std::vector<dart_border::Loop> all;
  for (const std::size_t j : forest.loops) {
    const core::Joint& joint = scene.joints[j];
    dart_border::Loop loop;
    loop.turns = core::kind_of(joint.type).turns_freely();
    loop.body = moves(joint.body) ? joint.body : joint.to;
    loop.to = moves(joint.body) && moves(joint.to) ? joint.to : -1;
    loop.point = to_dart(joint.point);
    all.push_back(loop);
  }
  return all;
}

// ---- Surfaces -----------------------------------------------------------------------------------------

DartSurfaces::DartSurfaces(const Scene& scene) : rules_(scene), kinds_(core::surfaces(scene)) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::Body& body = scene.bodies[i];
    if (!core::collides(body)) continue;
    for (const core::Part& part : applied::parts_of(body.shape)) {
      dart_border::Shape shape;
      shape.body = static_cast<int>(i);
      shape.position = to_dart(part.position), shape.orientation = turn(part.orientation);
      if (const auto* sphere = std::get_if<core::Sphere>(&part.shape)) {
        shape.size[0] = sphere->radius;
      } else if (const auto* box = std::get_if<core::Box>(&part.shape)) {
        shape.sphere = false, shape.size = to_dart(2 * box->half_extents);
      } else {
        continue;  // of a body that meets nothing
      }
      add(scene, {shape.body, -1, -1}, shape, kinds_.of_body[i]);
    }
  }
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    dart_border::Shape shape;
    shape.body = static_cast<int>(scene.bodies.size() + i);
    shape.sphere = false;
    shape.size = {2 * dart_plane_reach, dart_plane_depth, 2 * dart_plane_reach};
    shape.position = {0, -dart_plane_depth / 2, 0};
    add(scene, {core::world, static_cast<int>(i), -1}, shape, kinds_.of_plane[i]);
  }
}

// The square root in each: DART multiplies restitutions, and takes the smaller friction.
void DartSurfaces::add(const Scene& scene, const DartSurface& surface, const dart_border::Shape& shape,
                       int kind) {
  std::set<int> rows;
  for (int other = 0; other < kinds_.count; ++other) rows.insert(kinds_.material(kind, other));
  for (const int row : rows) {
    if (row < 0) continue;
    const core::Material& material = scene.materials[at(row)];
    shapes_.push_back(shape);
    shapes_.back().restitution = std::sqrt(material.restitution);
    shapes_.back().friction = material.friction;
    surfaces_.push_back(surface);
    surfaces_.back().material = row;
  }
}

int DartSurfaces::kind_of(const DartSurface& one) const {
  return one.plane >= 0 ? kinds_.of_plane[at(one.plane)] : kinds_.of_body[at(one.body)];
}

bool DartSurfaces::meet(int shape, int other) const {
  const DartSurface &a = of(shape), &b = of(other);
  if (a.material != b.material || (a.plane >= 0 && b.plane >= 0)) return false;
  if (a.plane < 0 && a.body == b.body) return false;  // two parts of one body
  if (kinds_.material(kind_of(a), kind_of(b)) != a.material) return false;
  if (a.plane >= 0) return rules_.body_and_plane(b.body, a.plane);
  if (b.plane >= 0) return rules_.body_and_plane(a.body, b.plane);
  return rules_.bodies(a.body, b.body);
}

}  // namespace cylon::simulators
