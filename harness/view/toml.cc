#include "harness/view/toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace cylon::view {
namespace {

using Json = nlohmann::ordered_json;

// The shortest digits that read back as the same double; "3" alone would be an integer.
std::string number(double x) {
  std::string text = fmt::format("{}", x);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      result += fmt::format("\\{}", c);
    else if (byte < ' ' || byte == 127)
      result += fmt::format("\\u{:04X}", byte);
    else
      result += c;
  }
  return result + '"';
}

std::string key(const std::string& name) {
  constexpr std::string_view bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return name.empty() || name.find_first_not_of(bare) != std::string::npos ? in_quotes(name) : name;
}

std::string written(const Json& value);

std::string listed(const Json& values, const char* open, const char* close) {
  std::string text = open;
  for (const auto& [name, value] : values.items()) {
    if (text.size() > 1) text += ", ";
    if (values.is_object()) text += key(name) + " = ";
    text += written(value);
  }
  return text + close;
}

std::string written(const Json& value) {
  if (value.is_object()) return listed(value, "{", "}");
  if (value.is_array()) return listed(value, "[", "]");
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  if (value.is_number_float()) return number(value.get<double>());
  if (value.is_null()) throw std::invalid_argument("TOML has no null");
  return value.dump();  // an integer, true, false
}

std::string lines(const Json& table) {
  std::string text;
  for (const auto& [name, value] : table.items()) text += fmt::format("{} = {}\n", key(name), written(value));
  return text;
}

bool is_tables(const Json& value) {
  return value.is_array() &&
         std::all_of(value.begin(), value.end(), [](const Json& row) { return row.is_object(); });
}

}  // namespace

std::string to_toml(const Json& document) {
  if (!document.is_object()) throw std::invalid_argument("a TOML document is a table");
  std::string text, tables;  // after the first [table] no key of the document can follow
  for (const auto& [name, value] : document.items()) {
    if (value.is_object())
      tables += fmt::format("\n[{}]\n{}", key(name), lines(value));
    else if (is_tables(value))
      for (const Json& row : value) tables += fmt::format("\n[[{}]]\n{}", key(name), lines(row));
    else
      text += fmt::format("{} = {}\n", key(name), written(value));
  }
  return text + tables;
}

}  // namespace cylon::view
