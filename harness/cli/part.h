// What a journal is to hold: all units of a question, and the part of them that one process does.
#pragma once

#include "harness/cli/shard.h"
#include "harness/study/parallel.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cylon::cli {

/// The commands whose work can be shared out, each with the name of its journal.
struct Question {
  const char* command;
  const char* journal;
};
inline constexpr Question questions[] = {{"run", "journal"},   {"trade", "trade"},   {"matrix", "matrix"},
                                         {"limits", "limits"}, {"advise", "advise"}, {"hunt", "hunt"}};

/// "`cylon run`, `trade` and `limits`", of all of them.
std::string sharing_commands();

/// "run" → .cylon/journal.jsonl; of a shard .cylon/journal-2-of-8.jsonl.  Relative to the working folder.
std::filesystem::path journal_file(const std::string& command, const std::optional<Shard>& = {});

/// The journals of a farm's ranks that lie in this folder.
std::vector<std::filesystem::path> rank_journals(const std::string& command);

/// The line of a journal that says what it is.
struct Part {
  std::string command;  ///< One of `questions`.
  std::size_t index = 1, count = 1;
  std::vector<Unit> units;  ///< All of them, also those of other parts.
  std::string suite =
      {};  ///< Of `run`, as it was asked for: its published numbers are held against the whole.
};

nlohmann::json to_json(const Part&);

/// Throws std::exception for what is none.
Part part_from(const nlohmann::json&);

/// How long units took in the last whole or merged run in this folder.
Durations durations(const std::string& command);

/// Which units may be the shard's; all where there is none, and in a farm, which then begins to hand them out.  Says on
/// stderr how many that is.  `resume`: what this folder has already is kept.  Throws core::InputError where the shard is
/// by time and this folder's journal of the command has no durations, and where the ranks of a farm do not agree.
std::vector<bool> own_units(const std::optional<Shard>&, const Part&, bool resume);

/// The order in which this process does its `count` own units.
study::Next next_of(const std::optional<Shard>&, std::size_t count);

/// Leaves of a list with one entry per unit what is the shard's.
template <class Entry>
void keep(const std::vector<bool>& own, std::vector<Entry>& list) {
  std::size_t i = 0;
  std::erase_if(list, [&](const Entry&) { return !own[i++]; });
}

}  // namespace cylon::cli
