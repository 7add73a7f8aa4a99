#include "engine/contact/neighbours.h"

namespace cylon::engine {

Neighbours::Neighbours(const std::vector<Candidate>& candidates, const std::vector<Body>& bodies)
    : candidates_(candidates) {
  std::vector<char> paired(bodies.size(), 0);
  for (const Candidate& c : candidates_) {
    if (c.other == fixed_world || is_of_joint(c)) continue;
    for (const auto& [body, reach] : {std::pair(c.body, c.reach), std::pair(c.other, c.other_reach)}) {
      if (bodies[index(body)].locked) continue;
      paired[index(body)] = 1;
      least_room_ = std::max(least_room_, reach);
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (paired[i]) bodies_.push_back(i);
  places_.resize(bodies_.size(), Vector3::Zero());
}

void Neighbours::find(const Motion* motion, Real room) {
  room_ = std::max(least_room_, room);
  near_.clear();
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const Candidate& c = candidates_[i];
    if (c.other != fixed_world && !is_of_joint(c)) {
      const Real reach = c.reach + c.other_reach + room_;
      const Real square = (motion[index(c.body)].position - motion[index(c.other)].position).squaredNorm();
      if (square > reach * reach) continue;
    }
    near_.push_back(i);
  }
}

}  // namespace cylon::engine
