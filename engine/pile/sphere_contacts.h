// The contacts of a pile of spheres in one step: found, given their impulses of the step before, and packed.
//
// Bodies are cut into blocks of equal number, in their order in space.  Contacts within a block are swept by
// one thread, block beside block; those between blocks afterwards, colour by colour.  Neither knows how many
// threads there are.
#pragma once

#include "engine/pile/sphere_grid.h"
#include "engine/pile/sphere_impact.h"
#include "engine/pile/threads.h"
#include "engine/pile/window.h"

#include <array>
#include <vector>

namespace cylon::engine::pile {

class SphereContacts {
 public:
  static constexpr int block_size = 1024;
  /// Up to so many spheres, impacts without restitution are passed on at their instant.
  static constexpr int most_that_pass_on = 256;

  SphereContacts(const Model&, Threads&);

  /// Finds the contacts that can matter within `span`, those coming near fast aside too.
  void find(const Spheres&, Time span, Real gravity);

  const std::vector<Approaching>& approaching() const { return approaching_; }

  /// Calls f(batch) for every batch of contacts, no two at once that have a body in common.
  template <class F>
  void sweep(F&& f) {
    threads_.for_each(blocks_.size(), 1, [&](std::size_t k) {
      for (PairBatch& batch : blocks_[k].pairs) f(batch);
      for (PlaneBatch& batch : blocks_[k].planes) f(batch);
    });
    for (auto& colour : colours_) threads_.for_each(colour.size(), 64, [&](std::size_t k) { f(colour[k]); });
    for (PairBatch& batch : rest_) f(batch);
  }

  /// Calls f(batch) for every batch, one after the other, in an order that only the bodies decide.
  template <class F>
  void each(F&& f) const {
    for (const Block& block : blocks_) {
      for (const PairBatch& batch : block.pairs) f(batch);
      for (const PlaneBatch& batch : block.planes) f(batch);
    }
    for (const auto& colour : colours_)
      for (const PairBatch& batch : colour) f(batch);
    for (const PairBatch& batch : rest_) f(batch);
  }

  /// Rows of impulses of this step: a batch's `pair` is less.
  std::size_t rows() const { return impulses_.size() / 4; }

  /// Keeps the impulses for the next step.
  void remember();

  /// The bodies were put in another order; position[i]: where body i went.
  void reorder(const std::vector<int>& position);

  std::size_t pairs() const { return impulses_.size() / 4 - 1 - blocks_.size(); }

 private:
  struct Found {
    int a, b;
    int pair, old;  // rows of the impulses, of this step and of the one before
  };
  struct Block {
    int first = 0, last = 0, base = 0;
    // The pairs of body i: other[start[i - first]] ...; planes come after the last body.
    std::vector<int> start, other;
    std::vector<int> old_start, old_other;  // of the step before
    int old_base = 0;
    std::vector<PairBatch> pairs;
    std::vector<PlaneBatch> planes;
    std::vector<Found> border;
    std::vector<Approaching> approaching;
  };

  void find_pairs(const Spheres&, Block&);
  int leave_out_filtered(const Spheres&, int i, int* found, int count) const;
  void pack(const Spheres&, Block&);
  void pack_border(const Spheres&);
  template <class Batch>
  void prepare(const Spheres&, Batch&, int used, int spare, std::vector<Approaching>&);
  const Material& material(const Spheres&, int a, int b, bool plane) const;

  const Model& model_;
  Aligned<Real> planes_;  // rows (normal, offset)
  Threads& threads_;
  Time span_ = 0;
  Real gravity_ = 0;
  bool bounces_ = false;
  SphereGrid grid_;
  std::vector<Real> reach_;
  std::vector<Block> blocks_;
  std::array<std::vector<PairBatch>, 64> colours_;
  std::vector<PairBatch> rest_;  // of bodies with more than 64 contacts across blocks
  std::vector<std::uint64_t> colours_of_;
  Window<PairBatch> rest_window_;
  Aligned<Real> impulses_, old_impulses_;  // rows (normal, tangential); none, empty lanes, pairs
  std::vector<Approaching> approaching_;
};

}  // namespace cylon::engine::pile
