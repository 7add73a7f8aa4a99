// What `cylon limits` has found, search by search, so that an interrupted one goes on and shards can be merged:
// JSON lines in .cylon/limits.jsonl of the working folder.
#pragma once

#include "harness/cli/commands/limits_report.h"
#include "harness/cli/line_file.h"
#include "harness/cli/part.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace cylon::cli {

class LimitsJournal {
 public:
  /// Starts afresh, or reads what is there and goes on after it; a line cut off by a crash is left out.
  /// Throws core::InputError where another search has the file open.
  LimitsJournal(const std::filesystem::path& file, const Part&, bool resume);

  std::size_t known() const { return rows_.size(); }
  std::optional<LimitRow> find(const Unit&) const;

  /// Adds what was found, and how long that took [s].
  void add(const Unit&, const LimitRow&, double seconds);

  /// Whether all of it could be written so far.
  bool is_open() const { return file_.is_open(); }

 private:
  LineFile file_;
  std::map<std::string, LimitRow> rows_;
};

}  // namespace cylon::cli
