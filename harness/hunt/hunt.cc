#include "harness/hunt/hunt.h"

#include "harness/hunt/scene_parts.h"
#include "harness/hunt/shrink.h"
#include "harness/process/session.h"
#include "harness/study/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace cylon::hunt {
namespace {

using process::EngineChoice;

std::optional<Fault> fault_of(const Trial& trial, const EngineChoice& engine, const process::Limits& limits,
                              const Broken& broken) {
  std::vector<Fault> faults = examine(trial, engine, limits, {broken.oracle, broken.kind}).faults;
  if (faults.empty()) return std::nullopt;
  return std::move(faults.front());
}

// Hits that may be of one fault.
struct Group {
  std::string name;  // "energy at every step in spheres"
  Broken broken;
  std::vector<const Hit*> hits;  // fewest bodies first
};

std::vector<Group> groups_of(const Source& source, const std::vector<Hit>& hits) {
  std::map<std::tuple<std::string, Kind, std::string>, Group> groups;
  for (const Hit& hit : hits)
    for (const Broken& broken : hit.broken) {
      Group& group = groups[{broken.oracle, broken.kind, hit.family}];
      group.name = fmt::format("{} {} in {}", broken.oracle, name(broken.kind), hit.family);
      group.broken = broken;
      group.hits.push_back(&hit);
    }
  std::vector<Group> list;
  const auto size = [&](const Hit* hit) { return source.scene(hit->number).trial.scene.bodies.size(); };
  for (auto& [key, group] : groups) {
    std::ranges::stable_sort(group.hits, {}, size);
    list.push_back(std::move(group));
  }
  return list;
}

class Shrinkery {
 public:
  Shrinkery(const Source& source, const Quarry& quarry,
            const std::function<void(const std::string&)>& progress)
      : source_(source),
        quarry_(quarry),
        progress_(progress),
        version_(process::describe(quarry.engine, quarry.limits).version) {}

  // A card for the first hit, and for the first of those that lack a part of its least scene, and so on.
  std::vector<Card> cards_of(Group group) {
    std::vector<Card> cards;
    while (!group.hits.empty()) {
      const Hit& first = *group.hits.front();
      Card card = card_of(first, group);
      const std::set<std::string> needs = parts_without_shapes(card.trial.scene);
      const std::size_t before = group.hits.size();
      std::erase_if(group.hits, [&](const Hit* hit) {
        const std::set<std::string> has = parts_without_shapes(source_.scene(hit->number).trial.scene);
        return hit == &first || std::ranges::includes(has, needs);
      });
      card.hits = before - group.hits.size();
      say(fmt::format("{}: {}", group.name, card.signature));
      cards.push_back(std::move(card));
    }
    return cards;
  }

 private:
  Card card_of(const Hit& hit, const Group& group) {
    Card card;
    card.engine = quarry_.engine.id, card.version = version_;
    card.family = hit.family, card.source = source_.name(), card.number = hit.number;
    card.trial = least_of(hit, group);
    if (auto fault = fault_of(card.trial, quarry_.engine, quarry_.limits, group.broken))
      card.fault = std::move(*fault);
    else  // by the clock, once
      card.fault.oracle = group.broken.oracle, card.fault.detail = "not seen again",
      card.fault.by_time = group.broken.by_time;
    card.signature = signature(card.fault, card.trial.scene);
    return card;
  }

  Trial least_of(const Hit& hit, const Group& group) {
    const std::string key = fmt::format("{} #{}", group.name, hit.number);
    {
      const std::scoped_lock lock(guard_);
      if (quarry_.memory)
        if (auto known = quarry_.memory->least(key)) return std::move(*known);
    }
    int asked = 0;
    const auto has_it = [&](const Trial& trial) {
      if (++asked % 20 == 0)
        say(fmt::format("{}: {} tries, {} bodies", group.name, asked, trial.scene.bodies.size()));
      return fault_of(trial, quarry_.engine, quarry_.limits, group.broken).has_value();
    };
    const Trial whole = source_.scene(hit.number).trial;
    Trial least = [&] {
      const process::KeptWorkers kept;
      return shrink(whole, has_it);
    }();
    if (!has_it(least)) least = shrink(whole, has_it);  // it needs runs before it
    const std::scoped_lock lock(guard_);
    if (quarry_.memory) quarry_.memory->note(key, least);
    return least;
  }

  void say(const std::string& line) {
    const std::scoped_lock lock(guard_);
    if (progress_) progress_(line);
  }

  const Source& source_;
  const Quarry& quarry_;
  const std::function<void(const std::string&)>& progress_;
  std::string version_;
  std::mutex guard_;
};

Opinion opinion_of(const EngineChoice& engine, const Card& card, const process::Limits& limits) {
  const process::RunOutcome first = first_step(card.trial, engine, limits);
  Opinion opinion{engine.id, first.engine.version, first.status == results::Status::unsupported, false};
  if (!opinion.refuses)
    opinion.faulty = fault_of(card.trial, engine, limits, {card.fault.oracle, card.fault.kind}).has_value();
  return opinion;
}

}  // namespace

Found search(const Source& source, std::uint64_t first, const Quarry& quarry,
             const std::function<bool(std::uint64_t)>& more) {
  Found found;
  std::mutex guard;
  std::uint64_t begun = 0;
  // The next scene, and what is known of it.  Numbers are handed out in their order, so that what is done has no gaps.
  const auto next = [&]() -> std::optional<std::pair<std::uint64_t, std::optional<Hit>>> {
    const std::scoped_lock lock(guard);
    if (!more(begun)) return std::nullopt;
    const std::uint64_t number = first + begun++;
    return std::pair{number, quarry.memory ? quarry.memory->asked(number) : std::nullopt};
  };
  const auto ask = [&](Hit& hit, const Trial& trial) {
    const Examined examined = examine(trial, quarry.engine, quarry.limits);
    hit.refused = examined.refused;
    hit.broken.clear();
    for (const Fault& fault : examined.faults)
      hit.broken.push_back({fault.oracle, fault.kind, fault.by_time});
  };
  const auto done = [&](Hit hit, bool fresh, bool after_others = false) {
    const std::scoped_lock lock(guard);
    if (after_others) found.after_others.push_back(hit.number);
    if (fresh && quarry.memory) quarry.memory->note(hit);
    if (hit.refused) ++found.refused;
    if (!hit.broken.empty()) found.hits.push_back(std::move(hit));
  };
  const auto jobs = static_cast<std::size_t>(std::max(1, quarry.jobs));
  study::in_parallel(jobs, quarry.jobs, [&](std::size_t) {
    std::optional<process::KeptWorkers> kept;
    while (auto one = next()) {
      if (one->second) {
        done(std::move(*one->second), false);
        continue;
      }
      const Generated made = source.scene(one->first);
      if (!kept) kept.emplace();
      Hit hit{one->first, made.family, {}};
      ask(hit, made.trial);
      const bool suspected = !hit.broken.empty();
      if (suspected) kept.reset(), ask(hit, made.trial);
      const bool after_others = suspected && hit.broken.empty();
      done(std::move(hit), true, after_others);
    }
  });
  std::ranges::sort(found.hits, {}, &Hit::number);
  std::ranges::sort(found.after_others);
  found.scenes = begun;
  return found;
}

std::vector<Card> cards(const Source& source, const std::vector<Hit>& hits, const Quarry& quarry,
                        const std::vector<EngineChoice>& others,
                        const std::function<void(const std::string&)>& progress) {
  const std::vector<Group> groups = groups_of(source, hits);
  if (groups.empty()) return {};
  Shrinkery shrinkery(source, quarry, progress);
  std::vector<std::vector<Card>> made(groups.size());
  study::in_parallel(groups.size(), quarry.jobs,
                     [&](std::size_t i) { made[i] = shrinkery.cards_of(groups[i]); });
  std::vector<Card> kept;
  for (std::vector<Card>& of_group : made)
    for (Card& card : of_group) {
      const auto same = std::ranges::find(kept, card.signature, &Card::signature);
      if (same == kept.end())
        kept.push_back(std::move(card));
      else
        same->hits += card.hits;
    }
  std::vector<std::vector<Opinion>> opinions(others.size());  // of each engine, by card
  if (!kept.empty())
    study::in_parallel(others.size(), quarry.jobs, [&](std::size_t i) {
      const process::KeptWorkers workers;
      for (const Card& card : kept) opinions[i].push_back(opinion_of(others[i], card, quarry.limits));
    });
  for (const std::vector<Opinion>& of_engine : opinions)
    for (std::size_t k = 0; k < of_engine.size(); ++k) kept[k].opinions.push_back(of_engine[k]);
  return kept;
}

}  // namespace cylon::hunt
