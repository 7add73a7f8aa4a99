// What a run has finished, cell by cell, so that it can be resumed after an interruption and its
// differing cells run again.  A JSON line with what was asked for, one with the part of the work that the file
// holds, then one per cell, in .cylon/journal.jsonl of the working folder, sealed: a journal names programs to
// run, so that of somebody else is not read.
#pragma once

#include "harness/cli/line_file.h"
#include "harness/cli/part.h"
#include "harness/cli/selection.h"
#include "harness/study/cell.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cylon::cli {

/// What must be equal for a stored cell to stand for a new one, on this machine or on another: the scenario's
/// and expected.toml's content, the engine's id, the content of its worker with the version that it says (identity_of.h),
/// the content of this program, and the step; no path.
std::string cell_key(const study::Cell&, const std::string& expectations_hash);

/// The same for those who know the engine by something else.
std::string cell_key(const study::Cell&, const std::string& expectations_hash, const std::string& engine);

/// Scenario, engine and step as the user names them: the same cell, whatever its files hold by now.
std::string cell_name(const study::Cell&);

/// The units of a run, cell by cell.
std::vector<Unit> units_of(const std::vector<study::Cell>&, const std::string& expectations_hash);

/// What was asked for, so that it can be asked for again; throws nlohmann::json's exceptions where it is
/// none.
nlohmann::json to_json(const Request&);
Request request_from(const nlohmann::json&);

class Journal {
 public:
  explicit Journal(const std::filesystem::path& file) : file_(file) {}

  struct Content {
    std::optional<Request> request;                              ///< Absent: there was no run.
    std::map<std::string, std::vector<results::Verdict>> cells;  ///< By key.
    std::set<std::string> differing;  ///< Names of cells that were not as expected.
    std::size_t strange = 0;          ///< Lines that this user did not write here, or that are cut off.

    /// Adds a line's object; throws std::exception where it is none of a journal.
    void take(const nlohmann::json& row);
  };

  /// The last run.  Throws core::InputError for a file of more than 1 GiB.
  Content read() const;

  /// Starts afresh, or goes on after what is there.  Throws core::InputError where another run has it open.
  void open(const Request&, const Part&, bool append);

  /// Adds a finished cell and how long it took [s]; where it cannot be written, stderr says so.  A cell without verdicts is
  /// finished where there is nothing to judge.
  void add(const std::string& key, const study::Cell&, const std::vector<results::Verdict>&, double seconds);

  /// Whether all of it could be written so far.
  bool is_open() const { return file_.is_open(); }

 private:
  LineFile file_;
};

}  // namespace cylon::cli
