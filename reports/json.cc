#include "reports/json.h"

#include "harness/core/input_error.h"
#include "harness/input/json.h"

#include "reports/sentence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

namespace cylon::reports {
namespace {

using results::Verdict;
using Json = nlohmann::ordered_json;

std::string text(const Json& json) {
  return json.dump(-1, ' ', /*ensure_ascii=*/true, Json::error_handler_t::replace);
}

constexpr std::pair<const char*, std::string Provenance::*> provenance_texts[] = {
    {"cylon", &Provenance::cylon},       {"revision", &Provenance::revision},
    {"compiler", &Provenance::compiler}, {"flags", &Provenance::flags},
    {"machine", &Provenance::machine},   {"os", &Provenance::os},
    {"date", &Provenance::date},         {"command_line", &Provenance::command_line}};

// A member of a row that must exist, read as T; the row and the key stand in every error.
struct Row {
  const Json& json;
  std::string place;

  [[noreturn]] void refuse(const char* key, const std::string& why) const {
    throw core::InputError(fmt::format("{}: \"{}\": {}", place, key, why));
  }

  const Json& at(const char* key) const {
    const auto found = json.find(key);
    if (found == json.end()) refuse(key, "is missing");
    return *found;
  }

  std::string string(const char* key) const {
    const Json& value = at(key);
    if (!value.is_string()) refuse(key, fmt::format("must be a string, not {}", value.type_name()));
    return value.get<std::string>();
  }

  double real(const char* key) const {
    const Json& value = at(key);
    if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (!value.is_number()) refuse(key, fmt::format("must be a number or null, not {}", value.type_name()));
    return value.get<double>();
  }

  std::int64_t integer(const char* key) const {
    const Json& value = at(key);
    const bool fits = value.is_number_integer() &&
                      (!value.is_number_unsigned() || value.get<std::uint64_t>() <= std::uint64_t{INT64_MAX});
    if (!fits) refuse(key, "must be a whole number of 64 bits");
    return value.get<std::int64_t>();
  }

  bool boolean(const char* key) const {
    const Json& value = at(key);
    if (!value.is_boolean()) refuse(key, fmt::format("must be true or false, not {}", value.type_name()));
    return value.get<bool>();
  }

  results::Status status(const char* key) const {
    const std::string word = string(key);
    const auto status = results::status_from(word);
    if (!status) refuse(key, fmt::format("'{}' is not a status", word));
    return *status;
  }

  std::vector<std::string> strings(const char* key) const {
    const Json& value = at(key);
    if (!value.is_array()) refuse(key, fmt::format("must be an array, not {}", value.type_name()));
    std::vector<std::string> list;
    for (const Json& item : value) {
      if (!item.is_string()) refuse(key, "must hold strings only");
      list.push_back(item.get<std::string>());
    }
    return list;
  }

  std::vector<std::pair<std::string, std::string>> pairs(const char* key) const {
    const Json& value = at(key);
    if (!value.is_object()) refuse(key, fmt::format("must be an object, not {}", value.type_name()));
    std::vector<std::pair<std::string, std::string>> list;
    for (const auto& [name, setting] : value.items()) {
      if (!setting.is_string()) refuse(key, "must hold strings only");
      list.emplace_back(name, setting.get<std::string>());
    }
    return list;
  }
};

std::optional<double> real_if(const Row& row, const char* key) {
  return row.at(key).is_null() ? std::nullopt : std::optional(row.real(key));
}

told::Diagnostic diagnostic_from(const Json& json, const std::string& place) {
  if (!json.is_object()) throw core::InputError(place + ": must be an object");
  const Row row{json, place};
  told::Diagnostic d;
  d.kind = row.string("kind");
  d.bodies = row.strings("bodies");
  const std::int64_t bodies = row.integer("body_count"), order = row.integer("order");
  if (bodies < static_cast<std::int64_t>(d.bodies.size()))
    row.refuse("body_count", "is less than the bodies that are named");
  if (order < 0 || order > 1000) row.refuse("order", "must lie in [0, 1000]");
  d.body_count = static_cast<std::size_t>(bodies), d.order = static_cast<int>(order);
  d.method = row.string("method");
  d.since = row.real("since");
  d.until = real_if(row, "until");
  d.count = row.integer("count");
  if (d.count < 1) row.refuse("count", "must be at least 1");
  d.limit = real_if(row, "limit"), d.limit_unit = row.string("limit_unit");
  d.reached = real_if(row, "reached"), d.unit = row.string("unit");
  d.text = row.string("text");
  return d;
}

std::vector<told::Diagnostic> diagnostics_from(const Row& row) {
  std::vector<told::Diagnostic> list;
  const Json& value = row.at("diagnostics");
  if (!value.is_array())
    row.refuse("diagnostics", fmt::format("must be an array, not {}", value.type_name()));
  for (const Json& item : value)
    list.push_back(diagnostic_from(item, fmt::format("{}: diagnostic {}", row.place, list.size() + 1)));
  return list;
}

// [low, high]; what is not finite was written as null.
results::Bounds bounds(const Row& row, const char* key) {
  const Json& value = row.at(key);
  if (!value.is_array() || value.size() != 2) row.refuse(key, "must be null or [low, high]");
  double ends[2];
  for (std::size_t i = 0; i < 2; ++i) {
    if (!value[i].is_number() && !value[i].is_null()) row.refuse(key, "must hold two numbers");
    ends[i] = value[i].is_null() ? std::numeric_limits<double>::quiet_NaN() : value[i].get<double>();
  }
  return {ends[0], ends[1]};
}

int substeps_from(const Row& row) {
  const std::int64_t parts = row.integer("substeps");
  if (parts < 1 || parts > std::numeric_limits<int>::max()) row.refuse("substeps", "must be at least 1");
  return static_cast<int>(parts);
}

Verdict from_row(const Json& json, const std::string& place) {
  if (!json.is_object()) throw core::InputError(place + ": a verdict must be an object");
  const Row row{json, place};
  Verdict v;
  v.scenario = row.string("scenario");
  v.scenario_hash = row.string("scenario_hash");
  v.engine = row.string("engine");
  v.version = row.string("version");
  v.version_listed = row.boolean("version_listed");
  v.precision = row.string("precision");
  v.path = row.string("path");
  v.gyroscopic = row.string("gyroscopic");
  v.settings = row.pairs("settings");
  v.unforceable = row.strings("unforceable");
  v.integrator = row.string("integrator");
  v.closed_form = row.boolean("closed_form");
  if (json.contains("substeps")) v.substeps = substeps_from(row);  // older rows lack it
  v.dt = row.real("dt");
  v.dt_text = row.string("dt_text");
  v.sampling = row.string("sampling");
  v.claim = row.string("claim");
  v.observable = row.string("observable");
  v.evidence = row.string("evidence");
  v.measured = row.real("measured");
  if (!row.at("interval").is_null()) v.interval = bounds(row, "interval");
  if (!row.at("first_bad_step").is_null()) v.first_bad_step = row.integer("first_bad_step");
  v.allowed = row.real("allowed");
  v.tolerance_scale = row.real("tolerance_scale");
  if (!row.at("spread").is_null()) v.spread = row.real("spread");
  v.unit = row.string("unit");
  v.truth_error = row.real("truth_error");
  v.status = row.status("status");
  if (row.at("allowed").is_null() && !has_allowed(v)) v.allowed = 0;  // as where nothing was measured
  v.expected = row.status("expected");
  if (!row.at("expected_size").is_null()) v.expected_size = row.real("expected_size");
  v.expected_within = row.real("expected_within");
  row.boolean("as_expected");  // follows from the others; only its place is checked
  v.expected_reason = row.string("expected_reason");
  v.tolerance_reason = row.string("reason");
  v.detail = row.string("detail");
  v.diagnostics = diagnostics_from(row);
  v.complaints = row.string("stderr");
  v.reproduce = row.string("reproduce");
  v.cpu_seconds = row.real("cpu_seconds");
  v.cpu_verified = json.contains("cpu_verified") && row.boolean("cpu_verified");  // older rows lack it
  v.body_steps = row.integer("body_steps");
  return v;
}

Provenance provenance_from(const Json& json, const std::string& place) {
  if (!json.is_object()) throw core::InputError(place + ": must be an object");
  const Row row{json, place};
  Provenance p;
  for (const auto& [key, text] : provenance_texts)
    if (json.contains(key)) p.*text = row.string(key);
  if (json.contains("tolerance_scale")) p.tolerance_scale = row.real("tolerance_scale");
  return p;
}

// nlohmann says "[json.exception.parse_error.101] parse error at line 2, column 3: …"; the place goes in
// front.
Json parse(std::string_view document, const std::string& file, unsigned first_line) {
  try {
    return input::parse_json<Json>(document);
  } catch (const input::BadJson& error) {
    if (error.byte == 0) throw core::InputError(file, first_line, 1, error.what());
    const std::size_t at = std::min(error.byte == 0 ? 0 : error.byte - 1, document.size());
    const std::string_view before = document.substr(0, at);
    const auto lines = static_cast<unsigned>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t line_start = lines == 0 ? 0 : before.rfind('\n') + 1;
    throw core::InputError(file, first_line + lines, static_cast<unsigned>(at - line_start + 1),
                           error.what());
  }
}

}  // namespace

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json diagnostic_json(const told::Diagnostic& d) {
  const auto maybe = [](const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
  };
  return {{"kind", d.kind},
          {"bodies", Json(d.bodies)},
          {"body_count", d.body_count},
          {"method", d.method},
          {"order", d.order},
          {"since", number(d.since)},
          {"until", maybe(d.until)},
          {"count", d.count},
          {"limit", maybe(d.limit)},
          {"limit_unit", d.limit_unit},
          {"reached", maybe(d.reached)},
          {"unit", d.unit},
          {"text", d.text}};
}

namespace {

// Zero would say that no error at all is allowed.
bool says_nothing(const Verdict& v) { return v.allowed == 0 && !has_allowed(v); }

}  // namespace

Json row(const Verdict& v) {
  Json diagnostics = Json::array();
  for (const told::Diagnostic& d : v.diagnostics) diagnostics.push_back(diagnostic_json(d));
  Json settings = Json::object();
  for (const auto& [name, value] : v.settings) settings[name] = value;
  return {{"scenario", v.scenario},
          {"scenario_hash", v.scenario_hash},
          {"engine", v.engine},
          {"version", v.version},
          {"version_listed", v.version_listed},
          {"precision", v.precision},
          {"path", v.path},
          {"gyroscopic", v.gyroscopic},
          {"settings", std::move(settings)},
          {"unforceable", Json(v.unforceable)},
          {"integrator", v.integrator},
          {"closed_form", v.closed_form},
          {"substeps", v.substeps},
          {"dt", number(v.dt)},
          {"dt_text", v.dt_text},
          {"sampling", v.sampling},
          {"claim", v.claim},
          {"observable", v.observable},
          {"evidence", v.evidence},
          {"measured", number(v.measured)},
          {"interval",
           v.interval ? Json::array({number(v.interval->low), number(v.interval->high)}) : Json(nullptr)},
          {"first_bad_step", v.first_bad_step ? Json(*v.first_bad_step) : Json(nullptr)},
          {"allowed", says_nothing(v) ? Json(nullptr) : number(v.allowed)},
          {"tolerance_scale", number(v.tolerance_scale)},
          {"spread", v.spread ? number(*v.spread) : Json(nullptr)},
          {"unit", v.unit},
          {"truth_error", number(v.truth_error)},
          {"status", results::name(v.status)},
          {"expected", results::name(v.expected)},
          {"expected_size", v.expected_size ? number(*v.expected_size) : Json(nullptr)},
          {"expected_within", number(v.expected_within)},
          {"as_expected", v.as_expected()},
          {"expected_reason", v.expected_reason},
          {"reason", v.tolerance_reason},
          {"detail", v.detail},
          {"diagnostics", std::move(diagnostics)},
          {"stderr", v.complaints},
          {"reproduce", v.reproduce},
          {"cpu_seconds", number(v.cpu_seconds)},
          {"cpu_verified", v.cpu_verified},
          {"body_steps", v.body_steps}};
}

Json provenance_json(const Provenance& provenance) {
  Json json;
  for (const auto& [key, text] : provenance_texts) json[key] = provenance.*text;
  json["tolerance_scale"] = number(provenance.tolerance_scale);
  return json;
}

Json document(const RunReport& report) {
  Json rows = Json::array();
  for (const Verdict& v : report.verdicts) rows.push_back(row(v));
  return {
      {"schema", schema}, {"provenance", provenance_json(report.provenance)}, {"verdicts", std::move(rows)}};
}

std::string to_json(const std::vector<Verdict>& verdicts, const Provenance& provenance) {
  std::string out = fmt::format("{{\"schema\": {},\n\"provenance\": {},\n\"verdicts\": [", schema,
                                text(provenance_json(provenance)));
  for (std::size_t i = 0; i < verdicts.size(); ++i)
    (out += i == 0 ? "\n" : ",\n") += to_json_line(verdicts[i]);
  return out + (verdicts.empty() ? "]}\n" : "\n]}\n");
}

RunReport read_json(std::string_view document, const std::string& file) {
  return read_document(parse(document, file, 1), file);
}

RunReport read_document(Json json, const std::string& file) {
  if (!json.is_object() || !json.contains("schema") || !json.contains("verdicts"))
    throw core::InputError(file, 0, 0, "not a report: it needs \"schema\" and \"verdicts\"");
  if (json["schema"] != schema)
    throw core::InputError(
        file, 0, 0, fmt::format("schema {}, but this program reads schema {}", text(json["schema"]), schema));
  if (!json["verdicts"].is_array()) throw core::InputError(file, 0, 0, "\"verdicts\" must be an array");

  RunReport report;
  if (json.contains("provenance"))
    report.provenance = provenance_from(json["provenance"], file + ": \"provenance\"");
  for (Json& item : json["verdicts"]) {
    report.verdicts.push_back(
        from_row(item, fmt::format("{}: verdict {}", file, report.verdicts.size() + 1)));
    item = nullptr;  // its memory is that of the next row
  }
  return report;
}

std::string to_json_line(const Verdict& verdict) { return text(row(verdict)); }

Verdict from_json_line(std::string_view line, const std::string& file, unsigned line_number) {
  return from_row(parse(line, file, line_number), fmt::format("{}:{}", file, line_number));
}

}  // namespace cylon::reports
