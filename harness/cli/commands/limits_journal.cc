#include "harness/cli/commands/limits_journal.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::cli {
namespace {

using nlohmann::json;

constexpr std::pair<const char*, std::string LimitRow::*> texts[] = {{"family", &LimitRow::family},
                                                                     {"asks", &LimitRow::asks},
                                                                     {"unit", &LimitRow::unit},
                                                                     {"breaks", &LimitRow::breaks},
                                                                     {"engine", &LimitRow::engine},
                                                                     {"integrator", &LimitRow::integrator},
                                                                     {"unsupported", &LimitRow::unsupported}};

// A theory may be infinite, which JSON has no number for.
json to_json(const LimitRow& row) {
  json j;
  for (const auto& [key, text] : texts) j[key] = row.*text;
  j["kind"] = static_cast<int>(row.limit.kind);
  j["holds_at"] = row.limit.holds, j["breaks_at"] = row.limit.breaks, j["what"] = row.limit.what;
  j["holds_again"] = row.limit.holds_again, j["runs"] = row.limit.runs, j["value"] = row.value;
  j["downward"] = row.downward;
  if (row.theory) j["theory"] = std::isinf(*row.theory) ? json("none") : json(*row.theory);
  return j;
}

LimitRow from_json(const json& j) {
  constexpr std::array kinds = {study::Limit::Kind::found, study::Limit::Kind::none,
                                study::Limit::Kind::nowhere};
  LimitRow row;
  for (const auto& [key, text] : texts) row.*text = j.at(key).get<std::string>();
  row.limit.kind = kinds.at(j.at("kind").get<std::size_t>());
  row.limit.holds = j.at("holds_at"), row.limit.breaks = j.at("breaks_at"), row.limit.what = j.at("what");
  row.limit.holds_again = j.at("holds_again").get<std::vector<double>>();
  row.limit.runs = j.at("runs"), row.value = j.at("value");
  row.downward = j.value("downward", false);  // journals of 0.3 and before lack it
  if (j.contains("theory"))
    row.theory =
        j.at("theory").is_string() ? std::numeric_limits<double>::infinity() : j.at("theory").get<double>();
  return row;
}

}  // namespace

LimitsJournal::LimitsJournal(const std::filesystem::path& file, const Part& part, bool resume) : file_(file) {
  if (resume)
    file_.read([&](const json& line) {
      if (line.contains("limit")) rows_[line.at("key")] = from_json(line.at("limit"));
    });
  file_.open(resume);
  file_.add(to_json(part));
}

std::optional<LimitRow> LimitsJournal::find(const Unit& unit) const {
  const auto found = rows_.find(unit.key);
  return found == rows_.end() ? std::nullopt : std::optional(found->second);
}

void LimitsJournal::add(const Unit& unit, const LimitRow& row, double seconds) {
  file_.add({{"key", unit.key}, {"cell", unit.name}, {"limit", to_json(row)}, {"seconds", seconds}});
}

}  // namespace cylon::cli
