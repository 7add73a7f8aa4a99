#include "engine/ballistic/cluster.h"

#include <limits>

namespace cylon::engine::ballistic {

namespace {

// One contact against the present velocities; returns how much it changed a speed [m/s].
Real relax(Touch& c, Side& a, Side& b) {
  const Real inverse_mass = a.inverse_mass + b.inverse_mass;
  const Real u = c.n.dot(a.velocity - b.velocity);
  const Real normal = std::max(Real(0), c.normal - (u - c.wanted) / inverse_mass);
  const Real change = normal - c.normal;
  c.normal = normal;
  a.push(change * c.n);
  b.push(-change * c.n);
  Real moved = std::abs(change) * inverse_mass;
  if (c.material.friction > 0) {
    const Real k = a.tangential() + b.tangential();
    const Vector3 drive = slip(a, b, c.n) - k * c.tangential;  // the slip that there would be without it
    const Vector3 tangential = friction_impulse(drive, c.n, k, c.material.friction, c.normal);
    const Vector3 step = tangential - c.tangential;
    c.tangential = tangential;
    a.rub(step, c.n);
    b.rub(-step, -c.n);
    moved += step.norm() * k;
  }
  return moved;
}

}  // namespace

bool strike_at_once(std::vector<Touch>& touches, std::vector<Side>& sides) {
  constexpr int most_sweeps = 20000;
  Real scale = 0;
  for (const Touch& c : touches) {
    const auto& [a, b] = std::pair(c.a, c.b);
    scale = std::max(scale, sides[static_cast<std::size_t>(a)].velocity.norm() +
                                sides[static_cast<std::size_t>(b)].velocity.norm());
  }
  const Real settled = 8 * epsilon * scale;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    Real moved = 0;
    for (Touch& c : touches)
      moved = std::max(moved,
                       relax(c, sides[static_cast<std::size_t>(c.a)], sides[static_cast<std::size_t>(c.b)]));
    if (moved <= settled) return true;
  }
  return false;
}

}  // namespace cylon::engine::ballistic
