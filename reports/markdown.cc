#include "reports/markdown.h"

#include "reports/comparison_report.h"
#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace cylon::reports {
namespace {

using results::Comparison;
using results::ComparisonReport;
using results::Finding;

constexpr std::size_t most_rows = 50;  // a comment that nobody scrolls through

// The words stand beside the sign: never a sign alone.
const char* sign(Finding finding) {
  switch (finding) {
    case Finding::regressed:
      return "❌ regressed";
    case Finding::inconclusive:
      return "❔ inconclusive";
    case Finding::improved:
      return "🎉 improved";
    case Finding::changed:
      return "✏️ changed";
    case Finding::same:
      return "✅ same";
    case Finding::skipped:
      return "⏭️ skipped";
  }
  return "";
}

std::string table(const std::vector<const Comparison*>& cells) {
  std::string out = "| cell | outcome | time, candidate / baseline | pairs | what changed in the results |\n";
  out += "|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < std::min(cells.size(), most_rows); ++i) {
    const Comparison& c = *cells[i];
    out +=
        fmt::format("| {} | {} | {} | {} | {} |\n", markdown(c.cell()), sign(c.finding), markdown(ratio(c)),
                    c.time ? fmt::format("{}", c.time->pairs) : "", markdown(brief(c)));
  }
  if (cells.size() > most_rows) out += fmt::format("\n… and {} more\n", cells.size() - most_rows);
  return out;
}

std::string headline(const ComparisonReport& report) {
  const auto any = [&](Finding f) {
    return std::any_of(report.cells.begin(), report.cells.end(),
                       [&](const auto& c) { return c.finding == f; });
  };
  return any(Finding::regressed)      ? "❌ Cylon: regression confirmed"
         : any(Finding::inconclusive) ? "❔ Cylon: no regression confirmed, some cells inconclusive"
                                      : "✅ Cylon: no regression";
}

}  // namespace

std::string markdown(std::string_view text) {
  // @, # and !: no one is called and no issue is linked, as a character reference is no trigger.
  static constexpr std::array<Substitute, 17> table = {{{'&', "&amp;"},
                                                        {'<', "&lt;"},
                                                        {'>', "&gt;"},
                                                        {'@', "&#64;"},
                                                        {'#', "&#35;"},
                                                        {'!', "&#33;"},
                                                        {'\\', "\\\\"},
                                                        {'`', "\\`"},
                                                        {'*', "\\*"},
                                                        {'_', "\\_"},
                                                        {'[', "\\["},
                                                        {']', "\\]"},
                                                        {'(', "\\("},
                                                        {')', "\\)"},
                                                        {'|', "\\|"},
                                                        {'~', "\\~"},
                                                        {'$', "\\$"}}};
  std::string out = substituted(escaped(text, is_printable), table);
  for (std::size_t at = 0; (at = out.find("://", at)) != std::string::npos; at += 3)
    out.replace(at, 1, "&#58;"), at += 4;  // a bare address is no link
  return out;
}

std::string to_markdown(const ComparisonReport& report) {
  std::vector<const Comparison*> first, rest;
  for (const Comparison& c : report.cells)
    (c.finding == Finding::same || c.finding == Finding::skipped ? rest : first).push_back(&c);
  std::stable_sort(first.begin(), first.end(),
                   [](const Comparison* a, const Comparison* b) { return a->finding < b->finding; });
  std::string out = fmt::format("### {}\n\n{}, against {}\n\n", headline(report), markdown(summary(report)),
                                markdown(report.baseline));
  if (const std::string text = warning(report); !text.empty())
    out += fmt::format("> ⚠️ {}\n\n", markdown(text));
  if (!first.empty()) out += table(first) + "\n";
  if (!rest.empty())
    out +=
        fmt::format("<details><summary>{} the same or not compared</summary>\n\n{}\n</details>\n\n",
                    rest.size() == 1 ? "1 cell is" : fmt::format("{} cells are", rest.size()), table(rest));
  out += fmt::format("<sub>Slower means by more than {:g} %, confirmed at {:g}{}.", 100 * report.tau,
                     report.alpha, report.gate ? " over all cells (Holm)" : "");
  if (report.self_check)
    out += fmt::format(" The baseline against itself: x {:.3f} in {} pairs.", report.self_check->ratio,
                       report.self_check->pairs);
  for (const std::string& note : report.notes) out += " " + markdown(note) + ".";
  return out + "</sub>\n";
}

}  // namespace cylon::reports
