// What the families of limits share: the smallest scenes, and what of a run can break in any of them.
#pragma once

#include "harness/study/limits.h"

#include <cstdint>
#include <optional>
#include <string>

namespace cylon::study {

/// A ball of 1 kg and radius 0.1 m about the origin of nothing: no forces, no surroundings.
core::Scene lone_ball(const core::Vector3& position, const core::Vector3& velocity,
                      const core::Vector3& angular_velocity = core::Vector3::Zero());

/// A box of the given half extents and mass; it collides.
core::Body box_body(const std::string& name, double mass, const core::Vector3& half_extents,
                    const core::Vector3& position);

/// Adds a plane y >= 0 and a material of all pairs.
void add_floor(core::Scene&, double restitution, double friction);

/// Gravity of 9.81 m/s^2 along -y.
void add_gravity(core::Scene&);

/// "breaks: <words>".
Probed broken(std::string what);

/// The first recorded state with a number that is none, infinite, or beyond `bound` in SI units: finite
/// nonsense; or nothing.
std::optional<std::string> nonsense(const core::Recording&, double bound);

/// The largest distance of any body from where it was at the start, over the samples [m].
double strayed(const core::Recording&);

inline constexpr double gravity = 9.81;  // [m/s^2]

// The probes, by file.  Each takes the family's parameter.
Probed spring_probe(const Runner&, double w_dt);
Probed stiffness_probe(const Runner&, double k_dt2_over_m);
Probed damping_probe(const Runner&, double c_dt_over_m);
Probed spring_run_probe(const Runner&, double steps);
Probed turn_probe(const Runner&, double turn);
Probed tumble_probe(const Runner&, double turn);
Probed origin_probe(const Runner&, double distance);
Probed mass_ratio_probe(const Runner&, double ratio);
Probed stack_probe(const Runner&, double cubes);
Probed tunnel_probe(const Runner&, double speed);
Probed size_probe(const Runner&, double radius);
Probed low_restitution_probe(const Runner&, double restitution);
Probed high_restitution_probe(const Runner&, double loss);
Probed slow_bounce_probe(const Runner&, double speed);
Probed rest_run_probe(const Runner&, double steps);

}  // namespace cylon::study
