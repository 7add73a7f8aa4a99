#include "tests/mutants/matrix/scenes.h"

namespace cylon::mutants {

const std::vector<SceneRow>& scene_rows() {
  static const std::vector<SceneRow> rows = {
      {"projectile", "scenarios/projectile.toml"},
      {"projectile_drag", "scenarios/projectile_drag.toml"},
      {"rocket", "scenarios/rocket.toml"},
      {"accretion", "scenarios/accretion.toml"},
      {"airplane", "scenarios/seed_airplane.toml"},
      {"rotating_frame", "scenarios/rotating_frame.toml"},
      {"constant_spin", "scenarios/constant_spin.toml"},
      {"slow_spin", "scenarios/constant_spin.toml", 0.02, 2e-6},
      {"symmetric_top", "scenarios/free_symmetric_top.toml"},
      {"dzhanibekov", "scenarios/dzhanibekov.toml"},
      {"hammer", "scenarios/compound_spin.toml"},
      {"damped_top", "scenarios/damped_free_top.toml"},
      {"spring_zero", "scenarios/spring_zero_length.toml"},
      {"spring_orbit", "scenarios/spring_orbit.toml"},
      {"damped_spring", "scenarios/damped_spring_under.toml"},
      {"driven_spring", "scenarios/driven_spring.toml"},
      {"spring_chain", "scenarios/spring_chain.toml"},
      {"two_body_spring", "scenarios/two_body_spring.toml"},
      {"kepler", "scenarios/kepler.toml"},
      {"cork", "scenarios/water_step_force.toml"},
      {"pendulum", "scenarios/physical_pendulum.toml"},
      {"heavy_top", "scenarios/heavy_top.toml"},
      {"bouncing", "scenarios/bouncing_sphere.toml"},
      {"two_walls", "scenarios/sphere_two_walls.toml"},
      {"head_on", "scenarios/two_sphere_head_on.toml"},
      {"oblique", "scenarios/two_sphere_oblique.toml"},
      {"rod_hit", "scenarios/rod_offcentre_hit.toml"},
      {"rough_ball", "scenarios/rough_ball_bounce.toml"},
      {"slide_to_roll", "scenarios/slide_to_roll.toml"},
      {"box_edge", "scenarios/box_drop_edge.toml"},
      {"block_slides", "scenarios/block_slides.toml"},
      {"block_stops", "scenarios/block_stops.toml"},
      {"cube_stack", "scenarios/cube_stack.toml"},
      {"hinge_tilted", "scenarios/hinge_tilted.toml"},
      {"welded_beams", "scenarios/welded_beams.toml"},
      {"fixed_arm", "scenarios/fixed_arm.toml"},
      {"spring_damper", "scenarios/spring_damper.toml"},
      {"tilted_gravity", "scenarios/tilted_gravity.toml"},
      {"named_material", "scenarios/bouncing_sphere_named.toml"},
      {"box_on_slab", "scenarios/box_on_slab.toml"},
      {"moving_frame", "scenarios/moving_frame.toml"},
      {"far_orbit", "scenarios/extremes/far_orbit.toml"},
      {"rough_edge", "scenarios/box_edge_rough.toml"},
      {"break_shot", "scenarios/break_shot.toml"},
      {"room", "scenarios/seed_bouncing_balls.toml"},
      {"locked_post", "scenarios/locked_post.toml"},
      {"fast_ball", "scenarios/fast_ball.toml"},
      {"cradle", "scenarios/newtons_cradle.toml"},
  };
  return rows;
}

}  // namespace cylon::mutants
