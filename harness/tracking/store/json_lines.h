// The whole history as JSON Lines: what is written, read into an empty store and written again is the same
// bytes.
#pragma once

#include "harness/tracking/store/store.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace cylon::store {

/// Version of the format; a reader refuses a later one.
inline constexpr int json_lines_version = 1;

/// A line {"cylon_history": 1}, then one for each cell, each run followed by its results, each anchor and
/// each change point; ASCII, numbers with the digits that give the same bits back.
void write_json_lines(const Store&, std::ostream&);

/// What an import has found.
struct Imported {
  std::size_t runs = 0, results = 0, here_already = 0;  ///< `here_already`: results that the store has.
};

/// Adds what such a document holds, in one transaction.  A result that the store has is passed over; another
/// one of the same run and cell is an error.  Of two states of one change point, or two anchors of one name,
/// the later date holds.  Throws core::InputError with the line, the key and the value; `file` is its name.
Imported read_json_lines(Store&, std::string_view document, const std::string& file);

}  // namespace cylon::store
