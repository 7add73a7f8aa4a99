#include "reference/applied/masses.h"

#include <fmt/format.h>

namespace cylon::applied {

std::optional<std::string> without_step(std::string_view engine, const core::Setup& setup) {
  if (setup.dt > 0) return {};
  return fmt::format("{} steps forward only; dt = {} s.", engine, setup.dt);
}

std::optional<std::string> without_mass(std::string_view engine, const core::Scene& scene) {
  for (const core::Body& body : scene.bodies) {
    if (body.locked) continue;
    if (!(body.mass > 0))
      return fmt::format("{} needs a mass above zero of what moves; '{}' has {} kg.", engine, body.name,
                         body.mass);
    const double least = core::principal_axes(body.inertia).moments.minCoeff();
    if (!(least > 0))
      return fmt::format("{} needs principal moments above zero of what moves; '{}' has one of {} kg m^2.",
                         engine, body.name, least);
  }
  return {};
}

std::optional<std::string> without_triangle(std::string_view engine, const core::Scene& scene) {
  constexpr double rounding = 1e-12;  // relative, of moments computed from a tensor
  for (const core::Body& body : scene.bodies) {
    if (body.locked) continue;
    const core::Vector3 moments = core::principal_axes(body.inertia).moments;
    if (2 * moments.maxCoeff() > moments.sum() + rounding * moments.maxCoeff())
      return fmt::format("{} needs principal moments A + B >= C; '{}' has {}, {} and {} kg m^2.", engine,
                         body.name, moments[0], moments[1], moments[2]);
  }
  return {};
}

}  // namespace cylon::applied
