// When one sphere meets each of its neighbours: the numbers of contact(), some lanes at a time.
#pragma once

#include "engine/ballistic/encounter.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace cylon::engine::ballistic {

/// The neighbours of a sphere that fly with its own acceleration.  A meeting has the bits of contact().
class Crowd {
 public:
  static constexpr std::size_t capacity = 64;

  std::size_t size() const { return size_; }
  bool full() const { return size_ == capacity; }
  void clear() { size_ = 0; }
  std::size_t body(std::size_t i) const { return bodies_[i]; }

  /// Requires that it is not full.
  void add(std::size_t body) { bodies_[size_++] = body; }

  /// Computes the meetings of `one` with all of them.  First all are read, then all computed, so that no
  /// number waits for another body's.
  void meet(const Flight& one, const std::vector<Flight>& flights) {
    for (std::size_t i = 0; i < size_; ++i) read(one, flights[bodies_[i]], i);
    const auto spread3 = [](const Vector3& v) { return Lanes3{spread(v.x()), spread(v.y()), spread(v.z())}; };
    const Lanes3 p = spread3(one.position), v = spread3(one.velocity), g = spread3(one.acceleration);
    for (std::size_t k = 0; k * lanes < size_; ++k) {
      Block& b = blocks_[k];
      const Pair<Lanes> meeting = pair(moved(p, v, g, b.own_age), v + b.own_age * g,
                                       moved(b.p, b.v, g, b.age), b.v + b.age * g, b.reach);
      const Lanes t = contact_in_flight(meeting);
      const auto meets = (meeting.b < 0) & (meeting.disc >= 0) & (b.reach > 0);  // points meet nowhere
      b.after = meets ? t : spread(never);
      b.near = meeting.c <= 2 * b.reach * meeting.touch_gap ? spread(1) : Lanes{};
    }
  }

  /// The instant of the contact with a neighbour, or infinity.
  Time time(std::size_t i) const {
    return bases_[i] + static_cast<Time>(blocks_[i / lanes].after[i % lanes]);
  }
  /// Whether they touch or overlap: time(i) is none, and contact() must tell.
  bool near(std::size_t i) const { return blocks_[i / lanes].near[i % lanes] != 0; }

 private:
  static constexpr std::size_t lanes = lane_count;

  struct Block {
    Lanes3 p, v;                // at the neighbour's own reference time
    Lanes own_age, age, reach;  // from both reference times to the later of them [s]; sum of radii
    Lanes after, near;          // results
  };

  void read(const Flight& one, const Flight& f, std::size_t i) {
    const Time base = std::max(one.since, f.since);
    Block& b = blocks_[i / lanes];
    const std::size_t lane = i % lanes;
    b.p.x[lane] = f.position.x(), b.p.y[lane] = f.position.y(), b.p.z[lane] = f.position.z();
    b.v.x[lane] = f.velocity.x(), b.v.y[lane] = f.velocity.y(), b.v.z[lane] = f.velocity.z();
    b.own_age[lane] = static_cast<Real>(base - one.since), b.age[lane] = static_cast<Real>(base - f.since);
    b.reach[lane] = one.radius + f.radius;
    bases_[i] = base;
  }

  std::size_t size_ = 0;
  std::array<Block, capacity / lanes> blocks_{};
  std::array<Time, capacity> bases_{};
  std::array<std::size_t, capacity> bodies_{};
};

}  // namespace cylon::engine::ballistic
