// Where an engine breaks: one parameter of a scene, taken up or down until something gives, and the value at
// which it does, by bisection.  Knows the families of limits.h's table and no engine.
#pragma once

#include "harness/study/runner.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::study {

/// What became of one value of the parameter.
struct Probed {
  bool holds = true;
  std::string what;  ///< What broke, with its number; empty where it holds.
};

/// The range in which a limit is looked for, and how closely.
struct Range {
  double low = 0, high = 0;  ///< Both > 0, low < high.
  bool downward = false;     ///< The least value that holds is sought, from `high` down; else the largest.
  bool whole = false;        ///< Whole numbers only.
  int per_decade = 3;        ///< Values that are tried in each factor of ten before bisection starts.
  double closeness = 1.005;  ///< The ratio of the bracket's ends at which bisection ends.
};

/// What a search found.
struct Limit {
  enum class Kind {
    found,   ///< Holds at `holds`, breaks at `breaks`.
    none,    ///< Holds over the whole range, at the values tried.
    nowhere  ///< Breaks at the range's first value already.
  };
  Kind kind = Kind::found;
  double holds = 0, breaks = 0;  ///< The bracket; of `none` and `nowhere` one of them, the end of the range.
  std::string what;              ///< What broke first beyond the limit.
  std::vector<double> holds_again;  ///< Values tried beyond the limit that hold: it is not the only one.
  int runs = 0;

  /// The limit itself: the geometric middle of the bracket, or, of whole numbers, the last that holds.
  double value(const Range&) const;
};

/// Tries values of the range in geometric steps from the end that should hold, and those of `also` within it;
/// brackets the first that breaks, and bisects.  All are tried, so that one which holds again is seen.  What
/// breaks in a window between two of them is missed: say in `also` where one is to be feared.
Limit find_limit(const Range&, const std::function<Probed(double)>&, const std::vector<double>& also = {});

/// A value just beyond what theory says, where that lies in the range: windows of instability can be narrow.
std::vector<double> just_beyond(const std::optional<double>& theory, const Range&);

/// A scene with one parameter, and what breaking means.
struct Family {
  const char* name;    ///< "spring"
  const char* asks;    ///< "largest w dt of a spring"
  const char* unit;    ///< Of the parameter; "" for a pure number.
  const char* breaks;  ///< What counts as breaking, in words.
  Range range;
  /// Throws what the runner throws.
  Probed (*probe)(const Runner&, double);
  /// What theory says of an engine (its name) and an integrator: the limit, 0 where it never holds,
  /// infinity where it never breaks; nothing where theory says nothing.
  std::optional<double> (*theory)(std::string_view engine, std::string_view integrator);
};

/// The table.
std::span<const Family> families();

/// The family's limit on an engine.  A crash, a timeout or garbage is breaking, and so is a refusal beyond a
/// value that holds: an engine may know its limit.  Throws RunFailed where the engine refuses from the first.
Limit limit_of(const Family&, const Runner&, const std::optional<double>& theory);

}  // namespace cylon::study
