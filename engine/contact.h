// Contacts of a sphere with a plane or another sphere: gap, impact, and the row of a contact that rests.
// Frictionless, so an impact turns nothing.
#pragma once

#include "engine/constraint.h"

#include <cmath>

namespace cylon::engine {

/// A pair that may touch: a sphere (radius 0: a point) and a plane, solid where normal . x < offset, where
/// `other` is the world; else two spheres.
struct Contact {
  int body = 0;
  Real radius = 0;  ///< [m], >= 0.
  int other = fixed_world;
  Real other_radius = 0;              ///< [m], >= 0.
  Vector3 normal = Vector3::UnitY();  ///< Of the plane, unit.
  Real offset = 0;                    ///< Of the plane [m].
  Real restitution = 0;               ///< [0, 1]
  bool resting = false;               ///< Holds as a constraint while it is pressed.
};

/// How near the surfaces of a contact are, and how that changes.
struct Approach {
  Real gap = 0;             ///< g [m]; negative inside.
  Real speed = 0;           ///< u = dg/dt [m/s]; negative when approaching.
  Real curvature = 0;       ///< The part of d^2g/dt^2 that the velocities alone make [m/s^2].
  Vector3 normal;           ///< n, from `other` to `body`.
  Real gap_rounding = 0;    ///< |g| below this is contact [m].
  Real speed_rounding = 0;  ///< |u| below this is none [m/s].
};

/// Plane:  g = n.p - offset - r,  u = n.v.
/// Sphere: d = p_a - p_b, n = d/|d|,  g = |d| - r_a - r_b,  u = n.(v_a - v_b),  g'' = n.(a_a - a_b) + (|v|^2
/// - u^2)/|d|.
inline Approach approach(const Contact& contact, const std::vector<Body>& bodies,
                         const std::vector<Motion>& motion) {
  constexpr Real ulp = 2.3e-16, least_speed = 1e-15;  // the latter: rounding of 1 m/s, where all else is zero
  const auto a = static_cast<std::size_t>(contact.body);
  const Vector3 p_a = motion[a].position, v_a = velocity(bodies[a], motion[a]);
  Approach result;
  if (contact.other == fixed_world) {
    result.normal = contact.normal;
    result.gap = contact.normal.dot(p_a) - contact.offset - contact.radius;
    result.speed = contact.normal.dot(v_a);
    result.gap_rounding = 8 * ulp * (p_a.norm() + std::abs(contact.offset) + contact.radius);
    result.speed_rounding = 8 * ulp * v_a.norm() + least_speed;
  } else {
    const auto b = static_cast<std::size_t>(contact.other);
    const Vector3 p_b = motion[b].position, v_b = velocity(bodies[b], motion[b]);
    const Vector3 d = p_a - p_b, v = v_a - v_b;
    const Real distance = d.norm();
    result.normal = distance > 0 ? Vector3(d / distance) : Vector3(Vector3::UnitY());
    result.gap = distance - contact.radius - contact.other_radius;
    result.speed = result.normal.dot(v);
    result.curvature = distance > 0 ? (v.squaredNorm() - result.speed * result.speed) / distance : 0;
    result.gap_rounding = 8 * ulp * (p_a.norm() + p_b.norm() + contact.radius + contact.other_radius);
    result.speed_rounding = 8 * ulp * (v_a.norm() + v_b.norm()) + least_speed;
  }
  return result;
}

/// Changes the momenta so that the surfaces separate with `separation` >= 0 [m/s].
///   J = (separation - u) / (1/m_a + 1/m_b),  K_a += J n,  K_b -= J n
/// Newton's law is separation = -restitution u: seed eq. 86-92 with the normal components only (errata 24), K
/// + J (errata 25), m_b -> infinity for planes and locked bodies (errata 26) and a positive sign (errata 27).
/// Through the centres of spheres r x n = 0: no angular impulse.
inline void strike(const Contact& contact, const Approach& now, Real separation,
                   const std::vector<Body>& bodies, std::vector<Motion>& motion) {
  const auto a = static_cast<std::size_t>(contact.body), b = static_cast<std::size_t>(contact.other);
  Real inverse_mass = bodies[a].inverse_mass;
  if (contact.other != fixed_world) inverse_mass += bodies[b].inverse_mass;
  if (inverse_mass == 0) return;
  const Vector3 impulse = (separation - now.speed) / inverse_mass * now.normal;
  if (!bodies[a].locked) motion[a].momentum += impulse;
  if (contact.other != fixed_world && !bodies[b].locked) motion[b].momentum -= impulse;
}

/// Adds the row that keeps a resting contact closed; it only pushes.
inline void add_rows(const Contact& contact, const std::vector<Body>& bodies,
                     const std::vector<Motion>& motion, std::vector<Row>& rows) {
  const Approach now = approach(contact, bodies, motion);
  Row row;
  row.body = contact.body;
  row.to = contact.other;
  row.direction = now.normal;
  row.bias = now.curvature;
  row.offset = now.gap;
  row.pushes_only = true;
  rows.push_back(row);
}

}  // namespace cylon::engine
