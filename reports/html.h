// The report that people look at: one file that opens from disk, without a network.
#pragma once

#include "reports/json.h"
#include "reports/trace_block.h"

#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::reports {

using Documents = std::vector<nlohmann::ordered_json>;

/// A part of the page that shows documents of another command as they are; `key` is that of the page's index.
struct Section {
  const char *key, *written_by;
  bool (*holds)(const nlohmann::ordered_json& document);
};
inline constexpr std::array sections = {
    Section{"trades", "cylon trade --json",
            [](const auto& json) { return json.contains("format") && json["format"] == "cylon-trade/1"; }},
    Section{"comparisons", "cylon track compare --json",
            [](const auto& json) { return json.contains("cells") && json.contains("candidate"); }},
    Section{"histories", "cylon track history --json",
            [](const auto& json) { return json.contains("series"); }},
    Section{"hunts", "cylon hunt --json",
            [](const auto& json) { return json.contains("format") && json["format"] == "cylon-hunt/1"; }},
    Section{
        "predictions", "cylon predict --json",
        [](const auto& json) { return json.contains("format") && json["format"] == "cylon-prediction/1"; }},
    Section{"fits", "cylon fit --json",
            [](const auto& json) { return json.contains("format") && json["format"] == "cylon-fit/1"; }},
};

/// What a report shows.
struct HtmlReport {
  std::string title;                           ///< "": how many scenarios and engines there are.
  std::optional<RunReport> results;            ///< Of the run.
  std::optional<RunReport> baseline;           ///< Of an earlier run, to say what changed.
  Documents scenarios;                         ///< What they are about (`ScenarioView` of documents.ts).
  std::vector<PackedTrace> traces;             ///< In the order in which space is given to them.
  std::string omitted_traces;                  ///< Why some runs have none, a sentence; "": all have.
  std::map<std::string, Documents> documents;  ///< By the key of their section.
};

/// Most that the traces of a report may take [bytes]: what is mailed stays under 15 MB.
inline constexpr std::size_t trace_budget = std::size_t{12} << 20;

/// The whole page.  Traces beyond the budget are left out and counted in the page.  The matrix of steps, then that of the
/// verdicts, and the scores of measured motions stand in it as plain tables too, for a reader without script.  The same report
/// gives the same bytes.
std::string to_html(HtmlReport);

}  // namespace cylon::reports
