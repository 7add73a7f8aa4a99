#include "harness/hunt/examine.h"

#include "harness/core/input_error.h"
#include "harness/hunt/oracle.h"
#include "harness/hunt/sensitivity.h"
#include "harness/scenario/scenario.h"
#include "harness/study/cell.h"
#include "harness/study/metamorphic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace cylon::hunt {
namespace {

using results::Status;
using results::Verdict;

constexpr double most_sensitive = 100;  // beyond it oracles of trajectories are silent
constexpr std::size_t at_a_64th = 6;    // of the step: no more than truncation shows there

std::optional<scenario::Scenario> scenario_of(const Trial& trial, const std::string& claim) {
  try {
    scenario::Scenario scenario = scenario::read(to_toml(trial, claim), "hunted.toml");
    if (!scenario::prepare_soon(scenario)) return std::nullopt;
    return scenario;
  } catch (const core::InputError&) {
    return std::nullopt;  // the claim cannot be made here
  }
}

// One oracle's numbers, as they come.
struct Asked {
  Fault fault;
  Course course;
  bool of_trajectories = false;  // or of steps, or held to a promise: the motion must not be sensitive
  bool answers = true;           // until the engine tells nothing

  bool open() const { return answers && course.open(); }

  void note(double measured, double allowed, const std::string& unit, double truth_error = 0) {
    course.add(measured, allowed, truth_error);
    fault.unit = unit;
  }
  void note(const Verdict& row) {
    // Without a number, fail: the engine starts a restated scene from another state.
    if (row.status == Status::unsupported || (row.status == Status::fail && std::isnan(row.measured))) {
      answers = false;
      return;
    }
    fault.by_time = fault.by_time || row.status == Status::timeout;
    for (const told::Diagnostic& one : row.diagnostics)
      if (one.order > 0) course.not_promised(one.order);
    if (std::isnan(row.measured) && fault.detail.empty())
      fault.detail = fmt::format("{}: {}", results::name(row.status), row.detail);
    note(row.measured, row.allowed, row.unit, row.truth_error);
  }
};

class Examination {
 public:
  Examination(Trial trial, const process::EngineChoice& engine, const process::Limits& limits,
              const Only& only)
      : trial_(std::move(trial)), engine_(engine), limits_(limits), only_(only) {}

  Examined examined() {
    const auto plain = scenario_of(trial_, "");
    if (!plain) return {};
    trial_.scene = plain->scene;  // as a reader of the file has it
    for (const Oracle& oracle : oracles())
      if (wanted(oracle.name) && !oracle.undefined_in(trial_.scene)) defined_.push_back(&oracle);
    if (runs()) {
      ask_recordings();
      ask_claims();
      ask_relations();
    }
    return {std::move(found_), first_.status == Status::unsupported || first_.status == Status::fail};
  }

 private:
  bool wanted(std::string_view name) const { return only_.oracle.empty() || only_.oracle == name; }
  double step(std::size_t i) const { return trial_.step / static_cast<double>(1 << i); }
  double sensitive() {
    if (!sensitivity_) sensitivity_ = sensitivity(trial_, engine_, limits_);
    return *sensitivity_;
  }

  Asked asked(std::string_view oracle, std::string_view says, std::string_view why, double relative) const {
    return {{std::string(oracle), std::string(says), std::string(why)}, Course(expected_, relative)};
  }
  Asked asked(const Oracle& oracle) const {
    Expected expected = expected_;
    expected.smooth = expected.smooth && !oracle.of_steps;
    expected.resolved = expected.resolved && !oracle.one_sided;
    if (oracle.of_angle) expected.largest = std::numbers::pi;  // of a radian: an angle is no larger
    expected.stepless = oracle.stepless_in && oracle.stepless_in(trial_.scene);
    Asked one = asked(oracle.name, oracle.says, oracle.why, oracle.relative);
    one.course = Course(expected, oracle.relative);
    return one;
  }

  // Large errors that do not fall: at a far finer step they do where they are truncation.  `measure(i)`: the error at the
  // i-th step; nothing where there is no such run.
  template <class Measure>
  std::optional<Kind> asked_further(const Asked& asked, const Measure& measure) const {
    if (!asked.course.may_be_saturated()) return asked.course.fault();
    const std::optional<double> finer = measure(at_a_64th);
    if (!finer || !asked.course.falls_at_last(*finer)) return Kind::every_step;
    Trial finest = trial_;
    finest.step = step(halvings - 1);
    const bool resolved = is_smooth(trial_.scene) && resolves(finest).value_or(false);
    return resolved && !asked.of_trajectories ? std::optional(Kind::slow) : std::nullopt;
  }

  // What is a fault in the end.
  template <class Measure>
  void close(Asked& asked, const Measure& measure) {
    if (!asked.answers) return;
    const std::optional<Kind> kind = asked_further(asked, measure);
    if (!kind || (!only_.oracle.empty() && *kind != only_.kind)) return;
    const bool promise = *kind == Kind::own_promise;
    const bool exact = asked.course.allowed() == 0;
    if ((promise || (asked.of_trajectories && !exact)) && !(sensitive() <= most_sensitive)) return;
    // What the motion makes of an error that the integrator bounds.
    if (promise && expected_.promise.adaptive &&
        asked.course.least_part() <= std::max(1.0, sensitive()) * Course::held_to(expected_.promise))
      return;
    Fault fault = std::move(asked.fault);
    fault.kind = *kind, fault.measured = asked.course.measured(), fault.steps = asked.course.count();
    fault.allowed = asked.course.allowed();
    if (std::ranges::none_of(fault.measured, [](double x) { return std::isnan(x); })) fault.detail.clear();
    found_.push_back(std::move(fault));
  }

  // Whether the run comes to its end; else that is the fault, unless the engine refuses the scene.  Numbers that
  // end at a coarse step alone, or where no step asked for resolves the rates, are an unstable scheme's, and no fault.
  bool runs() {
    first_ = outcome_at(0);
    if (first_.status == Status::unsupported || first_.status == Status::fail) return false;
    Fault fault;
    fault.says = "a run comes to its end, with numbers", fault.why = "whatever the scene";
    fault.detail = first_.reason;
    if (first_.status == Status::pass) {
      if (!core::first_bad_step(*first_.recording)) {
        expect(*first_.recording);
        return true;
      }
      Trial finest = trial_;
      finest.step = step(halvings - 1);
      const std::optional<bool> resolved = resolves(finest);
      if (resolved == false) return false;
      const auto ends_without_numbers = [&](std::size_t i) {
        const process::RunOutcome finer = outcome_at(i);
        return finer.status == Status::pass && core::first_bad_step(*finer.recording);
      };
      for (std::size_t i = 1; i < halvings; ++i)
        if (!ends_without_numbers(i)) return false;
      if (!resolved && !ends_without_numbers(at_a_64th)) return false;
      fault.detail = "not a number, at every step";
    }
    fault.by_time = first_.status == Status::timeout;
    fault.oracle = results::name(first_.status == Status::pass ? Status::non_finite : first_.status);
    if (wanted(fault.oracle)) found_.push_back(std::move(fault));
    return false;
  }

  void expect(const core::Recording& run) {
    study::Promise& promise = expected_.promise = study::promise_of(run.engine, run.terms);
    promise.adaptive = promise.adaptive || run.terms.closed_form;
    if (promise.each_step) promise.tolerance *= static_cast<double>(trial_.steps);
    expected_.smooth = is_smooth(trial_.scene);
    expected_.resolved = resolves(trial_).value_or(false);
    expected_.rounding = run.engine.precision == "float" ? 1e-4 : 1e-7;
  }

  process::RunOutcome outcome_at(std::size_t i) const {
    process::RunRequest request;
    request.scene = &trial_.scene;
    request.setup.dt = step(i), request.steps = trial_.steps << i;
    request.contacts = std::ranges::any_of(defined_, &Oracle::of_contacts);
    return process::run(engine_, request, limits_);
  }

  // Those that read a recording themselves.
  void ask_recordings() {
    std::vector<std::pair<const Oracle*, Asked>> open;
    for (const Oracle* oracle : defined_)
      if (oracle->read) open.emplace_back(oracle, asked(*oracle));
    for (std::size_t i = 0;
         i < halvings && std::ranges::any_of(open, [](auto& o) { return o.second.open(); }); ++i) {
      process::RunOutcome outcome = i == 0 ? std::move(first_) : outcome_at(i);
      for (auto& [oracle, one] : open) {
        if (!one.open()) continue;
        const auto reading =
            outcome.recording ? oracle->read(trial_.scene, *outcome.recording) : std::nullopt;
        one.answers = reading.has_value();
        if (reading) one.note(reading->measured, oracle->relative * reading->scale, reading->unit);
      }
    }
    for (auto& [oracle, one] : open)
      close(one, [&, oracle = oracle](std::size_t i) -> std::optional<double> {
        const process::RunOutcome outcome = outcome_at(i);
        const auto reading =
            outcome.recording ? oracle->read(trial_.scene, *outcome.recording) : std::nullopt;
        return reading ? std::optional(reading->measured) : std::nullopt;
      });
    std::vector<Asked*> quiet;
    std::vector<const Oracle*> rows;
    for (auto& [oracle, one] : open)
      if (may_rise(one)) quiet.push_back(&one), rows.push_back(oracle);
    ask_finer(quiet, [&](std::size_t i) {
      const process::RunOutcome outcome = outcome_at(i);
      std::vector<double> values;
      for (const Oracle* oracle : rows) {
        const auto reading =
            outcome.recording ? oracle->read(trial_.scene, *outcome.recording) : std::nullopt;
        values.push_back(reading ? reading->measured : 0);
      }
      return values;
    });
  }

  // ---- Faults of fine steps ----------------------------------------------------------------------------------

  bool may_rise(const Asked& one) const {
    return !expected_.smooth && one.answers && !one.of_trajectories && one.course.count() == 1 &&
           !one.course.fault();
  }

  // `at(i)`: the numbers of all at the i-th step.
  template <class At>
  void ask_finer(const std::vector<Asked*>& quiet, const At& at) {
    if (quiet.empty() || (!only_.oracle.empty() && only_.kind != Kind::fine_step)) return;
    std::array<std::vector<double>, halvings> all;
    for (Asked* one : quiet) all[0].push_back(one->course.measured()[0]);
    const auto faulty = [&](std::size_t i) {
      for (std::size_t k = 0; k < quiet.size(); ++k)
        if (all[i][k] > 10 * quiet[k]->course.allowed()) return true;
      return false;
    };
    for (const std::size_t i : {std::size_t{4}, std::size_t{3}, std::size_t{2}, std::size_t{1}}) {
      all[i] = at(i);
      if (i >= 3 && !faulty(i)) return;
    }
    for (std::size_t k = 0; k < quiet.size(); ++k) {
      Fault fault = quiet[k]->fault;
      for (std::size_t i = 0; i < halvings; ++i) fault.measured[i] = all[i][k];
      fault.allowed = quiet[k]->course.allowed(), fault.steps = halvings, fault.kind = Kind::fine_step;
      if (Course::rises(fault.measured, fault.allowed)) found_.push_back(std::move(fault));
    }
  }

  // All claims that can be made of the scene, of one run at each step.
  void ask_claims() {
    std::vector<const Oracle*> rows;
    std::string own, truths;
    for (const Oracle* oracle : defined_) {
      if (oracle->claim.empty()) continue;
      const std::string claim = claim_of(*oracle);
      if (!oracle->of_trajectories && !scenario_of(trial_, claim)) continue;  // none to be made here
      rows.push_back(oracle);
      (oracle->of_trajectories ? truths : own) += claim;
    }
    std::optional<scenario::Scenario> scenario = scenario_of(trial_, own + truths);
    if (!scenario) {  // no certified solution
      scenario = scenario_of(trial_, own);
      std::erase_if(rows, [](const Oracle* oracle) { return oracle->of_trajectories; });
    }
    if (!scenario || rows.empty()) return;
    std::vector<Asked> all;
    for (const Oracle* oracle : rows) {
      all.push_back(asked(*oracle));
      all.back().of_trajectories = oracle->of_trajectories || oracle->of_steps;
      all.back().fault.claim = claim_of(*oracle);
    }
    for (std::size_t i = 0; i < halvings && std::ranges::any_of(all, &Asked::open); ++i) {
      const std::vector<Verdict> verdicts = ask(*scenario, i, study::Exam::claims);
      for (std::size_t k = 0; k < all.size(); ++k)
        if (all[k].open()) all[k].note(verdicts.at(k));
    }
    for (std::size_t k = 0; k < all.size(); ++k)
      close(all[k], [&](std::size_t i) {
        const double measured = ask(*scenario, i, study::Exam::claims).at(k).measured;
        return std::isnan(measured) ? std::nullopt : std::optional(measured);
      });
    std::vector<Asked*> quiet;
    std::vector<std::size_t> which;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (may_rise(all[k])) quiet.push_back(&all[k]), which.push_back(k);
    ask_finer(quiet, [&](std::size_t i) {
      const std::vector<Verdict> verdicts = ask(*scenario, i, study::Exam::claims);
      std::vector<double> values;
      for (const std::size_t k : which) values.push_back(verdicts.at(k).measured);
      return values;
    });
  }

  std::vector<Verdict> ask(const scenario::Scenario& scenario, std::size_t i, study::Exam exam) const {
    study::Cell cell;
    cell.scenario = &scenario, cell.engine = engine_, cell.exam = exam;
    cell.dt = step(i), cell.dt_text = fmt::format("{}", cell.dt);
    return exam == study::Exam::relations ? study::relate(cell, limits_, {}) : study::run(cell, limits_, {});
  }

  void ask_relations() {
    if (!only_.oracle.empty() && !only_.oracle.starts_with("relation ")) return;
    const auto scenario = scenario_of(trial_, "");
    if (!scenario) return;
    std::map<std::string, Asked> all;
    const auto open = [&] { return std::ranges::any_of(all, [](auto& one) { return one.second.open(); }); };
    for (std::size_t i = 0; i < halvings && (i == 0 || open()); ++i)
      for (const Verdict& row : ask(*scenario, i, study::Exam::relations)) {
        // A scheme that damps runs back as far as its truncation lets it, which need not fall from step to step.
        if (row.claim == "relation time reversal" || !wanted(row.claim)) continue;
        if (i == 0) {
          const auto [at, fresh] = all.emplace(
              row.claim, asked(row.claim, row.tolerance_reason, "as of every relation: docs/claims.md",
                               study::allowed_of_relations));
          at->second.of_trajectories = true;
        }
        const auto at = all.find(row.claim);
        if (at != all.end() && at->second.open()) at->second.note(row);
      }
    for (auto& [name, one] : all)
      close(one, [&, &name = name](std::size_t i) -> std::optional<double> {
        for (const Verdict& row : ask(*scenario, i, study::Exam::relations))
          if (row.claim == name && !std::isnan(row.measured)) return row.measured;
        return std::nullopt;
      });
  }

  Trial trial_;
  const process::EngineChoice& engine_;
  const process::Limits& limits_;
  Only only_;
  std::vector<const Oracle*> defined_;
  process::RunOutcome first_;
  Expected expected_;
  std::optional<double> sensitivity_;
  std::vector<Fault> found_;
};

}  // namespace

process::RunOutcome first_step(const Trial& trial, const process::EngineChoice& engine,
                               const process::Limits& limits) {
  process::RunRequest request;
  request.scene = &trial.scene, request.setup.dt = trial.step, request.steps = 1;
  return process::run(engine, request, limits);
}

bool refuses(const Trial& trial, const process::EngineChoice& engine, const process::Limits& limits) {
  return first_step(trial, engine, limits).status == Status::unsupported;
}

Examined examine(const Trial& trial, const process::EngineChoice& engine, const process::Limits& limits,
                 const Only& only) {
  return Examination(trial, engine, limits, only).examined();
}

}  // namespace cylon::hunt
