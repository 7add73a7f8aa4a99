// What a fit has evaluated, so that an interrupted one goes on where it was: JSON lines in .cylon/fit.jsonl of the working folder.
#pragma once

#include "harness/cli/line_file.h"
#include "harness/validation/fit.h"

#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace cylon::cli {

class FitJournal {
 public:
  /// Starts afresh, or reads what is there and goes on after it; a line cut off by a crash is left out.  Throws core::InputError
  /// where another fit has the file open.
  FitJournal(const std::filesystem::path& file, bool resume);

  std::size_t known() const { return deviances_.size(); }

  /// The memory of the fit with that key, which is of all that decides its result.  The journal outlives it.
  validation::Memory memory(const std::string& key);

 private:
  using Place = std::tuple<std::string, int, std::vector<double>>;  // key, round, values
  LineFile file_;
  std::map<Place, double> deviances_;
};

}  // namespace cylon::cli
