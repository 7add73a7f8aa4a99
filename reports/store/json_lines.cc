#include "reports/store/json_lines.h"

#include "harness/core/input_error.h"
#include "reports/store/json_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <utility>

namespace cylon::store {
namespace {

using nlohmann::json;
using Ordered = nlohmann::ordered_json;

Ordered number(double value) { return std::isfinite(value) ? Ordered(value) : Ordered(nullptr); }

// ---- Out -----------------------------------------------------------------------------------------------

Ordered to_json(const RunInfo& r) {
  return {{"uid", r.uid},
          {"label", r.label},
          {"revision", r.revision},
          {"order", r.revision_order.value_or(0)},
          {"date", r.date},
          {"machine", r.machine},
          {"os", r.os},
          {"compiler", r.compiler},
          {"flags", r.flags},
          {"build", r.build},
          {"command_line", r.command_line},
          {"request", r.request},
          {"note", r.note},
          {"complete", r.complete}};
}

Ordered to_json(const Cell& c) {
  return {{"hash", c.hash},           {"scenario", c.scenario}, {"scenario_hash", c.scenario_hash},
          {"engine", c.engine},       {"path", c.path},         {"integrator", c.integrator},
          {"precision", c.precision}, {"settings", c.settings}, {"dt", number(c.dt)},
          {"dt_text", c.dt_text}};
}

Ordered to_json(const Sample& s) {
  return {{"metric", s.metric.name},
          {"kind", name(s.metric.kind)},
          {"unit", s.metric.unit},
          {"repetition", s.repetition},
          {"value", s.text.empty() ? number(s.value) : Ordered(s.text)}};
}

Ordered to_json(const Judgement& j) {
  return {{"claim", j.claim},
          {"observable", j.observable},
          {"unit", j.unit},
          {"status", j.status},
          {"expected", j.expected},
          {"measured", number(j.measured)},
          {"allowed", number(j.allowed)},
          {"truth_error", number(j.truth_error)},
          {"detail", j.detail}};
}

Ordered to_json(const RunInfo& run, const Result& r) {
  Ordered samples = Ordered::array(), verdicts = Ordered::array();
  for (const Sample& s : r.samples) samples.push_back(to_json(s));
  for (const Judgement& j : r.judgements) verdicts.push_back(to_json(j));
  return {{"run", run.uid},   {"cell", r.cell.hash},           {"engine_version", r.engine_version},
          {"asked", r.asked}, {"samples", std::move(samples)}, {"verdicts", std::move(verdicts)}};
}

Ordered to_json(const Anchor& a) {
  return {{"name", a.name}, {"binary", a.binary}, {"build", a.build},
          {"date", a.date}, {"note", a.note},     {"run", a.run}};
}

Ordered to_json(const ChangePoint& p) {
  return {
      {"series", p.series}, {"revision", p.revision}, {"state", p.state}, {"date", p.date}, {"note", p.note}};
}

// ---- In ------------------------------------------------------------------------------------------------

RunInfo run_from(JsonObject object) {
  RunInfo r;
  r.uid = object.text("uid");
  if (r.uid.size() != 16 || r.uid.find_first_not_of("0123456789abcdef") != std::string::npos)
    object.refuse("uid", fmt::format("must be 16 hex digits, not '{}'", clean(r.uid)));
  r.label = object.text("label");
  r.revision = object.text("revision");
  r.revision_order = object.integer("order", INT64_MIN);
  r.date = object.text("date");
  r.machine = object.text("machine");
  r.os = object.text("os");
  r.compiler = object.text("compiler");
  r.flags = object.text("flags");
  r.build = object.text("build");
  r.command_line = object.text("command_line");
  r.request = object.text("request");
  r.note = object.text("note");
  r.complete = object.boolean("complete");
  object.finish();
  return r;
}

Cell cell_from(JsonObject object) {
  Cell c;
  c.hash = object.text("hash");
  c.scenario = object.text("scenario");
  c.scenario_hash = object.text("scenario_hash");
  c.engine = object.text("engine");
  c.path = object.text("path");
  c.integrator = object.text("integrator");
  c.precision = object.text("precision");
  c.settings = object.text("settings");
  c.dt = object.number("dt");
  c.dt_text = object.text("dt_text");
  object.finish();
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

Judgement judgement_from(JsonObject object) {
  Judgement j;
  j.claim = object.text("claim");
  j.observable = object.text("observable");
  j.unit = object.text("unit");
  j.status = object.text("status");
  j.expected = object.text("expected");
  j.measured = object.number("measured");
  j.allowed = object.number("allowed");
  j.truth_error = object.number("truth_error");
  j.detail = object.text("detail");
  object.finish();
  return j;
}

Anchor anchor_from(JsonObject object) {
  Anchor a;
  a.name = object.text("name");
  a.binary = object.text("binary");
  a.build = object.text("build");
  a.date = object.text("date");
  a.note = object.text("note");
  a.run = object.text("run");
  object.finish();
  return a;
}

ChangePoint change_point_from(JsonObject object) {
  ChangePoint p;
  p.series = object.text("series");
  p.revision = object.text("revision");
  p.state = object.text("state");
  if (p.state != "detected" && p.state != "active" && p.state != "ignored" && p.state != "fixed")
    object.refuse("state", fmt::format("'{}' is none of detected, active, ignored, fixed", clean(p.state)));
  p.date = object.text("date");
  p.note = object.text("note");
  object.finish();
  return p;
}

class Reader {
 public:
  Reader(Store& store, std::string file) : store_(store), place_{std::move(file), 0} {}

  void line(std::string_view text) {
    ++place_.line;
    if (text.find_first_not_of(" \t\r") == std::string_view::npos) return;
    const json row = parse_json(text, place_);
    if (!row.is_object() || row.size() != 1) place_.refuse("a line must be an object with one key");
    const std::string key = row.begin().key();
    if (!headed_ && key != "cylon_history")
      place_.refuse("the first line must be {\"cylon_history\": 1}, as `cylon track export` writes it");
    for (const auto& [known, read] : readers)
      if (key == known) return (this->*read)(row.begin().value());
    std::vector<std::string> names;
    for (const auto& [known, read] : readers) names.emplace_back(known);
    place_.refuse(fmt::format("unknown key '{}'{}", clean(key), core::did_you_mean(key, names)));
  }

  const Imported& imported() const { return imported_; }

 private:
  void head(const json& value) {
    if (value != json_lines_version)
      place_.refuse(fmt::format("\"cylon_history\" is version {}, this program reads {}", value.dump(),
                                json_lines_version));
    headed_ = true;
  }

  void cell(const json& value) {
    Cell c = cell_from({value, place_, "cell"});
    cells_[c.hash] = std::move(c);
  }

  void run(const json& value) {
    const RunInfo r = run_from({value, place_, "run"});
    std::int64_t id = 0;
    if (store_.import_run(r, id))
      ++imported_.runs;
    else if (r.complete)
      store_.finish_run(id);
    runs_[r.uid] = id;
  }

  void result(const json& value) {
    JsonObject object(value, place_, "result");
    Result r;
    const std::string uid = object.text("run"), hash = object.text("cell");
    const auto run = runs_.find(uid);
    if (run == runs_.end()) object.refuse("run", fmt::format("'{}' is not defined above", clean(uid)));
    const auto cell = cells_.find(hash);
    if (cell == cells_.end()) object.refuse("cell", fmt::format("'{}' is not defined above", clean(hash)));
    r.cell = cell->second;
    r.engine_version = object.text("engine_version");
    r.asked = object.text("asked");
    for (const json& item : object.array("samples"))
      r.samples.push_back(sample_from({item, place_, "sample"}));
    for (const json& item : object.array("verdicts"))
      r.judgements.push_back(judgement_from({item, place_, "verdict"}));
    object.finish();
    if (const std::string word = twice(r); !word.empty())
      place_.refuse(fmt::format("result: {} stands twice", word));
    const std::string stored = store_.stored_digest(run->second, hash);
    if (stored == digest(r)) {
      ++imported_.here_already;
    } else if (stored.empty()) {
      store_.add(run->second, r);
      ++imported_.results;
    } else {
      object.refuse("cell", fmt::format("'{}' of run {} is in the store with other values", hash, uid));
    }
  }

  void anchor(const json& value) {
    const Anchor a = anchor_from({value, place_, "anchor"});
    const std::vector<Anchor> here = store_.anchors();
    if (std::none_of(here.begin(), here.end(),
                     [&](const Anchor& other) { return other.name == a.name && other.date > a.date; }))
      store_.pin(a);
  }

  void change_point(const json& value) {
    const ChangePoint p = change_point_from({value, place_, "change_point"});
    const std::vector<ChangePoint> here = store_.change_points();
    if (std::none_of(here.begin(), here.end(), [&](const ChangePoint& other) {
          return other.series == p.series && other.revision == p.revision && other.date > p.date;
        }))
      store_.set(p);
  }

  static constexpr std::pair<const char*, void (Reader::*)(const json&)> readers[] = {
      {"cylon_history", &Reader::head}, {"cell", &Reader::cell},     {"run", &Reader::run},
      {"result", &Reader::result},      {"anchor", &Reader::anchor}, {"change_point", &Reader::change_point},
  };

  Store& store_;
  Place place_;
  bool headed_ = false;
  std::map<std::string, Cell> cells_;
  std::map<std::string, std::int64_t> runs_;
  Imported imported_;
};

}  // namespace

void write_json_lines(const Store& store, std::ostream& out) {
  const auto line = [&](const char* key, const Ordered& value) {
    out << Ordered{{key, value}}.dump(-1, ' ', true) << '\n';
  };
  line("cylon_history", json_lines_version);
  std::vector<Cell> cells = store.cells();
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) { return a.hash < b.hash; });
  for (const Cell& cell : cells) line("cell", to_json(cell));
  std::vector<RunInfo> runs = store.runs();
  std::sort(runs.begin(), runs.end(), [](const RunInfo& a, const RunInfo& b) { return a.id < b.id; });
  for (const RunInfo& run : runs) {
    line("run", to_json(run));
    for (const Result& result : store.results(run.id)) line("result", to_json(run, result));
  }
  for (const Anchor& anchor : store.anchors()) line("anchor", to_json(anchor));
  for (const ChangePoint& point : store.change_points()) line("change_point", to_json(point));
}

Imported read_json_lines(Store& store, std::string_view document, const std::string& file) {
  Reader reader(store, file);
  store.in_one_transaction([&] {
    while (!document.empty()) {
      const std::size_t end = document.find('\n');
      reader.line(document.substr(0, end));
      document.remove_prefix(end == std::string_view::npos ? document.size() : end + 1);
    }
  });
  return reader.imported();
}

}  // namespace cylon::store
