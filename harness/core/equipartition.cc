#include "harness/core/equipartition.h"

#include <fmt/format.h>
#include <boost/math/special_functions/beta.hpp>
#include "harness/core/collision_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cylon::core {
namespace {

// Whether the planes leave no way out: no d != 0 with n . d >= 0 for each of them.  If there is one, there is one along
// the line in which two planes meet, unless all normals lie in one plane.
bool is_closed(const std::vector<Plane>& planes) {
  constexpr double parallel = 1e-9;
  const auto way_out = [&](const Vector3& d) {
    return std::ranges::all_of(planes, [&](const Plane& p) { return p.normal.dot(d) >= -parallel; });
  };
  bool turned = false;  // whether three normals are independent
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vector3 edge = planes[i].normal.cross(planes[j].normal);
      if (edge.norm() < parallel) continue;
      const Vector3 d = edge.normalized();
      if (way_out(d) || way_out(-d)) return false;
      turned = true;
    }
  return turned;  // along a common edge of all there would have been a way out
}

bool is_ball(const Body& body) {
  const auto* sphere = std::get_if<Sphere>(&body.shape);
  return body.collide && sphere && sphere->radius > 0;
}

int bodies_that_move(const Scene& scene) {
  return static_cast<int>(std::ranges::count_if(scene.bodies, [](const Body& body) { return !body.locked; }));
}

bool of_all(const Observable& q) { return !q.body && q.component == Component::all; }

// k of the n numbers.
int numbers_of(const Observable& q, const Scene& scene) {
  return static_cast<int>(axes(q.component).size()) * (q.body ? 1 : bodies_that_move(scene));
}

// Doubles stay doubles: the law is asked for every body at every sample, and long doubles, which give the same digits but the
// last two, take several times as long.
constexpr boost::math::policies::policy<boost::math::policies::promote_double<false>> in_doubles;

// The law of the share of k of n numbers.
struct Law {
  double a, b;
  Law(int k, int n) : a(k / 2.0), b((n - k) / 2.0) {}
  double below(double x) const { return boost::math::ibeta(a, b, std::clamp(x, 0.0, 1.0), in_doubles); }
  double above(double x) const { return boost::math::ibetac(a, b, std::clamp(x, 0.0, 1.0), in_doubles); }
};

// D of shares of N bodies.
double distance_from_law(std::vector<double> shares) {
  std::ranges::sort(shares);
  const auto n = static_cast<double>(shares.size());
  const Law law(3, 3 * static_cast<int>(shares.size()));
  double result = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double f = law.below(shares[i]), at = static_cast<double>(i) / n;
    result = std::max({result, f - at, at + 1 / n - f});
  }
  return result;
}

}  // namespace

std::optional<std::string> energy_share_undefined(const Observable& q, const Scene& scene) {
  for (const Body& body : scene.bodies)
    if (!body.locked && !is_ball(body))
      return fmt::format("body '{}' is no sphere that collides: only of a gas of spheres is it known",
                         body.name);
  if (states_filters(scene)) return "collision groups may keep bodies from each other or from the walls";
  if (bodies_that_move(scene) < 2) return "chance needs two bodies that meet";
  if (q.body && scene.bodies[static_cast<std::size_t>(*q.body)].locked) return "a locked body has no share";
  for (const Material& m : scene.materials)
    if (m.restitution != 1 || m.friction != 0)
      return fmt::format("the impacts of '{}' and '{}' are not elastic and smooth", m.between[0],
                         m.between[1]);
  for (const Force& force : scene.forces)
    if (!std::holds_alternative<UniformGravity>(force)) return "other forces than gravity act";
  if (!scene.joints.empty()) return "joints hold bodies";
  if (has_fictitious_forces(scene)) return "the frame turns or accelerates";
  if (!is_closed(scene.planes)) return "the planes leave a way out";
  return std::nullopt;
}

double energy_share(const Observable& q, const Scene& scene, const State& state) {
  double total = 0, part = 0;
  std::vector<double> shares;
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (scene.bodies[i].locked) continue;
    const double twice = scene.bodies[i].mass * state[i].velocity.squaredNorm();
    total += twice;
    shares.push_back(twice);
    if (!q.body || static_cast<std::size_t>(*q.body) == i)
      part += scene.bodies[i].mass * only(state[i].velocity, q.component).squaredNorm();
  }
  if (!std::isfinite(total)) return std::numeric_limits<double>::quiet_NaN();
  if (!(total > 0)) return of_all(q) ? 1 : 0;
  if (!of_all(q)) return part / total;
  for (double& share : shares) share /= total;
  return distance_from_law(std::move(shares));
}

double expected_share(const Observable& q, const Scene& scene) {
  return of_all(q) ? 0 : static_cast<double>(numbers_of(q, scene)) / (3 * bodies_that_move(scene));
}

double chance_of_share(const Observable& q, const Scene& scene, double distance) {
  if (of_all(q)) return std::min(1.0, 2 * std::exp(-2 * bodies_that_move(scene) * distance * distance));
  const Law law(numbers_of(q, scene), 3 * bodies_that_move(scene));
  const double mean = expected_share(q, scene);
  return law.below(mean - distance) + law.above(mean + distance);
}

double allowed_share(const Observable& q, const Scene& scene, double level) {
  double low = 0, high = 1;  // chance falls from 1 to 0, or to what is below every level
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (chance_of_share(q, scene, middle) > level ? low : high) = middle;
  }
  return high;
}

}  // namespace cylon::core
