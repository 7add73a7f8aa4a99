#include "harness/scenario/draft.h"

#include "harness/scenario/budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::scenario {

void Draft::expect(std::size_t more) {
  const std::size_t bodies = scene.bodies.size() + more;
  if (bodies <= scene.bodies.capacity()) return;
  // At least twice what there was: else each of many small groups would move all bodies before it.
  const std::size_t room = std::max(bodies, 2 * scene.bodies.capacity());
  scene.bodies.reserve(room), origin.reserve(room), index_.reserve(room);
}

void Draft::add(core::Body&& body, const Table& table, bool is_point) {
  const auto [place, is_new] = index_.emplace(body.name, static_cast<int>(scene.bodies.size()));
  if (!is_new) table.fail("name", fmt::format("name '{}' is taken by another body", body.name));
  const core::BodyState& start = body.initial;
  if (!start.position.allFinite() || !start.velocity.allFinite() || !start.angular_velocity.allFinite())
    table.fail(fmt::format("'{}': its place or its velocity is not finite; take smaller numbers", body.name));
  scene.bodies.push_back(std::move(body));
  origin.push_back(table);
  point.push_back(is_point);
}

int Draft::body(const Table& table, std::string_view key, const std::string& name) const {
  if (const auto found = index_.find(name); found != index_.end()) return found->second;
  std::vector<std::string> names;
  for (const core::Body& body : scene.bodies) names.push_back(body.name);
  table.fail(key,
             fmt::format("{} = '{}': no body has that name{}", key, name, core::did_you_mean(name, names)));
}

void Draft::add_points(const Table& table, double more) {
  if (static_cast<double>(points) + more > static_cast<double>(budget::points))
    table.fail(
        table.has("shape") ? "shape" : "",
        fmt::format("shape: the hulls, meshes and parts of all bodies have more than {} points together",
                    budget::points));
  points += static_cast<std::size_t>(more);
}

std::string Draft::read(const Table& table, std::string_view key) {
  try {
    std::string text = read_file(folder / table.text(key));
    bytes += text.size();
    if (bytes > budget::files)
      table.fail(key, fmt::format("{}: the files of this scenario have more than {} MB together", key,
                                  budget::files >> 20));
    content.add(text);
    return text;
  } catch (const core::InputError& error) {
    if (error.line > 0) throw;
    table.fail(key, error.what());
  }
}

void make_unit(core::Vector3& v) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  constexpr double far_from_one = 1e150;  // its square is a double yet
  if (const double largest = v.cwiseAbs().maxCoeff(); !(largest < far_from_one && largest > 1 / far_from_one))
    v /= largest;
  if (!(std::abs(v.squaredNorm() - 1) <= rounding)) v.normalize();
}

std::string written(const core::Vector3& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }

}  // namespace cylon::scenario
