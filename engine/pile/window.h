// Packs contacts, one after another, into batches in which no body is twice, close to the order they come in.
#pragma once

#include "engine/pile/lanes.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace cylon::engine::pile {

/// Up to 64 batches are open at a time.  A bit of a body's mask says in which of them it is.
/// Batch: a struct with room for lane_count contacts; Finish(batch, lanes used) gets every full batch.
template <class Batch>
class Window {
 public:
  void start(std::size_t bodies) { masks_.assign(bodies, 0); }

  /// Calls fill(batch, lane) for the place of a contact of body a, and b where that is not negative.
  template <class Fill, class Finish>
  void add(int a, int b, Fill&& fill, Finish&& finish) {
    std::uint64_t used = mask(a);
    if (b >= 0) used |= mask(b);
    int slot = std::countr_one(used);
    if (slot == 64) close(slot = 0, finish);
    Slot& s = slots_[slot];
    mask(a) |= std::uint64_t{1} << slot;
    if (b >= 0) mask(b) |= std::uint64_t{1} << slot;
    s.bodies[2 * s.used] = a, s.bodies[2 * s.used + 1] = b;
    fill(s.batch, s.used);
    if (++s.used == lane_count) close(slot, finish);
  }

  template <class Finish>
  void flush(Finish&& finish) {
    for (int slot = 0; slot < 64; ++slot)
      if (slots_[slot].used > 0) close(slot, finish);
  }

 private:
  struct Slot {
    Batch batch;
    int used = 0;
    int bodies[2 * lane_count];
  };

  std::uint64_t& mask(int body) { return masks_[static_cast<std::size_t>(body)]; }

  template <class Finish>
  void close(int slot, Finish&& finish) {
    Slot& s = slots_[slot];
    for (int k = 0; k < 2 * s.used; ++k)
      if (s.bodies[k] >= 0) mask(s.bodies[k]) &= ~(std::uint64_t{1} << slot);
    finish(s.batch, s.used);
    s.used = 0;
  }

  Slot slots_[64];
  std::vector<std::uint64_t> masks_;
};

}  // namespace cylon::engine::pile
