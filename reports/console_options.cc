#include "reports/console_options.h"

#include "reports/text.h"

#include <fmt/format.h>

#include <array>

namespace cylon::reports {
namespace {

struct Look {
  std::string_view utf8, ascii;
  int color;  // SGR parameter
};

// In the order of results::Status.
constexpr std::array looks = {
    Look{"✓", "ok", 32},
    Look{"~", "~", 33},
    Look{"✗", "X", 31},
    Look{"?", "?", 36},
    Look{"–", "-", 2},
    Look{"☠ crash", "crash", 35},
    Look{"⌛ timeout", "timeout", 35},
    Look{"∞ non-finite", "non-finite", 35},
    Look{"‽ protocol", "protocol", 35},
};

const Look& look(results::Status status) { return looks[static_cast<std::size_t>(status)]; }

}  // namespace

std::string shown(std::string_view text, const ConsoleOptions& options) {
  if (options.utf8) return escaped(text, is_printable);
  std::string plain(text);
  for (std::size_t at = 0; (at = plain.find("µ", at)) != std::string::npos;) plain.replace(at, 2, "u");
  return escaped(plain, is_printable_ascii);
}

std::string_view glyph(results::Status status, const ConsoleOptions& options) {
  return options.utf8 ? look(status).utf8 : look(status).ascii;
}

std::string painted(std::string_view text, results::Status status, const ConsoleOptions& options) {
  if (!options.colour) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", look(status).color, text);
}

}  // namespace cylon::reports
