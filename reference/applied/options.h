// The options of an engine by our names, as adapters of optional engines have them: a table of what each takes, what
// the engine calls it, and the engine's own value.
#pragma once

#include "harness/core/engine.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::applied {

/// A word out of some, or a number within bounds.
struct Option {
  const char* name;
  const char* setting;             ///< The engine's own name.
  int place = 0;                   ///< Where the engine has it; the adapter says what a number means.
  std::vector<std::string> words;  ///< None: a number.
  double engine_default;           ///< The number, or the place among the words.
  const char* meaning;
  double least = 0, most = 0;
  bool whole = false;  ///< A whole number.
  bool above = false;  ///< `least` itself is senseless.
};

/// Every option by its name: its number, or the place of its word.
using Values = std::map<std::string, double, std::less<>>;

/// A value as a report shows it.
std::string text(const Option&, double value);

/// Throws std::invalid_argument, naming the nearest valid one, for a word that is none of them.
void require(const std::string& engine, const std::string& kind, const std::string& word,
             const std::vector<std::string>& valid);

class Options {
 public:
  Options(std::string engine, std::vector<Option> rows)
      : engine_(std::move(engine)), rows_(std::move(rows)) {}

  const std::string& engine() const { return engine_; }
  std::span<const Option> rows() const { return rows_; }

  /// Throws std::logic_error for a name that is no option.
  const Option& row(std::string_view name) const;

  /// The engine's own.
  Values defaults() const;

  /// Sets an option to what was given.  Throws std::invalid_argument, naming the nearest valid one, for what is
  /// no option or no value of it.
  void set(Values&, const std::string& option, const std::string& given) const;

  /// As the engine offers them.
  std::vector<core::Option> offered() const;

 private:
  std::string engine_;
  std::vector<Option> rows_;
};

}  // namespace cylon::applied
