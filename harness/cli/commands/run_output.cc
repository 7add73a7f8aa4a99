#include "harness/cli/commands/run_output.h"

#include "harness/cli/commands/published.h"
#include "harness/cli/output.h"
#include "harness/cli/scenario_view.h"
#include "harness/results/duration.h"
#include "reports/error_plot.h"
#include "reports/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <ostream>
#include <utility>

namespace cylon::cli {

namespace fs = std::filesystem;
using results::Verdict;

int exit_code(const std::vector<Verdict>& rows, bool published_differs) {
  // A worker that could not be had, or that broke where nobody expected it, is the harness's failure; the
  // engine's own misbehaviour is a verdict that differs.
  const auto broken = [](const Verdict& row) {
    const bool absent = row.status == results::Status::unsupported && row.version.empty();
    return !row.as_expected() &&
           (absent || row.status == results::Status::crash || row.status == results::Status::protocol ||
            row.status == results::Status::timeout);
  };
  if (std::any_of(rows.begin(), rows.end(), broken)) return harness_failure;
  return published_differs || !std::ranges::all_of(rows, &Verdict::as_expected) ? differs : ok;
}

void print(const Context& context, const RunOptions& options, const std::vector<Verdict>& rows,
           std::size_t cells) {
  const reports::ConsoleOptions style{.width = context.width, .utf8 = context.utf8, .colour = context.colour};
  if (options.verbose || (cells == 1 && !options.brief))
    std::cout << reports::console_details(rows, style) << '\n';
  std::cout << (options.brief ? reports::console_summary(rows, style) : reports::console_matrix(rows, style));
}

bool print_published(const scenario::Suite& suite, const std::vector<Verdict>& rows, bool quiet) {
  const Reproduction reproduction = reproduce(suite, rows);
  if (!quiet) std::cout << reproduction.text;
  return !reproduction.complete;
}

void write_report(const RunOptions& options, const Selection& selection, const Traces& traces,
                  reports::RunReport results) {
  if (options.html.empty() && options.traces.empty()) return;
  reports::HtmlReport report;
  for (const auto& scenario : selection.scenarios) report.scenarios.push_back(scenario_view(*scenario));
  report.traces =
      traces.chosen(selection.cells, results.verdicts, options.trajectories, report.omitted_traces);
  report.results = std::move(results);
  if (!options.traces.empty())
    write_whole(options.traces, [&](std::ostream& out) {
      for (const auto& scenario : report.scenarios)
        out << scenario.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) << '\n';
      for (const reports::PackedTrace& trace : report.traces) out << reports::to_json_line(trace);
    });
  if (!options.html.empty()) write_whole(options.html, reports::to_html(std::move(report)));
}

void print_charts(const Traces& traces, const reports::ConsoleOptions& style) {
  for (const reports::Trace& trace : traces.errors()) {
    if (trace.errors.empty()) continue;
    std::cout << reports::shown(fmt::format("{} on {}, {}, step {}", trace.scenario, trace.engine,
                                            trace.integrator, results::step_in_words(trace.dt_text)),
                                style)
              << "\n\n";
    for (const reports::ErrorCurve& curve : trace.errors)
      std::cout << reports::error_chart(curve, style) << '\n';
  }
}

void write_plots(const std::string& folder, const Traces& traces) {
  std::map<std::string, std::vector<const reports::Trace*>> by_scenario;
  for (const reports::Trace& trace : traces.errors())
    if (!trace.errors.empty()) by_scenario[trace.scenario].push_back(&trace);
  for (const auto& [scenario, runs] : by_scenario) {
    const reports::Plot plot = reports::error_plot(runs);
    if (!plot.curves.empty())
      write_whole((fs::path(folder) / fmt::format("errors-{}.svg", scenario)).string(),
                  reports::to_svg(plot));
  }
}

}  // namespace cylon::cli
