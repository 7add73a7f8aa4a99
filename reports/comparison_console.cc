#include "reports/comparison_report.h"
#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace cylon::reports {
namespace {

using results::Comparison;
using results::ComparisonReport;
using results::Finding;

results::Status colour_of(Finding finding) {
  if (finding == Finding::regressed) return results::Status::fail;
  if (finding == Finding::inconclusive || finding == Finding::changed) return results::Status::low_quality;
  return finding == Finding::skipped ? results::Status::unsupported : results::Status::pass;
}

using Line = std::array<std::string, 5>;

Line line_of(const Comparison& c, const ConsoleOptions& options) {
  return {shown(c.cell(), options), std::string(results::name(c.finding)), shown(ratio(c), options),
          c.time ? fmt::format("{}", c.time->pairs) : "-", shown(brief(c), options)};
}

}  // namespace

std::string console(const ComparisonReport& report, const ConsoleOptions& options) {
  std::string out = fmt::format("baseline   {}\ncandidate  {}\n\n", shown(report.baseline, options),
                                shown(report.candidate, options));
  const Line head = {"cell", "outcome", "time, candidate/baseline", "pairs", "what changed in the results"};
  std::vector<Line> lines;
  std::array<int, 5> widths{};
  for (const Comparison& c : report.cells) lines.push_back(line_of(c, options));
  for (std::size_t i = 0; i < head.size(); ++i) {
    widths[i] = display_width(head[i]);
    for (const Line& line : lines) widths[i] = std::max(widths[i], std::min(60, display_width(line[i])));
  }
  const auto row = [&](const Line& line, const Finding* finding) {
    std::string text;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const std::string cell = fitted(line[i], widths[i], options.utf8 ? "…" : "...");
      text += (i == 1 && finding ? painted(cell, colour_of(*finding), options) : cell) + "  ";
    }
    text += line.back();
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + "\n";
  };
  row(head, nullptr);
  for (std::size_t i = 0; i < lines.size(); ++i) row(lines[i], &report.cells[i].finding);

  for (const Comparison& c : report.cells) {
    if (c.finding != Finding::regressed) continue;
    out += fmt::format("\n{}: {}\n", painted("regressed", results::Status::fail, options),
                       shown(c.cell(), options));
    if (c.time && c.time->finding == Finding::regressed)
      out +=
          fmt::format("  time {}, {} pairs of {}\n", shown(ratio(c), options), c.time->pairs, c.time->what);
    if (!changes(c).empty()) out += fmt::format("  {}\n", shown(changes(c), options));
    if (!c.reproduce.empty()) out += fmt::format("  {}\n", shown(c.reproduce, options));
  }
  out += "\n";
  for (const std::string& note : report.notes) out += fmt::format("{}\n", shown(note, options));
  if (report.self_check)
    out += fmt::format("self-check: x {:.3f} in {} pairs, {} ({})\n", report.self_check->ratio,
                       report.self_check->pairs, results::name(report.self_check->finding),
                       shown(report.self_check->what, options));
  if (const std::string text = warning(report); !text.empty())
    out += painted(shown(text, options), results::Status::low_quality, options) + "\n";
  return out + summary(report) + "\n";
}

}  // namespace cylon::reports
