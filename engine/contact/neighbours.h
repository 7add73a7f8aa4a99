// Which candidates are near each other, so that bodies far from all that moves cost nothing in a step.
#pragma once

#include "engine/contact/candidate.h"

#include <algorithm>

namespace cylon::engine {

/// Keeps a list of the candidates whose bounding balls are nearer than some room, and finds it anew when bodies
/// have moved by half of that.  What is left out is apart: the list is the same as all candidates.
class Neighbours {
 public:
  /// Keeps a reference to the candidates.
  Neighbours(const std::vector<Candidate>&, const std::vector<Body>&);

  /// Numbers of candidates, ascending: those with a plane and those of joints, and the pairs whose bounding balls may come nearer
  /// than `margin` [m] while each body i is at most away(i, place) [m] from any place.  Valid until the next
  /// call.
  template <class Away>
  const std::vector<std::size_t>& near(const Motion* motion, Real margin, Away away) {
    const auto need = [&] {
      Real most = 0;
      for (std::size_t k = 0; k < bodies_.size(); ++k) most = std::max(most, away(bodies_[k], places_[k]));
      return 2 * most + margin;
    };
    // Not a list that a fast body has left too long, either.
    const Real now = need();
    if (!(now <= room_ && room_ <= 8 * std::max(now, least_room_))) {
      for (std::size_t k = 0; k < bodies_.size(); ++k) places_[k] = motion[bodies_[k]].position;
      find(motion, 2 * need());
    }
    return near_;
  }

 private:
  void find(const Motion*, Real room);

  const std::vector<Candidate>& candidates_;
  std::vector<std::size_t> bodies_;  // of pairs, that move
  std::vector<Vector3> places_;      // of these when the list was found
  Real least_room_ = 0, room_ = -1;  // [m]
  std::vector<std::size_t> near_;
};

}  // namespace cylon::engine
