// Queries of the store.
#include "harness/tracking/store/database.h"
#include "harness/tracking/store/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace cylon::store {
namespace {

#define RUN_COLUMNS                                                                                     \
  "id, uid, label, revision, revision_order, date, machine, os, compiler, flags, build, command_line, " \
  "request, note, complete"
#define CELL_COLUMNS \
  "hash, scenario, scenario_hash, engine, path, integrator, precision, settings, dt, dt_text"

RunInfo read_run(Query& row) {
  RunInfo r;
  r.id = row.integer();
  for (std::string* text : {&r.uid, &r.label, &r.revision}) *text = row.text();
  r.revision_order = row.integer();
  for (std::string* text :
       {&r.date, &r.machine, &r.os, &r.compiler, &r.flags, &r.build, &r.command_line, &r.request, &r.note})
    *text = row.text();
  r.complete = row.integer() != 0;
  return r;
}

Cell read_cell(Query& row) {
  Cell c;
  for (std::string* text :
       {&c.hash, &c.scenario, &c.scenario_hash, &c.engine, &c.path, &c.integrator, &c.precision, &c.settings})
    *text = row.text();
  c.dt = row.real();
  c.dt_text = row.text();
  return c;
}

Metric read_metric(Query& row) {
  Metric m;
  m.name = row.text();
  m.kind = kind_from(row.text()).value_or(Kind::info);
  m.unit = row.text();
  return m;
}

// The foreign keys see to it that it is there; only damage to the file can take it away.
template <class Map>
auto& known(const Database& database, Map& map, std::int64_t id) {
  const auto found = map.find(id);
  if (found == map.end()) database.fail_as_damaged("a row has a dangling reference");
  return found->second;
}

// By run: the points of all series begin as copies of these.
using Points = std::unordered_map<std::int64_t, Point>;

Points points_of_runs(Database& database) {
  Points points;
  Query row = database.query("SELECT id, revision, revision_order, label, date, machine, build FROM run");
  while (row.step()) {
    Point p;
    p.run = row.integer();
    p.revision = row.text();
    p.revision_order = row.integer();
    for (std::string* text : {&p.label, &p.date, &p.machine, &p.build}) *text = row.text();
    points.emplace(p.run, std::move(p));
  }
  return points;
}

using Versions = std::unordered_map<std::int64_t, std::string>;  // by run

Versions versions_of(Database& database, const std::string& engine) {
  Versions versions;
  Query row = database.query("SELECT run, version FROM engine_version WHERE engine = ?");
  row.bind(engine);
  while (row.step()) {
    const std::int64_t run = row.integer();
    versions[run] = row.text();
  }
  return versions;
}

// The rows of one cell and metric.
std::vector<Point> read_points(Database& database, std::int64_t cell, std::int64_t metric,
                               const Points& points, const Versions& versions) {
  std::vector<Point> read;
  Query row = database.query(
      "SELECT run, value, text FROM sample WHERE cell = ? AND metric = ? ORDER BY run, repetition");
  row.bind(cell, metric);
  while (row.step()) {
    const std::int64_t run = row.integer();
    if (read.empty() || read.back().run != run) {
      read.push_back(known(database, points, run));
      if (const auto version = versions.find(run); version != versions.end())
        read.back().engine_version = version->second;
    }
    Point& point = read.back();
    const double value = row.real();
    const std::string text = row.text();
    if (text.empty())
      point.values.push_back(value);
    else
      point.text += (point.text.empty() ? "" : " ") + text;
  }
  std::stable_sort(read.begin(), read.end(), [](const Point& a, const Point& b) {
    return std::tie(a.revision_order, a.run) < std::tie(b.revision_order, b.run);
  });
  return read;
}

void read_samples(Database& database, std::int64_t run, std::map<std::int64_t, Result>& results) {
  Query row = database.query(
      "SELECT s.cell, m.name, m.kind, m.unit, s.repetition, s.value, s.text FROM sample s JOIN metric m ON "
      "m.id = s.metric WHERE s.run = ?");
  row.bind(run);
  while (row.step()) {
    Result& result = known(database, results, row.integer());
    Sample s;
    s.metric = read_metric(row);
    s.repetition = row.integer();
    s.value = row.real();
    s.text = row.text();
    result.samples.push_back(std::move(s));
  }
}

void read_judgements(Database& database, std::int64_t run, std::map<std::int64_t, Result>& results) {
  Query row = database.query(
      "SELECT v.cell, c.name, c.observable, c.unit, v.status, v.expected, v.measured, v.allowed, "
      "v.truth_error, "
      "v.detail FROM verdict v JOIN claim c ON c.id = v.claim WHERE v.run = ?");
  row.bind(run);
  while (row.step()) {
    Result& result = known(database, results, row.integer());
    Judgement j;
    for (std::string* text : {&j.claim, &j.observable, &j.unit, &j.status, &j.expected}) *text = row.text();
    for (double* value : {&j.measured, &j.allowed, &j.truth_error}) *value = row.real();
    j.detail = row.text();
    result.judgements.push_back(std::move(j));
  }
}

}  // namespace

std::vector<RunInfo> Store::runs() const {
  std::vector<RunInfo> all;
  Query row = database_->query("SELECT " RUN_COLUMNS " FROM run ORDER BY revision_order, id");
  while (row.step()) all.push_back(read_run(row));
  return all;
}

std::optional<RunInfo> Store::find_run(const std::string& word) const {
  const auto latest = [&](const char* sql, const auto& value) -> std::optional<RunInfo> {
    Query row = database_->query(sql);
    if (!row.bind(value).step()) return std::nullopt;
    return read_run(row);
  };
  std::optional<RunInfo> found;
  if (word.size() >= 8 && word.find_first_not_of("0123456789abcdef") == std::string::npos)
    found = latest("SELECT " RUN_COLUMNS " FROM run WHERE uid LIKE ? || '%' ORDER BY id DESC LIMIT 1", word);
  if (!found)
    found = latest("SELECT " RUN_COLUMNS " FROM run WHERE label = ? ORDER BY id DESC LIMIT 1", word);
  if (!found)
    found = latest("SELECT " RUN_COLUMNS " FROM run WHERE revision = ? ORDER BY id DESC LIMIT 1", word);
  std::int64_t id = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), id);
  if (!found && error == std::errc() && end == word.data() + word.size())
    found = latest("SELECT " RUN_COLUMNS " FROM run WHERE id = ?", id);
  return found;
}

std::vector<Cell> Store::cells(const std::string& glob) const {
  std::vector<Cell> all;
  Query row = database_->query("SELECT " CELL_COLUMNS " FROM cell WHERE name GLOB ? ORDER BY name, hash");
  row.bind(glob);
  while (row.step()) all.push_back(read_cell(row));
  return all;
}

std::vector<Result> Store::results(std::int64_t run) const {
  std::map<std::int64_t, Result> by_cell;
  {
    Query row = database_->query(
        "SELECT c.id, r.asked, coalesce((SELECT version FROM engine_version e WHERE e.run = r.run AND "
        "e.engine = "
        "c.engine), ''), " CELL_COLUMNS " FROM result r JOIN cell c ON c.id = r.cell WHERE r.run = ?");
    row.bind(run);
    while (row.step()) {
      Result& result = by_cell[row.integer()];
      result.asked = row.text();
      result.engine_version = row.text();
      result.cell = read_cell(row);
    }
  }
  read_samples(*database_, run, by_cell);
  read_judgements(*database_, run, by_cell);
  std::vector<Result> all;
  all.reserve(by_cell.size());
  for (auto& [id, result] : by_cell) all.push_back(canonical(std::move(result)));
  std::sort(all.begin(), all.end(),
            [](const Result& a, const Result& b) { return a.cell.hash < b.cell.hash; });
  return all;
}

std::vector<Series> Store::series(const std::string& cell_glob, const std::string& metric_glob) const {
  const Points points = points_of_runs(*database_);
  std::vector<std::pair<std::int64_t, Cell>> wanted_cells;
  {
    Query row =
        database_->query("SELECT id, " CELL_COLUMNS " FROM cell WHERE name GLOB ? ORDER BY name, hash");
    row.bind(cell_glob);
    while (row.step()) {
      const std::int64_t id = row.integer();
      wanted_cells.emplace_back(id, read_cell(row));
    }
  }
  std::vector<std::pair<std::int64_t, Metric>> wanted_metrics;
  {
    Query row = database_->query(
        "SELECT id, name, kind, unit FROM metric WHERE name GLOB ? ORDER BY name, kind, unit");
    row.bind(metric_glob);
    while (row.step()) {
      const std::int64_t id = row.integer();
      wanted_metrics.emplace_back(id, read_metric(row));
    }
  }
  std::vector<Series> all;
  std::map<std::string, Versions> versions;  // by engine
  for (const auto& [cell_id, cell] : wanted_cells) {
    const auto [found, fresh] = versions.try_emplace(cell.engine);
    if (fresh) found->second = versions_of(*database_, cell.engine);
    for (const auto& [metric_id, metric] : wanted_metrics) {
      std::vector<Point> read = read_points(*database_, cell_id, metric_id, points, found->second);
      if (!read.empty()) all.push_back({series_id(cell, metric), cell, metric, std::move(read)});
    }
  }
  return all;
}

std::set<std::string> Store::asked(std::int64_t run) const {
  std::set<std::string> all;
  Query row = database_->query("SELECT asked FROM result WHERE run = ?");
  row.bind(run);
  while (row.step()) all.insert(row.text());
  return all;
}

std::string Store::stored_digest(std::int64_t run, const std::string& cell_hash) const {
  Query row = database_->query(
      "SELECT digest FROM result r JOIN cell c ON c.id = r.cell WHERE r.run = ? AND c.hash = ?");
  return row.bind(run, cell_hash).step() ? row.text() : "";
}

std::vector<Anchor> Store::anchors() const {
  std::vector<Anchor> all;
  Query row = database_->query("SELECT name, \"binary\", build, date, note, run FROM anchor ORDER BY name");
  while (row.step()) {
    Anchor a;
    for (std::string* text : {&a.name, &a.binary, &a.build, &a.date, &a.note, &a.run}) *text = row.text();
    all.push_back(std::move(a));
  }
  return all;
}

std::vector<ChangePoint> Store::change_points() const {
  std::vector<ChangePoint> all;
  Query row = database_->query(
      "SELECT series, revision, state, date, note FROM change_point ORDER BY series, revision");
  while (row.step()) {
    ChangePoint p;
    for (std::string* text : {&p.series, &p.revision, &p.state, &p.date, &p.note}) *text = row.text();
    all.push_back(std::move(p));
  }
  return all;
}

}  // namespace cylon::store
