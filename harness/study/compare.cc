#include "harness/study/compare.h"

#include "harness/process/interruption.h"
#include "harness/results/build.h"
#include "harness/study/paired_times.h"
#include "harness/tracking/statistics/holm.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

namespace cylon::study {
namespace {

using process::EngineChoice;
using results::Comparison;
using results::Finding;

/// What is timed later.
struct ToTime {
  std::size_t cell;
  EngineChoice baseline, candidate;
  SamplePlan plan;
};

bool end(Comparison& c, Finding finding, std::string reason) {
  c.finding = finding;
  c.reason = std::move(reason);
  return false;
}

std::string failure_of(const Profile& p) { return fmt::format("{}: {}", results::name(p.status), p.reason); }

/// Of a cell whose times nobody knows: it is not the same.
void leave_untimed(Comparison& c, std::string reason) {
  c.untimed = std::move(reason);
  c.finding = Finding::inconclusive;
}

/// Callgrind would count an interpreter for minutes.
Counter counter_for(const EngineChoice& engine, Counter counter) {
  return counter == Counter::callgrind && engine.row.command.size() > 1 ? Counter::off : counter;
}

/// What repeats bit for bit, and a plan for the times.
std::optional<ToTime> compare_exactly(const Cell& cell, Comparison& c, const Side& old_side,
                                      const Side& new_side, const CompareOptions& options,
                                      std::set<std::string>& notes) {
  const auto before = on(old_side, cell.engine), after = on(new_side, cell.engine);
  if (before && !after) {
    end(c, Finding::regressed,
        fmt::format("{} no longer has a worker for '{}'", new_side.name, cell.engine.row.id));
    return std::nullopt;
  }
  if (!before || !after) {
    c.skip = results::Skip::missing;
    end(c, Finding::skipped,
        fmt::format("{} has no worker for '{}'", after ? old_side.name : new_side.name, cell.engine.row.id));
    return std::nullopt;
  }
  if (content_hash(before->row.command) == content_hash(after->row.command)) {
    c.skip = results::Skip::identical;
    end(c, Finding::skipped, "identical: the same binary and libraries on the same scenario");
    return std::nullopt;
  }
  const Counter counter = counter_for(*after, options.counter);
  if (counter != options.counter)
    notes.insert(fmt::format("instructions of '{}' are not counted: its worker is started by another program",
                             cell.engine.row.id));
  const Profile old_profile = profile(*cell.scenario, *before, cell.dt, counter, options.limits);
  const Profile new_profile = profile(*cell.scenario, *after, cell.dt, counter, options.limits);
  if (!both_ran(c, old_profile, new_profile)) return std::nullopt;
  c.metrics = compare_profiles(old_profile, new_profile);
  if (!new_profile.instructions.instructions && counter != Counter::off)
    notes.insert("instructions: " + new_profile.instructions.remark);
  if (!options.time) return std::nullopt;
  const std::string old_build = results::build_in_words(old_profile.version),
                    new_build = results::build_in_words(new_profile.version);
  if (old_build != new_build) {
    leave_untimed(c, fmt::format("{} is {}, {} is {}: their costs do not compare", old_side.name, old_build,
                                 new_side.name, new_build));
    return std::nullopt;
  }

  const Sampling plan = sampling(*cell.scenario, cell.dt);
  Planned planned = plan_samples(pinned(*before, options.pinning), cell.scenario->scene, cell.dt, plan.steps,
                                 options.sample, options.limits);
  if (!planned.plan) {
    if (planned.failed)
      leave_untimed(c, "the baseline: " + planned.reason);
    else
      c.untimed = planned.reason;
    return std::nullopt;
  }
  return ToTime{0, pinned(*before, options.pinning), pinned(*after, options.pinning), *planned.plan};
}

TakeSample sampler(const EngineChoice& engine, const SamplePlan& plan, const process::Limits& limits) {
  return [&engine, &plan, &limits] { return take_sample(engine, plan, limits); };
}

/// The pairs of one cell; those of the baseline with itself between them where `self_check` is wanted.
void time_cell(const ToTime& job, const CompareOptions& options, const statistics::PairedRule& rule,
               const CompareProgress& progress, Comparison& c,
               std::optional<results::ComparedTime>* self_check) {
  const TakeSample old_sample = sampler(job.baseline, job.plan, options.limits);
  PairedTimes pairs(old_sample, sampler(job.candidate, job.plan, options.limits), rule);
  PairedTimes same(old_sample, old_sample, options.rule);
  for (int n = 1; pairs.wants_more() || (self_check && same.wants_more()); ++n) {
    if (progress)
      progress(fmt::format("timing {}, pair {} of at most {}", c.cell(), n, rule.looks.back().pairs));
    if (pairs.wants_more()) pairs.take_pair();
    if (self_check && same.wants_more()) same.take_pair();
  }
  if (self_check) {
    *self_check = same.summary();
    (*self_check)->what = fmt::format("{}, baseline against itself", c.cell());
  }
  if (!pairs.candidate_failure().empty()) {
    c.finding = Finding::regressed, c.reason = "fails when repeated: " + pairs.candidate_failure();
  } else if (!pairs.baseline_failure().empty()) {
    leave_untimed(c, "the baseline: " + pairs.baseline_failure());
  } else {
    c.time = pairs.summary();
    c.time->what = job.plan.says();
  }
}

}  // namespace

results::Comparison open_comparison(const Cell& cell) {
  Comparison c;
  c.scenario = cell.scenario->name, c.scenario_hash = cell.scenario->hash;
  c.engine = cell.engine.id, c.dt = cell.dt, c.dt_text = cell.dt_text, c.reproduce = cell.reproduce;
  return c;
}

bool both_ran(Comparison& c, const Profile& baseline, const Profile& candidate) {
  const bool before = baseline.status == results::Status::pass,
             after = candidate.status == results::Status::pass;
  if (before && after) return true;
  if (before) return end(c, Finding::regressed, "no longer runs: " + failure_of(candidate));
  if (after) return end(c, Finding::improved, "the baseline did not run: " + failure_of(baseline));
  const bool unsupported = baseline.status == results::Status::unsupported;
  c.skip = unsupported ? results::Skip::unsupported : results::Skip::missing;
  return end(c, Finding::skipped,
             unsupported ? failure_of(candidate) : "neither build runs: " + failure_of(candidate));
}

void adjust(std::vector<Comparison>& cells, double alpha) {
  std::vector<results::ComparedTime*> timed;
  std::vector<double> p;
  for (Comparison& c : cells)
    if (c.time) timed.push_back(&*c.time), p.push_back(c.time->p);
  const std::vector<double> adjusted = statistics::holm(p);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    timed[i]->adjusted = adjusted[i];
    // Each was sampled with alpha / m; a later step of Holm's asks for less.
    if (timed[i]->finding == Finding::inconclusive && adjusted[i] <= alpha)
      timed[i]->finding = timed[i]->ratio > 1 ? Finding::regressed : Finding::improved;
  }
}

void conclude(results::ComparisonReport& report) {
  if (report.self_check)
    report.reliable =
        report.self_check->finding != Finding::regressed && report.self_check->finding != Finding::improved;
  for (Comparison& c : report.cells) {
    if (c.time && !report.reliable) c.time->finding = Finding::inconclusive;
    c.finding = results::worst_finding(c);
  }
}

void leave_out(Comparison& c) {
  if (c.untimed.empty()) c.untimed = "interrupted";
  if (!c.metrics.empty()) return;
  c.skip = results::Skip::missing;
  end(c, Finding::skipped, "interrupted before it was compared");
}

results::ComparisonReport compare(const std::vector<Cell>& cells, const Side& baseline, const Side& candidate,
                                  const CompareOptions& options, const CompareProgress& progress) {
  results::ComparisonReport report{.baseline = baseline.name, .candidate = candidate.name};
  report.tau = options.rule.tau, report.alpha = options.rule.alpha, report.gate = options.gate;
  // Of a cell; after an interruption of none any more.
  const auto unless_interrupted = [&](Comparison& c, const auto& step) {
    try {
      if (!report.interrupted) return step();
    } catch (const process::Interrupted&) {
      report.interrupted = true;
    }
    leave_out(c);
  };
  std::set<std::string> notes;
  std::vector<ToTime> jobs;
  for (const Cell& cell : cells) {
    Comparison& c = report.cells.emplace_back(open_comparison(cell));
    unless_interrupted(c, [&] {
      if (progress) progress("results of " + c.cell());
      auto job = compare_exactly(cell, c, baseline, candidate, options, notes);
      if (!job) return;
      job->cell = report.cells.size() - 1;
      jobs.push_back(std::move(*job));
    });
  }

  statistics::PairedRule rule = options.rule;
  if (options.gate && !jobs.empty()) rule.alpha /= static_cast<double>(jobs.size());
  for (const ToTime& job : jobs) {
    Comparison& c = report.cells[job.cell];
    unless_interrupted(c, [&] {
      time_cell(job, options, rule, progress, c, &job == &jobs.front() ? &report.self_check : nullptr);
    });
  }
  if (options.gate) adjust(report.cells, options.rule.alpha);
  conclude(report);
  report.notes.assign(notes.begin(), notes.end());
  return report;
}

}  // namespace cylon::study
