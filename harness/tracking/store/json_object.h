// A JSON object read key by key; every complaint has the file, the line, the key and the value.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::store {

/// Where a value stands: a file and a line, from 1.
struct Place {
  std::string file;
  unsigned line = 1;

  /// Throws core::InputError.
  [[noreturn]] void refuse(const std::string& why) const;
};

class JsonObject {
 public:
  /// `name` is what the object is called in complaints; keeps references to all three.
  JsonObject(const nlohmann::json&, const Place&, std::string name);

  std::string text(const char* key);
  double number(const char* key);  ///< null is NaN.
  std::int64_t integer(const char* key, std::int64_t least);
  bool boolean(const char* key);
  const nlohmann::json& array(const char* key);
  const nlohmann::json& value(const char* key);
  bool has(const char* key) const { return json_.contains(key); }

  /// Complains of keys that nobody asked for, with the nearest one.
  void finish() const;
  [[noreturn]] void refuse(const char* key, const std::string& why) const;

 private:
  const nlohmann::json& json_;
  const Place& place_;
  std::string name_;
  std::set<std::string> known_;
};

/// The value that the text is; a complaint has the line within the text, counted from `place`'s.
nlohmann::json parse_json(std::string_view text, const Place&);

}  // namespace cylon::store
