#include "reports/comparison_report.h"

#include "reports/json.h"

#include <nlohmann/json.hpp>

namespace cylon::reports {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const results::ComparedTime& t) {
  return {{"finding", results::name(t.finding)},
          {"ratio", number(t.ratio)},
          {"low", number(t.low)},
          {"high", number(t.high)},
          {"confidence", number(t.confidence)},
          {"pairs", t.pairs},
          {"p", number(t.p)},
          {"adjusted_p", number(t.adjusted)},
          {"baseline_seconds", number(t.baseline_seconds)},
          {"candidate_seconds", number(t.candidate_seconds)},
          {"what", t.what}};
}

ordered_json json_of(const results::Comparison& c) {
  ordered_json metrics = ordered_json::array();
  for (const results::ComparedMetric& m : c.metrics)
    metrics.push_back({{"name", m.name}, {"finding", results::name(m.finding)}, {"sentence", m.sentence}});
  return {{"scenario", c.scenario},  {"scenario_hash", c.scenario_hash},
          {"engine", c.engine},      {"dt", number(c.dt)},
          {"dt_text", c.dt_text},    {"finding", results::name(c.finding)},
          {"reason", c.reason},      {"time", c.time ? json_of(*c.time) : ordered_json()},
          {"untimed", c.untimed},    {"metrics", metrics},
          {"reproduce", c.reproduce}};
}

}  // namespace

std::string to_json(const results::ComparisonReport& report) {
  ordered_json cells = ordered_json::array();
  for (const results::Comparison& c : report.cells) cells.push_back(json_of(c));
  const ordered_json whole = {
      {"schema", 1},
      {"baseline", report.baseline},
      {"candidate", report.candidate},
      {"tau", number(report.tau)},
      {"alpha", number(report.alpha)},
      {"gate", report.gate},
      {"reliable", report.reliable},
      {"self_check", report.self_check ? json_of(*report.self_check) : ordered_json()},
      {"notes", report.notes},
      {"cells", cells}};
  return whole.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace cylon::reports
