#include "harness/tracking/statistics/outcome.h"

#include <array>

namespace cylon::statistics {
namespace {

// In the order of the enumeration.
constexpr std::array<std::string_view, 6> names = {"regressed", "improved", "same",
                                                   "changed",   "more",     "inconclusive"};

}  // namespace

std::string_view name(Outcome outcome) { return names.at(static_cast<std::size_t>(outcome)); }

}  // namespace cylon::statistics
