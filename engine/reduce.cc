#include "engine/reduce.h"

#include "engine/numbering.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace cylon::engine {

namespace {

// A joint to the world as the body sees it: its anchor and axis in body axes, and where they are held.
struct Fastening {
  Vector3 anchor, axis, place, to_axis;
};

// What a joint to the world may keep so that the body's own motion has coordinates without it.
struct Reducible {
  Joint::Type type;
  const char* motion;  // that is left
  bool (*pin)(Reduced&, int body, const Fastening&);
  bool alone;  // not beside other joints, which would see a mass that is not the same in all directions
};

const Reducible* find_reducible(Joint::Type type);

constexpr Joint::Type on_rod{Joint::Place::at_length, Joint::Turn::freely};

bool floats(const Model& model) {
  return std::any_of(model.forces.waters.begin(), model.forces.waters.end(),
                     [](const Water& water) { return water.mode == WaterMode::volume; });
}

// Whether nothing but a force through the centre of mass ever acts on a body that does not spin.
bool is_point(const Model& model, int body) {
  const auto off_centre = [&](int end, const Vector3& anchor) { return end == body && !anchor.isZero(0); };
  return model.motions[index(body)].angular_momentum.isZero(0) &&
         std::none_of(model.forces.springs.begin(), model.forces.springs.end(),
                      [&](const Spring& s) {
                        return off_centre(s.body, s.anchor) || off_centre(s.to, s.to_anchor);
                      }) &&
         std::none_of(model.forces.thrusts.begin(), model.forces.thrusts.end(),
                      [&](const Thrust& t) { return t.body == body; }) &&
         std::none_of(model.forces.frame_forces.begin(), model.forces.frame_forces.end(),
                      [](const FrameForce& f) { return f.turns(); }) &&
         std::none_of(model.forces.user_forces.begin(), model.forces.user_forces.end(),
                      [&](const UserForce& f) { return f.acts_on(body); }) &&
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
  const auto locked = [&](int body) { return body != fixed_world && model.bodies[index(body)].locked; };
  const auto place = [&](int body, const Vector3& anchor) -> Vector3 {
    return model.motions[index(body)].position + model.motions[index(body)].orientation * anchor;
  };
  if (!find_reducible(joint.type) || locked(joint.to) == locked(joint.body)) return;
  if (locked(joint.to)) {
    joint.to_anchor = place(joint.to, joint.to_anchor);
    joint.to_axis = model.motions[index(joint.to)].orientation * joint.to_axis;
    joint.relative = model.motions[index(joint.to)].orientation * joint.relative;
    joint.to = fixed_world;
  } else if (joint.to != fixed_world) {
    joint.anchor = place(joint.body, joint.anchor);
    joint.axis = model.motions[index(joint.body)].orientation * joint.axis;
    joint.relative = model.motions[index(joint.body)].orientation * joint.relative.conjugate();
    std::swap(joint.body, joint.to);
    std::swap(joint.anchor, joint.to_anchor);
    std::swap(joint.axis, joint.to_axis);
    joint.to = fixed_world;
  }
}

// Moves the reference point of a body to where a joint holds it; about that
//   L = L + r x K;  the pivot itself rests.
void move_reference(Reduced& reduced, int i, const Vector3& shift, const Vector3& place) {
  Model& model = reduced.model;
  Motion& motion = model.motions[index(i)];
  shift_anchors(model, i, shift);
  const Vector3 r = motion.orientation * model.bodies[index(i)].centre;
  motion.angular_momentum += r.cross(motion.momentum);
  motion.momentum.setZero();
  motion.position = place;
}

bool pin_at_point(Reduced& reduced, int i, const Fastening& f) {
  Body& body = reduced.model.bodies[index(i)];
  reduced.readings[index(i)] = {.body = i, .pinned = true, .inertia = body.inertia};
  body = pinned_body(body, shifted(body.inertia, body.mass, -f.anchor), -f.anchor);
  move_reference(reduced, i, f.anchor, f.place);
  return true;
}

bool pin_on_axis(Reduced& reduced, int i, const Fastening& f) {
  Body& body = reduced.model.bodies[index(i)];
  reduced.readings[index(i)] = {.body = i, .pinned = true, .inertia = body.inertia};
  body = one_axis_body(body, shifted(body.inertia, body.mass, -f.anchor), -f.anchor, f.axis);
  move_reference(reduced, i, f.anchor, f.place);
  return true;
}

// A rod without mass from the pivot to the point: c = R^T (p - x),  I = m (|c|^2 1 - c c^T).
bool put_on_rod(Reduced& reduced, int i, const Fastening& f) {
  Body& body = reduced.model.bodies[index(i)];
  const Motion& motion = reduced.model.motions[index(i)];
  if (!f.anchor.isZero(0) || !is_point(reduced.model, i)) return false;
  const Vector3 c = motion.orientation.conjugate() * (motion.position - f.place);
  reduced.readings[index(i)] = {i, true, true, motion.orientation, body.inertia};
  body = pinned_body(body, shifted(Matrix3::Zero(), body.mass, c), c);
  move_reference(reduced, i, -c, f.place);
  // What turns from now on is the rod: the body does not, and nothing brakes its rotation.
  for (Drag& drag : reduced.model.forces.drags)
    if (drag.body == i) drag.angular = 0;
  return true;
}

// Only moves along an axis:  K = a a^T K.
bool put_on_line(Reduced& reduced, int i, const Fastening& f) {
  Body& body = reduced.model.bodies[index(i)];
  Motion& motion = reduced.model.motions[index(i)];
  body.guide = f.to_axis * f.to_axis.transpose();
  body.inverse_inertia.setZero(), body.inverse_moments.setZero();
  motion.momentum = *body.guide * motion.momentum;
  motion.angular_momentum.setZero();
  return true;
}

// Moves along an axis and turns about it.  With the reference point on the axis and c from there to the centre,
//   v = s' a,  w = t' a,  T = m s'^2/2 + (a.I_p a) t'^2/2:  both motions are independent, as a.(a x c) = 0.
bool put_on_shaft(Reduced& reduced, int i, const Fastening& f) {
  Body& body = reduced.model.bodies[index(i)];
  Motion& motion = reduced.model.motions[index(i)];
  const Vector3 momentum = motion.momentum, place = motion.position + motion.orientation * f.anchor;
  const Real inverse_mass = body.inverse_mass;
  pin_on_axis(reduced, i, {f.anchor, f.axis, place, f.to_axis});
  body.pinned = false;
  body.inverse_mass = inverse_mass;
  body.guide = f.to_axis * f.to_axis.transpose();
  motion.momentum = *body.guide * momentum;
  return true;
}

// Moves in a plane and turns about its normal n through the centre of mass.
bool put_in_plane(Reduced& reduced, int i, const Fastening& f) {
  Body& body = reduced.model.bodies[index(i)];
  Motion& motion = reduced.model.motions[index(i)];
  const Real inverse_mass = body.inverse_mass;
  reduced.readings[index(i)] = {.body = i, .pinned = true, .inertia = body.inertia};
  body = one_axis_body(body, body.inertia, Vector3::Zero(), f.axis);
  body.pinned = false;
  body.inverse_mass = inverse_mass;
  body.guide = Matrix3::Identity() - f.to_axis * f.to_axis.transpose();
  motion.momentum = *body.guide * motion.momentum;
  return true;
}

constexpr Joint::Type about_axis{Joint::Place::together, Joint::Turn::about_axis},
    on_line{Joint::Place::along_axis, Joint::Turn::never},
    on_shaft{Joint::Place::along_axis, Joint::Turn::about_axis},
    in_plane{Joint::Place::in_plane, Joint::Turn::about_axis},
    in_gimbal{Joint::Place::together, Joint::Turn::about_three_axes};
constexpr std::array reducible = {
    Reducible{{Joint::Place::together, Joint::Turn::freely}, "turns about a point", pin_at_point, false},
    Reducible{in_gimbal, "turns about a point", pin_at_point, false},
    Reducible{about_axis, "turns about an axis", pin_on_axis, false},
    Reducible{on_rod, "keeps its distance from a point", put_on_rod, false},
    Reducible{on_line, "moves along an axis", put_on_line, true},
    Reducible{on_shaft, "moves along an axis and turns about it", put_on_shaft, true},
    Reducible{in_plane, "moves in a plane", put_in_plane, true}};

const Reducible* find_reducible(Joint::Type type) {
  const auto* row = std::ranges::find(reducible, type, &Reducible::type);
  return row == reducible.end() ? nullptr : row;
}

bool is_alone(const Model& model, int body) {
  return std::ranges::count_if(model.joints,
                               [&](const Joint& j) { return j.body == body || j.to == body; }) == 1;
}

bool pin(Reduced& reduced, const Joint& joint, const Reducible& form) {
  const Model& model = reduced.model;
  const bool first = joint.to == fixed_world;
  const int i = first ? joint.body : joint.to;
  const Body& body = model.bodies[index(i)];
  if (body.locked || body.pinned || body.guide || (form.alone && !is_alone(model, i))) return false;
  const Fastening f = first ? Fastening{joint.anchor, joint.axis, joint.to_anchor, joint.to_axis}
                            : Fastening{joint.to_anchor, joint.to_axis, joint.anchor, joint.axis};
  return form.pin(reduced, i, f);
}

// The same bodies, those that can move first.
void order(Reduced& reduced) {
  Model& m = reduced.model;
  const auto moves = [&](int body) { return !m.bodies[index(body)].locked; };
  std::vector<int> bodies(m.bodies.size());
  std::iota(bodies.begin(), bodies.end(), 0);
  if (std::is_partitioned(bodies.begin(), bodies.end(), moves)) return;
  std::stable_partition(bodies.begin(), bodies.end(), moves);
  const auto sort = [&](auto& list) {
    if (list.empty()) return;
    auto sorted = list;
    for (std::size_t i = 0; i < bodies.size(); ++i) sorted[i] = list[index(bodies[i])];
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
    const auto [low, high] = std::minmax({numbering(pair[0]), numbering(pair[1])});
    pair = {low, high};
  }
  std::sort(m.apart.begin(), m.apart.end());
}

// Whether a rotor turns with a body against what stands still: its pull is none that a body's own inertia knows.
bool drives_rotor(const Model& model, int body) {
  const auto stands = [&](int end) { return end == fixed_world || model.bodies[index(end)].locked; };
  return std::ranges::any_of(model.forces.coordinate_laws, [&](const CoordinateLaw& law) {
    return law.armature != 0 &&
           ((law.at.body == body && stands(law.at.to)) || (law.at.to == body && stands(law.at.body)));
  });
}

void reduce_joints(Reduced& reduced) {
  Model& m = reduced.model;
  for (Joint& joint : m.joints) fasten(m, joint);
  for (std::size_t k = 0; k < m.joints.size();) {
    const Joint joint = m.joints[k];
    const int i = joint.to == fixed_world ? joint.body : joint.to;
    const bool to_world = (joint.to == fixed_world) != (joint.body == fixed_world);
    const bool touches = i != fixed_world && !m.surfaces.empty() && m.surfaces[index(i)] != no_surface;
    const Reducible* form = find_reducible(joint.type);
    if (to_world && form && !touches && !floats(m) && !m.frame && m.bodies[index(i)].mass_rate == 0 &&
        !drives_rotor(m, i) && pin(reduced, joint, *form)) {
      reduced.pinned.push_back("body " + std::to_string(i) + " " + form->motion);
      m.joints.erase(m.joints.begin() + static_cast<std::ptrdiff_t>(k));
    } else {
      ++k;
    }
  }
}

Motion read(const Body& body, const Reading& reading, const Motion& motion) {
  if (!reading.pinned) return motion;
  // p = x + R c,  K = K_x + m w x R c,  L_spin = R I R^T w;  K_x = 0 where the reference point rests
  const Matrix3 r = motion.orientation.toRotationMatrix();
  const Vector3 arm = r * body.centre, w = angular_velocity(body, motion);
  Motion out;
  out.position = motion.position + arm;
  out.momentum = motion.momentum + body.mass * w.cross(arm);
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
    given[index(readings[i].body)] = read(bodies[i], readings[i], motions[i]);
}

}  // namespace cylon::engine
