#include "engine/integrators/scheme.h"

#include "engine/integrators/table.h"

namespace cylon::engine {

std::span<const Scheme> schemes() { return scheme_table; }

const Scheme* find_scheme(std::string_view name) {
  for (const Scheme& row : scheme_table) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace cylon::engine
