#include "reports/html.h"

#include "reports/console.h"
#include "reports/gzip.h"
#include "reports/measured_tables.h"
#include "reports/steps_tables.h"
#include "reports/text.h"
#include "reports/verdict_matrix.h"
#include "reports/web_bundle.h"
#include "reports/xml.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <set>
#include <utility>

namespace cylon::reports {
namespace {

using Json = nlohmann::ordered_json;

Json shown(const std::optional<RunReport>& report) { return report ? document(*report) : Json(nullptr); }

std::string block(std::size_t number, std::string_view packed) {
  return fmt::format("<script type=\"application/gzip;base64\" id=\"block-{}\">{}</script>\n", number,
                     packed);
}

// Lines of a legend, whose entries are apart by "; ".
std::string in_one_line(std::string_view lines) {
  std::string out;
  for (const char c : lines.substr(0, lines.find_last_not_of('\n') + 1))
    out += c == '\n' ? "; " : std::string(1, c);
  return out;
}

// A scenario has a row of the matrix for each of its steps.
std::size_t scenarios_of(const std::vector<results::Verdict>& verdicts) {
  std::set<std::string_view> names;
  for (const results::Verdict& v : verdicts) names.insert(v.scenario);
  return names.size();
}

// For a reader without script; the script puts its own in this place.
std::string plain_matrix(const std::vector<results::Verdict>& verdicts, const Matrix& matrix) {
  const ConsoleOptions style;
  std::string out =
      fmt::format("<p>{}</p>\n<table><thead><tr><th scope=\"col\">scenario</th>", xml(summary(verdicts)));
  for (const std::string& engine : matrix.engines)
    out += fmt::format("<th scope=\"col\">{}</th>", xml(engine));
  out += "</tr></thead>\n<tbody>\n";
  for (std::size_t i = 0; i < matrix.scenarios.size(); ++i) {
    out += fmt::format("<tr><th scope=\"row\">{}</th>", xml(matrix.scenarios[i]));
    for (const Cell& cell : matrix.cells[i]) out += fmt::format("<td>{}</td>", xml(cell_text(cell, style)));
    out += "</tr>\n";
  }
  return out + fmt::format("</tbody></table>\n<p>{}</p>\n", xml(in_one_line(legend(matrix, style))));
}

// What has no table for a reader without script.
std::string needs_script(const std::map<std::string, Documents>& documents) {
  constexpr std::pair<const char*, const char*> parts[] = {{"trades", "the plots of speed against accuracy"},
                                                           {"comparisons", "the comparison of builds"},
                                                           {"histories", "the history of runs"},
                                                           {"hunts", "the faults that a hunt found"},
                                                           {"predictions", "the curves of measured motions"}};
  std::string out;
  for (const auto& [key, words] : parts)
    if (documents.contains(key)) out += fmt::format("{}{}", out.empty() ? "" : "; ", words);
  return out.empty() ? ""
                     : fmt::format(
                           "<noscript><p>This file also holds what needs scripts to be shown, and this "
                           "browser runs none: {}.</p></noscript>\n",
                           out);
}

}  // namespace

std::string to_html(HtmlReport report) {
  const std::vector<results::Verdict> none;
  const std::vector<results::Verdict>& verdicts = report.results ? report.results->verdicts : none;
  const Matrix matrix = fold(verdicts);
  const std::string heading =
      !report.title.empty() ? report.title
      : verdicts.empty()    ? "Cylon report"
                            : fmt::format("Cylon: {} on {}", counted(scenarios_of(verdicts), "scenario"),
                                          counted(matrix.engines.size(), "engine"));
  Json entries = Json::array();
  std::string blocks;
  std::size_t number = 0, used = 0, left_out = 0;
  for (const PackedTrace& trace : report.traces) {
    if (used + trace.block.size() > trace_budget) {
      ++left_out;
      continue;
    }
    used += trace.block.size();
    entries.push_back({{"scenario", trace.scenario},
                       {"engine", trace.engine},
                       {"integrator", trace.integrator},
                       {"dt_text", trace.dt_text},
                       {"block", ++number}});
    blocks += block(number, trace.block);
  }
  std::string omitted = report.omitted_traces;
  if (left_out > 0)
    omitted += fmt::format("{}{} more {} left out to limit the size of this file",
                           omitted.empty() ? "" : "; ", left_out, left_out == 1 ? "was" : "were");

  Json index = {{"kind", "report"},     {"title", heading},  {"results", nullptr},
                {"scenarios", nullptr}, {"traces", entries}, {"omitted_traces", omitted},
                {"baseline", nullptr}};
  for (const Section& section : sections) index[section.key] = Json::array();
  // Moved in, because they may take much memory, and last, because an object that grows copies its values.
  const std::string steps = steps_tables(report.documents), tables = measured_tables(report.documents),
                    rest = needs_script(report.documents);
  index["results"] = shown(report.results);
  index["scenarios"] = std::move(report.scenarios);
  index["baseline"] = shown(report.baseline);
  for (auto& [key, given] : report.documents) index[key] = std::move(given);
  std::string text = index.dump(-1, ' ', /*ensure_ascii=*/true, Json::error_handler_t::replace);
  index = nullptr;
  const std::string packed = base64(gzip(std::exchange(text, {})));
  const std::string title = xml(heading);

  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\" data-page=\"report\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src '{}'; "
      "style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'\">\n"
      "<title>{}</title>\n<style>",
      web::script_hash(), title);
  page += web::style();
  page += fmt::format("</style>\n</head>\n<body>\n<div id=\"app\">\n<h1>{}</h1>\n", title);
  page += steps;
  if (!verdicts.empty()) page += plain_matrix(verdicts, matrix);
  page += tables + rest + "</div>\n" + block(0, packed) + blocks + "<script>";
  page += web::script();
  page += "</script>\n</body>\n</html>\n";
  return page;
}

}  // namespace cylon::reports
