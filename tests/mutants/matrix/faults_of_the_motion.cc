#include "tests/mutants/matrix/decorator.h"

#include <algorithm>
#include <cmath>

namespace cylon::mutants {
namespace {

using core::BodyState;
using core::State;
using core::Vector3;

Mask tampers(std::function<bool(const Moment&, State&)> change) { return {.tampers = std::move(change)}; }

// Body by body; whether any was changed.
Mask each(const std::function<bool(const Moment&, std::size_t, BodyState&)>& change) {
  return tampers([change](const Moment& m, State& state) {
    bool changed = false;
    for (std::size_t i = 0; i < state.size(); ++i) changed = change(m, i, state[i]) || changed;
    return changed;
  });
}

// A blow by a plane in this step: the plane's normal, or nothing.
const core::Plane* struck_by(const Moment& m, std::size_t body, const BodyState& now) {
  if (!m.scene.bodies[body].collide) return nullptr;
  for (const core::Plane& plane : m.scene.planes)
    if (plane.normal.dot(m.before[body].velocity) < -1e-3 && plane.normal.dot(now.velocity) > 1e-3)
      return &plane;
  return nullptr;
}

// A change of velocity that weight alone does not make.
bool deflected(const Moment& m, std::size_t i, const BodyState& now) {
  return (now.velocity - m.before[i].velocity).norm() > 20 * m.dt && now.velocity.norm() > 0;
}

// After each blow by a plane.
Mask at_blows(const std::function<bool(const Moment&, std::size_t, const core::Plane&, BodyState&)>& change) {
  return each([change](const Moment& m, std::size_t i, BodyState& s) {
    const core::Plane* plane = struck_by(m, i, s);
    return plane && change(m, i, *plane, s);
  });
}

double clamp(Vector3& v, double most) {
  const double size = v.norm();
  if (size > most) v *= most / size;
  return size - most;
}

// Friction of a sphere that slid through a blow: Coulomb's cone gives mu J_n along the slip, a pyramid on the
// axes x and z up to sqrt(2) times that.
bool pyramid(const Moment& m, std::size_t i, const core::Plane& plane, BodyState& s) {
  const auto* sphere = std::get_if<core::Sphere>(&m.scene.bodies[i].shape);
  if (!sphere) return false;
  const core::Body& body = m.scene.bodies[i];
  const Vector3 J = body.mass * (s.velocity - m.before[i].velocity);
  const double normal = plane.normal.dot(J);
  const Vector3 tangential = J - normal * plane.normal;
  const double most = std::max(std::abs(tangential.x()), std::abs(tangential.z()));
  const Vector3 arm = -sphere->radius * plane.normal;
  const Vector3 slip = s.velocity + s.angular_velocity.cross(arm);
  const bool slides = (slip - plane.normal.dot(slip) * plane.normal).norm() > 1e-6;
  if (!slides || most == 0) return false;
  const Vector3 more = tangential * (tangential.norm() / most - 1);
  s.velocity += more / body.mass;
  s.angular_velocity += core::world_inertia(body, s.orientation).inverse() * arm.cross(more);
  return true;
}

}  // namespace

std::vector<MaskedRow> faults_of_the_motion() {
  return {
      {"frozen",
       "the state of the start for ever",
       "projectile",
       "position follows",
       {.skips = [](std::int64_t) { return true; }}},
      {"speed limit", "4 m/s", "bouncing", "position follows",
       each([](const Moment&, std::size_t, BodyState& s) { return clamp(s.velocity, 4) > 1e-9; })},
      {"spin limit", "8 rad/s", "rough_ball", "angular_velocity follows",
       each([](const Moment&, std::size_t, BodyState& s) { return clamp(s.angular_velocity, 8) > 1e-9; })},
      {"sleeps too early", "below 0.2 m/s", "block_stops", "position follows",
       each([](const Moment& m, std::size_t i, BodyState& s) {
         const bool slows = s.velocity.norm() < m.before[i].velocity.norm();
         if (m.scene.planes.empty() || !slows || s.velocity.norm() > 0.2 || s.velocity.norm() == 0)
           return false;
         s.velocity.setZero();
         return true;
       })},
      {"restitution threshold", "no bounce below 1 m/s", "bouncing", "position follows",
       at_blows([](const Moment&, std::size_t, const core::Plane& plane, BodyState& s) {
         const double out = plane.normal.dot(s.velocity);
         if (out >= 1) return false;
         s.velocity -= out * plane.normal;
         return true;
       })},
      {"restitution after gravity", "the target contains the step's own fall", "bouncing", "position follows",
       at_blows([](const Moment& m, std::size_t, const core::Plane& plane, BodyState& s) {
         s.velocity += 0.8 * 9.81 * m.dt * plane.normal;
         return true;
       })},
      {"Baumgarte", "the depth is pushed out by speed", "bouncing", "event follows",
       at_blows([](const Moment& m, std::size_t i, const core::Plane& plane, BodyState& s) {
         s.velocity += 0.01 * plane.normal.dot(-m.before[i].velocity) * plane.normal;
         return true;
       })},
      {"friction pyramid", "in place of the cone", "rough_ball", "velocity follows", at_blows(pyramid)},
      {"blows spin", "a smooth floor turns what lands", "bouncing", "angular_velocity",
       at_blows([](const Moment&, std::size_t, const core::Plane&, BodyState& s) {
         s.angular_velocity.z() += 1e-6;
         return true;
       })},
      {"gains at each blow", "a thousandth of its speed", "bouncing", "position follows",
       at_blows([](const Moment&, std::size_t, const core::Plane&, BodyState& s) {
         s.velocity *= 1 + 1e-3;
         return true;
       })},
      {"blows turn aside", "a thousandth of the speed goes sideways", "bouncing", "linear_momentum",
       at_blows([](const Moment&, std::size_t, const core::Plane& plane, BodyState& s) {
         s.velocity += 1e-3 * s.velocity.norm() * plane.normal.unitOrthogonal();
         return true;
       })},
      {"thermostat", "blows that lose energy get it back", "bouncing", "position follows",
       at_blows([](const Moment& m, std::size_t i, const core::Plane&, BodyState& s) {
         s.velocity *= m.before[i].velocity.norm() / s.velocity.norm();
         return true;
       })},
      {"thermostat of the third", "the energy that a blow takes goes to another body", "room",
       "energy never rises", tampers([](const Moment& m, State& state) {
         if (state.size() < 3) return false;
         for (std::size_t i = 0; i < state.size(); ++i)
           if (struck_by(m, i, state[i])) {
             BodyState& other = state[(i + 1) % state.size()];
             other.velocity *= 1.05;
             return true;
           }
         return false;
       })},
      {"blows favour one axis", "the speed stays", "gas_mixture", "energy_share as expected, x",
       each([](const Moment& m, std::size_t i, BodyState& s) {
         if (!deflected(m, i, s)) return false;
         const double speed = s.velocity.norm();
         s.velocity.x() *= 1.5;
         s.velocity *= speed / s.velocity.norm();
         return true;
       })},
      {"thermostat of a crowd", "those that were struck in a step get the same energy, all keep their sum",
       "gas_mixture", "energy_share as expected", tampers([](const Moment& m, State& state) {
         double sum = 0;
         std::vector<std::size_t> struck;
         for (std::size_t i = 0; i < state.size(); ++i)
           if (deflected(m, i, state[i])) {
             struck.push_back(i);
             sum += m.scene.bodies[i].mass * state[i].velocity.squaredNorm();
           }
         for (const std::size_t i : struck)
           state[i].velocity *= std::sqrt(sum / static_cast<double>(struck.size()) / m.scene.bodies[i].mass) /
                                state[i].velocity.norm();
         return struck.size() > 1;
       })},
      {"leaks 1e-9 a step", "of every speed", "spring_zero", "theory: energy conserved",
       each([](const Moment&, std::size_t, BodyState& s) {
         s.velocity *= 1 - 1e-9;
         return true;
       })},
      {"gains 1e-9 a step", "of every speed", "spring_zero", "theory: energy conserved",
       each([](const Moment&, std::size_t, BodyState& s) {
         s.velocity *= 1 + 1e-9;
         return true;
       })},
      {"keeps |w|", "whatever its direction does", "dzhanibekov", "energy",
       each([](const Moment& m, std::size_t i, BodyState& s) {
         const double before = m.before[i].angular_velocity.norm();
         if (!(before > 0) || m.step < 2) return false;
         s.angular_velocity *= before / s.angular_velocity.norm();
         return true;
       })},
      {"wakes late", "velocities stand still for ten steps after the first", "spring_zero",
       "theory: position follows", tampers([](const Moment& m, State& state) {
         if (m.step < 2 || m.step > 11) return false;
         state = m.before;
         return true;
       })},
      {"drifts with the step", "1e-9 m aside a step", "spring_orbit", "theory: position follows",
       each([](const Moment&, std::size_t, BodyState& s) {
         s.position.x() += 1e-9;
         return true;
       })},
      {"pushed out", "a millimetre after each blow", "two_walls", "position follows",
       at_blows([](const Moment&, std::size_t, const core::Plane& plane, BodyState& s) {
         s.position += 1e-3 * plane.normal;
         return true;
       })},
      {"forgets its fractions", "positions are kept in float every 64 steps", "spring_zero",
       "theory: position follows", tampers([](const Moment& m, State& state) {
         if (m.step % 64) return false;
         for (BodyState& s : state) s.position = s.position.cast<float>().cast<double>();
         return true;
       })},
      {"kicked once", "1e-6 m/s at the 100th step", "spring_orbit", "theory: position follows",
       each([](const Moment& m, std::size_t, BodyState& s) {
         if (m.step == 100) s.velocity.x() += 1e-6;
         return m.step == 100;
       })},
      {"angular momentum traded", "each tenth of a second w shrinks by 1e-7", "hammer",
       "theory: angular_momentum conserved", each([](const Moment& m, std::size_t, BodyState& s) {
         if (m.step % 100) return false;
         s.angular_velocity *= 1 - 1e-7;
         return true;
       })},
  };
}

}  // namespace cylon::mutants
