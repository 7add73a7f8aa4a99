#include "engine/free_bodies.h"

#include "engine/free_bodies_lanes.h"
#include "engine/free_rotation.h"
#include "engine/integrators/splittings.h"
#include "engine/plan.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace cylon::engine {

namespace {

using wide::add;
using wide::take;

constexpr std::size_t grain = 64;  // blocks that one thread carries at a time: 8 and 34 kB

/// Turns e_x to e_y, e_y to e_z, e_z to e_x.
const Quaternion cyclic(Real(0.5), Real(0.5), Real(0.5), Real(0.5));

void set(Lanes& lanes, std::size_t lane, Real value) { lanes[lane] = value; }

/// Parts of a rotation's step about e_0, e_2, e_0, ...
std::span<const double> rotation_parts(int order) {
  static constexpr std::array<double, 3> strang = {0.5, 1, 0.5};
  if (order <= 2) return strang;
  return order <= 4 ? std::span<const double>(bm4_parts) : std::span<const double>(bm6_parts);
}

/// A = sum over the drifts of their part times the kicks before them.
double own_share(const Composition& splitting) {
  double share = 0, kicked = 0;
  bool kick = splitting.first == Part::kick;
  for (const double part : splitting.coefficients) {
    (kick ? kicked : share) += kick ? part : part * kicked;
    kick = !kick;
  }
  return share;
}

// a q
[[gnu::always_inline]] inline void turn_left(Lanes w, Lanes x, Lanes y, Lanes z, Lanes* q) {
  const Lanes q0 = q[0], q1 = q[1], q2 = q[2], q3 = q[3];
  q[0] = take(z, q3, take(y, q2, take(x, q1, w * q0)));
  q[1] = take(z, q2, add(y, q3, add(x, q0, w * q1)));
  q[2] = add(z, q1, add(y, q0, take(x, q3, w * q2)));
  q[3] = add(z, q0, take(y, q1, add(x, q2, w * q3)));
}

// q (c + s e_x), q (c + s e_z)
[[gnu::always_inline]] inline void turn_about_x(Lanes c, Lanes s, Lanes* q) {
  const Lanes q0 = q[0], q1 = q[1], q2 = q[2], q3 = q[3];
  q[0] = take(q1, s, q0 * c), q[1] = add(q0, s, q1 * c);
  q[2] = add(q3, s, q2 * c), q[3] = take(q2, s, q3 * c);
}
[[gnu::always_inline]] inline void turn_about_z(Lanes c, Lanes s, Lanes* q) {
  const Lanes q0 = q[0], q1 = q[1], q2 = q[2], q3 = q[3];
  q[0] = take(q3, s, q0 * c), q[3] = add(q0, s, q3 * c);
  q[1] = add(q2, s, q1 * c), q[2] = take(q1, s, q2 * c);
}

// q (3 - |q|^2)/2
[[gnu::always_inline]] inline void renormalise(Lanes* q) {
  const Lanes square = add(q[3], q[3], add(q[2], q[2], add(q[1], q[1], q[0] * q[0])));
  const Lanes factor = take(square, spread(Real(0.5)), spread(Real(1.5)));
  for (int i = 0; i < 4; ++i) q[i] = q[i] * factor;
}

// R^T L:  L - w t + v x t,  t = 2 v x L
[[gnu::always_inline]] inline void to_body(const Lanes* q, const Lanes* l, Lanes* result) {
  const Lanes two = spread(2);
  const Lanes w = q[0], x = q[1], y = q[2], z = q[3];
  const Lanes tx = two * take(z, l[1], y * l[2]), ty = two * take(x, l[2], z * l[0]),
              tz = two * take(y, l[0], x * l[1]);
  result[0] = add(y, tz, take(z, ty, take(w, tx, l[0])));
  result[1] = add(z, tx, take(x, tz, take(w, ty, l[1])));
  result[2] = add(x, ty, take(y, tx, take(w, tz, l[2])));
}

// Asks for memory that is read soon; any address may be asked for.
[[gnu::always_inline]] inline void fetch(const char* from, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; i += 64) __builtin_prefetch(from + i, 1);
}

template <bool is_fast>
[[gnu::always_inline]] inline wide::Turn half(Lanes x) {
  if constexpr (is_fast)
    return wide::half_turn(x);
  else
    return wide::small_turn(x);
}

}  // namespace

std::string FreeBodies::not_free(const Model& model, const Integrator& integrator) {
  if (integrator.kind != cylon::engine::Kind::splitting) return "the integrator is not a splitting";
  return missing(Method::free, model);
}

FreeBodies::FreeBodies(const Model& model, const Integrator& integrator, Time dt, int threads)
    : FreeBodies(
          model.bodies.size(),
          [&](std::size_t i) {
            return Given{model.bodies[i], model.motions[i]};
          },
          model.forces.gravity, integrator, dt, threads) {
  assert(not_free(model, integrator).empty());
}

FreeBodies::FreeBodies(std::size_t count, const std::function<Given(std::size_t)>& given,
                       const Vector3& gravity, const Integrator& integrator, Time dt, int threads)
    : gravity_(gravity),
      dt_(static_cast<Real>(dt)),
      own_share_(static_cast<Real>(own_share(integrator.splitting))),
      parts_(rotation_parts(integrator.order)),
      threads_(threads) {
  for (const double part : parts_) largest_part_ = std::max(largest_part_, std::abs(static_cast<Real>(part)));
  std::uint32_t counts[kinds] = {};
  places_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Given g = given(i);
    const Kind kind = kind_of(g.body, g.motion);
    places_.push_back({kind, counts[kind]++});
  }
  const auto blocks = [&](Kind kind) { return (counts[kind] + lanes - 1) / lanes; };
  points_.resize(blocks(point));
  for (const Kind kind : {symmetric, slow, fast}) {
    Spin idle{};
    idle.q[0] = idle.a[0] = spread(1);
    spins_[kind].assign(blocks(kind), idle);
  }
  rests_.resize(count);
  for (std::size_t i = 0; i < count; ++i) put(i, given(i));
}

FreeBodies::Kind FreeBodies::kind_of(const Body& body, const Motion& motion) const {
  const Real l = motion.angular_momentum.norm();
  if (!body.turns || l == 0) return point;
  const Vector3& x = body.inverse_moments;
  if (same_moment(x[0], x[1]) || same_moment(x[2], x[1])) return symmetric;
  const Real angle = largest_part_ * std::abs(dt_) / 2 * l * std::max(x[0] - x[1], x[1] - x[2]);
  return angle <= wide::small_angle ? slow : fast;
}

void FreeBodies::put(std::size_t i, const Given& given) {
  const Place place = places_[i];
  const std::size_t block = place.index / lanes, lane = place.index % lanes;
  rests_[i] = {given.body.mass, given.motion.orientation};
  Flight* flight = nullptr;
  if (place.kind == point) {
    flight = &points_[block];
  } else {
    Spin& spin = spins_[place.kind][block];
    flight = &spin.flight;
    put_spin(spin, lane, static_cast<Kind>(place.kind), given, rests_[i]);
  }
  const Vector3 v = velocity(given.body, given.motion);
  for (int c = 0; c < 3; ++c) {
    set(flight->p[c], lane, given.motion.position[c]);
    set(flight->s[c], lane, dt_ * (v[c] + own_share_ * dt_ * gravity_[c]));
  }
}

void FreeBodies::put_spin(Spin& spin, std::size_t lane, Kind kind, const Given& given, Rest& rest) const {
  const Vector3& x = given.body.inverse_moments;
  const Vector3& l = given.motion.angular_momentum;
  Quaternion frame = given.body.principal_axes;
  Real constants[2];
  if (kind == symmetric) {
    const bool low = same_moment(x[0], x[1]);
    if (!low) frame = frame * cyclic;
    const Vector3 axis = given.motion.orientation * (frame * Vector3::UnitZ());
    const bool sphere = low && same_moment(x[2], x[1]);
    const Real angle = sphere ? 0 : dt_ / 2 * (x[low ? 2 : 0] - x[1]) * axis.dot(l);
    constants[0] = std::cos(angle), constants[1] = std::sin(angle);
  } else {
    constants[0] = dt_ / 2 * (x[0] - x[1]), constants[1] = dt_ / 2 * (x[2] - x[1]);
  }
  const Quaternion q = given.motion.orientation * frame, a = exponential(dt_ * x[1] * l);
  const Real components[] = {q.w(), q.x(), q.y(), q.z()};
  for (int i = 0; i < 4; ++i) set(spin.q[i], lane, components[i]);
  for (int c = 0; c < 3; ++c) set(spin.l[c], lane, l[c]);
  set(spin.a[0], lane, a.w());
  set(spin.a[1], lane, a.vec().dot(l) / l.squaredNorm());
  for (int i = 0; i < 2; ++i) set(spin.constants[i], lane, constants[i]);
  rest.frame = frame.conjugate();
}

// A step's turn of bodies without symmetry.
template <bool is_fast>
[[gnu::always_inline]] inline void FreeBodies::turn(const Spin& spin, Lanes* q) const {
  Lanes l[3];
  to_body(q, spin.l, l);
  const auto about_x = [&](Lanes scale, bool last) {
    const wide::Turn t = half<is_fast>(scale * spin.constants[0] * l[0]);
    turn_about_x(t.cosine, t.sine, q);
    if (last) return;
    // the double angle, back
    const Lanes c = take(t.sine, t.sine, t.cosine * t.cosine), s = t.sine * t.cosine * Real(2);
    const Lanes l1 = l[1], l2 = l[2];
    l[1] = add(s, l2, c * l1), l[2] = take(s, l1, c * l2);
  };
  const auto about_z = [&](Lanes scale, bool last) {
    const wide::Turn t = half<is_fast>(scale * spin.constants[1] * l[2]);
    turn_about_z(t.cosine, t.sine, q);
    const Lanes c = take(t.sine, t.sine, t.cosine * t.cosine), s = t.sine * t.cosine * Real(2);
    const Lanes l0 = l[0], l1 = l[1];
    l[0] = add(s, l1, c * l0);
    if (!last) l[1] = take(s, l0, c * l1);
  };
  const auto part = [&](std::size_t i) { return spread(static_cast<Real>(parts_[i])); };
  if (parts_.size() == 3) {
    about_x(spread(Real(0.5)), false);
    about_z(spread(1), true);
    about_x(spread(Real(0.5)), true);
  } else {
    about_x(part(0), false);
    for (std::size_t i = 1; i + 1 < parts_.size(); i += 2) {
      about_z(part(i), false);
      about_x(part(i + 1), false);
    }
  }
}

void FreeBodies::run(Kind kind, std::size_t begin, std::size_t end, std::int64_t steps) {
  const Vector3 gain = dt_ * dt_ * gravity_;
  const bool falls[] = {gain[0] != 0, gain[1] != 0, gain[2] != 0};
  if (kind == point) {
    // each axis by itself, four blocks side by side: an addition waits for the one before it
    constexpr std::size_t width = 4;
    std::size_t b = begin;
    for (; b + width <= end && steps > 1; b += width) {
      for (int c = 0; c < 3; ++c) {
        Lanes p[width], s[width];
        for (std::size_t k = 0; k < width; ++k) p[k] = points_[b + k].p[c], s[k] = points_[b + k].s[c];
        const Lanes more = spread(gain[c]);
        if (falls[c]) {
          for (std::int64_t n = 0; n < steps; ++n)
            for (std::size_t k = 0; k < width; ++k) p[k] += s[k], s[k] += more;
          for (std::size_t k = 0; k < width; ++k) points_[b + k].s[c] = s[k];
        } else {
          for (std::int64_t n = 0; n < steps; ++n)
            for (std::size_t k = 0; k < width; ++k) p[k] += s[k];
        }
        for (std::size_t k = 0; k < width; ++k) points_[b + k].p[c] = p[k];
      }
    }
    for (; b < end; ++b) {
      Flight& f = points_[b];
      for (int c = 0; c < 3; ++c) {
        const Lanes more = spread(gain[c]);
        Lanes p = f.p[c], s = f.s[c];
        for (std::int64_t n = 0; n < steps; ++n) p += s, s += more;
        f.p[c] = p;
        if (falls[c]) f.s[c] = s;
      }
    }
    return;
  }
  // a few blocks together, so that a run of steps finds them near and has several to work on at once
  constexpr std::size_t few = 16;
  constexpr std::size_t ahead = 8 * sizeof(Spin);  // further than the machine looks by itself: over pages
  const auto each = [&](const auto& rotate) {
    for (std::size_t first = begin; first < end; first += few) {
      for (std::int64_t n = 0; n < steps; ++n) {
        for (std::size_t b = first; b < std::min(end, first + few); ++b) {
          Spin& spin = spins_[kind][b];
          if (steps == 1) fetch(reinterpret_cast<const char*>(&spin) + ahead, sizeof(Spin));
          for (int c = 0; c < 3; ++c) {
            spin.flight.p[c] += spin.flight.s[c];
            if (falls[c]) spin.flight.s[c] += spread(gain[c]);
          }
          Lanes q[4] = {spin.q[0], spin.q[1], spin.q[2], spin.q[3]};
          const Lanes v = spin.a[1];
          turn_left(spin.a[0], v * spin.l[0], v * spin.l[1], v * spin.l[2], q);
          rotate(spin, q);
          renormalise(q);
          for (int i = 0; i < 4; ++i) spin.q[i] = q[i];
        }
      }
    }
  };
  if (kind == symmetric)
    each([](const Spin& spin, Lanes* q) { turn_about_z(spin.constants[0], spin.constants[1], q); });
  else if (kind == slow)
    each([&](const Spin& spin, Lanes* q) { turn<false>(spin, q); });
  else
    each([&](const Spin& spin, Lanes* q) { turn<true>(spin, q); });
}

void FreeBodies::advance(std::int64_t steps) {
  for (const Kind kind : {point, symmetric, slow, fast}) {
    const std::size_t blocks = kind == point ? points_.size() : spins_[kind].size();
    threads_.for_each((blocks + grain - 1) / grain, 1, [&](std::size_t part) {
      run(kind, part * grain, std::min(blocks, (part + 1) * grain), steps);
    });
  }
  steps_ += steps;
}

std::int64_t FreeBodies::operations() const {
  std::size_t blocks = points_.size();
  for (const auto& spins : spins_) blocks += spins.size();
  return steps_ * static_cast<std::int64_t>(blocks);
}

void FreeBodies::read(std::vector<Motion>& motions) const {
  motions.resize(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place place = places_[i];
    const std::size_t block = place.index / lanes, lane = place.index % lanes;
    const Rest& rest = rests_[i];
    Motion& motion = motions[i];
    const Flight* flight = nullptr;
    if (place.kind == point) {
      flight = &points_[block];
      motion.orientation = rest.frame;
      motion.angular_momentum.setZero();
    } else {
      const Spin& spin = spins_[place.kind][block];
      flight = &spin.flight;
      const Quaternion q(spin.q[0][lane], spin.q[1][lane], spin.q[2][lane], spin.q[3][lane]);
      motion.orientation = (q * rest.frame).normalized();
      for (int c = 0; c < 3; ++c) motion.angular_momentum[c] = spin.l[c][lane];
    }
    for (int c = 0; c < 3; ++c) {
      motion.position[c] = flight->p[c][lane];
      motion.momentum[c] = rest.mass * (flight->s[c][lane] / dt_ - own_share_ * dt_ * gravity_[c]);
    }
  }
}

std::size_t FreeBodies::memory() const {
  std::size_t bytes = sizeof *this + places_.capacity() * sizeof(Place) + rests_.capacity() * sizeof(Rest) +
                      points_.capacity() * sizeof(Flight);
  for (const auto& spins : spins_) bytes += spins.capacity() * sizeof(Spin);
  return bytes;
}

}  // namespace cylon::engine
