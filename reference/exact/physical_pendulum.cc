// Rigid bodies on hinges to the world (physical pendulums), by pendulum.h.  Domain: one hinge to the world per body,
// gravity at any angle to the axis or none; not on the separatrix k = 1, nor nearer to it than 1e-14, where the
// starting values decide nothing.
#include "reference/exact/domain.h"
#include "reference/exact/pendulum.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"

#include <optional>

namespace cylon::exact {
namespace {

constexpr auto name = "physical_pendulum";

class Pendulum {
 public:
  Pendulum(const core::Scene& scene, std::size_t index) : body_(scene, index) {
    if (body_.frequency > 0) motion_.emplace(body_.frequency, body_.initial);
  }

  bool on_separatrix() const { return motion_ && motion_->on_separatrix(); }

  WideState at(Wide t) const {
    if (!motion_ || motion_->on_separatrix()) return body_.turned(body_.initial.rate * t);
    return body_.state(motion_->at(t));
  }

 private:
  HingedBody body_;
  std::optional<PendulumMotion> motion_;
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<Pendulum> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.emplace_back(scene, i);
  return together(std::move(motions));
}

}  // namespace

core::Truth physical_pendulum(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_no_contacts(name, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    check_hinge(name, scene, i);
    if (Pendulum(scene, static_cast<std::size_t>(i)).on_separatrix())
      refuse(name, named(scene, i) + " is on the separatrix or too near it: it comes to rest upright");
  }
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = "Whittaker, Analytical Dynamics, section 44: the pendulum by Jacobi's functions",
          .horizon = horizon};
}

}  // namespace cylon::exact
