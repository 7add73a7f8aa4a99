#include "harness/validation/split.h"

#include "harness/core/content_hash.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <tuple>

namespace cylon::validation {

std::vector<std::size_t> parts_of(const measured::Experiment& e, std::size_t parts) {
  std::vector<std::tuple<std::uint64_t, std::string, std::size_t>> order;
  for (std::size_t i = 0; i < e.runs.size(); ++i) {
    core::ContentHash hash;
    hash.add(e.runs[i].name);
    order.emplace_back(hash.value(), e.runs[i].name, i);
  }
  std::ranges::sort(order);
  std::vector<std::size_t> part(e.runs.size());
  for (std::size_t i = 0; i < order.size(); ++i) part[std::get<2>(order[i])] = i % parts;
  return part;
}

}  // namespace cylon::validation
