// Parts of the plain tables that a page has for readers without script, of documents that may be anybody's.
#pragma once

#include "reports/text.h"
#include "reports/xml.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace cylon::reports {

/// The documents are in the page whole; their tables need not be.
inline constexpr std::size_t most_rows = 1000, longest_text = 1000;

/// Null where there is no such part.
inline const nlohmann::ordered_json& part(const nlohmann::ordered_json& json, const char* key) {
  static const nlohmann::ordered_json none;
  const auto found = json.is_object() ? json.find(key) : json.end();
  return found == json.end() ? none : *found;
}

/// Text for HTML; "?" where there is none.
inline std::string text(const nlohmann::ordered_json& json, const char* key) {
  const nlohmann::ordered_json& value = part(json, key);
  return value.is_string() ? xml(head(value.get_ref<const std::string&>(), longest_text)) : "?";
}

}  // namespace cylon::reports
