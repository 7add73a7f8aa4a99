#include "harness/scenario/claim_truths.h"

#include "harness/core/event_find.h"
#include "harness/scenario/budget.h"
#include "harness/scenario/certified_truth.h"
#include "harness/scenario/draft.h"
#include "reference/exact/catalogue.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

namespace cylon::scenario {

using core::Claim;
using core::Observable;

namespace {

using StateAt = std::function<core::State(double)>;

// The same states, each computed once as long as there is room: the claims of a scenario, and the runs that it judges, ask for
// those of the same times again and again.  Runs are judged on several threads.
StateAt remembered(StateAt state) {
  struct Memory {
    std::mutex mutex;
    std::unordered_map<double, core::State> known;
    std::size_t room = std::size_t{1} << 15;  // states of a body: some megabytes
  };
  return [state = std::move(state), memory = std::make_shared<Memory>()](double time) {
    {
      const std::scoped_lock lock(memory->mutex);
      if (const auto found = memory->known.find(time); found != memory->known.end()) return found->second;
    }
    core::State result = state(time);
    const std::scoped_lock lock(memory->mutex);
    if (std::isfinite(time) && result.size() <= memory->room && memory->known.emplace(time, result).second)
      memory->room -= result.size();
    return result;
  };
}

}  // namespace

const core::Truth& ExactTruths::at(const Table& t, const Claim& claim, double horizon) {
  auto& known = truths_[{claim.follows, horizon}];
  if (!known) {
    core::Truth truth = make(t, claim.follows, horizon);
    StateAt anew = truth.state;
    truth.state = remembered(anew);
    known = Solved{std::move(truth), std::move(anew)};
  }
  if (claim.observable.quantity != core::Quantity::event) return known->truth;
  const Observable& q = claim.observable;
  auto& located = events_[{claim.follows, horizon,
                           fmt::format("{} {} {} {}", core::name(q.event), q.to.value_or(-1),
                                       written(q.about), q.body.value_or(-1))}];
  if (!located) located = with_events(t, q, *known, horizon);
  return *located;
}

// Counts the states in which events are searched.
core::Truth ExactTruths::with_events(const Table& t, const Observable& q, const Solved& solved,
                                     double horizon) {
  core::Truth counted = solved.truth;
  counted.state = [&](double time) {
    looks_ += scene_.bodies.size();
    if (looks_ > budget::truth_looks)
      t.fail("follows",
             fmt::format("follows = '{}': to find its events takes too long; end the claim sooner with "
                         "'until', or make fewer claims of events",
                         t.text("follows")));
    return solved.anew(time);
  };
  try {
    core::Truth located = core::with_events(q, scene_, counted, horizon, step_);
    located.state = solved.truth.state;
    return located;
  } catch (const core::OutOfDomain& error) {
    t.fail("follows", fmt::format("follows = '{}': {}", t.text("follows"), error.what()));
  }
}

core::Truth ExactTruths::make(const Table& t, const std::string& name, double horizon) const {
  if (scene_.bodies.size() > budget::bodies_of_truth)
    t.fail("follows", fmt::format("follows = '{}': exact solutions serve scenes of at most {} bodies", name,
                                  budget::bodies_of_truth));
  std::vector<std::string> names;
  for (const exact::Solution& solution : exact::catalogue()) {
    names.emplace_back(solution.name);
    if (solution.name != name) continue;
    try {
      return exact::solve(solution, scene_, horizon);
    } catch (const core::OutOfDomain& error) {
      t.fail("follows", fmt::format("follows = '{}' does not serve this scene: {} (it serves: {})", name,
                                    error.what(), solution.domain));
    }
  }
  names.emplace_back(certified_name);
  t.fail("follows", fmt::format("follows = '{}' is no exact solution{}; valid: {}", name,
                                core::did_you_mean(name, names), fmt::join(names, ", ")));
}

void cut(const Table& t, core::Truth& recorded, double horizon) {
  std::erase_if(recorded.times, [&](double time) { return time > horizon * (1 + 1e-9); });
  if (recorded.times.empty())
    t.fail("follows", fmt::format("follows: the data has no time up to {} s", horizon));
}

namespace {

bool has_event(const core::Truth& truth, const Observable& q) {
  return std::ranges::any_of(truth.events, [&](const core::Event& e) {
    if (e.kind != q.event || (q.body && e.pair.body != *q.body && e.pair.other != *q.body)) return false;
    if (core::of_all(q.event_quantity)) return true;
    return e.index == q.index && core::quantity(truth.events, e, q.event_quantity).has_value();
  });
}

}  // namespace

void require_event(const Table& t, const Claim& claim, double horizon) {
  const core::EventQuantity quantity = claim.observable.event_quantity;
  const bool none_is_right = quantity == core::EventQuantity::count;
  if (claim.truth && core::of_all(quantity) && claim.truth->events_until < horizon)
    t.fail("quantity",
           fmt::format("'{}' tells its events up to {:.6g} s only, and a {} up to {:.6g} s is asked "
                       "for; end the claim sooner with 'until'",
                       claim.follows, claim.truth->events_until, core::name(quantity), horizon));
  if (!claim.truth || claim.observable.quantity != core::Quantity::event || none_is_right ||
      has_event(*claim.truth, claim.observable))
    return;
  t.fail(t.has("index") ? "index" : "event",
         fmt::format("'{}' has no {} {} with a {} up to {} s", claim.follows, t.text("event"),
                     claim.observable.index, core::name(claim.observable.event_quantity), horizon));
}

}  // namespace cylon::scenario
