// The command line as commands declare it: a small face of CLI11, which parser.cc and app.cc alone include.
// Its headers hold objects with constructors, so that a source which sees them compiles the whole library.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library calls itself so
class App;
class Option;
class Validator;
}  // namespace CLI

namespace cylon::cli {

struct Context;

/// What runs a command once its options are read.
using Command = std::function<int()>;

/// What a value must be; a value that is not is refused with a message.
using Check = std::function<void(CLI::Option&)>;
Check in_range(int least, int most);
Check in_range(double least, double most);
Check one_of(std::vector<std::string> words);
Check whole(std::uint64_t most);  ///< Digits alone, at most `most`: no sign, and nothing wraps.
Check positive(double most);      ///< A number > 0 and at most `most`, NaN refused.

/// An option or an argument; each word returns the option itself, so that they chain.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}
  const Option* operator->() const { return this; }

  Option type_name(const std::string& name) const;  ///< What the help calls its value.
  Option required() const;
  Option check(const Check&) const;
  Option capture_default_str() const;  ///< The help shows the value that it has now.
  Option default_str(const std::string& text) const;
  Option delimiter(char) const;         ///< Between several values in one word.
  Option allow_extra_args(bool) const;  ///< Whether several words may follow one name.
  Option excludes(const Option& other) const;

 private:
  CLI::Option* option_;
};

/// The program, or one of its commands.
class App {
 public:
  explicit App(CLI::App& app) : app_(&app) {}

  /// `names`: "-j,--jobs", or "file" for an argument.  Value: those of parser.cc, std::string, numbers and
  /// vectors of them.
  template <class Value>
  Option add_option(const std::string& names, Value& value, const std::string& meaning);
  /// One of some words, which is handed to `take`.
  Option add_choice(const std::string& names, std::vector<std::string> words,
                    const std::function<void(const std::string&)>& take, const std::string& meaning);
  Option add_flag(const std::string& names, bool& value, const std::string& meaning);
  void footer(const std::string& text);
  /// All words after the command's name, options too, as they stand.
  void take_rest(std::vector<std::string>& words);

  struct Row {
    const char* name;
    const char* summary;
    Command (*add)(App&, const Context&);
  };
  /// A command of its own for each row, one of which is required; `chosen` becomes that which the user names.
  void add_commands(const std::vector<Row>&, const Context&, const std::function<void(Command)>& choose);

  /// What a shell completes: the words of every command below this one.
  struct Words {
    std::string command;
    std::vector<std::string> options, commands;  ///< Of it, and those of its commands too.
  };
  std::vector<Words> words() const;
  /// The one that this is a command of.
  App parent() const;

 private:
  CLI::App* app_;
};

}  // namespace cylon::cli
