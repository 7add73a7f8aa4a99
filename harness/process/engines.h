// The table of engines: an id, the worker that runs it, and the path that it means.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::process {

struct EngineRow {
  std::string id;                    ///< "bullet-multibody"
  std::vector<std::string> command;  ///< Worker and its arguments; looked up in PATH unless it has a slash.
  std::string path;                  ///< Of the engine; "": the engine's own rule.
  std::string brought_by = {};  ///< Of an optional engine: the command that brings it where it is missing.

  bool takes_plugins = false;                ///< Its worker takes the words `--plugin NAME FILE`.
  std::vector<std::string> started_by = {};  ///< Words before the command: a program that starts the worker.

  /// It may be missing, and takes part only where it is named.
  bool optional() const { return !brought_by.empty(); }
};

/// Why an optional engine cannot run: that it is not here, and the command that brings it; nothing where its worker is
/// there, with Node and the npm package that it needs, and of all other engines.
std::optional<std::string> missing(const EngineRow&);

/// The rows that take part where none is named: all but the optional ones.
std::vector<EngineRow> usual(std::vector<EngineRow>);

/// The engines that are built with Cylon, and the optional ones, whether they are here or not.
std::vector<EngineRow> default_engines(const std::filesystem::path& worker_dir);

/// One engine with a variant, as a user asks for it.
struct EngineChoice {
  std::string id;  ///< As given: "bullet/gyro=none,erp=0".
  EngineRow row;
  std::string path;        ///< The variant's, else the row's; "": whatever the run asks for.
  std::string integrator;  ///< The variant's; "": whatever the run asks for.
  std::map<std::string, std::string> options;
};

/// Reads "id", or "id/key=value,key=value" where the keys `path` and `integrator` are reserved and all others
/// are options of the engine.  Throws core::InputError for an unknown id (with the nearest), a key given
/// twice, or a pair without a key or a value.
EngineChoice parse_engine(std::string_view id_with_variant, std::span<const EngineRow> rows);

}  // namespace cylon::process
