// What came of comparing two builds of an engine, cell by cell.  Plain values: a report is rebuilt from them.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::results {

enum class Finding {
  regressed,     ///< Slower or less accurate by more than the rule allows, confirmed; or it no longer runs.
  inconclusive,  ///< The times do not decide, after all the pairs that were allowed.
  improved,
  changed,  ///< Other results, neither better nor worse by the rules.
  same,
  skipped,  ///< Nothing to compare; `reason` says why.
};

/// Why a cell was skipped, as far as it matters to a gate.
enum class Skip {
  none,
  identical,    ///< Both builds are the same file: nothing can have changed, as good as compared.
  unsupported,  ///< By the engine, in both builds.
  missing,      ///< One side has no such cell, or it runs to the end on neither side.
};

/// "regressed", "inconclusive", "improved", "changed", "same", "skipped".
std::string_view name(Finding);

/// One number of both builds that repeats bit for bit, and what its rule says.
struct ComparedMetric {
  std::string name;  ///< "error of position", "state hash", "instructions per step"
  Finding finding = Finding::same;
  std::string sentence;  ///< What moved from where to where.
};

/// Times as the paired rule sees them.  Ratios are candidate / baseline: above 1 is slower.
struct ComparedTime {
  Finding finding = Finding::inconclusive;
  double ratio = std::numeric_limits<double>::quiet_NaN();
  double low = 0, high = std::numeric_limits<double>::infinity();  ///< Interval of the ratio.
  double confidence = 0;                                           ///< Of the interval.
  int pairs = 0;                                                   ///< Fresh processes of each build.
  double p = 1;         ///< That it is not slower by more than the threshold, and the wrong way round.
  double adjusted = 1;  ///< By Holm, over all cells of the gate; p where there is no gate.
  double baseline_seconds = 0,
         candidate_seconds = 0;  ///< Medians of the samples, a run of the cell each [s].
  std::string what;              ///< "5000 steps, 8 times 3 runs a process"
};

struct Comparison {
  std::string scenario, scenario_hash, engine, dt_text;
  double dt = 0;  ///< [s]
  Finding finding = Finding::same;
  Skip skip = Skip::none;
  std::string reason;  ///< Why it was skipped, or why it counts as regressed without a number.
  std::optional<ComparedTime> time;
  std::string untimed;  ///< Why there is no time where the cell was compared.
  std::vector<ComparedMetric> metrics;
  std::string reproduce;  ///< The command that compares this cell again.

  std::string cell() const { return scenario + "/" + engine + "@" + dt_text; }
};

struct ComparisonReport {
  std::string baseline, candidate;  ///< As the user named them, with what they turned out to be.
  double tau = 0, alpha = 0;        ///< Ratios within 1 + tau are the same; risk of a wrong decision.
  bool gate = false;                ///< Holm over all cells.
  std::vector<std::string> notes;   ///< How it was measured: pinning, counter of instructions.
  /// The baseline against itself, beside the first cell; absent where nothing was timed.
  std::optional<ComparedTime> self_check;
  bool reliable = true;  ///< False: the baseline seems to differ from itself, so that no time is believed.
  bool interrupted = false;  ///< Cells that were not reached are skipped, or have no time.
  std::vector<Comparison> cells;
};

/// The worst that any metric or the time of a cell says.
Finding worst_finding(const Comparison&);

}  // namespace cylon::results
