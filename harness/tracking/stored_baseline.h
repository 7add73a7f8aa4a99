// A comparison with what the history has of an earlier run: results only, since no machine is what it was.
#pragma once

#include "harness/results/comparison.h"
#include "harness/study/compare.h"
#include "harness/tracking/store/model.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::tracking {

/// The run that "run:ID" or a label means; nothing where there is no history or no such run.  "run:" that
/// names none throws core::InputError.
std::optional<store::RunInfo> stored_run(const std::string& store_file, const std::string& word);

/// The binary that the history keeps as the anchor of that run, where it is still there.
std::optional<std::string> anchor_binary(const std::string& store_file, const store::RunInfo&);

/// Each cell as the candidate runs it against the stored values: errors, hash, counts.  A cell whose scenario
/// has another content than then is not compared, and says so.
results::ComparisonReport compare_with_stored(const std::string& store_file, const store::RunInfo&,
                                              const std::vector<study::Cell>&, const study::Side& candidate,
                                              const study::CompareOptions&, const study::CompareProgress&);

/// What the history has of a cell as a profile; `like` gives what it does not have.
study::Profile profile_of(const store::Result&, const study::Profile& like);

}  // namespace cylon::tracking
