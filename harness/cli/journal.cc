#include "harness/cli/journal.h"

#include "harness/cli/content_of.h"
#include "harness/cli/identity_of.h"
#include "reports/json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace cylon::cli {
namespace {

// What a cell is asked beside its scenario's claims, as the command's options say it.
std::string asked_of(const study::Cell& cell) {
  std::string asked = cell.exam == study::Exam::relations ? " --metamorphic"
                      : cell.exam == study::Exam::theory  ? " --theory"
                                                          : "";
  if (cell.tolerance_scale != 1) asked += fmt::format(" --tolerance-scale {}", cell.tolerance_scale);
  if (cell.copies > 0) asked += fmt::format(" --spread {}", cell.copies);
  if (cell.force) asked += " --force";
  return asked;
}

}  // namespace

nlohmann::json to_json(const Request& r) {
  return {{"patterns", r.patterns},
          {"engines", r.engines},
          {"steps", r.steps},
          {"integrators", r.integrators},
          {"workers", r.brought.workers},
          {"plugins", r.brought.plugins},
          {"suite", r.suite},
          {"metamorphic", r.metamorphic},
          {"theory", r.theory},
          {"tolerance_scale", r.tolerance_scale},
          {"copies", r.copies},
          {"force", r.force}};
}

Request request_from(const nlohmann::json& j) {
  return {j.at("patterns"),
          j.at("engines"),
          j.at("steps"),
          j.at("integrators"),
          {j.at("workers"), j.value("plugins", std::vector<std::string>())},
          j.at("suite"),
          j.value("metamorphic", false),
          j.value("theory", false),
          j.value("tolerance_scale", 1.0),
          j.value("copies", 0),
          j.value("force", false)};
}

std::string cell_key(const study::Cell& cell, const std::string& expectations_hash) {
  return cell_key(cell, expectations_hash, identity_of(cell.engine.row));
}

std::string cell_key(const study::Cell& cell, const std::string& expectations_hash,
                     const std::string& engine) {
  return fmt::format("{}/{}/{}/{}/{}", cell_name(cell), cell.scenario->hash, engine,
                     content_of({"/proc/self/exe"}), expectations_hash);
}

std::string cell_name(const study::Cell& cell) {
  return fmt::format("{} {} {}{}", cell.scenario->name, cell.engine.id, cell.dt_text, asked_of(cell));
}

std::vector<Unit> units_of(const std::vector<study::Cell>& cells, const std::string& expectations_hash) {
  std::vector<process::EngineRow> engines;
  for (const study::Cell& cell : cells) engines.push_back(cell.engine.row);
  identify(engines);
  std::vector<Unit> units;
  for (const study::Cell& cell : cells) units.push_back({cell_key(cell, expectations_hash), cell_name(cell)});
  return units;
}

void Journal::Content::take(const nlohmann::json& row) {
  if (row.contains("part")) return;
  if (row.contains("request")) {
    request = request_from(row.at("request"));
    return;
  }
  std::vector<results::Verdict> verdicts;
  for (const auto& verdict : row.at("verdicts"))
    verdicts.push_back(reports::from_json_line(verdict.get<std::string>()));
  const std::string cell = row.at("cell");
  if (std::all_of(verdicts.begin(), verdicts.end(),
                  [](const results::Verdict& v) { return v.as_expected(); })) {
    differing.erase(cell);
  } else {
    differing.insert(cell);
  }
  cells[row.at("key").get<std::string>()] = std::move(verdicts);
}

Journal::Content Journal::read() const {
  Content content;
  content.strange = file_.read([&](const nlohmann::json& row) { content.take(row); });
  return content;
}

void Journal::open(const Request& request, const Part& part, bool append) {
  file_.open(append);
  file_.add({{"request", to_json(request)}});
  file_.add(to_json(part));
}

void Journal::add(const std::string& key, const study::Cell& cell,
                  const std::vector<results::Verdict>& verdicts, double seconds) {
  nlohmann::json lines = nlohmann::json::array();
  for (const results::Verdict& verdict : verdicts) lines.push_back(reports::to_json_line(verdict));
  file_.add({{"key", key}, {"cell", cell_name(cell)}, {"verdicts", lines}, {"seconds", seconds}});
}

}  // namespace cylon::cli
