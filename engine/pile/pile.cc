#include "engine/pile/pile.h"

#include "engine/pile/sphere_pile.h"

namespace cylon::engine {

std::unique_ptr<Stepper> make_pile(const Model& model, Time dt, const PileSettings& settings) {
  return std::make_unique<pile::SpherePile>(model, dt, settings);
}

}  // namespace cylon::engine
