#include "tests/mutants/matrix/decorator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::mutants {
namespace {

using core::BodyState;
using core::Quaternion;
using core::Scene;
using core::State;
using core::Vector3;

Mask reading(std::function<void(const Moment&, State&)> change) { return {.reading = std::move(change)}; }

// After the first step, so that reading back the start shows nothing.
Mask each(const std::function<void(const Moment&, BodyState&)>& change) {
  return reading([change](const Moment& m, State& state) {
    if (m.step == 0) return;
    for (BodyState& s : state) change(m, s);
  });
}

Mask reacting(std::function<void(core::Reaction&)> change) { return {.reacting = std::move(change)}; }
Mask telling(std::function<void(core::Contact&)> change) { return {.telling = std::move(change)}; }

Vector3 to_float(const Vector3& v) { return v.cast<float>().cast<double>(); }

void reverse(BodyState& s) { s.velocity = -s.velocity, s.angular_velocity = -s.angular_velocity; }

// Runs with all velocities turned round, and tells them as they should start.
Mask backwards() {
  return {.scene =
              [](Scene& s) {
                for (core::Body& b : s.bodies) reverse(b.initial);
              },
          .reading =
              [](const Moment&, State& state) {
                for (BodyState& s : state) reverse(s);
              }};
}

// Turns about -w, and tells w.
Mask left_handed() {
  return {.scene =
              [](Scene& s) {
                for (core::Body& b : s.bodies) b.initial.angular_velocity *= -1;
              },
          .reading =
              [](const Moment&, State& state) {
                for (BodyState& s : state) s.angular_velocity *= -1;
              }};
}

double spread(const State& state) {
  double size = 0;
  for (const BodyState& s : state) size = std::max(size, s.position.norm());
  return size;
}

}  // namespace

std::vector<MaskedRow> faults_of_the_reading() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  return {
      {"wrong start", "a tenth of a millimetre aside", "projectile", "read back",
       reading([](const Moment&, State& state) {
         for (BodyState& s : state) s.position.z() += 1e-4;
       })},
      {"offset", "a tenth of a millimetre aside once it moves", "projectile", "theory: position follows",
       each([](const Moment&, BodyState& s) { s.position.x() += 1e-4; })},
      {"time reversed", "the right orbit, the other way round", "spring_zero", "position follows",
       backwards()},
      {"left-handed", "turns about -w", "constant_spin", "orientation follows", left_handed()},
      {"mirrored", "z is -z", "spring_zero", "position follows",
       each([](const Moment&, BodyState& s) { s.position.z() *= -1, s.velocity.z() *= -1; })},
      {"conjugate quaternion", "orientations are world to body", "constant_spin", "orientation follows",
       each([](const Moment&, BodyState& s) { s.orientation = s.orientation.conjugate(); })},
      {"quaternion order", "(x, y, z, w) told as (w, x, y, z)", "constant_spin", "orientation follows",
       each([](const Moment&, BodyState& s) {
         const Quaternion q = s.orientation;
         s.orientation = Quaternion(q.x(), q.y(), q.z(), q.w());
       })},
      {"quaternion grows", "not normalised, 1e-9 a step", "constant_spin", "theory: orientation follows",
       each([](const Moment& m, BodyState& s) {
         s.orientation.coeffs() *= 1 + 1e-9 * static_cast<double>(m.step);
       })},
      {"w in body axes", "and not of the world", "damped_top", "angular_velocity follows",
       each([](const Moment&, BodyState& s) {
         s.angular_velocity = s.orientation.conjugate() * s.angular_velocity;
       })},
      {"one step late", "the state of the step before", "projectile", "theory: position follows",
       reading([](const Moment& m, State& state) { state = m.before; })},
      {"velocities half a step late", "a staggered integrator's", "projectile", "theory: velocity follows",
       reading([](const Moment& m, State& state) {
         for (std::size_t i = 0; i < state.size(); ++i)
           state[i].velocity = (state[i].velocity + m.before[i].velocity) / 2;
       })},
      {"told in float", "positions and velocities", "projectile", "theory: position follows",
       each([](const Moment&, BodyState& s) {
         s.position = to_float(s.position), s.velocity = to_float(s.velocity);
       })},
      {"quaternions in float", "and normalised again", "constant_spin", "theory: orientation follows",
       each([](const Moment&, BodyState& s) {
         for (double& c : s.orientation.coeffs()) c = static_cast<float>(c);
         s.orientation.normalize();
       })},
      {"inverted between samples", "velocities turn round at odd steps", "projectile",
       "theory: velocity follows", each([](const Moment& m, BodyState& s) {
         if (m.step % 2) reverse(s);
       })},
      {"orientation a step late", "the rest is on time", "constant_spin", "theory: orientation follows",
       reading([](const Moment& m, State& state) {
         for (std::size_t i = 0; i < state.size(); ++i) state[i].orientation = m.before[i].orientation;
       })},
      {"spin a step late", "the rest is on time", "damped_top", "theory: angular_velocity follows",
       reading([](const Moment& m, State& state) {
         for (std::size_t i = 0; i < state.size(); ++i)
           state[i].angular_velocity = m.before[i].angular_velocity;
       })},
      {"bodies in the wrong order", "the last one is told first", "spring_chain", "position follows",
       reading([](const Moment& m, State& state) {
         if (m.step > 0) std::reverse(state.begin(), state.end());
       })},
      {"the first for the second", "two rows are one", "spring_chain", "position follows",
       reading([](const Moment& m, State& state) {
         if (m.step > 0 && state.size() > 1) state[1] = state[0];
       })},
      {"degrees", "w in degrees a second", "damped_top", "angular_velocity follows",
       each([](const Moment&, BodyState& s) { s.angular_velocity *= 180 / 3.14159265358979; })},
      {"rounded to a micrometre", "as a file format does", "projectile", "theory: position follows",
       each([](const Moment&, BodyState& s) { s.position = (s.position * 1e6).array().round() * 1e-6; })},
      {"speeds rounded to 1e-6", "as a file format does", "tilted_gravity", "theory: velocity follows",
       each([](const Moment&, BodyState& s) { s.velocity = (s.velocity * 1e6).array().round() * 1e-6; })},
      {"wraps at four metres", "a world without an edge", "rocket", "velocity follows",
       each([](const Moment&, BodyState& s) { s.velocity = s.velocity.cwiseMin(4).cwiseMax(-4); })},
      {"contact forces a percent off", "all of them, as they are told", "box_on_slab", "momentum_balance",
       telling([](core::Contact& c) {
         if (c.impulse) *c.impulse *= 1.01;
       })},
      {"contact points at the corner", "where the force acts is told a millimetre aside", "box_on_slab",
       "angular_momentum_balance", telling([](core::Contact& c) { c.point.x() += 1e-3; })},
      {"joint forces of the other body", "the opposite of each, as it is told", "hinge_tilted",
       "momentum_balance", reacting([](core::Reaction& r) { r.impulse *= -1; })},
      {"joint forces five percent off", "all of them, as they are told", "hinge_tilted", "momentum_balance",
       reacting([](core::Reaction& r) { r.impulse *= 1.05; })},
      {"joint moments left out", "of what is welded the force alone is told", "welded_beams",
       "angular_momentum_balance", reacting([](core::Reaction& r) { r.moment.setZero(); })},
      {"joint forces of the next joint", "those of each joint are told of another", "hanging_chain",
       "joint_force follows statics, hook", reacting([](core::Reaction& r) { r.joint = (r.joint + 1) % 3; })},
      {"joint forces and torques of the other body", "the opposite of each, as they are told",
       "hanging_chain", "joint_force follows statics, between",
       reacting([](core::Reaction& r) { r.impulse *= -1, r.moment *= -1; })},
      {"joint torques about another point", "the force is told a centimetre aside", "welded_beams",
       "joint_torque follows statics", reacting([](core::Reaction& r) { r.point.x() += 1e-2; })},
      {"joint torques of the other body", "of what swings the torque alone has the other sign", "hinge_load",
       "joint_torque follows physical_pendulum, hinge", reacting([](core::Reaction& r) { r.moment *= -1; })},
      {"joint forces of a swing five percent off", "as they are told", "hinge_load",
       "joint_force follows physical_pendulum, hinge",
       reacting([](core::Reaction& r) { r.impulse *= 0.95; })},
      {"friction told backwards", "on the other body", "block_slides", "momentum_balance",
       telling([](core::Contact& c) {
         if (c.friction) *c.friction *= -1;
       })},
      {"position extrapolated", "half a step ahead along v", "spring_zero", "theory: position follows",
       each([](const Moment& m, BodyState& s) { s.position += 0.5 * m.dt * s.velocity; })},
      {"smoothed", "the mean of two steps", "spring_zero", "theory: position follows",
       reading([](const Moment& m, State& state) {
         for (std::size_t i = 0; i < state.size(); ++i)
           state[i].position = (state[i].position + m.before[i].position) / 2;
       })},
      {"ripples", "1e-7 m from step to step", "projectile", "theory: position follows",
       each([](const Moment& m, BodyState& s) { s.position.x() += m.step % 2 ? 1e-7 : -1e-7; })},
      {"grows", "lengths stretch by 1e-8 a step", "spring_zero", "theory: position follows",
       each([](const Moment& m, BodyState& s) { s.position *= 1 + 1e-8 * static_cast<double>(m.step); })},
      {"far bodies coarsen", "positions in 2^-24 of the farthest, beyond 1 km", "far body", "motion",
       reading([](const Moment&, State& state) {
         const double size = spread(state), grain = std::ldexp(size, -24);
         if (size > 1e3)
           for (BodyState& s : state) s.position = (s.position / grain).array().round() * grain;
       })},
      {"finite nonsense", "a kilometre away after fifty steps", "projectile", "position follows",
       each([](const Moment& m, BodyState& s) {
         if (m.step > 50) s.position = {1e3, 1e3, 1e3};
       })},
      {"NaN late", "a velocity at the 700th step", "projectile", "finite",
       each([](const Moment& m, BodyState& s) {
         if (m.step >= 700) s.velocity.x() = nan;
       })},
      {"infinite", "a position at the 700th step", "projectile", "finite",
       each([](const Moment& m, BodyState& s) {
         if (m.step >= 700) s.position.y() = inf;
       })},
      {"never the same", "a part in 1e14 that no run repeats", "same again", "motion",
       each([](const Moment& m, BodyState& s) {
         const double share = static_cast<double>(m.run) * 0.6180339887498949;
         s.position.x() += 1e-14 * (share - std::floor(share));
       })},
      {"sinks", "a hundredth of a millimetre a second", "cube_stack", "theory: position conserved",
       each([](const Moment& m, BodyState& s) {
         s.position.y() -= 1e-5 * static_cast<double>(m.step) * m.dt;
       })},
      {"steady offset of w", "a gyroscope's bias, 1e-6 rad/s", "damped_top",
       "theory: angular_velocity follows",
       each([](const Moment&, BodyState& s) { s.angular_velocity.z() += 1e-6; })},
  };
}

}  // namespace cylon::mutants
