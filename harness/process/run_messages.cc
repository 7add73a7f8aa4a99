#include "harness/process/run_messages.h"

#include "harness/process/json_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace cylon::process {

using nlohmann::json;

namespace {

core::Pair pair(Fields& f) { return {f.index("body"), f.index("other"), f.index("plane")}; }

json json_of(const core::Vector3& v) { return {v.x(), v.y(), v.z()}; }

// The value of an index, which `count` things have.
std::size_t index_within(Fields& f, const char* key, std::size_t count, const char* expected) {
  const int i = f.index(key);
  if (i < 0 || static_cast<std::size_t>(i) >= count) f.fail(key, expected);
  return static_cast<std::size_t>(i);
}

json contacts_json(const std::vector<core::Contact>& contacts) {
  json rows = json::array();
  for (const core::Contact& c : contacts) {
    if (!c.point.allFinite() || !c.normal.allFinite()) continue;
    const bool told = c.impulse && std::isfinite(*c.impulse);
    rows.push_back({{"body", c.pair.body},
                    {"other", c.pair.other},
                    {"plane", c.pair.plane},
                    {"point", json_of(c.point)},
                    {"normal", json_of(c.normal)},
                    {"impulse", told ? json(*c.impulse) : json(nullptr)}});
    if (c.friction && c.friction->allFinite()) rows.back()["friction"] = json_of(*c.friction);
  }
  return rows;
}

core::Contact contact_from_json(Fields& f, const core::Scene& scene) {
  core::Contact c;
  c.pair = pair(f);
  const auto within = [](int i, std::size_t count) { return i >= 0 && static_cast<std::size_t>(i) < count; };
  if (!within(c.pair.body, scene.bodies.size())) f.fail("body", "must be the index of a body");
  if (c.pair.plane >= 0 ? !within(c.pair.plane, scene.planes.size())
                        : !within(c.pair.other, scene.bodies.size()))
    f.fail("other", "must be the index of a body, or -1 beside that of a plane");
  c.point = f.vector("point");
  c.normal = f.vector("normal");
  if (!f.at("impulse").is_null()) c.impulse = f.number("impulse");
  if (f.find("friction")) c.friction = f.vector("friction");
  return c;
}

json reactions_json(const std::vector<core::Reaction>& reactions) {
  json rows = json::array();
  for (const core::Reaction& r : reactions)
    if (r.point.allFinite() && r.impulse.allFinite() && r.moment.allFinite())
      rows.push_back({{"joint", r.joint},
                      {"point", json_of(r.point)},
                      {"impulse", json_of(r.impulse)},
                      {"moment", json_of(r.moment)}});
  return rows;
}

core::Reaction reaction_from_json(Fields& f, const core::Scene& scene) {
  return {index_within(f, "joint", scene.joints.size(), "must be the index of a joint"), f.vector("point"),
          f.vector("impulse"), f.vector("moment")};
}

}  // namespace

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

json constraint_forces_json(const ConstraintForces& forces) {
  json line = {{"contacts", contacts_json(forces.contacts)}};
  if (forces.reactions) line["reactions"] = reactions_json(*forces.reactions);
  return line;
}

ConstraintForces constraint_forces_from_json(const json& value, const core::Scene& scene) {
  ConstraintForces forces;
  Fields top(value, "");
  top.each("contacts", [&](const json& row, const std::string& place) {
    Fields f(row, place);
    forces.contacts.push_back(contact_from_json(f, scene));
    f.finish();
  });
  if (top.find("reactions")) {
    forces.reactions.emplace();
    top.each("reactions", [&](const json& row, const std::string& place) {
      Fields f(row, place);
      forces.reactions->push_back(reaction_from_json(f, scene));
      f.finish();
    });
  }
  top.finish();
  return forces;
}

}  // namespace cylon::process
