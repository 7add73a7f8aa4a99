// Text that came from somewhere else (an engine's stderr, a title), made fit for a terminal, XML or CSV.
// Knows nothing of verdicts.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace cylon::reports {

/// One Unicode scalar value, or one byte that is no UTF-8.
struct Symbol {
  char32_t code = 0;  ///< The scalar value, or the byte where `valid` is false.
  bool valid = false;
  std::string_view bytes;  ///< As found.
};

/// Takes the first symbol off a non-empty text.  Overlong forms, surrogates and values above U+10FFFF
/// are invalid (Unicode 15, table 3-7).
Symbol take_symbol(std::string_view& text);

/// The text with each symbol that `keep` refuses, and each byte that is no UTF-8, written as \n, \t, \r,
/// \xNN or \u{NNNN}.
std::string escaped(std::string_view text, bool (*keep)(char32_t));

/// Neither a control character nor one that moves, hides or reorders its neighbours (bidirectional
/// overrides, zero-width characters, line separators).
bool is_printable(char32_t);
bool is_printable_ascii(char32_t);

/// A character, and what stands for it.
using Substitute = std::pair<char, std::string_view>;

/// The text with every character that the table has replaced.
std::string substituted(std::string_view text, std::span<const Substitute> table);

/// Columns that printable text takes on a terminal: 0 for combining marks, 2 for wide (East Asian, emoji)
/// characters, else 1.  (Unicode TR 11, whole blocks.)
int display_width(std::string_view);

/// "1 engine", "3 engines", "0 bodies".
std::string counted(std::size_t, std::string_view one, std::string_view many = "");

/// The text followed by spaces up to `width` columns; a longer text is cut and ends in `ellipsis`.
std::string fitted(std::string_view text, int width, std::string_view ellipsis);

/// The first `bytes` bytes of a longer text, cut between symbols, with the number of bytes left out.
std::string head(std::string_view text, std::size_t bytes);

/// The last `bytes` bytes of a longer text, likewise.
std::string tail(std::string_view text, std::size_t bytes);

}  // namespace cylon::reports
