// Scenes that some engine refuses: with contacts, joints, forces, water, long chains and crowds.
#pragma once

#include "tests/conformance/adapters_fixture.h"

namespace cylon::conformance {

// Body "a" over plane "floor" with a material, both able to touch; "b" touches nothing.
inline core::Scene resting(const core::Shape& shape = core::Sphere{0.2}) {
  core::Scene scene = three_bodies(81);
  scene.bodies.pop_back();
  scene.bodies[0].shape = shape;
  scene.bodies[0].collide = true;
  scene.planes = {{"floor", Vector3(1, 3, -2).normalized(), -50}};
  scene.materials = {{{"a", "floor"}, 0.4, 0}};
  return scene;
}

inline core::Scene jointed(core::JointType type, int body, int to) {
  core::Scene scene = three_bodies(82);
  for (core::Body& one : scene.bodies) one.initial.velocity = one.initial.angular_velocity = Vector3::Zero();
  core::Joint joint;
  joint.type = type;
  joint.body = body, joint.to = to;
  joint.point = {0.3, -0.4, 0.6};
  joint.axis = Vector3(1, 2, 3).normalized();
  joint.length = to < 0 ? (scene.bodies[static_cast<std::size_t>(body)].initial.position - joint.point).norm()
                        : (scene.bodies[static_cast<std::size_t>(body)].initial.position -
                           scene.bodies[static_cast<std::size_t>(to)].initial.position)
                              .norm();
  scene.joints = {joint};
  return scene;
}

// A joint that something acts on, counted from 0.
inline core::Scene jointed(core::JointType type, int body, int to, const core::JointCoordinate& acts) {
  core::Scene scene = jointed(type, body, to);
  core::Joint& joint = scene.joints[0];
  const core::JointKind& kind = core::kind_of(type);
  if (kind.has_second_axis()) joint.axis_2 = Vector3(3, 0, -1).normalized();
  if (kind.displacements() > 0) {
    joint.displacements = {{acts}};
  } else {
    joint.angles = {{acts}};
  }
  return scene;
}

inline core::Scene pushed(const core::Force& force) {
  core::Scene scene = three_bodies(83);
  scene.forces = {force};
  return scene;
}

// "a" and "c" are spheres, "b" is of another shape.
inline core::Scene in_water(const core::Shape& shape) {
  core::Scene scene = three_bodies(84);
  for (core::Body& body : scene.bodies) body.shape = core::Sphere{0.2};
  scene.bodies[1].shape = shape;
  scene.forces = {core::UniformGravity{}, core::Water{.level = 1, .buoyancy = 1000}};
  return scene;
}

template <class Change>
inline core::Scene with(core::Scene scene, Change change) {
  change(scene);
  return scene;
}

inline core::Compound compound_of(const core::Primitive& shape) {
  return {{core::Part{shape, 1, {0.1, 0.2, 0}, {1, 0, 0, 0}}}};
}

// The same scene where nothing bounces.
inline core::Scene soft(const core::Shape& shape) {
  return with(resting(shape), [](core::Scene& s) { s.materials[0].restitution = 0; });
}

// Bodies that hang from each other by ball joints, at rest.
inline core::Scene chain(int links) {
  core::Scene scene;
  for (int i = 0; i < links; ++i) {
    scene.bodies.emplace_back().name = fmt::format("link{}", i);
    scene.bodies.back().initial.position = {i + 0.5, 0, 0};
    scene.joints.push_back({core::JointType::ball, i, i - 1, {static_cast<double>(i), 0, 0}});
  }
  return scene;
}

// Bodies that touch nothing.
inline core::Scene crowd(int bodies) {
  core::Scene scene;
  for (int i = 0; i < bodies; ++i) scene.bodies.emplace_back().name = fmt::format("one{}", i);
  return scene;
}

// Spheres that may touch each other.
inline core::Scene gas(int bodies) {
  core::Scene scene = crowd(bodies);
  for (core::Body& body : scene.bodies) body.shape = core::Sphere{0.1}, body.collide = true;
  scene.materials = {{{"*", "*"}, 0, 0}};
  return scene;
}

inline const core::Mesh tetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                       {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};

// The same with a face pushed in.
inline const core::Mesh dented = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}},
                                  {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}}};

}  // namespace cylon::conformance
