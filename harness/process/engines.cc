#include "harness/process/engines.h"

#include "harness/core/input_error.h"
#include "harness/process/engine_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ranges>

namespace cylon::process {
namespace {

namespace fs = std::filesystem;

bool is_in_path(const char* program) {
  const char* path = std::getenv("PATH");
  return std::ranges::any_of(std::views::split(std::string_view(path ? path : ""), ':'), [&](auto folder) {
    return ::access((fs::path(folder.begin(), folder.end()) / program).c_str(), X_OK) == 0;
  });
}

// What the worker of an npm package needs besides itself: Node, and the package beside the script that the worker links to.
bool has_node_and(const char* package, const fs::path& worker) {
  std::error_code error;
  const fs::path folder = fs::canonical(worker, error).parent_path();
  return !error && is_in_path("node") &&
         fs::exists(folder / "node_modules" / package / "package.json", error);
}

bool is_here(const EngineRow& row) {
  std::error_code ignored;
  const fs::path worker = row.command.front();
  if (!fs::exists(worker, ignored)) return false;
  const auto built =
      std::ranges::find(engine_table(), row.id, [](const BuiltEngine& e) { return std::string(e.id); });
  return built == engine_table().end() || std::string_view(built->npm).empty() ||
         has_node_and(built->npm, worker);
}

}  // namespace

std::vector<std::string> compared_engines() {
  std::vector<std::string> ids;
  for (const BuiltEngine& e : engine_table())
    if (e.compared) ids.emplace_back(e.id);
  return ids;
}

std::vector<EngineRow> default_engines(const std::filesystem::path& worker_dir) {
  std::vector<EngineRow> rows;
  // Absolute, so that a worker is never looked up in PATH.
  const std::filesystem::path folder = std::filesystem::absolute(worker_dir);
  for (const BuiltEngine& e : engine_table())
    rows.push_back({e.id,
                    {(folder / fmt::format("cylon-worker-{}", e.build)).string()},
                    e.path,
                    e.brought_by,
                    e.takes_plugins});
  return rows;
}

std::optional<std::string> missing(const EngineRow& row) {
  if (!row.optional() || is_here(row)) return std::nullopt;
  return fmt::format("{} is not here; `{}` brings it", row.id, row.brought_by);
}

std::vector<EngineRow> usual(std::vector<EngineRow> rows) {
  std::erase_if(rows, [](const EngineRow& row) { return row.optional(); });
  return rows;
}

EngineChoice parse_engine(std::string_view text, std::span<const EngineRow> rows) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const std::string id(text.substr(0, slash));
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const EngineRow& r) { return r.id == id; });
  if (row == rows.end()) {
    std::vector<std::string> ids;
    for (const EngineRow& r : rows) ids.push_back(r.id);
    throw core::InputError(fmt::format("unknown engine '{}'{} (engines: {})", id, core::did_you_mean(id, ids),
                                       fmt::join(ids, ", ")));
  }
  EngineChoice choice{std::string(text), *row, "", "", {}};
  std::map<std::string, std::string> pairs;
  for (std::size_t at = slash; at < text.size();) {  // at a slash or a comma, with a pair behind it
    const std::size_t end = std::min(text.find(',', at + 1), text.size());
    const std::string_view pair = text.substr(at + 1, end - at - 1);
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == pair.size())
      throw core::InputError(fmt::format("engine '{}': expected key=value, got '{}'", text, pair));
    const std::string key(pair.substr(0, equals));
    if (!pairs.emplace(key, pair.substr(equals + 1)).second)
      throw core::InputError(fmt::format("engine '{}': '{}' is given twice", text, key));
    at = end;
  }
  if (auto path = pairs.extract("path")) choice.path = path.mapped();
  if (auto integrator = pairs.extract("integrator")) choice.integrator = integrator.mapped();
  if (choice.path.empty()) choice.path = row->path;
  choice.options = std::move(pairs);
  return choice;
}

}  // namespace cylon::process
