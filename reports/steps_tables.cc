#include "reports/steps_tables.h"

#include "harness/results/duration.h"
#include "harness/results/substeps.h"
#include "reports/plain_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>

namespace cylon::reports {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_errors = 10;  // of a row

// An entry of an array by an index that the document names; null where there is none.
const Json& entry(const Json& array, const Json& index) {
  static const Json none;
  if (!array.is_array() || !index.is_number_integer()) return none;
  const auto at = index.get<std::int64_t>();
  return at < 0 || static_cast<std::size_t>(at) >= array.size() ? none : array[static_cast<std::size_t>(at)];
}

std::string step(const Json& series, const Json& reach) {
  if (part(reach, "point").is_null()) return "not reached";
  if (part(series, "closed_form") == true) return "no steps";
  const Json& point = entry(part(series, "points"), part(reach, "point"));
  const bool adaptive = part(series, "adaptive") == true;
  const Json& value = part(point, adaptive ? "tolerance" : "dt");
  if (!value.is_number()) return "?";
  if (adaptive) return fmt::format("tolerance {:.2g}", value.get<double>());
  const Json& substeps = part(series, "substeps");
  return results::with_substeps(results::duration(value.get<double>(), 2),
                                substeps.is_number_integer() ? substeps.get<int>() : 1);
}

// Cells of a row beside its engine: errors, then the reason of the first that is not reached.
std::size_t width(const Json& table) {
  std::size_t most = 0;
  for (const Json& cell : part(table, "cells"))
    if (const Json& reach = part(cell, "reach"); reach.is_array()) most = std::max(most, reach.size());
  return std::min(most, most_errors) + 1;
}

std::string row(const Json& table, const Json& cell, std::size_t width) {
  const Json& series = entry(part(table, "series"), part(cell, "series"));
  std::string out = fmt::format("<tr><th scope=\"row\">{}</th>", text(series, "engine"));
  const Json& refusal = part(cell, "refusal");
  if (refusal.is_string() && !refusal.get_ref<const std::string&>().empty())
    return out + fmt::format("<td colspan=\"{}\">refused: {}</td></tr>\n", width, text(cell, "refusal"));
  std::size_t errors = 0;
  std::string why;  // of the first that is not reached
  for (const Json& reach : part(cell, "reach")) {
    if (++errors > most_errors) break;
    const Json& error = part(reach, "error");
    out += fmt::format("<td>{}: {}</td>",
                       error.is_number() ? fmt::format("{:.0e}", error.get<double>()) : std::string("?"),
                       step(series, reach));
    if (why.empty() && part(reach, "point").is_null()) why = text(reach, "why");
  }
  return out + fmt::format("<td>{}</td></tr>\n", why);
}

bool has_rows(const Json& table) { return part(table, "cells").is_array() && !part(table, "cells").empty(); }

// "cylon matrix", "cylon trade"; "" where the command line does not say.
std::string command(const Json& document) {
  const Json& line = part(part(document, "provenance"), "command_line");
  if (!line.is_string()) return "";
  const std::string words = line.get<std::string>() + ' ';
  for (const char* name : {"matrix", "trade"})
    if (words.find(fmt::format(" {} ", name)) != std::string::npos) return fmt::format("cylon {}", name);
  return "";
}

// What tells sweeps of one scenario apart, as on the page with script: " of cylon trade", with the number of the
// file where the commands are the same; "" for the only sweep.
class Sources {
 public:
  explicit Sources(const std::vector<Json>& documents) {
    for (const Json& document : documents) {
      for (const Json& table : part(document, "tables"))
        if (has_rows(table)) files_[text(table, "scenario")].insert(commands_.size());
      commands_.push_back(command(document));
    }
  }

  std::string of(std::size_t file, const std::string& scenario) const {
    const std::set<std::size_t>& files = files_.at(scenario);
    if (files.size() == 1) return "";
    const std::string& made_by = commands_[file];
    const auto same = std::ranges::count_if(files, [&](std::size_t f) { return commands_[f] == made_by; });
    if (!made_by.empty() && same == 1) return " of " + made_by;
    return fmt::format(" of {} ({})", made_by.empty() ? "file" : made_by, file + 1);
  }

 private:
  std::vector<std::string> commands_;
  std::map<std::string, std::set<std::size_t>> files_;  // by scenario
};

}  // namespace

std::string steps_tables(const std::map<std::string, std::vector<Json>>& documents) {
  const auto given = documents.find("trades");
  if (given == documents.end()) return "";
  const Sources sources(given->second);
  std::string out;
  std::size_t rows = 0;
  for (std::size_t file = 0; file < given->second.size(); ++file)
    for (const Json& table : part(given->second[file], "tables")) {
      if (!has_rows(table)) continue;
      if (rows >= most_rows) break;
      const std::string scenario = text(table, "scenario");
      out += fmt::format("<table><caption>{}{}</caption>\n<tbody>\n", scenario, sources.of(file, scenario));
      const std::size_t wide = width(table);
      for (const Json& cell : table["cells"])
        if (++rows <= most_rows) out += row(table, cell, wide);
      out += "</tbody></table>\n";
    }
  if (out.empty()) return "";
  if (rows > most_rows)
    out += fmt::format("<p>The first {} rows; the document has the others.</p>\n", most_rows);
  return "<h2>Which step an engine needs</h2>\n<p>The coarsest step that meets a relative error, as the next "
         "finer one does.</p>\n" +
         out;
}

}  // namespace cylon::reports
