#include "engine/pile/crowd.h"

#include "engine/pile/lanes.h"
#include "engine/pile/quad.h"
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

[[gnu::always_inline]] inline Lanes size(Lanes x) { return larger(x, -x); }
[[gnu::always_inline]] inline Lanes inverse(Lanes x) {
  const Lanes one = spread(1), none = {};
  return x > none ? one / (x > none ? x : one) : none;
}

void set(Lanes3& lanes, int lane, const Vector3& v) {
  lanes.x[lane] = v.x(), lanes.y[lane] = v.y(), lanes.z[lane] = v.z();
}
Vector3 at(const Lanes3& lanes, int lane) { return {lanes.x[lane], lanes.y[lane], lanes.z[lane]}; }

void copy(const Vector3& v, Real* row) { row[0] = v.x(), row[1] = v.y(), row[2] = v.z(), row[3] = 0; }
Vector3 vector_of(const Real* row) { return {row[0], row[1], row[2]}; }
Quad& quad_at(Real* row) { return *reinterpret_cast<Quad*>(row); }

}  // namespace

// One body of each pair of a batch.
struct Crowd::Side {
  Lanes3 v, w;
  Lanes inverse_mass, xx, yy, zz, xy, xz, yz;

  // I^-1 t
  [[gnu::always_inline]] Lanes3 turn(const Lanes3& t) const {
    return {xx * t.x + xy * t.y + xz * t.z, xy * t.x + yy * t.y + yz * t.z, xz * t.x + yz * t.y + zz * t.z};
  }
  // K d = d/m + (I^-1 (r x d)) x r
  [[gnu::always_inline]] Lanes3 response(const Lanes3& arm, const Lanes3& d) const {
    return inverse_mass * d + cross(turn(cross(arm, d)), arm);
  }
  [[gnu::always_inline]] void add(const Lanes3& force, const Lanes3& torque) {
    v = v + inverse_mass * force, w = w + turn(torque);
  }
  [[gnu::always_inline]] void take_away(const Lanes3& force, const Lanes3& torque) {
    v = v - inverse_mass * force, w = w - turn(torque);
  }
};

[[gnu::always_inline]] inline Crowd::Side Crowd::side(const int* members) const {
  const Member& m = members_.front();
  Side s;
  Lanes none;
  load(m.v, members, stride, s.v.x, s.v.y, s.v.z, none);
  load(m.w, members, stride, s.w.x, s.w.y, s.w.z, none);
  load(m.diagonal, members, stride, s.xx, s.yy, s.zz, s.inverse_mass);
  load(m.beside, members, stride, s.xy, s.xz, s.yz, none);
  return s;
}

// What does not move gets back the zeros that it had.
[[gnu::always_inline]] inline void Crowd::put(const int* members, const Side& s) {
  store(members_.front().v, members, stride, s.v.x, s.v.y, s.v.z, Lanes{});
  store(members_.front().w, members, stride, s.w.x, s.w.y, s.w.z, Lanes{});
}

void Crowd::take_bodies(const std::vector<Group>& groups, const std::vector<Body>& bodies,
                        const std::vector<Mover>& movers) {
  place_.resize(bodies.size());
  body_.clear(), members_.clear(), spins_.clear();
  for (const Group& group : groups)
    for (const int body : group.bodies) {
      const Mover& m = movers[index(body)];
      place_[index(body)] = -1;
      if (!moves(m)) continue;
      place_[index(body)] = static_cast<int>(members_.size());
      body_.push_back(body), spins_.push_back(m.w);
      Member& member = members_.emplace_back();
      const Matrix3& i = m.inverse_inertia;
      copy(m.v, member.v), copy(m.w, member.w);
      copy(i.diagonal(), member.diagonal), copy({i(0, 1), i(0, 2), i(1, 2)}, member.beside);
      member.diagonal[3] = m.inverse_mass;
    }
  members_.emplace_back();  // what does not move
}

// From the top down along gravity, what holds the others last: a sweep then carries all the weight of a stack to
// the ground.
void Crowd::take_pairs(const std::vector<Group>& groups, const Vector3& gravity,
                       const std::vector<Block>& blocks, const std::vector<Motion>& motions) {
  const int ground = static_cast<int>(members_.size()) - 1;
  pairs_.clear();
  for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
    const std::vector<int>& mine = groups[index(g)].blocks;
    for (std::size_t from = 0, to = 0; from < mine.size(); from = to) {
      const Block& first = blocks[index(mine[from])];
      const auto same = [&](const Block& b) {
        return b.a == first.a && b.b == first.b && b.plane == first.plane && b.normal == first.normal;
      };
      while (to < mine.size() && same(blocks[index(mine[to])])) ++to;
      const int a = place_[index(first.a)], b = first.b == fixed_world ? -1 : place_[index(first.b)];
      const bool turned = a < 0;
      const Vector3 point = motions[index(first.a)].position + first.arm;
      pairs_.push_back(
          {g, turned ? b : a, turned || b < 0 ? ground : b, from, to, turned, gravity.dot(point)});
    }
  }
  std::stable_sort(pairs_.begin(), pairs_.end(),
                   [](const Pair& one, const Pair& other) { return one.depth < other.depth; });
}

// Each pair joins the first batch with room after all those that have one of its bodies.
void Crowd::schedule() {
  const int ground = static_cast<int>(members_.size()) - 1;
  last_.assign(members_.size(), -1);
  open_.assign(1, 0);  // of a batch: itself, or one after it that has room
  batches_.clear(), batch_.clear(), lane_.clear();
  const auto find_open = [&](int k) {
    while (open_[index(k)] != k) k = open_[index(k)] = open_[index(open_[index(k)])];
    return k;
  };
  for (const Pair& pair : pairs_) {
    const int k = find_open(std::max(last_[index(pair.a)], last_[index(pair.b)]) + 1);
    if (k == static_cast<int>(batches_.size())) {
      Batch& batch = batches_.emplace_back();
      std::fill_n(batch.a, lane_count, ground), std::fill_n(batch.b, lane_count, ground);
      open_.push_back(k + 1);
    }
    Batch& batch = batches_[index(k)];
    const int lane = batch.filled++;
    batch.a[lane] = pair.a, batch.b[lane] = pair.b, batch.group[lane] = pair.group;
    batch.count = std::max(batch.count, static_cast<int>(pair.to - pair.from));
    if (batch.filled == lane_count) open_[index(k)] = k + 1;
    last_[index(pair.a)] = k;
    if (pair.b != ground) last_[index(pair.b)] = k;
    batch_.push_back(k), lane_.push_back(lane);
  }
}

void Crowd::fill(const std::vector<Group>& groups, Real share, const std::vector<Block>& blocks,
                 const std::vector<Motion>& motions) {
  std::size_t count = 0;
  for (Batch& batch : batches_) batch.first = count, count += index(batch.count);
  spots_.assign(count, Spot{});
  block_.assign(count * lane_count, -1);
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const Pair& pair = pairs_[p];
    Batch& batch = batches_[index(batch_[p])];
    const int lane = lane_[p];
    const std::vector<int>& mine = groups[index(pair.group)].blocks;
    const Block& first = blocks[index(mine[pair.from])];
    const Real sign = pair.turned ? Real(-1) : Real(1);
    const Vector3 n = sign * first.normal;
    int least = 0;
    n.cwiseAbs().minCoeff(&least);
    const Vector3 t1 = n.cross(Vector3::Unit(least)).normalized(), t2 = n.cross(t1);
    set(batch.n, lane, n), set(batch.t1, lane, t1), set(batch.t2, lane, t2);
    batch.sign[lane] = sign, batch.friction[lane] = first.friction;
    const bool two = first.b != fixed_world;
    for (std::size_t k = pair.from; k < pair.to; ++k) {
      const Block& block = blocks[index(mine[k])];
      const std::size_t at = batch.first + (k - pair.from);
      Spot& spot = spots_[at];
      block_[at * lane_count + index(lane)] = mine[k];
      const Vector3 to = two ? Vector3(motions[index(first.b)].position + block.to_arm) : block.to_anchor;
      spot.first_gap[lane] = spot.gap[lane] =
          block.gap + first.normal.dot(motions[index(first.a)].position + block.arm - to);
      set(spot.arm, lane, pair.turned ? block.to_arm : block.arm);
      if (two) set(spot.to_arm, lane, pair.turned ? block.arm : block.to_arm);
      const Vector3 j = sign * share * block.impulse;
      spot.normal[lane] = std::max(n.dot(j), Real(0));
      spot.across_1[lane] = t1.dot(j), spot.across_2[lane] = t2.dot(j);
    }
  }
  for (const Batch& batch : batches_) set_masses(batch);
}

void Crowd::set_masses(const Batch& batch) {
  const Side a = side(batch.a), b = side(batch.b);
  for (std::size_t k = batch.first; k < batch.first + index(batch.count); ++k) {
    Spot& spot = spots_[k];
    Lanes used;
    for (int lane = 0; lane < lane_count; ++lane)
      used[lane] = block_[k * lane_count + index(lane)] < 0 ? Real(0) : Real(1);
    const auto k_times = [&](const Lanes3& d) {
      return a.response(spot.arm, d) + b.response(spot.to_arm, d);
    };
    spot.yield = used * dot(batch.n, k_times(batch.n));
    spot.mass = inverse(spot.yield);
    const Lanes3 one = k_times(batch.t1), two = k_times(batch.t2);
    const Lanes k_11 = used * dot(batch.t1, one), k_12 = used * dot(batch.t1, two),
                k_22 = used * dot(batch.t2, two);
    const Lanes over = inverse(k_11 * k_22 - k_12 * k_12);
    spot.mass_11 = over * k_22, spot.mass_12 = -over * k_12, spot.mass_22 = over * k_11;
    spot.slip_mass = inverse(larger(k_11, k_22) + size(k_12));
  }
}

// The impulses of the part before.
void Crowd::push(const Batch& batch) {
  Lanes3 force = {}, torque = {}, to_torque = {};
  for (std::size_t k = batch.first; k < batch.first + index(batch.count); ++k) {
    const Spot& spot = spots_[k];
    const Lanes3 j = spot.normal * batch.n + spot.across_1 * batch.t1 + spot.across_2 * batch.t2;
    force = force + j, torque = torque + cross(spot.arm, j), to_torque = to_torque + cross(spot.to_arm, j);
  }
  Side a = side(batch.a), b = side(batch.b);
  a.add(force, torque), b.take_away(force, to_torque);
  put(batch.a, a), put(batch.b, b);
}

template <bool relaxes>
void Crowd::sweep(const Batch& batch, const Sweep& how, Lanes* worst) {
  Side a = side(batch.a), b = side(batch.b);
  const Lanes none = {};
  Lanes3 moved = {}, turned = {}, to_turned = {};
  if constexpr (relaxes) {
    Lanes3 to_moved = {};
    Lanes fourth;
    const Member& m = members_.front();
    load(m.moved, batch.a, stride, moved.x, moved.y, moved.z, fourth);
    load(m.moved, batch.b, stride, to_moved.x, to_moved.y, to_moved.z, fourth);
    load(m.turned, batch.a, stride, turned.x, turned.y, turned.z, fourth);
    load(m.turned, batch.b, stride, to_turned.x, to_turned.y, to_turned.z, fourth);
    moved = moved - to_moved;
  }
  const auto velocity = [&](const Spot& spot) {
    return (a.v + cross(a.w, spot.arm)) - (b.v + cross(b.w, spot.to_arm));
  };
  const auto give = [&](const Spot& spot, const Lanes3& j) {
    a.add(j, cross(spot.arm, j)), b.take_away(j, cross(spot.to_arm, j));
  };
  for (std::size_t k = batch.first; k < batch.first + index(batch.count); ++k) {
    Spot& spot = spots_[k];
    if constexpr (relaxes)
      spot.gap =
          spot.first_gap + dot(batch.n, moved + cross(turned, spot.arm) - cross(to_turned, spot.to_arm));
    const Lanes s = spot.gap, before = spot.normal;
    const Lanes3 n_u = velocity(spot);
    const Lanes u_n = dot(batch.n, n_u);
    Lanes step;
    if constexpr (relaxes) {
      step = spot.mass * ((s > none ? -s * spread(how.inverse_h) : none) - u_n);
    } else {
      const Lanes target =
          s > none ? -s * spread(how.inverse_h) : spread(how.rate) * larger(-s - spread(how.slop), none);
      step = (s > none ? spread(1) : spread(how.stiff)) * spot.mass * (target - u_n) -
             (s > none ? none : spread(how.bleed)) * before;
    }
    const Lanes normal = larger(before + step, none), change = normal - before;
    spot.normal = normal;
    give(spot, change * batch.n);

    const Lanes limit = batch.friction * normal, squared_limit = limit * limit;
    const Lanes3 u = velocity(spot);
    const Lanes u_1 = dot(batch.t1, u), u_2 = dot(batch.t2, u);
    Lanes across_1 = spot.across_1 - (spot.mass_11 * u_1 + spot.mass_12 * u_2);
    Lanes across_2 = spot.across_2 - (spot.mass_12 * u_1 + spot.mass_22 * u_2);
    const auto slips = across_1 * across_1 + across_2 * across_2 > squared_limit;
    if (signs(slips) != 0) {
      // Against u: steps by the inverse of K would end along that times u.
      const Lanes slip_1 = spot.across_1 - spot.slip_mass * u_1,
                  slip_2 = spot.across_2 - spot.slip_mass * u_2;
      const Lanes square = larger(slip_1 * slip_1 + slip_2 * slip_2, squared_limit);
      const Lanes shorter = limit / root(square > none ? square : spread(1));
      across_1 = slips ? shorter * slip_1 : across_1, across_2 = slips ? shorter * slip_2 : across_2;
    }
    const Lanes d_1 = across_1 - spot.across_1, d_2 = across_2 - spot.across_2;
    spot.across_1 = across_1, spot.across_2 = across_2;
    give(spot, d_1 * batch.t1 + d_2 * batch.t2);
    if (worst) *worst = larger(*worst, (size(change) + size(d_1) + size(d_2)) * spot.yield);
  }
  put(batch.a, a), put(batch.b, b);
}

template <class Use>
void Crowd::for_each_impulse(Use use) const {
  for (const Batch& batch : batches_)
    for (std::size_t k = batch.first; k < batch.first + index(batch.count); ++k) {
      const Spot& spot = spots_[k];
      const Lanes3 j =
          batch.sign * (spot.normal * batch.n + spot.across_1 * batch.t1 + spot.across_2 * batch.t2);
      for (int lane = 0; lane < batch.filled; ++lane)
        if (const int block = block_[k * lane_count + index(lane)]; block >= 0)
          use(index(block), at(j, lane));
    }
}

void Crowd::advance(const std::vector<Group>& groups, const Step& step, const std::vector<Body>& bodies,
                    const std::vector<Mover>& movers, std::vector<Block>& blocks,
                    std::vector<Motion>& motions, std::vector<Vector3>* pressed) {
  take_bodies(groups, bodies, movers);
  take_pairs(groups, step.gravity, blocks, motions);
  schedule();
  fill(groups, 1 / static_cast<Real>(step.parts), blocks, motions);
  const Real h = step.span / static_cast<Real>(step.parts);
  const Stiffness stiff = stiffness(h);
  const Quad fall = quad(h * step.gravity);
  const Sweep how = {1 / h, stiff.rate, step.slop, stiff.share, stiff.bleed};
  residuals_.assign(groups.size(), 0);
  for (const Group& group : groups)
    operations_ += std::int64_t{2} * step.parts * static_cast<std::int64_t>(group.blocks.size());
  for (int part = 0; part < step.parts; ++part) {
    for (Member& m : members_)
      if (m.diagonal[3] > 0) quad_at(m.v) += fall;
    for (const Batch& batch : batches_) push(batch);
    for (const Batch& batch : batches_) sweep<false>(batch, how, nullptr);
    for (Member& m : members_) quad_at(m.moved) += h * quad_at(m.v), quad_at(m.turned) += h * quad_at(m.w);
    for (const Batch& batch : batches_) {
      if (part + 1 < step.parts) {
        sweep<true>(batch, how, nullptr);
        continue;
      }
      Lanes worst = {};
      sweep<true>(batch, how, &worst);
      for (int lane = 0; lane < batch.filled; ++lane) {
        Real& residual = residuals_[index(batch.group[lane])];
        residual = std::max(residual, worst[lane]);
      }
    }
    if (pressed) for_each_impulse([&](std::size_t block, const Vector3& j) { (*pressed)[block] += j; });
  }
  give(step, bodies, blocks, motions);
}

// K = m v;  L += I (w - w_start) with I at the start: the sum of what the impulses gave.
void Crowd::give(const Step& step, const std::vector<Body>& bodies, std::vector<Block>& blocks,
                 std::vector<Motion>& motions) const {
  for (std::size_t i = 0; i < body_.size(); ++i) {
    const Member& m = members_[i];
    const Body& body = bodies[index(body_[i])];
    Motion& motion = motions[index(body_[i])];
    const Matrix3 r = rotation_matrix(motion.orientation);
    if (m.diagonal[3] > 0) motion.momentum = body.mass * vector_of(m.v);
    motion.angular_momentum += r * (body.inertia * (r.transpose() * (vector_of(m.w) - spins_[i])));
    motion.position += vector_of(m.moved);
    const Vector3 turned = vector_of(m.turned);
    if (!turned.isZero(0)) motion.orientation = engine::turned(motion.orientation, turned);
  }
  for_each_impulse([&](std::size_t block, const Vector3& j) {
    blocks[block].impulse = static_cast<Real>(step.parts) * j;
  });
}

}  // namespace cylon::engine::pile
