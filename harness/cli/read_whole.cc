#include "harness/cli/read_whole.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <iostream>

namespace cylon::cli {

std::string read_whole(const std::string& path, std::size_t most) {
  std::ifstream file;
  if (path != "-") file.open(path, std::ios::binary);
  std::istream& in = path == "-" ? std::cin : file;
  const auto unreadable = [&] { return core::InputError(fmt::format("{}: cannot be read", path)); };
  if (path != "-" && !file.is_open()) throw unreadable();
  std::string text;
  std::array<char, 1 << 16> piece;
  while (in.read(piece.data(), piece.size()) || in.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > most) throw core::InputError(fmt::format("{}: more than {} MB", path, most >> 20));
  }
  if (in.bad()) throw unreadable();  // a directory
  return text;
}

}  // namespace cylon::cli
