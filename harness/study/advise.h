// The cheapest setting of each engine that meets a tolerance: found along the integrator's order, and run
// from starts that had no part in the search.
#pragma once

#include "harness/results/advice.h"
#include "harness/study/starts.h"
#include "harness/study/sweep.h"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace cylon::study {

/// A pick must be so much better than asked for: starts that nobody has tried differ a little.
inline constexpr double margin = 1.15;

struct AdviseOptions {
  double tolerance = 1e-3;      ///< Relative, of the measure, > 0.
  double budget = 0;            ///< CPU seconds per simulated second; 0: none.
  std::int64_t most = 1 << 20;  ///< Bodies times steps that one run may take.
  int workers = 1;              ///< Searches at one time.
  int rounds = 3;               ///< Of timing.
  process::Limits limits;
};

/// Parts by which the starts of a check differ from the nominal one.
std::span<const double> check_variations();

/// The times at which a search looks: as few as 64, for up to 256 times the nominal step; never more than the
/// sweep's ladder has.
std::int64_t search_samples(const scenario::Scenario&);

/// The steps that a search chooses among: multiples of `samples`, each about 2^(1/per_octave) of the one
/// before, up to `most`.
std::vector<std::int64_t> fine_steps(std::int64_t samples, std::int64_t most, int per_octave = 4);

/// An advice for each row of engines among the settings, in their order.  `starts`, not empty: the first is
/// searched on; a pick must meet the tolerance with the margin on all.  `done` is called after each
/// search, one at a time.  Throws core::InputError for a setting that was asked for and is impossible,
/// process::Interrupted.
std::vector<results::EngineAdvice> advise(const std::vector<Start>& starts,
                                          const std::vector<Setting>& settings, const AdviseOptions&,
                                          const std::function<void(const Setting&)>& done);

/// The cheapest first; of those whose costs are within 5 % of the least, as two timings of one setting differ by so much, the one
/// first that needs the fewest options: what gains nothing is not advised.
void put_cheapest_first(std::vector<results::Pick>&);

/// A pick as a setting to run.
Setting setting_of(const results::Pick&, const std::vector<Setting>& settings);

/// The error of a pick from one start; NaN where the run fails.
double error_from(const Start&, const Setting&, std::int64_t steps, double tolerance, const process::Limits&);

/// The costs of picks, measured in turns: round r of each before round r + 1.  Returns why a pick has none, by pick.
std::map<const results::Pick*, std::string> time_picks(const std::vector<results::Pick*>&, const core::Scene&,
                                                       const std::vector<Setting>&, double duration,
                                                       int rounds, const process::Limits&);

}  // namespace cylon::study
