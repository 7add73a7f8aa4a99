#include "harness/cli/commands/trade_journal.h"

#include "harness/cli/journal.h"
#include "harness/study/cell.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace cylon::cli {
namespace {

using nlohmann::json;

json to_json(const study::Ran& ran) {
  const results::TradePoint& p = ran.point;
  return {{"steps", p.steps},
          {"dt", p.dt},
          {"dt_text", p.dt_text},
          {"tolerance", p.tolerance},
          {"status", results::name(p.status)},
          {"reason", p.reason},
          {"errors", p.errors},
          {"integrator", ran.integrator},
          {"version", ran.version},
          {"precision", ran.precision},
          {"path", ran.path},
          {"gyroscopic", ran.gyroscopic},
          {"order", ran.order},
          {"closed_form", ran.closed_form},
          {"substeps", ran.substeps},
          {"cpu", ran.cpu_seconds}};
}

study::Ran from_json(const json& j) {
  study::Ran ran;
  results::TradePoint& p = ran.point;
  p.steps = j.at("steps"), p.dt = j.at("dt"), p.dt_text = j.at("dt_text");
  p.tolerance = j.at("tolerance"), p.reason = j.at("reason");
  p.status = results::status_from(j.at("status").get<std::string>()).value();
  for (const json& e : j.at("errors"))
    p.errors.push_back(e.is_null() ? std::numeric_limits<double>::quiet_NaN() : e.get<double>());
  ran.integrator = j.at("integrator"), ran.version = j.at("version"), ran.precision = j.at("precision");
  ran.path = j.at("path"), ran.gyroscopic = j.at("gyroscopic");
  ran.closed_form = j.at("closed_form"), ran.substeps = j.value("substeps", 1);  // older rows lack it
  ran.order = j.at("order"), ran.cpu_seconds = j.at("cpu");
  return ran;
}

}  // namespace

TradeJournal::TradeJournal(const std::filesystem::path& file, const Part& part, bool resume) : file_(file) {
  if (resume)
    file_.read([&](const json& row) {
      if (row.contains("ran"))
        runs_[row.at("key")] = from_json(row.at("ran"));
      else if (row.contains("load"))
        times_[row.at("key")] = {row.at("load"), row.at("step")};
    });
  file_.open(resume);
  file_.add(to_json(part));
}

void TradeJournal::finish(const Unit& unit, double seconds) {
  file_.add({{"key", unit.key}, {"cell", unit.name}, {"seconds", seconds}});
}

void TradeJournal::turn_to(const scenario::Scenario& scenario, std::int64_t samples) {
  scenario_ = &scenario;
  samples_ = samples;
}

std::string TradeJournal::key(const study::Setting& setting, std::int64_t steps, double tolerance) const {
  study::Cell cell;
  cell.scenario = scenario_;
  cell.engine = setting.engine;
  return fmt::format("{} {} {} steps, {} samples, tolerance {}", cell_key(cell, ""),
                     setting.integrator_asked(), steps, samples_, tolerance);
}

std::optional<study::Ran> TradeJournal::find(const study::Setting& setting, std::int64_t steps,
                                             double tolerance) {
  const auto found = runs_.find(key(setting, steps, tolerance));
  if (found == runs_.end()) return std::nullopt;
  return found->second;
}

void TradeJournal::keep(const study::Setting& setting, const study::Ran& ran) {
  file_.add({{"key", key(setting, ran.point.steps, ran.point.tolerance)}, {"ran", to_json(ran)}});
}

std::optional<process::Repetition> TradeJournal::find_time(const study::Setting& setting,
                                                           const results::TradePoint& point, int round) {
  const auto found = times_.find(fmt::format("{} #{}", key(setting, point.steps, point.tolerance), round));
  if (found == times_.end()) return std::nullopt;
  return found->second;
}

void TradeJournal::keep_time(const study::Setting& setting, const results::TradePoint& point, int round,
                             const process::Repetition& time) {
  file_.add({{"key", fmt::format("{} #{}", key(setting, point.steps, point.tolerance), round)},
             {"load", time.load_seconds},
             {"step", time.step_seconds}});
}

}  // namespace cylon::cli
