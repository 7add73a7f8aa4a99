#include "harness/validation/fit.h"

#include "harness/tracking/statistics/quantile.h"
#include "harness/validation/differences.h"

#include <nlopt.hpp>

#include <algorithm>
#include <cmath>
#include <exception>

namespace cylon::validation {
namespace {

using measured::Parameter;

double range(const Parameter& p) { return p.high - p.low; }

// The deviance as NLopt asks for it.
struct Objective {
  Likelihood& likelihood;
  const Memory& memory;
  int round = 0;
  std::size_t evaluations = 0;
  std::exception_ptr error = nullptr;  // NLopt forgets what was thrown through it

  double operator()(const std::vector<double>& values) {
    ++evaluations;
    if (memory.find)
      if (const auto known = memory.find(round, values)) return *known;
    const double deviance = likelihood.deviance(values);
    if (memory.found) memory.found({round, values, deviance});
    return deviance;
  }
};

double asked(const std::vector<double>& values, std::vector<double>&, void* objective) {
  auto& deviance = *static_cast<Objective*>(objective);
  try {
    return deviance(values);
  } catch (...) {
    deviance.error = std::current_exception();
    throw nlopt::forced_stop();
  }
}

double clamped(double value, const Parameter& p) { return std::clamp(value, p.low, p.high); }

// The least deviance from there on: a tenth of what changes it by 0.1, so that the rest is 0.03 of a standard error.
std::vector<double> least(Objective& objective, std::vector<double> from, const std::vector<double>& steps) {
  const std::vector<Parameter>& parameters = objective.likelihood.parameters();
  nlopt::opt search(parameters.size() > 1 ? nlopt::LN_BOBYQA : nlopt::LN_SBPLX,
                    static_cast<unsigned>(parameters.size()));
  std::vector<double> low, high, accuracy;
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    low.push_back(parameters[j].low), high.push_back(parameters[j].high);
    accuracy.push_back(1e-2 * steps[j]);
  }
  search.set_lower_bounds(low), search.set_upper_bounds(high);
  search.set_initial_step(steps);
  search.set_min_objective(asked, &objective);
  search.set_ftol_abs(1e-3);
  search.set_xtol_abs(accuracy);
  search.set_maxeval(200 * static_cast<int>(parameters.size()));
  // BOBYQA scales parameters by their steps and can leave a bound by rounding, and refuses to start there.
  const auto inside = [&](std::vector<double> values) {
    for (std::size_t j = 0; j < values.size(); ++j) values[j] = clamped(values[j], parameters[j]);
    return values;
  };
  from = inside(std::move(from));
  double deviance = 0;
  try {
    search.optimize(from, deviance);
  } catch (const nlopt::forced_stop&) {
    std::rethrow_exception(objective.error);
  } catch (const nlopt::roundoff_limited&) {
    // The region shrank to rounding: `from` is the best point so far.
  }
  return inside(std::move(from));
}

}  // namespace

Fit fit(Likelihood& likelihood, const Memory& memory) {
  const std::vector<Parameter>& parameters = likelihood.parameters();
  const std::size_t k = parameters.size(), before = likelihood.predictions();
  Objective objective{likelihood, memory};
  Fit made;
  std::vector<double> steps, lengths;
  for (const Parameter& p : parameters) {
    made.values.push_back(p.start);
    steps.push_back(0.2 * range(p)), lengths.push_back(0.02 * range(p));
  }
  while (!made.settled && made.rounds < most_rounds) {
    objective.round = ++made.rounds;
    likelihood.renew(made.values);
    const std::vector<double> last = made.values;
    made.values = least(objective, made.values, steps);
    const Differences found = differences(likelihood, made.values, lengths);
    lengths = found.lengths;
    made.known = known(found.score, parameters);
    std::vector<double> newton;
    for (std::size_t j = 0; j < k; ++j)
      newton.push_back(clamped(made.values[j] + made.known.newton[j], parameters[j]));
    const double there = objective(newton), here = objective(made.values);
    const bool taken = found.jumps || there < here;  // the least of jumps says nothing
    if (taken) made.values = newton;
    made.deviance = taken ? there : here;
    made.settled = made.rounds > 1;
    for (std::size_t j = 0; j < k; ++j) {
      const double error = std::isfinite(made.known.error[j]) ? made.known.error[j] : range(parameters[j]);
      const double scale = std::max(error, lengths[j]);  // below this the likelihood is not smooth
      made.settled = made.settled && std::abs(made.values[j] - last[j]) <= 0.1 * scale;
      steps[j] = std::clamp(2 * scale, 1e-4 * range(parameters[j]), 0.2 * range(parameters[j]));
    }
  }
  for (std::size_t j = 0; j < k; ++j)
    made.at_bound.push_back(
        std::min(made.values[j] - parameters[j].low, parameters[j].high - made.values[j]) <= lengths[j]);
  made.misfit = likelihood.misfit(made.values);
  made.runs = likelihood.runs().size(), made.windows = likelihood.windows(),
  made.numbers = likelihood.numbers();
  made.evaluations = objective.evaluations, made.predictions = likelihood.predictions() - before;
  return made;
}

double misfit_tail(const Fit& fit) {
  const auto freedom = static_cast<double>(fit.numbers) - static_cast<double>(fit.values.size());
  return statistics::chi_squared_tail(fit.misfit, freedom);
}

}  // namespace cylon::validation
