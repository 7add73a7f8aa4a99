#include "harness/process/json_fields.h"

#include "harness/input/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace cylon::process {

using nlohmann::json;

json parse_object(std::string_view line) {
  try {
    json value = input::parse_json(line);
    if (!value.is_object()) throw MalformedMessage("a line must hold one JSON object");
    return value;
  } catch (const input::BadJson& error) {
    throw MalformedMessage(error.what());
  }
}

std::vector<double> numbers(const json& value, std::size_t count, const std::string& place) {
  if (!value.is_array() || value.size() != count)
    throw MalformedMessage(fmt::format("{}: expected {} numbers", place, count));
  std::vector<double> result;
  result.reserve(count);
  for (const json& element : value) {
    if (!element.is_number()) throw MalformedMessage(fmt::format("{}: expected {} numbers", place, count));
    result.push_back(element.get<double>());
  }
  return result;
}

Fields::Fields(const json& object, std::string place) : object_(object), place_(std::move(place)) {
  if (!object.is_object()) throw MalformedMessage(place_ + ": expected an object");
  asked_.reserve(object.size());
}

std::string Fields::place_of(std::string_view key) const {
  return place_.empty() ? std::string(key) : fmt::format("{}.{}", place_, key);
}

void Fields::fail(std::string_view key, std::string_view problem) const {
  throw MalformedMessage(fmt::format("{}: {}", place_of(key), problem));
}

const json* Fields::find(const char* key) {
  const auto found = object_.find(key);
  if (found == object_.end()) return nullptr;
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
  return &*found;
}

const json& Fields::at(const char* key) {
  const json* value = find(key);
  if (!value) fail(key, "missing");
  return *value;
}

double Fields::number(const char* key) {
  const json& value = at(key);
  if (!value.is_number()) fail(key, "expected a number");
  return value.get<double>();
}

std::int64_t Fields::integer(const char* key) {
  const json& value = at(key);
  if (!value.is_number_integer()) fail(key, "expected an integer");
  return value.get<std::int64_t>();
}

int Fields::index(const char* key) {
  const std::int64_t value = integer(key);
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    fail(key, "out of range");
  return static_cast<int>(value);
}

bool Fields::flag(const char* key) {
  const json& value = at(key);
  if (!value.is_boolean()) fail(key, "expected true or false");
  return value.get<bool>();
}

std::string Fields::text(const char* key) {
  const json& value = at(key);
  if (!value.is_string()) fail(key, "expected a string");
  return value.get<std::string>();
}

std::vector<double> Fields::numbers(const char* key, std::size_t count) {
  return process::numbers(at(key), count, place_of(key));
}

std::vector<double> Fields::numbers(const char* key) {
  const nlohmann::json& array = at(key);
  return process::numbers(array, array.size(), place_of(key));
}

core::Vector3 Fields::vector(const char* key) {
  const std::vector<double> v = numbers(key, 3);
  return {v[0], v[1], v[2]};
}

core::Quaternion Fields::quaternion(const char* key) {
  const std::vector<double> q = numbers(key, 4);
  return {q[0], q[1], q[2], q[3]};
}

void Fields::each(const char* key, const std::function<void(const json&, const std::string&)>& row) {
  const json& values = at(key);
  if (!values.is_array()) fail(key, "expected an array");
  std::size_t i = 0;
  for (const json& value : values) row(value, fmt::format("{}[{}]", place_of(key), i++));
}

void Fields::finish() const {
  if (asked_.size() >= object_.size()) return;
  for (const auto& [key, value] : object_.items())
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) fail(key, "unknown key");
}

}  // namespace cylon::process
