#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace cylon::reports {
namespace {

struct Range {
  char32_t first, last;
};

template <std::size_t N>
bool within(const std::array<Range, N>& ranges, char32_t code) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [&](const Range& r) { return r.first <= code && code <= r.last; });
}

constexpr std::array unprintable = {
    Range{0x00, 0x1F},     Range{0x7F, 0x9F},     Range{0xAD, 0xAD},      // C0, delete and C1, soft hyphen
    Range{0x061C, 0x061C}, Range{0x180E, 0x180E}, Range{0x200B, 0x200F},  // zero width, direction marks
    Range{0x2028, 0x202E}, Range{0x2060, 0x206F}, Range{0xFEFF, 0xFEFF},  // separators, overrides, isolates
    Range{0xFFF9, 0xFFFB}, Range{0xFFFE, 0xFFFF}, Range{0xE0000, 0x10FFFF}};

constexpr std::array zero_wide = {Range{0x0300, 0x036F}, Range{0x1AB0, 0x1AFF}, Range{0x1DC0, 0x1DFF},
                                  Range{0x20D0, 0x20FF}, Range{0xFE00, 0xFE0F}, Range{0xFE20, 0xFE2F}};

constexpr std::array double_wide = {Range{0x1100, 0x115F},   Range{0x231A, 0x231B},   Range{0x23E9, 0x23EC},
                                    Range{0x2E80, 0x303E},   Range{0x3041, 0xA4CF},   Range{0xAC00, 0xD7A3},
                                    Range{0xF900, 0xFAFF},   Range{0xFE30, 0xFE6F},   Range{0xFF00, 0xFF60},
                                    Range{0xFFE0, 0xFFE6},   Range{0x1F300, 0x1F64F}, Range{0x1F680, 0x1F6FF},
                                    Range{0x1F900, 0x1F9FF}, Range{0x20000, 0x3FFFD}};

int width_of(char32_t code) { return within(zero_wide, code) ? 0 : within(double_wide, code) ? 2 : 1; }

// Length of the sequence that a lead byte announces; 0 where it cannot lead.
std::size_t announced(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead < 0xC2) return 0;
  return lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF5 ? 4 : 0;
}

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

}  // namespace

Symbol take_symbol(std::string_view& text) {
  static constexpr std::array<char32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};  // else overlong
  static constexpr std::array<unsigned char, 5> payload = {0, 0x7F, 0x1F, 0x0F, 0x07};
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = announced(lead);

  bool valid = length > 0 && length <= text.size();
  char32_t code = valid ? lead & payload[length] : lead;
  for (std::size_t i = 1; valid && i < length; ++i) {
    valid = continues(text[i]);
    code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3F);
  }
  valid = valid && code >= least[length] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);

  const Symbol symbol{valid ? code : lead, valid, text.substr(0, valid ? length : 1)};
  text.remove_prefix(symbol.bytes.size());
  return symbol;
}

std::string escaped(std::string_view text, bool (*keep)(char32_t)) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Symbol symbol = take_symbol(text);
    if (symbol.valid && keep(symbol.code)) {
      out += symbol.bytes;
    } else if (symbol.valid && symbol.code == '\n') {
      out += "\\n";
    } else if (symbol.valid && symbol.code == '\t') {
      out += "\\t";
    } else if (symbol.valid && symbol.code == '\r') {
      out += "\\r";
    } else {
      const bool byte = !symbol.valid || symbol.code < 0x80;
      const auto number = static_cast<unsigned>(symbol.code);
      byte ? fmt::format_to(std::back_inserter(out), "\\x{:02x}", number)
           : fmt::format_to(std::back_inserter(out), "\\u{{{:04x}}}", number);
    }
  }
  return out;
}

bool is_printable(char32_t code) { return !within(unprintable, code); }
bool is_printable_ascii(char32_t code) { return code < 0x80 && is_printable(code); }

int display_width(std::string_view text) {
  int width = 0;
  while (!text.empty()) width += width_of(take_symbol(text).code);
  return width;
}

std::string fitted(std::string_view text, int width, std::string_view ellipsis) {
  const int whole = display_width(text);
  if (whole <= width) return std::string(text) + std::string(static_cast<std::size_t>(width - whole), ' ');

  const int room = std::max(0, width - display_width(ellipsis));
  std::string out;
  int used = 0;
  while (!text.empty()) {
    const Symbol symbol = take_symbol(text);
    if (used + width_of(symbol.code) > room) break;
    out += symbol.bytes;
    used += width_of(symbol.code);
  }
  out += ellipsis;
  return out + std::string(static_cast<std::size_t>(std::max(0, width - display_width(out))), ' ');
}

std::string counted(std::size_t n, std::string_view one, std::string_view many) {
  if (n == 1) return fmt::format("1 {}", one);
  return many.empty() ? fmt::format("{} {}s", n, one) : fmt::format("{} {}", n, many);
}

std::string substituted(std::string_view text, std::span<const Substitute> table) {
  std::string out;
  for (const char c : text) {
    const auto found =
        std::find_if(table.begin(), table.end(), [c](const Substitute& s) { return s.first == c; });
    out += found == table.end() ? std::string_view(&c, 1) : found->second;
  }
  return out;
}

std::string head(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return std::string(text);
  std::size_t end = bytes;
  while (end > 0 && bytes - end < 3 && continues(text[end])) --end;
  return fmt::format("{} [{} more bytes]", text.substr(0, end), text.size() - end);
}

std::string tail(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return std::string(text);
  const std::size_t earliest = text.size() - bytes;
  std::size_t begin = earliest;
  while (begin < text.size() && begin - earliest < 3 && continues(text[begin])) ++begin;
  return fmt::format("[{} bytes before] {}", begin, text.substr(begin));
}

}  // namespace cylon::reports
