#include "harness/cli/output.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iostream>

namespace cylon::cli {

namespace fs = std::filesystem;

void require_writable(const std::string& path) {
  if (path.empty() || path == "-") return;
  const fs::path folder = fs::absolute(path).parent_path();
  if (fs::is_directory(path)) throw core::InputError(fmt::format("{}: is a directory, a file is needed", path));
  if (!fs::is_directory(folder)) throw core::InputError(fmt::format("{}: the folder {} is not there", path, folder.string()));
  if (access(folder.c_str(), W_OK) != 0) throw core::InputError(fmt::format("{}: the folder {} cannot be written", path, folder.string()));
}

void write_whole(const std::string& path, std::string_view text) {
  if (path == "-") {
    std::cout << text;
    return;
  }
  require_writable(path);
  const std::string partial = fmt::format("{}.{}.partial", path, getpid());
  std::ofstream out(partial, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) fs::rename(partial, path, error);
  if (!out || error) {
    fs::remove(partial, error);
    throw core::InputError(fmt::format("{}: cannot be written", path));
  }
}

}  // namespace cylon::cli
