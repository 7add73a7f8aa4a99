// The history of every series: ratios to the anchor, values, and where they changed.  Knows no terminal.
#pragma once

#include "harness/tracking/statistics/outcome.h"
#include "harness/tracking/store/store.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::tracking {

/// Globs; a series is wanted where all three match.
struct HistorySelection {
  std::string scenario = "*", engine = "*", metric = "*";
};

struct HistoryPoint {
  std::int64_t run = 0;
  std::string revision, date, version;  ///< The version of the engine that ran.
  double value;                         ///< A ratio, or the metric's own value; NaN: not finite, or a text.
  std::string text;                     ///< Of a metric whose values are texts.
};

/// A place where a series changed its level, and what is known of it.
struct HistoryChange {
  std::string id;         ///< 8 hex digits of series and revision: the same in every store.
  std::size_t index = 0;  ///< Of the first point at the new level.
  statistics::Outcome outcome = statistics::Outcome::changed;
  /// Of a level of several values: the ratio after / before, its 99 % interval, and the p value.
  std::optional<double> ratio;
  statistics::Interval interval;
  double p = 0;
  std::string sentence;            ///< "slower by 5.1 %, 99 % within 4.6 … 5.7 %".
  std::string state = "detected";  ///< "detected", "active", "ignored", "fixed".
  std::string note;
  bool found = true;  ///< False: somebody acknowledged it, and the series no longer shows it.
};

/// How the numbers of a row are to be read.
enum class Scale {
  ratio,     ///< Time over that of a pinned binary, side by side: what change points are sought in.
  absolute,  ///< Time alone: shown, not judged, as the machine's own speed changes.
  value,     ///< Deterministic numbers: errors, counts, sizes.
  text,      ///< Hashes.
};

struct HistoryRow {
  std::string series;  ///< store::Series::id
  store::Cell cell;
  store::Metric metric;
  Scale scale = Scale::value;
  std::vector<HistoryPoint> points;
  std::vector<HistoryChange> changes;  ///< By index.
  std::vector<std::size_t> versions;   ///< Points whose engine is of another version than the point before.
};

/// The rows that are wanted, by cell name; of a cell ratios first, then times, errors, and the rest by name.
///
/// A time is a ratio where the metric's unit is "ratio" or its name begins with "cpu_ratio:": a value per pair of processes, of which the run's is
/// the Hodges-Lehmann estimate; of absolute times it is the least.  Change points are sought in ratios and in
/// sizes (statistics/change_points.h); errors are held against the level before by the rule of their kind,
/// down to the truth's own error; counts and hashes are equal or not.
std::vector<HistoryRow> history_rows(const store::Store&, const HistorySelection& = {});

/// The id of a change at a revision.
std::string change_id(const std::string& series, const std::string& revision);

}  // namespace cylon::tracking
