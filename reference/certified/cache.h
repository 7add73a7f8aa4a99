// Certified solutions on disk, so that a scenario costs its integration once.
#pragma once

#include "reference/certified/dense.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace cylon::certified {

/// $CYLON_CACHE, else $XDG_CACHE_HOME/cylon, else $HOME/.cache/cylon; nothing where none is set or
/// CYLON_CACHE is "off".
std::optional<std::filesystem::path> cache_folder();

/// The solution that a file of the cache holds behind its seal; nothing where Dense::at() cannot be asked of
/// these bytes.
std::optional<Dense> parse_body(std::string_view body);

/// The solution of this key; nothing where there is none, or where the file is damaged or of another format.
std::optional<Dense> load(const std::string& key);

/// Writes it whole or not at all (a temporary file, then a rename); a folder that cannot be written to is no
/// error.
void keep(const std::string& key, const Dense&);

}  // namespace cylon::certified
