// What a run has finished, cell by cell, so that it can be resumed after an interruption and its
// differing cells run again.  A JSON line with what was asked for, then one per cell, in .cylon/journal.jsonl
// of the working folder.
#pragma once

#include "harness/cli/selection.h"
#include "harness/study/cell.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cylon::cli {

/// What must be equal for a stored cell to stand for a new one: the scenario's and expected.toml's content,
/// the engine's id and its worker's content, and the step.
std::string cell_key(const study::Cell&, const std::string& expectations_hash);

/// Scenario, engine and step as the user names them: the same cell, whatever its files hold by now.
std::string cell_name(const study::Cell&);

/// What was asked for, so that it can be asked for again; throws nlohmann::json's exceptions where it is
/// none.
nlohmann::json to_json(const Request&);
Request request_from(const nlohmann::json&);

class Journal {
 public:
  explicit Journal(std::filesystem::path file) : file_(std::move(file)) {}

  struct Content {
    std::optional<Request> request;                              ///< Absent: there was no run.
    std::map<std::string, std::vector<results::Verdict>> cells;  ///< By key.
    std::set<std::string> differing;  ///< Names of cells that were not as expected.
  };

  /// The last run; a line cut off by a crash is left out.
  Content read() const;

  /// Starts afresh, or goes on after what is there.
  void open(const Request&, bool append);

  /// Adds a finished cell and flushes it; a journal that cannot be written is silently none.
  void add(const std::string& key, const study::Cell&, const std::vector<results::Verdict>&);

 private:
  std::filesystem::path file_;
  std::ofstream out_;
};

}  // namespace cylon::cli
