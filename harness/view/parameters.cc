#include "harness/view/parameters.h"

#include "harness/view/bad_command.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <optional>
#include <string>

namespace cylon::view {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

// A number of the scene, where it is there, and its domain.
struct Parameter {
  const char *list, *name;
  double low, high;
  double* (*find)(core::Scene&, std::size_t index);
};

template <class Kind>
Kind* force(core::Scene& scene, std::size_t index) {
  for (core::Force& any : scene.forces)
    if (Kind* kind = std::get_if<Kind>(&any); kind && index-- == 0) return kind;
  return nullptr;
}

template <class Kind, double Kind::*member>
double* of_force(core::Scene& scene, std::size_t index) {
  Kind* kind = force<Kind>(scene, index);
  return kind ? &(kind->*member) : nullptr;
}

template <double core::Material::*member>
double* of_material(core::Scene& scene, std::size_t index) {
  return index < scene.materials.size() ? &(scene.materials[index].*member) : nullptr;
}

constexpr Parameter table[] = {
    {"spring", "stiffness", 0, unbounded, of_force<core::Spring, &core::Spring::stiffness>},
    {"spring", "rest_length", 0, unbounded, of_force<core::Spring, &core::Spring::rest_length>},
    {"spring", "damping", 0, unbounded, of_force<core::Spring, &core::Spring::damping>},
    {"drag", "linear", 0, unbounded, of_force<core::Drag, &core::Drag::linear>},
    {"drag", "angular", 0, unbounded, of_force<core::Drag, &core::Drag::angular>},
    {"drag", "momentum", 0, unbounded, of_force<core::Drag, &core::Drag::momentum>},
    {"attraction", "strength", -unbounded, unbounded,
     of_force<core::Attraction, &core::Attraction::strength>},
    {"water", "level", -unbounded, unbounded, of_force<core::Water, &core::Water::level>},
    {"water", "buoyancy", 0, unbounded, of_force<core::Water, &core::Water::buoyancy>},
    {"water", "drag", 0, unbounded, of_force<core::Water, &core::Water::drag>},
    {"material", "restitution", 0, 1, of_material<&core::Material::restitution>},
    {"material", "friction", 0, unbounded, of_material<&core::Material::friction>},
};

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

double number(std::string_view key, const std::variant<double, core::Vector3>& value, double low,
              double high) {
  const double* x = std::get_if<double>(&value);
  if (!x) throw BadCommand(fmt::format("{}: expected a number, not a vector", key));
  if (*x >= low && *x <= high) return *x;
  throw BadCommand(fmt::format("{} = {}: must lie in [{}, {}]", key, *x, low, high));
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
    const double mass = number(key, value, std::numeric_limits<double>::min(), unbounded);
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
  for (const Parameter& row : table) {
    if (!parts || parts->list != row.list || parts->name != row.name) continue;
    const std::optional<std::size_t> index = index_of(parts->middle);
    double* const place = index ? row.find(scene, *index) : nullptr;
    if (!place) throw BadCommand(fmt::format("{}: there is no {} '{}'", key, parts->list, parts->middle));
    *place = number(key, value, row.low, row.high);
    return;
  }
  throw BadCommand(fmt::format("'{}' is not a parameter that can be changed", key));
}

}  // namespace cylon::view
