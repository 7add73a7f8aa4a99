#include "harness/cli/parser.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

namespace cylon::cli {
namespace {

Check checked(CLI::Validator validator) {
  return [validator = std::move(validator)](CLI::Option& option) { option.check(validator); };
}

void add_names(const CLI::App& command, std::vector<std::string>& names) {
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) add("--" + name);
    for (const std::string& name : option->get_snames()) add("-" + name);
  }
}

// An empty word is a variable of a script that is not set: as a file it would be none, as a pattern all.
const CLI::Validator not_empty(
    [](std::string& word) { return word.empty() ? std::string("an empty word") : std::string(); }, "");

template <class Value>
constexpr bool holds_words =
    std::is_same_v<Value, std::string> || std::is_same_v<Value, std::vector<std::string>>;

}  // namespace

Check in_range(int least, int most) { return checked(CLI::Range(least, most)); }

// Not the library's: NaN is below no bound, and its message has the digits of 1e300.
Check in_range(double least, double most) {
  return checked({[least, most](std::string& text) {
                    double value = 0;
                    const bool number = CLI::detail::lexical_cast(text, value);
                    return number && value >= least && value <= most
                               ? std::string()
                               : fmt::format("'{}' must be a number from {:g} to {:g}", text, least, most);
                  },
                  ""});
}

Check one_of(std::vector<std::string> words) { return checked(CLI::IsMember(std::move(words))); }

Check whole(std::uint64_t most) {
  return checked({[most](std::string& text) {
                    std::uint64_t value = 0;
                    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
                    const bool all = error == std::errc() && end == text.data() + text.size();
                    return all && value <= most
                               ? std::string()
                               : fmt::format("'{}' must be a whole number, at most {}", text, most);
                  },
                  ""});
}

Check positive(double most) {
  return checked({[most](std::string& text) {
                    double value = 0;
                    const bool number = CLI::detail::lexical_cast(text, value);
                    return number && value > 0 && value <= most
                               ? std::string()
                               : fmt::format("'{}' must be a number > 0, at most {:g}", text, most);
                  },
                  ""});
}

Option Option::type_name(const std::string& name) const { return Option(*option_->type_name(name)); }
Option Option::required() const { return Option(*option_->required()); }
Option Option::check(const Check& check) const {
  check(*option_);
  return *this;
}
Option Option::capture_default_str() const { return Option(*option_->capture_default_str()); }
Option Option::default_str(const std::string& text) const { return Option(*option_->default_str(text)); }
Option Option::delimiter(char c) const { return Option(*option_->delimiter(c)); }
Option Option::allow_extra_args(bool allow) const { return Option(*option_->allow_extra_args(allow)); }
Option Option::excludes(const Option& other) const { return Option(*option_->excludes(other.option_)); }

template <class Value>
Option App::add_option(const std::string& names, Value& value, const std::string& meaning) {
  CLI::Option& option = *app_->add_option(names, value, meaning);
  if constexpr (holds_words<Value>) option.check(not_empty);
  return Option(option);
}
template Option App::add_option(const std::string&, std::string&, const std::string&);
template Option App::add_option(const std::string&, int&, const std::string&);
template Option App::add_option(const std::string&, double&, const std::string&);
template Option App::add_option(const std::string&, std::uint64_t&, const std::string&);
template Option App::add_option(const std::string&, std::optional<std::int64_t>&, const std::string&);
template Option App::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template Option App::add_option(const std::string&, std::vector<double>&, const std::string&);

Option App::add_choice(const std::string& names, std::vector<std::string> words,
                       const std::function<void(const std::string&)>& take, const std::string& meaning) {
  return Option(
      *app_->add_option_function<std::string>(names, take, meaning)->check(CLI::IsMember(std::move(words))));
}

Option App::add_flag(const std::string& names, bool& value, const std::string& meaning) {
  return Option(*app_->add_flag(names, value, meaning));
}

void App::take_rest(std::vector<std::string>& words) {
  app_->prefix_command();
  app_->final_callback([&words, app = app_] { words = app->remaining(); });
}

void App::footer(const std::string& text) { app_->footer(text); }

void App::add_commands(const std::vector<Row>& rows, const Context& context,
                       const std::function<void(Command)>& choose) {
  app_->require_subcommand(1);
  for (const Row& row : rows) {
    CLI::App& command = *app_->add_subcommand(row.name, row.summary);
    App face(command);
    command.parse_complete_callback([choose, run = row.add(face, context)] { choose(run); });
  }
}

std::vector<App::Words> App::words() const {
  const auto all = [](const CLI::App*) { return true; };
  std::vector<Words> words;
  for (const CLI::App* command : std::as_const(*app_).get_subcommands(all)) {
    Words row{command->get_name(), {}, {}};
    add_names(*command, row.options);
    for (const CLI::App* part : command->get_subcommands(all)) {
      row.commands.push_back(part->get_name());
      add_names(*part, row.options);
    }
    words.push_back(row);
  }
  return words;
}

App App::parent() const { return App(*app_->get_parent()); }

}  // namespace cylon::cli
