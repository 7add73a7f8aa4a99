// Many bodies from one template.  The same file gives the same bodies on every platform: integer arithmetic
// and correctly rounded operations (+ - * / sqrt) only.
#include "harness/core/solid.h"
#include "harness/scenario/draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cylon::scenario {
namespace {

using core::Vector3;

// SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  Vector3 in_box(const Vector3& low, const Vector3& high) {
    Vector3 p;
    for (int i = 0; i < 3; ++i) p[i] = low[i] + (high[i] - low[i]) * uniform();
    return p;
  }

  // Uniform on the unit sphere: a point of the ball, drawn by rejection, projected outward.
  Vector3 direction() {
    for (;;) {
      const Vector3 p = in_box(Vector3::Constant(-1), Vector3::Constant(1));
      const double r2 = p.x() * p.x() + p.y() * p.y() + p.z() * p.z();
      if (r2 <= 1 && r2 > 1e-6) return p / std::sqrt(r2);
    }
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

// Balls of one radius, no two closer than their diameter; cells of that size, so neighbours suffice.
class Packing {
 public:
  explicit Packing(double radius) : diameter_(2 * radius) {}

  bool fits(const Vector3& p) const {
    if (diameter_ == 0) return true;
    const Cell c = cell(p);
    for (std::int64_t x = c[0] - 1; x <= c[0] + 1; ++x)
      for (std::int64_t y = c[1] - 1; y <= c[1] + 1; ++y)
        for (std::int64_t z = c[2] - 1; z <= c[2] + 1; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (const Vector3& other : found->second)
            if ((p - other).norm() < diameter_) return false;
        }
    return true;
  }

  void add(const Vector3& p) {
    if (diameter_ > 0) cells_[cell(p)].push_back(p);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell(const Vector3& p) const {
    Cell c;
    for (int i = 0; i < 3; ++i)
      c[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(p[i] / diameter_));
    return c;
  }
  double diameter_;
  std::map<Cell, std::vector<Vector3>> cells_;
};

bool clear_of(const core::Scene& others, const Vector3& p, double radius) {
  for (const core::Plane& plane : others.planes)
    if (plane.normal.dot(p) - plane.offset < radius) return false;
  return std::none_of(others.bodies.begin(), others.bodies.end(), [&](const core::Body& body) {
    return body.collide && (p - body.initial.position).norm() < radius + core::bounding_radius(body.shape);
  });
}

std::string indexed(const std::string& name, std::size_t i) { return fmt::format("{}[{}]", name, i); }

}  // namespace

std::vector<core::Body> lattice(const Table& table, const core::Body& pattern) {
  const std::vector<double> count = table.numbers("count");
  const Vector3 spacing = table.vector("spacing");
  std::vector<core::Body> bodies;
  for (int z = 0; z < static_cast<int>(count[2]); ++z)
    for (int y = 0; y < static_cast<int>(count[1]); ++y)
      for (int x = 0; x < static_cast<int>(count[0]); ++x) {
        core::Body body = pattern;
        body.name = indexed(pattern.name, bodies.size());
        body.initial.position += Vector3(x * spacing.x(), y * spacing.y(), z * spacing.z());
        bodies.push_back(std::move(body));
      }
  return bodies;
}

std::vector<core::Body> cloud(const Table& table, const core::Body& pattern, const core::Scene& others) {
  if (table.has("position")) table.fail("position", "position: a cloud lies between 'low' and 'high'");
  const Vector3 low = table.vector("low"), high = table.vector("high");
  if (!(low.array() <= high.array()).all())
    table.fail("low", fmt::format("low = {} must not exceed high = {}", written(low), written(high)));
  const double radius = pattern.collide ? core::bounding_radius(pattern.shape) : 0;
  const double span = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  if (radius > 0 && span / radius > 1e12) table.fail("high", "the box is more than 1e12 radii wide");
  const auto count = static_cast<std::size_t>(table.whole("count"));
  const double speed = table.number("speed");
  if (pattern.locked && speed > 0) table.fail("speed", "speed: a locked body does not move");
  Random random(static_cast<std::uint64_t>(table.whole("seed")));
  Packing packing(radius);
  std::vector<core::Body> bodies;
  while (bodies.size() < count) {
    constexpr int most_tries = 10'000;
    int tries = 0;
    Vector3 place = random.in_box(low, high);
    while (!packing.fits(place) || (radius > 0 && !clear_of(others, place, radius))) {
      if (++tries == most_tries)
        table.fail(
            "count",
            fmt::format("count = {}: only {} of radius {} m found a place that overlaps nothing; take fewer "
                        "or a larger box",
                        count, bodies.size(), radius));
      place = random.in_box(low, high);
    }
    packing.add(place);
    core::Body body = pattern;
    body.name = indexed(pattern.name, bodies.size());
    body.initial.position = place;
    if (speed > 0) body.initial.velocity += speed * random.direction();
    bodies.push_back(std::move(body));
  }
  return bodies;
}

}  // namespace cylon::scenario
