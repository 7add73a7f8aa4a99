#include "harness/view/parameters.h"

#include "harness/core/fields.h"
#include "harness/view/command.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <optional>
#include <string>

namespace cylon::view {
namespace {

// A number of the scene and its domain.
struct Parameter {
  double* place = nullptr;
  core::Range range;
};

// Element `index` of the kind T, in the order of workers; null where there are fewer.
template <class T>
T* find(core::Scene& scene, std::size_t index) {
  if constexpr (std::is_same_v<T, core::Material>) {
    return index < scene.materials.size() ? &scene.materials[index] : nullptr;
  } else {
    for (core::Force& any : scene.forces)
      if (T* kind = std::get_if<T>(&any); kind && index-- == 0) return kind;
    return nullptr;
  }
}

// "list.middle.name"; the middle may have dots of its own.
struct Key {
  std::string_view list, middle, name;
};

std::optional<Key> split(std::string_view key) {
  const std::size_t first = key.find('.'), last = key.rfind('.');
  if (first == std::string_view::npos || first == last) return std::nullopt;
  return Key{key.substr(0, first), key.substr(first + 1, last - first - 1), key.substr(last + 1)};
}

std::optional<std::size_t> index_of(std::string_view text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return index;
}

double number(std::string_view key, const std::variant<double, core::Vector3>& value,
              const core::Range& range) {
  const double* x = std::get_if<double>(&value);
  if (!x) throw BadCommand(fmt::format("{}: expected a number, not a vector", key));
  if (*x >= range.low && *x <= range.high) return *x;
  throw BadCommand(fmt::format("{} = {}: must lie in [{}, {}]", key, *x, range.low, range.high));
}

// Where the key is a tunable number of T: its parameter, without a place where the scene has no such element.
template <class T>
void look_up(core::Scene& scene, const Key& parts, std::optional<Parameter>& found) {
  if (parts.list != core::Element<T>::name) return;
  const std::optional<std::size_t> index = index_of(parts.middle);
  T none, *const element = index ? find<T>(scene, *index) : nullptr;
  core::for_each_field(element ? *element : none, [&](const auto& field, auto& value) {
    if constexpr (std::is_same_v<decltype(value), double&>)
      if (field.about.tunable && field.key == parts.name)
        found = Parameter{element ? &value : nullptr, field.about.range};
  });
}

void set_gravity(core::Scene& scene, const std::variant<double, core::Vector3>& value) {
  const core::Vector3* g = std::get_if<core::Vector3>(&value);
  if (!g) throw BadCommand("gravity: expected a vector of three numbers");
  std::erase_if(scene.forces,
                [](const core::Force& f) { return std::holds_alternative<core::UniformGravity>(f); });
  if (!g->isZero(0)) scene.forces.insert(scene.forces.begin(), core::UniformGravity{*g});
}

void set_mass(core::Scene& scene, std::string_view key, const Key& parts,
              const std::variant<double, core::Vector3>& value) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    core::Body& body = scene.bodies[i];
    if (body.name != parts.middle) continue;
    const double mass = number(key, value, {.low = std::numeric_limits<double>::min()});
    for (const core::Force& force : scene.forces)
      if (const auto* thrust = std::get_if<core::Thrust>(&force);
          thrust && thrust->mass_rate != 0 && thrust->body == static_cast<int>(i))
        throw BadCommand(fmt::format("{} = {}: a thrust changes this body's mass", key, mass));
    const double factor = mass / body.mass;
    body.inertia *= factor;
    if (auto* compound = std::get_if<core::Compound>(&body.shape))
      for (core::Part& part : compound->parts) part.mass *= factor;
    body.mass = mass;
    return;
  }
  throw BadCommand(fmt::format("{}: there is no body '{}'", key, parts.middle));
}

}  // namespace

void set_parameter(core::Scene& scene, std::string_view key,
                   const std::variant<double, core::Vector3>& value) {
  if (key == "gravity") return set_gravity(scene, value);
  const std::optional<Key> parts = split(key);
  if (parts && parts->list == "body" && parts->name == "mass") return set_mass(scene, key, *parts, value);
  std::optional<Parameter> found;
  if (parts) {
    core::for_each_force([&]<class Kind>() { look_up<Kind>(scene, *parts, found); });
    look_up<core::Material>(scene, *parts, found);
  }
  if (!found) throw BadCommand(fmt::format("'{}' is not a parameter that can be changed", key));
  if (!found->place)
    throw BadCommand(fmt::format("{}: there is no {} '{}'", key, parts->list, parts->middle));
  *found->place = number(key, value, found->range);
}

}  // namespace cylon::view
