// What the history store keeps: plain values, and the hashes by which runs and cells are known again in any
// store.  Knows no SQL and no simulator.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::store {

/// How a metric is judged.  exact: equal or not (state hash, instruction count); error: deterministic, less
/// is better; time: noisy, less is better; size: less is better; info: stored and shown, never judged.
enum class Kind { exact, error, time, size, info };

/// "exact", "error", "time", "size", "info".
std::string_view name(Kind);
std::optional<Kind> kind_from(std::string_view);

/// One recording: who measured, where, of which revision, and what was asked for.
struct RunInfo {
  std::int64_t id = 0;  ///< Of this store alone; ascending in the order of recording.
  std::string uid;      ///< 16 hex digits, the same in every store; given by the store.
  std::string label;
  std::string revision;  ///< Of what is under test: a git revision, a version.
  /// The place of the revision in the history, ascending.  As given to begin_run; absent there: that of the
  /// same revision where the store has it, else one more than the store's highest.
  std::optional<std::int64_t> revision_order;
  std::string date;  ///< ISO 8601, given by the caller.
  std::string machine, os, compiler, flags;
  std::string build;         ///< Hash of the binaries that ran.
  std::string command_line;  ///< As typed.
  std::string request;       ///< What was asked for, so that an interrupted recording can go on.
  std::string note;
  bool complete = false;  ///< False: it is going on, or was interrupted.
};

/// What was run: the key of every series.  Two cells are one exactly when all fields but `dt_text` agree.
struct Cell {
  std::string hash;  ///< cell_hash() of the others; given by the store.
  std::string scenario, scenario_hash;
  std::string engine;  ///< The id with its variant: "bullet/gyro=none"; for a benchmark its program.
  std::string path, integrator, precision, settings;  ///< Empty where the engine did not get that far.
  double dt = 0;                                      ///< [s]; 0: none.
  std::string dt_text;                                ///< As given: "1/60".

  /// "scenario/engine@dt", or "scenario/engine" without a step: what globs are matched with.
  std::string name() const;
};

struct Metric {
  std::string name;
  Kind kind = Kind::info;
  std::string unit;

  bool operator==(const Metric&) const = default;
};

/// One measured value of one repetition: a number or a text.  A number that is not finite is absent.
struct Sample {
  Metric metric;
  std::int64_t repetition = 0;
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string text;
};

/// One claim as it was judged.
struct Judgement {
  std::string claim, observable, unit;
  std::string status, expected;  ///< As core::name(Status) writes them.
  double measured = std::numeric_limits<double>::quiet_NaN();
  double allowed = 0, truth_error = 0;
  std::string detail;  ///< Why it is not a pass; "" where nothing is to be said.
};

/// All that one run has of one cell; stored whole or not at all.
struct Result {
  Cell cell;
  std::string engine_version;
  std::string asked;  ///< Key of the question, by which a recording that goes on knows that it is answered.
  std::vector<Sample> samples;
  std::vector<Judgement> judgements;
};

/// What one run says of a series.
struct Point {
  std::int64_t run = 0;
  std::string revision;
  std::int64_t revision_order = 0;
  std::string label, date, machine, build;
  std::string engine_version;
  std::vector<double> values;  ///< One per repetition, in their order; NaN where it was not finite.
  std::string text;            ///< Of a metric whose values are texts.
};

/// One metric of one cell through the history.
struct Series {
  std::string id;  ///< series_id(): what change points are kept under.
  Cell cell;
  Metric metric;
  std::vector<Point> points;  ///< In the order of revisions, then of recording.
};

/// A binary (and the run that recorded it, where there is one) that others are compared with by name.
struct Anchor {
  std::string name;
  std::string binary;  ///< "NAME=COMMAND", "--sandbox NAME=COMMAND" where it was pinned under --sandbox.
  std::string build, date, note;
  std::string run;  ///< uid; "": none.
};

/// What is known of a step in a series.
struct ChangePoint {
  std::string series;    ///< Series::id
  std::string revision;  ///< The first on the new level.
  std::string state;     ///< "detected", "active", "ignored" or "fixed".
  std::string date, note;
};

/// Of all fields that tell one cell from another, 16 hex digits.
std::string cell_hash(const Cell&);

/// Of all that was given at the start of the run, and `ordinal` where the store has the same ones already.
std::string run_uid(const RunInfo&, std::int64_t ordinal);

/// "<cell hash>/<metric>".
std::string series_id(const Cell&, const Metric&);

/// Every value of it in one text, two of which are equal exactly when the values are: of a result in any
/// order of its samples and judgements; of a run all but its id and whether it is complete.
std::string content_of(const Result&);
std::string content_of(const RunInfo&);
std::string content_of(const Anchor&);
std::string content_of(const ChangePoint&);

/// Of a result's every value, in any order of its samples and judgements.
std::string digest(const Result&);
/// Of all fields; of a run all but its id and whether it is complete.
std::string digest(const RunInfo&);
std::string digest(const Anchor&);
std::string digest(const ChangePoint&);

/// The first metric or claim that a result has twice, "" where none.
std::string twice(const Result&);

/// The result as it is stored: its cell hashed; samples by metric and repetition, judgements by claim;
/// numbers that are not finite NaN, and no minus zero; characters that are no printable UTF-8 escaped.
Result canonical(Result);

/// The text with all but printable UTF-8 escaped.
std::string clean(std::string_view);

}  // namespace cylon::store
