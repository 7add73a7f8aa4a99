// One function per file of this folder; what each serves stands in its file's head and in catalogue.cc.
#pragma once

#include "harness/core/truth.h"

namespace cylon::exact {

core::Truth projectile(const core::Scene&, double horizon);
core::Truth bouncing_sphere(const core::Scene&, double horizon);
core::Truth box_drop_edge(const core::Scene&, double horizon);
core::Truth rod_offcentre_hit(const core::Scene&, double horizon);
core::Truth rough_sphere(const core::Scene&, double horizon);
core::Truth sliding_block(const core::Scene&, double horizon);
core::Truth sphere_row(const core::Scene&, double horizon);
core::Truth sphere_two_walls(const core::Scene&, double horizon);
core::Truth two_sphere_oblique(const core::Scene&, double horizon);
core::Truth spring_zero_length(const core::Scene&, double horizon);
core::Truth spring_orbit(const core::Scene&, double horizon);
core::Truth free_symmetric_top(const core::Scene&, double horizon);
core::Truth free_asymmetric_top(const core::Scene&, double horizon);
core::Truth heavy_top(const core::Scene&, double horizon);
core::Truth projectile_drag(const core::Scene&, double horizon);
core::Truth rocket(const core::Scene&, double horizon);
core::Truth accretion(const core::Scene&, double horizon);
core::Truth damped_spring(const core::Scene&, double horizon);
core::Truth driven_spring(const core::Scene&, double horizon);
core::Truth damped_free_top(const core::Scene&, double horizon);
core::Truth jointed_body(const core::Scene&, double horizon);
core::Truth kepler(const core::Scene&, double horizon);
core::Truth limited_pendulum(const core::Scene&, double horizon);
core::Truth physical_pendulum(const core::Scene&, double horizon);
core::Truth spherical_pendulum(const core::Scene&, double horizon);
core::Truth statics(const core::Scene&, double horizon);
core::Truth spring_chain(const core::Scene&, double horizon);
core::Truth rotating_frame(const core::Scene&, double horizon);
core::Truth water_step_force(const core::Scene&, double horizon);
core::Truth seed_airplane(const core::Scene&, double horizon);

}  // namespace cylon::exact
