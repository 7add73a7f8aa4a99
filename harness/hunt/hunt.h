// Looks for faults of an engine by itself: scenes, oracles, shrinking, cards.
#pragma once

#include "harness/hunt/card.h"
#include "harness/hunt/source.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cylon::hunt {

/// An oracle that a scene broke, and how.
struct Broken {
  std::string oracle;
  Kind kind = Kind::every_step;
  bool by_time = false;  ///< A run was stopped by the clock.
  friend bool operator==(const Broken&, const Broken&) = default;
};

/// A scene that was asked, with what it broke, in the order of the oracles.
struct Hit {
  std::uint64_t number = 0;
  std::string family;
  std::vector<Broken> broken;
  bool refused = false;  ///< See Examined.
};

/// What an earlier hunt for the same found out, and where to note what this one does.  Calls come one at a time.
class Memory {
 public:
  virtual ~Memory() = default;
  virtual std::optional<Hit> asked(std::uint64_t number) = 0;
  virtual void note(const Hit&) = 0;
  /// The least scene of a group, by its name.
  virtual std::optional<Trial> least(const std::string& group) = 0;
  virtual void note(const std::string& group, const Trial& least) = 0;
};

/// Who is hunted, and how.
struct Quarry {
  process::EngineChoice engine;
  process::Limits limits;
  int jobs = 1;
  Memory* memory = nullptr;  ///< May be none.
};

struct Found {
  std::vector<Hit> hits;      ///< Scenes with a fault, by their numbers.
  std::uint64_t scenes = 0;   ///< All of first, first + 1, …, first + scenes - 1 were asked.
  std::uint64_t refused = 0;  ///< Of these the engine refused so many.
  /// Scenes asked now that had a fault after others in one process, and none in processes of their own.
  std::vector<std::uint64_t> after_others;
};

/// Asks scenes from `first` on as long as more(n) says so, n being how many were begun; which is asked before each, one
/// at a time.  Scenes are run one after another in one process; a hit was seen again with a process for each of its runs.
/// The same hits for any number of jobs, of an engine that carries nothing over from one scene to the next.  Throws what
/// process::run throws.
Found search(const Source&, std::uint64_t first, const Quarry&,
             const std::function<bool(std::uint64_t)>& more);

/// One card for each fault.  Hits are grouped by oracle, kind and family; of each group the one with the fewest bodies is
/// shrunk.  Hits that lack a part of its least scene have another fault, and are a group of their own, and so on.
/// Cards of one signature are one.  `others` are asked what they make of the least scene.  `progress` gets a line at
/// a time.
std::vector<Card> cards(const Source&, const std::vector<Hit>&, const Quarry&,
                        const std::vector<process::EngineChoice>& others,
                        const std::function<void(const std::string&)>& progress);

}  // namespace cylon::hunt
