#include "harness/study/limits_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::study {

using core::Vector3;

core::Scene lone_ball(const Vector3& position, const Vector3& velocity, const Vector3& angular_velocity) {
  core::Scene scene;
  core::Body body;
  body.name = "ball";
  body.shape = core::Sphere{0.1};
  body.inertia = 0.004 * core::Matrix3::Identity();
  body.initial = {position, core::Quaternion::Identity(), velocity, angular_velocity};
  scene.bodies.push_back(body);
  return scene;
}

core::Body box_body(const std::string& name, double mass, const Vector3& half, const Vector3& position) {
  core::Body body;
  body.name = name;
  body.mass = mass;
  body.shape = core::Box{half};
  const Vector3 s = half.cwiseProduct(half);
  body.inertia = (mass / 3 * Vector3(s.y() + s.z(), s.z() + s.x(), s.x() + s.y())).asDiagonal();
  body.initial.position = position;
  body.collide = true;
  return body;
}

void add_floor(core::Scene& scene, double restitution, double friction) {
  for (core::Body& body : scene.bodies) body.collide = true;
  scene.planes.push_back({"floor", Vector3::UnitY(), 0});
  scene.materials.push_back({{"*", "*"}, restitution, friction});
}

void add_gravity(core::Scene& scene) { scene.forces.emplace_back(core::UniformGravity{{0, -gravity, 0}}); }

Probed broken(std::string what) { return {false, std::move(what)}; }

std::optional<std::string> nonsense(const core::Recording& r, double bound) {
  for (std::size_t i = 0; i < r.states.size(); ++i)
    for (const core::BodyState& s : r.states[i]) {
      const double worst = std::max({s.position.cwiseAbs().maxCoeff(), s.velocity.cwiseAbs().maxCoeff(),
                                     s.angular_velocity.cwiseAbs().maxCoeff()});
      const bool number = s.position.allFinite() && s.velocity.allFinite() &&
                          s.angular_velocity.allFinite() && s.orientation.coeffs().allFinite();
      if (!number) return fmt::format("non-finite at step {}", r.steps[i]);
      if (worst > bound) return fmt::format("value too large: {:.2g} at step {}", worst, r.steps[i]);
    }
  return std::nullopt;
}

double strayed(const core::Recording& r) {
  double far = 0;
  for (const core::State& state : r.states)
    for (std::size_t b = 0; b < state.size(); ++b)
      far = std::max(far, (state[b].position - r.states.front()[b].position).norm());
  return far;
}

}  // namespace cylon::study
