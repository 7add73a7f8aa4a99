#include "engine/integrators/integrator.h"

#include "engine/integrators/table.h"

namespace cylon::engine {

std::span<const Integrator> integrators() { return integrator_table; }

const Integrator* find_integrator(std::string_view name) {
  for (const Integrator& row : integrator_table) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace cylon::engine
