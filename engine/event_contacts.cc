// EventStepper at one instant: finds contacts, solves impacts, chooses persistent contacts, and falls back
// where Coulomb friction has no solution.
#include "engine/event_stepper.h"

#include "engine/contact/response.h"
#include "engine/geometry/manifold.h"
#include "engine/geometry/pose.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

// Points nearer than this many ulps of the lengths around them touch, and at one instant: 3e-12 m at 3 m in
// double, which at 1 m/s is 3e-12 s.
constexpr Real touch_ulps = is_double ? 4096 : 64;

// Slip slower than this part of what gravity gives in a step is turned by friction less than it should be,
// and where it ends it counts as none.  A slip of 0.7 m/s that turns round on an incline through any least
// speed from 1e-1 to 1e-17 m/s is then off by 5e-11 m/s at most (EventTurning; 1e-5 in place of
// 1e-8: 1.2e-7); the work grows as its logarithm.
constexpr Real turning_part = is_double ? Real(1e-8) : Real(1e-4);

// A bounce that would return within this part of a step is the end of a Zeno sequence: the contact rests.
// What is cut off has the height a (1e-6 h)^2 / 8, 1e-18 m for a = g and h = 1 ms.
constexpr Time zeno_return = is_double ? 1e-6 : 1e-3;

// Points of a general pair touch at any gap within the margin, so that what they fall is known to that only:
// bounces lower than this part of it would go on without end.
constexpr Real lowest_bounce = Real(0.25);

// Points of a general pair that are held count as touching up to so many margins.
constexpr Real held_margin = 128;

// Forces that are off the laws by less than this part of what accelerates are not given up: where points that jam each other
// begin to slip all at once, which way they do is known to no more.
constexpr Real nearly_exact = is_double ? Real(1e-4) : Real(1e-3);

// Bound on the speed of any point of a body [m/s].
Real surface_speed(const Body& body, const Motion& m, Real size) {
  return velocity(body, m).norm() + (rotates(body) ? size * angular_velocity(body, m).norm() : 0);
}

// How far two surfaces may approach each other within `ahead`, twice.
Real reach_of(Real ahead, Real closing, Real gravity) { return 2 * ahead * (closing + ahead * gravity); }

// Whether the balls that hold two bodies are farther apart than `margin`.
bool are_apart(const Candidate& c, const Motion* motion, Real margin) {
  if (c.other == fixed_world) return false;
  const Real reach = Real(1.001) * (c.reach + c.other_reach) + margin;
  return (motion[index(c.body)].position - motion[index(c.other)].position).squaredNorm() > reach * reach;
}

}  // namespace

// What the rounding of a gap is relative to [m, rad].  Of a coordinate along an axis at least the length that error
// control measures places by: beside the origin of the world places are not exact.
Real EventStepper::scale_of(const Candidate& c, const Motion* motion) const {
  const Model& model = system_.model();
  const Real scale = gap_scale(c, model, motion);
  const bool place =
      is_of_joint(c) && model.forces.coordinate_laws[index(c.law)].at.kind == Coordinate::Kind::displacement;
  return place ? std::max(scale, scaled_.length()) : scale;
}

Real EventStepper::touch_margin(const Candidate& c, const Motion* motion) const {
  return touch_ulps * epsilon * scale_of(c, motion);
}

// The largest distance within which spots() looks at a pair.
Real EventStepper::widest_margin(const Motion* motion, Real ahead) const {
  const Model& model = system_.model();
  Real outermost = outermost_, fastest = 0;
  for (std::size_t i = 0; i < system_.count(); ++i) {
    outermost = std::max(outermost, motion[i].position.norm() + reaches_[i]);
    if (ahead > 0) fastest = std::max(fastest, surface_speed(model.bodies[i], motion[i], reaches_[i]));
  }
  return held_margin * (2 * touch_ulps * epsilon * outermost + reach_of(ahead, 2 * fastest, gravity_));
}

// All points that touch now, or may within `ahead`.
std::vector<EventStepper::Spot> EventStepper::spots(Real ahead) {
  const Model& model = system_.model();
  const auto reach = [&](const Candidate& c) -> Real {
    if (ahead == 0) return 0;
    const auto speed = [&](int body, Real size) {
      return surface_speed(model.bodies[index(body)], motions()[index(body)], size);
    };
    return reach_of(ahead,
                    speed(c.body, c.reach) + (c.other == fixed_world ? 0 : speed(c.other, c.other_reach)),
                    gravity_);
  };
  const Motion* motion = motions();
  std::vector<Spot> result;
  std::vector<TouchPoint> found;
  const auto away = [&](std::size_t body, const Vector3& place) -> Real {
    return (motion[body].position - place).norm();
  };
  const std::vector<std::size_t>& near = neighbours_.near(motion, widest_margin(motion, ahead), away);
  work_ += 2 * static_cast<std::int64_t>(near.size());
  for (const std::size_t i : near) {
    const Candidate& c = candidates_[i];
    Spot spot;
    spot.held.candidate = i;
    if (is_of_joint(c)) {
      spot.touch = touch_of(spot.held, motion);
      // Forces along a coordinate know no bound, so that it may come to any of its stops within a time.
      if (ahead > 0 || spot.touch.gap <= touch_margin(c, motion)) result.push_back(spot);
      continue;
    }
    const Real margin = touch_margin(c, motion) + reach(c);
    if (are_apart(c, motion, held_margin * margin)) continue;
    if (c.kind != Candidate::Kind::general) {
      spot.touch = touch_of(spot.held, motion);
      if (spot.touch.gap <= margin && !inside_surface(spot.touch)) result.push_back(spot);
      continue;
    }
    found.clear();
    if (touches_of(c, model, motion, holds(i) ? held_margin * margin : margin, found))
      log_.note(DiagnosticKind::points_left_out, now_, Manifold::capacity);
    const Motion &a = motion[index(c.body)], &b = motion[index(c.other)];
    for (const TouchPoint& touch : found) {
      if (inside_surface(touch)) continue;
      spot.held.facets = facets_at(model.shapes[index(c.body)], pose(a), model.shapes[index(c.other)],
                                   pose(b), touch.position, touch.normal, touch.gap);
      spot.touch = touch_of(spot.held, motion);
      result.push_back(spot);
    }
  }
  return result;
}

// Whether a touch is on what is no surface, as the locked shapes beside it cover it.
bool EventStepper::inside_surface(const TouchPoint& touch) const {
  if (touch.other == fixed_world) return false;
  const Motion* motion = motions();
  const auto covered = [&](int on, int body, Real side) {
    const Vector3 on_surface = touch.position - side * touch.gap / 2 * touch.normal;
    return seams_.covers(on, 0, body, motion[index(on)], on_surface, side * touch.normal,
                         motion[index(body)].position);
  };
  return covered(touch.other, touch.body, 1) || covered(touch.body, touch.other, -1);
}

// Impacts of this instant, then which contacts last.
void EventStepper::resolve(Time now) {
  now_ = now;
  resting_ = false;
  fresh_ = instant_ = true;
  system_.set_masses(y_.data());
  std::vector<Spot> touching = spots();
  if (touching.empty()) {
    held_.clear();
    return;
  }
  strike_spots(now, touching);
  hold_spots(now, touching);
}

// Impacts.  A point whose bounce would return too soon to be followed is struck again without restitution,
// from the same momenta.
void EventStepper::strike_spots(Time now, std::vector<Spot>& touching) {
  const Model& model = system_.model();
  const std::vector<Body>& bodies = model.bodies;
  Motion* motion = motions();
  const auto rate_now = [&](const TouchPoint& t) { return gap_rate(t, bodies, motion); };
  const bool approaching = std::any_of(touching.begin(), touching.end(), [&](const Spot& s) {
    return rate_now(s.touch) <
           -std::max(rest_speed(s.held.candidate), speed_rounding(s.touch, bodies, motion));
  });
  if (!approaching) return;

  system_.load(now, y_.data());
  std::vector<TouchPoint> touches;
  for (const Spot& spot : touching) {
    touches.push_back(spot.touch);
    if (plastic_) touches.back().restitution = 0;
  }
  const std::vector<Row> joints = joint_rows(motion);
  // -g'' without the contacts
  std::vector<Real> pulls =
      free_partings(touches, joints,
                    {bodies, motion, system_.kinematics().data(), system_.loads().data(), system_.count()});
  for (Real& pull : pulls) pull = -pull;
  // Of the speeds that the pulls were computed from: a blow may leave two bodies at rest.
  std::vector<Real> rounding;
  for (const TouchPoint& touch : touches) rounding.push_back(speed_rounding(touch, bodies, motion));
  copy(y_, before_);
  ImpactOutcome outcome;
  // Every pass but the last takes the restitution of one more point: there are no more passes than this.
  for (std::size_t pass = 0; pass <= touches.size(); ++pass) {
    copy(before_, y_);
    outcome = strike(touches, model.impacts, joints, bodies, motion);
    work_ += outcome.rounds * solution(touches.size()) + outcome.operations;
    bool again = false;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      // What its own bounce gave it: a blow elsewhere may have taken that, and gone on with it.
      const Real u = std::max(rate_now(touches[i]), touches[i].restitution * outcome.approach[i]);
      // A pull that is rounding (of gyroscopic terms that cancel) brings nothing back.
      const bool pulled = static_cast<Real>(dt_) * pulls[i] >
                          std::max(rounding[i], speed_rounding(touches[i], bodies, motion));
      const Candidate& c = candidates_[touching[i].held.candidate];
      const Real low = c.kind == Candidate::Kind::general ? lowest_bounce * touch_margin(c, motion) : 0;
      const bool soon =
          pulled && (2 * u < static_cast<Real>(zeno_return * dt_) * pulls[i] || u * u < 2 * pulls[i] * low);
      if (touches[i].restitution == 0 || outcome.approach[i] == 0 || !soon) continue;
      touches[i].restitution = 0;
      again = true;
    }
    if (!again) break;
  }
  // Rocking that no restitution keeps up: what a blow elsewhere lifts by less than the rounding of the gap stays.
  const bool blow =
      std::any_of(outcome.approach.begin(), outcome.approach.end(), [](Real u) { return u > 0; });
  for (std::size_t i = 0; blow && i < touches.size(); ++i) {
    const Real u = rate_now(touches[i]);
    const Real low = 16 * epsilon * scale_of(candidates_[touching[i].held.candidate], motion);
    touching[i].returns =
        touches[i].restitution == 0 && outcome.approach[i] == 0 && u > 0 && u * u < 2 * pulls[i] * low;
  }
  if (!outcome.exact && outcome.violation > *std::ranges::max_element(rounding))
    log_.note(DiagnosticKind::impacts_inexact, now, {}, static_cast<double>(outcome.violation));
  if (outcome.order_counts) log_.note(DiagnosticKind::impacts_ordered, now);
  if (!outcome.ended) log_.note(DiagnosticKind::impacts_unending, now, outcome.turns);

  for (std::size_t i = 0; keep_ && i < touches.size(); ++i) tell(touching[i], outcome.impulse[i]);

  // One record per pair that met: its fastest point.
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const bool first_of_pair = i == 0 || touches[i].pair != touches[i - 1].pair;
    if (!first_of_pair) continue;
    std::size_t fastest = i;
    for (std::size_t j = i; j < touches.size() && touches[j].pair == touches[i].pair; ++j) {
      if (outcome.approach[j] > outcome.approach[fastest]) fastest = j;
    }
    const TouchPoint& touch = touches[fastest];
    const Real rest = rest_speed(touching[fastest].held.candidate);
    if (outcome.approach[fastest] <= std::max(rest, speed_rounding(touch, bodies, motion))) continue;
    struck_ = true;
    if (touch.row) continue;
    Impact impact;
    impact.time = now;
    impact.body = given(touch.body);
    impact.other = given(touch.other);
    impact.plane = candidates_[touching[fastest].held.candidate].plane;
    impact.approach = outcome.approach[fastest];
    impact.separation = std::max<Real>(0, rate_now(touch));
    impacts_.push_back(impact);
  }
}

// What pressed, and by what impulse [N s] on the first body.
void EventStepper::tell(const Spot& spot, const Vector3& impulse) {
  const TouchPoint& touch = spot.touch;
  if (touch.row) return;
  const Real pressed = touch.normal.dot(impulse);
  if (!(pressed > 0)) return;
  contacts_.push_back({given(touch.body), given(touch.other), candidates_[spot.held.candidate].plane,
                       touch.position, touch.normal, pressed, Vector3(impulse - pressed * touch.normal)});
}

// What has lasted until an event: it pressed for a part of the step, and how hard is not known.
void EventStepper::note_held() {
  if (!keep_) return;
  for (const HeldPoint& held : held_) {
    if (is_of_joint(candidates_[held.candidate])) continue;
    const TouchPoint touch = touch_of(held, motions());
    contacts_.push_back({given(touch.body), given(touch.other), candidates_[held.candidate].plane,
                         touch.position, touch.normal});
  }
}

// Of the contacts that are held; none where they do not obey the laws to rounding.
std::vector<ContactForce> EventStepper::held_forces(Time now) {
  if (held_.empty()) return {};
  const std::int64_t work = work_;
  ContactForces found = support(now, y_.data());
  work_ = work;  // told or not, a step has the same work
  return found.exact ? std::move(found.points) : std::vector<ContactForce>{};
}

// What lasts at the end of a step.  Where it lasted all of it and nothing happened, with the forces `begun`, its
// impulse is J = (F_begun + F_now) dt/2 + O(dt^3); elsewhere that is not known.
void EventStepper::note_lasting(Time now, const std::vector<ContactForce>& begun) {
  const std::vector<ContactForce> lasting = held_forces(now);
  const bool known = !lasting.empty() && begun.size() == lasting.size();
  for (std::size_t i = 0; i < held_.size(); ++i) {
    if (is_of_joint(candidates_[held_[i].candidate])) continue;
    const TouchPoint touch = touch_of(held_[i], motions());
    Contact contact{given(touch.body), given(touch.other), candidates_[held_[i].candidate].plane,
                    touch.position, touch.normal};
    if (known) {
      const Vector3 impulse = static_cast<Real>(dt_ / 2) * (begun[i].force + lasting[i].force);
      contact.impulse = touch.normal.dot(impulse);
      contact.friction = impulse - *contact.impulse * touch.normal;
    }
    contacts_.push_back(contact);
  }
}

// Contacts that do not part last: held points and how they are held.
void EventStepper::hold_spots(Time now, const std::vector<Spot>& touching) {
  const std::vector<Body>& bodies = system_.model().bodies;
  Motion* motion = motions();
  system_.load(now, y_.data());
  Real speed = 0, push = 0;
  for (std::size_t i = 0; i < system_.count(); ++i) {
    if (bodies[i].locked) continue;
    speed = std::max(speed, velocity(bodies[i], motion[i]).norm());
    push = std::max(push, bodies[i].inverse_mass * system_.loads()[i].force.norm());
  }
  for (const Spot& s : touching) speed = std::max(speed, relative_velocity(s.touch, bodies, motion).norm());
  note_pulls(touching);
  std::vector<Real> slow;
  for (const Spot& s : touching) {
    const Real h = static_cast<Real>(dt_);
    slow.push_back(s.touch.row ? speed_rounding(s.touch, bodies, motion) +
                                     slow_ulps * epsilon * pulls_[s.held.candidate] * h
                               : slow_ulps * epsilon * (speed + push * h));
  }
  slow_slip_ = turning_part * haste_ * push * static_cast<Real>(dt_);
  rest_speed_ = rest_ulps * epsilon * push * static_cast<Real>(dt_);

  std::vector<std::size_t> which;
  ContactForces support = find_holds(touching, slow, which);
  if (!support.exact && support.violation > nearly_exact * push) {  // jams: see loosen()
    for (const std::size_t i : which) restless_[touching[i].held.candidate] = 1;
    if (loosen(now)) support = find_holds(touching, slow, which);
  }
  if (!support.exact)
    log_.note(DiagnosticKind::forces_inexact, now, {}, static_cast<double>(support.violation));
  if (support.undecided > 0)
    log_.note(DiagnosticKind::loads_undecided, now, {}, static_cast<double>(support.undecided));
  held_.clear();
  for (std::size_t i = 0; i < which.size(); ++i) {
    if (support.points[i].holding.grip == Grip::parts) continue;
    HeldPoint held = touching[which[i]].held;
    held.holding = support.points[i].holding;
    held.slow = std::max(slow[which[i]], left_slip(held.candidate));
    held_.push_back(held);
  }
  if (held_.empty()) return;
  system_.set_holder(this);
  system_.project(y_.data());
  resting_ = support.exact && nothing_moves(support);
}

// Friction that grows without bound wedges what slips: it stops at once, or, where no impulse within the
// cones stops it, does not rub for the rest of the step.
void EventStepper::wedge(Time now) {
  Motion* motion = motions();
  touches_.clear();
  for (const HeldPoint& h : held_) {
    touches_.push_back(touch_of(h, motion));
    if (h.holding.grip == Grip::slides) restless_[h.candidate] = 1;
  }
  if (stop_slip(touches_, joint_rows(motion), system_.model().bodies, motion))
    log_.note(DiagnosticKind::wedged, now);
  else
    loosen(now);
}

// Leaves out the friction of what changes without end, else of all; false where none was left.  Without
// friction there is always one motion, and a contact that does not rub gives no energy; a law that has no
// solution (Painleve's, where friction presses what it brakes) or infinitely many changes of its mind is
// left for the rest of a step only, and told.
bool EventStepper::loosen(Time now) {
  bool any = false;
  for (const bool all : {false, true}) {
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (loose_[i] || !(all || restless_[i]) || !(candidates_[i].material.friction > 0)) continue;
      loose_[i] = 1;
      any = true;
    }
    if (any) break;
  }
  if (any) log_.note(DiagnosticKind::frictionless, now);
  return any;
}

// Nothing moves, nothing pushes, and no force will come with time: what is so stays so.
bool EventStepper::nothing_moves(const ContactForces& support) const {
  const Model& model = system_.model();
  const Motion* motion = motions();
  if (model.frame || any_force(model.forces, [](const auto& force) { return force.reads_time(); }))
    return false;
  for (std::size_t i = 0; i < system_.count(); ++i) {
    if (model.bodies[i].mass_rate != 0) return false;
    if (!motion[i].momentum.isZero(0) || !motion[i].angular_momentum.isZero(0)) return false;
  }
  return balanced(
      support, {model.bodies, motion, system_.kinematics().data(), system_.loads().data(), system_.count()});
}

// How the points are held that do not part, and which they are.
ContactForces EventStepper::find_holds(const std::vector<Spot>& touching, const std::vector<Real>& slow,
                                       std::vector<std::size_t>& which) {
  const std::vector<Body>& bodies = system_.model().bodies;
  const Motion* motion = motions();
  std::vector<TouchPoint> touches;
  std::vector<Holding> guess;
  std::vector<Vector3> places;  // of what was held
  std::vector<Real> still;      // of the touches
  for (const HeldPoint& held : held_) places.push_back(touch_of(held, motion).position);
  which.clear();
  for (std::size_t i = 0; i < touching.size(); ++i) {
    TouchPoint touch = touching[i].touch.pair >= 0 ? touching[i].touch : TouchPoint{};
    if (gap_rate(touch, bodies, motion) > slow[i] && !touching[i].returns) continue;
    // velocities have changed since the touch was measured
    touch = touch_of(touching[i].held, motion);
    touches.push_back(touch);
    which.push_back(i);
    still.push_back(std::max(slow[i], left_slip(touching[i].held.candidate)));
    // As it was held before: a point of the same candidate, of several the nearest.
    Holding before{Grip::parts};
    Real nearest = std::numeric_limits<Real>::infinity();
    for (std::size_t k = 0; k < held_.size(); ++k) {
      const Real far = (places[k] - touch.position).norm();
      if (held_[k].candidate != touching[i].held.candidate || !(far < nearest)) continue;
      nearest = far;
      before = held_[k].holding;
    }
    guess.push_back(before);
  }
  if (touches.empty()) return {};
  if (held_.empty()) guess.clear();
  const Instant instant{bodies, motion, system_.kinematics().data(), system_.loads().data(), system_.count()};
  work_ += 4 * solution(touches.size());
  ContactForces found = find_contact_forces(touches, joint_rows(motion), instant, still, guess);
  work_ += found.operations;
  return found;
}

// Slip that the last event left over at a candidate.  Of surfaces all points of a body may end together; the rate of
// a coordinate has a unit of its own.
Real EventStepper::left_slip(std::size_t candidate) const {
  const bool alone = is_of_joint(candidates_[candidate]) || is_of_joint(candidates_[ended_]);
  return !alone || candidate == ended_ ? left_slip_ : Real(0);
}

// Slower than this does not approach [m/s; a coordinate: its unit/s].
Real EventStepper::rest_speed(std::size_t candidate) const {
  if (!is_of_joint(candidates_[candidate])) return rest_speed_;
  return rest_ulps * epsilon * pulls_[candidate] * static_cast<Real>(dt_);
}

}  // namespace cylon::engine
