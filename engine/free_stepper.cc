#include "engine/free_stepper.h"

namespace cylon::engine {

FreeStepper::FreeStepper(const Model& model, Time dt)
    : bodies_(model.bodies), start_(model.motions), dt_(dt) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    gravity_.push_back(model.gravity_of(i));
    rotations_.emplace_back(bodies_[i], start_[i].orientation, start_[i].angular_momentum);
  }
}

void FreeStepper::read(std::vector<Motion>& motions) const {
  motions = start_;
  const Time time = static_cast<Time>(steps_) * dt_;
  const Real t = static_cast<Real>(time);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Body& body = bodies_[i];
    if (body.locked) continue;
    motions[i].position += t * (velocity(body, start_[i]) + t / 2 * gravity_[i]);
    motions[i].momentum += t * body.mass * gravity_[i];
    if (!start_[i].angular_momentum.isZero(0)) motions[i].orientation = rotations_[i].at(time);
  }
}

}  // namespace cylon::engine
