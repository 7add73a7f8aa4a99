#include "reference/applied/options.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace cylon::applied {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

double number(const std::string& engine, const Option& option, const std::string& given) {
  double x = 0;
  const char* const end = given.data() + given.size();
  const auto [stop, error] = std::from_chars(given.data(), end, x);
  const bool inside = (option.above ? x > option.least : x >= option.least) && x <= option.most;
  if (error == std::errc() && stop == end && inside && (!option.whole || x == std::floor(x))) return x;
  const std::string range =
      option.most == largest
          ? fmt::format("{} {}", option.above ? "above" : "from", option.least)
          : fmt::format("in {}{}, {}]", option.above ? '(' : '[', option.least, option.most);
  throw std::invalid_argument(fmt::format("{}: option {} = '{}' is not a {}number {}", engine, option.name,
                                          given, option.whole ? "whole " : "finite ", range));
}

}  // namespace

std::string text(const Option& option, double value) {
  return option.words.empty() ? fmt::format("{}", value) : option.words[static_cast<std::size_t>(value)];
}

void require(const std::string& engine, const std::string& kind, const std::string& word,
             const std::vector<std::string>& valid) {
  if (std::ranges::find(valid, word) != valid.end()) return;
  throw std::invalid_argument(fmt::format("{}: no {} '{}'{} (valid: {})", engine, kind, word,
                                          core::did_you_mean(word, valid), fmt::join(valid, ", ")));
}

const Option& Options::row(std::string_view name) const {
  const auto found = std::ranges::find(rows_, name, &Option::name);
  if (found == rows_.end()) throw std::logic_error(fmt::format("unknown setting '{}'", name));
  return *found;
}

Values Options::defaults() const {
  Values values;
  for (const Option& option : rows_) values[option.name] = option.engine_default;
  return values;
}

void Options::set(Values& values, const std::string& option, const std::string& given) const {
  std::vector<std::string> names;
  for (const Option& one : rows_) names.emplace_back(one.name);
  require(engine_, "option", option, names);
  const Option& found = row(option);
  if (found.words.empty()) {
    values[option] = number(engine_, found, given);
    return;
  }
  require(engine_, "value of option " + option, given, found.words);
  values[option] = static_cast<double>(std::ranges::find(found.words, given) - found.words.begin());
}

std::vector<core::Option> Options::offered() const {
  std::vector<core::Option> all;
  for (const Option& one : rows_)
    all.push_back({one.name, one.words, text(one, one.engine_default), one.meaning});
  return all;
}

}  // namespace cylon::applied
