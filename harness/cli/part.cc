#include "harness/cli/part.h"

#include "harness/cli/line_file.h"
#include "harness/core/input_error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <stdexcept>

namespace cylon::cli {
namespace {

// How long units took in the last whole or merged run in this folder.
Durations durations(const std::string& command) {
  Durations known;
  LineFile(journal_file(command)).read([&](const nlohmann::json& line) {
    if (line.contains("cell")) known[line.at("cell")] = line.at("seconds");
  });
  return known;
}

}  // namespace

std::filesystem::path journal_file(const std::string& command, const std::optional<Shard>& shard) {
  const auto question = std::ranges::find(questions, command, &Question::command);
  if (question == std::end(questions)) throw std::logic_error("no journal of " + command);
  return shard ? fmt::format(".cylon/{}-{}.jsonl", question->journal, shard->label())
               : fmt::format(".cylon/{}.jsonl", question->journal);
}

nlohmann::json to_json(const Part& part) {
  nlohmann::json units = nlohmann::json::array();
  for (const Unit& unit : part.units) units.push_back({unit.key, unit.name});
  return {{"part", {{"command", part.command}, {"index", part.index}, {"count", part.count}}},
          {"units", units}};
}

Part part_from(const nlohmann::json& json) {
  const nlohmann::json& head = json.at("part");
  Part part{head.at("command"), head.at("index"), head.at("count"), {}};
  if (std::ranges::none_of(questions, [&](const Question& q) { return part.command == q.command; }))
    throw std::invalid_argument("'" + part.command + "' is not divided into parts");
  for (const nlohmann::json& unit : json.at("units")) part.units.push_back({unit.at(0), unit.at(1)});
  return part;
}

std::vector<bool> own_units(const std::optional<Shard>& shard, const Part& part) {
  if (!shard) return std::vector<bool>(part.units.size(), true);
  const Durations known = shard->by_time ? durations(part.command) : Durations();
  if (shard->by_time && known.empty())
    throw core::InputError(
        fmt::format("--shard-by time: {} has no durations; do all of it here once, or merge",
                    journal_file(part.command).string()));
  std::vector<bool> own = part_of(*shard, part.units, known);
  std::cerr << fmt::format("shard {} of {} ({}): {} of {}\n", shard->index, shard->count, shard->said_by,
                           std::ranges::count(own, true), part.units.size());
  return own;
}

}  // namespace cylon::cli
