// The in-house engine behind the common interface.  It has no path that others have not: it gets a Scene and
// a Setup.
#include "engine/world.h"
#include "harness/core/input_error.h"
#include "harness/core/overloaded.h"
#include "harness/core/simulator.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string_view>
#include <variant>

namespace cylon::simulators {

namespace {

using core::Overloaded;
using Reason = std::optional<std::string>;

// ---- What the engine cannot express -------------------------------------------------------------

Reason missing(const core::Force& force) {
  return std::visit(Overloaded{[](const core::Thrust&) -> Reason {
                                 return "thrust is not modelled: bodies have a constant mass and no engines";
                               },
                               [](const core::Attraction&) -> Reason {
                                 return "attraction between bodies is not modelled";
                               },
                               [](const core::Water&) -> Reason { return "water is not modelled"; },
                               [](const auto&) -> Reason { return std::nullopt; }},
                    force);
}

Reason missing(const core::Joint& joint) {
  constexpr std::array names = {"ball", "hinge", "distance", "fixed"};
  if (joint.type == core::JointType::ball) return std::nullopt;
  return fmt::format("{} joints are not modelled: only ball joints are",
                     names[static_cast<std::size_t>(joint.type)]);
}

// The radius of a shape that may touch, or nothing when it is not a sphere.
std::optional<double> radius_of(const core::Body& body) {
  if (const auto* sphere = std::get_if<core::Sphere>(&body.shape)) return sphere->radius;
  return std::nullopt;
}

const core::Body& body_of(const core::Scene& scene, int index) {
  return scene.bodies[static_cast<std::size_t>(index)];
}

Reason missing(const core::Scene& scene, const core::Pair& pair) {
  for (const int index : {pair.body, pair.other}) {
    if (index == core::world || radius_of(body_of(scene, index))) continue;
    return fmt::format("body '{}' may touch and is no sphere: only spheres and planes collide",
                       body_of(scene, index).name);
  }
  const std::string& first = body_of(scene, pair.body).name;
  const std::string& second = pair.plane < 0 ? body_of(scene, pair.other).name
                                             : scene.planes[static_cast<std::size_t>(pair.plane)].name;
  const auto material = core::material_of(scene, pair);
  if (!material)
    return fmt::format("'{}' and '{}' may touch and the scene states no material for them", first, second);
  if (material->friction > 0) {
    return fmt::format("friction between '{}' and '{}' is not modelled: contacts are frictionless", first,
                       second);
  }
  return std::nullopt;
}

Reason missing(const core::Scene& scene) {
  if (scene.frame) return "moving frames are not modelled: the engine computes in an inertial frame";
  for (const auto& force : scene.forces) {
    if (auto reason = missing(force)) return reason;
  }
  for (const auto& joint : scene.joints) {
    if (auto reason = missing(joint)) return reason;
  }
  const auto pairs = core::touching_pairs(scene);
  if (scene.impacts == core::Impacts::simultaneous && !pairs.empty()) {
    return "simultaneous impacts are not modelled: several impacts at one instant resolve one after another";
  }
  for (const auto& pair : pairs) {
    if (auto reason = missing(scene, pair)) return reason;
  }
  return std::nullopt;
}

// ---- Scene to model -----------------------------------------------------------------------------

void add(const core::Force& force, engine::Forces& forces) {
  std::visit(Overloaded{[&](const core::UniformGravity& g) { forces.gravity += g.acceleration; },
                        [&](const core::Spring& s) {
                          forces.springs.push_back(
                              {s.body, s.anchor, s.to, s.to_anchor, s.stiffness, s.rest_length, s.damping});
                        },
                        [&](const core::Drag& d) {
                          forces.drags.push_back({d.body, d.linear, d.angular, d.momentum});
                        },
                        [&](const core::Drive& d) {
                          forces.drives.push_back({d.body, d.force, d.frequency});
                        },
                        [](const core::Thrust&) {},  // refused by missing()
                        [](const core::Attraction&) {}, [](const core::Water&) {}},
             force);
}

// A point given in world coordinates at t = 0, in the axes of a body or of the world.
engine::Vector3 anchor_of(const core::Scene& scene, int body, const core::Vector3& point) {
  if (body == core::world) return point;
  const core::BodyState& initial = body_of(scene, body).initial;
  return initial.orientation.conjugate() * (point - initial.position);
}

engine::Contact contact_of(const core::Scene& scene, const core::Pair& pair) {
  engine::Contact contact;
  contact.body = pair.body;
  contact.radius = *radius_of(body_of(scene, pair.body));
  contact.restitution = core::material_of(scene, pair)->restitution;
  if (pair.plane >= 0) {
    const core::Plane& plane = scene.planes[static_cast<std::size_t>(pair.plane)];
    contact.normal = plane.normal;
    contact.offset = plane.offset;
  } else {
    contact.other = pair.other;
    contact.other_radius = *radius_of(body_of(scene, pair.other));
  }
  return contact;
}

engine::Model model_of(const core::Scene& scene) {
  static_assert(core::world == engine::fixed_world);
  engine::Model model;
  for (const auto& body : scene.bodies)
    model.bodies.push_back(engine::make_body(body.mass, body.inertia, body.locked));
  for (const auto& force : scene.forces) add(force, model.forces);
  for (const auto& joint : scene.joints) {
    model.joints.push_back({joint.body, anchor_of(scene, joint.body, joint.point), joint.to,
                            anchor_of(scene, joint.to, joint.point)});
  }
  for (const auto& pair : core::touching_pairs(scene)) model.contacts.push_back(contact_of(scene, pair));
  return model;
}

// ---- The simulator ------------------------------------------------------------------------------

core::Engine describe() {
  core::Engine engine;
  engine.name = "in-house";
  engine.version = "0.1";
  engine.precision = "double";
  core::Path path;
  path.name = "default";
  path.summary = "Joints and resting contacts at acceleration level, impacts located inside the step.";
  path.unforceable = {"After each step the state is projected onto its joints and resting contacts.",
                      "A bounce that would return within a millionth of a step, or comes after a thousand in "
                      "one step, ends in rest.",
                      "A thin body does not turn about an axis without inertia."};
  engine.paths = {path};
  engine.default_path_rule = "There is one path.";
  for (const auto& row : engine::integrators()) {
    engine.schemes.push_back({std::string(row.name), row.order, std::string(row.conserves)});
  }
  return engine;
}

[[noreturn]] void refuse(std::string_view what, const std::string& word,
                         const std::vector<std::string>& valid) {
  std::string message = fmt::format("in-house has no {} '{}'{}", what, word, core::did_you_mean(word, valid));
  message += valid.empty() ? fmt::format(" (there are no {}s)", what)
                           : fmt::format(" (valid: {})", fmt::join(valid, ", "));
  throw std::invalid_argument(message);
}

class InHouse final : public core::Simulator {
 public:
  const core::Engine& engine() const override {
    static const core::Engine description = describe();
    return description;
  }

  Reason unsupported(const core::Scene& scene, const core::Setup&) const override { return missing(scene); }

  core::Terms load(const core::Scene& scene, const core::Setup& setup) override {
    const core::Path& path = engine().paths.front();
    if (!setup.path.empty() && setup.path != path.name) refuse("path", setup.path, {path.name});
    if (!setup.options.empty()) refuse("option", setup.options.begin()->first, {});
    const engine::Integrator& integrator = integrator_of(setup);

    engine::Model model = model_of(scene);
    std::vector<engine::Motion> motion;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const core::BodyState& initial = scene.bodies[i].initial;
      motion.push_back(engine::make_motion(model.bodies[i], initial.position, initial.orientation,
                                           initial.velocity, initial.angular_velocity));
    }
    world_.emplace(std::move(model), std::move(motion), integrator, setup.dt);
    return {path.name,       std::string(integrator.name), integrator.order, "exact", path.settings,
            path.unforceable};
  }

  void step() override { world_->step(); }

  void read(core::State& state) const override {
    const auto& bodies = world_->bodies();
    const auto& motion = world_->motion();
    state.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      state[i] = {motion[i].position, motion[i].orientation, engine::velocity(bodies[i], motion[i]),
                  engine::angular_velocity(bodies[i], motion[i])};
    }
  }

 private:
  const engine::Integrator& integrator_of(const core::Setup& setup) const {
    if (setup.integrator.empty()) return engine::integrators().front();
    if (const auto* row = engine::find_integrator(setup.integrator)) return *row;
    std::vector<std::string> names;
    for (const auto& scheme : engine().schemes) names.push_back(scheme.name);
    refuse("integrator", setup.integrator, names);
  }

  std::optional<engine::World> world_;
};

}  // namespace

}  // namespace cylon::simulators

std::unique_ptr<cylon::core::Simulator> cylon::core::make_simulator() {
  return std::make_unique<simulators::InHouse>();
}
