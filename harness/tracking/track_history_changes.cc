#include "harness/tracking/track_history_changes.h"

#include "harness/tracking/statistics/change_points.h"
#include "harness/tracking/statistics/metric_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::tracking {

namespace {

using statistics::MetricKind;
using statistics::Outcome;

double percent(double log_ratio) { return 100 * std::expm1(log_ratio); }

// Levels of ratios or sizes: noise is expected, so E-divisive decides.
std::vector<HistoryChange> level_changes(const HistoryRow& row, const statistics::ChangePointRule& rule,
                                         const char* worse, const char* better) {
  std::vector<std::size_t> at;  // of the finite ones
  std::vector<double> logs;
  for (std::size_t i = 0; i < row.points.size(); ++i) {
    const double log = std::log(row.points[i].value);
    if (std::isfinite(log)) at.push_back(i), logs.push_back(log);
  }
  std::vector<HistoryChange> changes;
  for (const statistics::ChangePoint& found : statistics::change_points(logs, rule)) {
    const bool up = found.magnitude > 0;
    HistoryChange change;
    change.index = at[found.index];
    change.outcome = up ? Outcome::regressed : Outcome::improved;
    change.ratio = std::exp(found.magnitude);
    change.interval = {std::exp(found.interval.low), std::exp(found.interval.high)};
    change.p = found.p;
    change.sentence = fmt::format("{} by {:.1f} %, 99 % within {:+.1f} … {:+.1f} %", up ? worse : better,
                                  std::abs(percent(found.magnitude)), percent(found.interval.low),
                                  percent(found.interval.high));
    changes.push_back(std::move(change));
  }
  return changes;
}

MetricKind kind_of(const store::Metric& metric) {
  if (metric.kind == store::Kind::exact) return MetricKind::exact;
  return metric.name.starts_with("order") ? MetricKind::order : MetricKind::error;
}

// Deterministic values: each is held against the first of its level, so that small steps add up.
std::vector<HistoryChange> exact_changes(const HistoryRow& row, double floor) {
  std::vector<HistoryChange> changes;
  for (std::size_t level = 0, i = 1; i < row.points.size(); ++i) {
    const HistoryPoint &before = row.points[level], &now = row.points[i];
    statistics::MetricResult said =
        row.scale == Scale::text ? statistics::judge_hash(before.text, now.text)
                                 : statistics::judge(kind_of(row.metric), before.value, now.value, floor);
    if (said.outcome == Outcome::same) continue;
    HistoryChange change;
    change.index = level = i;
    change.outcome = said.outcome;
    change.sentence = std::move(said.sentence);
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace

double TruthErrors::of(const HistoryRow& row) {
  constexpr std::string_view prefix = "error:";
  if (row.metric.kind != store::Kind::error || !row.metric.name.starts_with(prefix) || row.points.empty())
    return 0;
  const std::int64_t run = row.points.back().run;
  if (!results_.contains(run)) results_[run] = store_.results(run);
  for (const store::Result& result : results_[run])
    if (result.cell.hash == row.cell.hash)
      for (const store::Judgement& judgement : result.judgements)
        if (judgement.claim == row.metric.name.substr(prefix.size())) return judgement.truth_error;
  return 0;
}

std::vector<HistoryChange> changes_of(const HistoryRow& row, double truth_error) {
  std::vector<HistoryChange> changes;
  if (row.scale == Scale::ratio)
    changes = level_changes(row, {}, "slower", "faster");
  else if (row.metric.kind == store::Kind::size)
    changes = level_changes(row, {.min_magnitude = 0.01}, "larger", "smaller");
  else if (row.metric.kind == store::Kind::exact || row.metric.kind == store::Kind::error)
    changes = exact_changes(row, truth_error);
  for (HistoryChange& change : changes) {
    const HistoryPoint &before = row.points[change.index - 1], &now = row.points[change.index];
    change.id = change_id(row.series, now.revision);
    const bool other =
        std::find(row.versions.begin(), row.versions.end(), change.index) != row.versions.end();
    if (other)
      change.sentence += fmt::format("; engine version {} -> {}", before.version, now.version);
    else if (before.revision == now.revision)
      change.sentence += "; between runs of one revision";
  }
  return changes;
}

void add_known(HistoryRow& row, const std::vector<store::ChangePoint>& known) {
  for (const store::ChangePoint& kept : known) {
    if (kept.series != row.series) continue;
    const auto at = [&](const HistoryChange& c) { return row.points[c.index].revision == kept.revision; };
    auto change = std::find_if(row.changes.begin(), row.changes.end(), at);
    if (change == row.changes.end()) {
      const auto point = std::find_if(row.points.begin(), row.points.end(),
                                      [&](const HistoryPoint& p) { return p.revision == kept.revision; });
      if (point == row.points.end()) continue;
      HistoryChange gone;
      gone.id = change_id(row.series, kept.revision);
      gone.index = static_cast<std::size_t>(point - row.points.begin());
      gone.sentence = "no longer seen";
      gone.found = false;
      change = row.changes.insert(std::find_if(row.changes.begin(), row.changes.end(),
                                               [&](const auto& c) { return c.index > gone.index; }),
                                  gone);
    }
    change->state = kept.state;
    change->note = kept.note;
  }
}

}  // namespace cylon::tracking
