#include "harness/cli/commands/trade_sweep.h"

#include "harness/cli/command_line.h"
#include "harness/cli/farm.h"
#include "harness/cli/output.h"
#include "harness/cli/progress.h"
#include "harness/cli/provenance_now.h"
#include "harness/cli/resumed.h"
#include "harness/cli/scenario_view.h"
#include "harness/cli/timed_cores.h"
#include "harness/core/input_error.h"
#include "harness/process/interruption.h"
#include "harness/results/duration.h"
#include "harness/study/self_reference.h"
#include "reports/html.h"
#include "reports/trade_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <exception>
#include <iostream>
#include <optional>

namespace cylon::cli {
namespace {

// One line on a terminal, written over; nothing elsewhere.
class Progress {
 public:
  Progress(bool on, std::string scenario) : on_(on), scenario_(std::move(scenario)) {}
  ~Progress() { show_progress(on_, ""); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void operator()(const study::Setting& setting, const results::TradePoint& point, bool timing) {
    ++(timing ? timings_ : runs_);
    show_progress(on_, plain_line(fmt::format("{}: {} runs, {} timings; {} {} at {}", scenario_, runs_,
                                              timings_, setting.engine.id, setting.integrator.name,
                                              results::step_in_words(point.dt_text))));
  }

 private:
  bool on_;
  std::string scenario_;
  int runs_ = 0, timings_ = 0;
};

// One scenario under all settings: its times are compared with each other, so that one machine measures them.
Unit unit_of(const SweepRequest& request, const scenario::Scenario& scenario) {
  return {fmt::format("{}/{}/{}", scenario.name, scenario.hash, fmt::join(request.asked, "/")),
          scenario.name};
}

}  // namespace

results::TradeTable sweep(const Context& context, const Sweep& plan, TradeJournal& journal,
                          const std::function<std::vector<study::Setting>()>& wanted) {
  study::SweepOptions how = plan.how;
  const auto reference = study::self_reference(plan.scenario, plan.ladder.samples, plan.rows, how.limits);
  const study::Yardstick yardstick(plan.scenario, plan.ladder.samples, reference);
  results::TradeTable table;
  if (yardstick.measures().empty()) {
    table.scenario = plan.scenario.name;
    return table;
  }
  if (!plan.observable.empty()) how.by = yardstick.find(plan.observable);
  journal.turn_to(plan.scenario, plan.ladder.samples);
  std::vector<study::Setting> settings = wanted();
  Progress progress(context.progress, plan.scenario.name);
  const auto step = [&](const study::Setting& setting, const results::TradePoint& point, bool timing) {
    progress(setting, point, timing);
  };
  table = study::sweep_errors(plan.scenario, yardstick, plan.ladder, settings, how, journal, step);
  study::sweep_times(table, plan.scenario, settings, how, journal, step);
  study::mark_front(table);
  return table;
}

int sweep_each(const Context& context, const SweepRequest& request,
               const std::function<results::TradeTable(const scenario::Scenario&, TradeJournal&)>& each,
               const std::function<void(const Selection&, const std::vector<results::TradeTable>&)>& done) {
  Request wanted;
  wanted.patterns = request.patterns;
  Selection selection = select_unprepared(context, wanted);
  if (selection.scenarios.empty()) {
    std::cerr << "nothing selected; see `cylon list --names`\n";
    return nothing_selected;
  }
  if (context.farm && request.timed)
    context.farm->require_own_cores(fmt::format("`cylon {}` measures times", request.command));
  const std::optional<Shard> shard = shard_asked(request.shard, context.farm);
  Part part{request.command, shard ? shard->index : 1, shard ? shard->count : 1, {}};
  for (const auto& scenario : selection.scenarios) part.units.push_back(unit_of(request, *scenario));
  const std::vector<bool> own = own_units(shard, part, request.resume);
  std::vector<Unit> units = part.units;
  keep(own, units), keep(own, selection.scenarios);
  std::optional<TimedCores> cores;
  if (request.timed && !context.farm && !units.empty())
    cores.emplace(shard ? TimedCores::Taken::wait : TimedCores::Taken::warn);
  TradeJournal journal(journal_file(request.command, shard), part, request.resume);
  if (shard && !journal.is_open())
    throw core::InputError("a shard is its journal, and there is none: nothing was run");
  if (request.resume && !(shard && shard->farm)) std::cerr << resumed(journal.known(), "run");
  std::vector<results::TradeTable> tables;
  std::vector<std::string> failed;                   // scenarios in which the harness itself failed
  std::optional<process::Interruptible> until_told;  // not while there is nothing to tell
  bool whole = true;
  const study::Next next = next_of(shard, units.size());
  while (const auto i = next()) try {
      const auto start = std::chrono::steady_clock::now();
      scenario::prepare(*selection.scenarios[*i]);
      if (!until_told) until_told.emplace();
      tables.push_back(each(*selection.scenarios[*i], journal));
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      journal.finish(units[*i], seconds.count());
    } catch (const process::Interrupted&) {
      whole = false;
      break;
    } catch (const core::InputError&) {
      throw;
    } catch (const std::exception& error) {  // no process, no memory
      if (shard && shard->farm) throw;
      failed.push_back(
          fmt::format("{}: the harness failed: {}", selection.scenarios[*i]->name, error.what()));
    }
  if (whole && shard && !journal.is_open()) return harness_failure;
  if (shard && shard->farm) return whole ? ok : interrupted;  // the leader writes the tables
  if (whole && shard && tables.empty() && failed.empty()) return ok;
  if ((whole && failed.empty()) || !tables.empty()) done(selection, tables);
  for (const std::string& line : failed) std::cerr << "error: " << plain_line(line) << '\n';
  if (!whole || !failed.empty()) {
    std::cerr
        << (whole ? "" : "interrupted: ")
        << "what is written holds the scenarios that are done; repeat the command with --resume in this "
           "folder to continue\n";
    return whole ? harness_failure : interrupted;
  }
  for (const results::TradeTable& table : tables)
    for (const results::TradeSeries& series : table.series)
      if (!series.points.empty()) return ok;
  std::cerr << "no engine that is asked for ran a scenario\n";
  return nothing_selected;
}

void write_tables(const Context& context, const Selection& selection,
                  const std::vector<results::TradeTable>& tables, const std::string& title,
                  const std::string& json, const std::string& html) {
  const auto document = reports::trade_json(tables, provenance_now(context));
  if (!json.empty())
    write_whole(json, document.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + '\n');
  if (html.empty()) return;
  reports::HtmlReport report;
  report.title = title;
  report.documents["trades"] = {document};
  for (const auto& scenario : selection.scenarios) report.scenarios.push_back(scenario_view(*scenario));
  write_whole(html, reports::to_html(std::move(report)));
}

}  // namespace cylon::cli
