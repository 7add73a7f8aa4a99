#include "engine/pile/sphere_contacts.h"

#include <bit>
#include <cmath>
#include <limits>

namespace cylon::engine::pile {
namespace {

using Row = Eigen::Map<const Vector3>;

void set_lane(Lanes3& lanes, int lane, const Vector3& value) {
  lanes.x[lane] = value[0], lanes.y[lane] = value[1], lanes.z[lane] = value[2];
}

// Lanes without a contact act on a row of zeros, one for each block.
template <class Batch>
void pad(Batch& batch, int used, int spare) {
  for (int lane = used; lane < lane_count; ++lane) {
    set_lane(batch.normal, lane, Vector3::Zero()), set_lane(batch.tangential, lane, Vector3::Zero());
    batch.mass[lane] = batch.tangent_mass[lane] = batch.friction[lane] = batch.impulse[lane] = 0;
    batch.a[lane] = spare, batch.pair[lane] = 0;
    if constexpr (requires { batch.b; })
      batch.b[lane] = spare;
    else
      batch.offset[lane] = 0;
  }
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
    block.start.assign(static_cast<std::size_t>(block.last - block.first + 1), 0);
    block.old_start = block.start;
  }
  for (const Material& material : model.materials) bounces_ |= material.restitution > 0;
}

void SphereContacts::find(const Spheres& spheres, Time span, Real gravity) {
  span_ = span, gravity_ = gravity;
  const Real h = static_cast<Real>(span);
  for (int i = 0; i < spheres.count; ++i) {
    const Real* v = spheres.v(i);
    const Real r = spheres.p(i)[3];
    // how far a body gets in a step, twice for what may strike it, and a little more
    reach_[static_cast<std::size_t>(i)] = spheres.surface[static_cast<std::size_t>(i)] == no_surface
                                              ? -1
                                              : r + h * (std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) +
                                                         gravity * h) + r / 256;
  }
  grid_.build(spheres, reach_);
  threads_.for_each(blocks_.size(), 1, [&](std::size_t k) { find_pairs(spheres, blocks_[k]); });
  std::swap(impulses_, old_impulses_);
  int total = 0;
  for (Block& block : blocks_) {
    block.base = total;
    total += static_cast<int>(block.other.size());
  }
  impulses_.resize(4 * static_cast<std::size_t>(total));
  threads_.for_each(blocks_.size(), 1, [&](std::size_t k) { pack(spheres, blocks_[k]); });
  pack_border(spheres);
  approaching_.clear();
  for (const Block& block : blocks_)
    approaching_.insert(approaching_.end(), block.approaching.begin(), block.approaching.end());
}

void SphereContacts::find_pairs(const Spheres& spheres, Block& block) {
  std::swap(block.start, block.old_start), std::swap(block.other, block.old_other);
  block.old_base = block.base;
  block.other.clear();
  for (int i = block.first; i < block.last; ++i) {
    block.start[static_cast<std::size_t>(i - block.first)] = static_cast<int>(block.other.size());
    const Real* p = spheres.p(i);
    const Real reach = reach_[static_cast<std::size_t>(i)];
    if (reach < 0) continue;
    grid_.near(i, p, reach, [&](int j) { block.other.push_back(j); });
    for (std::size_t k = 0; k < model_.planes.size(); ++k) {
      const Plane& plane = model_.planes[k];
      if (plane.normal.dot(Row(p)) - plane.offset < reach && model_.plane_surfaces[k] != no_surface)
        block.other.push_back(spheres.count + static_cast<int>(k));
    }
  }
  block.start.back() = static_cast<int>(block.other.size());
}

const Real* SphereContacts::old_impulse(const Block& block, int a, int b) const {
  const auto k = static_cast<std::size_t>(a - block.first);
  for (int pair = block.old_start[k]; pair < block.old_start[k + 1]; ++pair)
    if (block.old_other[static_cast<std::size_t>(pair)] == b)
      return old_impulses_.data() + 4 * (block.old_base + pair);
  return nullptr;
}

template <class Batch>
void SphereContacts::set(const Spheres& spheres, const Block& block, const Found& found, Batch& batch, int lane,
                         std::vector<Approaching>& approaching) {
  constexpr bool plane = !requires { batch.b; };
  const Real *va = spheres.v(found.a), *pa = spheres.p(found.a);
  const Real h = static_cast<Real>(span_);
  const int surface = spheres.surface[static_cast<std::size_t>(found.a)];
  Vector3 n, v = Row(va);
  Real gap, inverse = va[3], spin_inverse = va[7];
  const Material* material;
  if constexpr (plane) {
    const auto k = static_cast<std::size_t>(found.b - spheres.count);
    n = model_.planes[k].normal;
    gap = n.dot(Row(pa)) - model_.planes[k].offset - pa[3];
    batch.offset[lane] = model_.planes[k].offset;
    material = &model_.material(surface, model_.plane_surfaces[k]);
  } else {
    const Real *vb = spheres.v(found.b), *pb = spheres.p(found.b);
    v -= Row(vb);
    inverse += vb[3], spin_inverse += vb[7];
    const Vector3 d = Row(pa) - Row(pb);
    const Real length = d.norm(), reach = pa[3] + pb[3];
    gap = length - reach;
    n = length > 0 ? Vector3(d / length) : Vector3(Real(0.36), Real(0.8), Real(0.48));  // any unit vector
    // The direction in which they will touch, or pass each other, where they move far within the step.
    if (gap > 0 && v.squaredNorm() * h * h > reach * reach / 4096) {
      Real t = time_of_contact(d, v, reach);
      if (t < 0) t = std::max(Real(0), -d.dot(v) / v.squaredNorm());
      n = (d + std::min(t, h) * v).normalized();
    }
    material = &model_.material(surface, spheres.surface[static_cast<std::size_t>(found.b)]);
    batch.b[lane] = found.b;
  }
  const Real u_n = n.dot(v), e = material->restitution;
  if ((bounces_ && e > 0) || (gap > 0 && gap + u_n * h < 0 && u_n < -2 * gravity_ * h))
    approaching.push_back({found.a, found.b, *material});

  batch.a[lane] = found.a;
  batch.pair[lane] = block.base + found.pair;
  batch.mass[lane] = inverse > 0 ? 1 / inverse : 0;
  batch.tangent_mass[lane] = inverse + spin_inverse > 0 ? 1 / (inverse + spin_inverse) : 0;
  batch.friction[lane] = material->friction;
  const Real* old = old_impulse(block, found.a, found.b);
  batch.impulse[lane] = old ? old[0] : 0;
  Vector3 tangential = old ? Vector3(Row(old + 1)) : Vector3(Vector3::Zero());
  tangential -= n.dot(tangential) * n;
  set_lane(batch.normal, lane, n), set_lane(batch.tangential, lane, tangential);
  set_lane(batch.normal, lane, n);
}

void SphereContacts::pack(const Spheres& spheres, Block& block) {
  thread_local Window<PairBatch> pairs;
  thread_local Window<PlaneBatch> planes;
  block.pairs.clear(), block.planes.clear(), block.border.clear(), block.approaching.clear();
  const int size = block.last - block.first, spare = spheres.count + static_cast<int>(&block - blocks_.data());
  pairs.start(static_cast<std::size_t>(size)), planes.start(static_cast<std::size_t>(size));
  const auto finish = [&](auto& to) {
    return [&to, spare](auto& batch, int used) { pad(batch, used, spare), to.push_back(batch); };
  };
  for (int i = block.first; i < block.last; ++i) {
    const auto k = static_cast<std::size_t>(i - block.first);
    for (int pair = block.start[k]; pair < block.start[k + 1]; ++pair) {
      const Found found{i, block.other[static_cast<std::size_t>(pair)], pair};
      const auto fill = [&](auto& batch, int lane) {
        set(spheres, block, found, batch, lane, block.approaching);
      };
      if (found.b >= spheres.count)
        planes.add(i - block.first, -1, fill, finish(block.planes));
      else if (spheres.v(i)[3] + spheres.v(found.b)[3] == 0)
        continue;
      else if (found.b < block.last)
        pairs.add(i - block.first, found.b - block.first, fill, finish(block.pairs));
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
  const auto finish = [&](PairBatch& batch, int lanes) { pad(batch, lanes, spare), rest_.push_back(batch); };
  for (Block& block : blocks_)
    for (const Found& found : block.border) {
      const auto a = static_cast<std::size_t>(found.a), b = static_cast<std::size_t>(found.b);
      const auto colour = static_cast<std::size_t>(std::countr_one(colours_of_[a] | colours_of_[b]));
      const auto fill = [&](PairBatch& batch, int lane) {
        set(spheres, block, found, batch, lane, block.approaching);
      };
      if (colour == 64) {
        rest_window_.add(found.a, found.b, fill, finish);
        continue;
      }
      colours_of_[a] |= std::uint64_t{1} << colour, colours_of_[b] |= std::uint64_t{1} << colour;
      if (used[colour] == 0) colours_[colour].emplace_back();
      fill(colours_[colour].back(), used[colour]);
      used[colour] = (used[colour] + 1) % lane_count;
    }
  for (std::size_t colour = 0; colour < 64; ++colour)
    if (used[colour] > 0) pad(colours_[colour].back(), used[colour], spare);
  rest_window_.flush(finish);
}

void SphereContacts::remember() {
  sweep([&](const auto& batch) {
    for (int lane = 0; lane < lane_count && batch.mass[lane] > 0; ++lane) {
      Real* to = impulses_.data() + 4 * batch.pair[lane];
      to[0] = batch.impulse[lane], to[1] = batch.tangential.x[lane];
      to[2] = batch.tangential.y[lane], to[3] = batch.tangential.z[lane];
    }
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
           k < block.start[static_cast<std::size_t>(i - block.first + 1)]; ++k) {
        const Real* j = impulses_.data() + 4 * (block.base + k);
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
  for (Block& block : blocks_) {
    block.base = static_cast<int>(next);
    block.other.clear();
    for (int i = block.first; i < block.last; ++i) {
      block.start[static_cast<std::size_t>(i - block.first)] = static_cast<int>(block.other.size());
      for (; next < kept.size() && kept[next].a == i; ++next) {
        block.other.push_back(kept[next].b);
        std::copy(kept[next].impulse.begin(), kept[next].impulse.end(),
                  impulses_.begin() + 4 * static_cast<std::ptrdiff_t>(next));
      }
    }
    block.start.back() = static_cast<int>(block.other.size());
  }
}

}  // namespace cylon::engine::pile
