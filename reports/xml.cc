#include "reports/xml.h"

#include "reports/text.h"

#include <array>

namespace cylon::reports {
namespace {

// XML 1.0, section 2.2, production Char; and nothing that a terminal would obey.
bool allowed_in_xml(char32_t code) {
  return code == '\t' || code == '\n' || code == '\r' || is_printable(code);
}

}  // namespace

std::string xml(std::string_view text) {
  // Of white space an attribute would make spaces.
  static constexpr std::array<Substitute, 7> table = {{{'&', "&amp;"},
                                                       {'<', "&lt;"},
                                                       {'>', "&gt;"},
                                                       {'"', "&quot;"},
                                                       {'\t', "&#9;"},
                                                       {'\n', "&#10;"},
                                                       {'\r', "&#13;"}}};
  return substituted(escaped(text, allowed_in_xml), table);
}

}  // namespace cylon::reports
