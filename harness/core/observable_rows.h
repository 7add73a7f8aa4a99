// The table of observables: one row for each Quantity.
#pragma once

#include "harness/core/observable.h"
#include "harness/core/truth.h"

namespace cylon::core {

/// A new observable is its functions, its row in observable_rows.cc and its enumerator.
struct ObservableRow {
  Quantity quantity;
  std::string_view name, unit;
  std::optional<std::string> (*undefined_in)(const Observable&, const Scene&);
  void (*evaluate)(const Observable&, const Scene&, const State&, Values&);  ///< Appends to the values.
  double (*distance)(const Values&, const Values&);
  double (*magnitude)(const Values&);
  /// What a drift is compared with; null: the value's magnitude.
  double (*scale)(const Scene&, const State&);
  /// First-order bound, by the triangle inequality, on the error that a state's error makes in the value.
  double (*error)(const Observable&, const Scene&, const State&, const StateError&);
};

const ObservableRow& observable_row(Quantity);

}  // namespace cylon::core
