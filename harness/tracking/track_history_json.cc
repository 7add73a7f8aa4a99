#include "harness/tracking/track_history_text.h"
#include "reports/json.h"

#include <nlohmann/json.hpp>

namespace cylon::tracking {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* scale_names[] = {"ratio", "absolute", "value", "text"};

Json points(const HistoryRow& row) {
  Json all = Json::array();
  for (const HistoryPoint& p : row.points) {
    Json one = {{"run", p.run}, {"revision", p.revision}, {"date", p.date}, {"version", p.version}};
    if (row.scale == Scale::text)
      one["text"] = p.text;
    else
      one["value"] = reports::number(p.value);
    all.push_back(std::move(one));
  }
  return all;
}

Json changes(const HistoryRow& row) {
  Json all = Json::array();
  for (const HistoryChange& c : row.changes) {
    Json one = {{"id", c.id},
                {"index", c.index},
                {"run", row.points[c.index].run},
                {"revision", row.points[c.index].revision},
                {"outcome", statistics::name(c.outcome)},
                {"state", c.state},
                {"note", c.note},
                {"found", c.found},
                {"sentence", c.sentence}};
    if (c.ratio) {
      one["ratio"] = *c.ratio;
      one["ratio_low"] = reports::number(c.interval.low);
      one["ratio_high"] = reports::number(c.interval.high);
      one["p"] = c.p;
    }
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

std::string history_json(const std::vector<HistoryRow>& rows) {
  Json series = Json::array();
  for (const HistoryRow& row : rows)
    series.push_back({{"series", row.series},
                      {"cell", row.cell.name()},
                      {"scenario", row.cell.scenario},
                      {"scenario_hash", row.cell.scenario_hash},
                      {"engine", row.cell.engine},
                      {"dt", row.cell.dt},
                      {"metric", row.metric.name},
                      {"kind", store::name(row.metric.kind)},
                      {"unit", row.metric.unit},
                      {"scale", scale_names[static_cast<std::size_t>(row.scale)]},
                      {"points", points(row)},
                      {"versions", row.versions},
                      {"changes", changes(row)}});
  return Json({{"schema", 1}, {"series", series}}).dump(1, ' ', true) + "\n";
}

}  // namespace cylon::tracking
