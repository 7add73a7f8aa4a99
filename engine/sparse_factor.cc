#include "engine/sparse_factor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace cylon::engine {

namespace {

// Up to so many rows, and while elimination adds no more than half of the entries, the order is theirs.
constexpr std::size_t few_rows = 48;

// For each row the others that act on the same bodies, itself left out, ascending.
std::vector<std::vector<std::size_t>> find_coupled(const std::vector<SparseFactor::Ends>& ends) {
  std::map<int, std::vector<std::size_t>> rows_of;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (const int body : ends[i])
      if (body != SparseFactor::none) rows_of[body].push_back(i);
  std::vector<std::vector<std::size_t>> coupled(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (const int body : ends[i])
      if (body != SparseFactor::none)
        coupled[i].insert(coupled[i].end(), rows_of[body].begin(), rows_of[body].end());
    std::sort(coupled[i].begin(), coupled[i].end());
    coupled[i].erase(std::unique(coupled[i].begin(), coupled[i].end()), coupled[i].end());
    std::erase(coupled[i], i);
  }
  return coupled;
}

}  // namespace

void SparseFactor::set_pattern(const std::vector<Ends>& ends) {
  if (ends == ends_) return;
  ends_ = ends, settled_ = 1, fresh_ = true;
  depended_.assign(ends.size(), 0);
  const Graph coupled = find_coupled(ends);
  std::vector<std::size_t> order(ends.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  find_fill(coupled, order);
  if (ends.size() <= few_rows) return;
  std::size_t given = ends.size();
  for (const auto& row : coupled) given += row.size();
  if (2 * entries() > 3 * ((given + ends.size()) / 2)) find_fill(coupled, least_degree_first(ends));
}

// Of rows with the same ends all or none are eliminated: they are one node of the graph.  Ties: the first.
// D. J. Rose, in Graph Theory and Computing (1972), 183.
std::vector<std::size_t> SparseFactor::least_degree_first(const std::vector<Ends>& ends) {
  std::map<Ends, std::size_t> node_of;
  std::vector<Ends> nodes;
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto [place, is_new] = node_of.try_emplace(ends[i], nodes.size());
    if (is_new) nodes.push_back(ends[i]), rows.emplace_back();
    rows[place->second].push_back(i);
  }
  const Graph coupled = find_coupled(nodes);
  std::vector<std::set<std::size_t>> next;
  std::set<std::pair<std::size_t, std::size_t>> by_degree;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    next.emplace_back(coupled[i].begin(), coupled[i].end());
    by_degree.emplace(next[i].size(), i);
  }
  std::vector<std::size_t> order;
  while (!by_degree.empty()) {
    const std::size_t least = by_degree.begin()->second;
    by_degree.erase(by_degree.begin());
    order.insert(order.end(), rows[least].begin(), rows[least].end());
    for (const std::size_t i : next[least]) {
      by_degree.erase({next[i].size(), i});
      next[i].insert(next[least].begin(), next[least].end());
      next[i].erase(i), next[i].erase(least);
      by_degree.emplace(next[i].size(), i);
    }
  }
  return order;
}

// Row k of L has the columns on the ways up the elimination tree from those of row k of A.
void SparseFactor::find_fill(const Graph& coupled, std::vector<std::size_t> order) {
  order_ = std::move(order);
  const std::size_t n = order_.size(), no_parent = n;
  std::vector<std::size_t> place(n), parent(n, no_parent), seen(n, n);
  for (std::size_t k = 0; k < n; ++k) place[order_[k]] = k;
  start_.assign(1, 0), column_.clear(), couples_.clear();
  for (std::size_t k = 0; k < n; ++k) {
    seen[k] = k;
    const std::size_t begin = column_.size();
    for (const std::size_t row : coupled[order_[k]])
      for (std::size_t j = place[row]; j < k && seen[j] != k; j = parent[j]) {
        if (parent[j] == no_parent) parent[j] = k;
        seen[j] = k;
        column_.push_back(j);
      }
    std::sort(column_.begin() + static_cast<std::ptrdiff_t>(begin), column_.end());
    for (std::size_t e = begin; e < column_.size(); ++e)
      couples_.push_back(
          std::binary_search(coupled[order_[k]].begin(), coupled[order_[k]].end(), order_[column_[e]]));
    column_.push_back(k), couples_.push_back(1);
    start_.push_back(column_.size());
  }
  value_.resize(column_.size());
  scaled_.assign(n, 0), turned_.resize(n), share_.resize(n);
}

void SparseFactor::set_order(std::vector<std::size_t> order) {
  find_fill(find_coupled(ends_), std::move(order));
}

// A pivot so small that it may be a dependent row's; or a small one where other rows may do for it.
Real SparseFactor::weak_share(Real dependent) const {
  return any_dependent_ ? Real(1) / 64 : std::sqrt(dependent);
}

std::vector<std::size_t> SparseFactor::weak_last(Real dependent) const {
  std::vector<std::size_t> order, last;
  for (std::size_t k = 0; k < order_.size(); ++k)
    (value_[start_[k + 1] - 1] > 0 && share_[k] < weak_share(dependent) ? last : order).push_back(order_[k]);
  order.insert(order.end(), last.begin(), last.end());
  return order;
}

constexpr Real above_rounding = 256;  // dependent = 4096 epsilon (constraint.cc), and sums round by some 16

// L_ij = (A_ij - sum_k<j L_ik D_k L_jk)/D_j,  D_i = A_ii - sum_j<i L_ij D_j L_ij;  `scaled_` has L_ik D_k.
// D_j has the rounding of A_jj, and so L_ij D_j L_ij one that is larger by A_jj/D_j; `dependent` is far above rounding.
void SparseFactor::eliminate(Real dependent) {
  weakest_ = 1, any_dependent_ = false;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const std::size_t last = start_[i + 1] - 1;
    const Real whole = value_[last];
    Real d = whole, rounded = 0;
    for (std::size_t e = start_[i]; e < last; ++e) {
      const std::size_t j = column_[e], diagonal = start_[j + 1] - 1;
      Real sum = value_[e];
      for (std::size_t f = start_[j]; f < diagonal; ++f) sum -= scaled_[column_[f]] * value_[f];
      const Real pivot = value_[diagonal], l = pivot > 0 ? sum / pivot : 0;
      value_[e] = l, scaled_[j] = l * pivot;
      d -= l * scaled_[j];
      if (pivot > 0) rounded += l * scaled_[j] / share_[j];
    }
    for (std::size_t e = start_[i]; e < last; ++e) scaled_[column_[e]] = 0;
    const Real least = std::max(dependent * std::max(whole, rounded / above_rounding),
                                depended_[order_[i]] ? std::sqrt(dependent) * whole : Real(0));
    value_[last] = d > least ? d : 0;
    share_[i] = whole > 0 ? d / whole : 0;
    if (value_[last] > 0)
      weakest_ = std::min(weakest_, share_[i]);
    else
      any_dependent_ = true;
  }
}

void SparseFactor::solve(std::vector<Real>& x) {
  const std::size_t n = order_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t last = start_[i + 1] - 1;
    Real y = x[order_[i]];
    for (std::size_t e = start_[i]; e < last; ++e) y -= value_[e] * turned_[column_[e]];
    turned_[i] = value_[last] > 0 ? y : 0;
  }
  for (std::size_t i = n; i-- > 0;) {
    const std::size_t last = start_[i + 1] - 1;
    if (value_[last] > 0) turned_[i] /= value_[last];
  }
  for (std::size_t i = n; i-- > 0;) {
    const std::size_t last = start_[i + 1] - 1;
    for (std::size_t e = start_[i]; e < last; ++e)
      if (value_[start_[column_[e] + 1] - 1] > 0) turned_[column_[e]] -= value_[e] * turned_[i];
  }
  for (std::size_t i = 0; i < n; ++i) x[order_[i]] = turned_[i];
}

}  // namespace cylon::engine
