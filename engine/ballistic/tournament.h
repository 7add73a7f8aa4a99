// Who comes first: a tree of winners over a fixed number of players, one key each.  No allocation after it is
// made; a changed key costs one path to the root.
#pragma once

#include "engine/vector.h"

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace cylon::engine::ballistic {

/// Order of events: by time, at equal times by the indices of the pair, so that it never depends on history.
struct Key {
  Time time = std::numeric_limits<Time>::infinity();
  int first = 0, second = 0;

  bool operator<(const Key& other) const {
    if (time != other.time) return time < other.time;
    return first != other.first ? first < other.first : second < other.second;
  }
};

class Tournament {
 public:
  explicit Tournament(std::size_t players) {
    while (leaves_ < players) leaves_ *= 2;
    keys_.resize(leaves_);
    winners_.resize(2 * leaves_);
    for (std::size_t i = 0; i < leaves_; ++i) winners_[leaves_ + i] = i;
    for (std::size_t node = leaves_ - 1; node > 0; --node) play(node);
  }

  std::size_t first() const { return winners_[1]; }
  const Key& key(std::size_t player) const { return keys_[player]; }

  void set(std::size_t player, const Key& key) {
    keys_[player] = key;
    for (std::size_t node = (leaves_ + player) / 2; node > 0; node /= 2) {
      const std::size_t before = winners_[node];
      if (play(node) != player && before != player) return;  // nothing changes further up
    }
  }

 private:
  std::size_t play(std::size_t node) {
    const std::size_t left = winners_[2 * node], right = winners_[2 * node + 1];
    return winners_[node] = keys_[right] < keys_[left] ? right : left;
  }

  std::size_t leaves_ = 1;
  std::vector<Key> keys_;
  std::vector<std::size_t> winners_;  // node k plays 2k against 2k + 1
};

}  // namespace cylon::engine::ballistic
