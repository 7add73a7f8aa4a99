// Which files are scenes in a format of others, by their endings.
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

namespace cylon::scenario {

/// "MJCF", "SDFormat", "URDF", or "" for a file of none of them.
inline std::string_view foreign_format(const std::filesystem::path& file) {
  constexpr std::pair<const char*, std::string_view> endings[] = {
      {".xml", "MJCF"}, {".mjcf", "MJCF"}, {".sdf", "SDFormat"}, {".world", "SDFormat"}, {".urdf", "URDF"}};
  for (const auto& [ending, format] : endings)
    if (file.extension() == ending) return format;
  return "";
}

}  // namespace cylon::scenario
