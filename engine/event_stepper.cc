#include "engine/event_stepper.h"

#include "engine/joint.h"
#include "engine/root.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

constexpr Real ulp = std::numeric_limits<Real>::epsilon();
constexpr bool wide = sizeof(Real) == 8;

// Points nearer than this many ulps of the lengths around them touch, and at one instant: 3e-12 m at 3 m in
// double, which at 1 m/s is 3e-12 s.
constexpr Real touch_ulps = wide ? 4096 : 64;
// A margin has changed its sign when it is this far on the other side, in ulps of its terms; more than the
// rounding with which laws are judged, so that the change is then seen.
constexpr Real change_ulps = 8192;
// Events in one step, and such in a row as take no time; beyond, the rest of the step is one smooth piece.
constexpr int event_limit = 4000, idle_limit = 12;
// Changes of contact in one step without an impact; beyond, they are taken to have no end.
constexpr int change_limit = 48;

const Scheme& fixed_scheme(const Scheme& scheme) {
  return scheme.kind == Kind::adaptive ? *find_scheme("rk8") : scheme;
}

const Scheme& lasting_scheme(const Scheme& scheme) {
  return scheme.kind == Kind::runge_kutta ? scheme : *find_scheme("rk8");
}

Real largest_reach(const std::vector<Candidate>& candidates) {
  Real reach = 0;
  for (const Candidate& c : candidates) reach = std::max({reach, c.reach, c.other_reach});
  return reach > 0 ? reach : Real(1);
}

Real least_speed(const Model& model, Real reach, Time dt) {
  const Real h = static_cast<Real>(dt);
  return std::max(model.forces.gravity.norm() * h, reach / 100 / h);
}

}  // namespace

void ScaledBodies::scales(const Real* y, Real* scale) const {
  const std::vector<Body>& bodies = bodies_.model().bodies;
  const Motion* motion = Bodies::motions(y);
  Real length = reach_, speed = least_speed_, turn = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    length = std::max(length, motion[i].position.norm());
    speed = std::max(speed, velocity(bodies[i], motion[i]).norm());
    if (rotates(bodies[i])) turn = std::max(turn, angular_velocity(bodies[i], motion[i]).norm());
  }
  turn = std::max(turn, speed / reach_);
  std::fill(scale, scale + bodies_.size(), Real(1e30));  // works and the clock are not controlled
  for (std::size_t i = 0; i < bodies.size(); ++i, scale += motion_size) {
    std::fill(scale, scale + 3, length);
    std::fill(scale + 3, scale + 6, bodies[i].mass * speed);
    std::fill(scale + 6, scale + 10, Real(1));
    const Real inertia = bodies[i].inertia.diagonal().maxCoeff();
    std::fill(scale + 10, scale + 13, inertia > 0 ? inertia * turn : Real(1));
  }
}

EventStepper::EventStepper(const Model& model, const Scheme& scheme, Time dt, Real tolerance, bool account,
                           Time start)
    : EventStepper(reduce(model), scheme, dt, tolerance, account, start) {}

EventStepper::EventStepper(Reduced reduced, const Scheme& scheme, Time dt, Real tolerance, bool account,
                           Time start)
    : system_(std::move(reduced.model), account),
      readings_(std::move(reduced.readings)),
      candidates_(find_candidates(system_.model())),
      account_(account),
      adaptive_(scheme.kind == Kind::adaptive),
      splits_(scheme.kind == Kind::splitting),
      dt_(dt),
      start_time_(start),
      steps_(static_cast<std::int64_t>(std::floor(start / dt * (1 + 4e-16)))),
      y_(system_.initial()),
      start_(y_),
      rate_(y_.size()),
      fixed_(fixed_scheme(scheme), y_.size()),
      lasting_(lasting_scheme(scheme), y_.size()),
      scaled_(system_, largest_reach(candidates_),
              least_speed(system_.model(), largest_reach(candidates_), dt)),
      controlled_(y_.size(), tolerance),
      hits_(candidates_.size() + 1, 0),
      loose_(candidates_.size(), 0),
      restless_(candidates_.size(), 0) {
  system_.settle(y_.data());
  resolve(start);
  impacts_.clear();
}

void EventStepper::step() {
  Time now = std::max(start_time_, static_cast<Time>(steps_) * dt_);
  const Time end = static_cast<Time>(steps_ + 1) * dt_;
  impacts_.clear();
  if (resting_) {
    ++steps_;
    return;
  }
  std::fill(hits_.begin(), hits_.end(), 0);
  std::fill(loose_.begin(), loose_.end(), char{0});
  std::fill(restless_.begin(), restless_.end(), char{0});
  idle_ = 0;
  int changes = 0;
  for (int events = 0; now < end; ++events) {
    if (events == event_limit) ++crowded_;
    bool event = false;
    if (events >= event_limit || changes >= 4 * change_limit) idle_ = idle_limit;
    const Time after = go_on(now, end - now, event);
    if (!event) break;
    idle_ = after > 1e-9 * dt_ ? 0 : idle_ + 1;
    now = std::min(end, now + after);
    if (idle_ >= idle_limit && loosen()) idle_ = 0;
    const std::size_t struck = impacts_.size();
    resolve(now);
    changes += impacts_.size() == struck;
    if (changes >= change_limit && changes % change_limit == 0 && loosen()) resolve(now);
  }
  ++steps_;
  if (std::any_of(held_.begin(), held_.end(), [](const HeldPoint& h) { return h.general; })) resolve(end);
}

// Goes on from y_ to the first event or over the span; says how far.
Time EventStepper::go_on(Time from, Time span, bool& event) {
  start_ = y_;
  const bool watches = !held_.empty();
  Support before;
  if (watches) before = support(from, start_.data());
  if (!flow(from, span)) {
    if (span > 1e-6 * dt_) {  // something runs away in the trial: nearer, it may yet be seen to end
      y_ = start_;
      const Time after = go_on(from, span / 2, event);
      event = true;  // the rest of the span is still to come
      return after;
    }
    ++failed_;
  }
  const Real width = static_cast<Real>(span);
  passage_.set(system_.model().bodies, Bodies::motions(start_.data()), Bodies::motions(y_.data()), width);
  std::optional<Real> first;
  bool looked = false;
  if (watches && idle_ < idle_limit) {
    first = change_time(from, width, before);
    looked = first.has_value();
  }
  const Real slip = left_slip_;
  if (const auto hit = contact_time(from, first.value_or(width))) {
    first = hit;
    looked = true;
    left_slip_ = 0;
  } else {
    left_slip_ = first ? slip : 0;
  }
  event = first.has_value();
  if (!event) {
    if (looked) {
      y_ = start_;
      flow(from, span);
    }
    return span;
  }
  y_ = start_;
  const Time after = std::min(span, static_cast<Time>(*first));
  if (after > 0) flow(from, after);
  return after;
}

// The scheme over a span, from y_; whether it came to the end.
bool EventStepper::flow(Time from, Time span) {
  if (held_.empty()) {
    system_.set_holder(nullptr);
  } else {
    system_.set_holder(this);
    if (at_rest(from) && at_rest(from + span)) return true;
  }
  if (adaptive_) {
    const bool done = controlled_.advance(scaled_, from, from + span, y_.data()) == Ending::done;
    if (account_) system_.load(from + span, y_.data());
    return done;
  } else {
    (held_.empty() ? fixed_ : lasting_)(system_, from, span, y_.data());
  }
  return true;
}

bool EventStepper::at_rest(Time t) {
  system_.rates(t, y_.data(), rate_.data());
  return std::all_of(rate_.begin(), rate_.end(), [](Real r) { return r == 0; });
}

Real EventStepper::touch_margin(const Candidate& c, const Motion* motion) const {
  return touch_ulps * ulp * gap_scale(c, system_.model(), motion);
}

bool EventStepper::holds(std::size_t candidate) const {
  return std::any_of(held_.begin(), held_.end(),
                     [&](const HeldPoint& h) { return h.candidate == candidate; });
}

// The first time within the span at which surfaces meet that are apart.
std::optional<Real> EventStepper::contact_time(Time from, Real span) {
  const Model& model = system_.model();
  std::optional<Real> first;
  std::vector<Real> end_state = y_;
  const Motion* begin = Bodies::motions(start_.data());
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const Candidate& c = candidates_[i];
    const bool held = holds(i), general = c.kind == Candidate::Kind::general;
    if (held && !general) continue;
    const Real margin = touch_margin(c, begin);
    // Of a pair that is held a corner that comes down shows as depth; so deep counts.
    const Real depth = held ? 64 * margin : margin / 4;
    const Real rate = general ? Real(0) : gap_rate(touch_at(c, model, begin), model.bodies, begin);
    const auto bracket = first_closing(c, model, passage_, rate, depth, scratch_);
    if (!bracket || bracket->open > first.value_or(span)) continue;
    const auto gap_after = [&](Real s) {
      y_ = start_;
      if (s > 0) flow(from, static_cast<Time>(s));
      return gap_of(c, model, Bodies::motions(y_.data())) + (held ? depth : Real(0));
    };
    const Real high = std::min(bracket->closed, passage_.span());
    const Real g_low = gap_after(bracket->open), g_high = gap_after(high);
    if (!(g_high < 0)) continue;  // grazes
    const Real hit = g_low > 0 ? root(gap_after, bracket->open, g_low, high, g_high) : bracket->open;
    if (hit <= first.value_or(span)) first = hit;
  }
  y_ = std::move(end_state);
  return first;
}

// The first time within the span at which a held point would pull, slip or stop slipping.
std::optional<Real> EventStepper::change_time(Time from, Real span, const Support& before) {
  std::vector<Real> end_state = y_;
  const Support after = support(from + static_cast<Time>(span), y_.data());
  Real force = 0, speed = 0;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    force = std::max({force, before.points[i].force.norm(), after.points[i].force.norm()});
    speed = std::max({speed, std::abs(before.points[i].slip_speed), std::abs(after.points[i].slip_speed)});
  }
  enum class What { presses, reserve, slip };
  std::optional<Real> first;
  left_slip_ = 0;
  const auto look = [&](std::size_t i, What what, Real least) {
    const auto margin = [&, i, what, least](const Support& s) {
      const SupportPoint& p = s.points[i];
      return least + (what == What::presses ? p.normal : what == What::reserve ? p.reserve : p.slip_speed);
    };
    const Real m0 = margin(before), m1 = margin(after);
    if (!(m1 < 0)) return;
    const auto margin_after = [&](Real s) {
      y_ = start_;
      if (s > 0) flow(from, static_cast<Time>(s));
      return margin(support(from + static_cast<Time>(s), y_.data()));
    };
    const Real t = m0 > 0 ? root(margin_after, Real(0), m0, span, m1) : Real(0);
    if (t <= static_cast<Real>(1e-9 * dt_)) restless_[held_[i].candidate] = 1;
    if (first && t >= *first) return;
    first = t;
    left_slip_ = what == What::slip ? Real(1e4) * ulp * speed : Real(0);
  };
  const Real least = change_ulps * ulp * force;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const bool rough = candidates_[held_[i].candidate].material.friction > 0 && !loose_[held_[i].candidate];
    look(i, What::presses, least);
    if (held_[i].holding.grip == Grip::sticks) look(i, What::reserve, 2 * least);
    if (held_[i].holding.grip == Grip::slides && rough)
      look(i, What::slip, before.points[i].slip_speed > 0 ? 0 : rest_speed_);
  }
  y_ = std::move(end_state);
  return first;
}

void EventStepper::read(std::vector<Motion>& motions) const {
  motions.resize(readings_.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    motions[i] = engine::read(system_.model().bodies[i], readings_[i], Bodies::motions(y_.data())[i]);
  }
}

std::vector<std::string> EventStepper::remarks() const {
  std::vector<std::string> result;
  if (inexact_ > 0) {
    result.push_back(std::to_string(inexact_) +
                     " contact problems were solved by iteration, not to rounding");
  }
  if (failed_ > 0) result.push_back(std::to_string(failed_) + " pieces of motion did not keep the tolerance");
  if (loosened_ > 0) {
    result.push_back("at " + std::to_string(loosened_) +
                     " instants no force obeyed Coulomb's law, or stick and slip took turns without end: "
                     "those contacts were without friction for the rest of the step");
  }
  if (crowded_ > 0) {
    result.push_back(std::to_string(crowded_) + " steps had more than " + std::to_string(event_limit) +
                     " events");
  }
  return result;
}

}  // namespace cylon::engine
