// Which models the ballistic stepper supports.
#include "engine/ballistic/ballistic.h"
#include "engine/ballistic/scene.h"
#include "engine/methods.h"

#include <limits>

namespace cylon::engine {

namespace {

using ballistic::Symmetry;

// In the general engine a body's reference point may be another than its centre of mass.
template <class AnyBody>
bool off_centre(const AnyBody& body) {
  if constexpr (requires { body.centre; }) return !body.centre.isZero(0);
  return false;
}

std::string body_name(std::size_t i) { return "body " + std::to_string(i) + " "; }

std::optional<std::string> unsupported_body(const Model& model, std::size_t i) {
  const Body& body = model.bodies[i];
  const bool touches = ballistic::surface(model, i) != no_surface;
  if (touches && !std::holds_alternative<Sphere>(model.shapes[i])) return body_name(i) + "is not a sphere";
  if (body.locked) return {};
  if (off_centre(body)) return body_name(i) + "has an origin that is not its centre of mass";
  if (body.inverse_mass == 0) return body_name(i) + "is pinned";

  const bool spins = !model.motions[i].angular_momentum.isZero(0);
  const bool turned = touches && ballistic::meets_friction(model, i);
  const Symmetry symmetry = ballistic::symmetry(body);
  if (turned && symmetry != Symmetry::sphere)
    return body_name(i) + "can be rotated by friction and its inertia is not that of a sphere";
  if (spins && symmetry == Symmetry::none)
    return body_name(i) + "spins and has three different principal moments";
  return {};
}

}  // namespace

namespace ballistic {

Symmetry symmetry(const Body& body) {
  const Vector3& m = body.inverse_moments;
  const Real same = 8 * epsilon * m.maxCoeff();
  const bool lower = std::abs(m[0] - m[1]) <= same, upper = std::abs(m[1] - m[2]) <= same;
  return lower && upper ? Symmetry::sphere : lower || upper ? Symmetry::axis : Symmetry::none;
}

bool meets_friction(const Model& model, std::size_t i) {
  const int own = surface(model, i);
  for (std::size_t k = 0; k < model.planes.size(); ++k)
    if (const int other = model.plane_surfaces[k];
        other != no_surface && model.material(own, other).friction > 0 &&
        model.may_touch_plane(static_cast<int>(i), static_cast<int>(k)))
      return true;
  for (std::size_t k = 0; k < model.bodies.size(); ++k)
    if (const int other = surface(model, k); k != i && other != no_surface &&
                                             model.material(own, other).friction > 0 &&
                                             model.may_touch(static_cast<int>(i), static_cast<int>(k)))
      return true;
  return false;
}

}  // namespace ballistic

std::optional<std::string> ballistic_unsupported(const Model& model) {
  if (const std::string reason = missing(Method::ballistic, model); !reason.empty()) return reason;
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    if (auto reason = unsupported_body(model, i)) return reason;
  return {};
}

}  // namespace cylon::engine
