#include "reports/csv.h"

#include "reports/json.h"
#include "reports/sentence.h"
#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include <nlohmann/json.hpp>

namespace cylon::reports {
namespace {

using Json = nlohmann::ordered_json;

bool allowed_in_field(char32_t code) {
  return code == '\n' || code == '\r' || code == '\t' || is_printable(code);
}

// Full-width forms of = + - @ start a formula too.
bool starts_formula(std::string_view text) {
  constexpr std::string_view starts[] = {"=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠"};
  return std::any_of(std::begin(starts), std::end(starts),
                     [&](std::string_view start) { return text.starts_with(start); });
}

// "name=value; …" of an object, "item; …" of an array; of diagnostics their kinds.
std::string joined(const Json& json) {
  std::string out;
  for (const auto& [key, value] : json.items()) {
    if (!out.empty()) out += "; ";
    if (json.is_object()) out += key + "=";
    out += value.is_number_float() ? fmt::format("{:.17g}", value.get<double>())
                                   : (value.is_object() ? value.at("kind") : value).get<std::string>();
  }
  return out;
}

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return csv_field(value.get_ref<const std::string&>());
  if (value.is_structured()) return csv_field(joined(value));
  return value.is_number_float() ? fmt::format("{:.17g}", value.get<double>()) : value.dump();
}

}  // namespace

std::string csv_field(std::string_view text) {
  std::string safe = escaped(text, allowed_in_field);
  if (starts_formula(safe)) safe.insert(0, 1, '\'');
  if (safe.find_first_of(",\"\r\n") == std::string::npos) return safe;

  std::string quoted = "\"";
  for (const char c : safe) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_unguarded(std::string_view text) {
  const bool guarded = text.starts_with('\'') && starts_formula(text.substr(1));
  return std::string(guarded ? text.substr(1) : text);
}

std::string to_csv(const std::vector<results::Verdict>& verdicts) {
  std::string out;
  const auto line = [&](const Json& json, auto&& column) {
    const char* separator = "";
    for (const auto& [key, value] : json.items()) (out += separator) += column(key, value), separator = ",";
    out += "\r\n";
  };
  line(row({}), [](const std::string& key, const Json&) { return key; });
  for (const results::Verdict& verdict : verdicts)
    line(row(verdict), [&](const std::string& key, const Json& value) {
      return key == "allowed" && !has_allowed(verdict) ? "" : cell(value);
    });
  return out;
}

}  // namespace cylon::reports
