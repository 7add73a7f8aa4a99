#include "harness/scenario/toml_depth.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::scenario {
namespace {

// Behind the string that starts at `i`: "…", '…' or their forms with three quotes.  An unclosed string ends
// with its line, or with the text.
std::size_t behind_string(std::string_view text, std::size_t i) {
  const char quote = text[i];
  const bool escapes = quote == '"';
  const std::string three(3, quote);
  if (text.substr(i, 3) == three) {
    for (i += 3; i < text.size(); ++i) {
      if (escapes && text[i] == '\\') {
        ++i;
      } else if (text.substr(i, 3) == three) {
        i += 3;
        while (i < text.size() && text[i] == quote) ++i;  // up to two quotes may stand before the last three
        return i;
      }
    }
    return text.size();
  }
  for (++i; i < text.size() && text[i] != '\n'; ++i) {
    if (escapes && text[i] == '\\')
      ++i;
    else if (text[i] == quote)
      return i + 1;
  }
  return std::min(i, text.size());
}

}  // namespace

void require_shallow_toml(std::string_view text, const std::string& file) {
  int dots = 0, depth = 0;
  const auto refuse = [&](std::size_t at, const char* what) {
    const std::string_view before = text.substr(0, at);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = line == 1 ? 0 : before.rfind('\n') + 1;
    throw core::InputError(file, static_cast<unsigned>(line), static_cast<unsigned>(at - start + 1),
                           fmt::format("{} nested more than {} deep", what, deepest_toml));
  };
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = behind_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '.') {
      if (++dots > deepest_toml) refuse(i, "a key is");
    } else if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') {
      dots = 0;
      if (c == '[' || c == '{') {
        if (++depth > deepest_toml) refuse(i, "values are");
      } else if ((c == ']' || c == '}') && depth > 0) {
        --depth;
      }
    }
    ++i;
  }
}

}  // namespace cylon::scenario
