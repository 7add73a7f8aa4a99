#include "engine/ballistic/cells.h"

#include <cmath>
#include <utility>

namespace cylon::engine::ballistic {

namespace {

constexpr std::size_t too_few = 24;        // below this a grid costs more than all pairs
constexpr Real usual = 4;                  // times the median radius: larger spheres are kept apart
constexpr int most_cells = 160;            // along an axis
constexpr std::size_t most_near = 27 + 1;  // cells around one; one more for what is written in vain
constexpr std::size_t most_slots = 64;     // for each body and each cell, where they crowd in a few cells
constexpr Real margin = Real(1.001);       // cells are wider than spheres by more than rounding

Real median_radius(const std::vector<Flight>& flights, const std::vector<char>& collides) {
  std::vector<Real> radii;
  for (std::size_t i = 0; i < flights.size(); ++i)
    if (collides[i]) radii.push_back(flights[i].radius);
  if (radii.empty()) return 0;
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

// The whole part of x, or what of 0 … last is nearest; of what is no number: 0.
int within(Real x, int last) {
  if (!(x > 0)) return 0;
  return x < static_cast<Real>(last) ? static_cast<int>(x) : last;
}

}  // namespace

void Cells::choose_size(const std::vector<Flight>& flights, const std::vector<char>& collides, Time t) {
  const Real largest = usual * median_radius(flights, collides);
  Vector3 high = Vector3::Constant(-infinity);
  low_ = -high;
  Real radius = 0;
  std::size_t number = 0;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    if (!collides[i]) continue;
    held_[i] = flights[i].radius <= largest;
    if (!held_[i]) {
      large_.push_back(i);
      continue;
    }
    const Vector3 p = flights[i].position_at(t);
    low_ = low_.cwiseMin(p);
    high = high.cwiseMax(p);
    radius = std::max(radius, flights[i].radius);
    ++number;
  }
  count_ = {1, 1, 1};
  const Vector3 extent = high - low_;
  const Real least = 2 * margin * radius;
  const Vector3 filled = extent.cwiseMax(std::max(least, extent.maxCoeff() / most_cells));
  size_ = std::max(least, std::cbrt(filled.prod() / static_cast<Real>(number)));
  size_ = std::max(size_, extent.maxCoeff() / most_cells);
  if (number < too_few || !std::isfinite(size_)) {
    low_.setZero();
    size_ = 1;
    return;
  }
  if (!(size_ > 0)) size_ = 1;
  for (std::size_t k = 0; k < 3; ++k)
    count_[k] = static_cast<int>(std::floor(extent[static_cast<int>(k)] / size_)) + 1;
}

void Cells::build(const std::vector<Flight>& flights, const std::vector<char>& collides, Time t) {
  cells_.assign(flights.size(), Cell{0, 0, 0});
  held_.assign(flights.size(), 0);
  places_.assign(flights.size(), 0);
  large_.clear();
  choose_size(flights, collides, t);
  width_ = least_width;
  const auto count = static_cast<std::size_t>(std::ptrdiff_t{count_[0]} * count_[1] * count_[2]);
  counts_.assign(count, 0);
  slots_.assign(count * width_, 0);
  found_.resize(most_near * width_);
  for (std::size_t i = 0; i < flights.size(); ++i) {
    if (!held_[i]) continue;
    const Vector3 p = (flights[i].position_at(t) - low_) / size_;
    for (std::size_t k = 0; k < 3; ++k) cells_[i][k] = within(p[static_cast<int>(k)], count_[k] - 1);
    put(i);
  }
}

void Cells::put(std::size_t body) {
  const std::size_t cell = index(cells_[body]);
  if (counts_[cell] == width_ && !widen()) {
    held_[body] = 0;
    large_.push_back(body);
    return;
  }
  slots_[places_[body] = cell * width_ + counts_[cell]++] = static_cast<int>(body);
}

// The last of the cell takes its slot.
void Cells::take_out(std::size_t body) {
  const std::size_t cell = index(cells_[body]);
  const int last = slots_[cell * width_ + --counts_[cell]];
  slots_[places_[static_cast<std::size_t>(last)] = places_[body]] = last;
}

// Twice as many slots for every cell, unless that were far more than there are bodies.
bool Cells::widen() {
  if (2 * slots_.size() > most_slots * (cells_.size() + counts_.size())) return false;
  std::vector<int> wider(2 * slots_.size());
  for (std::size_t cell = 0; cell < counts_.size(); ++cell)
    for (std::size_t i = 0; i < counts_[cell]; ++i) {
      const int body = slots_[cell * width_ + i];
      wider[places_[static_cast<std::size_t>(body)] = 2 * cell * width_ + i] = body;
    }
  slots_ = std::move(wider);
  width_ *= 2;
  found_.resize(most_near * width_);
  return true;
}

}  // namespace cylon::engine::ballistic
