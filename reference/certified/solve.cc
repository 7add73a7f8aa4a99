#include "reference/certified/solve.h"

#include "reference/certified/impacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::certified {
namespace {

template <std::size_t N>
std::array<Ball, N> read(const std::array<int, N>& nodes, const std::function<Ball(int)>& value) {
  std::array<Ball, N> values;
  std::ranges::transform(nodes, values.begin(), value);
  return values;
}

Sampled sample(const Model& model, double t, const std::function<Ball(int)>& value) {
  Sampled result;
  result.time = t;
  for (const BodyNodes& body : model.bodies)
    result.bodies.push_back({read(body.position, value), read(body.velocity, value),
                             read(body.orientation, value), read(body.angular_velocity, value)});
  return result;
}

// Smooth arcs one after another; each has its own time, since the blow that begins it is known within a
// radius.
class Journey {
 public:
  Journey(const core::Scene& scene, std::span<const double> times, const Effort& effort,
          const Numbers& numbers, const Watch& watch)
      : times_(times),
        watch_(watch),
        effort_(effort),
        // A body alone that nothing moves has no state; a positive horizon keeps even that a solution.
        horizon_(times.back() > 0 ? times.back() : 1e-3),
        model_(make_model(scene, horizon_, effort.bits, numbers, Blows::described)) {
    result_.bits = effort.bits;
  }

  Certificate run() {
    // A little beyond the end, so that a blow at the end is isolated too.
    double arc = model_.contacts.empty() ? horizon_ : beyond * horizon_;
    do {
      next_.clear();
      fresh_ = true;
      follow(model_, arc, effort_, [&](const Step& step) { return show(step); });
      if (next_.empty()) break;
      model_.initial = next_;
      effort_.offset = begin_.middle();
      arc = beyond * (horizon_ - lower(begin_)) + 1e-9;
    } while (!done());
    for (const Sampled& s : result_.samples)
      for (const BodyBalls& body : s.bodies) result_.radius = std::max(result_.radius, body.radius());
    return std::move(result_);
  }

 private:
  static constexpr double beyond = 1.001;

  bool done() const { return result_.samples.size() == times_.size(); }

  // From the start of the step to time t.
  Ball since(const Step& step, double t) const {
    Ball result(t);
    const Ball start(step.start);
    arb_sub(result.get(), result.get(), begin_.get(), effort_.bits);
    arb_sub(result.get(), result.get(), start.get(), effort_.bits);
    return result;
  }

  bool show(const Step& step) {
    ++result_.steps;
    if (fresh_) check_start(step);
    fresh_ = false;
    const auto impact = first_impact(model_, step, beyond * upper(since(step, times_.back())));
    const Ball end = impact ? impact->time : Ball(step.length);
    while (!done()) {
      const double t = times_[result_.samples.size()];
      const Ball past = since(step, t);
      if (arb_gt(past.get(), end.get())) break;
      const bool before = impact ? arb_lt(past.get(), end.get()) : arb_le(past.get(), end.get());
      if (!before)
        throw Stuck(t, fmt::format("whether {} s is before or after {} cannot be told", t,
                                   impact ? "a blow" : "the end of a step"));
      add_sample(step, t, past);
    }
    watch_({begin_.middle() + step.start + end.middle(), result_.steps, effort_.bits});
    if (impact && !done()) strike(step, *impact);
    return !impact && !done();
  }

  void add_sample(const Step& step, double t, const Ball& past) {
    if (result_.impacts.empty()) {
      result_.samples.push_back(sample(model_, t, [&](int node) { return step.at(node, t); }));
      for (const int state : model_.graph.states())
        result_.samples.back().conditioning =
            std::max(result_.samples.back().conditioning, step.sensitivity(state, t).lpNorm<1>());
    } else {
      result_.samples.push_back(sample(model_, t, [&](int node) { return step.within(node, past); }));
      result_.samples.back().conditioning = std::numeric_limits<double>::quiet_NaN();
    }
  }

  // All apart at first; after a blow its pair opens.
  void check_start(const Step& step) const {
    const Ball now;
    if (result_.impacts.empty()) {
      for (const Contact& c : model_.contacts)
        if (!arb_is_positive(step.within(c.gap, now).get()))
          throw core::OutOfDomain(fmt::format("certified: {} touch at the start", c.names));
    } else if (const Contact& c = model_.contacts[last_]; !arb_is_positive(step.within(c.rate, now).get())) {
      throw Stuck(0, fmt::format("{} do not part, or too slowly for the radius, after their blow at {:.6g} s",
                                 c.names, begin_.middle()));
    }
  }

  void strike(const Step& step, const Impact& impact) {
    constexpr std::size_t most = 10'000;
    next_ = state_after(model_, step, impact);
    const Ball start(step.start);
    arb_add(begin_.get(), begin_.get(), start.get(), effort_.bits);
    arb_add(begin_.get(), begin_.get(), impact.time.get(), effort_.bits);
    last_ = impact.contact;
    result_.impacts.push_back({begin_, model_.contacts[last_].pair});
    if (result_.impacts.size() > most)
      throw core::OutOfDomain(
          fmt::format("certified: more than {} blows up to {:.6g} s", most, begin_.middle()));
  }

  std::span<const double> times_;
  const Watch& watch_;
  Effort effort_;
  double horizon_;
  Model model_;
  Certificate result_;
  Ball begin_;              // When the arc began.
  std::vector<Ball> next_;  // The state after the blow that ended it.
  std::size_t last_ = 0;    // The pair of the last blow.
  bool fresh_ = true;
};

}  // namespace

double BodyBalls::radius() const {
  double largest = 0;
  const auto add = [&](const auto& balls) {
    for (const Ball& x : balls) largest = x.finite() ? std::max(largest, x.radius()) : HUGE_VAL;
  };
  add(position), add(velocity), add(orientation), add(angular_velocity);
  return largest;
}

// Six digits of room for what the motion amplifies.
Attempts::Attempts(const Goal& goal) : goal_(goal), best_(std::numeric_limits<double>::infinity()) {
  constexpr int guard_bits = 64;
  aim(std::max(goal.radius * 1e-6, std::ldexp(1.0, guard_bits - static_cast<int>(goal.most_bits))));
}

void Attempts::aim(double step_error) {
  constexpr slong guard = 36, word = 64;
  effort_.step_error = step_error;
  const slong wanted = static_cast<slong>(std::ceil(-std::log2(step_error))) + guard;
  effort_.bits = std::max<slong>(128, (wanted + word - 1) / word * word);
}

bool Attempts::next(double radius) {
  if (radius <= goal_.radius) return false;
  if (std::isfinite(radius) && radius > 0.5 * best_)
    return false;  // the numbers of the scene set this radius
  best_ = std::min(best_, radius);
  aim(std::isfinite(radius) ? effort_.step_error * std::max(1e-60, goal_.radius / radius) * 1e-3
                            : effort_.step_error * effort_.step_error);
  return effort_.step_error > 1e-280 && effort_.bits <= goal_.most_bits;
}

Certificate certify(const core::Scene& scene, std::span<const double> times, const Goal& goal,
                    const Numbers& numbers, const Watch& watch) {
  Attempts attempts(goal);
  Certificate best;
  best.radius = std::numeric_limits<double>::infinity();
  std::string stuck;
  double radius = 0;
  do {
    radius = std::numeric_limits<double>::infinity();
    try {
      Certificate found = Journey(scene, times, attempts.effort(), numbers, watch).run();
      radius = found.radius;
      if (radius < best.radius) best = std::move(found);
    } catch (const Stuck& error) {
      stuck = error.what();
    }
  } while (attempts.next(radius));
  if (!std::isfinite(best.radius)) throw core::OutOfDomain("certified: " + stuck);
  best.reached = best.radius <= goal.radius;
  if (!best.reached)
    best.reason =
        fmt::format("radius {:.2g} at {} bits; {:.2g} was asked for", best.radius, best.bits, goal.radius);
  return best;
}

}  // namespace cylon::certified
