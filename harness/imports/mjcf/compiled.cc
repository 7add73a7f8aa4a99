#include "harness/imports/mjcf/compiled.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::imports {

bool Compiled::disabled(const char* what) const {
  const nlohmann::json& list = json_.at("option").at("disabled");
  return std::find(list.begin(), list.end(), what) != list.end();
}

bool Compiled::disabled_group(int group) const {
  constexpr int groups = 31;  // bits 0 to 30 of opt.disableactuator; no other group can be disabled
  const int bits = json_.at("option").value("disabled_groups", 0);
  return group >= 0 && group < groups && (bits >> group & 1) != 0;
}

std::optional<double> Compiled::friction_of_all() const {
  const auto contact = override_of_contacts().find("friction");
  if (contact == override_of_contacts().end()) return std::nullopt;
  return finite(contact->at(0), "option: o_friction");
}

std::optional<double> Compiled::margin_of_all() const {
  const auto contact = override_of_contacts().find("margin");
  if (contact == override_of_contacts().end()) return std::nullopt;
  return finite(*contact, "option: o_margin");
}

bool Compiled::is_override_anisotropic() const {
  const auto contact = override_of_contacts().find("friction");
  return contact != override_of_contacts().end() && contact->at(0) != contact->at(1);
}

const nlohmann::json& Compiled::override_of_contacts() const {
  static const nlohmann::json none = nlohmann::json::object();
  const nlohmann::json& option = json_.at("option");
  const auto found = option.find("contact_override");
  return found == option.end() ? none : *found;
}

bool Compiled::any(const char* array, int row, int rows) const {
  const int columns = rows > 0 ? static_cast<int>(length(array)) / rows : 0;
  for (int k = 0; k < columns; ++k)
    if (number(array, columns * row + k) != 0) return true;
  return false;
}

double Compiled::number(const char* array, int i, double otherwise) const {
  const nlohmann::json& arrays = json_.at("arrays");
  const auto found = arrays.find(array);
  return found == arrays.end() ? otherwise : entry("arrays", array, at(i));
}

int Compiled::integer(const char* array, int i, int otherwise) const {
  const nlohmann::json& arrays = json_.at("arrays");
  const auto found = arrays.find(array);
  return found == arrays.end() ? otherwise : found->at(at(i)).get<int>();
}

std::size_t Compiled::length(const char* array) const {
  const nlohmann::json& arrays = json_.at("arrays");
  const auto found = arrays.find(array);
  return found == arrays.end() ? 0 : found->size();
}

// JSON has no NaN and no infinity: they come as null.
double Compiled::finite(const nlohmann::json& number, const std::string& where) {
  if (number.is_null()) throw NotFinite(where + " is not finite");
  return number.get<double>();
}

double Compiled::entry(const char* group, const char* array, std::size_t i) const {
  const nlohmann::json &numbers = json_.at(group).at(array), &number = numbers.at(i);
  return finite(number,
                number.is_null() ? fmt::format("{}: {}", owner(array, i, numbers.size()), array) : array);
}

foreign::Vector3 Compiled::vector(const char* group, const char* array, int row) const {
  const std::size_t first = 3 * at(row);
  return {entry(group, array, first), entry(group, array, first + 1), entry(group, array, first + 2)};
}

foreign::Quaternion Compiled::quaternion(const char* group, const char* array, int row) const {
  const std::size_t first = 4 * at(row);
  return {entry(group, array, first), entry(group, array, first + 1), entry(group, array, first + 2),
          entry(group, array, first + 3)};
}

// Whose entry i of an array of the length is: arrays have rows of one length, one row an element.
std::string Compiled::owner(std::string_view array, std::size_t i, std::size_t length) const {
  const struct {
    std::string_view prefix;
    const char* kind;
  } rows[] = {{"body_", "body"},    {"jnt_", "joint"}, {"geom_", "geom"},     {"pair_", "pair"},
              {"eq_", "equality"},  {"site_", "site"}, {"tendon_", "tendon"}, {"actuator_", "actuator"},
              {"xpos", "body"},     {"xquat", "body"}, {"xipos", "body"},     {"velocities", "body"},
              {"xanchor", "joint"}, {"xaxis", "joint"}};
  for (const auto& [prefix, kind] : rows)
    if (const std::size_t rows_of = at(count(kind)); array.starts_with(prefix) && rows_of > 0)
      return place(kind, static_cast<int>(i / std::max(length / rows_of, std::size_t{1}))).element;
  // Coordinates and velocities: of the last joint that begins at or before them.
  const bool of_motion = array.starts_with("dof_");
  if (!of_motion && !array.starts_with("qpos")) return "model";
  const std::size_t columns =
      of_motion ? std::max(length / std::max(at(size("nv")), std::size_t{1}), std::size_t{1}) : 1;
  int joint = 0;
  while (joint + 1 < size("njnt") &&
         at(integer(of_motion ? "jnt_dofadr" : "jnt_qposadr", joint + 1)) <= i / columns)
    ++joint;
  return place("joint", joint).element;
}

std::string Compiled::name(const char* kind, int i) const {
  const nlohmann::json& kinds = json_.at("names");
  const auto found = kinds.find(kind);
  return found != kinds.end() && at(i) < found->size() ? found->at(at(i)).get<std::string>() : "";
}

int Compiled::count(const char* kind) const {
  const nlohmann::json& kinds = json_.at("names");
  const auto found = kinds.find(kind);
  return found == kinds.end() ? 0 : static_cast<int>(found->size());
}

foreign::Place Compiled::place(const char* kind, int i) const {
  const std::string own = name(kind, i);
  return {own.empty() ? fmt::format("{} {}", kind, i) : fmt::format("{} '{}'", kind, own), "", 0};
}

}  // namespace cylon::imports
