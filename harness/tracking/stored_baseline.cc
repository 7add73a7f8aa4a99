#include "harness/tracking/stored_baseline.h"

#include "harness/core/input_error.h"
#include "harness/process/interruption.h"
#include "harness/study/profile.h"
#include "harness/tracking/store/store.h"
#include "harness/tracking/track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

namespace fs = std::filesystem;
using results::Comparison;
using results::Finding;

constexpr std::string_view prefix = "run:";
constexpr std::string_view counted_by = "instructions:";  // then the counter

const store::Result* result_of(const std::vector<store::Result>& results, const study::Cell& cell) {
  const auto found = std::find_if(results.begin(), results.end(), [&](const store::Result& r) {
    return r.cell.scenario == cell.scenario->name && r.cell.engine == cell.engine.id && r.cell.dt == cell.dt;
  });
  return found == results.end() ? nullptr : &*found;
}

bool ended(const std::string& status) {
  for (const char* word : {"unsupported", "crash", "timeout", "protocol"})
    if (status == word) return false;
  return true;
}

void compare_cell(const study::Cell& cell, const store::Result* stored, const study::Side& candidate,
                  const study::CompareOptions& options, Comparison& c) {
  const auto skip = [&](const std::string& why) {
    c.finding = Finding::skipped, c.skip = results::Skip::missing, c.reason = why;
  };
  if (!stored) return skip("the stored run has no such cell");
  if (stored->cell.scenario_hash != cell.scenario->hash)
    return skip(fmt::format("another version of the scenario: {} then, {} now", stored->cell.scenario_hash,
                            cell.scenario->hash));
  const auto engine = study::on(candidate, cell.engine);
  if (!engine) return skip(fmt::format("{} has no worker for '{}'", candidate.name, cell.engine.row.id));
  const bool counted =
      std::any_of(stored->samples.begin(), stored->samples.end(),
                  [](const store::Sample& s) { return s.metric.name.starts_with(counted_by); });
  const study::Profile now = study::profile(*cell.scenario, *engine, cell.dt,
                                            counted ? options.counter : study::Counter::off, options.limits);
  const study::Profile then = profile_of(*stored, now);
  if (!study::both_ran(c, then, now)) return;
  c.metrics = study::compare_profiles(then, now);
}

}  // namespace

std::optional<store::RunInfo> stored_run(const std::string& store_file, const std::string& word) {
  const bool said = word.starts_with(prefix);
  if (word.empty() || (!said && !fs::exists(store_file))) return std::nullopt;
  const store::Store store = store::Store::open(store_file, store::Mode::read);
  return said ? find_run(store, word.substr(prefix.size())) : store.find_run(word);
}

std::optional<std::string> anchor_binary(const std::string& store_file, const store::RunInfo& run) {
  const store::Store store = store::Store::open(store_file, store::Mode::read);
  for (const store::Anchor& anchor : store.anchors())
    if (anchor.run == run.uid && fs::exists(anchor.binary)) return anchor.binary;
  return std::nullopt;
}

study::Profile profile_of(const store::Result& stored, const study::Profile& like) {
  study::Profile result;
  result.facts = {"", like.facts.events, like.facts.contacts};
  for (const store::Judgement& j : stored.judgements) {
    if (!ended(j.status)) {
      result.status = results::status_from(j.status).value_or(results::Status::crash);
      result.reason = j.detail;
      return result;
    }
    study::ClaimProfile row{.claim = j.claim, .unit = j.unit};
    row.error = j.measured;
    result.claims.push_back(row);
  }
  for (const store::Sample& s : stored.samples) {
    if (s.metric.name == "state_hash") result.facts.state_hash = s.text;
    if (s.metric.name == "events") result.facts.events = std::llround(s.value);
    if (s.metric.name == "contacts") result.facts.contacts = std::llround(s.value);
    if (!std::isfinite(s.value) ||
        s.metric.name != fmt::format("{}{}", counted_by, study::name(like.instructions.counter)))
      continue;
    result.instructions = like.instructions;
    result.instructions.instructions = std::llround(s.value);
  }
  return result;
}

results::ComparisonReport compare_with_stored(const std::string& store_file, const store::RunInfo& run,
                                              const std::vector<study::Cell>& cells,
                                              const study::Side& candidate,
                                              const study::CompareOptions& options,
                                              const study::CompareProgress& progress) {
  const store::Store store = store::Store::open(store_file, store::Mode::read);
  const std::vector<store::Result> results = store.results(run.id);
  results::ComparisonReport report;
  report.baseline =
      fmt::format("run #{} of {}{}{}", run.id, run.revision, run.label.empty() ? "" : ", " + run.label,
                  run.complete ? "" : ", incomplete");
  report.candidate = candidate.name;
  report.tau = options.rule.tau, report.alpha = options.rule.alpha, report.gate = options.gate;
  report.notes = {
      "times are not compared with a stored run: give a build or a revision, or pin the run's binary as an "
      "anchor"};
  for (const study::Cell& cell : cells) {
    Comparison& c = report.cells.emplace_back(study::open_comparison(cell));
    if (progress) progress("results of " + c.cell());
    c.untimed = "not against a stored run";
    try {
      if (!report.interrupted) compare_cell(cell, result_of(results, cell), candidate, options, c);
    } catch (const process::Interrupted&) {
      report.interrupted = true;
    }
    if (report.interrupted) study::leave_out(c);
  }
  study::conclude(report);
  return report;
}

}  // namespace cylon::tracking
