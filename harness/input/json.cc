#include "harness/input/json.h"

namespace cylon::input {

void require_shallow(std::string_view text) {
  std::size_t depth = 0;
  bool inside = false;  // a string
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inside) {
      if (c == '\\') ++i;
      if (c == '"') inside = false;
    } else if (c == '"') {
      inside = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest_json)
        throw BadJson(i + 1, "nested more than " + std::to_string(deepest_json) + " deep at byte " +
                                 std::to_string(i + 1));
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
}

}  // namespace cylon::input
