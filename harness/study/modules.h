// The files that a script may read its code from.
#pragma once

#include <filesystem>
#include <vector>

namespace cylon::study {

/// Of a script in JavaScript or Python: the other files of its folder with its extension, and the lock files of its npm
/// packages, by name.  Nothing of any other file.  A link counts as what it points to.
std::vector<std::filesystem::path> modules_beside(const std::filesystem::path& script);

}  // namespace cylon::study
