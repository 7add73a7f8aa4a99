// What a run has finished, cell by cell, so that it can be resumed after an interruption and its
// differing cells run again.  One JSON line per cell in .cylon/journal.jsonl of the working folder.
#pragma once

#include "harness/study/cell.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace cylon::cli {

/// What must be equal for a stored cell to stand for a new one: the scenario's and expected.toml's content,
/// the engine's id and its worker's content, and the step.
std::string cell_key(const study::Cell&, const std::string& expectations_hash);

class Journal {
 public:
  explicit Journal(std::filesystem::path file) : file_(std::move(file)) {}

  /// Cells of the last run by key; a line cut off by a crash is left out.
  std::map<std::string, std::vector<core::Verdict>> read() const;

  /// Starts afresh, or goes on after what is there.
  void open(bool append);

  /// Adds a finished cell and flushes it; a journal that cannot be written is silently none.
  void add(const std::string& key, const std::vector<core::Verdict>&);

 private:
  std::filesystem::path file_;
  std::ofstream out_;
};

}  // namespace cylon::cli
