// What `cylon advise` is checked by.
#pragma once

#include "harness/cli/context.h"
#include "harness/cli/shard.h"
#include "harness/study/advise.h"
#include "harness/study/settings.h"

#include <string>
#include <vector>

namespace cylon::cli {

struct Verification {
  study::SettingsRequest wanted;
  study::AdviseOptions how;
  std::vector<process::EngineRow> rows;
  std::string only;  ///< One scenario; "": twenty of the shipped ones.
  std::string observable;
  ShardOptions shard;  ///< Of the scenarios: the costs of one are compared with each other.
  bool resume = false;
};

/// Prints a line per scenario and engine: whether the advice holds from starts that it has not seen, and its
/// cost against the cheapest point of a whole sweep that holds from the same starts.  `ok` where every advice
/// holds and none costs more than 1.5 times that, else `differs`; of a shard the answer for its scenarios.
int verify_advice(const Context&, const Verification&);

}  // namespace cylon::cli
