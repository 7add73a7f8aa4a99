#include "engine/geometry/broad_phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace cylon::engine {
namespace {

// A key is level | z | y | x.  A level's cells are 2^-level times the largest body; bodies of a level are not
// larger than its cells, so those that overlap have low corners in the same or neighbouring cells.
constexpr int bits = 19, most_levels = 16;
constexpr std::int64_t most_cells = (std::int64_t{1} << bits) - 2;  // one is kept free on each side

struct Cell {
  std::int64_t x, y, z;
};

std::uint64_t key_of(int level, const Cell& cell) {
  const auto part = [](std::int64_t i) { return static_cast<std::uint64_t>(i); };
  return ((part(level) << bits | part(cell.z)) << bits | part(cell.y)) << bits | part(cell.x);
}

constexpr double room =
    1 + 1e-6;  // cells over bodies: more than rounding of the cell's number, for float too

struct Lattice {
  Vector3 origin;
  double largest = 0;  // cell of level 0 [m]
  int levels = 1;

  double cell(int level) const { return std::ldexp(largest, -level); }
  Cell at(const Vector3& x, int level) const {
    const double size = cell(level);
    const auto along = [&](int k) {
      return 1 +
             static_cast<std::int64_t>((static_cast<double>(x[k]) - static_cast<double>(origin[k])) / size);
    };
    return {along(0), along(1), along(2)};
  }
  int level_of(const Bounds& box) const {
    const auto extent = static_cast<double>((box.high - box.low).maxCoeff());
    int level = 0;
    while (level + 1 < levels && extent * room <= cell(level + 1)) ++level;
    return level;
  }
};

bool is_empty(const Bounds& box) { return !(box.low.array() <= box.high.array()).all(); }
bool is_finite(const Bounds& box) { return box.low.allFinite() && box.high.allFinite(); }

bool overlap(const Bounds& a, const Bounds& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace

const std::vector<BroadPhase::Pair>& BroadPhase::pairs(const std::vector<Bounds>& all) {
  const int n = static_cast<int>(all.size());
  const auto box = [&](int i) -> const Bounds& { return all[static_cast<std::size_t>(i)]; };
  entries_.clear(), unbounded_.clear(), found_.clear();

  // The lattice: the largest body's size, halved while some body would fit and the scene's keys hold it.
  Lattice lattice;
  Vector3 high = Vector3::Zero();
  double least = 0;
  bool any = false;
  for (int i = 0; i < n; ++i) {
    if (is_empty(box(i))) continue;
    if (!is_finite(box(i))) {
      unbounded_.push_back(i);
      continue;
    }
    const auto extent = static_cast<double>((box(i).high - box(i).low).maxCoeff());
    least = any ? std::min(least, extent) : extent;
    lattice.origin = any ? Vector3(lattice.origin.cwiseMin(box(i).low)) : box(i).low;
    high = any ? Vector3(high.cwiseMax(box(i).low)) : box(i).low;
    lattice.largest = std::max(lattice.largest, extent);
    any = true;
    entries_.push_back({0, i});
  }
  const double width = any ? static_cast<double>((high - lattice.origin).maxCoeff()) : 0;
  const double narrowest = std::max(width / static_cast<double>(most_cells - 2), least);
  lattice.largest = room * std::max({lattice.largest, narrowest, 1e-30});
  while (lattice.levels < most_levels && lattice.cell(lattice.levels) >= narrowest) ++lattice.levels;

  for (Entry& entry : entries_) {
    const int level = lattice.level_of(box(entry.body));
    entry.key = key_of(level, lattice.at(box(entry.body).low, level));
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.body < b.body; });
  sorted_.clear();
  for (const Entry& entry : entries_) sorted_.push_back(box(entry.body));

  const auto meet = [&](std::size_t a, std::size_t b) {
    if (!overlap(sorted_[a], sorted_[b])) return;
    const auto [i, j] = std::minmax(entries_[a].body, entries_[b].body);
    found_.emplace_back(i, j);
  };
  const auto key_less = [](const Entry& entry, std::uint64_t key) { return entry.key < key; };
  const std::size_t count = entries_.size();

  // Within a level: the own cell and the half of its neighbours that comes after it, in rows along x.  The
  // start of each row moves forward with the entries, so nothing is searched for.
  constexpr std::array<std::array<std::int64_t, 2>, 4> rows = {{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}};  // y, z
  std::array<std::size_t, rows.size()> start{};
  for (std::size_t a = 0; a < count; ++a) {
    const std::uint64_t key = entries_[a].key;
    for (std::size_t b = a + 1; b < count && entries_[b].key <= key + 1; ++b) meet(a, b);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto step = rows[r][1] * (std::int64_t{1} << (2 * bits)) + rows[r][0] * (std::int64_t{1} << bits);
      const std::uint64_t middle = key + static_cast<std::uint64_t>(step);
      std::size_t& b = start[r];
      while (b < count && entries_[b].key < middle - 1) ++b;
      for (std::size_t c = b; c < count && entries_[c].key <= middle + 1; ++c) meet(a, c);
    }
  }

  // Against larger bodies, which are in coarser levels: the cells that may hold their low corners.
  std::array<std::size_t, most_levels + 1> level_start{};
  for (int level = 0; level <= lattice.levels; ++level)
    level_start[static_cast<std::size_t>(level)] = static_cast<std::size_t>(
        std::lower_bound(entries_.begin(), entries_.end(), key_of(level, {0, 0, 0}), key_less) -
        entries_.begin());
  for (std::size_t a = 0; a < count; ++a) {
    const int own = static_cast<int>(entries_[a].key >> (3 * bits));
    for (int level = 0; level < own; ++level) {
      const auto l = static_cast<std::size_t>(level);
      const auto first = entries_.begin() + static_cast<std::ptrdiff_t>(level_start[l]);
      const auto last = entries_.begin() + static_cast<std::ptrdiff_t>(level_start[l + 1]);
      if (last - first <= 32) {
        for (auto b = first; b != last; ++b) meet(a, static_cast<std::size_t>(b - entries_.begin()));
        continue;
      }
      const Cell low = lattice.at(sorted_[a].low, level), top = lattice.at(sorted_[a].high, level);
      for (std::int64_t z = low.z - 1; z <= top.z; ++z)
        for (std::int64_t y = low.y - 1; y <= top.y; ++y) {
          const std::uint64_t to = key_of(level, {top.x, y, z});
          for (auto b = std::lower_bound(first, last, key_of(level, {low.x - 1, y, z}), key_less);
               b != last && b->key <= to; ++b)
            meet(a, static_cast<std::size_t>(b - entries_.begin()));
        }
    }
  }

  for (std::size_t k = 0; k < unbounded_.size(); ++k) {
    const int i = unbounded_[k];
    for (int j = 0; j < n; ++j) {
      const bool seen = j <= i && std::binary_search(unbounded_.begin(), unbounded_.end(), j);
      if (!seen && !is_empty(box(j)) && overlap(box(i), box(j))) found_.push_back(std::minmax({i, j}));
    }
  }

  // In ascending order: counted into rows by the first body, each row sorted.
  starts_.assign(static_cast<std::size_t>(n) + 1, 0);
  for (const Pair& pair : found_) ++starts_[static_cast<std::size_t>(pair.first) + 1];
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  pairs_.resize(found_.size());
  for (const Pair& pair : found_)
    pairs_[static_cast<std::size_t>(starts_[static_cast<std::size_t>(pair.first)]++)] = pair;
  for (std::size_t begin = 0; begin < pairs_.size();) {
    std::size_t end = begin + 1;
    while (end < pairs_.size() && pairs_[end].first == pairs_[begin].first) ++end;
    std::sort(pairs_.begin() + static_cast<std::ptrdiff_t>(begin),
              pairs_.begin() + static_cast<std::ptrdiff_t>(end));
    begin = end;
  }
  return pairs_;
}

}  // namespace cylon::engine
