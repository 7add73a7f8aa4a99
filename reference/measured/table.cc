#include "reference/measured/table.h"

#include "harness/core/content_hash.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <set>
#include <string_view>

namespace cylon::measured {
namespace {

constexpr std::size_t longest_shown = 40;  // of what is refused [characters]

struct Close {
  void operator()(gzFile_s* file) const { gzclose_r(file); }
};

std::string unpacked(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& why) {
    return core::InputError(fmt::format("{}: {}", path.string(), why));
  };
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw refuse("is no file that can be read");
  const std::unique_ptr<gzFile_s, Close> file(gzopen(path.c_str(), "rb"));  // reads plain files as they are
  if (!file) throw refuse("cannot be read");
  std::string text;
  std::array<char, 1 << 16> piece;
  for (int got = 1; got > 0;) {
    got = gzread(file.get(), piece.data(), static_cast<unsigned>(piece.size()));
    if (got < 0) throw refuse("is no whole gzip file");
    text.append(piece.data(), static_cast<std::size_t>(got));
    if (text.size() > largest_table)
      throw refuse(fmt::format("unpacks to more than {} MB", largest_table >> 20));
  }
  int state = Z_OK;
  gzerror(file.get(), &state);
  if (state != Z_OK) throw refuse("is no whole gzip file");
  return text;
}

struct Cell {
  std::string_view word;  // without blanks and quotes around it
  std::size_t end = 0;    // in the line
};

Cell cell_at(std::string_view line, std::size_t begin, char separator) {
  std::size_t end = begin;
  for (bool quoted = false; end < line.size() && (quoted || line[end] != separator); ++end)
    quoted = quoted != (line[end] == '"');
  std::string_view word = line.substr(begin, end - begin);
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!word.empty() && blank(word.front())) word.remove_prefix(1);
  while (!word.empty() && blank(word.back())) word.remove_suffix(1);
  if (word.size() >= 2 && word.front() == '"' && word.back() == '"') word = word.substr(1, word.size() - 2);
  return {word, end};
}

std::string_view line_at(std::string_view text, std::size_t at) {
  return text.substr(at, std::min(text.find('\n', at), text.size()) - at);
}

bool is_empty(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

char separator_of(std::string_view head) {
  for (const char c : {',', ';', '\t'})
    if (head.find(c) != std::string_view::npos) return c;
  return ',';
}

}  // namespace

Table::Table(const std::filesystem::path& path) : file_(path.string()), text_(unpacked(path)) {
  core::ContentHash content;
  content.add(text_);
  hash_ = content.hex();
  const auto refuse_line = [&](std::size_t line, const std::string& why) {
    return core::InputError(fmt::format("{}:{}: {}", file_, line, why));
  };
  std::size_t empty = 0;  // the first empty line, after which no row may stand
  for (std::size_t at = text_.starts_with("\xef\xbb\xbf") ? 3 : 0, number = 1; at < text_.size(); ++number) {
    const std::string_view line = line_at(text_, at);
    const std::size_t begin = at;
    at += line.size() + 1;
    if (head_.empty() && line.starts_with('#')) continue;
    if (is_empty(line)) {
      empty = empty > 0 ? empty : number;
      continue;
    }
    if (empty > 0) throw refuse_line(empty, "an empty line before others");
    if (head_.empty()) {
      read_head(line, number);
      continue;
    }
    require_width(static_cast<std::size_t>(std::ranges::count(line, separator_)) + 1, number);
    std::size_t wide = 0;
    for (std::size_t i = 0; i <= line.size(); ++wide) {
      starts_.push_back(static_cast<std::uint32_t>(begin + i));
      i = cell_at(line, i, separator_).end + 1;
    }
    if (wide != head_.size())
      throw refuse_line(number, fmt::format("{} values, and {} columns", wide, head_.size()));
  }
  if (starts_.empty()) throw refuse_line(1, "no rows of numbers");
}

void Table::require_width(std::size_t columns, std::size_t line) const {
  if (columns > most_columns)
    throw core::InputError(fmt::format("{}:{}: {} columns, at most {}", file_, line, columns, most_columns));
}

void Table::read_head(std::string_view line, std::size_t number) {
  head_line_ = number, separator_ = separator_of(line);
  require_width(static_cast<std::size_t>(std::ranges::count(line, separator_)) + 1, number);
  std::set<std::string_view> names;
  for (std::size_t i = 0; i <= line.size();) {
    const Cell cell = cell_at(line, i, separator_);
    head_.emplace_back(cell.word);
    if (cell.word.empty() || !names.insert(cell.word).second)
      throw core::InputError(fmt::format("{}:{}: column {} has no name of its own: '{}'", file_, number,
                                         head_.size(), cell.word.substr(0, longest_shown)));
    i = cell.end + 1;
  }
}

std::size_t Table::column(const std::string& name) const {
  const auto found = std::ranges::find(head_, name);
  if (found == head_.end())
    throw core::InputError(
        fmt::format("{}:{}: no column '{}'{}", file_, head_line_, name, core::did_you_mean(name, head_)));
  return static_cast<std::size_t>(found - head_.begin());
}

std::string_view Table::word(std::size_t row, std::size_t column) const {
  const std::size_t start = starts_[row * head_.size() + column];
  return cell_at(line_at(text_, start), 0, separator_).word;
}

double Table::number(std::size_t row, std::size_t column) const {
  const std::string_view text = word(row, column);
  double x = std::nan("");
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc() || stop != text.data() + text.size() || !std::isfinite(x))
    throw refuse(row,
                 fmt::format("{} = '{}' is no finite number", head_[column], text.substr(0, longest_shown)));
  return x;
}

core::InputError Table::refuse(std::size_t row, const std::string& why) const {
  return core::InputError(fmt::format("{}:{}: {}", file_, head_line_ + 1 + row, why));
}

}  // namespace cylon::measured
