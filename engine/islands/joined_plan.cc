#include "engine/islands/joined_plan.h"

#include <algorithm>
#include <limits>

namespace cylon::engine::islands {

namespace {

constexpr std::size_t most_listed = 8;  // islands, and reasons of one stage

// A closed form has no order: its error is rounding.
int order_of(const Plan& plan) { return plan.order > 0 ? plan.order : std::numeric_limits<int>::max(); }

std::string listed(const std::vector<std::string>& all, const char* separator) {
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), most_listed); ++i)
    text += (i > 0 ? separator : "") + all[i];
  if (all.size() > most_listed) text += separator + std::to_string(all.size() - most_listed) + " more";
  return text;
}

}  // namespace

Plan joined_plan(const std::vector<NamedPlan>& islands) {
  const auto least = std::min_element(islands.begin(), islands.end(), [](const auto& a, const auto& b) {
    return order_of(*a.plan) < order_of(*b.plan);
  });
  Plan joined = *least->plan;
  for (std::size_t k = 0; k < joined.stages.size() && islands.size() > 1; ++k) {
    Stage& stage = joined.stages[k];
    stage.in =
        std::any_of(islands.begin(), islands.end(), [&](const auto& i) { return i.plan->stages[k].in; });
    std::vector<std::string> reasons;
    for (const NamedPlan& island : islands) {
      const Stage& own = island.plan->stages[k];
      if (own.in == stage.in && std::find(reasons.begin(), reasons.end(), own.reason) == reasons.end())
        reasons.push_back(own.reason);
    }
    stage.reason = listed(reasons, "; ");
  }
  std::vector<std::string> parts;
  for (const NamedPlan& island : islands) parts.push_back(island.bodies + ": " + name_of(island.plan->path));
  joined.stages.push_back({"islands", islands.size() > 1,
                           islands.size() > 1 ? std::to_string(islands.size()) +
                                                    " parts move by themselves: " + listed(parts, "; ")
                                              : "all that moves is one part"});
  return joined;
}

}  // namespace cylon::engine::islands
