// The union of journals: what several processes did of one question, each its part, as one journal.
#pragma once

#include "harness/cli/part.h"
#include "harness/results/verdict.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace cylon::cli {

/// What a journal holds of a unit, and the verdicts in it.
struct Result {
  nlohmann::json line;
  std::vector<results::Verdict> verdicts;
};

/// Of any journals of one question in any order, also of some again, and of unions: the same.
struct Union {
  Part part;                              ///< The whole: 1 of 1.
  std::map<std::string, Result> results;  ///< By key, each as the first file has it.
  std::vector<Unit> missing;              ///< In the order of the units.
  /// Where two files disagree on what does not depend on time: "heavy_top bullet 1/60: /verdicts/0/measured is 2
  /// in a.jsonl and 3 in b.jsonl".  The same input must give the same bits, so that each is a finding.
  std::vector<std::string> contradictions;
  std::size_t strange = 0;  ///< Lines that a crash has cut off.
  bool sandboxed = false;   ///< Engines of a part ran in a sandbox: whoever goes on must use one, too.
};

/// Throws core::InputError for a file that is no journal, and for journals that ask something else: another
/// command, suite, or cells with another content.  The lines of this user's own journal of the command in this folder are
/// kept as well, as by unite_own().
Union unite(std::span<const std::filesystem::path>);

/// The same of this user's own journals in this folder, whatever they asked, as the union of `part`: a line is used for what
/// its key says.  Lines that this user did not write here are left out and counted as strange.  No other line is lost.
/// Throws core::InputError where a part ran in a sandbox and this program runs engines without.
Union unite_own(const Part&, std::span<const std::filesystem::path>);

/// Writes it whole or not at all, as this user's own journal of the place.  Throws core::InputError where it
/// cannot be written, or another program has it open.
void write(const Union&, const std::filesystem::path&);

}  // namespace cylon::cli
