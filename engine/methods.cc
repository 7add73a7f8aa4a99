#include "engine/methods.h"

#include "engine/plan.h"

#include <algorithm>
#include <array>
#include <map>

namespace cylon::engine {

namespace {

// All that one row names; a new feature is in none of them.
constexpr Features all_forces = {Feature::spring,     Feature::damped_spring, Feature::off_centre_spring,
                                 Feature::drag,       Feature::thrust,        Feature::drive,
                                 Feature::attraction, Feature::water,         Feature::joint_law,
                                 Feature::frame_force};
constexpr Features user_forces = {Feature::user_force, Feature::user_force_of_velocities};
constexpr Features all_joints = {Feature::joint_together,     Feature::joint_at_length,
                                 Feature::joint_along_axis,   Feature::joint_in_plane,
                                 Feature::joint_about_axis,   Feature::joint_about_two_axes,
                                 Feature::joint_along_normal, Feature::joint_never};
constexpr Features all_contacts = {
    Feature::contact,     Feature::lasting_contact,  Feature::friction, Feature::sphere,
    Feature::box,         Feature::capsule,          Feature::hull,     Feature::compound,
    Feature::pairs_apart, Feature::collision_filters};
constexpr Features shapes_in_steps = {Feature::frustum, Feature::compound_beside_bodies};
constexpr Features rigid_bodies = {Feature::locked_body, Feature::spin, Feature::changing_mass,
                                   Feature::own_gravity};

struct MethodRow {
  Method method;
  Features features;
};

constexpr std::array methods = {
    MethodRow{Method::exact,
              {Feature::locked_body, Feature::spin, Feature::own_gravity, Feature::late_start}},
    MethodRow{Method::free, {Feature::spin, Feature::chosen_integrator, Feature::late_start}},
    MethodRow{Method::modes, {Feature::locked_body, Feature::spring, Feature::drive, Feature::own_gravity}},
    MethodRow{Method::points,
              {Feature::locked_body, Feature::spring, Feature::drive, Feature::attraction,
               Feature::own_gravity, Feature::chosen_integrator, Feature::late_start}},
    MethodRow{Method::top,
              {Feature::spin, Feature::pinned_body, Feature::own_gravity, Feature::chosen_integrator,
               Feature::late_start}},
    MethodRow{Method::bodies,
              rigid_bodies | all_forces | user_forces | all_joints |
                  Features{Feature::joint_couples, Feature::joint_rotor, Feature::quadratic_damping,
                           Feature::pinned_body, Feature::one_axis_body, Feature::guided_body,
                           Feature::turning_frame, Feature::chosen_integrator, Feature::account,
                           Feature::late_start, Feature::every_stage}},
    MethodRow{Method::trees,
              all_forces | user_forces |
                  Features{Feature::locked_body, Feature::spin, Feature::own_gravity, Feature::joint_together,
                           Feature::joint_along_axis, Feature::joint_in_plane, Feature::joint_along_normal,
                           Feature::joint_about_axis, Feature::joint_about_two_axes, Feature::joint_never,
                           Feature::joint_rotor, Feature::quadratic_damping, Feature::chosen_integrator,
                           Feature::late_start}},
    MethodRow{Method::ballistic,
              {Feature::locked_body, Feature::spin, Feature::contact, Feature::friction, Feature::sphere,
               Feature::collision_filters, Feature::own_gravity, Feature::late_start}},
    MethodRow{Method::events, rigid_bodies | all_forces | user_forces | all_joints | all_contacts |
                                  Features{Feature::joint_couples, Feature::quadratic_damping,
                                           Feature::joint_limit, Feature::joint_friction,
                                           Feature::joint_rotor, Feature::pinned_body, Feature::one_axis_body,
                                           Feature::guided_body, Feature::chosen_integrator, Feature::account,
                                           Feature::late_start, Feature::every_stage, Feature::path_events}},
    MethodRow{Method::sphere_steps,
              {Feature::locked_body, Feature::spin, Feature::contact, Feature::lasting_contact,
               Feature::friction, Feature::sphere, Feature::collision_filters, Feature::own_gravity,
               Feature::late_start, Feature::every_stage, Feature::path_stepping}},
    MethodRow{Method::body_steps,
              rigid_bodies | all_forces | all_joints | all_contacts | shapes_in_steps |
                  Features{Feature::joint_couples, Feature::joint_limit, Feature::joint_friction,
                           Feature::joint_rotor, Feature::quadratic_damping, Feature::late_start,
                           Feature::every_stage, Feature::path_stepping}},
};

constexpr bool one_row_each() {
  if (methods.size() != static_cast<std::size_t>(Method::count)) return false;
  for (std::size_t i = 0; i < methods.size(); ++i)
    if (methods[i].method != static_cast<Method>(i)) return false;
  return true;
}
static_assert(one_row_each(), "every method has a row, in the order of the enumeration");

void add_joint(Joint::Type type, Features& features) {
  switch (type.place) {
    case Joint::Place::together:
      features.add(Feature::joint_together);
      break;
    case Joint::Place::at_length:
      features.add(Feature::joint_at_length);
      break;
    case Joint::Place::along_axis:
      features.add(Feature::joint_along_axis);
      break;
    case Joint::Place::in_plane:
      features.add(Feature::joint_in_plane);
      break;
    case Joint::Place::along_normal:
      features.add(Feature::joint_along_normal);
      break;
  }
  switch (type.turn) {
    case Joint::Turn::freely:
    case Joint::Turn::about_three_axes:
      break;
    case Joint::Turn::about_axis:
      features.add(Feature::joint_about_axis);
      break;
    case Joint::Turn::about_two_axes:
      features.add(Feature::joint_about_two_axes);
      break;
    case Joint::Turn::never:
      features.add(Feature::joint_never);
      break;
  }
  if (type.couples) features.add(Feature::joint_couples);
}

// The feature of a shape that may touch; a shape without one does not compile.
void add_shape(const std::monostate&, Features&) {}
void add_shape(const Sphere&, Features& features) { features.add(Feature::sphere); }
void add_shape(const Box&, Features& features) { features.add(Feature::box); }
void add_shape(const Capsule&, Features& features) { features.add(Feature::capsule); }
void add_shape(const Hull&, Features& features) { features.add(Feature::hull); }
void add_shape(const Frustum&, Features& features) { features.add(Feature::frustum); }
void add_shape(const Compound& compound, Features& features) {
  features.add(Feature::compound);
  for (const ShapePart& part : compound.parts)
    std::visit([&](const auto& shape) { add_shape(shape, features); }, part.shape);
}

bool may_touch(const Model& model, std::size_t body) {
  return !model.surfaces.empty() && model.surfaces[body] != no_surface;
}

Features of_bodies(const Model& model) {
  Features all;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (body.locked) all.add(Feature::locked_body);
    if (!model.motions[i].angular_momentum.isZero(0)) all.add(Feature::spin);
    if (body.mass_rate != 0) all.add(Feature::changing_mass);
    if (body.gravity && !body.locked) all.add(Feature::own_gravity);
    if (body.pinned) all.add(Feature::pinned_body);
    if (body.one_axis) all.add(Feature::one_axis_body);
    if (body.guide) all.add(Feature::guided_body);
  }
  return all;
}

// The world and what is locked stand still as the frame sees them: with W x r as an inertial frame does.
bool stands_in_frame(const Model& model, int body) {
  return body == fixed_world || model.bodies[index(body)].locked;
}

template <class Force>
bool ties_to_frame(const Model& model, const Force& force) {
  const std::optional<Acted> bodies = force.acts_on();
  return bodies && std::ranges::any_of(*bodies, [&](int body) {
           return body != fixed_world && model.bodies[index(body)].locked;
         });
}

Features of_forces(const Model& model) {
  Features all;
  each_force(model.forces, [&](const auto& force) {
    force.add_features(all);
    if (model.frame &&
        (!force.holds_in_turning_frame() || (force.reads_velocities() && ties_to_frame(model, force))))
      all.add(Feature::force_in_turning_frame);
  });
  for (const Water& water : model.forces.waters)
    for (std::size_t i = 0; i < water.shapes.size(); ++i)
      if (water.mode == WaterMode::volume && !model.bodies[i].locked && !displaces(water.shapes[i]))
        all.add(Feature::unknown_displacement);
  return all;
}

Features of_joints(const Model& model) {
  Features all;
  for (const Joint& joint : model.joints) {
    add_joint(joint.type, all);
    if (model.frame && (stands_in_frame(model, joint.body) || stands_in_frame(model, joint.to)))
      all.add(Feature::world_joint_in_turning_frame);
  }
  return all;
}

Features of_contacts(const Model& model) {
  if (!can_touch(model)) return {};
  Features all = {Feature::contact};
  if (!model.apart.empty()) all.add(Feature::pairs_apart);
  if (!model.filters.empty()) all.add(Feature::collision_filters);
  std::size_t touching = 0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (!may_touch(model, i)) continue;
    ++touching;
    std::visit([&](const auto& shape) { add_shape(shape, all); }, model.shapes[i]);
  }
  if (touching > 1 && all.has(Feature::compound)) all.add(Feature::compound_beside_bodies);
  for (const Material& material : model.materials)
    if (material.friction > 0) all.add(Feature::friction);
  return all;
}

}  // namespace

Features supports(Method method) { return methods[static_cast<std::size_t>(method)].features; }

Features required(const Model& model) {
  Features all = of_bodies(model) | of_forces(model) | of_joints(model) | of_contacts(model);
  if (model.frame) all.add(Feature::turning_frame);
  // Limits and dry friction of joints are contacts, too.
  if (model.frame && all.has(Feature::contact)) all.add(Feature::contact_in_turning_frame);
  return all;
}

// A path is asked for only where something can touch.  The full model runs the stages of contacts too, where
// it may.
Features required(const Model& model, const Options& options) {
  Features all = required(model);
  if (options.integrator != "auto") all.add(Feature::chosen_integrator);
  if (options.account) all.add(Feature::account);
  if (options.full) all.add(Feature::every_stage);
  if (options.full && options.path.empty() && !model.frame) all.add(Feature::contact);
  if (!can_touch(model)) return all;
  if (options.path == "events") all.add(Feature::path_events);
  if (options.path == "stepping") all.add(Feature::path_stepping);
  return all;
}

std::string missing(Method method, const Model& model) { return names(required(model) - supports(method)); }

bool can_touch(const Model& model) {
  struct Members {
    std::size_t moving = 0, all = 0, planes = 0;
  };
  std::map<Filter, Members> kinds;
  const auto filter = [](const std::vector<Filter>& list, std::size_t i) {
    return list.empty() ? Filter{} : list[i];
  };
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (!may_touch(model, i)) continue;
    Members& members = kinds[filter(model.filters, i)];
    ++members.all;
    members.moving += !model.bodies[i].locked;
  }
  for (std::size_t k = 0; k < model.planes.size(); ++k) ++kinds[filter(model.plane_filters, k)].planes;
  for (const auto& [a, ours] : kinds)
    for (const auto& [b, theirs] : kinds)
      if (ours.moving > 0 && may_meet(a, b) && (theirs.all > (a == b ? 1u : 0u) || theirs.planes > 0))
        return true;
  return false;
}

}  // namespace cylon::engine
