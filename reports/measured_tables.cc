#include "reports/measured_tables.h"

#include "reports/plain_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace cylon::reports {
namespace {

using Json = nlohmann::ordered_json;

// After `rows` rows that there are to show.
std::string end_table(std::size_t rows) {
  const bool cut = rows > most_rows;
  return fmt::format(
      "</tbody></table>\n{}",
      cut ? fmt::format("<p>The first {} rows; the document has the others.</p>\n", most_rows) : "");
}

std::string number(const Json& value, double scale, int digits) {
  return value.is_number() ? fmt::format("{:.{}g}", scale * value.get<double>(), digits) : "?";
}

std::string with_interval(const Json& value, const Json& low, const Json& high, double scale = 1,
                          int digits = 4) {
  if (!value.is_number()) return "not known";
  const std::string shown = number(value, scale, digits);
  if (!low.is_number()) return shown;
  return fmt::format("{} [{}, {}]", shown, number(low, scale, digits), number(high, scale, digits));
}

// A time that is null where a prediction holds to the end of the data.
std::string until(const Json& time, double /*scale*/) {
  const auto one = [](const Json& t) { return t.is_number() ? number(t, 1, 3) : std::string("the end"); };
  return fmt::format("{} [{}, {}]", one(part(time, "value")), one(part(time, "low")),
                     one(part(time, "high")));
}

std::string estimate(const Json& of, double scale) {
  return with_interval(part(of, "value"), part(of, "low"), part(of, "high"), scale, 3);
}

// A column of an engine's scores.
struct Column {
  const char *key, *head;
  std::string (*cell)(const Json& score, double scale);
  double scale = 1;
};

constexpr double degrees = 180 / std::numbers::pi;

constexpr Column free_columns[] = {{"distance", "rest, distance [mm]", estimate, 1000.0},
                                   {"angle", "rest, angle [deg]", estimate, degrees},
                                   {"same_side", "same side up [%]", estimate, 100.0},
                                   {"impact", "first touch, off by [ms]", estimate, 1000.0},
                                   {"place", "its place, off by [mm]", estimate, 1000.0},
                                   {"loss", "energy lost, off by [%]", estimate, 100.0},
                                   {"covered", "inside the band [%]", estimate, 100.0}};
constexpr Column chain_columns[] = {{"held", "within 0.1 rad for [s]", until},
                                    {"expected", "by the start alone [s]", until},
                                    {"exponent", "exponent [1/s]", estimate, 1.0},
                                    {"covered", "inside the band [%]", estimate, 100.0}};

std::string begin_table(const std::string& caption, std::span<const std::string> columns) {
  std::string out = fmt::format("<table><caption>{}</caption><thead><tr>", caption);
  for (const std::string& column : columns) out += fmt::format("<th scope=\"col\">{}</th>", column);
  return out + "</tr></thead>\n<tbody>\n";
}

// Whether places and velocities of the data go together.
std::string columns_against(const Json& document, bool chain) {
  std::string out;
  const auto pair = [&](const char* key, const char* what, const char* of) {
    const Json& slope = part(part(document, "kinematics"), key);
    if (!part(slope, "value").is_number()) return;
    out += fmt::format("{}{} {} of {}{}", out.empty() ? "" : "; ", what, estimate(slope, 1), of,
                       part(slope, "goes_together") == "no"
                           ? ": <strong>they do not go together; check columns, units, axes and rate</strong>"
                           : "");
  };
  pair("velocity", "positions", "velocities");
  pair("spin", chain ? "angles" : "orientations", chain ? "rates" : "angular velocities");
  return out.empty()
             ? out
             : fmt::format(
                   "<p>Columns against each other, steps from frame to frame over velocities: {}.</p>\n",
                   out);
}

std::string scores(const Json& document) {
  const bool chain = part(document, "coordinates") == "chain";
  const std::span<const Column> columns =
      chain ? std::span<const Column>(chain_columns) : std::span<const Column>(free_columns);
  std::vector<std::string> heads = {"engine"};
  for (const Column& column : columns) heads.emplace_back(column.head);
  heads.emplace_back("90 to 98 %");
  std::string out = columns_against(document, chain) +
                    begin_table(part(document, "fitted") == true ? "Predicted, with fitted parameters"
                                                                 : "Predicted, with the model's own values",
                                heads);
  std::size_t rows = 0;
  for (const Json& engine : part(document, "engines")) {
    if (++rows > most_rows) break;
    out += fmt::format("<tr><th scope=\"row\">{}</th>", text(engine, "engine"));
    for (const Column& column : columns)
      out += fmt::format("<td>{}</td>", column.cell(part(engine, column.key), column.scale));
    out += fmt::format("<td>{}</td></tr>\n", text(engine, "band"));
  }
  return out + end_table(rows);
}

std::string parameters(const Json& document) {
  const std::string heads[] = {"engine", "parameter", "value, if the uncertainties are right",
                               "between runs"};
  std::string out = begin_table("Fitted", heads);
  std::size_t rows = 0;
  for (const Json& fit : part(document, "fits"))
    for (const Json& p : part(fit, "parameters")) {
      if (++rows > most_rows) break;
      out += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n", text(fit, "engine"),
          text(p, "name"), with_interval(part(p, "value"), part(p, "low"), part(p, "high")),
          with_interval(part(p, "value"), part(p, "low_between_runs"), part(p, "high_between_runs")));
    }
  return out + end_table(rows);
}

}  // namespace

std::string measured_tables(const std::map<std::string, std::vector<Json>>& documents) {
  std::string out;
  using Table = std::string (*)(const Json&);
  constexpr std::pair<const char*, Table> tables[] = {{"predictions", scores}, {"fits", parameters}};
  for (const auto& [key, table] : tables)
    if (const auto given = documents.find(key); given != documents.end())
      for (const Json& document : given->second)
        out += fmt::format("<h2>{}</h2>\n<p>{} Licence: {}</p>\n", text(document, "title"),
                           text(document, "source"), text(document, "licence")) +
               table(document);
  return out;
}

}  // namespace cylon::reports
