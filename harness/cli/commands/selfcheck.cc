// cylon selfcheck
#include "harness/study/selfcheck.h"
#include "harness/scenario/input.h"

#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/options.h"
#include "harness/cli/selection.h"
#include "harness/process/interruption.h"
#include "harness/scenario/glob.h"
#include "harness/study/cell_pool.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace cylon::cli {
namespace {

using nlohmann::ordered_json;
using study::Reproduction;

// The published rows of a suite, which name an engine and a step each, against the suite's own cells.
std::vector<Reproduction> of_suite(const Selection& selection) {
  const study::Pool pool{.workers = worker_count(0), .limits = {}};
  const study::Matrix matrix = study::run(selection.cells, pool, {}, {});
  if (matrix.interrupted) throw process::Interrupted();
  const auto& cells = matrix.rows;
  std::vector<Reproduction> rows;
  for (const auto& published : selection.suite.published)
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const study::Cell& cell = selection.cells[i];
      if (cell.engine.id != published.engine || cell.dt != scenario::parse_step(published.dt)) continue;
      for (const results::Verdict& verdict : cells[i])
        if (scenario::glob_match(selection.suite.claim, verdict.claim))
          rows.push_back({published.source,
                          fmt::format("{}, {}, dt {}", verdict.claim, published.engine, published.dt),
                          published.value, verdict.measured, study::last_digit(published.value), ""});
    }
  return rows;
}

std::string text(const std::vector<Reproduction>& rows) {
  std::size_t width = 0;
  for (const Reproduction& row : rows) width = std::max(width, row.what.size());
  std::string out, source;
  for (const Reproduction& row : rows) {
    if (row.source != source) out += fmt::format("{}{}\n", out.empty() ? "" : "\n", source = row.source);
    out += fmt::format("  {:{}}  {:>15}  {:>17.12g}  {:>8.1g}  {}\n", row.what, width, row.published,
                       row.here, row.difference(), row.reproduced() ? "reproduced" : "DIFFERS");
    if (!row.explanation.empty()) out += fmt::format("    {}\n", row.explanation);
  }
  return fmt::format("{:{}}  {:>15}  {:>17}  {:>8}\n", "", width + 2, "published", "here", "apart") + out;
}

ordered_json to_json(const Reproduction& row) {
  return {{"source", row.source},           {"what", row.what},
          {"published", row.published},     {"here", row.here},
          {"difference", row.difference()}, {"within", row.within},
          {"reproduced", row.reproduced()}, {"explanation", row.explanation}};
}

int selfcheck(const Context& context, bool json) {
  Request request;
  request.suite = "simbenchmark";
  const Selection selection = select(context, request);
  const process::Interruptible until_told;
  std::vector<Reproduction> rows = of_suite(selection);
  try {
    const auto others = study::published_numbers([&](const std::string& id) {
      return study::worker_runner(process::parse_engine(id, context.engines), {});
    });
    rows.insert(rows.end(), others.begin(), others.end());
  } catch (const study::RunFailed& failed) {
    std::cerr << plain_line(fmt::format("{} {}: {}", failed.outcome.engine.name,
                                        results::name(failed.outcome.status), failed.outcome.reason))
              << '\n';
    return harness_failure;
  }
  const auto count = [&](auto&& what) { return std::count_if(rows.begin(), rows.end(), what); };
  const auto reproduced = count([](const Reproduction&row) { return row.reproduced(); }),
             as_explained = count([](const Reproduction&row) { return row.as_explained(); }),
             all = static_cast<std::ptrdiff_t>(rows.size());
  if (json) {
    ordered_json out = ordered_json::array();
    for (const Reproduction& row : rows) out.push_back(to_json(row));
    std::cout << out.dump(2, ' ', true) << '\n';
  } else {
    std::cout
        << plain(text(rows))
        << fmt::format(
               "\n"
               "{} published numbers: {} reproduced, {} differ with a known reason, {} differ without\n",
               all, reproduced, as_explained - count([](const Reproduction& row) {
                                  return row.reproduced() && row.as_explained();
                                }),
               all - as_explained);
  }
  return as_explained == all ? ok : differs;
}

}  // namespace

Command add_selfcheck(App& app, const Context& context) {
  const auto json = std::make_shared<bool>(false);
  app.add_flag("--json", *json, "As JSON");
  return [=, &context] { return selfcheck(context, *json); };
}

}  // namespace cylon::cli
