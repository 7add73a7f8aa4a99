#include "harness/cli/journal.h"

#include "harness/core/fingerprint.h"
#include "reports/json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <iterator>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

// Of the worker's command, and of the content of each word of it that is a file.
std::string worker_hash(const std::vector<std::string>& command) {
  static std::map<std::vector<std::string>, std::string> known;
  const auto [found, fresh] = known.try_emplace(command);
  if (fresh) {
    core::Fingerprint fingerprint;
    for (const std::string& word : command) {
      fingerprint.add(word);
      std::error_code ignored;
      if (!fs::is_regular_file(word, ignored)) continue;
      std::ifstream in(word, std::ios::binary);
      fingerprint.add(std::string(std::istreambuf_iterator<char>(in), {}));
    }
    found->second = fingerprint.hex();
  }
  return found->second;
}

}  // namespace

std::string cell_key(const study::Cell& cell, const std::string& expectations_hash) {
  return fmt::format("{}/{}/{}/{}/{}/{}", cell.scenario->name, cell.scenario->hash, cell.engine.id, worker_hash(cell.engine.row.command),
                     cell.dt_text, expectations_hash);
}

std::map<std::string, std::vector<core::Verdict>> Journal::read() const {
  std::map<std::string, std::vector<core::Verdict>> cells;
  std::ifstream in(file_);
  for (std::string line; std::getline(in, line);) {
    try {
      const nlohmann::json row = nlohmann::json::parse(line);
      std::vector<core::Verdict>& verdicts = cells[row.at("key").get<std::string>()];
      verdicts.clear();
      for (const auto& verdict : row.at("verdicts")) verdicts.push_back(reports::from_json_line(verdict.get<std::string>()));
    } catch (const std::exception&) {
      continue;
    }
  }
  std::erase_if(cells, [](const auto& cell) { return cell.second.empty(); });
  return cells;
}

void Journal::open(bool append) {
  std::error_code ignored;
  fs::create_directories(file_.parent_path(), ignored);
  out_.open(file_, append ? std::ios::app : std::ios::trunc);
  if (append) out_ << '\n';  // ends a line that a crash has cut off
}

void Journal::add(const std::string& key, const std::vector<core::Verdict>& verdicts) {
  nlohmann::json lines = nlohmann::json::array();
  for (const core::Verdict& verdict : verdicts) lines.push_back(reports::to_json_line(verdict));
  out_ << nlohmann::json{{"key", key}, {"verdicts", lines}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n' << std::flush;
}

}  // namespace cylon::cli
