#include "reports/steps_tables.h"

#include "harness/results/substeps.h"
#include "reports/plain_tables.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

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
  return results::with_substeps(fmt::format("{:.3g} s", value.get<double>()),
                                substeps.is_number_integer() ? substeps.get<int>() : 1);
}

std::string row(const Json& table, const Json& cell) {
  const Json& series = entry(part(table, "series"), part(cell, "series"));
  std::string out = fmt::format("<tr><th scope=\"row\">{}</th>", text(series, "engine"));
  const Json& refusal = part(cell, "refusal");
  if (refusal.is_string() && !refusal.get_ref<const std::string&>().empty())
    return out + fmt::format("<td>refused: {}</td></tr>\n", text(cell, "refusal"));
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

}  // namespace

std::string steps_tables(const std::map<std::string, std::vector<Json>>& documents) {
  const auto given = documents.find("trades");
  if (given == documents.end()) return "";
  std::string out;
  std::size_t rows = 0;
  for (const Json& document : given->second)
    for (const Json& table : part(document, "tables")) {
      if (!part(table, "cells").is_array() || part(table, "cells").empty()) continue;
      if (rows >= most_rows) break;
      out += fmt::format("<table><caption>{}</caption>\n<tbody>\n", text(table, "scenario"));
      for (const Json& cell : table["cells"])
        if (++rows <= most_rows) out += row(table, cell);
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
