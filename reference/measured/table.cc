#include "reference/measured/table.h"

#include "harness/core/content_hash.h"
#include "harness/core/input_error.h"

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

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> all;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    std::string_view cell = line.substr(at, end - at);
    while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
    while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
    all.push_back(cell);
    at = end + 1;
  }
  return all;
}

}  // namespace

std::size_t Table::column(const std::string& name) const {
  const auto found = std::ranges::find(head, name);
  if (found == head.end())
    throw core::InputError(fmt::format("{}:1: no column '{}'{}", file, name, core::did_you_mean(name, head)));
  return static_cast<std::size_t>(found - head.begin());
}

Table read_table(const std::filesystem::path& path) {
  const std::string text = unpacked(path);
  core::ContentHash content;
  content.add(text);
  Table table{path.string(), content.hex(), {}, {}};
  const auto refuse = [&](std::size_t line, const std::string& why) {
    return core::InputError(fmt::format("{}:{}: {}", table.file, line, why));
  };
  std::size_t line = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view row = std::string_view(text).substr(at, end - at);
    at = end + 1, ++line;
    if (!row.empty() && row.back() == '\r') row.remove_suffix(1);
    const auto wide = static_cast<std::size_t>(std::ranges::count(row, ',')) + 1;
    if (wide > most_columns) throw refuse(line, fmt::format("{} columns, at most {}", wide, most_columns));
    const auto found = cells(row);
    if (line == 1) {
      table.head.assign(found.begin(), found.end());
      std::set<std::string_view> names;
      for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i].empty() || !names.insert(found[i]).second)
          throw refuse(1, fmt::format("column {} has no name of its own: '{}'", i + 1,
                                      found[i].substr(0, longest_shown)));
      continue;
    }
    if (found.size() != table.head.size())
      throw refuse(line, fmt::format("{} values, and {} columns", found.size(), table.head.size()));
    std::vector<double>& values = table.rows.emplace_back();
    values.reserve(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      double x = std::nan("");
      const auto [stop, error] = std::from_chars(found[i].data(), found[i].data() + found[i].size(), x);
      if (error != std::errc() || stop != found[i].data() + found[i].size() || !std::isfinite(x))
        throw refuse(line, fmt::format("{} = '{}' is no finite number", table.head[i],
                                       found[i].substr(0, longest_shown)));
      values.push_back(x);
    }
  }
  if (table.rows.empty()) throw refuse(1, "no rows of numbers");
  return table;
}

}  // namespace cylon::measured
