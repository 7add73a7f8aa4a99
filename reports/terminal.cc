#include "reports/terminal.h"

#include "reports/text.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>

namespace cylon::reports {
namespace {

struct Look {
  std::string_view utf8, ascii;
  int color;  // SGR parameter
};

// In the order of core::Status.
constexpr std::array looks = {
    Look{"✓", "ok", 32},
    Look{"~", "~", 33},
    Look{"✗", "X", 31},
    Look{"–", "-", 2},
    Look{"☠ crash", "crash", 35},
    Look{"⌛ timeout", "timeout", 35},
    Look{"∞ non-finite", "non-finite", 35},
    Look{"‽ protocol", "protocol", 35},
};

const Look& look(core::Status status) { return looks[static_cast<std::size_t>(status)]; }

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool locale_is_utf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    std::string locale(variable(name));
    if (locale.empty()) continue;
    std::transform(locale.begin(), locale.end(), locale.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return locale.find("utf-8") != std::string::npos || locale.find("utf8") != std::string::npos;
  }
  return false;
}

int width_of(int file_descriptor) {
  winsize size{};
  if (ioctl(file_descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  const std::string_view columns = variable("COLUMNS");
  int width = 0;
  std::from_chars(columns.data(), columns.data() + columns.size(), width);
  return width > 0 ? width : 100;
}

}  // namespace

Terminal terminal_of(int file_descriptor) {
  const bool color = isatty(file_descriptor) && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
  return {.width = width_of(file_descriptor), .utf8 = locale_is_utf8(), .color = color};
}

std::string shown(std::string_view text, const Terminal& terminal) {
  return escaped(text, terminal.utf8 ? is_printable : is_printable_ascii);
}

std::string_view glyph(core::Status status, const Terminal& terminal) {
  return terminal.utf8 ? look(status).utf8 : look(status).ascii;
}

std::string painted(std::string_view text, core::Status status, const Terminal& terminal) {
  if (!terminal.color) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", look(status).color, text);
}

}  // namespace cylon::reports
