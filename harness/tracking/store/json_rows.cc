#include "harness/tracking/store/json_rows.h"

#include "reports/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <string_view>
#include <type_traits>
#include <utility>

namespace cylon::store {
namespace {

using nlohmann::json;
using Ordered = nlohmann::ordered_json;

// ---- The keys of each row, once for both ways; const where it is written ----------------------------------

template <class T, class Row>
concept Of = std::same_as<std::remove_const_t<T>, Row>;

void each(Of<RunInfo> auto& r, auto&& field) {
  field("uid", r.uid);
  field("label", r.label);
  field("revision", r.revision);
  field("order", r.revision_order);
  field("date", r.date);
  field("machine", r.machine);
  field("os", r.os);
  field("compiler", r.compiler);
  field("flags", r.flags);
  field("build", r.build);
  field("command_line", r.command_line);
  field("request", r.request);
  field("note", r.note);
  field("complete", r.complete);
}

void each(Of<Cell> auto& c, auto&& field) {
  field("hash", c.hash);
  field("scenario", c.scenario);
  field("scenario_hash", c.scenario_hash);
  field("engine", c.engine);
  field("path", c.path);
  field("integrator", c.integrator);
  field("precision", c.precision);
  field("settings", c.settings);
  field("dt", c.dt);
  field("dt_text", c.dt_text);
}

void each(Of<Judgement> auto& j, auto&& field) {
  field("claim", j.claim);
  field("observable", j.observable);
  field("unit", j.unit);
  field("status", j.status);
  field("expected", j.expected);
  field("measured", j.measured);
  field("allowed", j.allowed);
  field("truth_error", j.truth_error);
  field("detail", j.detail);
}

void each(Of<Anchor> auto& a, auto&& field) {
  field("name", a.name);
  field("binary", a.binary);
  field("build", a.build);
  field("date", a.date);
  field("note", a.note);
  field("run", a.run);
}

void each(Of<ChangePoint> auto& p, auto&& field) {
  field("series", p.series);
  field("revision", p.revision);
  field("state", p.state);
  field("date", p.date);
  field("note", p.note);
}

// ---- The two ways -----------------------------------------------------------------------------------------

using reports::number;

struct Write {
  Ordered& out;
  void operator()(const char* key, const std::string& value) const { out[key] = value; }
  void operator()(const char* key, double value) const { out[key] = number(value); }
  void operator()(const char* key, bool value) const { out[key] = value; }
  void operator()(const char* key, const std::optional<std::int64_t>& value) const {
    out[key] = value.value_or(0);
  }
};

struct Read {
  JsonObject& in;
  void operator()(const char* key, std::string& value) const { value = in.text(key); }
  void operator()(const char* key, double& value) const { value = in.number(key); }
  void operator()(const char* key, bool& value) const { value = in.boolean(key); }
  void operator()(const char* key, std::optional<std::int64_t>& value) const {
    value = in.integer(key, INT64_MIN);
  }
};

template <class Row>
Ordered written(const Row& row) {
  Ordered out = Ordered::object();
  each(row, Write{out});
  return out;
}

template <class Row>
Row read(JsonObject& object) {
  Row row;
  each(row, Read{object});
  object.finish();
  return row;
}

Ordered to_json(const Sample& s) {
  return {{"metric", s.metric.name},
          {"kind", name(s.metric.kind)},
          {"unit", s.metric.unit},
          {"repetition", s.repetition},
          {"value", s.text.empty() ? number(s.value) : Ordered(s.text)}};
}

}  // namespace

Ordered to_json(const RunInfo& run) { return written(run); }
Ordered to_json(const Cell& cell) { return written(cell); }
Ordered to_json(const Anchor& anchor) { return written(anchor); }
Ordered to_json(const ChangePoint& point) { return written(point); }

Ordered to_json(const RunInfo& run, const Result& r) {
  Ordered samples = Ordered::array(), verdicts = Ordered::array();
  for (const Sample& s : r.samples) samples.push_back(to_json(s));
  for (const Judgement& j : r.judgements) verdicts.push_back(written(j));
  return {{"run", run.uid},   {"cell", r.cell.hash},           {"engine_version", r.engine_version},
          {"asked", r.asked}, {"samples", std::move(samples)}, {"verdicts", std::move(verdicts)}};
}

RunInfo run_from(JsonObject object) {
  RunInfo r = read<RunInfo>(object);
  if (r.uid.size() != 16 || r.uid.find_first_not_of("0123456789abcdef") != std::string::npos)
    object.refuse("uid", fmt::format("must be 16 hex digits, not '{}'", clean(r.uid)));
  return r;
}

Cell cell_from(JsonObject object) {
  Cell c = read<Cell>(object);
  if (!(c.dt >= 0)) object.refuse("dt", "must be a number >= 0");
  if (const std::string hash = cell_hash(c); c.hash != hash)
    object.refuse("hash",
                  fmt::format("'{}' is not that of the other keys, which is {}", clean(c.hash), hash));
  return c;
}

Sample sample_from(JsonObject object) {
  Sample s;
  s.metric.name = object.text("metric");
  const std::string word = object.text("kind");
  const auto kind = kind_from(word);
  if (!kind)
    object.refuse("kind", fmt::format("'{}' is none of exact, error, time, size, info", clean(word)));
  s.metric.kind = *kind;
  s.metric.unit = object.text("unit");
  s.repetition = object.integer("repetition", 0);
  if (const json& value = object.value("value"); value.is_string())
    s.text = value.get<std::string>();
  else
    s.value = object.number("value");
  object.finish();
  return s;
}

Judgement judgement_from(JsonObject object) { return read<Judgement>(object); }

Anchor anchor_from(JsonObject object) { return read<Anchor>(object); }

ChangePoint change_point_from(JsonObject object) {
  static constexpr std::array<std::string_view, 4> states = {"detected", "active", "ignored", "fixed"};
  ChangePoint p = read<ChangePoint>(object);
  if (std::find(states.begin(), states.end(), p.state) == states.end())
    object.refuse("state", fmt::format("'{}' is none of {}", clean(p.state), fmt::join(states, ", ")));
  return p;
}

}  // namespace cylon::store
