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

int order_if(Fields& fields) {
  if (!fields.find("order")) return 1;
  const int order = fields.index("order");
  if (order < 1) fields.fail("order", "must be at least 1");
  return order;
}

core::Pair pair(Fields& f) { return {f.index("body"), f.index("other"), f.index("plane")}; }

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
    engine.integrators.push_back(
        {text(s, "name"), order_if(s), text_if(s, "conserves"), s.find("adaptive") && s.flag("adaptive")});
  });
  each_if(f, "options", [&](Fields& o) {
    engine.options.push_back(
        {text(o, "name"), texts_if(o, "values"), text_if(o, "engine_default"), text_if(o, "meaning")});
  });
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
          {"plan", std::move(plan)}};
}

core::Terms terms_from_json(const json& value) {
  Fields f(value, "");
  f.at("ok");
  core::Terms terms{text_if(f, "path"), text_if(f, "integrator"),   order_if(f), text_if(f, "gyroscopic"),
                    settings_if(f),     texts_if(f, "unforceable"), {}};
  terms.closed_form = f.find("closed_form") && f.flag("closed_form");
  each_if(f, "plan", [&](Fields& s) {
    terms.plan.push_back({text(s, "name"), s.flag("in"), text_if(s, "reason")});
  });
  f.finish();
  return terms;
}

// ---- run ----------------------------------------------------------------------------------------

json run_request(const Run& run) {
  json watch = json::array();
  for (const core::Pair& p : run.watch)
    watch.push_back({{"body", p.body}, {"other", p.other}, {"plane", p.plane}});
  json request = {{"cmd", "run"},
                  {"steps", run.steps},
                  {"every", run.every},
                  {"at", run.at},
                  {"watch", std::move(watch)}};
  // Left out where they are not asked for: only workers that say they are live know them.
  if (run.resume) request["continue"] = true;
  if (run.contacts) request["contacts"] = true;
  return request;
}

Run run_from_json(const json& value) {
  Fields f(value, "");
  f.at("cmd");
  Run run;
  run.steps = f.integer("steps");
  if (run.steps < 0) f.fail("steps", "must not be negative");
  run.every = f.integer("every");
  if (run.every < 1) f.fail("every", "must be at least 1");
  if (f.find("at"))
    f.each("at", [&](const json& step, const std::string& place) {
      const std::int64_t before = run.at.empty() ? 0 : run.at.back();
      if (!step.is_number_integer() || step.get<std::int64_t>() <= before ||
          step.get<std::int64_t>() > run.steps)
        throw MalformedMessage(place + ": expected ascending steps in 1..steps");
      run.at.push_back(step.get<std::int64_t>());
    });
  if (f.find("watch"))
    f.each("watch", [&](const json& row, const std::string& place) {
      Fields fields(row, place);
      run.watch.push_back(pair(fields));
      fields.finish();
    });
  run.resume = f.find("continue") && f.flag("continue");
  run.contacts = f.find("contacts") && f.flag("contacts");
  if (run.resume && !run.watch.empty()) f.fail("watch", "must be empty where a run continues");
  f.finish();
  return run;
}

std::int64_t next_sample(const Run& run, std::int64_t step) {
  const std::int64_t multiple =
      run.every > run.steps ? run.steps : std::min((step / run.every + 1) * run.every, run.steps);
  const auto extra = std::upper_bound(run.at.begin(), run.at.end(), step);
  return extra == run.at.end() ? multiple : std::min(multiple, *extra);
}

json event_json(const core::Event& event) {
  return {{"event",
           {{"kind", event.kind == core::EventKind::bounce ? "bounce" : "apex"},
            {"body", event.pair.body},
            {"other", event.pair.other},
            {"plane", event.pair.plane},
            {"index", event.index},
            {"time", event.time},
            {"speed", event.speed},
            {"height", event.height}}}};
}

core::Event event_from_json(const json& value) {
  Fields top(value, "");
  Fields f(top.at("event"), "event");
  top.finish();
  // JSON has no NaN: null stands for it.
  const auto number = [&](const char* key) {
    return f.at(key).is_null() ? std::numeric_limits<double>::quiet_NaN() : f.number(key);
  };
  const std::string kind = f.text("kind");
  if (kind != "bounce" && kind != "apex") f.fail("kind", "expected \"bounce\" or \"apex\"");
  const core::Event event{kind == "bounce" ? core::EventKind::bounce : core::EventKind::apex,
                          pair(f),
                          f.index("index"),
                          number("time"),
                          number("speed"),
                          number("height")};
  f.finish();
  return event;
}

json contacts_json(const std::vector<core::Contact>& contacts) {
  json rows = json::array();
  for (const core::Contact& c : contacts) {
    if (!c.point.allFinite() || !c.normal.allFinite()) continue;
    const bool told = c.impulse && std::isfinite(*c.impulse);
    rows.push_back({{"body", c.pair.body},
                    {"other", c.pair.other},
                    {"plane", c.pair.plane},
                    {"point", {c.point.x(), c.point.y(), c.point.z()}},
                    {"normal", {c.normal.x(), c.normal.y(), c.normal.z()}},
                    {"impulse", told ? json(*c.impulse) : json(nullptr)}});
    if (c.friction && c.friction->allFinite())
      rows.back()["friction"] = {c.friction->x(), c.friction->y(), c.friction->z()};
  }
  return {{"contacts", std::move(rows)}};
}

std::vector<core::Contact> contacts_from_json(const json& value, std::size_t bodies, std::size_t planes) {
  std::vector<core::Contact> contacts;
  Fields top(value, "");
  top.each("contacts", [&](const json& row, const std::string& place) {
    Fields f(row, place);
    core::Contact c;
    c.pair = pair(f);
    const auto within = [](int i, std::size_t count) {
      return i >= 0 && static_cast<std::size_t>(i) < count;
    };
    if (!within(c.pair.body, bodies)) f.fail("body", "must be the index of a body");
    if (c.pair.plane >= 0 ? !within(c.pair.plane, planes) : !within(c.pair.other, bodies))
      f.fail("other", "must be the index of a body, or -1 beside that of a plane");
    c.point = f.vector("point");
    c.normal = f.vector("normal");
    if (!f.at("impulse").is_null()) c.impulse = f.number("impulse");
    if (f.find("friction")) c.friction = f.vector("friction");
    f.finish();
    contacts.push_back(c);
  });
  top.finish();
  return contacts;
}

json done_json(const Done& done) {
  return {{"ok", "run"},
          {"steps", done.steps},
          {"frames", done.frames},
          {"step_ns", done.step_ns},
          {"load_ns", done.load_ns},
          {"remarks", done.remarks}};
}

Done done_from_json(const json& value) {
  Fields f(value, "");
  f.at("ok");
  const Done done{f.integer("steps"), f.integer("frames"), f.number("step_ns"),
                  f.find("load_ns") ? f.number("load_ns") : 0, texts_if(f, "remarks")};
  if (!(done.step_ns >= 0)) f.fail("step_ns", "must not be negative");
  if (!(done.load_ns >= 0)) f.fail("load_ns", "must not be negative");
  f.finish();
  return done;
}

std::string line(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace cylon::process
