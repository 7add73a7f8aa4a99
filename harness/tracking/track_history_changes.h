// Where a row of the history changed, by the rule of its kind, and what somebody said of it.
#pragma once

#include "harness/tracking/track_history_rows.h"

#include <map>

namespace cylon::tracking {

/// The errors of the truths that errors were measured against: differences below are none.
class TruthErrors {
 public:
  explicit TruthErrors(const store::Store& store) : store_(store) {}

  /// Of the claim that a row's metric "error:CLAIM" belongs to, in its latest run; 0 where there is none.
  double of(const HistoryRow&);

 private:
  const store::Store& store_;
  std::map<std::int64_t, std::vector<store::Result>> results_;
};

/// All changes, by index, with the state "detected".
std::vector<HistoryChange> changes_of(const HistoryRow&, double truth_error);

/// Gives the row's changes the states and notes that are kept of them; a kept one that the row does not show
/// is added, not `found`, where the row has its revision.
void add_known(HistoryRow&, const std::vector<store::ChangePoint>&);

}  // namespace cylon::tracking
