#include "engine/reduce.h"

#include "engine/numbering.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace cylon::engine {

namespace {

std::size_t at(int body) { return static_cast<std::size_t>(body); }

// What a joint to the world may keep so that the body's own motion has coordinates without it.
struct Reducible {
  Joint::Type type;
  const char* motion;  // that is left
};
constexpr Joint::Type about_point{Joint::Place::together, Joint::Turn::freely},
    about_axis{Joint::Place::together, Joint::Turn::about_axis},
    on_rod{Joint::Place::at_length, Joint::Turn::freely};
constexpr std::array reducible = {Reducible{about_point, "turns about a point"},
                                  Reducible{about_axis, "turns about an axis"},
                                  Reducible{on_rod, "keeps its distance from a point"}};

const Reducible* find_reducible(Joint::Type type) {
  const auto* row = std::ranges::find(reducible, type, &Reducible::type);
  return row == reducible.end() ? nullptr : row;
}

bool floats(const Model& model) {
  return std::any_of(model.forces.waters.begin(), model.forces.waters.end(),
                     [](const Water& water) { return water.mode == WaterMode::volume; });
}

// Whether nothing but a force through the centre of mass ever acts on a body that does not spin.
bool is_point(const Model& model, int body) {
  const auto off_centre = [&](int end, const Vector3& anchor) { return end == body && !anchor.isZero(0); };
  return model.motions[at(body)].angular_momentum.isZero(0) &&
         std::none_of(model.forces.springs.begin(), model.forces.springs.end(),
                      [&](const Spring& s) {
                        return off_centre(s.body, s.anchor) || off_centre(s.to, s.to_anchor);
                      }) &&
         std::none_of(model.forces.thrusts.begin(), model.forces.thrusts.end(),
                      [&](const Thrust& t) { return t.body == body; }) &&
         std::all_of(model.joints.begin(), model.joints.end(),
                     [&](const Joint& j) { return (j.body != body && j.to != body) || j.type == on_rod; });
}

// The inertia about a point from which the centre of mass lies at c; seed eq. 70, 71.
Matrix3 shifted(const Matrix3& inertia, Real mass, const Vector3& c) {
  return inertia + mass * (c.squaredNorm() * Matrix3::Identity() - c * c.transpose());
}

Body pinned_body(const Body& body, const Matrix3& inertia, const Vector3& centre) {
  Body pinned = make_body(body.mass, inertia, false);
  pinned.inverse_mass = 0;
  pinned.centre = centre;
  pinned.mass_rate = body.mass_rate;
  pinned.gravity = body.gravity;
  pinned.pinned = true;
  return pinned;
}

// Turns only about h:  I^-1 = h h^T / (h^T I h).
Body one_axis_body(const Body& body, const Matrix3& inertia, const Vector3& centre, const Vector3& h) {
  Body pinned = pinned_body(body, inertia, centre);
  const Real inverse = 1 / h.dot(inertia * h);
  pinned.one_axis = true;
  pinned.axis = h;
  pinned.inverse_inertia = inverse * h * h.transpose();
  pinned.inverse_moments = {inverse, 0, 0};
  pinned.principal_axes = Quaternion::FromTwoVectors(Vector3::UnitX(), h);
  return pinned;
}

// Moves the reference point of a body by `shift` (body axes) in everything that is fastened to it.
void shift_anchors(Model& model, int body, const Vector3& shift) {
  const auto move = [&](int end, Vector3& anchor) {
    if (end == body) anchor -= shift;
  };
  each_force_list(model.forces, [&](auto& list) {
    for (auto& force : list) force.shift_anchors(body, shift);
  });
  for (Joint& j : model.joints) move(j.body, j.anchor), move(j.to, j.to_anchor);
}

// A locked body holds like the world: its end of a joint is a place of the world.
void fasten(const Model& model, Joint& joint) {
  const auto locked = [&](int body) { return body != fixed_world && model.bodies[at(body)].locked; };
  const auto place = [&](int body, const Vector3& anchor) -> Vector3 {
    return model.motions[at(body)].position + model.motions[at(body)].orientation * anchor;
  };
  if (!find_reducible(joint.type) || locked(joint.to) == locked(joint.body)) return;
  if (locked(joint.to)) {
    joint.to_anchor = place(joint.to, joint.to_anchor);
    joint.to_axis = model.motions[at(joint.to)].orientation * joint.to_axis;
    joint.to = fixed_world;
  } else if (joint.to != fixed_world) {
    joint.anchor = place(joint.body, joint.anchor);
    joint.axis = model.motions[at(joint.body)].orientation * joint.axis;
    std::swap(joint.body, joint.to);
    std::swap(joint.anchor, joint.to_anchor);
    std::swap(joint.axis, joint.to_axis);
    joint.to = fixed_world;
  }
}

// Requires find_reducible(joint.type).
bool pin(Reduced& reduced, const Joint& joint) {
  Model& model = reduced.model;
  const int i = joint.to == fixed_world ? joint.body : joint.to;
  const bool first = i == joint.body;
  Body& body = model.bodies[at(i)];
  Motion& motion = model.motions[at(i)];
  const Vector3 anchor = first ? joint.anchor : joint.to_anchor;
  const Vector3 place = first ? joint.to_anchor : joint.anchor;
  if (body.locked || body.pinned) return false;

  Vector3 shift = anchor;  // the new reference point from the old, body axes
  if (joint.type == on_rod) {
    if (!anchor.isZero(0) || !is_point(model, i)) return false;
    // A rod without mass from the pivot to the point: c = R^T (p - x),  I = m (|c|^2 1 - c c^T).
    const Vector3 c = motion.orientation.conjugate() * (motion.position - place);
    reduced.readings[at(i)] = {i, true, true, motion.orientation, body.inertia};
    body = pinned_body(body, shifted(Matrix3::Zero(), body.mass, c), c);
    shift = -c;
  } else {
    const Matrix3 inertia = shifted(body.inertia, body.mass, -anchor);
    reduced.readings[at(i)] = {i, true, false, {}, body.inertia};
    body = joint.type == about_axis
               ? one_axis_body(body, inertia, -anchor, first ? joint.axis : joint.to_axis)
               : pinned_body(body, inertia, -anchor);
  }
  shift_anchors(model, i, shift);

  // L about the pivot = L + r x K;  the pivot itself rests.
  const Vector3 r = motion.orientation * body.centre;
  motion.angular_momentum += r.cross(motion.momentum);
  motion.momentum.setZero();
  motion.position = place;
  return true;
}

// The same bodies, those that can move first.
void order(Reduced& reduced) {
  Model& m = reduced.model;
  const auto moves = [&](int body) { return !m.bodies[at(body)].locked; };
  std::vector<int> bodies(m.bodies.size());
  std::iota(bodies.begin(), bodies.end(), 0);
  if (std::is_partitioned(bodies.begin(), bodies.end(), moves)) return;
  std::stable_partition(bodies.begin(), bodies.end(), moves);
  const auto sort = [&](auto& list) {
    if (list.empty()) return;
    auto sorted = list;
    for (std::size_t i = 0; i < bodies.size(); ++i) sorted[i] = list[at(bodies[i])];
    list = std::move(sorted);
  };
  sort(m.bodies), sort(m.motions), sort(m.shapes), sort(m.surfaces), sort(m.filters);
  sort(reduced.readings);
  const Numbering numbering(std::move(bodies));
  for (Joint& joint : m.joints) joint.body = numbering(joint.body), joint.to = numbering(joint.to);
  each_force_list(m.forces, [&](auto& list) {
    for (auto& force : list) force.renumber(numbering);
  });
  for (BodyPair& pair : m.apart) {
    const auto [low, high] = std::minmax(numbering(pair[0]), numbering(pair[1]));
    pair = {low, high};
  }
  std::sort(m.apart.begin(), m.apart.end());
}

void reduce_joints(Reduced& reduced) {
  Model& m = reduced.model;
  for (Joint& joint : m.joints) fasten(m, joint);
  for (std::size_t k = 0; k < m.joints.size();) {
    const Joint joint = m.joints[k];
    const int i = joint.to == fixed_world ? joint.body : joint.to;
    const bool to_world = (joint.to == fixed_world) != (joint.body == fixed_world);
    const bool touches = i != fixed_world && !m.surfaces.empty() && m.surfaces[at(i)] != no_surface;
    const Reducible* form = find_reducible(joint.type);
    if (to_world && form && !touches && !floats(m) && !m.frame && m.bodies[at(i)].mass_rate == 0 &&
        pin(reduced, joint)) {
      reduced.pinned.push_back("body " + std::to_string(i) + " " + form->motion);
      m.joints.erase(m.joints.begin() + static_cast<std::ptrdiff_t>(k));
    } else {
      ++k;
    }
  }
}

Motion read(const Body& body, const Reading& reading, const Motion& motion) {
  if (!reading.pinned) return motion;
  // p = x + R c,  K = m w x R c,  L_spin = R I R^T w
  const Matrix3 r = motion.orientation.toRotationMatrix();
  const Vector3 arm = r * body.centre, w = angular_velocity(body, motion);
  Motion out;
  out.position = motion.position + arm;
  out.momentum = body.mass * w.cross(arm);
  out.orientation = motion.orientation;
  out.angular_momentum = r * (reading.inertia * (r.transpose() * w));
  if (reading.keeps_orientation) {
    out.orientation = reading.orientation;
    out.angular_momentum.setZero();
  }
  return out;
}

}  // namespace

Reduced reduce(Model model) {
  Reduced reduced{std::move(model), {}, {}};
  reduced.readings.resize(reduced.model.bodies.size());
  for (std::size_t i = 0; i < reduced.readings.size(); ++i) reduced.readings[i].body = static_cast<int>(i);
  if (reduced.model.reduce_joints) reduce_joints(reduced);
  order(reduced);
  return reduced;
}

void read(const std::vector<Body>& bodies, const std::vector<Reading>& readings, const Motion* motions,
          std::vector<Motion>& given) {
  const std::size_t count = given.size() == readings.size() ? movable_end(bodies) : readings.size();
  given.resize(readings.size());
  for (std::size_t i = 0; i < count; ++i)
    given[at(readings[i].body)] = read(bodies[i], readings[i], motions[i]);
}

}  // namespace cylon::engine
