// Scenes that nobody wrote: shipped ones with values, keys and tables changed, taken away, or added from the key tables.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cylon::fuzz {

struct SceneFile {
  std::string file, text;
};

/// Shipped scenes and those of the tests, in the order of their names, without those whose truths are certified, which
/// take seconds each.  `source`: the repository.
std::vector<SceneFile> shipped_scenes(const std::filesystem::path& source);

/// The n-th random scene, on every machine the same.
SceneFile random_scene(const std::vector<SceneFile>& shipped, std::uint64_t n);

}  // namespace cylon::fuzz
