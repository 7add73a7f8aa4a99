#include "reference/exact/domain.h"

#include "harness/core/fields.h"
#include "harness/core/joint_coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cylon::exact {
namespace {

// The word of the scenario file, and the body that the force acts on (world: all).
struct ForceName {
  std::string_view kind;
  int body;
};

ForceName name_of(const core::Force& force) {
  return std::visit(
      []<class Kind>(const Kind& f) {
        ForceName name{core::Element<Kind>::name, core::world};
        if constexpr (requires { f.body; }) name.body = f.body;
        return name;
      },
      force);
}

// The plane or the second body of a pair.
std::string named_other(const core::Scene& scene, const core::Pair& pair) {
  return pair.plane >= 0 ? "plane '" + scene.planes.at(static_cast<std::size_t>(pair.plane)).name + "'"
                         : named(scene, pair.other);
}

}  // namespace

void refuse(std::string_view solution, const std::string& condition) {
  throw core::OutOfDomain(std::string(solution) + ": " + condition);
}

std::string named(const core::Scene& scene, int body) {
  return "body '" + scene.bodies.at(static_cast<std::size_t>(body)).name + "'";
}

void check_bodies(std::string_view solution, const core::Scene& scene, double horizon) {
  if (!(horizon > 0) || !std::isfinite(horizon)) refuse(solution, "the horizon must be positive and finite");
  if (scene.bodies.empty()) refuse(solution, "the scene has no body");
  if (core::has_fictitious_forces(scene))
    refuse(solution, "the scene is given in a frame that turns or accelerates");
  for (const core::Body& body : scene.bodies) {
    if (body.locked) refuse(solution, "body '" + body.name + "' is locked");
    if (!(body.mass > 0)) refuse(solution, "body '" + body.name + "' has no positive mass");
  }
}

void check_no_contacts(std::string_view solution, const core::Scene& scene) {
  std::optional<core::Pair> first;
  core::any_touching_pair(scene, [&](const core::Pair& pair) { return first = pair, true; });
  if (!first) return;
  refuse(solution, named(scene, first->body) + " may touch " + named_other(scene, *first));
}

void check_no_joints(std::string_view solution, const core::Scene& scene) {
  if (!scene.joints.empty()) refuse(solution, named(scene, scene.joints.front().body) + " has a joint");
}

void check_forces(std::string_view solution, const core::Scene& scene,
                  std::initializer_list<std::string_view> kinds) {
  check_forces_beside_joints(solution, scene, kinds);
  for (const core::Joint& joint : scene.joints)
    if (core::acted_on(joint))
      refuse(solution, "something acts along the joint of " + named(scene, joint.body));
}

void check_forces_beside_joints(std::string_view solution, const core::Scene& scene,
                                std::initializer_list<std::string_view> kinds) {
  for (const core::Force& force : scene.forces) {
    const ForceName f = name_of(force);
    if (std::ranges::find(kinds, f.kind) != kinds.end()) continue;
    refuse(solution, std::string("a force that it does not know: ") + std::string(f.kind) +
                         (f.body == core::world ? "" : " on " + named(scene, f.body)));
  }
  if (std::ranges::find(kinds, core::Element<core::UniformGravity>::name) != kinds.end()) return;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].gravity && !scene.bodies[i].gravity->isZero(0))
      refuse(solution, named(scene, static_cast<int>(i)) + " has a gravity of its own");
}

void check_no_rest_length(std::string_view solution, const core::Scene& scene) {
  for (const core::Force& force : scene.forces) {
    const auto* spring = std::get_if<core::Spring>(&force);
    if (spring && spring->rest_length != 0) {
      refuse(solution, "the spring of " + named(scene, spring->body) + " has a rest length");
    }
  }
}

void check_springs(std::string_view solution, const core::Scene& scene) {
  std::vector<bool> held(scene.bodies.size(), false);
  for (const core::Force& force : scene.forces) {
    const auto* spring = std::get_if<core::Spring>(&force);
    if (!spring) continue;
    const std::string of = "the spring of " + named(scene, spring->body);
    if (spring->to != core::world) refuse(solution, of + " ends on another body");
    if (!spring->anchor.isZero(0.0)) refuse(solution, of + " is not anchored at the centre of mass");
    if (spring->damping != 0) refuse(solution, of + " is damped");
    if (!(spring->stiffness > 0)) refuse(solution, of + " has no stiffness");
    held[static_cast<std::size_t>(spring->body)] = true;
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) refuse(solution, named(scene, static_cast<int>(i)) + " has no spring");
  }
}

// Next to the axis of the middle moment, I1 < I2 < I3, the deviation grows by
//   growth = w sqrt((I2 - I1)(I3 - I2)/(I1 I3))
// The rounding of the scene's numbers is a deviation too, but where zeros alone make it none.
void check_steady_spin(std::string_view solution, const core::Scene& scene, int index, double horizon) {
  const core::Body& body = scene.bodies.at(static_cast<std::size_t>(index));
  const core::Vector3 w = body.initial.orientation.conjugate() * body.initial.angular_velocity;
  const core::Vector3 spin = body.inertia * w;
  const double scale = w.norm() * spin.norm(), deviation = scale > 0 ? w.cross(spin).norm() / scale : 0;
  if (deviation > 1e-14) refuse(solution, named(scene, index) + " does not turn about a principal axis");
  if (!(scale > 0)) return;
  core::Vector3 moments = core::principal_axes(body.inertia).moments;
  std::sort(moments.begin(), moments.end());
  const double own = spin.norm() / w.norm();
  const bool middle =
      std::abs(own - moments[1]) < std::min(std::abs(own - moments[0]), std::abs(own - moments[2]));
  if (!middle) return;
  const double growth =
      w.norm() * std::sqrt((moments[1] - moments[0]) * (moments[2] - moments[1]) / (moments[0] * moments[2]));
  const bool by_zeros =
      deviation == 0 && body.inertia.isDiagonal(0) && body.initial.orientation.vec().isZero(0);
  if (by_zeros) return;
  const double at_start = std::max(deviation, std::numeric_limits<double>::epsilon());
  if (at_start * std::exp(growth * horizon) > 1e-14)
    refuse(solution, named(scene, index) +
                         " turns about the axis of its middle moment, and rounding takes it away from there");
}

double colliding_radius(std::string_view solution, const core::Scene& scene, int index) {
  const core::Body& body = scene.bodies.at(static_cast<std::size_t>(index));
  const auto* sphere = std::get_if<core::Sphere>(&body.shape);
  if (!sphere) refuse(solution, named(scene, index) + " is not a sphere");
  if (!body.collide) refuse(solution, named(scene, index) + " does not collide");
  return sphere->radius;
}

void check_meets(std::string_view solution, const core::Scene& scene, const core::ContactRules& may_touch,
                 const core::Pair& pair) {
  const bool meets = pair.plane >= 0 ? may_touch.body_and_plane(pair.body, pair.plane)
                                     : may_touch.bodies(pair.body, pair.other);
  if (!meets)
    refuse(solution, "collision groups keep " + named(scene, pair.body) + " and " + named_other(scene, pair) +
                         " apart");
}

void check_smooth(std::string_view solution, const core::Scene& scene, const core::Pair& pair) {
  const auto material = core::material_of(scene, pair);
  const std::string both = named(scene, pair.body) + " and " + named_other(scene, pair);
  if (!material) refuse(solution, "no material is given for " + both);
  if (material->friction != 0) refuse(solution, "friction of " + both + " is not zero");
}

core::Vector3 gravity(const core::Scene& scene, std::size_t body) {
  return core::gravity_of(scene, scene.bodies.at(body));
}

core::Vector3 common_gravity(const core::Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (!scene.bodies[i].locked) return gravity(scene, i);
  return core::gravity(scene);
}

void check_all_fall(std::string_view solution, const core::Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (gravity(scene, i).isZero(0.0))
      refuse(solution, scene.bodies[i].gravity ? named(scene, static_cast<int>(i)) + " has no gravity"
                                               : std::string("the scene has no gravity"));
}

void check_falls_alike(std::string_view solution, const core::Scene& scene) {
  const core::Vector3 all = common_gravity(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (!scene.bodies[i].locked && gravity(scene, i) != all)
      refuse(solution, named(scene, static_cast<int>(i)) + " has another gravity than the others");
}

}  // namespace cylon::exact
