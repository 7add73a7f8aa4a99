#include "harness/tracking/track_history_rows.h"

#include "harness/core/content_hash.h"
#include "harness/scenario/glob.h"
#include "harness/tracking/statistics/hodges_lehmann.h"
#include "harness/tracking/track_history_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace cylon::tracking {

namespace {

using store::Kind;
using store::Point;
using store::Series;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Hodges-Lehmann over the logarithms of those that have one.
double ratio_of(const std::vector<double>& ratios) {
  std::vector<double> logs;
  for (const double ratio : ratios)
    if (const double log = std::log(ratio); std::isfinite(log)) logs.push_back(log);
  return std::exp(statistics::hodges_lehmann(logs));
}

double least_of(const std::vector<double>& values) {
  double least = nan;
  for (const double value : values) least = std::fmin(least, value);
  return least;
}

Scale scale_of(const Series& series) {
  // The six columns that an imported CSV needs leave the unit out.
  if (series.metric.kind == Kind::time)
    return series.metric.unit == "ratio" || series.metric.name.starts_with("cpu_ratio:") ? Scale::ratio
                                                                                         : Scale::absolute;
  const auto is_text = [](const Point& p) { return !p.text.empty(); };
  return std::any_of(series.points.begin(), series.points.end(), is_text) ? Scale::text : Scale::value;
}

HistoryRow row_of(const Series& series) {
  HistoryRow row{series.id, series.cell, series.metric, scale_of(series), {}, {}, {}};
  for (const Point& p : series.points) {
    const double value = row.scale == Scale::ratio      ? ratio_of(p.values)
                         : row.scale == Scale::absolute ? least_of(p.values)
                         : p.values.empty()             ? nan
                                                        : p.values.front();
    row.points.push_back({p.run, p.revision, p.date, p.engine_version, value, p.text});
  }
  for (std::size_t i = 1; i < row.points.size(); ++i) {
    const std::string &before = row.points[i - 1].version, &now = row.points[i].version;
    if (!before.empty() && !now.empty() && before != now) row.versions.push_back(i);
  }
  return row;
}

}  // namespace

std::string change_id(const std::string& series, const std::string& revision) {
  core::ContentHash content;
  for (const std::string_view part :
       {std::string_view(revision), std::string_view("@"), std::string_view(series)})
    content.add(part);  // the longer one last, which mixes revisions that differ in a digit
  return content.hex().substr(0, 8);
}

std::vector<HistoryRow> history_rows(const store::Store& store, const HistorySelection& wanted) {
  const auto known = store.change_points();
  TruthErrors truth_errors(store);
  std::vector<HistoryRow> rows;
  const bool narrow = (wanted.scenario + wanted.engine + wanted.metric).find('[') == std::string::npos;
  const std::string cells = narrow ? wanted.scenario + "/" + wanted.engine + "*" : "*";  // GLOB knows sets
  for (const Series& series : store.series(cells, narrow ? wanted.metric : "*")) {
    if (!scenario::glob_match(wanted.scenario, series.cell.scenario) ||
        !scenario::glob_match(wanted.engine, series.cell.engine) ||
        !scenario::glob_match(wanted.metric, series.metric.name))
      continue;
    HistoryRow row = row_of(series);
    row.changes = changes_of(row, truth_errors.of(row));
    add_known(row, known);
    rows.push_back(std::move(row));
  }
  std::stable_sort(rows.begin(), rows.end(), [](const HistoryRow& a, const HistoryRow& b) {
    const auto key = [](const HistoryRow& r) {
      return std::tuple(r.cell.name(), r.cell.hash, r.scale != Scale::ratio, r.metric.kind != Kind::time,
                        r.metric.kind != Kind::error, r.metric.name);
    };
    return key(a) < key(b);
  });
  return rows;
}

}  // namespace cylon::tracking
