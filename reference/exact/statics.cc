// Bodies that hang at rest from the world on joints, under gravity.
//
// What fixed joints weld together is one part.  With p_k the point of the joint on which part k hangs, M_j all the mass that
// hangs on joint j, and R_k the turn of part k from where it is, the potential energy is
//
//   V = - sum_k g . R_k c_k,   c_k = sum of the part's m_i (x_i - p_k) + sum over joints j below it of M_j (p_j - p_k)
//
// so that all is in equilibrium where every c_k is along g, and a minimum of V where none is against it:
// V - V_0 = sum |g| |c_k| (1 - cos a_k), a_k the angle by which c_k is off.  Where c_k = 0 nothing turns the part.  A part that
// is welded to the world is held whatever its c_k.
//
// Rounding leaves the c_k off by angles d_k of 1e-17 or so; then E = sum |g| |c_k| d_k^2/2 is all the energy that there is, and
// no angle exceeds sqrt(2 E/(|g| |c|)) + d_k, no speed sqrt(2 E/m).
// Domain: ball joints, hinges, universal and fixed joints; no loops; gravity alone, the same for all; c_k off by 1e-14 at most.
#include "reference/exact/domain.h"
#include "reference/exact/solutions.h"
#include "reference/exact/wide.h"

#include <algorithm>
#include <limits>

namespace cylon::exact {
namespace {

constexpr auto name = "statics";

std::size_t at(int body) { return static_cast<std::size_t>(body); }

// How a body hangs: on a joint from another, or from the world.
struct Hung {
  std::size_t joint = 0;
  int from = core::world;
  std::size_t part = 0;  // the body of the part that hangs on a joint that turns, or on the world
};

// The bodies in an order in which each comes after the one on which it hangs.
struct Tree {
  std::vector<std::size_t> order;
  std::vector<Hung> hung;  // by body
};

Tree tree_of(const core::Scene& scene) {
  Tree tree;
  tree.hung.resize(scene.bodies.size());
  std::vector<bool> seen(scene.bodies.size(), false), used(scene.joints.size(), false);
  const auto hang_all_on = [&](int from) {
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      const core::Joint& joint = scene.joints[j];
      if (used[j] || (joint.body != from && joint.to != from)) continue;
      used[j] = true;
      const int body = joint.body == from ? joint.to : joint.body;
      if (body == core::world || seen[at(body)])
        refuse(name, "the joints of " + named(scene, joint.body) + " close a loop");
      seen[at(body)] = true;
      const bool welded = core::kind_of(joint.type).turn == core::JointTurn::never && from != core::world;
      tree.hung[at(body)] = {j, from, welded ? tree.hung[at(from)].part : at(body)};
      tree.order.push_back(at(body));
    }
  };
  hang_all_on(core::world);
  for (std::size_t k = 0; k < tree.order.size(); ++k)  // which grows  NOLINT(modernize-loop-convert)
    hang_all_on(static_cast<int>(tree.order[k]));
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (!seen[i]) refuse(name, named(scene, static_cast<int>(i)) + " does not hang from the world");
  return tree;
}

// c_k of each part, by its first body; the sizes of what it is a sum of.
struct Levers {
  std::vector<WideVector> lever;
  std::vector<Wide> size;
};

Levers levers_of(const core::Scene& scene, const Tree& tree) {
  const std::size_t n = scene.bodies.size();
  Levers result{std::vector<WideVector>(n, WideVector::Zero()), std::vector<Wide>(n, 0)};
  std::vector<Wide> below(n);  // mass of a body and of all that hangs on it
  const auto add = [&](std::size_t part, Wide mass, const core::Vector3& point) {
    const WideVector arm = widen(point) - widen(scene.joints[tree.hung[part].joint].point);
    result.lever[part] += mass * arm, result.size[part] += mass * arm.norm();
  };
  for (auto i = tree.order.rbegin(); i != tree.order.rend(); ++i) {
    const Hung& hung = tree.hung[*i];
    below[*i] += scene.bodies[*i].mass;
    add(hung.part, scene.bodies[*i].mass, scene.bodies[*i].initial.position);
    if (hung.from == core::world) continue;
    below[at(hung.from)] += below[*i];
    if (hung.part == *i) add(tree.hung[at(hung.from)].part, below[*i], scene.joints[hung.joint].point);
  }
  return result;
}

bool welded_to_world(const core::Scene& scene, const Hung& hung) {
  return hung.from == core::world &&
         core::kind_of(scene.joints[hung.joint].type).turn == core::JointTurn::never;
}

core::StateError check_hanging(const core::Scene& scene, const Tree& tree) {
  const Levers levers = levers_of(scene, tree);
  const WideVector g = widen(common_gravity(scene));
  Wide energy = 0, weakest = std::numeric_limits<Wide>::infinity(), off = 0, reach = 0;
  for (const std::size_t i : tree.order) {
    reach = std::max(
        reach,
        (widen(scene.bodies[i].initial.position) - widen(scene.joints[tree.hung[i].joint].point)).norm());
    if (tree.hung[i].part != i || welded_to_world(scene, tree.hung[i])) continue;
    const WideVector& c = levers.lever[i];
    if (g.isZero(0) || c.isZero(0)) continue;
    const Wide across = c.cross(g).norm();
    if (across > 1e-14L * levers.size[i] * g.norm() || !(c.dot(g) > 1e-9L * levers.size[i] * g.norm()))
      refuse(name, "what hangs with " + named(scene, static_cast<int>(i)) +
                       " does not hang straight below its joint");
    const Wide angle = across / (c.norm() * g.norm());
    energy += c.norm() * g.norm() * angle * angle / 2;
    weakest = std::min(weakest, c.norm() * g.norm()), off = std::max(off, angle);
  }
  core::StateError error;
  if (energy == 0) return error;
  const Wide angle = std::sqrt(2 * energy / weakest) + off;
  error.orientation = static_cast<double>(angle);
  error.position = static_cast<double>(angle * reach * static_cast<Wide>(scene.bodies.size()));
  for (const core::Body& body : scene.bodies) {
    const Wide least = core::principal_axes(body.inertia).moments.minCoeff();
    error.velocity = std::max(error.velocity, static_cast<double>(std::sqrt(2 * energy / body.mass)));
    if (least > 0)  // a point does not turn
      error.angular_velocity =
          std::max(error.angular_velocity, static_cast<double>(std::sqrt(2 * energy / least)));
  }
  return error;
}

}  // namespace

core::Truth statics(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_falls_alike(name, scene);
  check_no_contacts(name, scene);
  for (const core::Joint& joint : scene.joints)
    if (core::kind_of(joint.type).place != core::JointPlace::together)
      refuse(name, "the joint of " + named(scene, joint.body) + " is of kind " +
                       std::string(core::kind_of(joint.type).name));
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::BodyState& s = scene.bodies[i].initial;
    if (!s.velocity.isZero(0) || !s.angular_velocity.isZero(0))
      refuse(name, named(scene, static_cast<int>(i)) + " does not start at rest");
  }
  const core::StateError error = check_hanging(scene, tree_of(scene));
  return {.state = [state = core::initial_state(scene)](double) { return state; },
          .error = error,
          .source = "Lagrange and Dirichlet: rest at a minimum of the potential energy",
          .horizon = horizon};
}

}  // namespace cylon::exact
