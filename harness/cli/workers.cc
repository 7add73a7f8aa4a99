#include "harness/cli/workers.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

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

void add_worker_option(App& app, std::vector<std::string>& workers) {
  app.add_option("--worker", workers,
                 "Add an engine that speaks the worker protocol (docs/protocol.md), the words of its command "
                 "separated by spaces")
      ->type_name("NAME=COMMAND")
      ->allow_extra_args(false);
}

std::vector<process::EngineRow> with_workers(const Context& context,
                                             const std::vector<std::string>& workers) {
  std::vector<process::EngineRow> rows = context.engines;
  for (const std::string& text : workers) {
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
    std::erase_if(rows, [&](const process::EngineRow& other) { return other.id == row.id; });
    rows.push_back(row);
  }
  return rows;
}

}  // namespace cylon::cli
