// The free motion of one body of any inertia, for the solutions that are made of it; free_asymmetric_top.cc.
#pragma once

#include "reference/exact/wide.h"

#include <functional>
#include <string_view>

namespace cylon::exact {

/// Refuses moments that are not positive and motion on the separatrix.
void check_free_rotation(std::string_view solution, const core::Scene&, std::size_t body);

/// State at t [s]; position and velocity those of free fall.
std::function<WideState(Wide t)> free_rotation(const core::Scene&, std::size_t body);

}  // namespace cylon::exact
