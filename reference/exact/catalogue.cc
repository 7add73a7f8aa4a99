#include "reference/exact/catalogue.h"

#include "reference/exact/solutions.h"

#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace cylon::exact {

std::span<const Solution> catalogue() {
  static constexpr std::array solutions = {
      Solution{"accretion", accretion,
               "bodies without spin in uniform gravity whose mass changes by matter of a given velocity"},
      Solution{"block_slides", sliding_block, "the same as sliding_block"},
      Solution{"block_sticks", sliding_block, "the same as sliding_block"},
      Solution{"block_stops", sliding_block, "the same as sliding_block"},
      Solution{"block_uphill", sliding_block, "the same as sliding_block"},
      Solution{"bouncing_sphere", bouncing_sphere,
               "smooth spheres bouncing on one plane that gravity points into, or each on the one that its "
               "group touches, which do not meet"},
      Solution{"box_drop_edge", box_drop_edge,
               "a smooth box that falls on an edge parallel to the plane, up to its second contact"},
      Solution{"constant_spin", projectile, "the same as projectile"},
      Solution{"damped_free_top", damped_free_top,
               "rigid bodies, free or falling, braked in proportion to their angular momentum, any inertia, "
               "not exactly on the separatrix"},
      Solution{
          "damped_spring", damped_spring,
          "bodies each on springs of no rest length from the centre to pins, linear drag, gravity or none"},
      Solution{"damped_spring_critical", damped_spring, "the same as damped_spring"},
      Solution{"damped_spring_over", damped_spring, "the same as damped_spring"},
      Solution{"damped_spring_under", damped_spring, "the same as damped_spring"},
      Solution{"driven_spring", driven_spring, "as damped_spring, and harmonic forces of any frequency"},
      Solution{"dzhanibekov", free_asymmetric_top, "the same as free_asymmetric_top"},
      Solution{"free_asymmetric_top", free_asymmetric_top,
               "rigid bodies, free or falling, any inertia and orientation, not exactly on the separatrix"},
      Solution{"free_symmetric_top", free_symmetric_top,
               "rigid bodies, free or falling, with two equal principal moments, any orientation"},
      Solution{
          "heavy_top", heavy_top,
          "bodies with two equal principal moments on ball joints to the world, the centre of mass on the "
          "symmetry axis, uniform gravity in any direction"},
      Solution{"jointed_body", jointed_body,
               "bodies each on a slider, hinge, screw, cylindrical or planar joint to the world whose "
               "coordinates do not couple: springs, dampers, driven targets, or stops and dry friction"},
      Solution{"kepler", kepler,
               "two bodies that attract each other, free, falling together or one of them locked, any conic"},
      Solution{"limited_pendulum", limited_pendulum,
               "bodies on hinges to the world in gravity, each between two stops, elastic or not"},
      Solution{"newtons_cradle", sphere_row, "the same as sphere_row"},
      Solution{"newtons_cradle_gapped", sphere_row, "the same as sphere_row"},
      Solution{"physical_pendulum", physical_pendulum,
               "bodies on hinges to the world in gravity, swinging or whirling, not on the separatrix"},
      Solution{"projectile", projectile,
               "bodies in uniform gravity, turning about a principal axis or not at all"},
      Solution{"projectile_drag", projectile_drag,
               "bodies in uniform gravity with linear drag, turning about a principal axis or not at all"},
      Solution{"rocket", rocket,
               "bodies without spin in uniform gravity that throw out mass at a given velocity relative to "
               "themselves"},
      Solution{"rod_offcentre_hit", rod_offcentre_hit,
               "a smooth sphere that strikes a free box, which does not turn before, once"},
      Solution{"rolling_sphere_incline", rough_sphere, "the same as rough_sphere"},
      Solution{"rotating_frame", rotating_frame,
               "scenes in a turning frame to which nothing is fixed, where another solution serves the "
               "inertial scene"},
      Solution{"rough_ball_bounce", rough_sphere, "the same as rough_sphere"},
      Solution{"rough_sphere", rough_sphere,
               "spheres that fly, bounce, slide and roll on one plane with friction, slip along the slope"},
      Solution{"seed_airplane", seed_airplane,
               "bodies with a constant thrust in body axes, in gravity, turning about a principal axis or "
               "not at all"},
      Solution{"slide_to_roll", rough_sphere, "the same as rough_sphere"},
      Solution{"sliding_block", sliding_block,
               "boxes flat on one plane that slide along the slope, stop or stay, and do not tip"},
      Solution{"slipping_sphere_incline", rough_sphere, "the same as rough_sphere"},
      Solution{
          "sphere_row", sphere_row,
          "smooth spheres in rows, free or falling, that strike each other centrally, one after another"},
      Solution{
          "sphere_two_walls", sphere_two_walls,
          "smooth spheres between two walls that face each other, no gravity across, far from each other"},
      Solution{
          "spherical_pendulum", spherical_pendulum,
          "bodies on distance joints from the centre to the world, in gravity, any start off the separatrix"},
      Solution{"spring_chain", spring_chain,
               "bodies joined by undamped springs between centres and to pins: any network without rest "
               "lengths, or a line along a coordinate axis"},
      Solution{
          "spring_orbit", spring_orbit,
          "bodies each on one undamped spring from the centre to a pin, no gravity, not aimed at the pin"},
      Solution{"spring_zero_length", spring_zero_length,
               "bodies each on undamped springs of no rest length from the centre to pins, gravity or none"},
      Solution{"statics", statics,
               "bodies at rest that hang straight down from the world on ball, hinge, universal and fixed "
               "joints, in gravity"},
      Solution{"two_sphere_head_on", sphere_row, "the same as sphere_row"},
      Solution{"two_sphere_oblique", two_sphere_oblique,
               "two smooth spheres, free or falling together, at most one collision"},
      Solution{"water_step_force", water_step_force,
               "points without spin that rise and fall in the seed's water of mode \"step\", vertical "
               "gravity or none"},
  };
  return solutions;
}

namespace {

// The scene as seen from an inertial frame in which -a adds to what makes bodies fall.
std::optional<core::Scene> with_more_gravity(const core::Scene& scene) {
  if (!scene.frame || scene.frame->turns() || scene.frame->frequency != 0 || !scene.frame->pushes())
    return std::nullopt;
  for (const core::Force& force : scene.forces)
    if (std::holds_alternative<core::Water>(force)) return std::nullopt;  // lifts against the stated gravity
  const core::Vector3 more = -scene.frame->acceleration;
  core::Scene result = scene;
  result.frame.reset();
  result.forces.emplace_back(core::UniformGravity{more});
  for (core::Body& body : result.bodies)
    if (body.gravity) *body.gravity += more;
  return result;
}

}  // namespace

core::Truth solve(const Solution& solution, const core::Scene& scene, double horizon) {
  const std::optional<core::Scene> inertial = with_more_gravity(scene);
  if (!inertial) return solution.make(scene, horizon);
  core::Truth truth = solution.make(*inertial, horizon);
  // Up is against the gravity that the scene states: such events are found in the states.
  std::erase_if(truth.events, [](const core::Event& e) {
    return e.kind == core::EventKind::turn || e.kind == core::EventKind::nutation ||
           e.kind == core::EventKind::precession;
  });
  truth.source += "; the acceleration of the frame is a gravity";
  return truth;
}

}  // namespace cylon::exact
