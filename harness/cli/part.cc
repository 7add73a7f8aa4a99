#include "harness/cli/part.h"

#include "harness/cli/farm.h"
#include "harness/cli/line_file.h"
#include "harness/core/input_error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace cylon::cli {
namespace {

const char* journal_of(const std::string& command) {
  const auto question = std::ranges::find(questions, command, &Question::command);
  if (question == std::end(questions)) throw std::logic_error("no journal of " + command);
  return question->journal;
}

}  // namespace

std::string sharing_commands() {
  std::string text = "`cylon ";
  for (std::size_t i = 0; i < std::size(questions); ++i)
    text += fmt::format("{}{}`",
                        i == 0                          ? ""
                        : i + 1 == std::size(questions) ? " and `"
                                                        : ", `",
                        questions[i].command);
  return text;
}

std::filesystem::path journal_file(const std::string& command, const std::optional<Shard>& shard) {
  const char* journal = journal_of(command);
  return shard ? fmt::format(".cylon/{}-{}.jsonl", journal, shard->label())
               : fmt::format(".cylon/{}.jsonl", journal);
}

std::vector<std::filesystem::path> rank_journals(const std::string& command) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(".cylon", ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(fmt::format("{}-rank-", journal_of(command))) && name.ends_with(".jsonl"))
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

nlohmann::json to_json(const Part& part) {
  nlohmann::json units = nlohmann::json::array();
  for (const Unit& unit : part.units) units.push_back({unit.key, unit.name});
  nlohmann::json head = {{"command", part.command}, {"index", part.index}, {"count", part.count}};
  if (!part.suite.empty()) head["suite"] = part.suite;
  return {{"part", std::move(head)}, {"units", std::move(units)}};
}

Part part_from(const nlohmann::json& json) {
  const nlohmann::json& head = json.at("part");
  Part part{head.at("command"), head.at("index"), head.at("count"), {}, head.value("suite", "")};
  if (std::ranges::none_of(questions, [&](const Question& q) { return part.command == q.command; }))
    throw std::invalid_argument("'" + part.command + "' is not divided into parts");
  for (const nlohmann::json& unit : json.at("units")) part.units.push_back({unit.at(0), unit.at(1)});
  return part;
}

Durations durations(const std::string& command) {
  Durations known;
  LineFile(journal_file(command)).read_as_data([&](const nlohmann::json& line) {
    if (line.contains("cell")) known[line.at("cell")] = line.at("seconds");
  });
  return known;
}

study::Next next_of(const std::optional<Shard>& shard, std::size_t count) {
  if (!shard || !shard->farm) return study::in_order(count);
  return [farm = shard->farm] { return farm->next(); };
}

std::vector<bool> own_units(const std::optional<Shard>& shard, const Part& part, bool resume) {
  if (shard && shard->farm) shard->farm->share_out(part, resume);
  if (!shard || shard->farm) return std::vector<bool>(part.units.size(), true);
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
