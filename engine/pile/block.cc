#include "engine/pile/block.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace cylon::engine::pile {
namespace {

Matrix3 skew(const Vector3& r) {
  Matrix3 m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

// What J_n becomes for the velocity u_n along the normal.
Real along_normal(const Block& block, Real j, Real u) {
  if (block.kind == Block::Kind::soft) {  // with u = u_free + j/mass
    const Real yield = block.mass > 0 ? 1 / block.mass : 0;
    return (block.push - block.drag * (u - j * yield)) / (1 + block.drag * yield);
  }
  if (block.kind == Block::Kind::rub) return std::clamp(j - block.mass * u, -block.limit, block.limit);
  return std::max(j + block.mass * (block.target - u), Real(0));
}

// Of a body that slips friction is against u; steps by the block's mass, which turns u, would end along that.
// ab/(a + b) of the two eigenvalues across the normal: no more than the lesser.
Real slip_mass(const Matrix3& block_mass) {
  const Real sum = block_mass.trace();
  return sum > 0 ? (sum * sum - block_mass.squaredNorm()) / (2 * sum) : 0;
}

}  // namespace

void set_effective_mass(Block& block, const std::vector<Mover>& movers) {
  Matrix3 k = Matrix3::Zero();
  const auto add = [&](int body, const Vector3& arm) {
    if (body == fixed_world) return;
    const Mover& m = movers[static_cast<std::size_t>(body)];
    if (block.angular) {
      k += m.inverse_inertia;
      return;
    }
    Matrix3 turn = skew(arm);
    turn.diagonal().array() += block.pitch;
    k += m.inverse_mass * Matrix3::Identity() + turn * m.inverse_inertia * turn.transpose();
  };
  add(block.a, block.arm), add(block.b, block.to_arm);
  Matrix3 space = block.space;
  if (block.kind != Block::Kind::hold) {
    const Real along = block.normal.dot(k * block.normal);
    block.mass = along > 0 ? 1 / along : 0;
    if (block.is_along_normal()) return;
    space = Matrix3::Identity() - block.normal * block.normal.transpose();
  }
  // The complement gets a weight of the size of K, so that the inverse is as well conditioned as K is.
  const Real size = k.trace() > 0 ? k.trace() : 1;
  const Matrix3 whole = space * k * space + size * (Matrix3::Identity() - space);
  block.block_mass = k.trace() > 0 ? Matrix3(space * whole.inverse() * space) : Matrix3(Matrix3::Zero());
}

void relax(Block& block, std::vector<Mover>& movers) {
  const Vector3 before = block.impulse;
  if (block.is_along_normal()) {
    const Vector3& n = block.normal;
    const Real j = n.dot(before), to = along_normal(block, j, n.dot(relative_velocity(block, movers)));
    push(block, (to - j) * n, movers);
    block.impulse = to * n;
  } else if (block.kind == Block::Kind::contact) {
    const Vector3& n = block.normal;
    const Real u_n = n.dot(relative_velocity(block, movers)), j_n = n.dot(before);
    const Real normal = along_normal(block, j_n, u_n);
    push(block, (normal - j_n) * n, movers);
    const Vector3 across = before - j_n * n;
    Vector3 u = relative_velocity(block, movers);
    u -= n.dot(u) * n;
    Vector3 t = across - block.block_mass * u;
    const Real limit = block.friction * normal;
    if (t.norm() > limit) {
      t = across - slip_mass(block.block_mass) * u;
      if (limit < t.norm()) t *= limit / t.norm();
    }
    t -= n.dot(t) * n;
    push(block, t - across, movers);
    block.impulse = normal * n + t;
  } else {
    const Vector3 change = -(block.block_mass * relative_velocity(block, movers));
    push(block, change, movers);
    block.impulse += change;
  }
}

// The change of relax(), its parts along and across the normal each from the velocity now, as a velocity.
Real unmet(const Block& block, const std::vector<Mover>& movers) {
  const Vector3 u = relative_velocity(block, movers);
  if (block.kind == Block::Kind::hold) return (block.space * u).norm();
  const Vector3& n = block.normal;
  const Real u_n = n.dot(u), j_n = n.dot(block.impulse);
  if (!(block.mass > 0)) return 0;
  const Real normal = along_normal(block, j_n, u_n);
  if (block.is_along_normal()) return std::abs(normal - j_n) / block.mass;
  const Vector3 across = block.impulse - j_n * n, u_t = u - u_n * n;
  const Real limit = block.friction * normal, slips = slip_mass(block.block_mass);
  Real along = u_t.norm();
  if (const Vector3 sticks = across - block.block_mass * u_t; sticks.norm() > limit) {
    Vector3 t = across - slips * u_t;
    if (limit < t.norm()) t *= limit / t.norm();
    along = slips > 0 ? (t - across).norm() / slips : Real(0);
  }
  return std::hypot((normal - j_n) / block.mass, along);
}

}  // namespace cylon::engine::pile
