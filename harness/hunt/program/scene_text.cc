#include "harness/hunt/program/scene_text.h"

#include "harness/core/fields.h"
#include "harness/core/joint_coordinates.h"
#include "harness/hunt/program/formulas.h"
#include "harness/hunt/program/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <variant>

namespace cylon::hunt::program {

using core::Scene;
using core::Vector3;

void require_expressible(const std::vector<Scene>& takes) {
  const Scene& scene = takes[0];
  if (scene.frame) throw None{"the scene has a frame that moves"};
  if (scene.impacts != core::Impacts::sequential) throw None{"the scene orders its impacts"};
  for (const core::Body& body : scene.bodies) {
    if (body.locked) throw None{"a body is locked"};
    if (body.gravity) throw None{"a body has a gravity of its own"};
    if (!body.collision_groups.empty() || !body.collision_mask.empty()) throw None{"bodies have groups"};
    if (!body.inertia.isDiagonal(0)) throw None{"an inertia is not diagonal"};
  }
  const core::Material* const first = scene.materials.empty() ? nullptr : scene.materials.data();
  for (const core::Material& m : scene.materials)
    if (m.friction != first->friction || m.restitution != first->restitution)
      throw None{"pairs have different materials"};
  for (const core::Force& force : scene.forces)
    std::visit(
        [&]<class Kind>(const Kind& one) {
          constexpr std::string_view name = core::Element<Kind>::name;
          if constexpr (!std::is_same_v<Kind, core::UniformGravity>)
            if (law(name).empty()) throw None{fmt::format("the scene has {}", name)};
          if constexpr (std::is_same_v<Kind, core::Thrust>)
            if (one.mass_rate != 0) throw None{"a mass changes"};
          const bool somewhere = takes.size() > 1 && !std::is_same_v<Kind, core::UniformGravity>;
          if (somewhere) throw None{"a force would have to be restated"};
        },
        force);
  if (takes.size() > 1 && !scene.joints.empty()) throw None{"a joint would have to be restated"};
}

namespace {

// As the adapters in Node turn y to a normal: x is across it and the axis to which it is least inclined.
core::Quaternion turn_of_y(const Vector3& normal) {
  if (normal == Vector3::UnitY()) return core::Quaternion::Identity();
  Eigen::Index least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Vector3 x = normal.cross(Vector3(Vector3::Unit(least))).normalized();
  core::Matrix3 turned;
  turned << x, normal, x.cross(normal);
  return core::Quaternion(turned);
}

// As the adapter of MuJoCo turns z to a normal, of any length: without roots, so that what lies on a plane touches it.
core::Quaternion long_turn_of_z(const Vector3& n) {
  if (n.z() > -0.5) return {1 + n.z(), -n.y(), n.x(), 0};
  return {-n.y(), 1 - n.z(), 0, n.x()};
}

class Saying : private Numbers {
 public:
  Saying(const std::vector<Scene>& takes, const Dialect& dialect, Words& words)
      : Numbers(*dialect.language), takes_(takes), dialect_(dialect), words_(words) {}

  void scene() {
    const Scene& scene = takes_[0];
    words_["count"] = std::to_string(scene.bodies.size());
    words_["bodies"] = list(scene.bodies, [&](const core::Body& b) { return body(b); });
    words_["starts"] = list(takes_, [&](const Scene& take) {
      return list(take.bodies, [&](const core::Body& b) { return state(b.initial); });
    });
    words_["gravities"] = list(takes_, [&](const Scene& take) { return vector(core::gravity(take)); });
    words_["friction"] = number(scene.materials.empty() ? 0 : scene.materials[0].friction);
    words_["restitution"] = number(scene.materials.empty() ? 0 : scene.materials[0].restitution);
    // Over settings of the same names.
    for (const char* word : {"shapes", "planes", "joints", "gaps", "forces", "potential"})
      words_[word].clear();
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const core::Body& body = scene.bodies[i];
      Words words{{"i", std::to_string(i)}};
      const bool touches = body.collide && !std::holds_alternative<std::monostate>(body.shape);
      if (touches) words["shape"] = shape_text(body.shape);
      words_["shapes"] += filled(touches ? dialect_.body_shape : dialect_.no_shape, words);
    }
    for (std::size_t p = 0; p < scene.planes.size(); ++p) plane(p);
    for (std::size_t j = 0; j < scene.joints.size(); ++j) joint(j);
    if (!dialect_.free_body.empty()) hang();
    forces();
  }

 private:
  std::string shape_text(const core::Shape& shape) const {
    return std::visit(
        [&]<class Shape>(const Shape& s) -> std::string {
          if constexpr (std::is_same_v<Shape, std::monostate> || std::is_same_v<Shape, core::Compound>) {
            throw None{"a body has a compound shape"};
          } else {
            const auto row = std::ranges::find(dialect_.shapes, core::Element<Shape>::name, &ShapeRow::name);
            if (row == dialect_.shapes.end())
              throw None{fmt::format("no line for the shape {}", core::Element<Shape>::name)};
            Words words;
            if constexpr (requires { s.radius; }) words["radius"] = number(s.radius);
            if constexpr (requires { s.length; }) words["length"] = number(s.length);
            if constexpr (requires { s.half_extents; })
              words["x"] = number(s.half_extents.x()), words["y"] = number(s.half_extents.y()),
              words["z"] = number(s.half_extents.z());
            return filled(row->text, words);
          }
        },
        shape);
  }

  // In each take its own: chosen at run time by `take`.
  void plane(std::size_t p) {
    for (const Scene& take : takes_)
      if (!take.planes[p].collision_mask.empty()) throw None{"a plane has groups"};
    const auto words = [&](const core::Plane& plane) {
      return Words{{"normal", listed(plane.normal)},
                   {"normal_vector", vector(plane.normal)},
                   {"offset", number(plane.offset)},
                   {"foot", vector(Vector3(plane.offset * plane.normal))},
                   {"turn_of_x", vector(core::turn_between(Vector3::UnitX(), plane.normal))},
                   {"turn_of_y", vector(turn_of_y(plane.normal))},
                   {"turn_of_z", vector(core::turn_between(Vector3::UnitZ(), plane.normal))},
                   {"long_turn_of_z", vector(long_turn_of_z(plane.normal))}};
    };
    std::string& out = words_["planes"];
    if (takes_.size() == 1)
      out += filled(dialect_.plane, words(takes_[0].planes[p]));
    else
      out += "  if (take == 0) {\n  " + filled(dialect_.plane, words(takes_[0].planes[p])) +
             "  } else {\n  " + filled(dialect_.plane, words(takes_[1].planes[p])) + "  }\n";
  }

  // Bodies in their order, so that each comes after what it hangs from.
  void hang() {
    std::string& out = words_["joints"];
    out.clear();
    const Scene& scene = takes_[0];
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const std::string* by = nullptr;
      for (std::size_t j = 0; j < scene.joints.size(); ++j) {
        const core::Joint& joint = scene.joints[j];
        if (joint.body != static_cast<int>(i)) continue;
        if (joint.to >= joint.body) throw None{"a joint hangs an earlier body from a later one"};
        if (by) throw None{"a joint closes a loop"};
        by = &joint_texts_[j];
      }
      out += by ? *by : filled(dialect_.free_body, {{"a", std::to_string(i)}});
    }
  }

  void joint(std::size_t j) {
    const core::Joint& joint = takes_[0].joints[j];
    const auto row = std::ranges::find(dialect_.joints, joint.type, &JointRow::type);
    if (core::acted_on(joint)) throw None{"a force, a stop or friction acts along a joint"};
    if (row == dialect_.joints.end())
      throw None{fmt::format("no line for a joint of type {}", core::kind_of(joint.type).name)};
    const auto at = [](int body) { return static_cast<std::size_t>(body); };
    const auto local = [&](int body) {
      const core::BodyState& s = takes_[0].bodies[at(body)].initial;
      return vector(Vector3(s.orientation.conjugate() * (joint.point - s.position)));
    };
    const auto axis = [&](int body) {
      return vector(Vector3(takes_[0].bodies[at(body)].initial.orientation.conjugate() * joint.axis));
    };
    // Whose x is the axis, and that in the axes of a body.
    const core::Quaternion frame = core::turn_between(Vector3::UnitX(), joint.axis.normalized());
    const auto turned = [&](int body) {
      return vector(core::Quaternion(takes_[0].bodies[at(body)].initial.orientation.conjugate() * frame));
    };
    Words words{{"a", std::to_string(joint.body)},     {"b", std::to_string(joint.to)},
                {"joint", fmt::format("joint{}", j)},  {"point", listed(joint.point)},
                {"point_vector", vector(joint.point)}, {"axis", listed(joint.axis)},
                {"axis_vector", vector(joint.axis)},   {"local_a", local(joint.body)},
                {"axis_a", axis(joint.body)},          {"frame", vector(frame)},
                {"frame_a", turned(joint.body)}};
    if (joint.to != core::world) {
      words["local_b"] = local(joint.to);
      words["axis_b"] = axis(joint.to), words["frame_b"] = turned(joint.to);
      const core::BodyState &a = takes_[0].bodies[at(joint.body)].initial,
                            &b = takes_[0].bodies[at(joint.to)].initial;
      words["place"] = vector(Vector3(b.orientation.conjugate() * (a.position - b.position)));
      words["turn"] = vector(b.orientation.conjugate() * a.orientation);
    }
    joint_texts_.push_back(filled(joint.to == core::world ? row->to_world : row->to_body, words));
    words_["joints"] += joint_texts_.back();
    words["end"] = joint.to == core::world ? words["point_vector"]
                                           : filled("add(s[${b}].x, turn(s[${b}].q, ${local_b}))", words);
    words_["gaps"] +=
        filled("  gap = max(gap, norm(sub(add(s[${a}].x, turn(s[${a}].q, ${local_a})), ${end})));\n", words);
  }

  void forces() {
    std::string& calls = words_["forces"];
    std::string& potential = words_["potential"];
    for (const core::Force& force : takes_[0].forces)
      std::visit(
          [&]<class Kind>(const Kind& f) {
            if constexpr (std::is_same_v<Kind, core::Spring>) {
              const std::string far = vector(f.to_anchor);
              calls += fmt::format("  spring(s, {}, {}, {}, {}, {}, {}, {});\n", f.body, vector(f.anchor),
                                   f.to, far, number(f.stiffness), number(f.rest_length), number(f.damping));
              const auto end = [&](int body, const Vector3& anchor) {
                return body == core::world
                           ? vector(anchor)
                           : fmt::format("add(s[{0}].x, turn(s[{0}].q, {1}))", body, vector(anchor));
              };
              potential += fmt::format("{}0.5 * {} * square(norm(sub({}, {})) - {})",
                                       potential.empty() ? "" : " + ", number(f.stiffness),
                                       end(f.to, f.to_anchor), end(f.body, f.anchor), number(f.rest_length));
            } else if constexpr (std::is_same_v<Kind, core::Drag>) {
              calls += fmt::format("  drag(s, {}, {}, {}, {});\n", f.body, number(f.linear),
                                   number(f.angular), number(f.momentum));
            } else if constexpr (std::is_same_v<Kind, core::Thrust>) {
              calls += fmt::format("  thrust(s, {}, {});\n", f.body, vector(f.force));
            } else if constexpr (std::is_same_v<Kind, core::Drive>) {
              calls += fmt::format("  drive(t, {}, {}, {});\n", f.body, vector(f.force), number(f.frequency));
            } else if constexpr (std::is_same_v<Kind, core::Attraction>) {
              calls += fmt::format("  attraction(s, {}, {}, {});\n", f.body, f.to, number(f.strength));
              potential +=
                  fmt::format("{}-({}) * body[{}].m * body[{}].m / norm(sub(s[{}].x, s[{}].x))",
                              potential.empty() ? "" : " + ", number(f.strength), f.body, f.to, f.body, f.to);
            }
          },
          force);
    if (potential.empty()) potential = "0.0";
  }

  const std::vector<Scene>& takes_;
  const Dialect& dialect_;
  Words& words_;
  std::vector<std::string> joint_texts_;
};

}  // namespace

void say_scene(const std::vector<Scene>& takes, const Dialect& dialect, Words& words) {
  Saying(takes, dialect, words).scene();
}

std::string depths(const Scene& scene, const Language& language) {
  std::string out;
  const Numbers numbers(language);
  const auto radius = [&](int i) {
    const auto* sphere = std::get_if<core::Sphere>(&scene.bodies[static_cast<std::size_t>(i)].shape);
    return sphere ? std::optional(sphere->radius) : std::nullopt;
  };
  for (const core::Pair& pair : core::touching_pairs(scene)) {
    if (pair.plane < 0) {
      if (!radius(pair.body) || !radius(pair.other))
        throw None{"the depth of two solids in each other takes more than a line"};
      out += fmt::format("  depth = max(depth, {} - norm(sub(s[{}].x, s[{}].x)));\n",
                         Numbers::number(*radius(pair.body) + *radius(pair.other)), pair.body, pair.other);
      continue;
    }
    const core::Plane& plane = scene.planes[static_cast<std::size_t>(pair.plane)];
    const auto add = [&](const std::string& point, double r) {
      out += fmt::format("  depth = max(depth, {} - dot({}, {}));\n", Numbers::number(r + plane.offset),
                         numbers.vector(plane.normal), point);
    };
    if (radius(pair.body)) {
      add(fmt::format("s[{}].x", pair.body), *radius(pair.body));
      continue;
    }
    const auto* box = std::get_if<core::Box>(&scene.bodies[static_cast<std::size_t>(pair.body)].shape);
    if (!box) throw None{"the depth of such a solid in a plane takes more than a line"};
    for (const double x : {-1, 1})
      for (const double y : {-1, 1})
        for (const double z : {-1, 1})
          add(fmt::format("add(s[{0}].x, turn(s[{0}].q, {1}))", pair.body,
                          numbers.vector(Vector3(box->half_extents.cwiseProduct(Vector3(x, y, z))))),
              0);
  }
  return out;
}

std::string laws(const Scene& scene) {
  std::string out;
  std::vector<std::string_view> said;
  for (const core::Force& force : scene.forces)
    std::visit(
        [&]<class Kind>(const Kind&) {
          constexpr std::string_view name = core::Element<Kind>::name;
          if (std::ranges::find(said, name) != said.end()) return;
          said.push_back(name);
          out += law(name);
        },
        force);
  return out;
}

}  // namespace cylon::hunt::program
