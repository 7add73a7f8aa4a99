// Delimited text with a head line, plain or gzip, as other people keep it.
#pragma once

#include "harness/core/input_error.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::measured {

/// Tables larger than this, unpacked, are refused [bytes].
inline constexpr std::size_t largest_table = std::size_t{256} << 20;

/// Tables of more columns are refused; known data have at most a few dozen.
inline constexpr std::size_t most_columns = 4096;

/// Cells are read when somebody asks for them: a column that nobody needs may hold anything.
class Table {
 public:
  /// Cells stand between commas, or, where the head line has none, between semicolons or tabs.  Quotes around a cell, a byte order
  /// mark, lines of '#' before the head and empty lines at the end are left out.  Throws core::InputError with file, line and column
  /// for what is no such table.
  explicit Table(const std::filesystem::path&);

  const std::string& file() const { return file_; }
  const std::string& hash() const { return hash_; }  ///< Of its text, unpacked.
  std::size_t rows() const { return starts_.size() / head_.size(); }
  std::size_t columns() const { return head_.size(); }

  /// Index of a column; throws core::InputError with the nearest name.
  std::size_t column(const std::string& name) const;

  std::string_view word(std::size_t row, std::size_t column) const;
  /// Throws core::InputError where it is no finite number.
  double number(std::size_t row, std::size_t column) const;

  core::InputError refuse(std::size_t row, const std::string& why) const;

 private:
  void read_head(std::string_view line, std::size_t number);
  void require_width(std::size_t columns, std::size_t line) const;

  std::string file_, hash_, text_;
  char separator_ = ',';
  std::size_t head_line_ = 1;
  std::vector<std::string> head_;
  std::vector<std::uint32_t> starts_;  // of cells in the text, row by row
};

}  // namespace cylon::measured
