// Many bodies from one template.  The same file gives the same bodies on every platform: integer arithmetic
// and correctly rounded operations (+ - * / sqrt) only.
#include "harness/core/solid.h"
#include "harness/scenario/budget.h"
#include "harness/scenario/draft.h"
#include "harness/scenario/sphere_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

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

// Places for balls of one radius that keep clear of each other and of what is there already.
class Places {
 public:
  Places(const core::Scene& others, double radius, std::size_t& looked_at)
      : planes_(others.planes), radius_(radius), looked_at_(looked_at) {
    if (radius_ == 0) return;
    looked_at_ += 4 * others.bodies.size();  // what it costs to add one
    if (crowded()) return;
    for (const core::Body& body : others.bodies)
      if (body.collide)
        balls_.add(0, body.initial.position, std::min(core::bounding_radius(body.shape), 1e300));
  }

  bool fits(const Vector3& p) {
    if (radius_ == 0) return true;
    ++looked_at_;
    for (const core::Plane& plane : planes_)
      if (plane.normal.dot(p) - plane.offset < radius_) return false;
    looked_at_ += planes_.size();
    return balls_.first(p, radius_, looked_at_, [&](int, const Vector3& centre, double radius) {
      return (p - centre).norm() < radius_ + radius;
    }) < 0;
  }

  void add(const Vector3& p) {
    if (radius_ > 0) balls_.add(0, p, radius_);
  }

  bool crowded() const { return looked_at_ > budget::neighbours; }

 private:
  const std::vector<core::Plane>& planes_;
  double radius_;
  SphereGrid balls_;
  std::size_t& looked_at_;
};

// Clouds of one box whose seeds differ are different; the default makes them differ.
std::uint64_t seed_of(const Table& cloud, std::size_t number) {
  return static_cast<std::uint64_t>(cloud.whole("seed", static_cast<std::int64_t>(number)));
}

// Why a cloud finds no place, where an earlier one has drawn the same.  One with `speed` draws directions in between.
std::string same_draws(const Table& table, std::span<const Table> earlier) {
  for (std::size_t i = 0; i < earlier.size(); ++i)
    if (seed_of(earlier[i], i) == seed_of(table, earlier.size()) && earlier[i].number("speed") == 0 &&
        earlier[i].vector("low") == table.vector("low") && earlier[i].vector("high") == table.vector("high"))
      return fmt::format(
          "; seed = {} is that of '{}' too, so that both draw the same places: give it another seed",
          seed_of(table, earlier.size()), earlier[i].text("name"));
  return "";
}

std::string indexed(const std::string& name, std::size_t i) { return fmt::format("{}[{}]", name, i); }

}  // namespace

void lattice(const Table& table, const core::Body& pattern, const TakeBody& take) {
  const std::vector<double> count = table.numbers("count");
  const Vector3 spacing = table.vector("spacing");
  std::size_t made = 0;
  for (int z = 0; z < static_cast<int>(count[2]); ++z)
    for (int y = 0; y < static_cast<int>(count[1]); ++y)
      for (int x = 0; x < static_cast<int>(count[0]); ++x) {
        core::Body body = pattern;
        body.name = indexed(pattern.name, made++);
        body.initial.position += Vector3(x * spacing.x(), y * spacing.y(), z * spacing.z());
        take(std::move(body));
      }
}

void cloud(const Table& table, const core::Body& pattern, Draft& others, std::span<const Table> earlier,
           const TakeBody& take) {
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
  Random random(seed_of(table, earlier.size()));
  Places places(others.scene, radius, others.neighbours);
  for (std::size_t made = 0; made < count; ++made) {
    constexpr int most_tries = 10'000;
    int tries = 0;
    Vector3 place = random.in_box(low, high);
    for (; places.crowded() || !places.fits(place); place = random.in_box(low, high)) {
      if (places.crowded())
        table.fail("count",
                   fmt::format("count = {}: after {} the search for free places takes too long; take "
                               "fewer or a larger box",
                               count, made));
      if (++tries == most_tries)
        table.fail(
            "count",
            fmt::format("count = {}: only {} of radius {} m found a place that overlaps nothing; take fewer "
                        "or a larger box{}",
                        count, made, radius, same_draws(table, earlier)));
    }
    places.add(place);
    core::Body body = pattern;
    body.name = indexed(pattern.name, made);
    body.initial.position = place;
    if (speed > 0) body.initial.velocity += speed * random.direction();
    take(std::move(body));
  }
}

}  // namespace cylon::scenario
