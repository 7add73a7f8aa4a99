// Persistent contacts of EventStepper between events: contact points, normal and friction forces, and the
// correction of the gap.
#include "engine/contact/response.h"
#include "engine/event_stepper.h"
#include "engine/joint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

constexpr Real ulp = std::numeric_limits<Real>::epsilon();

}  // namespace

std::vector<Row> EventStepper::joint_rows(const Motion* motion) const {
  std::vector<Row> rows;
  for (const Joint& joint : system_.model().joints) add_rows(joint, system_.model().bodies, motion, rows);
  return rows;
}

// The touch of a held point as it is now.
TouchPoint EventStepper::touch_of(const HeldPoint& held, const Motion* motion) const {
  const Candidate& c = candidates_[held.candidate];
  const Model& model = system_.model();
  if (!held.general) {
    TouchPoint touch = touch_at(c, model, motion);
    if (loose_[held.candidate]) touch.friction = 0;
    return touch;
  }
  const Motion &a = motion[index(c.body)], &b = motion[index(c.other)];
  const Body &body = model.bodies[index(c.body)], &other = model.bodies[index(c.other)];
  const Vector3 arm_a = a.orientation * held.on_body, arm_b = b.orientation * held.on_other;
  const auto spin = [](const Body& which, const Motion& m) -> Vector3 {
    return rotates(which) ? angular_velocity(which, m) : Vector3(Vector3::Zero());
  };
  const Vector3 w_a = spin(body, a), w_b = spin(other, b);
  TouchPoint touch;
  touch.body = c.body;
  touch.other = c.other;
  touch.pair = c.pair;
  touch.restitution = c.material.restitution;
  touch.friction = loose_[held.candidate] ? 0 : c.material.friction;
  touch.normal = (held.face_of_body ? a.orientation : b.orientation) * held.normal;
  touch.turning = (held.face_of_body ? w_a : w_b).cross(touch.normal);
  // Of cores c and radii r:  g = n . (c_a - c_b) - r_a - r_b,  x_a = c_a - r_a n,  x_b = c_b + r_b n;
  // n . n'' = -|n'|^2.
  const Real r_a = core_radius(model.shapes[index(c.body)]), r_b = core_radius(model.shapes[index(c.other)]);
  const Vector3 v_a = velocity(body, a) + w_a.cross(arm_a), v_b = velocity(other, b) + w_b.cross(arm_b);
  const Vector3 x_a = a.position + arm_a - r_a * touch.normal, x_b = b.position + arm_b + r_b * touch.normal;
  touch.gap = touch.normal.dot(x_a - x_b);
  touch.position = held.face_of_body ? x_b : x_a;
  touch.path = held.face_of_body ? Vector3(v_b + r_b * touch.turning) : Vector3(v_a - r_a * touch.turning);
  touch.curvature = touch.normal.dot(w_a.cross(w_a.cross(arm_a)) - w_b.cross(w_b.cross(arm_b))) +
                    2 * touch.turning.dot(v_a - v_b) - (r_a + r_b) * touch.turning.squaredNorm();
  return touch;
}

void EventStepper::hold(Time, const std::vector<Body>& bodies, const Motion* motion,
                        const Kinematics* kinematics, Load* loads) {
  touches_.clear();
  holdings_.clear();
  for (const HeldPoint& h : held_) {
    touches_.push_back(touch_of(h, motion));
    holdings_.push_back(h.holding);
  }
  const std::vector<Row> joints = joint_rows(motion);
  work_ += cube(touches_.size(), joints.size());
  add_forces(
      held_contact_forces(touches_, holdings_, joints, {bodies, motion, kinematics, loads}, slow_slip_),
      loads, system_.count());
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
  work_ += cube(touches_.size(), system_.model().joints.size());
  return held_contact_forces(touches_, holdings_, joint_rows(motion), now, slow_slip_);
}

// The directions that slip has now.
void EventStepper::turn_slips() {
  const std::vector<Body>& bodies = system_.model().bodies;
  const Motion* motion = motions();
  for (HeldPoint& h : held_) {
    if (h.holding.grip != Grip::slides || h.holding.slip.isZero(0)) continue;
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
// velocity at points that stick.  What is closed to rounding is left alone: rest does not creep.
void EventStepper::project(const std::vector<Body>& bodies, Motion* motion) {
  constexpr int sweeps = 4;  // of Newton's method: each leaves the square of what is small already
  const auto gather = [&](bool speeds) {
    rows_.rows = joint_rows(motion);
    bool closed = rows_.closed();
    std::vector<Row> three;
    for (const HeldPoint& h : held_) {
      const TouchPoint touch = touch_of(h, motion);
      three.clear();
      append_rows(touch, bodies, motion, three);
      three[0].offset = touch.gap;
      three[0].rounding = 16 * ulp * gap_scale(candidates_[h.candidate], system_.model(), motion);
      closed = closed && std::abs(touch.gap) <= three[0].rounding;
      const std::size_t count = speeds && h.holding.grip == Grip::sticks ? 3 : 1;
      rows_.rows.insert(rows_.rows.end(), three.begin(), three.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return closed;
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (gather(false)) break;
    rows_.project_positions(bodies, motion);
  }
  gather(true);
  rows_.project_velocities(bodies, motion);

  for (std::size_t i = 0; i < system_.count(); ++i) {
    bool sticks = false, slides = false;
    Real reach = 0;
    for (const HeldPoint& h : held_) {
      const Candidate& c = candidates_[h.candidate];
      if (index(c.body) != i && (c.other == fixed_world || index(c.other) != i)) continue;
      (h.holding.grip == Grip::sticks ? sticks : slides) = true;
      reach = std::max({reach, c.reach, c.other_reach});
    }
    if (!sticks || slides) continue;
    Motion& m = motion[i];
    if (velocity(bodies[i], m).norm() + reach * angular_velocity(bodies[i], m).norm() > rest_speed_) continue;
    m.momentum.setZero();
    m.angular_momentum.setZero();
  }
}

}  // namespace cylon::engine
