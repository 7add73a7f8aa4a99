// expected.toml: which verdicts are known not to be a pass, and why.
#pragma once

#include "harness/results/verdict.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::scenario {

struct Expected {
  results::Status status = results::Status::pass;
  std::string reason;  ///< Empty where nothing is said.
  std::string link;
  std::string place;  ///< "expected.toml:12" of the row that decided; empty where none did.
};

/// The rows of expected.toml.  Of the rows that match a cell the last one wins: general rows first,
/// exceptions after.
class Expectations {
 public:
  /// No rows: every verdict is expected to pass.
  Expectations() = default;

  /// Throws core::InputError for unknown keys and statuses, and for rows without a reason.
  static Expectations load(const std::filesystem::path&);
  static Expectations parse(std::string_view text, const std::string& file_name);

  /// What is expected of a cell; pass where no row matches.  `dt` in [s].
  Expected find(std::string_view scenario, std::string_view engine, std::string_view integrator, double dt,
                std::string_view claim) const;

  /// Whether the [versions] table knows this version of the engine; variants ("ode/erp=0") count as their
  /// engine.
  bool version_listed(std::string_view engine, std::string_view version) const;

  /// "expected.toml:12: engine 'ode', scenario '*', claim 'energy*'" for each row whose place is not among
  /// `decided`.
  std::vector<std::string> unused(const std::set<std::string>& decided) const;

  /// Of the content, as 16 hex digits; empty without a file.
  const std::string& hash() const { return hash_; }

 private:
  struct Row {
    std::string engine, scenario, claim, integrator;
    std::vector<double> steps;  // [s]; empty: all
    Expected expected;
  };
  std::vector<Row> rows_;
  std::string hash_;
  std::map<std::string, std::vector<std::string>> versions_;
};

}  // namespace cylon::scenario
