#include "harness/cli/command_line.h"

#include "harness/process/sandbox.h"
#include "reports/text.h"

namespace cylon::cli {

std::string shell_word(std::string_view word) {
  constexpr std::string_view safe =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,=+:@%";
  if (!word.empty() && word.find_first_not_of(safe) == std::string_view::npos) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string shell_command(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

std::vector<std::string> program_words() {
  std::vector<std::string> words = {"cylon"};
  if (process::sandboxing()) words.emplace_back("--sandbox");
  return words;
}

std::string plain(std::string_view text) {
  return reports::escaped(text, [](char32_t c) { return c == U'\n' || reports::is_printable(c); });
}

std::string plain_line(std::string_view text) { return reports::escaped(text, reports::is_printable); }

}  // namespace cylon::cli
