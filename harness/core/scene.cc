#include "harness/core/scene.h"

#include "harness/core/collision_filter.h"
#include "harness/core/surfaces.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace cylon::core {
namespace {

// How exactly a pattern names a surface: 0 not at all, 1 by "*", 2 by name.
int match(const std::string& pattern, const std::string& name) {
  return pattern == name ? 2 : pattern == "*" ? 1 : 0;
}

int match(const Material& material, const std::string& a, const std::string& b) {
  const auto both = [&](int i, int j) {
    const int first = match(material.between[i], a), second = match(material.between[j], b);
    return first && second ? first + second : 0;
  };
  return std::max(both(0, 1), both(1, 0));
}

}  // namespace

Vector3 gravity(const Scene& scene) {
  Vector3 sum = Vector3::Zero();
  for (const Force& force : scene.forces)
    if (const auto* uniform = std::get_if<UniformGravity>(&force)) sum += uniform->acceleration;
  return sum;
}

bool has_fictitious_forces(const Scene& scene) { return scene.frame && scene.frame->pushes(); }

Vector3 gravity_of(const Scene& scene, const Body& body) {
  return body.gravity ? *body.gravity : gravity(scene);
}

bool has_plugin_force(const Scene& scene) {
  return std::ranges::any_of(scene.forces,
                             [](const Force& force) { return std::holds_alternative<PluginForce>(force); });
}

bool states_own_gravity(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const Body& body) { return body.gravity.has_value(); });
}

double strongest_gravity(const Scene& scene) {
  double most = gravity(scene).norm();
  for (const Body& body : scene.bodies)
    if (body.gravity && !body.locked) most = std::max(most, body.gravity->norm());
  return most;
}

State initial_state(const Scene& scene) {
  State state;
  state.reserve(scene.bodies.size());
  for (const Body& body : scene.bodies) state.push_back(body.initial);
  return state;
}

bool any_touching_pair(const Scene& scene, const std::function<bool(const Pair&)>& found) {
  std::vector<int> solid;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (collides(scene.bodies[i])) solid.push_back(static_cast<int>(i));
  const ContactRules may_touch(scene);
  for (auto a = solid.begin(); a != solid.end(); ++a) {
    for (auto b = std::next(a); b != solid.end(); ++b)
      if (may_touch.bodies(*a, *b) && found({*a, *b, -1})) return true;
    for (int p = 0; p < static_cast<int>(scene.planes.size()); ++p)
      if (may_touch.body_and_plane(*a, p) && found({*a, world, p})) return true;
  }
  return false;
}

std::vector<Pair> touching_pairs(const Scene& scene) {
  std::vector<Pair> pairs;
  any_touching_pair(scene, [&](const Pair& pair) {
    pairs.push_back(pair);
    return false;
  });
  return pairs;
}

std::vector<Pair> touching_pairs(const Scene& scene, int body) {
  std::vector<Pair> pairs;
  if (!collides(scene.bodies[static_cast<std::size_t>(body)])) return pairs;
  const ContactRules may_touch(scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    if (i != body && collides(scene.bodies[static_cast<std::size_t>(i)]) && may_touch.bodies(i, body))
      pairs.push_back({std::min(i, body), std::max(i, body), -1});
  }
  for (int p = 0; p < static_cast<int>(scene.planes.size()); ++p)
    if (may_touch.body_and_plane(body, p)) pairs.push_back({body, world, p});
  return pairs;
}

std::optional<Material> material_of(const Scene& scene, const Pair& pair) {
  const std::string& a = scene.bodies[static_cast<std::size_t>(pair.body)].name;
  const std::string& b = pair.plane >= 0 ? scene.planes[static_cast<std::size_t>(pair.plane)].name
                                         : scene.bodies[static_cast<std::size_t>(pair.other)].name;
  const Material* best = nullptr;
  int best_match = 0;
  for (const Material& material : scene.materials) {
    const int m = match(material, a, b);
    if (m > best_match) best = &material, best_match = m;
  }
  return best ? std::optional(*best) : std::nullopt;
}

Matrix3 world_inertia(const Body& body, const Quaternion& orientation) {
  const Matrix3 r = orientation.toRotationMatrix();
  return r * body.inertia * r.transpose();
}

PrincipalAxes principal_axes(const Matrix3& inertia) {
  if (inertia.isDiagonal(0.0)) return {inertia.diagonal(), Quaternion::Identity()};
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(inertia);
  // Order the eigenvectors by the body axis that each lies closest to, and make them right-handed.
  std::array<int, 3> order = {0, 1, 2};
  double best = -1;
  for (std::array<int, 3> p : {std::array{0, 1, 2}, std::array{0, 2, 1}, std::array{1, 0, 2},
                               std::array{1, 2, 0}, std::array{2, 0, 1}, std::array{2, 1, 0}}) {
    double along = 0;
    for (int i = 0; i < 3; ++i) along += std::abs(solver.eigenvectors()(i, p[static_cast<std::size_t>(i)]));
    if (along > best) best = along, order = p;
  }
  PrincipalAxes result;
  Matrix3 axes;
  for (int i = 0; i < 3; ++i) {
    const int k = order[static_cast<std::size_t>(i)];
    result.moments[i] = solver.eigenvalues()[k];
    axes.col(i) = solver.eigenvectors().col(k) * (solver.eigenvectors()(i, k) < 0 ? -1 : 1);
  }
  if (axes.determinant() < 0) axes.col(2) = -axes.col(2);
  result.rotation = Quaternion(axes).normalized();
  return result;
}

Quaternion turn_between(const Vector3& from, const Vector3& to) {
  return Quaternion::FromTwoVectors(from, to);
}

}  // namespace cylon::core
