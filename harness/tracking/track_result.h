// What the history keeps of one cell, from its run and its verdicts.
#pragma once

#include "harness/results/verdict.h"
#include "harness/study/cell.h"
#include "harness/tracking/store/model.h"

#include <string>
#include <vector>

namespace cylon::tracking {

/// The cell's key, verdicts and engine version; `error:<claim>` of each claim that was measured; state hash,
/// events, contacts and peak memory where the run reached its end.
store::Result result_of(const study::Cell&, const process::RunOutcome&, const std::vector<results::Verdict>&);

/// `order:<claim>` = log2(error(dt) / error(dt/2)) of each claim that follows a truth and whose errors are
/// both more than ten times the truth's own; `halved` are the verdicts at half the step.
std::vector<store::Sample> observed_orders(const study::Cell&, const std::vector<results::Verdict>& rows,
                                           const std::vector<results::Verdict>& halved);

}  // namespace cylon::tracking
