// How far a run is from what is required, by every measure that a scenario has; the same times for any step.
// Reads recordings; knows no engine.
#pragma once

#include "harness/core/recording.h"
#include "harness/process/client.h"
#include "harness/results/trade.h"
#include "harness/scenario/scenario.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cylon::study {

/// States at k T/M, k = 0 … M, that stand in for a truth where a scenario has none.
struct Reference {
  std::string name;  ///< "in-house auto at 1e-11, uncertified"
  std::vector<core::State> states;
  double resolution = 0;  ///< Relative error that it may have.
};

/// The scenario's claims as relative errors: deviations from truths and from the start, and of events.  A
/// claim's tolerance plays no part.  Where the scenario claims nothing of energy or momenta, and the scene
/// shows by itself that they are kept, they are measured too.
class Yardstick {
 public:
  /// `samples` M >= 1: the times k T/M at which deviations are looked at.  Times of recorded truths must be
  /// among them.  `reference`: for a scenario whose claims follow nothing.
  Yardstick(const scenario::Scenario&, std::int64_t samples, const std::optional<Reference>& reference = {});

  const std::vector<results::TradeMeasure>& measures() const { return measures_; }
  /// The first measure of: trajectory, events, energy, whatever there is.  Requires measures() not empty.
  std::size_t principal() const { return principal_; }
  std::int64_t samples() const { return samples_; }
  const std::string& truth() const { return truth_; }

  /// The index of the measure of that name; throws core::InputError with the nearest.
  std::size_t find(const std::string& name) const;

  /// What a run of so many steps (a multiple of samples()) must record.
  process::RunRequest request(std::int64_t steps) const;

  /// By measure; NaN where a state is not finite.
  std::vector<double> errors(const core::Recording&) const;

 private:
  struct Question {
    core::Claim claim;
    std::size_t measure = 0;
    double scale = 1;
    bool in_trajectory = false;
    std::vector<std::int64_t> at;    ///< Samples that it looks at.
    std::vector<core::Values> want;  ///< One for each, or a single one: the start.
  };
  std::size_t measure_named(const std::string& name, const std::string& unit, const std::string& against);
  void ask(core::Claim, const std::vector<core::State>* states, double resolution);
  void ask_event(const core::Claim&);
  void choose_trajectory();
  double worst_deviation(const Question&, const core::Recording&) const;

  const scenario::Scenario* scenario_;
  std::int64_t samples_;
  std::vector<results::TradeMeasure> measures_;
  std::vector<Question> questions_;
  std::vector<core::Pair> watch_;
  std::string truth_;
  std::size_t principal_ = 0;
  bool every_step_ = false;
};

/// "energy", "linear_momentum", "angular_momentum": those that the scene alone shows to be constant.
std::vector<core::Quantity> conserved(const core::Scene&);

}  // namespace cylon::study
