#include "harness/imports/steps.h"

#include "harness/core/input_error.h"
#include "harness/core/solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace cylon::imports {
namespace {

using foreign::Body;
using foreign::Joint;
using foreign::Matrix3;
using foreign::Model;
using foreign::Pose;
using foreign::Vector3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

[[noreturn]] void fail(const foreign::Place& place, const std::string& file, const std::string& why) {
  throw core::InputError(place.file.empty() ? file : place.file,
                         static_cast<unsigned>(std::max(place.line, 0)), 0,
                         fmt::format("{}: {}", place.element, why));
}

// Which body each belongs to: the first of those that it is one with, seen from the world.
class Groups {
 public:
  explicit Groups(std::size_t count) : first_(count) { std::iota(first_.begin(), first_.end(), 0); }
  int first(int i) {
    while (first_[at(i)] != i) i = first_[at(i)] = first_[at(first_[at(i)])];
    return i;
  }
  void join(int to, int body) { first_[at(first(body))] = first(to); }

 private:
  std::vector<int> first_;
};

// m (|d|^2 1 - d d^T)
Matrix3 of_point(double mass, const Vector3& d) {
  return mass * (d.squaredNorm() * Matrix3::Identity() - d * d.transpose());
}

// Gravity acts on the mass of each, and drag at the centre of mass: what no longer holds of the whole is lost.
void lose_of_whole(const Body& whole, const Body& part, const Vector3& centre, Model& model) {
  constexpr double rounding = 1e-12;  // of a centre that stays [m]
  const Vector3 one = whole.gravity.value_or(model.gravity), other = part.gravity.value_or(model.gravity);
  if (whole.mass > 0 && part.mass > 0 && one != other)
    model.losses.push_back({"part_gravity", part.place, "a part of " + whole.place.element});
  if ((whole.linear_drag != 0 && (centre - whole.pose.position).norm() > rounding) || part.linear_drag != 0 ||
      part.angular_drag != 0)
    model.losses.push_back({"free_drag", part.place, "a part of " + whole.place.element});
}

// The second body's mass and solids go to the first, which keeps its axes, its velocity and its name.
void take_in(Body& whole, const Body& part, Model& model) {
  const Pose old = whole.pose;
  const double mass = whole.mass + part.mass;
  if (!whole.locked && mass > 0) {
    const Vector3 centre =
        part.mass == 0 ? old.position : (whole.mass * old.position + part.mass * part.pose.position) / mass;
    lose_of_whole(whole, part, centre, model);
    if (whole.mass == 0) whole.gravity = part.gravity;
    const Matrix3 r = (old.turn.conjugate() * part.pose.turn).toRotationMatrix();
    Matrix3 inertia = whole.inertia + r * part.inertia * r.transpose();
    if (whole.mass > 0 && part.mass > 0) {
      inertia += of_point(whole.mass, old.turn.conjugate() * (old.position - centre));
      inertia += of_point(part.mass, old.turn.conjugate() * (part.pose.position - centre));
    }
    whole.inertia = (inertia + inertia.transpose()).eval() / 2;
    whole.velocity += whole.spin.cross(centre - old.position);
    whole.pose.position = centre;
  }
  whole.mass = mass;
  const Pose shift = whole.pose.inverse() * old;
  for (foreign::Solid& solid : whole.solids) solid.pose.position += shift.position;
  for (foreign::Solid solid : part.solids) {
    solid.pose = whole.pose.inverse() * (part.pose * solid.pose);
    whole.solids.push_back(std::move(solid));
  }
}

// A joint seen from its other end: the same coordinates about the opposite axes.
void turn_about(Joint& joint) {
  std::swap(joint.body, joint.to);
  std::ranges::reverse(joint.freedoms);
  for (foreign::Freedom& freedom : joint.freedoms) freedom.axis = -freedom.axis;
}

// What has no mass and is fixed to the world, or to what is locked, does not move.
void lock_frames(Model& model) {
  for (bool again = true; again;) {
    again = false;
    for (const Joint& joint : model.joints) {
      Body& body = model.bodies[at(joint.body)];
      const bool held = joint.to < 0 || model.bodies[at(joint.to)].locked;
      if (!joint.freedoms.empty() || body.locked || body.mass > 0 || !held) continue;
      body.locked = again = true;
    }
  }
}

// Bodies that are one, and their joints, become one.
void join(Model& model, Groups& groups) {
  for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i)
    if (const int first = groups.first(i); first != i)
      take_in(model.bodies[at(first)], model.bodies[at(i)], model);
  std::erase_if(model.joints, [&](const Joint& j) {
    return j.freedoms.empty() && j.to >= 0 && groups.first(j.body) == groups.first(j.to);
  });
  for (Joint& joint : model.joints) {
    joint.body = groups.first(joint.body);
    if (joint.to >= 0) joint.to = groups.first(joint.to);
  }
}

// Leaves out the bodies that are not needed, but for their planes, and counts the others anew.
void keep(Model& model, const std::vector<bool>& needed) {
  std::vector<int> number(model.bodies.size(), -1);
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (!needed[i]) continue;
    number[i] = static_cast<int>(bodies.size());
    bodies.push_back(std::move(model.bodies[i]));
  }
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    if (!needed[i] && !model.bodies[i].solids.empty() && is_ground(model.bodies[i]))
      bodies.push_back(std::move(model.bodies[i]));
  model.bodies = std::move(bodies);
  for (Joint& joint : model.joints) {
    joint.body = number[at(joint.body)];
    if (joint.to >= 0) joint.to = number[at(joint.to)];
  }
}

}  // namespace

bool is_ground(const Body& body) {
  return body.locked &&
         std::ranges::all_of(body.solids, [](const foreign::Solid& solid) { return solid.kind == "plane"; });
}

void merge_fixed(Model& model, const std::string& file) {
  std::vector<Body>& bodies = model.bodies;
  for (const Joint& joint : model.joints)
    if (joint.body == joint.to) fail(joint.place, file, "it joins a body with itself");
  lock_frames(model);
  Groups groups(bodies.size());
  for (const Joint& joint : model.joints) {
    if (!joint.freedoms.empty() || joint.to < 0 ||
        bodies[at(joint.body)].locked != bodies[at(joint.to)].locked)
      continue;
    if (joint.one_body || bodies[at(joint.body)].mass == 0 || bodies[at(joint.to)].mass == 0)
      groups.join(joint.to, joint.body);
  }
  join(model, groups);

  std::vector<bool> needed(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    needed[i] = groups.first(static_cast<int>(i)) == static_cast<int>(i) && !is_ground(bodies[i]);
  for (Joint& joint : model.joints) {
    if (joint.to == joint.body) fail(joint.place, file, "it joins a body with itself");
    if (bodies[at(joint.body)].locked && joint.to >= 0) turn_about(joint);
    if (joint.to >= 0 && !needed[at(joint.to)]) joint.to = -1;
  }
  std::erase_if(model.joints, [&](const Joint& j) { return bodies[at(j.body)].locked; });
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (needed[i] && !bodies[i].locked && !(bodies[i].mass > 0))
      fail(bodies[i].place, file,
           fmt::format("it moves, but its mass is {} kg; it must state its inertia, with a mass > 0",
                       bodies[i].mass));
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (needed[i] && !bodies[i].locked)
      if (const auto why = core::impossible(bodies[i].inertia))
        fail(bodies[i].place, file, "its inertia: " + *why);
  keep(model, needed);
}

}  // namespace cylon::imports
