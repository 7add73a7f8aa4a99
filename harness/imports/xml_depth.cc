#include "harness/imports/xml_depth.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::imports {
namespace {

// Behind the next `end` from `at` on; the end of the text where there is none.
std::size_t behind(std::string_view text, std::size_t at, std::string_view end) {
  const std::size_t found = text.find(end, at);
  return found == std::string_view::npos ? text.size() : found + end.size();
}

// Behind the tag that begins at `at`: its '>' outside the quotes of attributes.
std::size_t behind_tag(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] != '>')
    at = text[at] == '"' || text[at] == '\'' ? behind(text, at + 1, text.substr(at, 1)) : at + 1;
  return std::min(at + 1, text.size());
}

}  // namespace

void require_shallow_xml(std::string_view text, const std::string& file) {
  int depth = 0;
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = behind(text, at + 4, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      at = behind(text, at, "]]>");
    } else if (rest.starts_with("<?")) {
      at = behind(text, at, "?>");
    } else if (rest.starts_with("<!")) {
      at = behind(text, at, ">");
    } else if (rest.starts_with("</")) {
      depth = std::max(depth - 1, 0);
      at = behind(text, at, ">");
    } else {
      const std::size_t end = behind_tag(text, at);
      if (++depth > deepest_xml) {
        const std::string_view before = text.substr(0, at);
        const auto lines = std::count(before.begin(), before.end(), '\n');
        const std::size_t start = lines == 0 ? 0 : before.rfind('\n') + 1;
        throw core::InputError(file, static_cast<unsigned>(lines + 1), static_cast<unsigned>(at - start + 1),
                               fmt::format("an element nested more than {} deep", deepest_xml));
      }
      if (text.substr(at, end - at).ends_with("/>")) --depth;
      at = end;
    }
  }
}

}  // namespace cylon::imports
