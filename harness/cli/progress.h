// How far a command is: one line of a terminal, written over.
#pragma once

#include <string_view>

namespace cylon::cli {

/// Writes the line to stderr over the last one, where `on` says that stderr is a terminal (Context::progress); an empty one
/// leaves none.
void show_progress(bool on, std::string_view line);

}  // namespace cylon::cli
