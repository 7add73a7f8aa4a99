#include "engine/pile/block_factor.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace cylon::engine::pile {

void BlockFactor::set_pattern(int bodies, std::vector<Pair> couples) {
  for (Pair& pair : couples)
    if (pair.first > pair.second) std::swap(pair.first, pair.second);
  std::sort(couples.begin(), couples.end());
  couples.erase(std::unique(couples.begin(), couples.end()), couples.end());
  if (bodies == bodies_ && couples == couples_) return;
  bodies_ = bodies, couples_ = std::move(couples);
  find_order();
}

// What a body leaves when it is eliminated is a column of L, and binds those that it was bound to.  Ties: the first.
void BlockFactor::find_order() {
  const std::size_t n = index(bodies_);
  std::vector<std::vector<int>> next(n), columns;
  for (const auto& [a, b] : couples_) next[index(a)].push_back(b), next[index(b)].push_back(a);
  std::set<Pair> by_degree;
  for (std::size_t i = 0; i < n; ++i) {
    std::sort(next[i].begin(), next[i].end());
    by_degree.emplace(static_cast<int>(next[i].size()), static_cast<int>(i));
  }
  order_.clear(), place_.assign(n, 0);
  std::vector<int> joined;
  while (!by_degree.empty()) {
    const int least = by_degree.begin()->second;
    by_degree.erase(by_degree.begin());
    place_[index(least)] = static_cast<int>(order_.size());
    order_.push_back(least);
    const std::vector<int> left = std::move(next[index(least)]);
    for (const int i : left) {
      std::vector<int>& of = next[index(i)];
      by_degree.erase({static_cast<int>(of.size()), i});
      joined.clear();
      std::set_union(of.begin(), of.end(), left.begin(), left.end(), std::back_inserter(joined));
      std::erase_if(joined, [&](int j) { return j == i || j == least; });
      of = joined;
      by_degree.emplace(static_cast<int>(of.size()), i);
    }
    columns.push_back(left);
  }
  start_.assign(1, 0), rows_.clear(), work_ = 0;
  for (std::vector<int>& column : columns) {
    for (int& row : column) row = place_[index(row)];
    std::sort(column.begin(), column.end());
    rows_.insert(rows_.end(), column.begin(), column.end());
    start_.push_back(rows_.size());
    const auto below = static_cast<std::int64_t>(column.size());
    work_ += 36 + 108 * below + 108 * below * (below + 1);
  }
  blocks_.assign(n + rows_.size(), Block::Zero());
}

void BlockFactor::clear() { std::fill(blocks_.begin(), blocks_.end(), Block::Zero()); }

std::size_t BlockFactor::find(int body, int other) const {
  const auto [column, row] = std::minmax(place_[index(body)], place_[index(other)]);
  const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(start_[index(column)]),
             end = rows_.begin() + static_cast<std::ptrdiff_t>(start_[index(column) + 1]);
  return order_.size() + static_cast<std::size_t>(std::lower_bound(begin, end, row) - rows_.begin());
}

// A pivot below the rounding of its row is rounding: a matrix a little stiffer is solved.
void BlockFactor::factor_diagonal(std::size_t k) {
  Block& l = blocks_[k];
  for (int c = 0; c < 6; ++c) {
    for (int r = c; r < 6; ++r)
      for (int d = 0; d < c; ++d) l(r, c) -= l(r, d) * l(c, d);
    l(c, c) = std::sqrt(std::max(l(c, c), 1e-14 * whole_[static_cast<Eigen::Index>(6 * k) + c]));
    for (int r = c + 1; r < 6; ++r) l(r, c) /= l(c, c);
  }
}

// L_ik = A_ik L_kk^-T,  A_ij -= L_ik L_jk^T for all i >= j below k.
void BlockFactor::factor() {
  const std::size_t n = order_.size();
  whole_.resize(static_cast<Eigen::Index>(6 * n));
  for (std::size_t k = 0; k < n; ++k)
    whole_.segment<6>(static_cast<Eigen::Index>(6 * k)) = blocks_[k].diagonal();
  for (std::size_t k = 0; k < n; ++k) {
    factor_diagonal(k);
    const Block& l = blocks_[k];
    const std::size_t from = start_[k], to = start_[k + 1];
    for (std::size_t e = from; e < to; ++e) {
      Block& x = blocks_[n + e];
      for (int c = 0; c < 6; ++c) {
        for (int d = 0; d < c; ++d) x.col(c) -= l(c, d) * x.col(d);
        x.col(c) /= l(c, c);
      }
    }
    for (std::size_t e = from; e < to; ++e) {
      const auto j = index(rows_[e]);
      const Block& of_j = blocks_[n + e];
      blocks_[j].noalias() -= of_j * of_j.transpose();
      std::size_t where = start_[j];
      for (std::size_t f = e + 1; f < to; ++f) {
        while (rows_[where] != rows_[f]) ++where;
        blocks_[n + where].noalias() -= blocks_[n + f] * of_j.transpose();
      }
    }
  }
}

void BlockFactor::solve(Vector& x) const {
  const std::size_t n = order_.size();
  const auto of = [&](int body) { return x.segment<6>(6 * static_cast<Eigen::Index>(body)); };
  for (std::size_t k = 0; k < n; ++k) {
    auto at = of(order_[k]);
    const Block& l = blocks_[k];
    for (int r = 0; r < 6; ++r) {
      for (int c = 0; c < r; ++c) at[r] -= l(r, c) * at[c];
      at[r] /= l(r, r);
    }
    for (std::size_t e = start_[k]; e < start_[k + 1]; ++e)
      of(order_[index(rows_[e])]).noalias() -= blocks_[n + e] * at;
  }
  for (std::size_t k = n; k-- > 0;) {
    auto at = of(order_[k]);
    const Block& l = blocks_[k];
    for (std::size_t e = start_[k]; e < start_[k + 1]; ++e)
      at.noalias() -= blocks_[n + e].transpose() * of(order_[index(rows_[e])]);
    for (int r = 6; r-- > 0;) {
      for (int c = r + 1; c < 6; ++c) at[r] -= l(c, r) * at[c];
      at[r] /= l(r, r);
    }
  }
}

}  // namespace cylon::engine::pile
