// What engines may be off by at the stops and the dry frictions of joints.
#pragma once

#include "tests/conformance/adapters_fixture.h"

#include <cmath>
#include <cstdint>
#include <string_view>

namespace cylon::conformance {

inline bool locates_events(const Subject& subject) { return subject.order > 1; }

// What a first-order engine with stops at the ends of its steps may be off by, after an impact at speed v between two
// motions with the acceleration a, of which the second lasts s: late by up to dt it is v dt too far, and leaves at e v as
// much too late; Euler's own error is dt/2 times the change of the velocity, v before and a s after.
inline double on_the_grid(double e, double v, double a, double s, double dt) {
  return dt * ((1 + e) * v + (v + a * s) / 2);
}

// MuJoCo's stops and dry frictions are soft: of the reference acceleration  -b v - k r  with b = 2/(dmax T), k = 1/(dmax T)^2,
// T = 0.02 s (solref) and dmax = 0.95 they get the part d >= 0.9 (solimp; doc/computation.rst, "Solver parameters").
inline bool is_soft(const Subject& subject) { return std::string_view(subject.id).starts_with("mujoco"); }
inline constexpr double soft_time = 0.95 * 0.02;
// At rest under an acceleration a:  d k r = (1 - d) a.
inline double soft_stop(double a) { return (1 - 0.9) / 0.9 * soft_time * soft_time * a; }
// Slower than v = a/b a friction of a m is a damper of rate b: a way of v/b is left.
inline double soft_friction(double a) { return a * soft_time * soft_time / 4; }

// MuJoCo 3 ends where the cost  m (a' - a)^2/2  improves by less than 1e-8 of that of 1 m/s^2 (tolerance).
inline double slow_friction(const Subject& subject, double dt) {
  return std::string_view(subject.id) == "mujoco3" ? std::sqrt(2 * 1e-8) * dt : 0;
}
// crashcat leaves out turns of less than 1e-6 rad in a step (tests/reference/simulators/js), the last of those that end in
// rest:  w^2/(2 a) + w dt/2  of  w = 1e-6/dt.
inline double left_out(const Subject& subject, double a, double dt) {
  if (std::string_view(subject.id) != "crashcat") return 0;
  return std::pow(1e-6 / dt, 2) / (2 * a) + 1e-6 / 2;
}

// Two roundings of a coordinate below 1 in each step, and those of a joint.
inline double event_rounding(const Subject& subject, std::int64_t steps) {
  return (2 * static_cast<double>(steps) + subject.joint_units) * subject.unit();
}

}  // namespace cylon::conformance
