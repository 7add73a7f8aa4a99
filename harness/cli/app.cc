#include "harness/cli/app.h"

#include "harness/core/input_error.h"
#include "harness/process/child.h"

#include <fmt/format.h>

#include <csignal>
#include <fstream>
#include <iostream>
#include <sstream>

namespace cylon::cli {
namespace {

struct Row {
  const char* name;
  const char* summary;
  Command (*add)(CLI::App&, const Context&);
};

constexpr Row commands[] = {
    {"list", "Scenarios, with what each claims", add_list},
    {"engines", "Engines, with every forced setting and what could not be switched off", add_engines},
    {"validate", "Check scenario files without running them", add_validate},
    {"simulate", "Run one engine on one scenario and print its states as CSV", add_simulate},
    {"run", "Run scenarios on engines and judge every claim", add_run},
    {"new", "Write a commented scenario to start from", add_new},
    {"doctor", "Check that everything Cylon needs is here and works", add_doctor},
    {"completion", "Print the completion script of a shell", add_completion},
};

// The offending line with a caret under the column, where the file can be read again.
void show_place(const core::InputError& error) {
  if (error.line == 0) return;
  std::ifstream file(error.file);
  std::string line;
  for (unsigned i = 0; i < error.line; ++i)
    if (!std::getline(file, line)) return;
  if (line.size() > 160) return;
  std::string margin;
  for (std::size_t i = 0; i + 1 < error.column && i < line.size(); ++i) margin += line[i] == '\t' ? '\t' : ' ';
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 32 && c != '\t') c = '?';
  std::cerr << "  " << line << "\n  " << margin << "^\n";
}

void interrupt(int) { process::interrupted() = true; }

}  // namespace

void add_worker_option(CLI::App& app, std::vector<std::string>& workers) {
  app.add_option("--worker", workers, "Add an engine behind the worker protocol (docs/protocol.md), its command's words separated by spaces")
      ->type_name("NAME=COMMAND")
      ->expected(1)
      ->take_all();
}

std::vector<process::EngineRow> with_workers(const Context& context, const std::vector<std::string>& workers) {
  std::vector<process::EngineRow> rows = context.engines;
  for (const std::string& text : workers) {
    const std::size_t equals = text.find('=');
    std::istringstream words(equals == std::string::npos ? "" : text.substr(equals + 1));
    process::EngineRow row;
    row.id = text.substr(0, equals);
    for (std::string word; words >> word;) row.command.push_back(word);
    if (row.id.empty() || row.command.empty() || row.id.find_first_of("/*? ") != std::string::npos)
      throw core::InputError(fmt::format("--worker '{}': must be NAME=COMMAND, the name without '/', '*', '?' or spaces", text));
    std::erase_if(rows, [&](const process::EngineRow& other) { return other.id == row.id; });
    rows.push_back(row);
  }
  return rows;
}

int main(int argc, char** argv) {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  std::signal(SIGPIPE, SIG_IGN);
  CLI::App app{"Cylon: the same scenes on every physics engine, judged against exact mechanics.", "cylon"};
  app.set_version_flag("--version", "cylon " CYLON_VERSION);
  app.require_subcommand(1);
  app.footer("Exit codes: 0 all as expected, 1 a verdict differs, 2 bad input, 4 nothing selected, 5 harness failure, 130 interrupted.");
  const Context context = make_context();
  Command chosen;
  for (const Row& row : commands) {
    CLI::App& command = *app.add_subcommand(row.name, row.summary);
    command.parse_complete_callback([&chosen, run = row.add(command, context)] { chosen = run; });
  }
  try {
    app.parse(argc, argv);
    const int code = chosen();
    std::cout.flush();
    return code;
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? ok : bad_input;
  } catch (const core::InputError& error) {
    std::cerr << "error: " << error.what() << '\n';
    show_place(error);
    return bad_input;
  } catch (const process::Interrupted&) {
    std::cerr << "interrupted\n";
    return interrupted;
  } catch (const std::exception& error) {
    std::cerr << "internal error: " << error.what() << '\n';
    return harness_failure;
  }
}

}  // namespace cylon::cli
