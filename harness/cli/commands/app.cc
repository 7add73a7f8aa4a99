#include "harness/cli/commands/app.h"

#include "harness/cli/command_line.h"
#include "harness/cli/output.h"
#include "harness/core/input_errors.h"
#include "harness/imports/imports.h"
#include "harness/process/interruption.h"
#include "harness/process/sandbox.h"
#include "harness/seal/seal.h"
#include "harness/tracking/track.h"
#include "reference/measured/claim_truth.h"
#include "reports/text.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace cylon::cli {

namespace {

const std::vector<App::Row> commands = {
    {"list", "List the scenarios and their claims", add_list},
    {"engines", "List the engines, their settings and their known limits", add_engines},
    {"validate", "Check scenario files without running them", add_validate},
    {"plan", "Show which stages an engine uses for a scenario, and why", add_plan},
    {"simulate", "Run one engine on one scenario and print its states as CSV", add_simulate},
    {"truth", "Print the certified solution of a scenario, with its error bound", add_truth},
    {"run", "Run scenarios on engines and check every claim", add_run},
    {"merge", "Join the parts of a run, sweep or search that was done in shards", add_merge},
    {"farm", "Share a run, sweep or search out over the ranks of an MPI job", add_farm},
    {"report", "Build an HTML report from run, trade and track output", add_report},
    {"matrix", "Print the coarsest step of each engine that meets an error, and its cost", add_matrix},
    {"trade", "Measure error and CPU time of each engine, integrator and step", add_trade},
    {"diff", "Find where two runs first differ, and by how much", add_diff},
    {"advise", "Find the cheapest setting of each engine that meets a tolerance", add_advise},
    {"limits", "Find the limits of each engine and integrator by bisection", add_limits},
    {"hunt", "Look for faults of an engine in random scenes, and shrink each", add_hunt},
    {"predict", "Hold engines against measured motions, with intervals", add_predict},
    {"fit", "Fit a model's parameters to measured motions, with intervals", add_fit},
    {"selfcheck", "Compare published numbers of other suites with results of the same scenes here",
     add_selfcheck},
    {"track", "Record the history of accuracy and speed, and compare builds", tracking::add_track},
    {"view", "Show a scenario live in the browser, with controls", add_view},
    {"import", "Make a scenario of an MJCF, SDFormat or URDF file", add_import},
    {"export", "Write a scenario as an MJCF or SDFormat file", add_export},
    {"new", "Write a commented template of a scenario", add_new},
    {"doctor", "Check that everything Cylon needs is installed and works", add_doctor},
    {"completion", "Print the completion script of a shell", add_completion},
};

// Commands inherit the footer with the exit codes; this is the program's alone.
constexpr const char* environment =
    "Environment:\n"
    "  CYLON_SCENARIOS             Folder of scenarios, with suites/ and expected.toml. Default: the one "
    "that comes with cylon\n"
    "  CYLON_WORKERS               Folder of cylon-worker-*. Default: those that come with cylon\n"
    "  CYLON_CACHE                 Folder of certified solutions; off: none. Default: $XDG_CACHE_HOME/cylon, "
    "else ~/.cache/cylon\n"
    "  CYLON_KEY                   File of your key, which seals what is kept. Default: "
    "$XDG_CONFIG_HOME/cylon/key, else "
    "~/.config/cylon/key";

// Its options, and its commands where it has any.
std::vector<std::string> words_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// "cylon rnu": the library would only say that a command is required.
void refuse_unknown_command(const std::string& word) {
  std::vector<std::string> names;
  for (const App::Row& row : commands) names.emplace_back(row.name);
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  if (word == "help")
    throw core::InputError(
        "'help' is no command: write `cylon --help`, or `cylon COMMAND --help` of one command");
  throw core::InputError(fmt::format("unknown command '{}'{} (commands: {})", word,
                                     core::did_you_mean(word, names), fmt::join(names, ", ")));
}

// The library says no more than a name: "b is required".
std::string missing_in(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* one : command.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(one->get_name());
  if (!names.empty()) return fmt::format("a command is missing (commands: {})", fmt::join(names, ", "));
  for (const CLI::Option* option : command.get_options())
    if (option->get_required() && option->count() == 0)
      return fmt::format("{} is missing: {}", option->get_name(), option->get_description());
  return "";
}

// What the library says of a command line that it cannot take, with the nearest option.
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* deepest = &app;
  std::string name = "cylon";
  while (!deepest->get_subcommands().empty()) {
    deepest = deepest->get_subcommands().front();
    name += " " + deepest->get_name();
  }
  const CLI::App& command = *deepest;
  std::string message = error.what();
  if (const std::string missing = missing_in(command);
      error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError) && !missing.empty())
    message = fmt::format("{}: {}", name, missing);
  if (const auto extra = app.remaining(true); !extra.empty()) {
    const std::string word = extra.front().substr(0, extra.front().find('='));
    message = fmt::format("{}: unexpected '{}'{}", name, extra.front(),
                          core::did_you_mean(word, words_of(command)));
  }
  return fmt::format("{}\n`{} --help` shows the valid options", plain(message), name);
}

// Lines after the first begin with spaces, so that none of a foreign name is taken for a message of its own.
std::string indented(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; ++at)
    if (!std::string_view(text).substr(at + 1).starts_with("  ")) text.insert(at + 1, "  ");
  return text;
}

// Whether nobody reads what is written to stdout any more: `cylon engines | head`.
bool reader_left() {
  pollfd out{STDOUT_FILENO, 0, 0};
  return ::poll(&out, 1, 0) > 0 && (out.revents & POLLERR) != 0;
}

// A full disk shows in the stream alone, and what was cut must not look whole.  A reader that left wants no more, and
// the exit code is that of a program which the closed pipe ends.
int with_whole_output(int code) {
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::cout) return code;
  if (reader_left()) return code == bad_input || code == interrupted ? code : no_reader;
  std::cerr << "error: stdout cannot be written: what it has got is not whole\n";
  return code == bad_input || code == interrupted ? code : harness_failure;
}

void show_one(const core::InputError& error) {
  std::cerr << "error: " << indented(plain(error.what())) << '\n';
  if (error.line == 0) return;
  std::ifstream file(error.file);
  std::string line;
  for (unsigned i = 0; i < error.line; ++i)
    if (!std::getline(file, line)) return;
  if (line.size() > 160) return;
  std::string margin;
  for (std::size_t i = 0; i + 1 < error.column && i < line.size(); ++i)
    margin += line[i] == '\t' ? '\t' : ' ';
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 32 && c != '\t') c = '?';
  std::cerr << fmt::format(
      "  {}\n  {}^\n",
      reports::escaped(line, [](char32_t c) { return c == U'\t' || reports::is_printable(c); }), margin);
}

}  // namespace

void show(const core::InputError& error) {
  const auto* several = dynamic_cast<const core::InputErrors*>(&error);
  if (several == nullptr) return show_one(error);
  for (const core::InputError& one : several->each) show_one(one);
}

namespace {

// The standard library's folders and threads let no exception out, so that lack of memory in them ends here.  What
// is kept by then can be resumed; workers die with this process.
[[noreturn]] void fail_at_once() {
  constexpr std::string_view text = "internal error: out of memory, or an exception that nothing may catch\n";
  [[maybe_unused]] const ssize_t told = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(harness_failure);
}

// Whether a path that somebody gave cannot be looked up.
bool is_of_a_name(const std::error_code& code) {
  return code == std::errc::filename_too_long || code == std::errc::too_many_symbolic_link_levels ||
         code == std::errc::permission_denied;
}

int run_command_line(int argc, char** argv) {
  std::set_terminate(fail_at_once);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its limit is a write that fails
  CLI::App app{"Cylon: run the same scenes on several physics engines and compare them with exact solutions.",
               "cylon"};
  app.set_version_flag("--version", "cylon " CYLON_VERSION);
  app.add_flag_callback(
      "--no-cache", [] { ::setenv("CYLON_CACHE", "off", 1); },
      "Compute certified solutions anew and do not cache them (like CYLON_CACHE=off)");
  app.add_flag_callback(
      "--sandbox",
      [] {
        process::require_sandbox();
        process::hidden_in_sandboxes() = seal::secret_places();
        process::sandboxing() = true;
      },
      "Run engines in a sandbox (bubblewrap): no network, no files but read-only ones of the system, of this "
      "folder and of the engine. What began with it is resumed only with it");
  app.footer(
      "Exit codes: 0 all as expected, 1 a verdict differs, a regression is confirmed, recordings differ "
      "(diff), a fault "
      "is found (hunt), no setting meets the tolerance (advise) or a fit fails, 2 bad input, 3 "
      "undecided (with --strict) or a bound not reached (truth), 4 nothing selected or compared, 5 internal "
      "failure, 6 cells are missing (merge), 130 "
      "interrupted, 141 nobody read the output to its end.");
  Context context = make_context();
  imports::serve_scenarios(
      context.workers, [](const std::string& text) { std::cerr << plain_line("left out: " + text) << '\n'; });
  measured::serve_scenarios();
  const std::vector<std::string> words(argv, argv + argc);
  context.command_line = shell_command(words);
  note_words(words);
  Command chosen;
  App(app).add_commands(commands, context, [&chosen](Command command) { chosen = std::move(command); });
  app.footer(app.get_footer() + "\n\n" + environment);
  try {
    if (argc > 1) refuse_unknown_command(argv[1]);
    app.parse(argc, argv);
    return with_whole_output(chosen());
  } catch (const CLI::Success& success) {
    return with_whole_output(app.exit(success));  // --help and --version
  } catch (const CLI::ParseError& error) {
    std::cerr << (argc > 1 ? fmt::format("error: {}\n", complaint_of(app, error)) : app.help());
    return bad_input;
  } catch (const core::InputError& error) {
    show(error);
    return bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    if (!is_of_a_name(error.code())) throw;
    std::cerr << "error: "
              << plain_line(fmt::format("{}: {}", error.path1().string(), error.code().message())) << '\n';
    return bad_input;
  } catch (const std::system_error& error) {  // no process, no thread, no descriptor
    std::cerr << "error: the harness failed: " << plain_line(error.what()) << '\n';
    return harness_failure;
  } catch (const process::Interrupted&) {
    std::cerr << "interrupted\n";
    return interrupted;
  }
}

}  // namespace

int run_words(const Context& context, const std::vector<std::string>& words) {
  CLI::App app{"", "cylon"};
  Command chosen;
  App(app).add_commands(commands, context, [&chosen](Command command) { chosen = std::move(command); });
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // the library takes them from the end
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help
  } catch (const CLI::ParseError& error) {
    throw core::InputError(complaint_of(app, error));
  }
  return chosen();
}

int main(int argc, char** argv) {
  try {
    return run_command_line(argc, argv);
  } catch (const std::exception& error) {  // no memory, also before there is a command
    std::cerr << "internal error: " << plain_line(error.what()) << '\n';
    return harness_failure;
  }
}

}  // namespace cylon::cli
