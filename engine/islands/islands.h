// The parts of a scene that do not interact now, and the model of each.
#pragma once

#include "engine/islands/clusters.h"

#include <cstdint>
#include <vector>

namespace cylon::engine::islands {

/// The model of some clusters.  `bodies` and `planes` are those of the whole model, ascending: bodies that
/// move, locked ones that hold them or that they may touch, and planes that they may touch.
struct Part {
  Model model;
  std::vector<int> bodies, planes;
  std::vector<int> laws;  ///< Forces::coordinate_laws.
};

/// Where a body may be until it is looked at again.
struct Range {
  Ball ball;              ///< Of the reference point.
  Real shape = 0;         ///< Radius of the shape about it [m].
  bool for_ever = false;  ///< A bound by joints; else the ball is one of the times ahead.
};

/// What may touch what in a model, for all time and in the times ahead.
///
/// For all time: a surface of a body and a plane or a locked body that the body's bound by joints reaches;
/// all of them where it has no bound.  In the times ahead: two clusters of which two bodies that may touch
/// have ranges that overlap.  The range of a body at p with speed v and acceleration a is
///   |x - p| <= max(|v| T + a T^2/2, radius of its shape),  T = ahead dt
/// or its bound by joints where that is smaller.  It is no promise: World looks after every step whether
/// bodies are still within it; one that leaves it and returns within a step is not seen.
class Interactions {
 public:
  /// Steps for which ranges are made.
  static constexpr int ahead = 64;
  /// Ranges of more bodies than this are not looked at: all that may touch something that moves are one
  /// island.
  static constexpr std::size_t most_watched = 512;

  Interactions(const Model&, Time dt);

  const std::vector<Cluster>& clusters() const { return clusters_; }

  /// The bodies of a cluster that may touch moving bodies of other clusters.
  const std::vector<int>& touching(std::size_t cluster) const { return touching_[cluster]; }

  /// The clusters with such bodies, ascending.
  const std::vector<std::size_t>& open() const { return open_; }

  /// Whether clusters that are apart now may ever meet.
  bool may_meet() const { return may_meet_; }
  /// Whether they could, but are more than are watched.
  bool too_many() const { return open_.size() > 1 && !may_meet_; }
  /// Whether two clusters may, in the times ahead; ranges: one per body.
  bool may_meet(std::size_t, std::size_t, const std::vector<Range>&) const;

  /// The range of a moving body, `part` times as far ahead; `acceleration` beside gravity [m/s^2].
  Range range(int body, const Body&, const Motion&, Real acceleration, Real part = 1) const;

  /// Groups of clusters that may touch in the times ahead, in the order of their first clusters; each
  /// ascending.
  std::vector<std::vector<std::size_t>> groups(const std::vector<Range>&,
                                               const std::vector<std::size_t>& clusters) const;

  /// Whether gravity alone ever acts on a cluster of one body unless it meets what moves.
  bool flies(std::size_t cluster) const;

  /// The model of some clusters, ascending, with the motions of all bodies at its start.  A surface that can
  /// touch nothing in it is gone.
  Part part(const std::vector<std::size_t>& clusters, const std::vector<Motion>&) const;

  /// The same of bodies that fly (flies()), without surfaces: each moves by itself.
  Part flight(const std::vector<std::size_t>& clusters, const std::vector<Motion>&) const;

 private:
  bool reaches_plane(int body, int plane) const;
  bool reaches(int body, int locked) const;
  bool may_touch(int, int) const;

  const Model& model_;
  Time span_;  // ahead dt
  std::vector<Cluster> clusters_;
  std::vector<std::optional<Ball>> bounds_;
  std::vector<int> obstacles_;  // locked bodies with a surface
  std::vector<std::vector<int>> touching_;
  std::vector<std::size_t> open_;
  bool may_meet_ = false;
};

/// Whether the ranges of two bodies overlap.
bool overlap(const Range&, const Range&);

}  // namespace cylon::engine::islands
