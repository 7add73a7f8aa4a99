#include "harness/cli/commands/fit_report.h"

#include "harness/cli/commands/estimates.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace cylon::cli {
namespace {

using nlohmann::ordered_json;
using validation::Combination, validation::Fit, validation::interval;

std::string range(const statistics::Interval& i) {
  return std::isfinite(i.low) ? fmt::format("[{:.5g}, {:.5g}]", i.low, i.high) : "not known";
}

std::string told(const Combination& c, const std::vector<measured::Parameter>& parameters) {
  std::string sum;
  for (std::size_t j = 0; j < parameters.size(); ++j)
    if (std::abs(c.weights[j]) > 0.1)
      sum += fmt::format("{}{:.2f} {}",
                         sum.empty()        ? ""
                         : c.weights[j] < 0 ? " - "
                                            : " + ",
                         sum.empty() ? c.weights[j] : std::abs(c.weights[j]), parameters[j].name);
  return sum;
}

ordered_json rows_of(const Eigen::MatrixXd& matrix) {
  ordered_json rows = ordered_json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    rows.push_back(numbers({matrix.row(i).begin(), matrix.row(i).end()}));
  return rows;
}

}  // namespace

std::string told(const FitRow& row, const std::vector<measured::Parameter>& parameters) {
  if (!row.failure.empty()) return fmt::format("{}\n  no fit: {}\n", row.engine, row.failure);
  const Fit& f = row.fit;
  std::string out = fmt::format("{}, on {} runs\n", row.engine, f.runs);
  for (std::size_t j = 0; j < parameters.size(); ++j)
    out += fmt::format("  {:<18} {:<10.5g} {:<24} {:<24}{}\n", parameters[j].name, f.values[j],
                       range(interval(f.values[j], f.known.error[j])),
                       range(interval(f.values[j], f.known.spread[j], f.known.freedom)),
                       f.at_bound[j] ? " at its bound" : "");
  for (const Combination& c : f.known.blind)
    out += fmt::format("  cannot be told apart: along {} the standard error is {:.2g} of the ranges\n",
                       told(c, parameters), c.error);
  out +=
      fmt::format("  misfit {:.6g} of {} numbers, {:.2f} each: {}\n", f.misfit, f.numbers,
                  f.misfit / static_cast<double>(f.numbers),
                  misfit_tail(f) < 0.05
                      ? fmt::format("the model and the stated uncertainties do not explain it (p = {:.2g})",
                                    misfit_tail(f))
                      : fmt::format("as the stated uncertainties say (p = {:.2g})", misfit_tail(f)));
  out += fmt::format(
      "  {} after {} rounds, {} evaluations, {} predictions of {} windows\n",
      f.settled ? "settled"
                : "NOT settled: the last round still moved a parameter by more than a tenth of its error,",
      f.rounds, f.evaluations, f.predictions, f.windows);
  if (row.left_over > 0)
    out += fmt::format("  {} frames at the ends of runs make no window\n", row.left_over);
  if (!row.judge_failure.empty()) out += fmt::format("  not judged: {}\n", row.judge_failure);
  return out;
}

ordered_json to_json(const FitRow& row, const std::vector<measured::Parameter>& parameters) {
  ordered_json j{{"engine", row.engine},
                 {"failure", row.failure},
                 {"fitted_on", row.fitted_on},
                 {"fitted_data", row.fitted_data},
                 {"judged_on", row.judged_on}};
  if (!row.failure.empty()) return j;
  const Fit& f = row.fit;
  ordered_json rows = ordered_json::array(), blind = ordered_json::array();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto stated = interval(f.values[i], f.known.error[i]),
               between = interval(f.values[i], f.known.spread[i], f.known.freedom);
    rows.push_back({{"name", parameters[i].name},
                    {"value", f.values[i]},
                    {"error", number(f.known.error[i])},
                    {"low", number(stated.low)},
                    {"high", number(stated.high)},
                    {"spread", number(f.known.spread[i])},
                    {"low_between_runs", number(between.low)},
                    {"high_between_runs", number(between.high)},
                    {"at_bound", static_cast<bool>(f.at_bound[i])}});
  }
  for (const Combination& c : f.known.blind)
    blind.push_back({{"weights", c.weights}, {"error", number(c.error)}});
  j["parameters"] = rows, j["cannot_be_told_apart"] = blind;
  j["covariance"] = rows_of(f.known.covariance);
  j["deviance"] = f.deviance, j["misfit"] = f.misfit, j["numbers"] = f.numbers,
  j["misfit_p"] = misfit_tail(f);
  j["windows"] = f.windows, j["rounds"] = f.rounds, j["settled"] = f.settled;
  j["evaluations"] = f.evaluations;
  j["frames_left_over"] = row.left_over;
  j["judged_deviances"] = numbers(row.deviances), j["judge_failure"] = row.judge_failure;
  return j;
}

std::string told(const Judged& all) {
  std::string out = fmt::format("{}, on runs that it was not fitted on\n", all.engine);
  std::vector<double> deviances;
  for (const double d : all.deviances)
    if (std::isfinite(d)) deviances.push_back(d);
  if (!deviances.empty())
    out += fmt::format("  -2 log L            {:.6g} a run ({} runs)\n", statistics::mean(deviances),
                       deviances.size());
  if (!all.horizon_before.empty())
    return out + "  before the fit\n" + told(validation::summary(all.horizon_before), 0) +
           "  after the fit\n" + told(validation::summary(all.horizon_after), 0);
  if (all.before.empty()) return out;
  out += "  before the fit\n" + told(validation::summary(all.before), 0);
  out += "  after the fit\n" + told(validation::summary(all.after), 0);
  return out;
}

ordered_json to_json(const Judged& all) {
  ordered_json j{{"engine", all.engine}, {"deviances", numbers(all.deviances)}};
  if (!all.horizon_before.empty())
    j["before"] = to_json(validation::summary(all.horizon_before)),
    j["after"] = to_json(validation::summary(all.horizon_after));
  if (all.before.empty()) return j;
  j["before"] = to_json(validation::summary(all.before)),
  j["after"] = to_json(validation::summary(all.after));
  return j;
}

std::vector<Likelier> likelier(const std::vector<Judged>& engines) {
  std::vector<std::vector<double>> deviances;
  for (const Judged& engine : engines) deviances.push_back(engine.deviances);
  std::vector<Likelier> all;
  if (engines.size() < 2) return all;
  const auto pairs = validation::better(deviances);
  for (std::size_t j = 0; j < pairs.size(); ++j)
    all.push_back({engines[0].engine, engines[j + 1].engine, pairs[j]});
  return all;
}

std::string told(const Likelier& pair) {
  const std::string answer = pair.by.answer == validation::Answer::inside    ? pair.one
                             : pair.by.answer == validation::Answer::outside ? pair.other
                                                                             : "undecided";
  return fmt::format("likelier: {} in {} runs, {} in {}: {} (p = {:.2g}, Holm)\n", pair.one, pair.by.one,
                     pair.other, pair.by.other, answer, pair.by.p);
}

ordered_json to_json(const Likelier& pair) {
  return {{"one", pair.one},
          {"other", pair.other},
          {"runs_of_one", pair.by.one},
          {"runs_of_other", pair.by.other},
          {"p", pair.by.p},
          {"likelier", pair.by.answer == validation::Answer::inside    ? pair.one
                       : pair.by.answer == validation::Answer::outside ? pair.other
                                                                       : "undecided"}};
}

}  // namespace cylon::cli
