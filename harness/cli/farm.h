// A question that the ranks of one crew answer together.  Rank 0, the leader, hands out the units and does units too;
// every rank keeps a journal, as a shard does; in the end the leader joins them to the folder's own journal.
#pragma once

#include "harness/cli/cores.h"
#include "harness/cli/part.h"
#include "harness/cli/shard.h"
#include "harness/crew/crew.h"

#include <cstddef>
#include <cstdlib>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace cylon::cli {

class LineFile;

/// How many units one answer of the leader holds: few, so that no rank is left with many when the others have none;
/// several while many are left, so that short units are not waited for one by one.
std::size_t units_at_once(std::size_t left, std::size_t ranks);

/// Every rank makes one and calls share_out() or leave(), then finish(), at the same point.
class Farm {
 public:
  explicit Farm(crew::Crew&);
  ~Farm();
  Farm(const Farm&) = delete;
  Farm& operator=(const Farm&) = delete;

  bool leads() const { return crew_.rank() == 0; }
  bool is_shared_out() const { return shared_out_; }
  Shard shard();

  /// "rank 2 of 8 on node7"
  std::string name(std::size_t rank) const;

  /// Cores that this rank's engines may keep busy.
  std::size_t cores() const { return share_of_cores(cores_, crew_.rank()); }

  /// Throws core::InputError where a rank does not have a core of its own, so that `what` would measure nothing.
  void require_own_cores(const std::string& what) const;

  /// The leader begins to hand out the units: all, or with `resume` those that are in no journal of this folder.  Throws
  /// core::InputError on every rank where one has other units, another program or another folder, or has left.
  void share_out(const Part&, bool resume);

  /// Of a rank that has nothing to share out, which the others hear of.  What the user is to be told of it: what the first
  /// rank says that has something to say.
  std::string leave(const std::string& why);

  /// The next unit of this rank.
  std::optional<std::size_t> next();

  /// Waits for all ranks, each with its exit code, ok or bad_input (units that were refused); the leader then joins what
  /// they did.  The exit code of all: bad_input before differs, where the leader found other results for one unit and
  /// said so, before ok.
  int finish(int code);

  /// Ends all ranks.
  [[noreturn]] void abort(int code) {
    crew_.abort(code);
    std::abort();  // gcc 12 does not see that a virtual function never returns
  }

 private:
  void collect(bool resume);
  std::vector<std::int64_t> take();
  bool join();
  std::vector<std::string> all_say(const std::string& word, const std::string& text);

  crew::Crew& crew_;
  std::vector<Cores> cores_;  // by rank
  std::optional<Part> part_;
  bool met_ = false;  // all ranks have heard of each other, and know alike whether there is something to do
  bool shared_out_ = false;
  std::unique_ptr<LineFile> folder_lock_;  // of the leader
  std::mutex taking_;
  std::deque<std::size_t> left_;  // of the leader: all that nobody has; of the others: what this rank has
  bool dry_ = false;              // the leader has said that there is no more
  std::jthread server_;           // of the leader
};

}  // namespace cylon::cli
