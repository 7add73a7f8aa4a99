// Comma-separated numbers with a head line, plain or gzip, as other people keep them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cylon::measured {

/// Tables larger than this, unpacked, are refused [bytes].
inline constexpr std::size_t largest_table = std::size_t{256} << 20;

/// Tables of more columns are refused; known data have at most a few dozen.
inline constexpr std::size_t most_columns = 4096;

struct Table {
  std::string file;
  std::string hash;  ///< Of its text, unpacked.
  std::vector<std::string> head;
  std::vector<std::vector<double>> rows;  ///< Each as wide as the head, finite; row i stands in line i + 2.

  /// Index of a column; throws core::InputError with the nearest name.
  std::size_t column(const std::string& name) const;
};

/// Throws core::InputError with file, line and column for what is no such table.
Table read_table(const std::filesystem::path&);

}  // namespace cylon::measured
