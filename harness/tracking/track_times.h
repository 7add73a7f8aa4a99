// The times of a cell for the history: fresh processes, in turn with those of the pinned binaries.
#pragma once

#include "harness/study/cell.h"
#include "harness/tracking/store/model.h"
#include "harness/tracking/track_anchor.h"

#include <vector>

namespace cylon::tracking {

/// `count` samples of `cpu_seconds` [s], each of them the least of some runs in a process of its own, and for
/// each anchor as many of `cpu_ratio:<anchor>`, the time of a neighbouring process of that anchor under it.
/// `first` is the cell's run that was judged.  A failure stands as the text of `no_time`.
/// Throws what process::run throws.
std::vector<store::Sample> time_samples(const study::Cell&, const process::RunOutcome& first, int count,
                                        const std::vector<PinnedEngine>&, const process::Limits&);

}  // namespace cylon::tracking
