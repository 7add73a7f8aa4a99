#include "harness/hunt/hunt.h"

#include "harness/hunt/shrink.h"
#include "harness/study/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace cylon::hunt {
namespace {

using process::EngineChoice;
using process::Limits;

std::optional<Fault> fault_of(const Trial& trial, const EngineChoice& engine, const Limits& limits,
                              const std::string& oracle) {
  std::vector<Fault> faults = examine(trial, engine, limits, oracle);
  if (faults.empty()) return std::nullopt;
  return std::move(faults.front());
}

Card card_of(std::uint64_t seed, const Hit& hit, const std::string& oracle, const EngineChoice& engine,
             const Limits& limits) {
  Card card;
  card.engine = engine.id, card.family = hit.family, card.seed = seed, card.number = hit.number;
  card.trial = shrink(generate(seed, hit.number).trial, [&](const Trial& trial) {
    return fault_of(trial, engine, limits, oracle).has_value();
  });
  if (auto fault = fault_of(card.trial, engine, limits, oracle)) card.fault = std::move(*fault);
  card.signature = signature(card.fault, card.trial.scene);
  card.version = process::describe(engine, limits).version;
  return card;
}

Opinion opinion_of(const EngineChoice& engine, const Card& card, const Limits& limits) {
  Opinion opinion{engine.id, false, false};
  process::RunRequest request;
  request.scene = &card.trial.scene, request.setup.dt = card.trial.step, request.steps = 1;
  if (process::run(engine, request, limits).status == results::Status::unsupported) {
    opinion.refuses = true;
    return opinion;
  }
  opinion.faulty = fault_of(card.trial, engine, limits, card.fault.oracle).has_value();
  return opinion;
}

}  // namespace

std::vector<Hit> search(const Range& range, const EngineChoice& engine, const Limits& limits, int jobs,
                        const std::function<void(const Hit&)>& done) {
  std::vector<Hit> all(range.count);
  std::mutex guard;
  study::in_parallel(range.count, jobs, [&](std::size_t i) {
    Hit hit{range.first + i, "", {}};
    const Generated made = generate(range.seed, hit.number);
    hit.family = made.family;
    for (const Fault& fault : examine(made.trial, engine, limits)) hit.broken.push_back(fault.oracle);
    const std::scoped_lock lock(guard);
    all[i] = std::move(hit);
    if (done) done(all[i]);
  });
  std::erase_if(all, [](const Hit& hit) { return hit.broken.empty(); });
  return all;
}

std::vector<Card> cards(std::uint64_t seed, const std::vector<Hit>& hits, const EngineChoice& engine,
                        const std::vector<EngineChoice>& others, const Limits& limits, int jobs,
                        const std::function<void(const std::string&)>& progress) {
  struct Group {
    const Hit* least = nullptr;
    std::size_t hits = 0;
  };
  std::map<std::pair<std::string, std::string>, Group> groups;  // by oracle and family
  const auto size = [&](const Hit& hit) { return generate(seed, hit.number).trial.scene.bodies.size(); };
  for (const Hit& hit : hits)
    for (const std::string& oracle : hit.broken) {
      Group& group = groups[{oracle, hit.family}];
      ++group.hits;
      if (!group.least || size(hit) < size(*group.least)) group.least = &hit;
    }
  const std::vector<std::pair<std::pair<std::string, std::string>, Group>> list(groups.begin(), groups.end());
  std::vector<Card> made(list.size());
  std::mutex guard;
  study::in_parallel(list.size(), jobs, [&](std::size_t i) {
    const auto& [key, group] = list[i];
    Card card = card_of(seed, *group.least, key.first, engine, limits);
    card.hits = group.hits;
    const std::scoped_lock lock(guard);
    if (progress) progress(fmt::format("{} in {}: {}", key.first, key.second, card.signature));
    made[i] = std::move(card);
  });
  std::vector<Card> kept;
  for (Card& card : made) {
    const auto same = std::ranges::find(kept, card.signature, &Card::signature);
    if (same == kept.end())
      kept.push_back(std::move(card));
    else
      same->hits += card.hits;
  }
  for (Card& card : kept)
    for (const EngineChoice& other : others) card.opinions.push_back(opinion_of(other, card, limits));
  return kept;
}

}  // namespace cylon::hunt
