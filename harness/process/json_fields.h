// Strict reading of JSON objects: a missing, mistyped or unknown key is an error that names it.
// Knows neither scenes nor messages.
#pragma once

#include "harness/core/scene.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::process {

/// A message that is not what the protocol says; what() names the key.
struct MalformedMessage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Parses one line.  Throws MalformedMessage with the byte offset unless it holds one JSON object.
nlohmann::json parse_object(std::string_view line);

/// One JSON object and the keys read so far.  Every reader throws MalformedMessage, naming the key, where the
/// value is missing or of another type; call finish() last, which throws where a key was never asked for.
class Fields {
 public:
  /// `place` is how errors call the object: "body[3]"; "" at the top.
  Fields(const nlohmann::json& object, std::string place);

  const nlohmann::json& at(const char* key);
  /// Null where the key is absent.
  const nlohmann::json* find(const char* key);

  double number(const char* key);         ///< An integer will do; null will not.
  std::int64_t integer(const char* key);  ///< A number without fraction.
  int index(const char* key);             ///< An integer that fits an int.
  bool flag(const char* key);
  std::string text(const char* key);
  core::Vector3 vector(const char* key);         ///< [x, y, z]
  core::Quaternion quaternion(const char* key);  ///< [w, x, y, z], taken as it is: not normalised.
  std::vector<double> numbers(const char* key, std::size_t count);
  std::vector<double> numbers(const char* key);  ///< As many as there are.

  /// Calls `row(value, place)` for each element of an array; the key must be there.
  void each(const char* key, const std::function<void(const nlohmann::json&, const std::string&)>& row);

  void finish() const;

  /// "place.key", as errors call it.
  std::string place_of(std::string_view key) const;
  [[noreturn]] void fail(std::string_view key, std::string_view problem) const;

 private:
  const nlohmann::json& object_;
  std::string place_;
  std::vector<std::string_view> asked_;
};

/// The array's elements; throws unless it holds exactly `count` numbers.
std::vector<double> numbers(const nlohmann::json&, std::size_t count, const std::string& place);

}  // namespace cylon::process
