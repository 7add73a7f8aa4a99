// Every shipped scenario as a judge, by its own claims alone.
#pragma once

#include "harness/core/measure.h"
#include "harness/core/recording.h"
#include "harness/results/verdict.h"
#include "harness/scenario/scenario.h"
#include "tests/mutants/matrix/subject.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cylon::mutants {

/// All scenario files under scenarios/, in order of their names.
std::vector<std::filesystem::path> shipped_scenarios();

struct ShippedFinding {
  std::string claim;
  results::Status status = results::Status::pass;
  double measured = 0, allowed = 0;
};

/// What one simulator makes of a scenario at its nominal step.
struct ShippedRun {
  core::Recording recording;             ///< At the nominal step.
  std::vector<ShippedFinding> findings;  ///< One per claim.
  bool passes() const;
  /// Whether some claim finds it wrong.  One that cannot be answered finds nothing.
  bool accused() const;
};

/// Of what one run makes of a claim, as a cell of `cylon run` has it.
results::Status status_of(const core::Measured&);

/// Nothing where the simulator cannot express the scene.
std::optional<ShippedRun> run_shipped(const scenario::Scenario&, const Subject&);

/// A scenario file and what simulators make of it, for tests that share that in one process.
class ShippedFile {
 public:
  /// The one that was asked for last is kept.
  static ShippedFile& of(const std::filesystem::path&);

  const scenario::Scenario& scenario() const { return scenario_; }
  /// As run_shipped(), once for each name of a subject.
  const std::optional<ShippedRun>& run(const Subject&);

 private:
  explicit ShippedFile(const std::filesystem::path&);
  std::filesystem::path path_;
  scenario::Scenario scenario_;
  std::map<std::string, std::optional<ShippedRun>> runs_;
};

/// Whether some body is ever farther from its start than a tenth of its size, or turned from it by more than
/// 0.1 rad.
bool moves(const core::Scene&, const std::vector<core::State>&);

/// Whether two simulators ever put some body a tenth of its size, or 0.1 rad, apart.
bool moves_apart(const core::Scene&, const std::vector<core::State>&, const std::vector<core::State>&);

/// A scene of which no law says whether anything moves.
struct Undecided {
  const char* scenario;
  const char* reason;
};
const std::vector<Undecided>& undecided();

/// Whether the truths of the scenario, or the in-house engine's run, move; what is undecided does not.  Throws std::logic_error where there is
/// neither.
bool dynamic(const scenario::Scenario&, const std::optional<ShippedRun>& in_house);

}  // namespace cylon::mutants
