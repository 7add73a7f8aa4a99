#include "reference/simulators/in_house/in_house_model.h"

#include "engine/methods.h"
#include "harness/core/collision_filter.h"
#include "harness/core/overloaded.h"
#include "harness/core/surfaces.h"
#include "reference/simulators/in_house/in_house_joints.h"
#include "reference/simulators/in_house/in_house_real.h"
#include "reference/simulators/in_house/in_house_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <variant>

namespace cylon::simulators {
namespace {

using core::Overloaded;
using core::Scene;
using engine::Model;
using engine::Real;

const core::Body& body_of(const Scene& scene, int index) {
  return scene.bodies[static_cast<std::size_t>(index)];
}

// ---- Bodies --------------------------------------------------------------------------------------

void add_bodies(const Scene& scene, Model& model) {
  static_assert(core::world == engine::fixed_world);
  for (const core::Body& body : scene.bodies) {
    model.bodies.push_back(
        engine::make_body(real(body.mass), engine::Matrix3(body.inertia.cast<Real>()), body.locked));
    if (body.gravity) model.bodies.back().gravity = real(*body.gravity);
    const core::BodyState& s = body.initial;
    model.motions.push_back(engine::make_motion(model.bodies.back(), real(s.position), real(s.orientation),
                                                real(s.velocity), real(s.angular_velocity)));
  }
}

// A body has no momentum about an axis without inertia, so a turn about it would be lost.
std::optional<std::string> lost_turn(const Scene& scene, const Model& model) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::Body& body = scene.bodies[i];
    const core::Vector3& w = body.initial.angular_velocity;
    if (body.locked || w.isZero(0)) continue;
    const core::Vector3 kept = engine::angular_velocity(model.bodies[i], model.motions[i]).cast<double>();
    constexpr double rounding = std::max(1e-6, 256. * engine::epsilon);  // of w, L and w again
    if ((w - kept).norm() > rounding * w.norm())
      return fmt::format(
          "body '{}' turns at {:.3g} rad/s about an axis about which its moment of inertia is none or "
          "rounding "
          "beside the largest: the engine keeps angular momentum, which says nothing of that turn",
          body.name, (w - kept).norm());
  }
  return std::nullopt;
}

// ---- Forces --------------------------------------------------------------------------------------

void add(const core::Thrust& t, Model& model) {
  engine::Thrust thrust{t.body, real(t.force), real(t.mass_rate), t.exhaust_velocity.has_value(), {}};
  thrust.exchanged = real(t.exhaust_velocity.value_or(t.exchanged_velocity.value_or(core::Vector3::Zero())));
  model.forces.thrusts.push_back(thrust);
  model.bodies[static_cast<std::size_t>(t.body)].mass_rate += thrust.mass_rate;
}

// By volume every body displaces water, whether it collides or not.
std::optional<std::string> add(const core::Water& w, const Scene& scene, Model& model) {
  engine::Water water;
  water.level = real(w.level), water.wave = real(w.wave), water.speed = real(w.speed);
  water.buoyancy = real(w.buoyancy), water.drag = real(w.drag);
  water.mode = w.mode == "step" ? engine::WaterMode::step : engine::WaterMode::volume;
  for (std::size_t i = 0; water.mode == engine::WaterMode::volume && i < scene.bodies.size(); ++i) {
    auto shape = in_house_shape(scene.bodies[i].shape, scene.bodies[i].locked);
    if (const Missing* what = std::get_if<Missing>(&shape)) {
      if (!scene.bodies[i].locked && std::holds_alternative<core::Disc>(scene.bodies[i].shape))
        return fmt::format("body '{}' under water is a disc, which has no volume", scene.bodies[i].name);
      if (!scene.bodies[i].locked)
        return fmt::format("body '{}' is {}, whose submerged volume the engine cannot compute",
                           scene.bodies[i].name, *what);
      shape = engine::Shape();
    }
    water.shapes.push_back(std::get<engine::Shape>(std::move(shape)));
  }
  model.forces.waters.push_back(std::move(water));
  return std::nullopt;
}

std::optional<std::string> add(const core::PluginForce& f, const Scene& scene, const Plugins& plugins,
                               Model& model) {
  auto law = plugins.law(scene, f);
  if (auto* reason = std::get_if<NoLaw>(&law)) return std::move(*reason);
  model.forces.user_forces.push_back({f.bodies, std::get<0>(std::move(law))});
  return std::nullopt;
}

std::optional<std::string> add_forces(const Scene& scene, const Plugins& plugins, Model& model) {
  std::optional<std::string> missing;
  engine::Forces& forces = model.forces;
  for (const core::Force& force : scene.forces) {
    std::visit(Overloaded{
                   [&](const core::UniformGravity& g) { forces.gravity += real(g.acceleration); },
                   [&](const core::Spring& s) {
                     forces.springs.push_back({s.body, real(s.anchor), s.to, real(s.to_anchor),
                                               real(s.stiffness), real(s.rest_length), real(s.damping)});
                   },
                   [&](const core::Drag& d) {
                     forces.drags.push_back({d.body, real(d.linear), real(d.angular), real(d.momentum)});
                   },
                   [&](const core::Thrust& t) { add(t, model); },
                   [&](const core::Drive& d) {
                     forces.drives.push_back({d.body, real(d.force), real(d.frequency)});
                   },
                   [&](const core::Attraction& a) {
                     forces.attractions.push_back({a.body, a.to, real(a.strength)});
                   },
                   [&](const core::Water& w) {
                     if (auto reason = add(w, scene, model)) missing = reason;
                   },
                   [&](const core::PluginForce& f) {
                     if (auto reason = add(f, scene, plugins, model)) missing = reason;
                   },
               },
               force);
  }
  return missing;
}

// ---- Contacts ------------------------------------------------------------------------------------

std::string name_of_other(const Scene& scene, const core::Pair& pair) {
  return pair.plane >= 0 ? scene.planes[static_cast<std::size_t>(pair.plane)].name
                         : body_of(scene, pair.other).name;
}

std::optional<std::string> add_contacts(const Scene& scene, Model& model) {
  if (const auto pair = core::pair_without_material(scene))
    return fmt::format("'{}' and '{}' may touch, but the scene has no material for them",
                       body_of(scene, pair->body).name, name_of_other(scene, *pair));
  const core::Surfaces surfaces = core::surfaces(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::Body& body = scene.bodies[i];
    const bool collides = body.collide && !std::holds_alternative<std::monostate>(body.shape);
    model.surfaces.push_back(collides ? surfaces.of_body[i] : engine::no_surface);
    model.shapes.emplace_back();
    if (!collides) continue;
    auto shape = in_house_shape(body.shape, body.locked);
    if (const Missing* what = std::get_if<Missing>(&shape))
      return fmt::format("body '{}' may touch, but is {}, for which the engine has no collision shape",
                         body.name, *what);
    model.shapes.back() = std::get<engine::Shape>(std::move(shape));
  }
  for (const core::Plane& plane : scene.planes)
    model.planes.push_back({real(plane.normal), real(plane.offset)});
  model.plane_surfaces = surfaces.of_plane;
  model.surface_count = surfaces.count;
  for (const int row : surfaces.table) {
    model.materials.emplace_back();  // of a pair that never meets, where the scene states none
    if (row < 0) continue;
    const core::Material& material = scene.materials[static_cast<std::size_t>(row)];
    model.materials.back() = {real(material.restitution), real(material.friction)};
  }
  for (const auto& [a, b] : core::jointed_pairs(scene)) model.apart.push_back({a, b});
  if (const core::CollisionFilters filters(scene); filters.stated) {
    const auto engine_filter = [](const core::CollisionFilter& f) {
      return engine::Filter{f.groups, f.mask};
    };
    std::ranges::transform(filters.of_body, std::back_inserter(model.filters), engine_filter);
    std::ranges::transform(filters.of_plane, std::back_inserter(model.plane_filters), engine_filter);
  }
  constexpr engine::Impacts rules[] = {engine::Impacts::sequential, engine::Impacts::simultaneous};
  model.impacts = rules[static_cast<std::size_t>(scene.impacts)];
  return std::nullopt;
}

// A frame that only moves on changes nothing (Galilei).  In one that turns evenly, and to which nothing is fixed, the
// motion is computed as from an inertial frame: v + W x p and w + W are the inertial velocities.  In all others it is as
// the frame sees it, and the frame's motion is a force.
void set_frame(const Scene& scene, Model& model) {
  if (!core::has_fictitious_forces(scene)) return;
  const core::Frame& frame = *scene.frame;
  const engine::Vector3 w = real(frame.angular_velocity);
  model.frame = engine::RotatingFrame{w};
  constexpr engine::Features of_the_frame = {engine::Feature::contact_in_turning_frame,
                                             engine::Feature::world_joint_in_turning_frame,
                                             engine::Feature::force_in_turning_frame};
  const bool fixed = !(engine::required(model) & of_the_frame).empty();
  if (fixed || !frame.acceleration.isZero(0) || !frame.angular_acceleration.isZero(0)) {
    model.frame.reset();
    model.forces.frame_forces = {
        {real(frame.acceleration), real(frame.frequency), w, real(frame.angular_acceleration)}};
    return;
  }
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const core::BodyState& s = scene.bodies[i].initial;
    model.motions[i] =
        engine::make_motion(model.bodies[i], real(s.position), real(s.orientation),
                            real(s.velocity) + w.cross(real(s.position)), real(s.angular_velocity) + w);
  }
}

}  // namespace

InHouseModel in_house_model(const Scene& scene, const Plugins& plugins) {
  InHouseModel result;
  Model& model = result.model;
  add_bodies(scene, model);
  result.lost = lost_turn(scene, model);
  result.missing = add_forces(scene, plugins, model);
  if (result.missing) return result;
  add_joints(scene, model);
  result.missing = add_contacts(scene, model);
  set_frame(scene, model);
  return result;
}

}  // namespace cylon::simulators
