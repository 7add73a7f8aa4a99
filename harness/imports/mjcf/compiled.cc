#include "harness/imports/mjcf/compiled.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::imports {

bool Compiled::disabled(const char* what) const {
  const nlohmann::json& list = json_.at("option").at("disabled");
  return std::find(list.begin(), list.end(), what) != list.end();
}

double Compiled::number(const char* array, int i, double otherwise) const {
  const nlohmann::json& arrays = json_.at("arrays");
  const auto found = arrays.find(array);
  return found == arrays.end() ? otherwise : found->at(at(i)).get<double>();
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

foreign::Vector3 Compiled::vector(const nlohmann::json& numbers, int row) {
  const std::size_t first = 3 * at(row);
  return {numbers.at(first).get<double>(), numbers.at(first + 1).get<double>(),
          numbers.at(first + 2).get<double>()};
}

foreign::Quaternion Compiled::quaternion(const nlohmann::json& numbers, int row) {
  const std::size_t first = 4 * at(row);
  return {numbers.at(first).get<double>(), numbers.at(first + 1).get<double>(),
          numbers.at(first + 2).get<double>(), numbers.at(first + 3).get<double>()};
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
