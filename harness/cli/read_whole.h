// Files read whole.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace cylon::cli {

/// All bytes of a file; "-" is stdin.  Throws core::InputError where it cannot be read, or has more than
/// `most` bytes (of a device without an end, too).
std::string read_whole(const std::string& path, std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace cylon::cli
