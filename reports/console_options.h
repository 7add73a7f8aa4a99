// What the place where a text ends up can show.
#pragma once

#include "harness/results/verdict.h"

#include <string>
#include <string_view>

namespace cylon::reports {

struct ConsoleOptions {
  int width = 100;   ///< [columns]; at least 40 is used.
  bool utf8 = true;  ///< false: ASCII only.
  bool colour = false;
};

/// A foreign text that the terminal can show and that cannot command it.
std::string shown(std::string_view text, const ConsoleOptions&);

/// "✓", "~", "✗", "–", "☠ crash", "⌛ timeout", "∞ non-finite", "‽ protocol"; in ASCII "ok", "~", "X", "-",
/// and the words alone.
std::string_view glyph(results::Status, const ConsoleOptions&);

/// The text in the status's colour, or as it is on a terminal without colour.
std::string painted(std::string_view text, results::Status, const ConsoleOptions&);

}  // namespace cylon::reports
