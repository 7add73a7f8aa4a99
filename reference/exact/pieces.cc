#include "reference/exact/pieces.h"

#include "reference/exact/domain.h"
#include "reference/exact/nudges.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace cylon::exact {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double step = 1e-10;
constexpr double unlike =
    1e4 * step;  // a velocity that moves by more, as a share of those at play, has jumped

// q' = (w + a t) q/2 over a time h with |w| h <= 1 and |a| h^2 <= 1: with q = sum q_n t^n,
// (n + 1) q_(n+1) = (w q_n + a q_(n-1))/2; the terms fall at least like 2^-n/n!!.
WideQuaternion series(const WideVector& w, const WideVector& a, Wide h, const WideQuaternion& start) {
  const auto times = [](const WideVector& v, const WideQuaternion& q) {
    return WideQuaternion(0, v.x(), v.y(), v.z()) * q;
  };
  WideQuaternion before(0, 0, 0, 0), term = start;
  Eigen::Matrix<Wide, 4, 1> sum = start.coeffs();
  for (int n = 0; n < 60; ++n) {  // term = q_n h^n, before = q_(n-1) h^(n-1)
    WideQuaternion next;
    next.coeffs() =
        (times(w, term).coeffs() * h + times(a, before).coeffs() * (h * h)) / (2 * static_cast<Wide>(n + 1));
    before = term;
    term = next;
    sum += term.coeffs();
    if (term.norm() + before.norm() < 1e-22L) break;
  }
  WideQuaternion end;
  end.coeffs() = sum.normalized();
  return end;
}

WideQuaternion spun_up(const WideVector& w, const WideVector& a, Wide t, WideQuaternion q) {
  if (w.cross(a).isZero(0)) return turn_by(w + a * (t / 2), t) * q;
  const Wide fastest = w.norm() + a.norm() * std::abs(t);
  const Wide length = std::max(fastest, std::sqrt(a.norm())) * std::abs(t);
  const long parts = 1 + static_cast<long>(length);
  const Wide h = t / static_cast<Wide>(parts);
  for (long i = 0; i < parts; ++i) q = series(w + a * (h * static_cast<Wide>(i)), a, h, q);
  return q;
}

struct Difference {
  Wide position = 0, velocity = 0, orientation = 0, angular_velocity = 0, time = 0;

  void raise(const Difference& d) {
    position = std::max(position, d.position);
    velocity = std::max(velocity, d.velocity);
    orientation = std::max(orientation, d.orientation);
    angular_velocity = std::max(angular_velocity, d.angular_velocity);
    time = std::max(time, d.time);
  }
};

Difference between(const WideState& a, const WideState& b) {
  const auto &p = a.orientation.coeffs(), &q = b.orientation.coeffs();
  const Wide chord = std::min((p - q).norm(), (p + q).norm());
  return {.position = (a.position - b.position).norm(),
          .velocity = (a.velocity - b.velocity).norm(),
          .orientation = 4 * std::asin(std::min<Wide>(1, chord / 2)),
          .angular_velocity = (a.angular_velocity - b.angular_velocity).norm()};
}

struct Span {
  Wide from, to;
};

// The piece's part of [0, horizon].
Span span_of(const Track& track, std::size_t k, Wide horizon) {
  const auto& pieces = track.pieces();
  return {pieces[k].start, std::min(horizon, k + 1 < pieces.size() ? pieces[k + 1].start : horizon)};
}

std::size_t started(const Track& track, Wide horizon) {
  return static_cast<std::size_t>(
      std::ranges::count_if(track.pieces(), [&](const Piece& p) { return p.start <= horizon; }));
}

// show(k, t) at times spread over every piece, some 256 in all but three at least in each.
template <class Show>
void over_pieces(const Track& track, Wide horizon, Show show) {
  const std::size_t count = started(track, horizon);
  const int parts = std::max(2, static_cast<int>(256 / count));
  for (std::size_t k = 0; k < count; ++k) {
    const Span span = span_of(track, k, horizon);
    if (span.to <= span.from && k > 0) continue;  // one of several impacts at one instant
    for (int i = 0; i <= parts; ++i) show(k, span.from + (span.to - span.from) * i / parts);
  }
}

// Piece by piece; nothing where the two have not the same pieces.
std::optional<Difference> by_pieces(const Track& a, const Track& b, Wide horizon) {
  const std::size_t count = started(a, horizon);
  if (b.pieces().size() < count || started(b, horizon / beyond) > count) return {};
  Difference most;
  over_pieces(a, horizon, [&](std::size_t k, Wide t) {
    const Piece &p = a.pieces()[k], &q = b.pieces()[k];
    most.raise(between(p.motion(t - p.start), q.motion(t - q.start)));
  });
  Wide slide = 0, swing = 0;  // a jump happens to one of the two before it happens to the other
  for (std::size_t k = 1; k < count; ++k) {
    const Piece &p = a.pieces()[k], &before = a.pieces()[k - 1];
    const Wide shift = std::abs(p.start - b.pieces()[k].start);
    const Difference jump = between(p.motion(0), before.motion(p.start - before.start));
    slide = std::max(slide, jump.velocity * shift);
    swing = std::max(swing, jump.angular_velocity * shift);
  }
  most.position += slide;
  most.orientation += swing;
  return most;
}

// At times that hit no event: shares of the horizon that no tidy scene has.
Difference by_times(const Track& a, const Track& b, Wide horizon) {
  Difference most;
  for (int i = 0; i <= 256; ++i) {
    const Wide t = horizon * (i + 0.381966L) / 257;
    most.raise(between(a.at(t), b.at(t)));
  }
  return most;
}

// By how much the events of `a` move in `b`; those that one of them lacks are no measure of time.
Wide shift_of_events(const Course& a, const Course& b) {
  const auto key = [](const core::Event& e) {
    return std::tuple(e.kind, e.pair.body, e.pair.other, e.pair.plane, e.index);
  };
  std::map<decltype(key(core::Event{})), Wide> times;
  for (const core::Event& e : b.events) times.emplace(key(e), e.time);
  Wide most = 0;
  for (const core::Event& e : a.events) {
    if (const auto found = times.find(key(e)); found != times.end()) {
      most = std::max(most, std::abs(found->second - Wide(e.time)));
    }
  }
  return most;
}

// Largest |X| of a course; an angle has the size 1.
Difference size_of(const Course& course, Wide horizon) {
  Difference most = {.orientation = 1, .time = course.events.empty() ? 0 : horizon};
  for (const Track& track : course.tracks) {
    over_pieces(track, horizon, [&](std::size_t k, Wide t) {
      const WideState s = track.pieces()[k].motion(t - track.pieces()[k].start);
      most.raise({.position = s.position.norm(),
                  .velocity = s.velocity.norm(),
                  .angular_velocity = s.angular_velocity.norm()});
    });
  }
  return most;
}

void add(core::StateError& sum, double factor, const Difference& d) {
  sum.position += factor * static_cast<double>(d.position);
  sum.velocity += factor * static_cast<double>(d.velocity);
  sum.orientation += factor * static_cast<double>(d.orientation);
  sum.angular_velocity += factor * static_cast<double>(d.angular_velocity);
  sum.time += factor * static_cast<double>(d.time);
}

}  // namespace

Motion uniform_motion(const WideState& start, const WideVector& acceleration, const WideVector& spin_up) {
  return [=](Wide s) {
    return WideState{.position = start.position + start.velocity * s + acceleration * (s * s / 2),
                     .velocity = start.velocity + acceleration * s,
                     .angular_velocity = start.angular_velocity + spin_up * s,
                     .orientation = spun_up(start.angular_velocity, spin_up, s, start.orientation)};
  };
}

WideState Track::at(Wide t) const {
  auto next = std::ranges::upper_bound(pieces_, t, {}, &Piece::start);
  if (next != pieces_.begin()) --next;
  return next->motion(t - next->start);
}

core::Truth truth_of(std::string_view solution, const core::Scene& scene, const SolveCourse& solve,
                     double horizon, std::string source) {
  Course course = solve(scene);
  const Difference size = size_of(course, horizon);
  const Wide fast = size.velocity + core::strongest_gravity(scene) * horizon;  // what there is to jump
  core::Truth truth;
  add(truth.error, 8 * eps, size);
  for (const double sign : {1.0, -1.0}) {
    for (const core::Scene& changed : nudged(scene, sign * step)) {
      const Course other = solve(changed);
      Difference most = {.time = shift_of_events(course, other)};
      for (std::size_t i = 0; i < course.tracks.size(); ++i) {
        const auto same = by_pieces(course.tracks[i], other.tracks[i], horizon);
        most.raise(same ? *same : by_times(course.tracks[i], other.tracks[i], horizon));
      }
      if (most.velocity > unlike * fast) {
        refuse(solution,
               "its events are not certain: a change of 1e-10 in one number of the scene changes them");
      }
      add(truth.error, 2 * eps / step, most);
    }
  }
  std::erase_if(course.events, [&](const core::Event& e) { return e.time > horizon; });
  std::ranges::stable_sort(course.events, {}, &core::Event::time);
  truth.events = std::move(course.events);
  truth.state = together(std::move(course.tracks));
  truth.source = std::move(source);
  truth.horizon = horizon;
  return truth;
}

void check_apart(std::string_view solution, const core::Scene& scene, const Course& course, int i, int j,
                 double reach, double horizon) {
  const Track &a = course.tracks[static_cast<std::size_t>(i)],
              &b = course.tracks[static_cast<std::size_t>(j)];
  Wide fastest = 0;
  for (const Track* track : {&a, &b}) {
    Wide most = 0;  // |v| is convex within a piece: largest at its ends
    over_pieces(*track, horizon, [&](std::size_t k, Wide t) {
      most = std::max(most, track->pieces()[k].motion(t - track->pieces()[k].start).velocity.norm());
    });
    fastest += most;
  }
  for (Wide t = 0; t <= horizon;) {  // no nearer than `clear` before t + clear/fastest
    const Wide clear = (a.at(t).position - b.at(t).position).norm() - reach;
    if (!(clear > 1e-3L * reach)) refuse(solution, named(scene, i) + " may touch " + named(scene, j));
    if (fastest == 0) return;
    t += clear / fastest;
  }
}

}  // namespace cylon::exact
