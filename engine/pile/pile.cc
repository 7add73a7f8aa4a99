#include "engine/pile/pile.h"

#include "engine/pile/body_pile.h"
#include "engine/pile/solved_spheres.h"
#include "engine/pile/sphere_pile.h"

namespace cylon::engine {

std::unique_ptr<Stepper> make_pile(const Model& model, Time dt, const PileSettings& settings,
                                   std::int64_t first) {
  if (!pile::only_spheres(model)) return std::make_unique<pile::BodyPile>(model, dt, settings, first);
  if (pile::SolvedSpheres::applies(model, settings))
    return std::make_unique<pile::SolvedSpheres>(model, dt, settings, first);
  return std::make_unique<pile::SpherePile>(model, dt, settings, first);
}

}  // namespace cylon::engine
