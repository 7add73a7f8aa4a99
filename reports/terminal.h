// What the place where a text ends up can show.
#pragma once

#include "harness/core/verdict.h"

#include <string>
#include <string_view>

namespace cylon::reports {

struct Terminal {
  int width = 100;   ///< [columns]; at least 40 is used.
  bool utf8 = true;  ///< false: ASCII only.
  bool color = false;
};

/// Of a file descriptor.  Width: of the terminal, else $COLUMNS, else 100.  UTF-8: as the first of LC_ALL,
/// LC_CTYPE, LANG that is set says.  Colour: on a terminal, unless NO_COLOR is set and not empty or TERM is
/// "dumb".
Terminal terminal_of(int file_descriptor);

/// A foreign text that the terminal can show and that cannot command it.
std::string shown(std::string_view text, const Terminal&);

/// "✓", "~", "✗", "–", "☠ crash", "⌛ timeout", "∞ non-finite", "‽ protocol"; in ASCII "ok", "~", "X", "-",
/// and the words alone.
std::string_view glyph(core::Status, const Terminal&);

/// The text in the status's colour, or as it is on a terminal without colour.
std::string painted(std::string_view text, core::Status, const Terminal&);

}  // namespace cylon::reports
