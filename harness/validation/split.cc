#include "harness/validation/split.h"

#include "harness/core/content_hash.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>

namespace cylon::validation {

std::vector<std::size_t> order_of(const measured::Experiment& e) {
  std::vector<std::tuple<std::uint64_t, std::string, std::size_t>> order;
  for (std::size_t i = 0; i < e.runs.size(); ++i) {
    core::ContentHash hash;
    hash.add(e.runs[i].name);
    order.emplace_back(hash.value(), e.runs[i].name, i);
  }
  std::ranges::sort(order);
  std::vector<std::size_t> runs;
  for (const auto& one : order) runs.push_back(std::get<2>(one));
  return runs;
}

std::vector<std::size_t> parts_of(const measured::Experiment& e, std::size_t parts) {
  const std::vector<std::size_t> order = order_of(e);
  std::vector<std::size_t> part(e.runs.size());
  for (std::size_t i = 0; i < order.size(); ++i) part[order[i]] = i % parts;
  return part;
}

measured::Experiment with_run(const measured::Experiment& e, std::size_t run) { return {e, {e.runs[run]}}; }

measured::Experiment with_runs(const measured::Experiment& e, std::size_t count) {
  std::vector<std::size_t> kept = order_of(e);
  kept.resize(std::min(count, kept.size()));
  std::ranges::sort(kept);
  measured::Experiment made{e, {}};
  for (const std::size_t i : kept) made.runs.push_back(e.runs[i]);
  return made;
}

}  // namespace cylon::validation
