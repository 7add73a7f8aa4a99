#include "reference/exact/linear_motion.h"

#include "reference/exact/domain.h"
#include "reference/exact/rounding.h"

#include <utility>

namespace cylon::exact {
namespace {

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<LinearMotion> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.emplace_back(scene, i);
  return together(std::move(motions));
}

}  // namespace

LinearMotion::LinearMotion(const core::Scene& scene, std::size_t index)
    : spin_(scene, index),
      centre_(WideVector::Zero()),
      velocity_(widen(scene.bodies[index].initial.velocity)),
      pushes_{{widen(gravity(scene, index)), 0}} {
  const Wide mass = scene.bodies[index].mass;
  const auto here = [index](int body) { return body == static_cast<int>(index); };
  for (const core::Force& force : scene.forces) {
    if (const auto* drag = std::get_if<core::Drag>(&force); drag && here(drag->body)) {
      friction_ += drag->linear / mass;
    } else if (const auto* spring = std::get_if<core::Spring>(&force); spring && here(spring->body)) {
      stiffness_ += spring->stiffness / mass;
      centre_ += spring->stiffness / mass * widen(spring->to_anchor);
    } else if (const auto* drive = std::get_if<core::Drive>(&force); drive && here(drive->body)) {
      pushes_.push_back({widen(drive->force) / mass, drive->frequency});
    }
  }
  if (stiffness_ > 0) centre_ /= stiffness_;
  offset_ = widen(scene.bodies[index].initial.position) - centre_;
  const Wide half = friction_ / 2, below = stiffness_ - half * half;
  if (below > 0) {
    slow_ = {-half, std::sqrt(below)};
    fast_ = {-half, -std::sqrt(below)};
  } else {
    fast_ = -(half + std::sqrt(-below));
    slow_ = fast_.real() == 0 ? 0 : stiffness_ / fast_.real();  // r1 r2 = k/m
  }
}

WideState LinearMotion::at(Wide t) const {
  const WideComplex difference = exponential_difference(slow_, fast_, t);
  const Wide s = difference.real(), ds = (slow_ * difference + std::exp(fast_ * t)).real();
  const Wide c = ds + friction_ * s;
  WideState state;
  state.position = centre_ + offset_ * c + velocity_ * s;
  state.velocity = velocity_ * ds - offset_ * (stiffness_ * s);
  for (const Push& push : pushes_) {
    const WideComplex at(0, push.frequency), response = exponential_difference(slow_, fast_, at, t);
    state.position += push.acceleration * response.real();
    // d/dt [a, b, c] = a [a, b, c] + [b, c]
    state.velocity += push.acceleration * (slow_ * response + exponential_difference(fast_, at, t)).real();
  }
  spin_.turn(state, t);
  return state;
}

core::Truth linear_motions(std::string_view solution, const core::Scene& scene, double horizon,
                           std::string source) {
  check_no_joints(solution, scene);
  check_no_contacts(solution, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i)
    check_steady_spin(solution, scene, i, horizon);
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = std::move(source),
          .horizon = horizon};
}

}  // namespace cylon::exact
