#include "harness/cli/farm.h"

#include "harness/cli/command_line.h"
#include "harness/cli/content_of.h"
#include "harness/cli/context.h"
#include "harness/cli/line_file.h"
#include "harness/cli/union.h"
#include "harness/core/content_hash.h"
#include "harness/core/input_error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <random>
#include <set>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* folder_file = ".cylon/farm.jsonl";  // locked by the leader, seen by all

// A network folder may show a new file late.
constexpr std::chrono::seconds to_see_here{1}, to_see_elsewhere{30};

std::string random_word() {
  std::random_device bits;
  return fmt::format("{:08x}{:08x}", bits(), bits());
}

std::string word_in_folder() {
  std::string word;
  try {
    Room room;
    LineFile::read_of_others(folder_file, room, [&](const nlohmann::json& line) { word = line.at("farm"); });
  } catch (const core::InputError&) {  // it is not there yet
  }
  return word;
}

bool sees(const std::string& word, std::chrono::seconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (word_in_folder() != word) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

void say_strange(std::size_t lines) {
  if (lines > 0)
    std::cerr << fmt::format(
        "{} lines are cut off, or were not written by you in this folder; they are not used\n", lines);
}

// Of all that must be equal: what is asked, and who answers.
std::string hash_of(const Part& part) {
  core::ContentHash content;
  content.add(content_of({"/proc/self/exe"}));
  content.add(to_json(part).at("units").dump());
  return content.hex();
}

}  // namespace

std::size_t units_at_once(std::size_t left, std::size_t ranks) {
  return std::clamp<std::size_t>(left / (64 * ranks), 1, 16);
}

Farm::Farm(crew::Crew& crew) : crew_(crew) {
  for (const std::string& text : crew_.all_say(to_text(own_cores()))) cores_.push_back(cores_from(text));
}

Farm::~Farm() = default;

Shard Farm::shard() {
  return {.index = crew_.rank() + 1, .count = crew_.size(), .said_by = "farm", .farm = this};
}

std::string Farm::name(std::size_t rank) const {
  return fmt::format("rank {} of {} on {}", rank, crew_.size(), cores_[rank].host);
}

void Farm::require_own_cores(const std::string& what) const {
  const std::string shared = shared_core(cores_);
  if (!shared.empty())
    throw core::InputError(fmt::format(
        "{}, and {}: times would be those of two at once.  Start the ranks with a core each (mpirun "
        "--bind-to core), or give --rounds 0 and measure times later",
        what, shared));
}

// Rank by rank what is said under the same word; throws what a rank says that leaves meanwhile.
std::vector<std::string> Farm::all_say(const std::string& word, const std::string& text) {
  std::vector<std::string> said = crew_.all_say(word + " " + text);
  for (std::size_t rank = 0; rank < said.size(); ++rank) {
    if (!said[rank].starts_with(word + " ")) {
      const std::string why = said[rank].substr(said[rank].find(' ') + 1);
      throw core::InputError(fmt::format("{}: {}", name(rank), why.empty() ? "has nothing to do" : why));
    }
    said[rank].erase(0, word.size() + 1);
  }
  return said;
}

std::string Farm::leave(const std::string& why) {
  if (met_) return why;  // it is because of what all have heard
  met_ = true;
  const std::vector<std::string> said = crew_.all_say("leaves " + why);
  for (std::size_t rank = 0; rank < said.size(); ++rank)
    if (said[rank].starts_with("leaves ") && said[rank].size() > 7)
      return rank == 0 ? said[0].substr(7) : fmt::format("{}: {}", name(rank), said[rank].substr(7));
  return "";
}

void Farm::share_out(const Part& part, bool resume) {
  const std::string own = hash_of(part);
  met_ = true;
  std::vector<std::string> said = all_say("asks", own);
  for (std::size_t rank = 1; rank < said.size(); ++rank)
    if (said[rank] != said[0])
      throw core::InputError(
          fmt::format("{} has other scenarios, engines or another cylon than {}", name(rank), name(0)));
  // The ranks' journals are joined in this folder, so that all must work in it.
  std::string word, why;
  if (leads()) try {
      folder_lock_ = std::make_unique<LineFile>(folder_file);
      folder_lock_->open(false);
      folder_lock_->add({{"farm", word = random_word()}});
      if (!folder_lock_->is_open()) why = fmt::format("{} cannot be written", folder_file);
      part_ = part;
      part_->index = part_->count = 1;
      collect(resume);
    } catch (const core::InputError& error) {
      why = error.what();
    }
  said = crew_.all_say(why.empty() ? word : "! " + why);
  if (said[0].starts_with("! ")) throw core::InputError(said[0].substr(2));
  word = said[0];
  const bool here = cores_[crew_.rank()].host == cores_[0].host;
  const auto patience = here ? to_see_here : to_see_elsewhere;
  said = all_say("sees", leads() || sees(word, patience) ? "it" : fs::current_path().string());
  for (std::size_t rank = 1; rank < said.size(); ++rank)
    if (said[rank] != "it")
      throw core::InputError(fmt::format(
          "{} works in {}, which is another folder than that of {}: a farm needs one that all share; "
          "without one use --shard and `cylon merge`",
          name(rank), said[rank], name(0)));
  part_ = part;
  part_->index = part_->count = 1;
  shared_out_ = true;
  if (!leads()) return;
  std::set<std::string> hosts;
  for (const Cores& cores : cores_) hosts.insert(cores.host);
  std::cerr << fmt::format("farm: {} ranks on {} hosts, {} of {} to do\n", crew_.size(), hosts.size(),
                           left_.size(), part.units.size());
  server_ = std::jthread([this] { crew_.serve([this] { return take(); }); });
}

// What is to be done, and of which the folder's own journal is afterwards: with `resume` what all journals of this
// folder hold, else nothing.
void Farm::collect(bool resume) {
  const fs::path place = journal_file(part_->command);
  const Durations known = durations(part_->command);
  std::vector<fs::path> files = rank_journals(part_->command);
  if (fs::exists(place)) files.push_back(place);
  Union all = resume ? unite_own(*part_, files) : Union{*part_, {}, part_->units, {}, 0, false};
  say_strange(all.strange);
  write(all, place);
  for (const fs::path& file : rank_journals(part_->command)) fs::remove(file);
  std::set<std::string> missing;
  for (const Unit& unit : all.missing) missing.insert(unit.key);
  for (const std::size_t i : longest_first(part_->units, known))
    if (missing.contains(part_->units[i].key)) left_.push_back(i);
}

std::vector<std::int64_t> Farm::take() {
  const std::scoped_lock lock(taking_);
  std::vector<std::int64_t> units;
  for (std::size_t n = units_at_once(left_.size(), crew_.size()); n > 0 && !left_.empty(); --n) {
    units.push_back(static_cast<std::int64_t>(left_.front()));
    left_.pop_front();
  }
  return units;
}

std::optional<std::size_t> Farm::next() {
  const std::scoped_lock lock(taking_);
  if (!leads() && left_.empty() && !dry_) {
    for (const std::int64_t unit : crew_.ask()) left_.push_back(static_cast<std::size_t>(unit));
    dry_ = left_.empty();
  }
  if (left_.empty()) return std::nullopt;
  const std::size_t unit = left_.front();
  left_.pop_front();
  return unit;
}

int Farm::finish(int code) {
  if (server_.joinable()) server_.join();
  const std::vector<std::string> said = all_say("done", std::to_string(code));
  const bool same = !leads() || join();
  if (std::ranges::find(said, std::to_string(bad_input)) != said.end()) return bad_input;
  return same ? ok : differs;
}

bool Farm::join() {
  const fs::path place = journal_file(part_->command);
  const std::vector<fs::path> ranks = rank_journals(part_->command);
  std::vector<fs::path> files = ranks;
  files.push_back(place);
  const Union all = unite_own(*part_, files);
  say_strange(all.strange);
  for (const std::string& line : all.contradictions)
    std::cerr << plain_line(fmt::format("the same input gave other results: {}", line)) << '\n';
  write(all, place);
  for (const fs::path& file : ranks) fs::remove(file);
  folder_lock_.reset();
  fs::remove(folder_file);
  return all.contradictions.empty();
}

}  // namespace cylon::cli
