#include "engine/event_stepper.h"

#include "engine/geometry/pose.h"
#include "engine/joint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cylon::engine {

namespace {

// Operations that a run may spend in each step, beside first_operations: so many times what it takes to find the
// forces at one instant.  One is about 0.05 us.
constexpr std::int64_t step_operations = 60;
// Events in one step; half of them are followed as they are.  A ball that keeps 99 % of its speed bounces
// 1400 times before its bounces end (zeno_return).
constexpr int event_limit = 4000;
// The rest of a step whose events are not followed, in so many strides.
constexpr int last_strides = 4;
// Where operations are spent, one in so many steps looks whether all rests by now.
constexpr std::int64_t resumed_steps = 64;
// Pieces in a row that took no time: a slip that ends or begins is followed in some forty (each a third or
// more of what is left); so many mean forces without bound.
constexpr int crawl_limit = 200;
// After so many pieces in a step, and again after each so many more, slips turn four times later, up to 1e-3 of
// what gravity gives in a step.
constexpr int hurried_pieces = 512, hurried_every = 64;
constexpr Real most_haste = 1e5;
// So many events and pieces in a row, while surfaces touch, in which less than this part of a step has passed:
// a stride goes over what changes without end.  The first in parts of a step; each is twice the last.
constexpr int crawl_rounds = 64;
constexpr Time crawl_part = 1e-5, first_stride = 1e-7;
// Where error control fails: the first fixed step, in parts of a step.
constexpr Time least_rest = 1e-9;
// Steps of error control over a part of one that was accepted: one, as a rule.
constexpr int most_parts = 20;

const Integrator& fixed_integrator(const Integrator& integrator) {
  return integrator.kind == Kind::adaptive ? *find_integrator("rk8") : integrator;
}

const Integrator& lasting_integrator(const Integrator& integrator) {
  return integrator.kind == Kind::runge_kutta ? integrator : *find_integrator("rk8");
}

Real largest_reach(const std::vector<Candidate>& candidates) {
  Real reach = 0;
  for (const Candidate& c : candidates) reach = std::max({reach, c.reach, c.other_reach});
  return reach > 0 ? reach : Real(1);
}

std::vector<std::size_t> numbers(const std::vector<Reading>& readings) {
  std::vector<std::size_t> bodies;
  for (const Reading& reading : readings) bodies.push_back(index(reading.body));
  return bodies;
}

std::size_t rows_of(const Model& model) {
  std::ptrdiff_t rows = std::ranges::count_if(model.forces.coordinate_laws,
                                              [](const CoordinateLaw& law) { return law.armature != 0; });
  for (const Joint& joint : model.joints) rows += row_count(joint.type);
  return static_cast<std::size_t>(rows);
}

Real least_speed(const Model& model, Real reach, Time dt) {
  const Real h = static_cast<Real>(dt);
  return std::max(model.strongest_gravity() * h, reach / 100 / h);
}

}  // namespace

ScaledBodies::ScaledBodies(Bodies& bodies, Real reach, Real least_speed)
    : bodies_(bodies), reach_(reach), least_speed_(least_speed), least_length_(reach) {
  const std::vector<Motion>& motions = bodies.model().motions;
  for (std::size_t i = bodies.count(); i < motions.size(); ++i)
    least_length_ = std::max(least_length_, motions[i].position.norm());
}

void ScaledBodies::scales(const Real* y, Real* scale) const {
  const std::vector<Body>& bodies = bodies_.model().bodies;
  const Motion* motion = bodies_.motions(y);
  Real length = least_length_, speed = least_speed_, turn = 0;
  for (std::size_t i = 0; i < bodies_.count(); ++i) {
    length = std::max(length, motion[i].position.norm());
    speed = std::max(speed, velocity(bodies[i], motion[i]).norm());
    if (rotates(bodies[i])) turn = std::max(turn, angular_velocity(bodies[i], motion[i]).norm());
  }
  turn = std::max(turn, speed / reach_);
  const std::size_t extras = bodies_.size() - motion_size * bodies_.count();
  std::fill_n(scale, extras, uncontrolled);  // works and the clock are not controlled
  scale += extras;
  for (std::size_t i = 0; i < bodies_.count(); ++i, scale += motion_size) {
    std::fill(scale, scale + 3, length);
    std::fill(scale + 3, scale + 6, bodies[i].mass * speed);
    std::fill(scale + 6, scale + 10, Real(1));
    const Real inertia = bodies[i].inertia.diagonal().maxCoeff();
    std::fill(scale + 10, scale + 13, inertia > 0 ? inertia * turn : Real(1));
  }
}

EventStepper::EventStepper(const Model& model, const Integrator& integrator, Time dt, Real tolerance,
                           bool account, Time start, std::shared_ptr<std::int64_t> reserve)
    : EventStepper(reduce(model), integrator, dt, tolerance, account, start, std::move(reserve)) {}

EventStepper::EventStepper(Reduced reduced, const Integrator& integrator, Time dt, Real tolerance,
                           bool account, Time start, std::shared_ptr<std::int64_t> reserve)
    : system_(std::move(reduced.model), account),
      readings_(std::move(reduced.readings)),
      candidates_(find_candidates(system_.model(), numbers(readings_))),
      neighbours_(candidates_, system_.model().bodies),
      seams_(system_.model()),
      gravity_(system_.model().strongest_gravity()),
      joint_rows_(rows_of(system_.model())),
      account_(account),
      adaptive_(integrator.kind == Kind::adaptive),
      splits_(integrator.kind == Kind::splitting),
      dt_(dt),
      start_time_(start),
      steps_(static_cast<std::int64_t>(std::floor(start / dt * (1 + 4e-16)))),
      y_(system_.initial(start)),
      start_(y_),
      end_(y_),
      before_(y_),
      rate_(system_.size()),
      fixed_(fixed_integrator(integrator), system_.size()),
      lasting_(lasting_integrator(integrator), system_.size()),
      scaled_(system_, largest_reach(candidates_),
              least_speed(system_.model(), largest_reach(candidates_), dt)),
      controlled_(system_.size(), tolerance),
      probe_(system_.size(), tolerance),
      loose_(candidates_.size(), 0),
      restless_(candidates_.size(), 0),
      pulls_(candidates_.size(), 0),
      stills_(system_.count(), 0),
      allowance_(reserve ? std::move(reserve) : std::make_shared<std::int64_t>(first_operations)) {
  for (const Shape& shape : system_.model().shapes) reaches_.push_back(bounding_radius(shape));
  reaches_.resize(readings_.size(), 0);
  for (std::size_t i = system_.count(); i < readings_.size(); ++i)
    outermost_ = std::max(outermost_, motions()[i].position.norm() + reaches_[i]);
  // Runs before this one have spent theirs.
  if (allowance_.reserve() < first_operations) controlled_.take_rounding();
  system_.start_piece(start);
  kink_ = system_.next_kink(start);
  system_.project(y_.data());
  resolve(start);
  impacts_.clear();
}

void EventStepper::step() {
  Time now = std::max(start_time_, static_cast<Time>(steps_) * dt_);
  const Time end = static_cast<Time>(steps_ + 1) * dt_;
  impacts_.clear(), contacts_.clear();
  struck_ = false;
  ++steps_;
  if (resting_) {
    if (keep_) note_lasting(end, held_forces(end));
    return;
  }
  std::fill(loose_.begin(), loose_.end(), char{0});
  std::fill(restless_.begin(), restless_.end(), char{0});
  plastic_ = false;
  idle_ = rough_ = 0;
  allowance_.add(step_operations * (3 * static_cast<std::int64_t>(system_.count()) + solution(held_.size())));
  rounds_ = 0, marked_ = now, stride_ = first_stride * dt_;
  if (lost_ && (!is_spent() || steps_ % resumed_steps == 0)) {
    lost_ = false;
    resolve(now);
  }
  const std::vector<ContactForce> begun = keep_ ? held_forces(now) : std::vector<ContactForce>{};
  // Ends: every round is an event or a piece, each is bounded work (go_on()), and where the events or the
  // operations that are allowed come to an end the rest of the step is a few strides.
  int events = 0, pieces = 0, crawled = 0, strides = 0;
  while (now < end) {
    const bool spent = !lost_ && !resting_ && is_spent();
    ran_out_ = ran_out_ || spent;
    if (lost_ || events >= event_limit || spent) {
      give_up(now, end);
      break;
    }
    bool event = false;
    const Time after = go_on(now, end - now, event);
    now = std::min(end, now + after);
    if (now < end && (crawls(now) || jumps_)) {
      if (event) resolve(now);
      note_held();
      const Time to = stride_ < end - now ? now + stride_ : end;
      log_.note(DiagnosticKind::crawled, now, {}, static_cast<double>(stride(now, to - now)));
      resolve(to);
      stride_ *= 2;
      marked_ = now = to;
      ++strides;
      continue;
    }
    if (!event) {
      ++pieces;
      if (pieces >= hurried_pieces && pieces % hurried_every == 0) hurry(now);
      idle_ = 0;
      crawled = after < no_time * dt_ ? crawled + 1 : 0;
      if (crawled < crawl_limit || held_.empty()) continue;
      wedge(now);
    }
    crawled = 0;
    ++events;
    idle_ = after > no_time * dt_ ? 0 : idle_ + 1;
    if (events == event_limit / 2) finish_plastically(now);
    if (idle_ >= idle_limit() && loosen(now)) idle_ = 0;
    note_held();
    resolve(now);
  }
  if (pieces < hurried_every / 4) haste_ = std::max<Real>(1, haste_ / 4);
  const bool undisturbed = events == 0 && strides == 0 && now >= end;
  if (keep_) note_lasting(end, undisturbed ? begun : std::vector<ContactForce>{});
  if (std::any_of(held_.begin(), held_.end(), [](const HeldPoint& h) { return h.facets.has_value(); }))
    resolve(end);
}

// The rest of a step whose events are not followed.
void EventStepper::give_up(Time now, Time end) {
  note_held();
  const Time part = (end - now) / last_strides;
  Real worst = 0;
  for (int k = 0; k < last_strides; ++k) {
    worst = std::max(worst, stride(now + k * part, part));
    close_gaps();
  }
  lost_ = true;
  log_.note(DiagnosticKind::not_located, now, {}, static_cast<double>(worst),
            std::to_string(last_strides) + " parts");
}

// Operations of a linear system of three rows a point and those of the joints.
std::int64_t EventStepper::solution(std::size_t points) const {
  return linear_operations(static_cast<std::int64_t>(3 * points + joint_rows_));
}

// Whether the operations that are allowed are spent, those of the reserve too; for the first time they may have been for
// steps that rounding made short.
bool EventStepper::is_spent() {
  if (!allowance_.is_spent(operations())) return false;
  if (!adaptive_ || controlled_.takes_rounding()) return true;
  controlled_.take_rounding();
  allowance_.add(first_operations / 6);
  return false;
}

bool EventStepper::gave_up() const {
  using K = DiagnosticKind;
  return std::ranges::any_of(
      std::array{K::not_located, K::plastic, K::frictionless, K::crawled, K::changes_not_searched},
      [&](K kind) { return log_.has(kind); });
}

std::int64_t EventStepper::operations() const {
  const auto bodies = static_cast<std::int64_t>(system_.count());
  const std::int64_t evaluation = 3 * bodies + 2 * static_cast<std::int64_t>(joint_rows_);
  return work_ + evaluation * (controlled_.evaluations() + probe_.evaluations()) +
         passage_.looks() * (2 + bodies);
}

// Where forces are smooth by pieces, those of the piece that begins.
void EventStepper::pass_kink(Time from) {
  const Time sliver = no_time * dt_;
  if (from + sliver < kink_) return;
  system_.start_piece(from + sliver);
  kink_ = system_.next_kink(from + sliver);
  fresh_ = true;
}

// How far forces are smooth, and no angle that is limited turns by more than a part of a turn.
Time EventStepper::smooth_span(Time from, Time span) {
  pass_kink(from);
  span = std::min(span, kink_ - from);
  const Model& model = system_.model();
  for (const CoordinateLaw& law : model.forces.coordinate_laws) {
    if (!law.is_limited() || !law.at.is_angle()) continue;
    const Real rate = speed_of(row_of(law.at, model.bodies, motions()), model.bodies, motions());
    if (std::abs(rate) * static_cast<Real>(span) > 1) span = static_cast<Time>(1 / std::abs(rate));
  }
  return span;
}

// Goes on from y_ to the first event or to the end of a smooth piece; says how far.
Time EventStepper::go_on(Time from, Time span, bool& event) {
  span = smooth_span(from, span);
  copy(y_, start_);
  turn_slips();
  const bool watches = !held_.empty() && idle_ < idle_limit();
  ContactForces before;
  if (!watches && !held_.empty()) log_.note(DiagnosticKind::changes_not_searched, from);
  if (watches) before = support(from, start_.data());
  jumps_ = event = false;
  Time went = piece(from, span);
  // The rate at the start bounds no turn of what speeds up.
  while (system_.most_turned(start_.data(), y_.data()) > most_turn && went > no_time * dt_) {
    copy(start_, y_);
    fresh_ = true;
    went = piece(from, went / 2);
  }
  if (jumps_) return 0;
  const Real width = static_cast<Real>(went);
  copy(y_, end_);
  passage_.set(system_.model().bodies, system_.count(), system_.motions(start_.data()), motions(), width);
  std::optional<Real> first;
  if (watches) first = change_time(from, width, before);
  if (const auto hit = contact_time(from, first.value_or(width))) {
    first = hit;
    left_slip_ = 0;
  }
  event = first.has_value();
  if (!event) {
    left_slip_ = 0;
    instant_ = false;
    copy(end_, y_);
    system_.set_turns(y_.data());
    return went;
  }
  part(from, *first);
  system_.set_turns(y_.data());
  return std::min(went, static_cast<Time>(*first));
}

// The integrator from y_ to the end of its own step, at most over the span; says how far it came.
Time EventStepper::piece(Time from, Time span) {
  system_.set_holder(held_.empty() ? nullptr : this);
  if (!held_.empty() && at_rest(from) && at_rest(from + span)) return span;
  by_rows_ = !adaptive_;
  if (adaptive_) {
    if (fresh_) controlled_.start(scaled_, from, y_.data(), controlled_.next_step());
    fresh_ = false;
    const Ending ending = controlled_.step(scaled_, from + span);
    if (controlled_.rounded()) log_.note(DiagnosticKind::rounding_exceeds, from);
    std::copy_n(controlled_.state(), system_.size(), y_.begin());
    if (account_) system_.load(controlled_.end(), y_.data());
    if (ending == Ending::done) {
      rough_ = 0;
      return controlled_.end() == from + span ? span : controlled_.end() - from;
    }
    // Forces jump in here: a fixed step gets over it, the longer the more of them come in a row.  Where surfaces touch a
    // stride does: forces of contact are without bound where friction jams.
    log_.note(DiagnosticKind::interval_missed, from);
    copy(start_, y_);
    fresh_ = by_rows_ = true;
    jumps_ = !held_.empty();
    if (jumps_) return 0;
    span = std::min(span, std::ldexp(least_rest * dt_, rough_++));
  }
  fixed_step(from, span);
  return span;
}

void EventStepper::fixed_step(Time from, Time span) {
  work_ += std::int64_t{48} * static_cast<std::int64_t>(system_.count());
  (held_.empty() ? fixed_ : lasting_)(system_, from, span, y_.data());
}

// To s within the piece that began in start_.
void EventStepper::part(Time from, Real s) {
  const Time span = static_cast<Time>(s);
  copy(start_, y_);
  if (!(s > 0)) return;
  if (by_rows_) return fixed_step(from, span);
  probe_.start(scaled_, from, y_.data(), span);
  for (int i = 0; i < most_parts && probe_.end() < from + span; ++i) {
    if (probe_.step(scaled_, from + span) != Ending::done) break;
  }
  if (probe_.end() < from + span) {
    log_.note(DiagnosticKind::interval_missed, from);
    return fixed_step(from, span);
  }
  std::copy_n(probe_.state(), system_.size(), y_.begin());
  if (account_) system_.load(from + span, y_.data());
}

// So slow a slip of surfaces turns that the pieces would not come to an end: it turns later.
void EventStepper::hurry(Time now) {
  const auto turns = [&](const HeldPoint& h) {
    return h.holding.grip == Grip::slides && !is_of_joint(candidates_[h.candidate]);
  };
  if (haste_ >= most_haste || std::ranges::none_of(held_, turns)) return;
  haste_ *= 4, slow_slip_ *= 4;
  log_.note(DiagnosticKind::slip_turned_late, now, {}, static_cast<double>(slow_slip_));
  fresh_ = true;
}

// Whether what touches changes again and again while time hardly goes on.
bool EventStepper::crawls(Time now) {
  if (held_.empty() || ++rounds_ < crawl_rounds) return false;
  const bool slow = now - marked_ < crawl_part * dt_;
  rounds_ = 0, marked_ = now;
  return slow;
}

bool EventStepper::at_rest(Time t) {
  system_.rates(t, y_.data(), rate_.data());
  return std::all_of(rate_.begin(), rate_.end(), [](Real r) { return r == 0; });
}

// At one instant a point can go from sticking to slipping to parting, and nowhere else but in a circle.
int EventStepper::idle_limit() const { return 3 * static_cast<int>(held_.size()) + 3; }

// Of a step that does not come to its end the rest is without bounces and friction.
void EventStepper::finish_plastically(Time now) {
  log_.note(DiagnosticKind::plastic, now, event_limit / 2);
  plastic_ = true;
  std::fill(loose_.begin(), loose_.end(), char{1});
}

void EventStepper::read(std::vector<Motion>& given) const {
  engine::read(system_.model().bodies, readings_, motions(), given);
}

void EventStepper::copy(const std::vector<Real>& from, std::vector<Real>& to) const {
  std::copy_n(from.begin(), system_.size(), to.begin());
}

std::vector<Diagnostic> EventStepper::diagnostics() const {
  std::vector<Diagnostic> all = log_.all();
  for (Diagnostic& d : system_.diagnostics()) all.push_back(std::move(d));
  return all;
}

}  // namespace cylon::engine
