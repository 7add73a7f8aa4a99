// Files read whole.
#pragma once

#include <cstddef>
#include <string>

namespace cylon::cli {

/// All bytes of a file; "-" is stdin.  Throws core::InputError where it cannot be read, or has more than
/// `most` bytes (of a device without an end, too), and for a named pipe into which nobody writes for 5 s.
std::string read_whole(const std::string& path, std::size_t most);

}  // namespace cylon::cli
