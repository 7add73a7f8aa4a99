// Persistent contacts of EventStepper between events: contact points, normal and friction forces, and the
// correction of the gap.
#include "engine/contact/response.h"
#include "engine/event_stepper.h"
#include "engine/geometry/pose.h"
#include "engine/joint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

// What joints keep.
std::vector<Row> EventStepper::conditions(const Motion* motion) const {
  std::vector<Row> rows;
  for (const Joint& joint : system_.model().joints) add_rows(joint, system_.model().bodies, motion, rows);
  return rows;
}

// The same, and the rotors on their coordinates: all that answers a push through joints.
std::vector<Row> EventStepper::joint_rows(const Motion* motion) const {
  std::vector<Row> rows = conditions(motion);
  add_rotor_rows(system_.model(), motion, rows);
  return rows;
}

// The touch of a held point as it is now.
TouchPoint EventStepper::touch_of(const HeldPoint& held, const Motion* motion) const {
  const Candidate& c = candidates_[held.candidate];
  const Model& model = system_.model();
  TouchPoint touch;
  if (held.facets) {
    touch.body = c.body;
    touch.other = c.other;
    touch.pair = c.pair;
    touch.restitution = c.material.restitution;
    touch.friction = c.material.friction;
    const std::size_t a = index(c.body), b = index(c.other);
    place_touch(*held.facets, model.bodies[a], motion[a], core_radius(model.shapes[a]), model.bodies[b],
                motion[b], core_radius(model.shapes[b]), touch);
  } else {
    touch = touch_at(c, model, motion);
  }
  if (loose_[held.candidate]) touch.friction = touch.bound = 0;
  return touch;
}

// How far a held point is from leaving its facets [m].
Real EventStepper::room_of(const HeldPoint& held, const Motion* motion) const {
  const Model& model = system_.model();
  const std::size_t a = index(candidates_[held.candidate].body), b = index(candidates_[held.candidate].other);
  return room_on(*held.facets, model.shapes[a], pose(motion[a]), model.shapes[b], pose(motion[b]));
}

void EventStepper::hold(Time t, const std::vector<Body>& bodies, const Motion* motion,
                        const Kinematics* kinematics, Load* loads) {
  now_ = t;
  touches_.clear();
  holdings_.clear();
  for (const HeldPoint& h : held_) {
    touches_.push_back(touch_of(h, motion));
    holdings_.push_back(h.holding);
  }
  const std::vector<Row> joints = joint_rows(motion);
  work_ += solution(touches_.size());
  add_forces(
      held_contact_forces(touches_, holdings_, joints, {bodies, motion, kinematics, loads}, slow_slip_),
      bodies, loads, system_.count());
}

ContactForces EventStepper::support(Time t, const Real* y) {
  system_.load(t, y);
  const Motion* motion = system_.motions(y);
  touches_.clear();
  holdings_.clear();
  for (const HeldPoint& h : held_) {
    touches_.push_back(touch_of(h, motion));
    holdings_.push_back(h.holding);
  }
  const Instant now{system_.model().bodies, motion, system_.kinematics().data(), system_.loads().data(),
                    system_.count()};
  work_ += solution(touches_.size());
  return held_contact_forces(touches_, holdings_, joint_rows(motion), now, slow_slip_);
}

// The directions that slip of surfaces has now; that of a coordinate has no other until it ends.
void EventStepper::turn_slips() {
  const std::vector<Body>& bodies = system_.model().bodies;
  const Motion* motion = motions();
  for (HeldPoint& h : held_) {
    if (h.holding.grip != Grip::slides || h.holding.slip.isZero(0) || is_of_joint(candidates_[h.candidate]))
      continue;
    const TouchPoint touch = touch_of(h, motion);
    Vector3 u = relative_velocity(touch, bodies, motion);
    u -= touch.normal.dot(u) * touch.normal;
    const Real speed = u.norm();
    if (!(speed > slow_slip_)) continue;
    u /= speed;
    fresh_ = fresh_ || u != h.holding.slip;
    h.holding.slip = u;
  }
}

// Gaps of held points and joints to zero by the shortest way; then velocities into held surfaces, and all
// velocity at points that stick.  What is closed to rounding is left alone: rest does not creep.  Where rows nearly say the
// same the way to their common zero is far, and no shorter for having been gone: a round that brings nothing nearer is undone.
void EventStepper::project(const std::vector<Body>& bodies, Motion* motion) {
  constexpr int sweeps = 4;  // of Newton's method: each leaves the square of what is small already
  const auto gather = [&](bool speeds) {
    rows_.rows = conditions(motion);
    bool closed = rows_.closed();
    std::vector<Row> three;
    for (const HeldPoint& h : held_) {
      const TouchPoint touch = touch_of(h, motion);
      three.clear();
      append_rows(touch, bodies, motion, three);
      const auto first = static_cast<std::size_t>(touch.axis);
      three[first].offset = touch.gap;
      three[first].rounding = 16 * epsilon * scale_of(candidates_[h.candidate], motion);
      closed = closed && std::abs(touch.gap) <= three[first].rounding;
      // Of a coordinate the one row that it has: dry friction holds a rate where it sticks, and no place.
      const bool sticks = speeds && h.holding.grip == Grip::sticks;
      const std::ptrdiff_t from = touch.axis;
      const std::ptrdiff_t to = from > 0 && !sticks ? from : touch.row ? from + 1 : sticks ? 3 : 1;
      rows_.rows.insert(rows_.rows.end(), three.begin() + from, three.begin() + to);
    }
    return closed;
  };
  bool closed = gather(false);
  std::vector<Motion> before;
  Real open_before = rows_.widest();
  int sweep = 0;
  while (sweep < sweeps && !closed) {
    ++sweep;
    before.assign(motion, motion + system_.count());
    rows_.project_positions(bodies, motion);
    closed = gather(false);
    const Real open_now = rows_.widest();
    if (!closed && !(open_now < open_before)) {
      std::copy(before.begin(), before.end(), motion);
      break;
    }
    open_before = open_now;
  }
  gather(true);
  if (const Real open = closed ? Real(0) : rows_.opening(); open != 0)
    log_.note(DiagnosticKind::contacts_open, now_, sweep, static_cast<double>(open));
  rows_.project_velocities(bodies, motion);
  stop_what_rests(motion);
}

// What is held on all its points and moves by no more than rounding does not move.
void EventStepper::stop_what_rests(Motion* motion) const {
  for (std::size_t i = 0; i < system_.count(); ++i) {
    const Body& body = system_.model().bodies[i];
    bool sticks = false, slides = false, of_joint = false;
    Real reach = 0;
    for (const HeldPoint& h : held_) {
      const Candidate& c = candidates_[h.candidate];
      if (index(c.body) != i && (c.other == fixed_world || index(c.other) != i)) continue;
      const bool limit = is_of_joint(c) && c.kind != Candidate::Kind::dry;  // keeps the rate that it stops
      (limit || h.holding.grip == Grip::sticks ? sticks : slides) = true;
      of_joint = of_joint || is_of_joint(c);
      reach = std::max({reach, c.reach, c.other_reach});
    }
    if (!sticks || slides) continue;
    Motion& m = motion[i];
    if (of_joint) reach = std::max(reach, gyration(body));
    if (velocity(body, m).norm() + reach * angular_velocity(body, m).norm() >
        (of_joint ? stills_[i] : rest_speed_))
      continue;
    m.momentum.setZero();
    m.angular_momentum.setZero();
  }
}

// What acts on the coordinates that touch, and on the bodies that they hold; loads without contact forces.
void EventStepper::note_pulls(const std::vector<Spot>& touching) {
  const std::vector<Body>& bodies = system_.model().bodies;
  const Motion* motion = motions();
  const Instant now{bodies, motion, system_.kinematics().data(), system_.loads().data(), system_.count()};
  std::fill(stills_.begin(), stills_.end(), Real(0));
  for (const Spot& spot : touching) {
    if (!spot.touch.row) continue;
    const Row& row = *spot.touch.row;
    const Real bound = spot.touch.bound;
    pulls_[spot.held.candidate] = pull_of(spot.touch, now);
    const auto hold = [&](int body, const Vector3& lever) {
      if (body == fixed_world || index(body) >= system_.count()) return;
      const Body& b = bodies[index(body)];
      const Load& load = system_.loads()[index(body)];
      const auto turned = [&](const Vector3& torque) -> Real {
        return rotates(b) ? inverse_inertia_times(b, motion[index(body)].orientation, torque).norm()
                          : Real(0);
      };
      const Real pull = b.inverse_mass * (load.force.norm() + bound * row.direction.norm()) +
                        gyration(b) * (turned(load.torque) + bound * turned(lever));
      stills_[index(body)] =
          std::max(stills_[index(body)], rest_ulps * epsilon * pull * static_cast<Real>(dt_));
    };
    hold(row.body, row.lever);
    hold(row.to, row.to_lever);
  }
}

}  // namespace cylon::engine
