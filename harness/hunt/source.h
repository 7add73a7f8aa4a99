// Where a hunt's scenes come from: its own families, or scenarios that somebody wrote, with changes.
#pragma once

#include "harness/hunt/generator.h"
#include "harness/scenario/scenario.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cylon::hunt {

/// A scenario to start from.
struct Base {
  std::string name;
  Trial trial;
};

/// Most bodies of a scenario to start from, and most steps that it is run.
inline constexpr std::size_t most_bodies = 50;
inline constexpr std::int64_t most_steps = 100;

/// The scenario without its claims, cut to `most_steps`; or why it is none to start from.
struct Start {
  std::optional<Base> base;
  std::string left_out;
};
Start start_from(const scenario::Scenario&);

/// Scene n of a source is the same on every machine.
class Source {
 public:
  explicit Source(std::uint64_t seed) : seed_(seed) {}
  /// Requires at least one.
  Source(std::uint64_t seed, std::vector<Base> bases) : seed_(seed), bases_(std::move(bases)) {}

  Generated scene(std::uint64_t number) const;
  std::uint64_t seed() const { return seed_; }

  /// "seed 7", or with a hash of what it starts from: what must be equal for its scenes to be.
  std::string name() const;

 private:
  std::uint64_t seed_;
  std::vector<Base> bases_;
};

}  // namespace cylon::hunt
