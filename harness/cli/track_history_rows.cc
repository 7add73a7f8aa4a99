#include "harness/cli/track_history_rows.h"

#include "harness/cli/track_history_changes.h"
#include "harness/core/fingerprint.h"
#include "harness/statistics/hodges_lehmann.h"
#include "scenarios/glob.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace cylon::cli {
namespace {

using store::Kind;
using store::Point;
using store::Series;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The times of a pinned binary: by scenario, its content, step and metric, then by run.
using AnchorKey = std::tuple<std::string, std::string, double, std::string>;
struct AnchorTimes {
  std::string name;
  std::map<std::int64_t, std::vector<double>> by_run;
};

AnchorKey key_of(const Series& s) {
  return {s.cell.scenario, s.cell.scenario_hash, s.cell.dt, s.metric.name};
}

std::map<AnchorKey, AnchorTimes> anchor_times(const std::vector<Series>& all,
                                              const std::set<std::string>& names) {
  std::map<AnchorKey, AnchorTimes> times;
  for (const Series& s : all) {
    if (s.metric.kind != Kind::time || !names.contains(s.cell.engine)) continue;
    AnchorTimes& anchor = times[key_of(s)];
    anchor.name = s.cell.engine;
    for (const Point& p : s.points) anchor.by_run[p.run] = p.values;
  }
  return times;
}

// Hodges-Lehmann over ln(value / reference); NaN where no pair is left.
double ratio_of(const std::vector<double>& values, const std::vector<double>* references) {
  std::vector<double> d;
  for (std::size_t i = 0; i < values.size() && (!references || i < references->size()); ++i) {
    const double one = std::log(values[i]) - (references ? std::log((*references)[i]) : 0);
    if (std::isfinite(one)) d.push_back(one);
  }
  return std::exp(statistics::hodges_lehmann(d));
}

HistoryRow row_of(const Series& series, const AnchorTimes* anchor) {
  HistoryRow row{series.id, series.cell, series.metric, Scale::value, "", {}, {}, {}};
  if (series.metric.kind == Kind::time) {
    const bool ratio = anchor != nullptr || series.metric.unit == "ratio";
    row.scale = ratio ? Scale::ratio : Scale::absolute;
    if (anchor) row.anchor = anchor->name;
  }
  for (const Point& p : series.points) {
    HistoryPoint point{p.run, p.revision, p.date, p.engine_version, nan, p.text};
    if (!p.text.empty()) {
      row.scale = Scale::text;
    } else if (row.scale == Scale::ratio) {
      const auto found = anchor ? anchor->by_run.find(p.run) : decltype(anchor->by_run.find(p.run)){};
      if (anchor && found == anchor->by_run.end()) continue;  // nothing to hold it against
      point.value = ratio_of(p.values, anchor ? &found->second : nullptr);
    } else if (row.scale == Scale::absolute) {
      const auto least = std::min_element(p.values.begin(), p.values.end());
      point.value = least == p.values.end() ? nan : *least;
    } else {
      point.value = p.values.empty() ? nan : p.values.front();
    }
    row.points.push_back(std::move(point));
  }
  for (std::size_t i = 1; i < row.points.size(); ++i) {
    const std::string &before = row.points[i - 1].version, &now = row.points[i].version;
    if (!before.empty() && !now.empty() && before != now) row.versions.push_back(i);
  }
  return row;
}

}  // namespace

std::string change_id(const std::string& series, const std::string& revision) {
  core::Fingerprint fingerprint;
  fingerprint.add(series);
  fingerprint.add("@");
  fingerprint.add(revision);
  return fingerprint.hex().substr(0, 8);
}

std::vector<HistoryRow> history_rows(const store::Store& store, const HistorySelection& wanted) {
  std::set<std::string> names;
  for (const store::Anchor& anchor : store.anchors()) names.insert(anchor.name);
  const std::vector<Series> all = store.series("*", "*");
  const auto anchors = anchor_times(all, names);
  const auto known = store.change_points();
  TruthErrors truth_errors(store);
  std::vector<HistoryRow> rows;
  for (const Series& series : all) {
    if (!scenarios::glob_match(wanted.scenario, series.cell.scenario) ||
        !scenarios::glob_match(wanted.engine, series.cell.engine) ||
        !scenarios::glob_match(wanted.metric, series.metric.name))
      continue;
    if (names.contains(series.cell.engine) && wanted.engine != series.cell.engine) continue;
    const auto anchor = anchors.find(key_of(series));
    const bool against = anchor != anchors.end() && anchor->second.name != series.cell.engine &&
                         series.metric.kind == Kind::time;
    HistoryRow row = row_of(series, against ? &anchor->second : nullptr);
    if (row.points.empty()) row = row_of(series, nullptr);  // the anchor was pinned for other runs
    row.changes = changes_of(row, truth_errors.of(row));
    add_known(row, known);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace cylon::cli
