// What a run could not keep, or did in another way than was asked: typed, per island.  The table below is the one
// place that has the words.
#pragma once

#include "engine/resolution.h"
#include "engine/vector.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::engine {

enum class DiagnosticKind {
  forced,
  deep_overlap,
  jointed_overlap,
  not_divided,
  merged,
  parted,
  not_followed,
  handed_over,
  path_not_taken,
  tolerance_not_kept,
  error_not_controlled,
  tolerance_missed,
  last_not_compared,
  tolerance_unknown,
  rounding_exceeds,
  integration_ended,
  switches_not_located,
  series_not_ended,
  drift_open,
  joints_open,
  contacts_open,
  forces_inexact,
  loads_undecided,
  impacts_inexact,
  interval_missed,
  meeting_not_searched,
  changes_not_searched,
  impacts_ordered,
  impacts_unending,
  frictionless,
  wedged,
  crawled,
  slip_turned_late,
  plastic,
  not_located,
  too_fast,
  contacts_unsolved,
  contacts_swept,
  overlaps_unsolved,
  joints_drifted,
  joint_forces_implicit,
  gimbal_passed,
  gimbal_parallel,
  stiff,
  unstable,
  solved_at_once,
  solved_in_turn,
  blows_swept,
  approaching,
  facets_unsettled,
  points_left_out,
  more,
  count
};

/// The part of a scene that a diagnostic is about, and how it moves.
struct IslandName {
  std::vector<int> bodies;  ///< Those that can move, of the whole model; the first most_named.
  std::size_t count = 0;    ///< How many can.
  bool whole = true;        ///< No other body can move.
  std::string method;       ///< "events by dop853".
  int order = 0;            ///< Of the method; 0: closed form.

  static constexpr std::size_t most_named = 6;
};

struct Diagnostic {
  DiagnosticKind kind = DiagnosticKind::count;
  Time since = 0;                      ///< When it was first so [s].
  std::int64_t count = 1;              ///< How often, in what the sentence counts.
  std::optional<double> limit = {};    ///< What was asked for, or the cap that was hit; unit: the kind's.
  std::optional<double> reached = {};  ///< The worst that came of it; unit: the kind's.  Infinite: no number.
  std::string cause = {};              ///< In words, where the kind has one.
  std::optional<Time> until = {};      ///< When the island came to an end that it was of [s].
  IslandName island = {};
};

/// What the words say of a kind.  In `text` {since}, {count}, {limit}, {reached} and {cause} are replaced.
struct DiagnosticRow {
  DiagnosticKind kind;
  std::string_view name;        ///< In protocol, verdicts and reports.
  std::string_view limit_unit;  ///< "1": a pure number.
  std::string_view unit;        ///< Of what was reached.
  std::string_view text;
};

extern const std::array<DiagnosticRow, static_cast<std::size_t>(DiagnosticKind::count)> diagnostic_rows;

inline const DiagnosticRow& row(DiagnosticKind kind) {
  return diagnostic_rows[static_cast<std::size_t>(kind)];
}

/// "'a', 'b' and 3 more".
std::string names_of(const IslandName&, const Names&);

/// One sentence, with the names of the bodies where others move too.
std::string sentence(const Diagnostic&, const Names& = numbered);
std::vector<std::string> sentences(const std::vector<Diagnostic>&, const Names& = numbered);

/// What a stepper has noted so far: one entry for each kind.
class DiagnosticLog {
 public:
  /// Once more.  The first sets the time, the worst of all what was reached; the last the limit and the cause.
  void note(DiagnosticKind, Time now, std::optional<double> limit = {}, std::optional<double> reached = {},
            const std::string& cause = {});
  /// All that another has counted of it.
  void take(const Diagnostic&);
  bool has(DiagnosticKind) const;

  /// In the order of the kinds.
  std::vector<Diagnostic> all() const;

 private:
  std::vector<Diagnostic> noted_;
};

/// Whether both say the same of the same bodies, at other times or of other size.
bool same_matter(const Diagnostic&, const Diagnostic&);

/// Adds one to another of the same matter.
void add(const Diagnostic& more, Diagnostic& to);

}  // namespace cylon::engine
