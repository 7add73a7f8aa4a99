#include "harness/core/event_watch.h"

#include "harness/core/observable.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cylon::core {
namespace {

// The root of g + u s + a s^2/2 nearest to s = 0, in the form that does not cancel:
// s = -2 g / (u + sign(u) sqrt(u^2 - 2 a g)); without a root, the vertex s = -u/a.
double nearest_root(double g, double u, double a) {
  const double discriminant = u * u - 2 * a * g;
  if (discriminant < 0) return -u / a;
  const double denominator = u + std::copysign(std::sqrt(discriminant), u);
  return denominator == 0 ? 0 : -2 * g / denominator;
}

// A separation this much slower than the fastest approach is rest, not a bounce.
constexpr double rest = 1e-6;

// Farther apart than it would go in so many steps, a pair does not touch: something else turned one of them.
constexpr double reach = 10;

}  // namespace

EventWatch::EventWatch(const Scene& scene, std::vector<Pair> pairs, double dt) : scene_(scene), dt_(dt) {
  tracks_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) tracks_[i].pair = pairs[i];
}

void EventWatch::observe(std::int64_t step, const State& state) {
  for (Track& track : tracks_) {
    std::move(std::begin(track.last) + 1, std::end(track.last), std::begin(track.last));
    track.last[3] = {gap(scene_, track.pair, state), gap_rate(scene_, track.pair, state)};
    track.fastest = std::max(track.fastest, std::abs(track.last[3].rate));
    track.rising = track.rising || (track.bounces == 0 && track.last[3].rate > rest * track.fastest);
    track.kept = std::min(track.kept + 1, 4);
    detect(track, step);
  }
}

// Looks at the pair of samples one step back, so that the outgoing arc has two states as well:
// last[0], last[1] before, last[2], last[3] after.
void EventWatch::detect(Track& track, std::int64_t step) {
  if (track.kept < 4) return;
  const auto& [s0, s1, s2, s3] = track.last;
  const double jump = s2.rate - s1.rate;
  const double t1 = static_cast<double>(step - 2) * dt_, t2 = t1 + dt_;

  if (s1.rate < 0 && s2.rate > 0) {
    // Free flight would change the rate by a dt; an impact changes it by more than twice that.
    const bool fresh = track.since_bounce >= 2;  // s0 and s1 lie on one arc
    const double before = fresh ? (s1.rate - s0.rate) / dt_ : 0;
    const bool touching = s1.gap <= reach * dt_ * -s1.rate;
    const bool impact = touching && jump - before * dt_ > 0.5 * jump && s2.rate > rest * track.fastest;
    if (impact) {
      const bool hit_again = s3.rate - s2.rate > 0.5 * jump;
      const double after = hit_again ? before : (s3.rate - s2.rate) / dt_;
      const double in = t1 + nearest_root(s1.gap, s1.rate, before);
      const double root = nearest_root(s2.gap, s2.rate, after);
      found_.push_back({.kind = EventKind::bounce,
                        .pair = track.pair,
                        .index = ++track.bounces,
                        .time = 0.5 * (in + t2 + root),
                        .speed = s2.rate + after * root});
      track.since_bounce = 0;
      track.rising = true;
    }
  } else if (s1.rate > 0 && s2.rate <= 0 && track.rising) {
    // Vertex of the arc through both states.
    const double a = jump / dt_, s = -s1.rate / a;
    found_.push_back({.kind = EventKind::apex,
                      .pair = track.pair,
                      .index = track.bounces,
                      .time = t1 + s,
                      .height = s1.gap + 0.5 * s1.rate * s});
    track.rising = false;
  }
  ++track.since_bounce;
}

std::vector<Event> EventWatch::take() {
  std::stable_sort(found_.begin(), found_.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
  return std::exchange(found_, {});
}

}  // namespace cylon::core
