#include "reports/xml.h"

#include "reports/text.h"

namespace cylon::reports {
namespace {

// XML 1.0, section 2.2, production Char; and nothing that a terminal would obey.
bool allowed_in_xml(char32_t code) {
  return code == '\t' || code == '\n' || code == '\r' || is_printable(code);
}

}  // namespace

std::string xml(std::string_view text) {
  std::string out;
  for (const char c : escaped(text, allowed_in_xml)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\t':
        out += "&#9;";
        break;  // else an attribute would turn them into spaces
      case '\n':
        out += "&#10;";
        break;
      case '\r':
        out += "&#13;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace cylon::reports
