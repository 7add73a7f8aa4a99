#include "engine/world.h"

#include "engine/root.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace cylon::engine {

namespace {

// A bounce that would return within this part of a step is the end of a Zeno sequence: the contact rests.
// What is cut off has the height a (1e-6 h)^2 / 8, 1e-18 m for a = g and h = 1 ms.
constexpr Real zeno_return = 1e-6;

// Impacts of one contact in one step.  From the first limit on they are plastic, which ends every sequence
// that restitution keeps alive; after the second the contact is left alone until the next step, so that a
// step always ends.
constexpr int elastic_limit = 1000;
constexpr int contact_limit = 1200;

}  // namespace

World::World(Model model, std::vector<Motion> motion, const Integrator& integrator, Real step)
    : dynamics_(std::move(model), motion),
      integrate_(integrator.advance),
      step_(step),
      motion_(std::move(motion)),
      start_(motion_),
      work_(motion_),
      hits_(dynamics_.contacts.size(), 0),
      rest_speed_(dynamics_.contacts.size(), 0) {
  assert(step > 0 && motion_.size() == dynamics_.bodies.size());
  candidates_.reserve(dynamics_.contacts.size());
  impacts_.reserve(dynamics_.contacts.size() + 16);
}

void World::step() {
  const Real begin = time();
  Real done = 0;  // of this step, up to the last impact
  impacts_.clear();
  std::fill(hits_.begin(), hits_.end(), 0);
  for (;;) {
    if (!hits_.empty()) start_ = motion_;
    advance(begin + done, step_ - done);                     // forces, momenta, positions, constraints
    const auto hit = first_hit(begin + done, step_ - done);  // detect and locate impacts
    if (!hit) break;
    motion_ = start_;
    advance(begin + done, hit->after);  // the part of the step before the first of them
    done = std::min(step_, done + hit->after);
    collide(hit->contact, begin + done);  // solve and record it
  }
  release_contacts();
  ++steps_;
}

// Integrates motion_ over a part of a step and returns it to the constraints.
void World::advance(Real from, Real span) {
  integrate_(dynamics_, from, span, motion_, work_);
  dynamics_.project(motion_);
}

// What a contact did between two states, from the gap g and its rate u at both.
World::Course World::course(std::size_t contact, const Approach& before, const Approach& after) const {
  const bool near = before.gap <= before.gap_rounding;
  const bool approaching = before.speed < -before.speed_rounding;
  const bool leaving = before.speed > before.speed_rounding;
  if (hits_[contact] >= contact_limit) return Course::clear;
  if (dynamics_.contacts[contact].resting) {  // only a blow from elsewhere ends its rest
    return before.speed < -rest_speed_[contact] ? Course::touching : Course::clear;
  }
  if (near && approaching) return Course::touching;
  if (after.gap < -after.gap_rounding) {
    if (leaving && after.speed < 0) return Course::rebounding;
    if (!near) return Course::closing;
    return leaving ? Course::clear : Course::touching;
  }
  return approaching && after.speed > 0 ? Course::passing : Course::clear;
}

// The earliest impact in the part of the step that starts at start_ and ends at motion_; overwrites motion_
// where it has to look inside.
std::optional<World::Hit> World::first_hit(Real from, Real span) {
  const auto& contacts = dynamics_.contacts;
  candidates_.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Approach before = approach(contacts[i], dynamics_.bodies, start_);
    const Approach after = approach(contacts[i], dynamics_.bodies, motion_);
    const Course what = course(i, before, after);
    if (what == Course::touching) return Hit{i, 0};
    if (what != Course::clear) candidates_.push_back({i, what, before, after});
  }

  std::optional<Hit> first;
  for (const Candidate& c : candidates_) {
    const auto gap = [&](Real t) { return approach_after(c.contact, from, t).gap; };
    const auto speed = [&](Real t) { return approach_after(c.contact, from, t).speed; };
    Real low = 0, high = span, g_low = c.before.gap, g_high = c.after.gap;
    if (c.course == Course::rebounding) {  // the gap first grows: start from its largest
      low = root(speed, 0, c.before.speed, span, c.after.speed);
      g_low = gap(low);
      if (g_low <= 0) return Hit{c.contact, 0};
    }
    if (c.course == Course::passing) {  // apart at both ends: the gap's least value decides
      high = root(speed, 0, c.before.speed, span, c.after.speed);
      g_high = gap(high);
      if (g_high >= -c.after.gap_rounding) continue;
    }
    const Real after = root(gap, low, g_low, high, g_high);
    if (!first || after < first->after) first = Hit{c.contact, after};
  }
  if (candidates_.empty() || first) return first;
  motion_ = start_;
  advance(from, span);
  return first;
}

// The approach of a contact at a time inside the part of the step, by the scheme's own step to there.
Approach World::approach_after(std::size_t contact, Real from, Real span) {
  motion_ = start_;
  advance(from, span);
  return approach(dynamics_.contacts[contact], dynamics_.bodies, motion_);
}

// Newton's impact law, or rest where the next bounce would return too soon to be followed.
void World::collide(std::size_t contact, Real now) {
  Contact& c = dynamics_.contacts[contact];
  c.resting = false;
  const Approach before = approach(c, dynamics_.bodies, motion_);
  const bool approaching = before.speed < -before.speed_rounding;
  const Real restitution = ++hits_[contact] < elastic_limit ? c.restitution : 0;
  Real separation = approaching ? -restitution * before.speed : 0;

  const Real pull = -gap_acceleration(contact, now);
  rest_speed_[contact] = zeno_return * step_ * pull / 2;
  c.resting = pull > 0 && separation < rest_speed_[contact];
  if (c.resting) separation = 0;
  if (!c.resting && !approaching) {  // nothing to do: let it be until the next step
    hits_[contact] = contact_limit;
    return;
  }
  strike(c, before, separation, dynamics_.bodies, motion_);
  if (approaching) impacts_.push_back({now, contact, -before.speed, separation});
}

// d^2g/dt^2 of a contact that does not rest [m/s^2].
Real World::gap_acceleration(std::size_t contact, Real now) {
  const Contact& c = dynamics_.contacts[contact];
  std::vector<Rate>& rate = work_.rate[0];
  dynamics_.rates(now, motion_, rate);
  const auto acceleration = [&](int body) -> Vector3 {
    const auto i = static_cast<std::size_t>(body);
    return dynamics_.bodies[i].inverse_mass * rate[i].force;
  };
  const Approach here = approach(c, dynamics_.bodies, motion_);
  Vector3 a = acceleration(c.body);
  if (c.other != fixed_world) a -= acceleration(c.other);
  return here.normal.dot(a) + here.curvature;
}

// Contacts whose surfaces separate, or that nothing presses together any more, rest no longer.
void World::release_contacts() {
  for (std::size_t i = 0; i < dynamics_.contacts.size(); ++i) {
    Contact& c = dynamics_.contacts[i];
    if (!c.resting) continue;
    const bool parting = approach(c, dynamics_.bodies, motion_).speed > rest_speed_[i];
    c.resting = dynamics_.pressed(i) && !parting;
  }
}

}  // namespace cylon::engine
