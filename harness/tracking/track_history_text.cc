#include "harness/tracking/track_history_text.h"

#include "harness/cli/sparkline.h"
#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

using reports::ConsoleOptions;
using statistics::Outcome;

constexpr int value_width = 24;

struct Page {
  const ConsoleOptions& console;
  int name_width;    ///< Of the first column.
  std::size_t room;  ///< For curves.
};

struct Mark {
  Outcome outcome;
  const char *utf8, *ascii;
};
constexpr Mark marks[] = {
    {Outcome::regressed, "▲", "^"}, {Outcome::improved, "▼", "v"}, {Outcome::changed, "◆", "*"}};
constexpr Mark version_mark = {Outcome::changed, "│", "|"};

std::string drawn(const Mark& mark, const ConsoleOptions& console) {
  return console.utf8 ? mark.utf8 : mark.ascii;
}

std::string mark_of(const HistoryChange& change, const ConsoleOptions& console) {
  if (!change.found) return " ";
  for (const Mark& mark : marks)
    if (mark.outcome == change.outcome) return drawn(mark, console);
  return " ";
}

// Sizes and errors over decades, ratios by their logarithm: heights are logarithms where all values allow.
std::string curve(const HistoryRow& row, const ConsoleOptions& console, std::size_t width) {
  if (row.scale == Scale::text) {
    std::vector<std::string> texts;
    for (const HistoryPoint& p : row.points) texts.push_back(p.text);
    return letters(texts, width);
  }
  std::vector<double> heights;
  bool positive = true;
  double largest = 0;
  for (const HistoryPoint& p : row.points) {
    heights.push_back(p.value);
    positive &= !(p.value <= 0);
    if (std::isfinite(p.value)) largest = std::max(largest, std::abs(p.value));
  }
  if (positive)
    for (double& height : heights) height = std::log(height);
  // A tenth of the value, and of a ratio a twentieth, is the least that fills the height.
  const double least = row.scale == Scale::ratio ? 0.05 : 0.1;
  return sparkline(heights, positive ? least : least * largest, console.utf8, width);
}

// Below the curve: what changed at which column; empty where nothing did.
std::string marks_below(const HistoryRow& row, const ConsoleOptions& console, std::size_t width) {
  std::map<std::size_t, std::string> at;
  for (const std::size_t i : row.versions)
    at[column_of(i, row.points.size(), width)] = drawn(version_mark, console);
  for (const HistoryChange& c : row.changes)
    if (c.found) at[column_of(c.index, row.points.size(), width)] = mark_of(c, console);
  std::string line;
  std::size_t column = 0;
  for (const auto& [where, mark] : at) {
    line += std::string(where - column, ' ') + mark;
    column = where + 1;
  }
  return line;
}

std::string last_value(const HistoryRow& row) {
  const HistoryPoint& last = row.points.back();
  if (row.scale == Scale::text) return last.text;
  if (!std::isfinite(last.value)) return "not finite";
  if (row.scale == Scale::ratio) return fmt::format("x {:.3f}", last.value);
  return fmt::format("{:.4g}{}{}", last.value, row.metric.unit.empty() ? "" : " ", row.metric.unit);
}

// Names take what the longest one needs, two fifths of the page at most.
Page page_of(const std::vector<HistoryRow>& rows, const ConsoleOptions& console) {
  const int width = std::max(console.width, 80);
  int longest = 20;
  for (const HistoryRow& row : rows)
    longest = std::max(longest, reports::display_width(reports::shown(row.metric.name, console)));
  const int name_width = std::min(longest, 2 * width / 5);
  return {console, name_width, static_cast<std::size_t>(width - name_width - value_width - 6)};
}

std::string row_text(const HistoryRow& row, const Page& page) {
  const auto& [console, name_width, room] = page;
  std::string text = fmt::format("  {}  {}  {}\n",
                                 reports::fitted(reports::shown(row.metric.name, console), name_width, "~"),
                                 curve(row, console, room), reports::shown(last_value(row), console));
  const std::string below = marks_below(row, console, room);
  if (!below.empty()) text += std::string(static_cast<std::size_t>(name_width) + 4, ' ') + below + "\n";
  for (const HistoryChange& c : row.changes) {
    text += fmt::format("      {} {} at {}: {} [{}]", c.id, mark_of(c, console),
                        reports::shown(row.points[c.index].revision, console),
                        reports::shown(c.sentence, console), c.state);
    text += (c.note.empty() ? "" : " " + reports::shown(c.note, console)) + "\n";
  }
  return text;
}

std::string versions_text(const HistoryRow& row, const ConsoleOptions& console) {
  std::string text;
  for (const std::size_t i : row.versions)
    text += reports::shown(fmt::format("  engine version {} -> {} at {}", row.points[i - 1].version,
                                       row.points[i].version, row.points[i].revision),
                           console) +
            "\n";
  return text;
}

}  // namespace

std::string history_text(const std::vector<HistoryRow>& rows, const ConsoleOptions& console) {
  const Page page = page_of(rows, console);
  std::string text, cell;
  std::map<std::string, int> states;
  for (const HistoryRow& row : rows) {
    if (row.cell.hash != cell) {
      const HistoryPoint &first = row.points.front(), &last = row.points.back();
      text += fmt::format("{}{}\n  {} to {}, engine version {}\n", text.empty() ? "" : "\n",
                          reports::shown(row.cell.name(), console), reports::shown(first.revision, console),
                          reports::shown(last.revision, console),
                          last.version.empty() ? "unknown" : reports::shown(last.version, console));
      text += versions_text(row, console);
    }
    cell = row.cell.hash;
    text += row_text(row, page);
    for (const HistoryChange& change : row.changes) ++states[change.state];
  }
  std::string summary;
  for (const char* state : {"detected", "active", "ignored", "fixed"})
    if (states[state] > 0)
      summary += fmt::format("{}{} {}", summary.empty() ? "" : ", ", states[state], state);
  text += "\nchanges: " + (summary.empty() ? "none" : summary) + "\n";
  if (!summary.empty())
    text += fmt::format("{} worse  {} better  {} other value  {} engine version\n", drawn(marks[0], console),
                        drawn(marks[1], console), drawn(marks[2], console), drawn(version_mark, console));
  return text;
}

}  // namespace cylon::tracking
