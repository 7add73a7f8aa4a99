// expected.toml and the rows measured from it: which verdicts are known not to be a pass, by cause.
#pragma once

#include "harness/results/verdict.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace cylon::scenario {

/// What is expected of one claim of one cell.
struct Expected {
  results::Status status = results::Status::pass;
  std::optional<double> size;  ///< What was measured, in the observable's unit; absent: the status says all.
  double within = 1;           ///< Factor by which another measurement may differ from `size`.
  std::string reason;          ///< "cause: mechanism"; empty where a pass is expected.
};

/// Cells that a cause explains: globs, joined by ':'.
struct Symptoms {
  std::string engine, scenario, claim;
};

/// A run with the cause, and one without or with less of it.  What of the second run must hold is a status,
/// or that its error is `low` to `high` times that of the first.
struct Counterfactual {
  std::string scenario, claim, engine, dt;                          ///< A glob for one claim.
  std::string other_scenario, other_claim, other_engine, other_dt;  ///< dt empty: the scenario's own.
  std::optional<results::Status> becomes;
  double low = 0, high = 0;
  std::string place;  ///< "expected.toml:12"
};

/// What speaks against a counterfactual, in words; empty: it holds.  The first run must show the symptom, that
/// is, be no pass, and what comes of the change must be as said.
std::string refutation(const Counterfactual&, const results::Verdict& first, const results::Verdict& other);

/// Why some verdicts are not a pass.
struct Cause {
  std::string name, mechanism, law;
  std::vector<std::string> source;  ///< "bullet: src/…/file.cpp:12 function"
  std::optional<double> power;      ///< Of the step, in the law.
  double within = 1;                ///< A factor, >= 1.
  std::vector<Symptoms> explains;
  std::vector<Counterfactual> counterfactuals;
};

/// The causes of expected.toml, and what was measured in each cell that they explain.
class Expectations {
 public:
  /// A verdict that is not a pass, as measured.  Exact names and no globs.
  struct Row {
    std::string scenario, engine, claim;
    double dt = 0;  ///< [s]
    std::string cause;
    results::Status status = results::Status::fail;
    std::optional<double> size;
  };

  /// No rows: every verdict is expected to pass.
  Expectations() = default;

  /// Reads expected.toml and, beside it, data/expected_rows.toml.  Throws core::InputError for unknown keys
  /// and statuses, for a cause without source or counterfactual, and for a row that its cause does not explain.
  static Expectations load(const std::filesystem::path&);
  static Expectations parse(std::string_view causes, const std::string& causes_name, std::string_view rows,
                            const std::string& rows_name);

  /// What is expected of a claim; a pass where no row has these names and this step.  `dt` in [s].
  Expected find(std::string_view scenario, std::string_view engine, double dt, std::string_view claim) const;

  const std::vector<Cause>& causes() const { return causes_; }
  const std::vector<Row>& rows() const { return rows_; }

  /// The first cause that explains the cell; nullptr: none.
  const Cause* explain(std::string_view scenario, std::string_view engine, std::string_view claim) const;

  /// "late_impact: engine 'ode', scenario '*', claim 'energy*'" for all that a cause claims to explain and
  /// no row has.
  std::vector<std::string> unused() const;

  /// Whether the [versions] table knows this version of the engine; variants ("ode/erp=0") count as their
  /// engine.
  bool version_listed(std::string_view engine, std::string_view version) const;

  /// Of the content, as 16 hex digits; empty without a file.
  const std::string& hash() const { return hash_; }

 private:
  std::vector<Cause> causes_;
  std::vector<Row> rows_;
  std::map<std::tuple<std::string, std::string, std::string>, std::vector<std::size_t>> rows_of_;
  std::string hash_;
  std::map<std::string, std::vector<std::string>> versions_;
};

}  // namespace cylon::scenario
