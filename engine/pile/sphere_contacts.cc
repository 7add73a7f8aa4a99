#include "engine/pile/sphere_contacts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace cylon::engine::pile {
namespace {

void set_lane(Lanes3& lanes, int lane, const Vector3& value) {
  lanes.x[lane] = value[0], lanes.y[lane] = value[1], lanes.z[lane] = value[2];
}

template <class Batch>
void put(Batch& batch, int lane, int a, int b, int pair, int old) {
  batch.a[lane] = a, batch.b[lane] = b, batch.pair[lane] = pair, batch.old[lane] = old;
}

template <class Mask>
bool any(const Mask& mask) {
  std::int64_t parts[sizeof(Mask) / 8];
  __builtin_memcpy(parts, &mask, sizeof mask);
  return (parts[0] | parts[1] | parts[2] | parts[3]) != 0;
}

}  // namespace

SphereContacts::SphereContacts(const Model& model, Threads& threads) : model_(model), threads_(threads) {
  const int n = static_cast<int>(model.bodies.size());
  reach_.assign(model.bodies.size(), -1);
  blocks_.resize(static_cast<std::size_t>((n + block_size - 1) / block_size));
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    Block& block = blocks_[k];
    block.first = static_cast<int>(k) * block_size;
    block.last = std::min(n, block.first + block_size);
    block.start.assign(static_cast<std::size_t>(block.last - block.first) + 1, 0);
    block.old_start = block.start;
  }
  for (const Plane& plane : model.planes)
    planes_.insert(planes_.end(), {plane.normal[0], plane.normal[1], plane.normal[2], plane.offset});
  impulses_.assign(4, 0), old_impulses_.assign(4, 0);  // row 0: none
  for (const Material& material : model.materials) bounces_ |= material.restitution > 0;
}

void SphereContacts::find(const Spheres& spheres, Time span, Real gravity) {
  span_ = span, gravity_ = gravity;
  const Real h = static_cast<Real>(span);
  for (int i = 0; i < spheres.count; ++i) {
    const Real* v = spheres.v(i);
    const Real r = spheres.p(i)[3];
    // how far a body gets in a step, twice for what may strike it, and a little more
    reach_[static_cast<std::size_t>(i)] =
        spheres.surface[static_cast<std::size_t>(i)] == no_surface
            ? -1
            : r + h * (std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + gravity * h) + r / 256;
  }
  grid_.build(spheres, reach_);
  threads_.for_each(blocks_.size(), 1, [&](std::size_t k) { find_pairs(spheres, blocks_[k]); });
  std::swap(impulses_, old_impulses_);
  int total = 1 + static_cast<int>(blocks_.size());
  for (Block& block : blocks_) {
    block.base = total;
    total += block.start.back();
  }
  impulses_.resize(4 * static_cast<std::size_t>(total));
  threads_.for_each(blocks_.size(), 1, [&](std::size_t k) { pack(spheres, blocks_[k]); });
  pack_border(spheres);
  approaching_.clear();
  for (const Block& block : blocks_)
    approaching_.insert(approaching_.end(), block.approaching.begin(), block.approaching.end());
}

// Keeps, in their order, those of the spheres found that sphere i may touch; their number.
int SphereContacts::leave_out_filtered(const Spheres& spheres, int i, int* found, int count) const {
  if (spheres.filter.empty()) return count;
  const Filter& own = spheres.filter[static_cast<std::size_t>(i)];
  int* const end = std::remove_if(found, found + count, [&](int other) {
    return !may_meet(own, spheres.filter[static_cast<std::size_t>(other)]);
  });
  return static_cast<int>(end - found);
}

void SphereContacts::find_pairs(const Spheres& spheres, Block& block) {
  std::swap(block.start, block.old_start), std::swap(block.other, block.old_other);
  block.old_base = block.base;
  std::size_t found = 0;
  for (int i = block.first; i < block.last; ++i) {
    block.start[static_cast<std::size_t>(i - block.first)] = static_cast<int>(found);
    const Real* p = spheres.p(i);
    const Real reach = reach_[static_cast<std::size_t>(i)];
    if (reach < 0) continue;
    const std::size_t room = found + static_cast<std::size_t>(grid_.most()) + model_.planes.size();
    if (block.other.size() < room) block.other.resize(2 * room);
    int* const first = block.other.data() + found;
    found += static_cast<std::size_t>(leave_out_filtered(spheres, i, first, grid_.near(i, p, reach, first)));
    for (std::size_t k = 0; k < model_.planes.size(); ++k) {
      const Real* plane = planes_.data() + 4 * k;
      block.other[found] = spheres.count + static_cast<int>(k);
      found += plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] - plane[3] < reach &&
               model_.plane_surfaces[k] != no_surface &&
               (spheres.filter.empty() ||
                may_meet(spheres.filter[static_cast<std::size_t>(i)], model_.plane_filters[k]));
    }
  }
  block.start.back() = static_cast<int>(found);
}

const Material& SphereContacts::material(const Spheres& spheres, int a, int b, bool plane) const {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  return model_.material(spheres.surface[i], plane ? model_.plane_surfaces[j] : spheres.surface[j]);
}

// Normals, masses and impulses of a batch whose bodies are known.  Lanes without a contact act on a row of
// zeros, one for each block.
template <class Batch>
void SphereContacts::prepare(const Spheres& spheres, Batch& batch, int used, int spare,
                             std::vector<Approaching>& approaching) {
  for (int lane = used; lane < lane_count; ++lane)
    put(batch, lane, spare, Batch::plane ? 0 : spare, 1 + spare - spheres.count, 0);
  const Real h = static_cast<Real>(span_);
  const Lanes zero{};
  Movers a, b{};
  Places at, bt{};
  Lanes gap, reach;
  a.load(spheres.velocity.data(), batch.a), at.load(spheres.place.data(), batch.a);
  Lanes3 d{};
  if constexpr (Batch::plane) {
    pile::load(planes_.data(), batch.b, 4, batch.normal.x, batch.normal.y, batch.normal.z, batch.offset);
    gap = dot(batch.normal, at.p) - batch.offset - at.radius;
    reach = at.radius;
  } else {
    b.load(spheres.velocity.data(), batch.b), bt.load(spheres.place.data(), batch.b);
    d = at.p - bt.p;
    const Lanes length = root(dot(d, d));
    reach = at.radius + bt.radius;
    gap = length - reach;
    const auto apart = length > zero;  // else any unit vector
    batch.normal = {apart ? d.x / length : spread(Real(0.36)), apart ? d.y / length : spread(Real(0.8)),
                    apart ? d.z / length : spread(Real(0.48))};
  }
  const Lanes3 v = a.v - b.v;
  const Lanes inverse = a.inverse_mass + b.inverse_mass,
              all = inverse + (a.inverse_inertia + b.inverse_inertia);
  batch.mass = inverse > zero ? 1 / inverse : zero;
  batch.tangent_mass = all > zero ? 1 / all : zero;

  if constexpr (!Batch::plane) {
    // The direction in which they will touch, or pass each other, where they move far within the step.
    const auto moving = (gap > zero) & (dot(v, v) * (h * h) > reach * reach * Real(1. / 4096));
    if (any(moving))
      for (int lane = 0; lane < used; ++lane) {
        if (!moving[lane]) continue;
        const Vector3 from(d.x[lane], d.y[lane], d.z[lane]), by(v.x[lane], v.y[lane], v.z[lane]);
        Real t = time_of_contact(from, by, reach[lane]);
        if (t < 0) t = std::max(Real(0), -from.dot(by) / by.squaredNorm());
        set_lane(batch.normal, lane, (from + std::min(t, h) * by).normalized());
      }
  }
  const Lanes u_n = dot(batch.normal, v);
  const auto near = (gap > zero) & (gap + u_n * h < zero) & (u_n < spread(-2 * gravity_ * h));
  // What gives nothing back passes a blow on all the same; of many spheres that is left to the sweeps.
  const bool all_pairs = spheres.count <= most_that_pass_on;
  if (bounces_ || all_pairs || any(near))
    for (int lane = 0; lane < used; ++lane) {
      const Material& pair = material(spheres, batch.a[lane], batch.b[lane], Batch::plane);
      if (near[lane] || all_pairs || pair.restitution > 0)
        approaching.push_back({batch.a[lane], batch.b[lane] + (Batch::plane ? spheres.count : 0), pair});
    }

  if (model_.surface_count == 1)
    batch.friction = spread(model_.materials[0].friction);
  else
    for (int lane = 0; lane < lane_count; ++lane)
      batch.friction[lane] =
          lane < used ? material(spheres, batch.a[lane], batch.b[lane], Batch::plane).friction : 0;
  Lanes3 t;
  pile::load(old_impulses_.data(), batch.old, 4, batch.impulse, t.x, t.y, t.z);
  batch.tangential = t - dot(batch.normal, t) * batch.normal;
}

void SphereContacts::pack(const Spheres& spheres, Block& block) {
  thread_local Window<PairBatch> pairs;
  thread_local Window<PlaneBatch> planes;
  block.pairs.clear(), block.planes.clear(), block.border.clear(), block.approaching.clear();
  const int spare = spheres.count + static_cast<int>(&block - blocks_.data());
  const auto finish = [&](auto& to) {
    return [&](auto& batch, int used) {
      prepare(spheres, batch, used, spare, block.approaching);
      to.push_back(batch);
    };
  };
  pairs.start(static_cast<std::size_t>(block.last - block.first));
  planes.start(static_cast<std::size_t>(block.last - block.first));
  for (int i = block.first; i < block.last; ++i) {
    const auto k = static_cast<std::size_t>(i - block.first);
    const int old_first = block.old_start[k], old_last = block.old_start[k + 1];
    int old = old_first;  // pairs mostly come in the order of the step before
    for (int pair = block.start[k]; pair < block.start[k + 1]; ++pair) {
      const int other = block.other[static_cast<std::size_t>(pair)];
      int row = 0;
      for (int tries = old_last - old_first; tries > 0 && row == 0; --tries) {
        if (block.old_other[static_cast<std::size_t>(old)] == other) row = block.old_base + old;
        if (++old == old_last) old = old_first;
      }
      const Found found{i, other, block.base + pair, row};
      if (other >= spheres.count)
        planes.add(
            i - block.first, -1,
            [&](auto& batch, int lane) { put(batch, lane, i, other - spheres.count, found.pair, row); },
            finish(block.planes));
      else if (other < block.last)
        pairs.add(
            i - block.first, other - block.first,
            [&](auto& batch, int lane) { put(batch, lane, i, other, found.pair, row); }, finish(block.pairs));
      else
        block.border.push_back(found);
    }
  }
  pairs.flush(finish(block.pairs)), planes.flush(finish(block.planes));
}

void SphereContacts::pack_border(const Spheres& spheres) {
  const int spare = spheres.count;
  colours_of_.assign(static_cast<std::size_t>(spheres.count), 0);
  rest_window_.start(static_cast<std::size_t>(spheres.count));
  std::array<int, 64> used{};  // lanes in use in the last batch of each colour
  for (auto& colour : colours_) colour.clear();
  rest_.clear();
  std::vector<Approaching>& approaching = blocks_[0].approaching;
  const auto finish = [&](PairBatch& batch, int lanes) {
    prepare(spheres, batch, lanes, spare, approaching);
    rest_.push_back(batch);
  };
  for (Block& block : blocks_)
    for (const Found& found : block.border) {
      const auto a = static_cast<std::size_t>(found.a), b = static_cast<std::size_t>(found.b);
      const auto colour = static_cast<std::size_t>(std::countr_one(colours_of_[a] | colours_of_[b]));
      const auto fill = [&](PairBatch& batch, int lane) {
        put(batch, lane, found.a, found.b, found.pair, found.old);
      };
      if (colour == 64) {
        rest_window_.add(found.a, found.b, fill, finish);
        continue;
      }
      colours_of_[a] |= std::uint64_t{1} << colour, colours_of_[b] |= std::uint64_t{1} << colour;
      if (used[colour] == 0) colours_[colour].emplace_back();
      fill(colours_[colour].back(), used[colour]);
      if (++used[colour] == lane_count) {
        prepare(spheres, colours_[colour].back(), lane_count, spare, approaching);
        used[colour] = 0;
      }
    }
  for (std::size_t colour = 0; colour < 64; ++colour)
    if (used[colour] > 0) prepare(spheres, colours_[colour].back(), used[colour], spare, approaching);
  rest_window_.flush(finish);
}

void SphereContacts::remember() {
  sweep([&](const auto& batch) {
    store(impulses_.data(), batch.pair, 4, batch.impulse, batch.tangential.x, batch.tangential.y,
          batch.tangential.z);
  });
}

void SphereContacts::reorder(const std::vector<int>& position) {
  struct Kept {
    int a, b;
    std::array<Real, 4> impulse;
  };
  std::vector<Kept> kept;
  const int n = static_cast<int>(position.size());
  for (const Block& block : blocks_)
    for (int i = block.first; i < block.last; ++i)
      for (int k = block.start[static_cast<std::size_t>(i - block.first)];
           k < block.start[static_cast<std::size_t>(i - block.first) + 1]; ++k) {
        const Real* j = impulses_.data() + std::ptrdiff_t{4} * (block.base + k);
        const int other = block.other[static_cast<std::size_t>(k)];
        int a = position[static_cast<std::size_t>(i)];
        int b = other < n ? position[static_cast<std::size_t>(other)] : other;
        const bool swapped = b < a;  // the tangential impulse is that on a
        const Real sign = swapped ? Real(-1) : Real(1);
        if (swapped) std::swap(a, b);
        kept.push_back({a, b, {j[0], sign * j[1], sign * j[2], sign * j[3]}});
      }
  std::stable_sort(kept.begin(), kept.end(), [](const Kept& x, const Kept& y) { return x.a < y.a; });
  std::size_t next = 0;
  const int first_row = 1 + static_cast<int>(blocks_.size());
  for (Block& block : blocks_) {
    block.base = first_row + static_cast<int>(next);
    block.other.clear();
    for (int i = block.first; i < block.last; ++i) {
      block.start[static_cast<std::size_t>(i - block.first)] = static_cast<int>(block.other.size());
      for (; next < kept.size() && kept[next].a == i; ++next) {
        block.other.push_back(kept[next].b);
        std::copy(kept[next].impulse.begin(), kept[next].impulse.end(),
                  impulses_.begin() + 4 * (first_row + static_cast<std::ptrdiff_t>(next)));
      }
    }
    block.start.back() = static_cast<int>(block.other.size());
  }
}

}  // namespace cylon::engine::pile
