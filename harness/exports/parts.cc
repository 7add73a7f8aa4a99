#include "harness/exports/parts.h"

#include "harness/core/fields.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cylon::exports {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// A pair by its two things: bodies first, then planes.
struct Ends {
  std::size_t a, b;
  core::Material material;
};

// Materials have no names: which one of the file it is.
int number_of(const core::Scene& scene, const core::Material& material) {
  const auto found = std::ranges::find_if(scene.materials, [&](const core::Material& m) {
    return m.between[0] == material.between[0] && m.between[1] == material.between[1];
  });
  return static_cast<int>(found - scene.materials.begin());
}

std::vector<Ends> meetings_of(const core::Scene& scene) {
  std::vector<Ends> meetings;
  for (const core::Pair& pair : core::touching_pairs(scene)) {
    const auto material = core::material_of(scene, pair);
    const std::string& name = scene.bodies[at(pair.body)].name;
    if (!material) throw Unsayable{"body", name, "", "it may touch something, and no [[material]] says how"};
    const std::size_t b = pair.plane >= 0 ? scene.bodies.size() + at(pair.plane) : at(pair.other);
    meetings.push_back({at(pair.body), b, *material});
  }
  return meetings;
}

const std::string& name_of_thing(const core::Scene& scene, std::size_t i) {
  return i < scene.bodies.size() ? scene.bodies[i].name : scene.planes[i - scene.bodies.size()].name;
}

constexpr double rounding = 1e-15;

}  // namespace

// Where one rule combines all pairs, a surface's number is the one of its pairs on which that rule has least effect: with
// the larger of two the smallest, with the smaller the largest.
Surfaces surfaces_of(const core::Scene& scene, const PairRule& rule) {
  const std::vector<Ends> meetings = meetings_of(scene);
  std::vector<std::optional<double>> friction(scene.bodies.size() + scene.planes.size());
  const bool larger = rule.friction(0, 1) == 1;
  std::optional<double> restitution;
  const auto fail = [&](const Ends& m, std::string_view key, const std::string& why) {
    throw Unsayable{
        "material", "", key,
        fmt::format("of '{}' and '{}': {}", name_of_thing(scene, m.a), name_of_thing(scene, m.b), why),
        number_of(scene, m.material)};
  };
  for (const Ends& m : meetings) {
    for (const std::size_t i : {m.a, m.b}) {
      const double mu = m.material.friction, old = friction[i].value_or(mu);
      friction[i] = larger ? std::min(old, mu) : std::max(old, mu);
    }
    const double e = m.material.restitution;
    if (e != 0 && !rule.restitution) fail(m, "restitution", "its impacts are inelastic");
    if (restitution && *restitution != e) fail(m, "restitution", "all pairs must have the same");
    restitution = e;
  }
  for (const Ends& m : meetings)
    if (std::abs(rule.friction(*friction[m.a], *friction[m.b]) - m.material.friction) > rounding)
      fail(m, "friction",
           "the format combines the numbers of two surfaces, and none give this beside the other pairs");
  Surfaces surfaces;
  for (std::size_t i = 0; i < friction.size(); ++i)
    (i < scene.bodies.size() ? surfaces.of_body : surfaces.of_plane)
        .push_back({friction[i].value_or(0), std::sqrt(restitution.value_or(0))});
  return surfaces;
}

std::string unique(std::string name, std::set<std::string>& taken) {
  const std::string plain = name;
  for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{} ({})", plain, i);
  return name;
}

void require_plain(const core::Scene& scene) {
  if (scene.frame) throw Unsayable{"frame", "", "", "its scenes are in an inertial frame"};
  if (scene.impacts != core::Impacts::sequential)
    throw Unsayable{"", "", "impacts", "it has no rule for several impacts at one instant"};
  for (const core::Body& body : scene.bodies)
    if (body.name == "world") throw Unsayable{"body", body.name, "name", "the world has this name"};
  for (const core::Force& force : scene.forces)
    std::visit(
        [&]<class F>(const F& f) {
          if constexpr (requires { f.bodies; })
            throw Unsayable{core::Element<F>::name, name_of(scene, f.bodies.front()), "",
                            "it has no such force"};
          else if constexpr (requires { f.body; })
            throw Unsayable{core::Element<F>::name, name_of(scene, f.body), "", "it has no such force"};
          else if constexpr (!std::is_same_v<F, core::UniformGravity>)
            throw Unsayable{core::Element<F>::name, "", "", "it has no such force"};
        },
        force);
}

int other_end(const core::Scene& scene, const core::Joint& joint) {
  if (joint.to == core::world || !scene.bodies[at(joint.to)].locked) return joint.to;
  if (core::collides(scene.bodies[at(joint.to)]))
    throw Unsayable{"joint", name_of(scene, joint.body), "to",
                    "a joint to a locked body is one to the world, and this "
                    "body has a surface that the other would touch then"};
  return core::world;
}

std::vector<core::Part> parts_of(const core::Body& body) {
  return std::visit(
      []<class S>(const S& shape) -> std::vector<core::Part> {
        if constexpr (std::is_same_v<S, std::monostate>)
          return {};
        else if constexpr (std::is_same_v<S, core::Compound>)
          return shape.parts;
        else
          return {core::Part{.shape = shape}};
      },
      body.shape);
}

const std::string& name_of(const core::Scene& scene, int body) {
  static const std::string world = "world";
  return body == core::world ? world : scene.bodies[at(body)].name;
}

void require_plain(const core::Scene& scene, const core::Joint& joint) {
  const auto require = [&](std::string_view key, const core::JointCoordinate& c) {
    const auto fail = [&](const char* why) {
      throw Unsayable{"joint", name_of(scene, joint.body), key, why};
    };
    if (c.restitution != 0) fail("a restitution: its limits are inelastic");
    if (c.quadratic_damping != 0) fail("quadratic_damping: its dampers are linear");
    if (core::target_moves(c)) fail("a target that moves: its springs have one rest position");
  };
  for (const auto& c : joint.displacements) require(core::Element<core::JointDisplacement>::name, c);
  for (const auto& c : joint.angles) require(core::Element<core::JointAngle>::name, c);
}

}  // namespace cylon::exports
