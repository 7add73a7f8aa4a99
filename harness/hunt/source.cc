#include "harness/hunt/source.h"

#include "harness/core/content_hash.h"
#include "harness/hunt/dice.h"
#include "harness/hunt/mutate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::hunt {

Start start_from(const scenario::Scenario& scenario) {
  if (scenario.scene.bodies.size() > most_bodies)
    return {std::nullopt, fmt::format("{} bodies, more than {}", scenario.scene.bodies.size(), most_bodies)};
  const auto steps = static_cast<std::int64_t>(std::floor(scenario.duration / scenario.step + 1e-9));
  if (steps < 1) return {std::nullopt, "shorter than a step"};
  return {Base{scenario.name, {scenario.scene, scenario.step, std::min(steps, most_steps)}}, ""};
}

Generated Source::scene(std::uint64_t number) const {
  if (bases_.empty()) return generate(seed_, number);
  Dice dice(seed_, number);
  const Base& base = dice.of(bases_);
  return {mutated(dice, base.trial), base.name};
}

std::string Source::name() const {
  if (bases_.empty()) return fmt::format("seed {}", seed_);
  core::ContentHash content;
  for (const Base& base : bases_) content.add(base.name + '\n' + to_toml(base.trial, ""));
  return fmt::format("seed {} from {} scenarios {}", seed_, bases_.size(), content.hex());
}

}  // namespace cylon::hunt
