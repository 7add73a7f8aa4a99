// Where bodies of any shape touch, or will within the step, as blocks; joints as blocks too.
#pragma once

#include "engine/geometry/broad_phase.h"
#include "engine/pile/block.h"

#include <utility>
#include <vector>

namespace cylon::engine::pile {

class BodyContacts {
 public:
  explicit BodyContacts(const Model&);

  /// Fills `blocks` with the contacts that can matter within `span` [s], each with the impulse that the same
  /// point had in `blocks` before, and with the joints.
  void find(const std::vector<Motion>&, const std::vector<Mover>&, Time span, std::vector<Block>& blocks);

  /// The least half-width of any shape [m]; 0: there is none.
  Real smallest() const { return smallest_; }

 private:
  void find_pairs(const std::vector<Motion>&);
  void touch(const std::vector<Motion>&, int a, int b, int plane, Real margin, const std::vector<Block>& old,
             std::size_t& next, std::vector<Block>&);
  void add_joints(const std::vector<Motion>&, const std::vector<Block>& old, std::vector<Block>&) const;

  const Model& model_;
  Real smallest_ = 0;
  std::vector<Real> radius_, margin_;
  std::vector<Bounds> bounds_;
  BroadPhase broad_phase_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<Block> old_;
};

/// Body to world; the identity for the world.
Quaternion orientation_of(int body, const std::vector<Motion>&);

/// The gap of a contact, or the distance from one point to the other of a part of a joint, now.
Vector3 offset(const Block&, const std::vector<Motion>&);

}  // namespace cylon::engine::pile
