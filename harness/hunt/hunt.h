// Looks for faults of an engine by itself: random scenes, oracles, shrinking, cards.
#pragma once

#include "harness/hunt/card.h"
#include "harness/hunt/generator.h"

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace cylon::hunt {

/// A scene with the oracles that it broke, in their order.
struct Hit {
  std::uint64_t number = 0;
  std::string family;
  std::vector<std::string> broken;
};

struct Range {
  std::uint64_t seed = 1, first = 0, count = 0;
};

/// Asks scenes [first, first + count) of a seed, `jobs` at one time; hits in the order of numbers, the same for any
/// number of jobs.  `done` is called after each scene, one at a time.  Throws what process::run throws.
std::vector<Hit> search(const Range&, const process::EngineChoice&, const process::Limits&, int jobs,
                        const std::function<void(const Hit&)>& done);

/// One card for each fault: of each oracle and family the hit with the fewest bodies is shrunk, and cards with one
/// signature are one.  `others` are asked what they make of the least scene.  `progress` gets a line at a time.
std::vector<Card> cards(std::uint64_t seed, const std::vector<Hit>&, const process::EngineChoice&,
                        const std::vector<process::EngineChoice>& others, const process::Limits&, int jobs,
                        const std::function<void(const std::string&)>& progress);

}  // namespace cylon::hunt
