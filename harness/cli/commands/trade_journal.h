// What `cylon trade` has measured, run by run, so that an interrupted sweep goes on: JSON lines in
// .cylon/trade.jsonl of the working folder, keyed by the content of what was run.
#pragma once

#include "harness/cli/line_file.h"
#include "harness/cli/part.h"
#include "harness/study/sweep.h"

#include <filesystem>
#include <map>
#include <string>

namespace cylon::cli {

class TradeJournal final : public study::Memory {
 public:
  /// Starts afresh, or reads what is there and goes on after it; a line cut off by a crash is left out.
  /// Throws core::InputError where another sweep has the file open.
  TradeJournal(const std::filesystem::path& file, const Part&, bool resume);

  /// The scenario whose runs follow, and how many common times they are looked at.
  void turn_to(const scenario::Scenario& scenario, std::int64_t samples);

  /// A scenario of which nothing is left to do, and how long that took now [s].
  void finish(const Unit&, double seconds);

  /// Whether all of it could be written so far.
  bool is_open() const { return file_.is_open(); }

  /// How many runs and timings the file held.
  std::size_t known() const { return runs_.size() + times_.size(); }

  std::optional<study::Ran> find(const study::Setting&, std::int64_t steps, double tolerance) override;
  void keep(const study::Setting&, const study::Ran&) override;
  std::optional<process::Repetition> find_time(const study::Setting&, const results::TradePoint&,
                                               int round) override;
  void keep_time(const study::Setting&, const results::TradePoint&, int round,
                 const process::Repetition&) override;

 private:
  std::string key(const study::Setting&, std::int64_t steps, double tolerance) const;

  LineFile file_;
  std::map<std::string, study::Ran> runs_;
  std::map<std::string, process::Repetition> times_;
  const scenario::Scenario* scenario_ = nullptr;
  std::int64_t samples_ = 0;
};

}  // namespace cylon::cli
