#include "engine/pile/crowd.h"

#include "engine/rotation.h"

#include <algorithm>
#include <cmath>

namespace cylon::engine::pile {
namespace {

// A contact that overlaps is a damped spring of the angular frequency `frequency`/h, implicit in time:
//   dj = share (target - u_n)/K - bleed j,  target = rate (overlap - slop)
// Without its damping the impulses that remove overlaps keep towers of boxes rocking.  E. Catto, Soft
// constraints, GDC 2011.
struct Stiffness {
  Real rate, share, bleed;  // [1/s], -, -
};
constexpr Real frequency = Real(1.2), damping_ratio = 5;

Stiffness stiffness(Real h) {
  constexpr Real a = 2 * damping_ratio + frequency, b = frequency * a;
  return {frequency / (h * a), b / (1 + b), 1 / (1 + b)};
}

// K d = d/m + (I^-1 (r x d)) x r
Quad response(const QuadMatrix& inverse_inertia, Real inverse_mass, const Quad& arm, const Quad& d) {
  return inverse_mass * d + cross(inverse_inertia * cross(arm, d), arm);
}

}  // namespace

void Crowd::take(const Group& group, const Step& step, const std::vector<Body>& bodies,
                 const std::vector<Mover>& movers, const std::vector<Block>& blocks,
                 const std::vector<Motion>& motions) {
  place_.resize(bodies.size());
  body_.clear(), members_.clear(), spins_.clear();
  for (const int body : group.bodies) {
    const Mover& m = movers[index(body)];
    place_[index(body)] = -1;
    if (!moves(m)) continue;
    place_[index(body)] = static_cast<int>(members_.size());
    body_.push_back(body);
    members_.push_back({quad(m.v), quad(m.w), Quad{}, Quad{}, quads(m.inverse_inertia), m.inverse_mass});
    spins_.push_back(m.w);
  }
  const Real share = 1 / static_cast<Real>(step.parts);
  pairs_.clear(), spots_.clear(), block_.clear();
  for (std::size_t from = 0, to = 0; from < group.blocks.size(); from = to) {
    const Block& first = blocks[index(group.blocks[from])];
    const auto same = [&](const Block& b) {
      return b.a == first.a && b.b == first.b && b.plane == first.plane && b.normal == first.normal;
    };
    while (to < group.blocks.size() && same(blocks[index(group.blocks[to])])) ++to;
    add_pair(group, from, to, share, blocks, motions);
  }
}

void Crowd::add_pair(const Group& group, std::size_t from, std::size_t to, Real share,
                     const std::vector<Block>& blocks, const std::vector<Motion>& motions) {
  const Block& first = blocks[index(group.blocks[from])];
  const int a = place_[index(first.a)], b = first.b == fixed_world ? -1 : place_[index(first.b)];
  const bool turned = a < 0;
  Pair pair;
  pair.a = turned ? b : a, pair.b = turned ? -1 : b;
  pair.first = spots_.size(), pair.count = static_cast<int>(to - from);
  pair.sign = turned ? Real(-1) : Real(1);
  const Vector3 n = pair.sign * first.normal;
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  const Vector3 t1 = n.cross(Vector3::Unit(least)).normalized(), t2 = n.cross(t1);
  pair.n = quad(n), pair.t1 = quad(t1), pair.t2 = quad(t2);
  pair.friction = first.friction;
  const Matrix3 r_a = rotation_matrix(motions[index(first.a)].orientation);
  const Matrix3 r_b = first.b == fixed_world ? Matrix3(Matrix3::Identity())
                                             : rotation_matrix(motions[index(first.b)].orientation);
  for (std::size_t k = from; k < to; ++k) {
    const Block& block = blocks[index(group.blocks[k])];
    Spot spot;
    const Vector3 arm = r_a * block.anchor, to_arm = r_b * block.to_anchor;
    const Vector3 to_centre =
        first.b == fixed_world ? Vector3(Vector3::Zero()) : motions[index(first.b)].position;
    spot.gap = block.gap + first.normal.dot((motions[index(first.a)].position - to_centre) + (arm - to_arm));
    spot.arm = quad(turned ? to_arm : arm);
    spot.to_arm = quad(turned ? arm : to_arm);
    const Vector3 j = pair.sign * share * block.impulse;
    spot.normal = std::max(n.dot(j), Real(0));
    spot.across_1 = t1.dot(j), spot.across_2 = t2.dot(j);
    spots_.push_back(spot);
    block_.push_back(index(group.blocks[k]));
  }
  set_masses(pair);
  pairs_.push_back(pair);
}

void Crowd::set_masses(const Pair& pair) {
  const Member& a = members_[index(pair.a)];
  for (std::size_t k = pair.first; k < pair.first + index(pair.count); ++k) {
    Spot& spot = spots_[k];
    const auto k_times = [&](const Quad& d) {
      Quad u = response(a.inverse_inertia, a.inverse_mass, spot.arm, d);
      if (pair.b >= 0) {
        const Member& b = members_[index(pair.b)];
        u += response(b.inverse_inertia, b.inverse_mass, spot.to_arm, d);
      }
      return u;
    };
    const Real along = dot(pair.n, k_times(pair.n));
    spot.mass = along > 0 ? 1 / along : 0;
    const Quad one = k_times(pair.t1), two = k_times(pair.t2);
    const Real k_11 = dot(pair.t1, one), k_12 = dot(pair.t1, two), k_22 = dot(pair.t2, two);
    const Real determinant = k_11 * k_22 - k_12 * k_12;
    const Real inverse = determinant > 0 ? 1 / determinant : 0;
    spot.mass_11 = inverse * k_22, spot.mass_12 = -inverse * k_12, spot.mass_22 = inverse * k_11;
    const Real largest = std::max(k_11, k_22) + std::abs(k_12);
    spot.slip_mass = largest > 0 ? 1 / largest : 0;
  }
}

// From the top down along gravity, what holds the others last: a sweep then carries all the weight of a stack to
// the ground.
void Crowd::order(const Vector3& gravity, const std::vector<Motion>& motions) {
  for (Pair& pair : pairs_)
    pair.depth = gravity.dot(motions[index(body_[index(pair.a)])].position + vector(spots_[pair.first].arm));
  std::stable_sort(pairs_.begin(), pairs_.end(),
                   [](const Pair& one, const Pair& other) { return one.depth < other.depth; });
}

namespace {

// What an impulse does to a member, held by value while a pair is swept.
struct Moving {
  Quad v, w;
};

template <class Member>
[[gnu::always_inline]] inline void apply(Moving& x, const Member& m, const Quad& arm, const Quad& j) {
  x.v += m.inverse_mass * j;
  x.w += m.inverse_inertia * cross(arm, j);
}

}  // namespace

// The impulses of the part before.
void Crowd::push(const Pair& pair) {
  Quad force = {}, torque = {}, to_torque = {};
  for (std::size_t k = pair.first; k < pair.first + index(pair.count); ++k) {
    const Spot& spot = spots_[k];
    const Quad j = spot.normal * pair.n + spot.across_1 * pair.t1 + spot.across_2 * pair.t2;
    force += j, torque += cross(spot.arm, j), to_torque += cross(spot.to_arm, j);
  }
  Member& a = members_[index(pair.a)];
  a.v += a.inverse_mass * force, a.w += a.inverse_inertia * torque;
  if (pair.b < 0) return;
  Member& b = members_[index(pair.b)];
  b.v -= b.inverse_mass * force, b.w -= b.inverse_inertia * to_torque;
}

template <bool two>
Real Crowd::sweep(const Pair& pair, const Sweep& how) {
  Member& a = members_[index(pair.a)];
  Member* b = two ? &members_[index(pair.b)] : nullptr;
  Moving at_a = {a.v, a.w}, at_b = two ? Moving{b->v, b->w} : Moving{Quad{}, Quad{}};
  Quad moved = a.moved;
  if constexpr (two) moved -= b->moved;
  const auto velocity = [&](const Spot& spot) {
    Quad u = at_a.v + cross(at_a.w, spot.arm);
    if constexpr (two) u -= at_b.v + cross(at_b.w, spot.to_arm);
    return u;
  };
  const auto give = [&](const Spot& spot, const Quad& j) {
    apply(at_a, a, spot.arm, j);
    if constexpr (two) apply(at_b, *b, spot.to_arm, -j);
  };
  Real worst = 0;
  for (std::size_t k = pair.first; k < pair.first + index(pair.count); ++k) {
    Spot& spot = spots_[k];
    Quad way = moved + cross(a.turned, spot.arm);
    if constexpr (two) way -= cross(b->turned, spot.to_arm);
    const Real s = spot.gap + dot(pair.n, way);
    const bool soft = !how.relaxes && s <= 0;
    const Real target = s > 0  ? -s * how.inverse_h
                        : soft ? how.rate * std::max(-s - how.slop, Real(0))
                               : Real(0);
    const Real u_n = dot(pair.n, velocity(spot));
    const Real step =
        soft ? how.stiff * spot.mass * (target - u_n) - how.bleed * spot.normal : spot.mass * (target - u_n);
    const Real normal = std::max(spot.normal + step, Real(0));
    const Real change = normal - spot.normal;
    if (change != 0) {
      spot.normal = normal;
      give(spot, change * pair.n);
    }
    const Real limit = pair.friction * normal;
    if (limit == 0 && spot.across_1 == 0 && spot.across_2 == 0) {
      worst = std::max(worst, std::abs(change) / spot.mass);
      continue;
    }
    const Quad u = velocity(spot);
    const Real u_1 = dot(pair.t1, u), u_2 = dot(pair.t2, u);
    Real across_1 = spot.across_1 - (spot.mass_11 * u_1 + spot.mass_12 * u_2);
    Real across_2 = spot.across_2 - (spot.mass_12 * u_1 + spot.mass_22 * u_2);
    if (across_1 * across_1 + across_2 * across_2 > limit * limit) {
      // It slips, against u: steps by the inverse of K would end along that times u.
      across_1 = spot.across_1 - spot.slip_mass * u_1, across_2 = spot.across_2 - spot.slip_mass * u_2;
      const Real square = std::max(across_1 * across_1 + across_2 * across_2, limit * limit);
      const Real shorter = square > 0 ? limit / std::sqrt(square) : Real(0);
      across_1 *= shorter, across_2 *= shorter;
    }
    const Real d_1 = across_1 - spot.across_1, d_2 = across_2 - spot.across_2;
    spot.across_1 = across_1, spot.across_2 = across_2;
    give(spot, d_1 * pair.t1 + d_2 * pair.t2);
    if (how.measures) worst = std::max(worst, (std::abs(change) + std::abs(d_1) + std::abs(d_2)) / spot.mass);
  }
  a.v = at_a.v, a.w = at_a.w;
  if constexpr (two) b->v = at_b.v, b->w = at_b.w;
  return worst;
}

void Crowd::advance(const Group& group, const Step& step, const std::vector<Body>& bodies,
                    const std::vector<Mover>& movers, std::vector<Block>& blocks,
                    std::vector<Motion>& motions, std::vector<Vector3>* pressed) {
  take(group, step, bodies, movers, blocks, motions);
  order(step.gravity, motions);
  const Real h = step.span / static_cast<Real>(step.parts);
  const Stiffness stiff = stiffness(h);
  const Quad fall = quad(h * step.gravity);
  residual_ = 0;
  const auto sweep_all = [&](const Sweep& how) {
    for (Pair& pair : pairs_) {
      const Real worst = pair.b >= 0 ? sweep<true>(pair, how) : sweep<false>(pair, how);
      if (how.measures) residual_ = std::max(residual_, worst);
    }
  };
  for (int part = 0; part < step.parts; ++part) {
    for (Member& m : members_)
      if (m.inverse_mass > 0) m.v += fall;
    for (const Pair& pair : pairs_) push(pair);
    sweep_all({1 / h, stiff.rate, step.slop, stiff.share, stiff.bleed, false, false});
    for (Member& m : members_) m.moved += h * m.v, m.turned += h * m.w;
    sweep_all({1 / h, 0, 0, 1, 0, true, part + 1 == step.parts});
    if (pressed) add_to(*pressed);
  }
  give(step, bodies, blocks, motions);
}

// K = m v;  L += I (w - w_start) with I at the start: the sum of what the impulses gave.
void Crowd::give(const Step& step, const std::vector<Body>& bodies, std::vector<Block>& blocks,
                 std::vector<Motion>& motions) const {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Member& m = members_[i];
    const Body& body = bodies[index(body_[i])];
    Motion& motion = motions[index(body_[i])];
    const Matrix3 r = rotation_matrix(motion.orientation);
    if (m.inverse_mass > 0) motion.momentum = body.mass * vector(m.v);
    motion.angular_momentum += r * (body.inertia * (r.transpose() * (vector(m.w) - spins_[i])));
    motion.position += vector(m.moved);
    const Vector3 turned = vector(m.turned);
    if (!turned.isZero(0)) motion.orientation = engine::turned(motion.orientation, turned);
  }
  for (const Pair& pair : pairs_)
    for (std::size_t k = pair.first; k < pair.first + index(pair.count); ++k)
      blocks[block_[k]].impulse = static_cast<Real>(step.parts) * impulse(pair, k);
}

// On the block's first body, of the last part [N s].
Vector3 Crowd::impulse(const Pair& pair, std::size_t k) const {
  const Spot& spot = spots_[k];
  return pair.sign * vector(spot.normal * pair.n + spot.across_1 * pair.t1 + spot.across_2 * pair.t2);
}

void Crowd::add_to(std::vector<Vector3>& pressed) const {
  for (const Pair& pair : pairs_)
    for (std::size_t k = pair.first; k < pair.first + index(pair.count); ++k)
      pressed[block_[k]] += impulse(pair, k);
}

}  // namespace cylon::engine::pile
