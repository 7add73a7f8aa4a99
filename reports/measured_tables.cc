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

std::string with_interval(const Json& value, const Json& low, const Json& high) {
  constexpr int digits = 4;
  if (!value.is_number()) return "not known";
  const std::string shown = number(value, 1, digits);
  if (!low.is_number()) return shown;
  return fmt::format("{} [{}, {}]", shown, number(low, 1, digits), number(high, 1, digits));
}

// A column of an engine's scores, with as many decimals as the page with script has.
struct Column {
  const char *key, *head;
  double scale;
  int decimals;
  const char* missing = "not known";  // of a number that is null
};

// Of too few runs there is a value without an interval.
std::string estimate(const Json& of, const Column& column) {
  const Json &value = part(of, "value"), &low = part(of, "low"), &high = part(of, "high");
  if (value.is_null() && part(of, "runs") == 0) return "not known";
  const auto one = [&](const Json& x) {
    return x.is_number() ? fmt::format("{:.{}f}", column.scale * x.get<double>(), column.decimals)
                         : std::string(column.missing);
  };
  if (!low.is_number() && !high.is_number()) return one(value);
  return fmt::format("{} [{}, {}]", one(value), one(low), one(high));
}

constexpr double degrees = 180 / std::numbers::pi;

constexpr Column free_columns[] = {
    {"distance", "rest, distance [mm]", 1000, 1}, {"angle", "rest, angle [deg]", degrees, 1},
    {"same_side", "same side up [%]", 100, 1},    {"impact", "first touch, off by [ms]", 1000, 2},
    {"place", "its place, off by [mm]", 1000, 1}, {"loss", "energy lost, off by [%]", 100, 1}};
constexpr Column chain_columns[] = {{"held", "within 0.1 rad for [s]", 1, 3, "the end"},
                                    {"expected", "by the start alone [s]", 1, 3, "the end"},
                                    {"exponent", "exponent [1/s]", 1, 2}};
constexpr Column covered{"covered", "inside the band [%]", 100, 1}, slope{"", "", 1, 4};

std::string begin_table(const std::string& caption, std::span<const std::string> columns) {
  std::string out = fmt::format("<table><caption>{}</caption><thead><tr>", caption);
  for (const std::string& column : columns) out += fmt::format("<th scope=\"col\">{}</th>", column);
  return out + "</tr></thead>\n<tbody>\n";
}

// Whether places and velocities of the data go together.
std::string columns_against(const Json& document, bool chain) {
  std::string out;
  const auto pair = [&](const char* key, const char* what, const char* of) {
    const Json& found = part(part(document, "kinematics"), key);
    if (!part(found, "value").is_number()) return;
    out += fmt::format("{}{} {} of {}{}", out.empty() ? "" : "; ", what, estimate(found, slope), of,
                       part(found, "goes_together") == "no"
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
  const std::span<const Column> of_motion =
      chain ? std::span<const Column>(chain_columns) : std::span<const Column>(free_columns);
  std::vector<Column> columns(of_motion.begin(), of_motion.end());
  const bool band = part(document, "members") != 0;
  if (band) columns.push_back(covered);
  std::vector<std::string> heads = {"engine"};
  for (const Column& column : columns) heads.emplace_back(column.head);
  if (band) heads.emplace_back("90 to 98 %");
  std::string out = columns_against(document, chain) +
                    begin_table(part(document, "fitted") == true ? "Predicted, with fitted parameters"
                                                                 : "Predicted, with the model's own values",
                                heads);
  std::size_t rows = 0;
  for (const Json& engine : part(document, "engines")) {
    if (++rows > most_rows) break;
    out += fmt::format("<tr><th scope=\"row\">{}</th>", text(engine, "engine"));
    const Json& failed = part(engine, "failed");
    if (failed.is_number_integer() && failed != 0 && failed == part(engine, "runs")) {
      out += fmt::format("<td colspan=\"{}\">no prediction: {}</td></tr>\n", heads.size() - 1,
                         text(engine, "first_failure"));
      continue;
    }
    for (const Column& column : columns)
      out += fmt::format("<td>{}</td>", estimate(part(engine, column.key), column));
    out += band ? fmt::format("<td>{}</td></tr>\n", text(engine, "band")) : "</tr>\n";
  }
  return out + end_table(rows);
}

// An engine without parameters says why.
std::string no_fit(const Json& fit) {
  const Json& failure = part(fit, "failure");
  if (!failure.is_string() || failure.get_ref<const std::string&>().empty()) return "";
  return fmt::format("<tr><th scope=\"row\">{}</th><td colspan=\"3\">no fit: {}</td></tr>\n",
                     text(fit, "engine"), text(fit, "failure"));
}

std::string parameters(const Json& document) {
  const std::string heads[] = {"engine", "parameter", "value, if the uncertainties are right",
                               "between runs"};
  std::string out = begin_table("Fitted", heads);
  std::size_t rows = 0;
  for (const Json& fit : part(document, "fits")) {
    if (const std::string row = no_fit(fit); !row.empty() && ++rows <= most_rows) out += row;
    for (const Json& p : part(fit, "parameters")) {
      if (++rows > most_rows) break;
      out += fmt::format(
          "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n", text(fit, "engine"),
          text(p, "name"), with_interval(part(p, "value"), part(p, "low"), part(p, "high")),
          with_interval(part(p, "value"), part(p, "low_between_runs"), part(p, "high_between_runs")));
    }
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
