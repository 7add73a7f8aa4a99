#include "harness/scenario/draft.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace cylon::scenario {

void Draft::add(const core::Body& body, const Table& table, bool is_point) {
  const auto [place, is_new] = index_.emplace(body.name, static_cast<int>(scene.bodies.size()));
  if (!is_new) table.fail("name", fmt::format("name '{}' is taken by another body", body.name));
  scene.bodies.push_back(body);
  origin.push_back(table);
  point.push_back(is_point);
}

int Draft::body(const Table& table, std::string_view key) const {
  const std::string name = table.text(key);
  if (const auto found = index_.find(name); found != index_.end()) return found->second;
  std::vector<std::string> names;
  for (const core::Body& body : scene.bodies) names.push_back(body.name);
  table.fail(key,
             fmt::format("{} = '{}': no body has that name{}", key, name, core::did_you_mean(name, names)));
}

std::string Draft::read(const Table& table, std::string_view key) {
  try {
    std::string bytes = read_file(folder / table.text(key));
    content.add(bytes);
    return bytes;
  } catch (const core::InputError& error) {
    table.fail(key, error.what());
  }
}

void make_unit(core::Vector3& v) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  if (!(std::abs(v.squaredNorm() - 1) <= rounding)) v.normalize();
}

std::string written(const core::Vector3& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }

}  // namespace cylon::scenario
