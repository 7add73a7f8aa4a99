// The options of ODE by our names: a table of what each takes and sets.
#pragma once

#include "reference/simulators/ode/ode_settings.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::simulators {

/// A word out of some, or a number within bounds.
struct OdeOption {
  const char* name;
  std::vector<std::string> words;  ///< None: a number.
  const char* engine_default;      ///< "none": ODE leaves it to its caller.
  const char* meaning;
  void (*set)(OdeSettings&, double);  ///< The place among the words, or the number.
  double least = 0, most = 0;
  bool open = false;      ///< The bounds themselves are senseless.
  bool whole = false;     ///< A whole number.
  bool of_quick = false;  ///< dWorldQuickStep alone reads it.
};

std::span<const OdeOption> ode_options();

/// Sets an option to what was given.  Throws std::invalid_argument, naming the nearest valid one, for what is
/// no option or no value of it.
void ode_set(OdeSettings&, const std::string& option, const std::string& given);

/// Throws std::invalid_argument, naming the nearest valid one, for a word that is none of them.
void ode_require(const std::string& kind, const std::string& word, const std::vector<std::string>& valid);

}  // namespace cylon::simulators
