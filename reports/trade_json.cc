#include "reports/csv.h"
#include "reports/json.h"
#include "reports/step_matrix.h"
#include "reports/trade_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace cylon::reports {
namespace {

using Json = nlohmann::ordered_json;
using results::TradePoint;
using results::TradeSeries;
using results::TradeTable;

// A run of a sweep is measured and not judged.
std::string_view ending(const TradePoint& point) {
  return point.status == results::Status::pass ? "ran" : results::name(point.status);
}

double per_body_step(const TradeTable& table, const TradePoint& p) {
  return p.step_seconds / static_cast<double>(p.steps * std::max<std::int64_t>(1, table.bodies));
}

Json to_object(const TradeTable& table, const TradePoint& point) {
  Json errors = Json::object();
  for (std::size_t i = 0; i < point.errors.size(); ++i)
    errors[table.measures[i].name] = number(point.errors[i]);
  return {
      {"steps", point.steps},     {"dt", point.dt},
      {"dt_text", point.dt_text}, {"tolerance", point.tolerance > 0 ? Json(point.tolerance) : Json(nullptr)},
      {"status", ending(point)},  {"reason", point.reason},
      {"errors", errors}};
}

Json to_object(const TradeTable& table, const TradeSeries& series) {
  Json points = Json::array();
  for (const TradePoint& point : series.points) points.push_back(to_object(table, point));
  return {{"engine", series.engine},
          {"integrator", series.integrator},
          {"version", series.version},
          {"precision", series.precision},
          {"path", series.path},
          {"gyroscopic", series.gyroscopic},
          {"adaptive", series.adaptive},
          {"closed_form", series.closed_form},
          {"substeps", series.substeps},
          {"declared_order", series.declared},
          {"observed_order", number(series.order)},
          {"floor", number(series.floor)},
          {"floor_from", std::isfinite(series.floor) ? Json(series.floor_from) : Json(nullptr)},
          {"floor_is_rounding", series.rounding},
          {"reason", series.reason},
          {"points", points}};
}

Json to_object(const TradeTable& table) {
  Json measures = Json::array(), series = Json::array();
  for (const results::TradeMeasure& m : table.measures)
    measures.push_back({{"name", m.name},
                        {"unit", m.unit},
                        {"scale", m.scale > 0 ? Json(m.scale) : Json(nullptr)},
                        {"against", m.against},
                        {"resolution", m.resolution}});
  for (const TradeSeries& s : table.series) series.push_back(to_object(table, s));
  return {{"scenario", table.scenario},
          {"scenario_hash", table.scenario_hash},
          {"duration", table.duration},
          {"bodies", table.bodies},
          {"truth", table.truth},
          {"samples", table.samples},
          {"by", table.measures.empty() ? Json(nullptr) : Json(table.measures[table.by].name)},
          {"measures", measures},
          {"series", series},
          {"cells", steps_json(table)}};
}

void add_times(const TradeTable& table, Json& times) {
  for (const TradeSeries& series : table.series)
    for (const TradePoint& p : series.points)
      times.push_back({{"scenario", table.scenario},
                       {"engine", series.engine},
                       {"integrator", series.integrator},
                       {"dt_text", p.dt_text},
                       {"tolerance", p.tolerance > 0 ? Json(p.tolerance) : Json(nullptr)},
                       {"step_seconds", number(p.step_seconds)},
                       {"load_seconds", number(p.load_seconds)},
                       {"cpu_seconds_per_second", number(p.cost)},
                       {"seconds_per_body_step", number(per_body_step(table, p))},
                       {"on_front", p.on_front},
                       {"dominated_by", p.dominated_by}});
}

std::string real(double value) { return std::isfinite(value) ? fmt::format("{:.17g}", value) : ""; }

}  // namespace

Json trade_json(const std::vector<TradeTable>& tables, const Provenance& p) {
  Json all = Json::array(), times = Json::array();
  for (const TradeTable& table : tables) {
    all.push_back(to_object(table));
    add_times(table, times);
  }
  Json provenance = provenance_json(p);
  provenance.erase("tolerance_scale");
  return {{"format", "cylon-trade/1"}, {"provenance", provenance}, {"tables", all}, {"times", times}};
}

std::string trade_csv(const std::vector<TradeTable>& tables) {
  std::vector<std::string> names;
  for (const TradeTable& table : tables)
    for (const results::TradeMeasure& m : table.measures)
      if (std::find(names.begin(), names.end(), m.name) == names.end()) names.push_back(m.name);
  std::string out =
      "scenario,engine,integrator,version,precision,path,gyroscopic,declared_order,observed_order,steps,dt,"
      "dt_text,substeps,tolerance,status,reason";
  for (const std::string& name : names) out += ",error_" + name;
  out += ",step_seconds,load_seconds,cpu_seconds_per_second,seconds_per_body_step,on_front,dominated_by\r\n";
  for (const TradeTable& table : tables)
    for (const TradeSeries& series : table.series)
      for (const TradePoint& p : series.points) {
        for (const std::string& word : {table.scenario, series.engine, series.integrator, series.version,
                                        series.precision, series.path, series.gyroscopic})
          out += csv_field(word) + ',';
        out +=
            fmt::format("{},{},{},{},{},{},{},{},{}", series.adaptive ? "" : std::to_string(series.declared),
                        real(series.order), p.steps, real(p.dt), csv_field(p.dt_text), series.substeps,
                        p.tolerance > 0 ? real(p.tolerance) : "", ending(p), csv_field(p.reason));
        for (const std::string& name : names) {
          out += ',';
          for (std::size_t i = 0; i < p.errors.size(); ++i)
            if (table.measures[i].name == name) out += real(p.errors[i]);
        }
        out += fmt::format(",{},{},{},{},{},{}\r\n", real(p.step_seconds), real(p.load_seconds), real(p.cost),
                           real(per_body_step(table, p)), p.on_front ? 1 : 0, csv_field(p.dominated_by));
      }
  return out;
}

}  // namespace cylon::reports
