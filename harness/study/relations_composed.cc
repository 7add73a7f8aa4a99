#include "harness/study/relations_composed.h"

#include "harness/core/fields.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/size.h"
#include "harness/study/restate.h"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace cylon::study {

using core::Body;
using core::BodyState;
using core::Force;
using core::Joint;
using core::Matrix3;
using core::Recording;
using core::Scene;
using core::State;
using core::Vector3;

namespace {

State as_is(const State& plain, double) { return plain; }

// Calls visit(int&) for each index of a body in the scene's forces and joints.
template <class Visit>
void each_body_index_of(Scene& scene, Visit&& visit) {
  for (Force& f : scene.forces) std::visit([&](auto& force) { each_body_index(force, visit); }, f);
  for (Joint& j : scene.joints) each_body_index(j, visit);
}

bool acts_on(const Force& f, int body) {
  bool acts = false;
  std::visit([&](const auto& force) { each_body_index(force, [&](int i) { acts |= i == body; }); }, f);
  return acts;
}

bool is_joint_of(const Joint& j, int body) { return j.body == body || j.to == body; }

template <class Kind>
bool has(const Scene& scene) {
  return std::ranges::any_of(scene.forces, [](const Force& f) { return std::holds_alternative<Kind>(f); });
}

}  // namespace

// ---- Order ---------------------------------------------------------------------------------------

Reason one_body(const Scene& scene) {
  if (scene.bodies.size() < 2) return "there is one body";
  return {};
}

double body_order(const Subject& s, const Runner& run) {
  Scene scene = s.scene;
  const int n = static_cast<int>(scene.bodies.size());
  std::ranges::reverse(scene.bodies);
  each_body_index_of(scene, [&](int& body) { body = body == core::world ? body : n - 1 - body; });
  return worst(s, again(s, run, scene), [](State plain, double) {
    std::ranges::reverse(plain);
    return plain;
  });
}

Reason one_part(const Scene& scene) {
  if (std::max({scene.forces.size(), scene.joints.size(), scene.planes.size()}) < 2)
    return "there are no two forces, joints or planes";
  return {};
}

double part_order(const Subject& s, const Runner& run) {
  Scene scene = s.scene;
  std::ranges::reverse(scene.forces);
  std::ranges::reverse(scene.joints);
  std::ranges::reverse(scene.planes);
  return worst(s, again(s, run, scene), as_is);
}

// ---- More ----------------------------------------------------------------------------------------

double far_body(const Subject& s, const Runner& run) {
  Scene scene = s.scene;
  Body far;
  far.name = "far away";
  far.inertia = Matrix3::Identity();
  far.initial.position = 1000 * s.scales.length * Vector3(0.6, 0.5, -0.4);
  scene.bodies.push_back(far);
  Recording other = again(s, run, scene);
  for (State& state : other.states) state.pop_back();
  return worst(s, other, as_is);
}

namespace {

// A direction along every plane, or nothing where their normals span all three.
std::optional<Vector3> along_planes(const Scene& scene) {
  Matrix3 normals = Matrix3::Zero();  // the sum of n n^T is zero along all planes
  for (const core::Plane& plane : scene.planes) normals += plane.normal * plane.normal.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(normals);
  if (solver.eigenvalues()[0] > 1e-12) return {};
  Vector3 direction = Vector3::Zero();  // general among those that there are
  for (int i = 0; i < 3; ++i)
    if (solver.eigenvalues()[i] <= 1e-12)
      direction += solver.eigenvectors().col(i).dot(along) * solver.eigenvectors().col(i);
  if (direction.norm() < 1e-3) direction = solver.eigenvectors().col(0);
  return direction.normalized();
}

}  // namespace

Reason no_room(const Scene& scene) {
  if (const Reason why = fixed_place(scene)) return why;
  if (!along_planes(scene)) return "planes leave no way to a place like this one";
  return {};
}

double bystander(const Subject& s, const Runner& run) {
  const int n = static_cast<int>(s.scene.bodies.size());
  double reach = s.scales.length;  // of the motion, from the first body's start
  for (const State& state : s.plain.states)
    for (const BodyState& b : state)
      reach = std::fmax(reach, (b.position - s.scene.bodies.front().initial.position).norm());
  Restatement moved;
  moved.move = 4 * reach * along_planes(s.scene).value();
  Scene other = moved(s.scene);
  const auto is_body = [&](const std::string& name) {
    return std::ranges::any_of(s.scene.bodies, [&](const Body& b) { return b.name == name; });
  };
  const auto renamed = [&](const std::string& name) { return is_body(name) ? name + " (far away)" : name; };
  each_body_index_of(other, [&](int& body) { body = body == core::world ? body : body + n; });
  for (Body& body : other.bodies) body.name = renamed(body.name);

  Scene both = s.scene;
  both.bodies.insert(both.bodies.end(), other.bodies.begin(), other.bodies.end());
  for (const Force& f : other.forces)  // gravity acts on all bodies already
    if (!std::holds_alternative<core::UniformGravity>(f)) both.forces.push_back(f);
  both.joints.insert(both.joints.end(), other.joints.begin(), other.joints.end());
  for (core::Material m : s.scene.materials) {
    for (std::string& name : m.between) name = renamed(name);
    if (std::ranges::any_of(s.scene.materials, [&](const core::Material& old) {
          return old.between[0] == m.between[0] && old.between[1] == m.between[1];
        }))
      continue;
    both.materials.push_back(m);
  }
  // Between a body and a copy, which never meet, all scenes need a word; where "*" with "*" has none.
  if (std::ranges::none_of(
          both.materials, [](const core::Material& m) { return m.between[0] == "*" && m.between[1] == "*"; }))
    both.materials.push_back({{"*", "*"}});

  const Recording together = again(s, run, both);
  Recording here = together, there = together;
  for (State& state : here.states) state.resize(s.scene.bodies.size());
  for (State& state : there.states) {
    state.erase(state.begin(), state.begin() + n);
    for (BodyState& b : state) b.position -= moved.move;
  }
  return std::max(worst(s, here, as_is), worst(s, there, as_is));
}

// ---- Fewer ---------------------------------------------------------------------------------------

namespace {

// The first body that moves, and that nothing joins, pulls or touches but the world.
std::optional<std::size_t> body_apart(const Scene& scene) {
  if (scene.bodies.size() < 2) return {};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    if (scene.bodies[i].locked) continue;
    const bool pulled = std::ranges::any_of(scene.forces, [&](const Force& f) {
      int bodies = 0;
      std::visit(
          [&](const auto& force) { each_body_index(force, [&](int k) { bodies += k != core::world; }); }, f);
      return bodies > 1 && acts_on(f, body);
    });
    const bool joined = std::ranges::any_of(scene.joints, [&](const Joint& j) {
      return is_joint_of(j, body) && j.body != core::world && j.to != core::world;
    });
    const auto pairs = core::touching_pairs(scene, body);
    const bool touches = std::ranges::any_of(pairs, [](const core::Pair& p) { return p.plane < 0; });
    if (!pulled && !joined && !touches) return i;
  }
  return {};
}

}  // namespace

Reason none_apart(const Scene& scene) {
  if (!body_apart(scene)) return "no body is independent of all others";
  return {};
}

double removal(const Subject& s, const Runner& run) {
  const std::size_t gone = body_apart(s.scene).value();
  const int body = static_cast<int>(gone);
  Scene scene = s.scene;
  std::erase_if(scene.forces, [&](const Force& f) { return acts_on(f, body); });
  std::erase_if(scene.joints, [&](const Joint& j) { return is_joint_of(j, body); });
  scene.bodies.erase(scene.bodies.begin() + body);
  each_body_index_of(scene, [&](int& i) { i -= i > body; });
  return worst(s, again(s, run, scene), [gone](State plain, double) {
    plain.erase(plain.begin() + static_cast<std::ptrdiff_t>(gone));
    return plain;
  });
}

// ---- One body as two -----------------------------------------------------------------------------

namespace {

// A body of mass m and inertia I is two of masses a m and b m, a + b = 1, with their centres at -b d and a d:
//   I = I_a + I_b + a b m (d^2 1 - d d^T).
// With J = tr(I)/2 1 - I, the second moments of mass: J = J_a + J_b + a b m d d^T, where no J may be negative.
constexpr double first_share = 0.6;

struct Split {
  Body first, second;
  Vector3 to_centre = Vector3::Zero();  // from the first's centre, in its axes
};

Split split_of(const Body& body, bool apart) {
  constexpr double a = first_share, b = 1 - a;
  Split split = {body, body, Vector3::Zero()};
  const Matrix3 moments = body.inertia.trace() / 2 * Matrix3::Identity() - body.inertia;
  Matrix3 rest = body.inertia;
  Vector3 d = Vector3::Zero();
  if (apart) {
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(moments);
    const double most = solver.eigenvalues()[2];
    d = std::sqrt(0.4 * most / (a * b * body.mass)) * solver.eigenvectors().col(2);
    rest -= a * b * body.mass * (d.squaredNorm() * Matrix3::Identity() - d * d.transpose());
  }
  const auto place = [&](Body& part, double share, const Vector3& offset) {
    const Vector3 arm = body.initial.orientation * offset;
    part.mass = share * body.mass, part.inertia = share * rest;
    part.initial.position += arm;
    part.initial.velocity += body.initial.angular_velocity.cross(arm);
  };
  place(split.first, a, -b * d);
  place(split.second, b, a * d);
  split.to_centre = b * d;
  split.second.name += " (rest)";
  split.second.shape = {}, split.second.collide = false;
  return split;
}

std::optional<std::size_t> body_to_split(const Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (!scene.bodies[i].locked && scene.bodies[i].inertia.trace() > 0) return i;
  return {};
}

bool has_shape(const Body& body) { return !std::holds_alternative<std::monostate>(body.shape); }

// Whether nothing acts at the centre of mass itself, which neither part has.
bool needs_no_centre(const Scene& scene, int body) {
  return std::ranges::all_of(
             scene.forces,
             [&](const Force& f) { return std::holds_alternative<core::Spring>(f) || !acts_on(f, body); }) &&
         std::ranges::none_of(scene.joints, [&](const Joint& j) {
           return is_joint_of(j, body) && core::kind_of(j.type).joins_centres();
         });
}

}  // namespace

Reason none_to_split(const Scene& scene) {
  if (has<core::Water>(scene)) return "water lifts each body";
  if (!body_to_split(scene)) return "no body both moves and has an inertia";
  const int body = static_cast<int>(*body_to_split(scene));
  for (const Force& f : scene.forces) {
    const auto* thrust = std::get_if<core::Thrust>(&f);
    if (thrust && thrust->body == body && thrust->mass_rate != 0) return "the mass changes";
    const auto* drag = std::get_if<core::Drag>(&f);
    if (drag && drag->body == body && drag->momentum != 0) return "a drag acts on a body's own spin";
  }
  return {};
}

double weld(const Subject& s, const Runner& run) {
  const std::size_t i = body_to_split(s.scene).value();
  const int body = static_cast<int>(i), rest = static_cast<int>(s.scene.bodies.size());
  Scene scene = s.scene;
  const Split split = split_of(scene.bodies[i], !has_shape(scene.bodies[i]) && needs_no_centre(scene, body));
  scene.bodies[i] = split.first;
  scene.bodies.push_back(split.second);
  for (Force& f : scene.forces) {
    if (auto* spring = std::get_if<core::Spring>(&f)) {
      if (spring->body == body) spring->anchor += split.to_centre;
      if (spring->to == body) spring->to_anchor += split.to_centre;
    }
    if (auto* pull = std::get_if<core::Attraction>(&f); pull && acts_on(f, body))
      pull->strength /= first_share;  // on the first part alone
  }
  scene.joints.push_back({core::JointType::fixed, body, rest, split.first.initial.position});

  Recording other = again(s, run, scene);
  for (State& state : other.states) {
    state.pop_back();
    const Vector3 arm = state[i].orientation * split.to_centre;
    state[i].position += arm;
    state[i].velocity += state[i].angular_velocity.cross(arm);
  }
  return worst(s, other, as_is);
}

// ---- The same joints in other words --------------------------------------------------------------

Reason none_between(const Scene& scene) {
  const bool spring = std::ranges::any_of(scene.forces, [](const Force& f) {
    const auto* k = std::get_if<core::Spring>(&f);
    return k && k->to != core::world;
  });
  if (!spring && scene.joints.empty()) return "there is no joint, and no spring between bodies";
  return {};
}

// A joint told from its second body: every coordinate counts the other way.  A planar joint's displacements are those of
// axes in one body, and it stays as it is.
void look_from_other_body(Joint& j) {
  const core::JointKind& kind = core::kind_of(j.type);
  if (kind.place == core::JointPlace::in_plane) return;
  std::swap(j.body, j.to);
  const auto between_axes = [](const core::JointAngle& c) { return c.which == core::Ordinal::third; };
  for (core::JointDisplacement& c : j.displacements) core::reverse(c);
  for (core::JointAngle& c : j.angles)
    if (!between_axes(c)) core::reverse(c);
  if (!kind.turns_between_axes()) return;
  // (R(h, a) R(u, b))^T = R(u, -b) R(h, -a);  the angle between h and u is that between u and h.
  j.point = core::held_point_of_body(j);
  std::swap(j.axis, *j.axis_2);
  for (core::JointAngle& c : j.angles)
    if (!between_axes(c))
      c.which = c.which == core::Ordinal::first ? core::Ordinal::second : core::Ordinal::first;
}

double other_points(const Subject& s, const Runner& run) {
  Scene scene = s.scene;
  for (Force& f : scene.forces)
    if (auto* k = std::get_if<core::Spring>(&f); k && k->to != core::world)
      std::swap(k->body, k->to), std::swap(k->anchor, k->to_anchor);
  for (Joint& j : scene.joints) {
    if (j.to != core::world) look_from_other_body(j);
    const core::JointTurn turn = core::kind_of(j.type).turn;
    if (turn == core::JointTurn::about_axis) j.point += 0.37 * s.scales.length * j.axis;
    if (turn == core::JointTurn::never) j.point += 0.37 * s.scales.length * along;
  }
  return worst(s, again(s, run, scene), as_is);
}

}  // namespace cylon::study
