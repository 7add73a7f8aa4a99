#include "tests/mutants/matrix/scenes.h"

namespace cylon::mutants {

// Durations are cut where errors show early and steps cost time.
const std::vector<SceneRow>& scene_rows() {
  static const std::vector<SceneRow> rows = {
      {"projectile", "scenarios/projectile.toml", 0, 3, "sqrt(g / 1 m)"},
      {"projectile_drag", "scenarios/projectile_drag.toml", 0, 3, "sqrt(g / 1 m)"},
      {"rocket", "scenarios/rocket.toml", 0, 3, "sqrt(g / 1 m)"},
      {"accretion", "scenarios/accretion.toml", 0, 3, "sqrt(g / 1 m)"},
      {"airplane", "scenarios/seed_airplane.toml", 5, 2, "|w|"},
      {"rotating_frame", "scenarios/rotating_frame.toml", 0, 2, "2 |w|, Coriolis"},
      {"constant_spin", "scenarios/constant_spin.toml", 5, 3, "|w|"},
      {"slow_spin", "scenarios/constant_spin.toml", 0.02, 3, "|w|", 1, 2e-6},
      {"symmetric_top", "scenarios/free_symmetric_top.toml", 4, 11, "|L| / I1 and the wobble"},
      {"dzhanibekov", "scenarios/dzhanibekov.toml", 8, 5, "|w|; a separatrix magnifies 1e4 times", 1e4},
      {"hammer", "scenarios/compound_spin.toml", 4, 8, "|w| and the wobble"},
      {"damped_top", "scenarios/damped_free_top.toml", 5, 6, "|w| and the wobble"},
      {"spring_zero", "scenarios/spring_zero_length.toml", 4, 10, "sqrt(k / m)"},
      {"spring_orbit", "scenarios/spring_orbit.toml", 5, 8, "sqrt(k / m)"},
      {"damped_spring", "scenarios/damped_spring_under.toml", 0, 10, "sqrt(k / m)"},
      {"driven_spring", "scenarios/driven_spring.toml", 5, 5, "sqrt(k / m)"},
      {"spring_chain", "scenarios/spring_chain.toml", 3, 18, "2 sqrt(k / m)"},
      {"two_body_spring", "scenarios/two_body_spring.toml", 0, 10, "sqrt(k / m) with the anchors' levers",
       10},
      {"kepler", "scenarios/kepler.toml", 4, 14, "rate at the periapsis"},
      {"cork", "scenarios/water_step_force.toml", 0, 3,
       "sqrt(g / 1 m); each crossing of the surface magnifies", 10, 0, Forces::jumping},
      {"pendulum", "scenarios/physical_pendulum.toml", 4, 7,
       "swing at the bottom; its period depends on its energy", 2},
      {"heavy_top", "scenarios/heavy_top.toml", 2, 60, "spin"},
      {"bouncing", "scenarios/bouncing_sphere.toml", 0, 3, "sqrt(g / 1 m)"},
      {"two_walls", "scenarios/sphere_two_walls.toml", 0, 1, "speed / way"},
      {"head_on", "scenarios/two_sphere_head_on.toml", 0, 4, "speed / way"},
      {"oblique", "scenarios/two_sphere_oblique.toml", 0, 4, "speed / way"},
      {"rod_hit", "scenarios/rod_offcentre_hit.toml", 0, 4, "speed / way"},
      {"rough_ball", "scenarios/rough_ball_bounce.toml", 0, 12, "spin"},
      {"slide_to_roll", "scenarios/slide_to_roll.toml", 0, 10, "spin", 1, 0, Forces::kinked},
      {"box_edge", "scenarios/box_drop_edge.toml", 0, 12, "spin after the blow"},
      {"block_stops", "scenarios/block_stops.toml", 0, 3, "sqrt(g / 1 m)"},
      {"cube_stack", "scenarios/cube_stack.toml", 0.5, 3, "sqrt(g / 1 m)"},
      {"locked_post", "tests/mutants/scenes/locked_post.toml", 0, 4, "speed / way"},
      {"fast_ball", "tests/mutants/scenes/fast_ball.toml", 0, 50, "speed / way"},
      {"cradle", "scenarios/newtons_cradle.toml", 0, 1, "speed / way"},
  };
  return rows;
}

}  // namespace cylon::mutants
