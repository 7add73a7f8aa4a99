// Sets of numbers that grow together; each is known by its least member.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace cylon::engine::islands {

class Unions {
 public:
  explicit Unions(std::size_t n) : root_(n) { std::iota(root_.begin(), root_.end(), std::size_t{0}); }

  std::size_t find(std::size_t i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t k) {
    const std::size_t a = find(i), b = find(k);
    root_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> root_;
};

}  // namespace cylon::engine::islands
