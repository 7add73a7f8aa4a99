#include "harness/tracking/track_result.h"

#include "harness/study/exact_facts.h"

#include <cmath>
#include <limits>
#include <string_view>

namespace cylon::tracking {

namespace {

using results::Verdict;
using store::Kind;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

store::Sample number(std::string metric, Kind kind, std::string unit, double value) {
  return {{std::move(metric), kind, std::move(unit)}, 0, value, ""};
}

std::string settings_of(const core::Terms& terms) {
  std::string text;
  for (const core::Setting& setting : terms.settings)
    text += (text.empty() ? "" : "; ") + setting.name + "=" + setting.value;
  return text;
}

store::Judgement judgement(const Verdict& row) {
  return {.claim = row.claim,
          .observable = row.observable,
          .unit = row.unit,
          .status = std::string(results::name(row.status)),
          .expected = std::string(results::name(row.expected)),
          .measured = row.measured,
          .allowed = row.allowed,
          .truth_error = row.truth_error,
          .detail = row.status == results::Status::pass ? "" : row.detail};
}

// A claim whose measured value is an error at the cell's step, which shrinks with it.
bool is_error(const core::Claim& claim) {
  const bool read_at_one_step =
      claim.reduction == core::Reduction::max || claim.reduction == core::Reduction::end;
  return claim.truth && !core::validates(claim) && read_at_one_step && !claim.tolerance.order;
}

}  // namespace

store::Result result_of(const study::Cell& cell, const process::RunOutcome& outcome,
                        const std::vector<Verdict>& rows) {
  store::Result result;
  store::Cell& key = result.cell;
  key.scenario = cell.scenario->name;
  key.scenario_hash = cell.scenario->hash;
  key.engine = cell.engine.id;
  key.path = outcome.terms.path;
  key.integrator = outcome.terms.integrator;
  key.precision = outcome.engine.precision;
  key.settings = settings_of(outcome.terms);
  key.dt = cell.dt;
  key.dt_text = cell.dt_text;
  result.engine_version = outcome.engine.version;
  for (const Verdict& row : rows) {
    result.judgements.push_back(judgement(row));
    if (std::isfinite(row.measured))
      result.samples.push_back(number("error:" + row.claim, Kind::error, row.unit, row.measured));
  }
  if (!outcome.recording) return result;
  const study::ExactFacts facts = study::exact_facts(*outcome.recording);
  result.samples.push_back({{"state_hash", Kind::exact, ""}, 0, nan, facts.state_hash});
  result.samples.push_back(number("events", Kind::exact, "", static_cast<double>(facts.events)));
  result.samples.push_back(number("contacts", Kind::exact, "", static_cast<double>(facts.contacts)));
  if (outcome.peak_bytes > 0)
    result.samples.push_back(number("peak_memory", Kind::size, "B", static_cast<double>(outcome.peak_bytes)));
  return result;
}

std::vector<store::Sample> observed_orders(const study::Cell& cell, const std::vector<Verdict>& rows,
                                           const std::vector<Verdict>& halved) {
  std::vector<store::Sample> samples;
  const auto& claims = cell.scenario->claims;
  for (std::size_t i = 0; i < claims.size() && i < rows.size() && i < halved.size(); ++i) {
    const double whole = rows[i].measured, half = halved[i].measured, floor = 10 * rows[i].truth_error;
    if (is_error(claims[i]) && std::isfinite(whole) && whole > floor && half > floor && half > 0)
      samples.push_back(number("order:" + claims[i].label, Kind::error, "order", std::log2(whole / half)));
  }
  return samples;
}

}  // namespace cylon::tracking
