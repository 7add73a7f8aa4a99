#include "harness/process/messages.h"

#include "harness/process/json_fields.h"
#include "harness/process/scene_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::process {
namespace {

using core::Setting;
using nlohmann::json;

json settings_json(const std::vector<Setting>& settings) {
  json rows = json::array();
  for (const Setting& s : settings)
    rows.push_back(
        {{"name", s.name}, {"value", s.value}, {"engine_default", s.engine_default}, {"reason", s.reason}});
  return rows;
}

// What a worker says of itself stands in every row of every report.
constexpr std::size_t longest_text = 4096, longest_list = 1000;

std::string text_of(const Fields& fields, const char* key, std::string text) {
  if (text.size() > longest_text) fields.fail(key, fmt::format("longer than {} bytes", longest_text));
  return text;
}

std::string text(Fields& fields, const char* key) { return text_of(fields, key, fields.text(key)); }

void require_short(Fields& fields, const char* key) {
  if (fields.at(key).size() > longest_list)
    fields.fail(key, fmt::format("more than {} entries", longest_list));
}

// Lists that a worker may leave out.
template <class Row>
void each_if(Fields& fields, const char* key, Row row) {
  if (!fields.find(key)) return;
  require_short(fields, key);
  fields.each(key, [&](const json& value, const std::string& place) {
    Fields f(value, place);
    row(f);
    f.finish();
  });
}

std::string text_if(Fields& fields, const char* key) { return fields.find(key) ? text(fields, key) : ""; }

std::vector<std::string> texts_if(Fields& fields, const char* key) {
  std::vector<std::string> result;
  if (!fields.find(key)) return result;
  require_short(fields, key);
  fields.each(key, [&](const json& value, const std::string& place) {
    if (!value.is_string()) throw MalformedMessage(place + ": expected a string");
    result.push_back(text_of(fields, key, value.get<std::string>()));
  });
  return result;
}

std::vector<Setting> settings_if(Fields& fields) {
  std::vector<Setting> result;
  each_if(fields, "settings", [&](Fields& f) {
    result.push_back({text(f, "name"), text(f, "value"), text_if(f, "engine_default"), text_if(f, "reason")});
  });
  return result;
}

// 1 where there is none.
int positive_if(Fields& fields, const char* key) {
  if (!fields.find(key)) return 1;
  const int number = fields.index(key);
  if (number < 1) fields.fail(key, "must be at least 1");
  return number;
}

}  // namespace

// ---- hello --------------------------------------------------------------------------------------

json hello_json(const Hello& hello) {
  const core::Engine& engine = hello.engine;
  json result = {{"ok", "hello"},
                 {"protocol", protocol_version},
                 {"engine", engine.name},
                 {"version", engine.version},
                 {"precision", engine.precision},
                 {"events", hello.events},
                 {"live", hello.live},
                 {"default_path_rule", engine.default_path_rule}};
  json& paths = result["paths"] = json::array();
  for (const core::Path& p : engine.paths)
    paths.push_back({{"name", p.name},
                     {"summary", p.summary},
                     {"settings", settings_json(p.settings)},
                     {"unforceable", p.unforceable}});
  json& integrators = result["schemes"] = json::array();
  for (const core::Integrator& s : engine.integrators)
    integrators.push_back(
        {{"name", s.name}, {"order", s.order}, {"conserves", s.conserves}, {"adaptive", s.adaptive}});
  json& options = result["options"] = json::array();
  for (const core::Option& o : engine.options)
    options.push_back({{"name", o.name},
                       {"values", o.values},
                       {"engine_default", o.engine_default},
                       {"meaning", o.meaning}});
  result["knows"] = engine.knows;
  return result;
}

Hello hello_from_json(const json& value) {
  Fields f(value, "");
  f.at("ok");
  if (const std::int64_t protocol = f.integer("protocol"); protocol != protocol_version)
    f.fail("protocol", fmt::format("this harness speaks {}, the worker {}", protocol_version, protocol));
  Hello hello;
  core::Engine& engine = hello.engine;
  engine.name = text(f, "engine");
  engine.version = text(f, "version");
  engine.precision = text(f, "precision");
  if (engine.precision != "double" && engine.precision != "float")
    f.fail("precision", "expected \"double\" or \"float\"");
  if (f.find("events")) hello.events = f.flag("events");
  if (f.find("live")) hello.live = f.flag("live");
  each_if(f, "paths", [&](Fields& p) {
    engine.paths.push_back(
        {text(p, "name"), text_if(p, "summary"), settings_if(p), texts_if(p, "unforceable")});
  });
  engine.default_path_rule = text_if(f, "default_path_rule");
  each_if(f, "schemes", [&](Fields& s) {
    engine.integrators.push_back({text(s, "name"), positive_if(s, "order"), text_if(s, "conserves"),
                                  s.find("adaptive") && s.flag("adaptive")});
  });
  each_if(f, "options", [&](Fields& o) {
    engine.options.push_back(
        {text(o, "name"), texts_if(o, "values"), text_if(o, "engine_default"), text_if(o, "meaning")});
  });
  engine.knows = texts_if(f, "knows");
  f.finish();
  return hello;
}

// ---- load ---------------------------------------------------------------------------------------

json load_request(const core::Scene& scene, const core::Setup& setup) {
  json request = {{"cmd", "load"},      {"scene", to_json(scene)},        {"dt", setup.dt},
                  {"path", setup.path}, {"integrator", setup.integrator}, {"options", setup.options}};
  // Left out where nobody asks for it: workers that are older than the key go on working.
  if (setup.tolerance > 0) request["tolerance"] = setup.tolerance;
  if (setup.force) request["force"] = true;
  return request;
}

core::Setup setup_from_json(const json& value) {
  Fields f(value, "");
  f.at("cmd"), f.at("scene");
  core::Setup setup;
  setup.dt = f.number("dt");
  if (!(setup.dt > 0)) f.fail("dt", "must be positive");
  setup.path = f.text("path");
  setup.integrator = f.text("integrator");
  const json& options = f.at("options");
  if (!options.is_object()) f.fail("options", "expected an object");
  for (const auto& [name, option] : options.items()) {
    if (!option.is_string()) f.fail("options." + name, "expected a string");
    setup.options[name] = option.get<std::string>();
  }
  if (f.find("tolerance")) {
    setup.tolerance = f.number("tolerance");
    if (!(setup.tolerance > 0)) f.fail("tolerance", "must be positive");
  }
  setup.force = f.find("force") && f.flag("force");
  f.finish();
  return setup;
}

json terms_json(const core::Terms& terms) {
  json plan = json::array();
  for (const core::Stage& s : terms.plan)
    plan.push_back({{"name", s.name}, {"in", s.in}, {"reason", s.reason}});
  return {{"ok", "load"},
          {"path", terms.path},
          {"integrator", terms.integrator},
          {"order", terms.order},
          {"gyroscopic", terms.gyroscopic},
          {"settings", settings_json(terms.settings)},
          {"unforceable", terms.unforceable},
          {"closed_form", terms.closed_form},
          {"substeps", terms.substeps},
          {"plan", std::move(plan)}};
}

core::Terms terms_from_json(const json& value) {
  Fields f(value, "");
  f.at("ok");
  core::Terms terms{text_if(f, "path"),
                    text_if(f, "integrator"),
                    positive_if(f, "order"),
                    text_if(f, "gyroscopic"),
                    settings_if(f),
                    texts_if(f, "unforceable"),
                    {}};
  terms.closed_form = f.find("closed_form") && f.flag("closed_form");
  terms.substeps = positive_if(f, "substeps");
  each_if(f, "plan", [&](Fields& s) {
    terms.plan.push_back({text(s, "name"), s.flag("in"), text_if(s, "reason")});
  });
  f.finish();
  return terms;
}

// ---- done ---------------------------------------------------------------------------------------

namespace {

json diagnostic_json(const told::Diagnostic& d) {
  json row = {{"kind", d.kind},   {"bodies", d.bodies}, {"body_count", d.body_count}, {"method", d.method},
              {"order", d.order}, {"since", d.since},   {"count", d.count},           {"text", d.text}};
  const auto quantity = [&](const char* key, const std::optional<double>& value) {
    if (value) row[key] = std::isfinite(*value) ? json(*value) : json(nullptr);
  };
  quantity("until", d.until), quantity("limit", d.limit), quantity("reached", d.reached);
  if (!d.limit_unit.empty()) row["limit_unit"] = d.limit_unit;
  if (!d.unit.empty()) row["unit"] = d.unit;
  return row;
}

// A number that may be absent or null.
std::optional<double> number_if(Fields& f, const char* key) {
  const json* value = f.find(key);
  return value && !value->is_null() ? std::optional(f.number(key)) : std::nullopt;
}

told::Diagnostic diagnostic_from(Fields& f) {
  told::Diagnostic d;
  d.kind = text(f, "kind");
  if (d.kind.empty()) f.fail("kind", "must not be empty");
  d.bodies = texts_if(f, "bodies");
  const std::int64_t bodies =
      f.find("body_count") ? f.integer("body_count") : static_cast<std::int64_t>(d.bodies.size());
  if (bodies < static_cast<std::int64_t>(d.bodies.size()))
    f.fail("body_count", "less than the bodies that are named");
  d.body_count = static_cast<std::size_t>(bodies);
  d.method = text_if(f, "method");
  d.order = f.find("order") ? f.index("order") : 0;
  if (d.order < 0) f.fail("order", "must not be negative");
  d.since = f.find("since") ? f.number("since") : 0;
  if (!(d.since >= 0)) f.fail("since", "must not be negative");
  d.until = number_if(f, "until");
  if (d.until && !(*d.until >= d.since)) f.fail("until", "before `since`");
  d.count = f.find("count") ? f.integer("count") : 1;
  if (d.count < 1) f.fail("count", "must be at least 1");
  d.limit = number_if(f, "limit"), d.limit_unit = text_if(f, "limit_unit");
  d.reached = number_if(f, "reached"), d.unit = text_if(f, "unit");
  d.text = text(f, "text");
  return d;
}

}  // namespace

json done_json(const Done& done) {
  json diagnostics = json::array();
  for (const told::Diagnostic& d : done.diagnostics) diagnostics.push_back(diagnostic_json(d));
  json line = {{"ok", "run"},
               {"steps", done.steps},
               {"frames", done.frames},
               {"step_ns", done.step_ns},
               {"load_ns", done.load_ns},
               {"remarks", done.remarks},
               {"diagnostics", std::move(diagnostics)}};
  for (const core::Work& w : done.works) line["works"].push_back({{"force", w.force}, {"work", w.work}});
  return line;
}

Done done_from_json(const json& value) {
  Fields f(value, "");
  f.at("ok");
  Done done{f.integer("steps"), f.integer("frames"), f.number("step_ns"),
            f.find("load_ns") ? f.number("load_ns") : 0, texts_if(f, "remarks")};
  each_if(f, "diagnostics", [&](Fields& row) { done.diagnostics.push_back(diagnostic_from(row)); });
  each_if(f, "works", [&](Fields& row) {
    const double none = std::numeric_limits<double>::quiet_NaN();  // null stands for what is not finite
    done.works.push_back({text(row, "force"), number_if(row, "work").value_or(none)});
  });
  if (!(done.step_ns >= 0)) f.fail("step_ns", "must not be negative");
  if (!(done.load_ns >= 0)) f.fail("load_ns", "must not be negative");
  f.finish();
  return done;
}

std::string line(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace cylon::process
