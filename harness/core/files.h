// Files by which an engine is known again: what the system cannot read now must not be taken for something else.
#pragma once

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace cylon::core {

/// All bytes of a file; none of one that is not there, or that may be run and not read.  Throws std::system_error where the
/// system cannot read it now: no memory, no descriptor.
inline std::string whole_file(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in.is_open()) {
    if (errno == ENOENT || errno == EACCES || errno == ENOTDIR) return "";
    throw std::system_error(errno != 0 ? errno : ENOMEM, std::generic_category(), file.string());
  }
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The entries of a folder, by the same rule.
inline std::filesystem::directory_iterator entries_of(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::directory_iterator entries(folder, error);
  if (error && error != std::errc::no_such_file_or_directory && error != std::errc::permission_denied &&
      error != std::errc::not_a_directory)
    throw std::system_error(error, folder.string());
  return entries;
}

}  // namespace cylon::core
