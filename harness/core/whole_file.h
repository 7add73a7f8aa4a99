// A file as its bytes.
#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace cylon::core {

/// All bytes of a file; none of one that is not there, or that may be run and not read.  Throws std::system_error where the
/// system could not read it now: no memory, no descriptor.  What is known by its content must not be taken for another.
inline std::string whole_file(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in.is_open()) {
    if (errno == ENOENT || errno == EACCES || errno == ENOTDIR || errno == EISDIR) return "";
    throw std::system_error(errno != 0 ? errno : ENOMEM, std::generic_category(), file.string());
  }
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace cylon::core
