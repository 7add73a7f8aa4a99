#include "harness/cli/commands/estimates.h"

#include "harness/core/input_error.h"
#include "harness/core/recording.h"
#include "harness/scenario/input.h"
#include "harness/validation/kinematics.h"
#include "harness/validation/split.h"
#include "harness/validation/touches.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cylon::cli {

using nlohmann::ordered_json;
using validation::Estimate, validation::RunScore, validation::Summary;

namespace {

constexpr double degrees = 180 / std::numbers::pi;

std::string told_band(const Estimate& covered, validation::Answer answer, int members) {
  if (members == 0) return "";
  const std::string judgement =
      validation::judged(members)
          ? fmt::format("90 to 98 %: {}", validation::name(answer))
          : fmt::format("not judged: 90 to 98 % is asked of {} members", validation::Band{}.members);
  return fmt::format("  inside the {:.3g} % band  {}; {}\n", 100 * validation::level(members),
                     shown(covered, 100, " %"), judgement);
}

std::string told_slope(const char* what, const Estimate& slope, const char* of) {
  if (!std::isfinite(slope.value)) return "";
  return fmt::format("  {:<22} {} of {}{}\n", what, shown(slope, 1, "", 3), of,
                     validation::goes_together(slope) == validation::Answer::outside
                         ? ": they do not go together; check columns, units, axes and rate"
                         : "");
}

}  // namespace

std::string told_kinematics(const measured::Experiment& e) {
  const validation::Kinematics of = validation::kinematics(e);
  const bool chain = e.coordinates == measured::Coordinates::chain;
  return "Columns against each other, steps from frame to frame over velocities, with 95 % intervals:\n" +
         told_slope("positions", of.velocity, "velocities") +
         told_slope(chain ? "angles" : "orientations", of.spin, chain ? "rates" : "angular velocities");
}

std::string told_touches(const measured::Experiment& e) {
  const auto counts = validation::touch_counts(e);
  if (counts.empty()) return "After no touch the body flies\n";
  std::string out = "Touches, and the energy lost in them:\n";
  for (std::size_t k = 0; k < counts.size(); ++k)
    out += fmt::format("  touch {:<16} {} of {} runs fly after it, and {} tell its loss\n", k + 1,
                       counts[k].flights, e.runs.size(), counts[k].known);
  return out;
}

ordered_json touches_json(const measured::Experiment& e) {
  ordered_json all = ordered_json::array();
  for (const auto& [flights, known] : validation::touch_counts(e))
    all.push_back({{"flights", flights}, {"known", known}});
  return all;
}

std::string shown(const Estimate& e, double scale, const char* unit, int digits) {
  if (!std::isfinite(e.value)) return "not known";
  const std::string value = fmt::format("{:.{}f}{}", e.value * scale, digits, unit);
  if (!std::isfinite(e.interval.low)) return value;
  return fmt::format("{} [{:.{}f}, {:.{}f}]", value, e.interval.low * scale, digits, e.interval.high * scale,
                     digits);
}

ordered_json number(double x) { return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr); }

ordered_json to_json(const Estimate& e) {
  return {{"value", number(e.value)},
          {"low", number(e.interval.low)},
          {"high", number(e.interval.high)},
          {"runs", e.runs}};
}

ordered_json numbers(const std::vector<double>& all) {
  ordered_json list = ordered_json::array();
  for (const double x : all) list.push_back(number(x));
  return list;
}

ordered_json to_json(const RunScore& r) {
  return {{"run", r.run},
          {"failure", r.failure},
          {"distance", number(r.distance)},
          {"angle", number(r.angle)},
          {"same_side", r.same_side},
          {"impact", number(r.impact)},
          {"place", number(r.place)},
          {"loss", number(r.loss)},
          {"touch_losses", numbers(r.touch_losses)},
          {"covered", number(r.covered)}};
}

ordered_json to_json(const Summary& s) {
  ordered_json touches = ordered_json::array();
  for (const Estimate& one : s.touch_losses) touches.push_back(to_json(one));
  return {{"runs", s.runs},
          {"failed", s.failed},
          {"first_failure", s.first_failure},
          {"distance", to_json(s.distance)},
          {"angle", to_json(s.angle)},
          {"same_side", to_json(s.same_side)},
          {"impact", to_json(s.impact)},
          {"place", to_json(s.place)},
          {"loss", to_json(s.loss)},
          {"touch_losses", touches},
          {"covered", to_json(s.covered)},
          {"band", validation::name(s.band)}};
}

std::string told(const Summary& s, int members) {
  std::string out;
  if (s.failed > 0)
    out += fmt::format("  failed              {} of {} runs: {}\n", s.failed, s.runs, s.first_failure);
  if (s.failed == s.runs) return out;
  out += fmt::format("  rest, distance      {}\n", shown(s.distance, 1000, " mm"));
  out += fmt::format("  rest, angle         {}\n", shown(s.angle, degrees, " deg"));
  out += fmt::format("  same side up        {}\n", shown(s.same_side, 100, " %"));
  out += fmt::format("  first touch, off by {}  ({} runs)\n", shown(s.impact, 1000, " ms", 2), s.impact.runs);
  out += fmt::format("  and its place by  {}\n", shown(s.place, 1000, " mm"));
  out += fmt::format("  energy lost, off by {}  ({} runs)\n", shown(s.loss, 100, " % of it", 1), s.loss.runs);
  for (std::size_t k = 0; k < s.touch_losses.size(); ++k)
    if (s.touch_losses[k].runs > 0)
      out += fmt::format("  in touch {}, off by  {}  ({} runs)\n", k + 1,
                         shown(s.touch_losses[k], 100, " % of it", 1), s.touch_losses[k].runs);
  return out + told_band(s.covered, s.band, members);
}

ordered_json to_json(const validation::Horizon& h) {
  return {{"run", h.run},
          {"failure", h.failure},
          {"held", number(h.held)},
          {"to_the_end", std::isinf(h.held)},
          {"expected", number(h.expected)},
          {"exponent", number(h.exponent)},
          {"covered", number(h.covered)}};
}

ordered_json to_json(const validation::HorizonSummary& s) {
  return {{"runs", s.runs},
          {"failed", s.failed},
          {"first_failure", s.first_failure},
          {"to_the_end", s.to_the_end},
          {"held", to_json(s.held)},
          {"expected", to_json(s.expected)},
          {"exponent", to_json(s.exponent)},
          {"covered", to_json(s.covered)},
          {"band", validation::name(s.band)}};
}

std::string told(const validation::HorizonSummary& s, int members) {
  const auto time = [](const Estimate& e) {
    const auto one = [](double t) {
      return std::isfinite(t) ? fmt::format("{:.3g} s", t) : std::string("the end");
    };
    if (std::isnan(e.value)) return std::string("not known");
    if (e.interval.low == -HUGE_VAL) return one(e.value);  // of too few runs
    return fmt::format("{} [{}, {}]", one(e.value), one(e.interval.low), one(e.interval.high));
  };
  std::string out;
  if (s.failed > 0)
    out += fmt::format("  failed              {} of {} runs: {}\n", s.failed, s.runs, s.first_failure);
  if (s.failed == s.runs) return out;
  out += fmt::format("  within 0.1 rad for  {}  ({} of {} runs to the end)\n", time(s.held), s.to_the_end,
                     s.runs - s.failed);
  out += fmt::format("  by the start alone  {}\n", time(s.expected));
  out += fmt::format("  exponent            {}\n", shown(s.exponent, 1, " 1/s", 2));
  return out + told_band(s.covered, s.band, members);
}

void set_step(measured::Experiment& e, const std::string& step) {
  if (step.empty()) return;
  e.model.step = scenario::parse_step(step, "--dt");
  try {
    core::whole_steps(1 / e.rate, e.model.step);
  } catch (const std::invalid_argument& error) {
    throw core::InputError(
        fmt::format("--dt {}: a frame is no whole number of steps: {}", step, error.what()));
  }
}

measured::Experiment first_runs(const measured::Experiment& e, int count) {
  const auto wanted = static_cast<std::size_t>(count);
  if (wanted > e.runs.size())
    throw core::InputError(fmt::format("--runs {}: {} has {} runs", wanted, e.file, e.runs.size()));
  return count == 0 ? e : validation::with_runs(e, wanted);
}

measured::Experiment set_values(const measured::Experiment& e, const std::vector<std::string>& values) {
  std::vector<measured::Parameter> parameters;
  std::vector<double> numbers;
  std::vector<std::string> names;
  for (const measured::Parameter& p : e.parameters) names.push_back(p.name);
  for (const std::string& word : values) {
    const std::size_t at = word.find('=');
    if (at == std::string::npos) throw core::InputError(fmt::format("--set {}: must be NAME=VALUE", word));
    const auto found = std::ranges::find(e.parameters, word.substr(0, at), &measured::Parameter::name);
    if (found == e.parameters.end())
      throw core::InputError(fmt::format("--set {}: {} has no parameter '{}'{}", word, e.file,
                                         word.substr(0, at), core::did_you_mean(word.substr(0, at), names)));
    if (std::ranges::find(parameters, found->name, &measured::Parameter::name) != parameters.end())
      throw core::InputError(fmt::format("--set {}: '{}' twice", word, found->name));
    double value = std::nan("");
    const char* end = word.data() + word.size();
    if (std::from_chars(word.data() + at + 1, end, value).ptr != end ||
        !(found->low <= value && value <= found->high))
      throw core::InputError(
          fmt::format("--set {}: a number in [{:g}, {:g}] must follow '='", word, found->low, found->high));
    parameters.push_back(*found), numbers.push_back(value);
  }
  return measured::with_values(e, parameters, numbers);
}

}  // namespace cylon::cli
