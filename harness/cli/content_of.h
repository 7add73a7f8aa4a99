// What a command consists of, by content: by it stored answers are known again.
#pragma once

#include <string>
#include <vector>

namespace cylon::cli {

/// A hash of the words of a command.  A word that is a file counts by its bytes, with what belongs to it in the folder where
/// it really lies: the shared libraries that a program names, the modules beside a script and the lock files of its npm
/// packages.  Where a file lies decides nothing.  Libraries of the system do not count.
std::string content_of(const std::vector<std::string>& command);

}  // namespace cylon::cli
