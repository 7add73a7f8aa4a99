#include "harness/cli/workers.h"

#include "harness/cli/command_line.h"
#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>
#include <system_error>

namespace cylon::cli {
namespace {

// Whether a shell would find the program.
bool is_program(const std::string& word) {
  if (word.find('/') != std::string::npos) return access(word.c_str(), X_OK) == 0;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((std::filesystem::path(folder) / word).c_str(), X_OK) == 0) return true;
  return false;
}

}  // namespace

void add_brought_options(App& app, Brought& brought) {
  app.add_option("--worker", brought.workers,
                 "Add an engine that speaks the worker protocol (docs/protocol.md), the words of its command "
                 "separated by spaces")
      ->type_name("NAME=COMMAND")
      ->allow_extra_args(false);
  app.add_option("--plugin", brought.plugins,
                 "Let scenarios use forces of your own: the shared library FILE, which they call NAME "
                 "(docs/in-house.md). It is code that runs as you do")
      ->type_name("NAME=FILE")
      ->allow_extra_args(false);
}

void add_plugins(std::vector<process::EngineRow>& rows, const std::vector<std::string>& plugins) {
  namespace fs = std::filesystem;
  std::set<std::string> names;
  for (const std::string& text : plugins) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = text.substr(0, equals), file = text.substr(std::min(equals + 1, text.size()));
    if (name.empty() || file.empty())
      throw core::InputError(fmt::format("--plugin '{}': must be NAME=FILE", text));
    if (!names.insert(name).second)
      throw core::InputError(fmt::format("--plugin '{}': '{}' is given twice", text, name));
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored))
      throw core::InputError(fmt::format("--plugin '{}': there is no file '{}'", text, file));
    // Absolute, so that it is never looked up in a path of libraries.
    for (process::EngineRow& row : rows)
      if (row.takes_plugins)
        row.command.insert(row.command.end(), {"--plugin", name, fs::canonical(file).string()});
  }
}

std::vector<process::EngineRow> with_brought(const Context& context, const Brought& brought) {
  std::vector<process::EngineRow> rows = context.engines;
  std::set<std::string> names;
  for (const std::string& text : brought.workers) {
    const std::size_t equals = text.find('=');
    std::istringstream words(equals == std::string::npos ? "" : text.substr(equals + 1));
    process::EngineRow row;
    row.id = text.substr(0, equals);
    for (std::string word; words >> word;) row.command.push_back(word);
    if (row.id.empty() || row.command.empty() || row.id.find_first_of("/*? ") != std::string::npos)
      throw core::InputError(
          fmt::format("--worker '{}': must be NAME=COMMAND, the name without '/', '*', '?' or spaces", text));
    if (!is_program(row.command.front()))
      throw core::InputError(
          fmt::format("--worker '{}': there is no program '{}'", text, row.command.front()));
    if (!names.insert(row.id).second)
      throw core::InputError(fmt::format("--worker '{}': '{}' is given twice", text, row.id));
    if (std::erase_if(rows, [&](const process::EngineRow& other) { return other.id == row.id; }) > 0)
      std::cerr << plain_line(
                       fmt::format("--worker '{}' stands in for the engine '{}' of Cylon", text, row.id))
                << '\n';
    rows.push_back(row);
  }
  add_plugins(rows, brought.plugins);
  return rows;
}

}  // namespace cylon::cli
