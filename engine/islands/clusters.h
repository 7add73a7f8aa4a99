// Moving bodies that interact for good: what joints and forces between bodies tie together.
#pragma once

#include "engine/model.h"

#include <array>
#include <optional>
#include <vector>

namespace cylon::engine::islands {

/// Bodies are listed in ascending order, joints and forces in the order of the model.
struct Cluster {
  std::vector<int> bodies;   ///< That move.
  std::vector<int> holders;  ///< Locked bodies at the other end of a joint or a force.
  std::vector<int> joints;
  std::array<std::vector<int>, std::tuple_size_v<decltype(force_lists)>>
      forces;  ///< One list per force_lists.
};

/// Every moving body is in one cluster; clusters are in the order of their first bodies.  Forces that act on
/// every body (water) tie nothing and are listed in all.
std::vector<Cluster> find_clusters(const Model&);

/// A ball that a point never leaves [m].
struct Ball {
  Vector3 centre = Vector3::Zero();
  Real radius = 0;
};

/// Per body, the ball in which joints hold its reference point for all time: with x the place at which a
/// chain of joints is fastened to the world or to a locked body,
///   |p - x| <= sum over the joints of the chain of |anchor| + length + |anchor on the next body|
/// and 1 % more, as joints close to rounding or to the error of a step.  Nothing where no chain does.
std::vector<std::optional<Ball>> find_bounds(const Model&);

}  // namespace cylon::engine::islands
