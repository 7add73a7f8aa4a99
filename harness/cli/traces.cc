#include "harness/cli/traces.h"

#include "reports/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace cylon::cli {
namespace {

using results::Verdict;
using Key = std::tuple<std::string, std::string, std::string, std::string>;

Key key(const reports::PackedTrace& t) { return {t.scenario, t.engine, t.integrator, t.dt_text}; }
Key key(const Verdict& v) { return {v.scenario, v.engine, v.integrator, v.dt_text}; }

// 0 differs, 1 fails as expected, 2 passes; of a cell the least.
std::map<Key, int> ranks(const std::vector<Verdict>& verdicts) {
  std::map<Key, int> result;
  for (const Verdict& v : verdicts) {
    const bool well = v.status == results::Status::pass || v.status == results::Status::unsupported;
    const int rank = !v.as_expected() ? 0 : well ? 2 : 1;
    const auto [place, fresh] = result.emplace(key(v), rank);
    if (!fresh) place->second = std::min(place->second, rank);
  }
  return result;
}

}  // namespace

void Traces::watch(std::vector<study::Cell>& cells) {
  packed_.resize(cells.size()), errors_.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i].seen = [this, i, &cell = cells[i]](const process::RunOutcome& outcome,
                                                std::span<const core::Reading> readings) {
      if (!outcome.recording) return;
      const scenario::Scenario& scenario = *cell.scenario;
      reports::Trace trace = reports::trace(scenario.scene, scenario.claims, readings, *outcome.recording);
      trace.scenario = scenario.name, trace.engine = cell.engine.id;
      trace.integrator = outcome.terms.integrator, trace.dt_text = cell.dt_text;
      reports::PackedTrace packed = reports::pack(trace);
      trace.motion = {}, trace.ghost.reset(), trace.totals.clear(), trace.events.clear();
      const std::scoped_lock lock(adding_);
      packed_[i] = std::move(packed);
      errors_[i] = std::move(trace);
    };
}

std::vector<reports::PackedTrace> Traces::chosen(const std::vector<study::Cell>& cells,
                                                 const std::vector<Verdict>& verdicts, Trajectories which,
                                                 std::string& why_not) const {
  if (which == Trajectories::none) {
    why_not = "--trajectories none was given";
    return {};
  }
  const std::map<Key, int> rank_of = ranks(verdicts);
  std::set<std::string> failing;
  for (const auto& [cell, rank] : rank_of)
    if (rank < 2) failing.insert(std::get<0>(cell));

  std::vector<std::pair<int, const reports::PackedTrace*>> order;
  std::size_t passing = 0, absent = 0;
  for (const reports::PackedTrace& trace : packed_) {
    if (trace.block.empty()) continue;
    const auto found = rank_of.find(key(trace));
    int rank = found == rank_of.end() ? 2 : found->second;
    if (rank == 2 && !failing.contains(trace.scenario)) rank = 3;
    if (rank == 3 && which == Trajectories::fail) {
      ++passing;
      continue;
    }
    order.emplace_back(rank, &trace);
  }
  absent = cells.size() - std::min(cells.size(), order.size() + passing);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });

  std::vector<std::string> reasons;
  if (passing > 0)
    reasons.push_back(fmt::format(
        "{} runs of scenarios without a failure are left out (--trajectories all keeps them)", passing));
  if (absent > 0)
    reasons.push_back(
        fmt::format("{} cells have no recording: unsupported, stopped early, or not run again", absent));
  why_not = fmt::format("{}", fmt::join(reasons, "; "));
  std::vector<reports::PackedTrace> result;
  for (const auto& [rank, trace] : order) result.push_back(*trace);
  return result;
}

}  // namespace cylon::cli
