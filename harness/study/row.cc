#include "harness/study/row.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::study {

results::Verdict open_row(const Cell& cell, const std::string& claim,
                          const scenario::Expectations& expectations) {
  results::Verdict row;
  row.scenario = cell.scenario->name;
  row.scenario_hash = cell.scenario->hash;
  row.engine = cell.engine.id;
  row.dt = cell.dt;
  row.dt_text = cell.dt_text;
  row.claim = claim;
  row.reproduce = cell.reproduce;
  const auto expected =
      expectations.find(cell.known_as.empty() ? row.scenario : cell.known_as, cell.engine.id, cell.dt, claim);
  row.expected = expected.status;
  row.expected_size = expected.size;
  row.expected_within = expected.within;
  row.expected_reason = expected.reason;
  if (const auto reason = process::missing(cell.engine.row)) {
    row.expected = results::Status::unsupported, row.expected_size.reset();
    row.expected_reason = *reason;
  }
  return row;
}

void sign(results::Verdict& row, const core::Engine& engine, const core::Terms& terms,
          const scenario::Expectations& expectations) {
  row.version = engine.version;
  row.precision = engine.precision;
  row.path = terms.path;
  row.gyroscopic = terms.gyroscopic;
  row.integrator = terms.integrator;
  row.closed_form = terms.closed_form;
  row.substeps = terms.substeps;
  row.settings.clear();
  for (const core::Setting& setting : terms.settings) row.settings.emplace_back(setting.name, setting.value);
  row.unforceable = terms.unforceable;
  row.version_listed = engine.version.empty() || expectations.version_listed(engine.name, engine.version);
}

void add_detail(results::Verdict& row, const std::string& sentence) {
  row.detail += fmt::format("{}{}", row.detail.empty() ? "" : "; ", sentence);
}

int copies_of(const Cell& cell) {
  constexpr int usual = 2;
  const auto& tags = cell.scenario->tags;
  const bool chaotic = std::find(tags.begin(), tags.end(), "chaos") != tags.end();
  return cell.copies > 0 ? cell.copies : chaotic ? usual : 0;
}

void tell_failed_copy(results::Verdict& row, int copy, const process::RunOutcome& outcome) {
  add_detail(row, fmt::format("copy {}, started one ulp apart: {}, {}", copy + 1,
                              results::name(outcome.status), outcome.reason));
}

void tell_spread(results::Verdict& row, int copies) {
  if (!row.spread) return;
  add_detail(row, fmt::format("{} runs that start one ulp apart end at a distance of {:.2g}{}{}", copies,
                              *row.spread, row.unit.empty() ? "" : " ", row.unit));
}

}  // namespace cylon::study
