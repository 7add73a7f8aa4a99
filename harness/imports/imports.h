// Scenes of other projects: MJCF, SDFormat and URDF, each read by the library of its format, in a process of its own.
// What a scene cannot say is told, or the file is refused.
#pragma once

#include "harness/imports/losses.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::imports {

struct Options {
  bool keep_axes = false;              ///< z stays up.
  bool fixed_base = false;             ///< Of a URDF: its root does not move.
  bool strict = false;                 ///< Every loss is an error.
  std::string keyframe;                ///< Of an MJCF: the start.
  double duration = 1;                 ///< At least [s]; a whole number of steps.
  std::vector<std::string> leave_out;  ///< Kinds of loss that are no refusal.
  std::vector<std::string> roots;      ///< Folders in which package:// and model:// are looked for.
};

struct Imported {
  std::string toml;                   ///< A scenario file.
  std::vector<std::string> left_out;  ///< For people; names in them may hold any characters.
};

/// Throws core::InputError where the library of the format is not here, refuses the file, crashes or takes too long, and
/// where a scene cannot say what the file says: all of it at once, each with file, line and element.
/// `programs`: the folder with cylon-import-*.
Imported import_file(const std::filesystem::path&, const Options&, const std::filesystem::path& programs);

/// From now on scenario::read takes such files too.  `left_out` gets what is left out, a text at a time, which may hold
/// any characters that the file has.
void serve_scenarios(const std::filesystem::path& programs,
                     const std::function<void(const std::string&)>& left_out);

}  // namespace cylon::imports
