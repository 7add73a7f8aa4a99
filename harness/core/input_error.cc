#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::core {
namespace {

// Levenshtein distance, two rows.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row[b.size()];
}

// "bouncing_sphere" for "bounce": the first with the longest common beginning, of at least four letters and most of the word.
const std::string* same_beginning(std::string_view word, std::span<const std::string> candidates) {
  const std::string* best = nullptr;
  std::size_t most = std::max<std::size_t>(4, (3 * word.size() + 3) / 4) - 1;
  for (const std::string& candidate : candidates) {
    const auto differs = std::ranges::mismatch(word, candidate).in1;
    const auto common = static_cast<std::size_t>(differs - word.begin());
    if (common > most) best = &candidate, most = common;
  }
  return best;
}

constexpr std::size_t longest_message = 2000;  // [bytes]: a hostile file may have a key of megabytes

// Cut before a character of UTF-8.
std::string shortened(std::string text) {
  if (text.size() <= longest_message) return text;
  std::size_t end = longest_message;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
  text.resize(end);
  return text + "…";
}

std::string place(const std::string& file, unsigned line, unsigned column) {
  if (line == 0) return file.empty() ? "" : file + ": ";
  return fmt::format("{}:{}:{}: ", file, line, column);
}

}  // namespace

InputError::InputError(const std::string& message) : std::runtime_error(shortened(message)) {}

InputError::InputError(const std::string& in, unsigned at_line, unsigned at_column,
                       const std::string& message)
    : std::runtime_error(shortened(place(in, at_line, at_column) + message)),
      file(in),
      line(at_line),
      column(at_column) {}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  // A distance costs the product of both lengths, and a generator makes a million names.
  constexpr std::size_t longest_word = 64, most_candidates = 10'000;
  if (word.size() > longest_word) return "";
  const std::string* best = nullptr;
  std::size_t least = 0;
  for (const std::string& candidate : candidates.first(std::min(candidates.size(), most_candidates))) {
    if (candidate.size() > longest_word) continue;
    const std::size_t distance = edit_distance(word, candidate);
    const std::size_t reach = std::max<std::size_t>(2, std::max(word.size(), candidate.size()) / 3);
    if (distance <= reach && (!best || distance < least)) best = &candidate, least = distance;
  }
  if (!best) best = same_beginning(word, candidates.first(std::min(candidates.size(), most_candidates)));
  return best ? fmt::format(", did you mean '{}'?", *best) : "";
}

}  // namespace cylon::core
