// Locates the end of a smooth interval of EventStepper: surfaces meet, or a persistent contact changes.
#include "engine/event_stepper.h"
#include "engine/root.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::engine {

namespace {

// A margin has changed its sign when it is this far on the other side, in ulps of its terms; more than the
// rounding with which laws are judged, so that the change is then seen.
constexpr Real change_ulps = 8192;
// Places at which the passage sees surfaces meet and the integrator itself does not.
constexpr int most_grazes = 8;
// Places within a piece at which a coordinate's limit is looked at.
constexpr int limit_looks = 8;
// A margin that stays above this part of its largest value, as a parabola through three looks has it, comes to no zero between
// them...
constexpr Real sure_margin = Real(0.5);
// ... else it is looked at here too, as parts of the piece, and its least value is sought in so many steps: a change that lasts
// less than 0.3 % of the piece (0.618^12), or the second of two within it, may be missed.
constexpr std::array<Real, 4> more_looks = {Real(0.0625), Real(0.25), Real(0.75), Real(0.9375)};
constexpr int most_dip_looks = 12;
// Flights down to 2^-30 of a piece are found where the passage sees only that surfaces meet.  One that is shorter is
// none: its pair meets where the flight would begin, 1e-9 of the piece early.
constexpr int most_halvings = 30;
// Where slip of surfaces ends, what is left of it across its direction counts as none below this many ulps of its
// speed...
constexpr Real left_ulps = 1e4;
// ... and this many times the slip that is turned less than it should be: going on there, in a direction that
// is wrong, would end and begin without end.  Slip that begins there may at first go back by twice that.
constexpr Real left_slow = 2;
// Slip slower than this part of that has just begun.
constexpr Real just_begun = Real(1e-3);

// Whether surfaces that are inside each other approach still.
bool approaches(const Candidate& c, const Model& model, const Motion* motion) {
  std::vector<TouchPoint> touches;
  if (c.kind == Candidate::Kind::general)
    touches_of(c, model, motion, 0, touches);
  else
    touches.push_back(touch_at(c, model, motion));
  return std::any_of(touches.begin(), touches.end(), [&](const TouchPoint& t) {
    return gap_rate(t, model.bodies, motion) < -speed_rounding(t, model.bodies, motion);
  });
}

}  // namespace

bool EventStepper::holds(std::size_t candidate) const {
  return std::any_of(held_.begin(), held_.end(),
                     [&](const HeldPoint& h) { return h.candidate == candidate; });
}

// Whether the one point at which a pair is held is the only one at which it can touch within the piece.
bool EventStepper::only_held_touches(const Candidate& c, const Motion* begin, const Motion* end) {
  const HeldPoint* only = nullptr;
  for (const HeldPoint& held : held_) {
    if (&candidates_[held.candidate] != &c) continue;
    if (only) return false;
    only = &held;
  }
  if (!only || !only->facets) return false;
  const std::size_t a = index(c.body), b = index(c.other);
  const std::vector<Shape>& shapes = system_.model().shapes;
  const Turning bounds{passage_.spin_bound(a), passage_.spin_bound(b), passage_.speed_bound(c)};
  const auto all_of = [&](int parts) {
    const Real width = passage_.span() / static_cast<Real>(parts);
    std::array<Motion, 2> from = {begin[a], begin[b]};
    for (int k = 1; k <= parts; ++k) {
      if (k < parts) passage_.at(static_cast<Real>(k) * width, scratch_);
      const Motion* const to = k < parts ? scratch_.data() : end;
      if (!only_facets_touch(*only->facets, shapes[a], shapes[b], from[0], to[a], from[1], to[b], bounds,
                             width))
        return false;
      from = {to[a], to[b]};
    }
    return true;
  };
  return all_of(1) || all_of(8) || all_of(64);
}

// The first time within the piece at which surfaces meet that are apart.
std::optional<Real> EventStepper::contact_time(Time from, Real span) {
  const Motion *begin = system_.motions(start_.data()), *end = system_.motions(end_.data());
  const auto away = [&](std::size_t body, const Vector3& place) { return passage_.farthest(body, place); };
  std::optional<Real> first;
  for (const std::size_t i : neighbours_.near(begin, widest_margin(begin, 0), away)) {
    const bool held = holds(i);
    if (is_of_joint(candidates_[i])) {
      if (held || candidates_[i].kind == Candidate::Kind::dry) continue;
      if (const auto hit = limit_time(candidates_[i], from, first.value_or(span))) first = hit;
      continue;
    }
    if (held ? candidates_[i].kind != Candidate::Kind::general : passage_.stays_apart(candidates_[i]))
      continue;
    const auto hit = meeting_time(candidates_[i], held, from, first.value_or(span), end);
    if (hit && *hit <= first.value_or(span)) first = hit;
  }
  return first;
}

// The first time within the piece at which a coordinate comes to a limit from which it is apart; a coordinate at
// its limit has left it, by less than the margin of rounding, if it goes away.
std::optional<Real> EventStepper::limit_time(const Candidate& c, Time from, Real span) {
  const Model& model = system_.model();
  const Real least = touch_margin(c, system_.motions(start_.data())) / 4;
  Real level = 0;  // the gap is counted from so deep
  // An angle turns by less than half a turn in a piece: all of it is near both ends.
  const auto gap_after = [&](Real s) {
    part(from, s);
    system_.set_turns(y_.data());
    return gap_of(c, model, motions()) + level;
  };
  const auto rate_after = [&](Real s) {
    part(from, s);
    system_.set_turns(y_.data());
    return gap_rate(touch_at(c, model, motions()), model.bodies, motions());
  };
  const auto seen_after = [&](Real s) {
    system_.set_turns(end_.data());
    if (s >= passage_.span()) return gap_of(c, model, system_.motions(end_.data())) + level;
    passage_.at(s, scratch_);
    return gap_of(c, model, scratch_.data()) + level;
  };
  system_.set_turns(start_.data());
  Real low = 0, g_low = gap_of(c, model, system_.motions(start_.data()));
  if (g_low < least &&
      rate_after(0) < -speed_rounding(touch_at(c, model, motions()), model.bodies, motions())) {
    if (!instant_) return Real(0);
    // Lest what has just been resolved be resolved again: where it is deeper by the margin.
    level = 2 * least - g_low;
    g_low += level;
  }
  Real before = low, g_before = g_low;  // the look before the last
  for (int i = 1; i <= limit_looks; ++i) {
    const Real high = i == limit_looks ? span : span * static_cast<Real>(i) / limit_looks;
    const Real g_high = seen_after(high);
    // Down and up again between three looks: where the rate is zero.
    const bool dips = g_before > g_low && g_low < g_high && g_low > 0 && i > 1;
    Real closed = high, g_closed = g_high;
    if (dips && !(g_high < -least)) {
      const Real u_low = rate_after(before), u_high = rate_after(high);
      if (u_low < 0 && u_high > 0) {
        closed = root(rate_after, before, u_low, high, u_high);
        g_closed = gap_after(closed);
        if (g_closed < -least) low = before, g_low = g_before;
      }
    }
    if (g_closed < -least) {
      Real open = low, g_open = low > 0 ? gap_after(low) : g_low;
      const Real g_exact = gap_after(closed);
      // Who leaves the limit has it behind him, however the gap is rounded: the next time is sought beyond the top.
      const Real u_open = g_open < least ? rate_after(open) : Real(0);
      if (g_exact < 0 && g_open > 0 && !(u_open > 0)) return root(gap_after, open, g_open, closed, g_exact);
      if (g_exact < -least) {  // it leaves the limit and returns within the first look
        const Real u_closed = rate_after(closed);
        if (!(u_open > 0 && u_closed < 0)) return open;
        const Real top = root(rate_after, open, u_open, closed, u_closed), g_top = gap_after(top);
        return g_top > 0 ? root(gap_after, top, g_top, closed, g_exact) : top;
      }
    }
    before = low, g_before = g_low;
    low = high, g_low = g_high;
  }
  return std::nullopt;
}

// Surfaces that are inside each other although they ought not to be (they began so, or a piece was not
// watched) meet where they approach: at once, or, lest what has just been resolved be resolved again, where
// they are as deep again as they began.
std::optional<Real> EventStepper::meeting_time(const Candidate& c, bool held, Time from, Real span,
                                               const Motion* end) {
  const Model& model = system_.model();
  const Motion* begin = system_.motions(start_.data());
  const Real margin = touch_margin(c, begin);
  // Of a pair that is held a corner that comes down shows as depth; so deep counts.
  const Real least = held ? 64 * margin : margin / 4;
  work_ += 2 * static_cast<std::int64_t>(system_.count());
  if (held && only_held_touches(c, begin, end)) return std::nullopt;
  if (passage_.stays_on_face(c, model, held, least, 0, passage_.span())) return std::nullopt;
  const Real began = gap_of(c, model, begin);
  const bool inside = began < -least;
  if (inside && !instant_ && approaches(c, model, begin)) return Real(0);
  const Real level = inside ? -began : held ? least : Real(0);
  const Real depth = inside ? level + margin / 4 : least;
  const Real g_start = began + level, g_end = gap_of(c, model, end) + level;
  const bool ends_inside = g_end < level - depth;
  const bool smooth = c.kind != Candidate::Kind::general;
  if (inside && !smooth && passage_.stays_on_face(c, model, held, depth, 0, passage_.span()))
    return std::nullopt;
  const Real slack = inside || !smooth ? depth - level : Real(0);
  const auto gap_after = [&](Real s) {
    part(from, s);
    return gap_of(c, model, motions()) + level;
  };
  const auto rate_after = [&](Real s) {
    part(from, s);
    const Motion* motion = motions();
    return gap_rate(touch_at(c, model, motion), model.bodies, motion);
  };
  // Where the gap goes through zero upwards, it is rounding, of a flight that has just begun: it ends where
  // it falls again, if that is inside still; a flight too short to be bracketed is found by halving.  Of a
  // general pair, a flight that begins within the least depth begins at zero.
  const Real nothing = smooth || held ? Real(0) : least;
  const auto meeting = [&](Real low, Real g_low, Real high, Real g_high) {
    if (g_low > (low > 0 ? Real(0) : nothing)) {
      const Real hit = root(gap_after, low, g_low, high, g_high);
      if (!smooth || inside) return hit;
      low = hit;
    }
    if (smooth) {
      const Real u_low = rate_after(low), u_high = rate_after(high);
      if (u_low > 0 && u_high < 0) {
        const Real top = root(rate_after, low, u_low, high, u_high),
                   g_top = inside ? gap_after(top) : Real(0);
        return g_top > 0 ? root(gap_after, top, g_top, high, g_high) : top;
      }
      if (!inside) return low;
    } else {
      Real fallen = high, g_fallen = g_high;
      for (int i = 0; i < most_halvings; ++i) {
        const Real middle = low + (fallen - low) / 2, g = gap_after(middle);
        if (g > 0) return root(gap_after, middle, g, fallen, g_fallen);
        fallen = middle, g_fallen = g;
      }
    }
    const auto deeper = [&](Real s) { return gap_after(s) + slack; };
    return g_low + slack > 0 && g_high + slack < 0 ? root(deeper, low, g_low + slack, high, g_high + slack)
                                                   : low;
  };
  const Real rate = smooth ? gap_rate(touch_at(c, model, begin), model.bodies, begin) : Real(0);
  Real low = 0, g_low = g_start;
  Real unseen = 0;
  for (int i = 0; i < most_grazes; ++i) {
    const auto bracket = first_closing(c, model, passage_, low, rate, depth, scratch_, unseen);
    if (!bracket || bracket->open > span) break;
    if (i + 1 == most_grazes) unseen = std::max(unseen, depth);
    const Real g_open = gap_after(bracket->open), g_closed = gap_after(bracket->closed);
    if (g_open > 0) low = bracket->open, g_low = g_open;
    if (g_closed < (g_low > 0 ? Real(0) : -slack)) return meeting(low, g_low, bracket->closed, g_closed);
    low = bracket->closed;
    g_low = g_closed;
  }
  if (unseen > 0) log_.note(DiagnosticKind::meeting_not_searched, from, {}, static_cast<double>(unseen));
  if (!ends_inside || span < passage_.span()) return std::nullopt;
  return meeting(low, g_low, passage_.span(), g_end);
}

// What holds within the piece, as the passage has the motion: near enough to see that a margin comes to zero.
ContactForces EventStepper::support_within(Time from, Real s) {
  passage_.at(s, scratch_);
  passage_.momenta_at(s, system_.model().bodies, scratch_);
  copy(end_, y_);
  std::copy_n(scratch_.begin(), system_.count(), system_.motions(y_.data()));
  system_.set_turns(y_.data());
  return support(from + static_cast<Time>(s), y_.data());
}

namespace {

// The least value of the parabola through three looks at 0, 1/2 and 1.
Real least_of_parabola(Real first, Real middle, Real last) {
  const Real least = std::min({first, middle, last});
  const Real bend = 2 * (first + last - 2 * middle), slope = 4 * middle - 3 * first - last;
  if (!(bend > 0) || !(slope < 0 && -slope < 2 * bend)) return least;
  return std::min(least, first - slope * slope / (4 * bend));
}

struct Look {
  Real at = 0, value = 0;
};

// Where f is below zero between the outer two of three looks, of which the middle one is lowest: the places of golden
// section, which end soon where f is far from zero.
template <class Function>
std::optional<Look> below_zero(Function&& f, Look low, Look middle, Look high) {
  constexpr Real golden = Real(0.381966011250105);
  for (int i = 0; i < most_dip_looks; ++i) {
    const bool right = high.at - middle.at > middle.at - low.at;
    const Real at = middle.at + golden * ((right ? high.at : low.at) - middle.at);
    const Look next = {at, f(at)};
    if (next.value < 0) return next;
    if (next.value < middle.value)
      (right ? low : high) = middle, middle = next;
    else
      (right ? high : low) = next;
    // A fall as steep as on either side would not come to zero.
    const Real fall = std::max(low.value, high.value) - middle.value;
    if (fall < middle.value / 8) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

// How far below zero slip ends that is so fast at the start of a piece.  What is far slower than friction turns as it should has
// just begun, and its rounding says nothing: that friction still holds it is seen where it goes back.
Real EventStepper::end_of_slip(const HeldPoint& held, Real speed) const {
  const bool of_joint = is_of_joint(candidates_[held.candidate]);
  if (speed > (of_joint ? Real(0) : just_begun * slow_slip_)) return 0;
  if (speed > 0) return slow_slip_;
  return of_joint ? 2 * held.slow : std::max(rest_speed_, 2 * left_slow * slow_slip_);
}

// The first time within the piece at which a held point would pull, slip or stop slipping.
std::optional<Real> EventStepper::change_time(Time from, Real span, const ContactForces& before) {
  const ContactForces after = support(from + static_cast<Time>(span), end_.data());
  // Both ends see nothing of what begins and ends within the piece.
  std::vector<std::pair<Real, ContactForces>> inner;
  inner.emplace_back(span / 2, support_within(from, span / 2));
  const auto look_closely = [&] {
    if (inner.size() > 1) return;
    for (const Real part : more_looks) inner.emplace_back(part * span, support_within(from, part * span));
    std::ranges::sort(inner, {}, [](const auto& one) { return one.first; });
  };
  Real force = 0, speed = 0;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    force = std::max({force, before.points[i].force.norm(), after.points[i].force.norm()});
    speed = std::max({speed, std::abs(before.points[i].slip_speed), std::abs(after.points[i].slip_speed)});
  }
  enum class What { presses, reserve, slip };
  std::optional<Real> first;
  left_slip_ = 0;
  const auto look = [&](std::size_t i, What what, Real least) {
    const auto margin = [&, i, what, least](const ContactForces& s) {
      const ContactForce& p = s.points[i];
      return least + (what == What::presses ? p.normal : what == What::reserve ? p.reserve : p.slip_speed);
    };
    const Real m0 = margin(before), m1 = margin(after);
    const auto margin_after = [&](Real s) {
      part(from, s);
      return margin(support(from + static_cast<Time>(s), y_.data()));
    };
    if (!(m0 > 0) && !(m1 < 0)) return;
    Look changed = {span, m1};
    if (m0 > 0) {
      const Real middle = margin(inner[inner.size() / 2].second);
      if (least_of_parabola(m0, middle, m1) > sure_margin * std::max({m0, middle, m1})) return;
      look_closely();
      std::vector<Look> looks = {{0, m0}};
      for (const auto& [at, forces] : inner) looks.push_back({at, margin(forces)});
      looks.push_back(changed);
      const auto seen = [&](Real s) { return margin(support_within(from, s)); };
      const auto below = std::ranges::find_if(looks, [](const Look& one) { return one.value < 0; });
      std::optional<Look> dip;
      for (auto k = looks.begin() + 1; k != below && k + 1 != looks.end() && !dip; ++k)
        if (k->value < (k - 1)->value && k->value <= (k + 1)->value)
          dip = below_zero(seen, *(k - 1), *k, *(k + 1));
      // Below zero for good: the end has the exact margin.
      const auto above = [](const Look& one) { return one.value > 0; };
      if (!dip && below != looks.end() && std::any_of(below, looks.end(), above)) dip = *below;
      if (dip) {
        const Real exact = margin_after(dip->at);
        if (exact < 0) changed = {dip->at, exact};
      }
      if (!(changed.value < 0)) return;
    }
    const Real t = m0 > 0 ? root(margin_after, Real(0), m0, changed.at, changed.value) : Real(0);
    if (t <= static_cast<Real>(no_time * dt_)) restless_[held_[i].candidate] = 1;
    if (first && t >= *first) return;
    first = t;
    left_slip_ = 0, ended_ = held_[i].candidate;
    if (what != What::slip) return;
    const bool turns = !is_of_joint(candidates_[ended_]);
    const Real own = std::max(std::abs(before.points[i].slip_speed), std::abs(after.points[i].slip_speed));
    left_slip_ =
        turns ? std::max(left_ulps * epsilon * speed, left_slow * slow_slip_) : left_ulps * epsilon * own;
  };
  const Real least = change_ulps * epsilon * force;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const bool rough = candidates_[held_[i].candidate].material.friction > 0 && !loose_[held_[i].candidate];
    look(i, What::presses, least);
    if (held_[i].holding.grip == Grip::sticks) look(i, What::reserve, 2 * least);
    if (held_[i].holding.grip == Grip::slides && rough)
      look(i, What::slip, end_of_slip(held_[i], before.points[i].slip_speed));
  }
  // Points that leave their facets: others touch there.
  const Motion *begin = system_.motions(start_.data()), *end = system_.motions(end_.data());
  for (const auto& held : held_) {
    if (!held.facets) continue;
    const Real room = room_of(held, begin), left = room_of(held, end);
    if (!(room > 0 && left < 0)) continue;
    const auto room_after = [&](Real s) {
      part(from, s);
      return room_of(held, motions());
    };
    const Real t = root(room_after, Real(0), room, span, left);
    if (first && t >= *first) continue;
    first = t;
    left_slip_ = 0;
  }
  return first;
}

}  // namespace cylon::engine
