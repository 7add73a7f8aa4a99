#include "harness/tracking/store/json_object.h"

#include "harness/core/input_error.h"
#include "harness/input/json.h"
#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace cylon::store {
namespace {

using nlohmann::json;

using input::shown;

}  // namespace

void Place::refuse(const std::string& why) const { throw core::InputError(file, line, 1, why); }

JsonObject::JsonObject(const json& value, const Place& place, std::string name)
    : json_(value), place_(place), name_(std::move(name)) {
  if (!json_.is_object()) place_.refuse(fmt::format("{} must be an object, not {}", name_, shown(json_)));
}

void JsonObject::refuse(const char* key, const std::string& why) const {
  place_.refuse(fmt::format("{}: \"{}\" {}", name_, key, why));
}

const json& JsonObject::value(const char* key) {
  known_.insert(key);
  const auto found = json_.find(key);
  if (found == json_.end()) refuse(key, "is missing");
  return *found;
}

std::string JsonObject::text(const char* key) {
  const json& v = value(key);
  if (!v.is_string()) refuse(key, fmt::format("must be a string, not {}", shown(v)));
  return v.get<std::string>();
}

double JsonObject::number(const char* key) {
  const json& v = value(key);
  if (v.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (!v.is_number()) refuse(key, fmt::format("must be a number or null, not {}", shown(v)));
  return v.get<double>();
}

std::int64_t JsonObject::integer(const char* key, std::int64_t least) {
  const json& v = value(key);
  const bool fits = v.is_number_integer() &&
                    (!v.is_number_unsigned() || v.get<std::uint64_t>() <= std::uint64_t{INT64_MAX}) &&
                    v.get<std::int64_t>() >= least;
  if (!fits) refuse(key, fmt::format("must be a whole number >= {}, not {}", least, shown(v)));
  return v.get<std::int64_t>();
}

bool JsonObject::boolean(const char* key) {
  const json& v = value(key);
  if (!v.is_boolean()) refuse(key, fmt::format("must be true or false, not {}", shown(v)));
  return v.get<bool>();
}

const json& JsonObject::array(const char* key) {
  const json& v = value(key);
  if (!v.is_array()) refuse(key, fmt::format("must be an array, not {}", shown(v)));
  return v;
}

void JsonObject::finish() const {
  for (const auto& [key, unused] : json_.items()) {
    if (known_.contains(key)) continue;
    const std::vector<std::string> candidates(known_.begin(), known_.end());
    refuse(key.c_str(), fmt::format("is no key of it{}", core::did_you_mean(key, candidates)));
  }
}

json parse_json(std::string_view text, const Place& place) {
  try {
    return input::parse_json(text);
  } catch (const input::BadJson& error) {
    if (error.byte == 0) place.refuse(error.what());
    const std::string_view before =
        text.substr(0, std::min(error.byte == 0 ? 0 : error.byte - 1, text.size()));
    const auto lines = static_cast<unsigned>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t start = lines == 0 ? 0 : before.rfind('\n') + 1;
    throw core::InputError(place.file, place.line + lines, static_cast<unsigned>(before.size() - start + 1),
                           fmt::format("{}: '{}'", error.what(), reports::head(text.substr(start), 40)));
  }
}

}  // namespace cylon::store
