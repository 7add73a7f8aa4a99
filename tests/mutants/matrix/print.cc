#include "tests/mutants/matrix/matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace cylon::mutants {
namespace {

// Digits by which a claim is missed: "+1".."+9", "##" from 9.5 on or not finite; '.' where nothing is.
std::string mark(const MatrixCell& cell) {
  if (!cell.run) return "   ";
  if (!cell.guilty) return "  .";
  if (cell.worst.margin() >= 9.5) return " ##";
  return fmt::format(" +{:.0f}", std::max(0.0, cell.worst.margin()));
}

std::string title(const Subject& subject) {
  if (subject.fault.empty()) return subject.name;
  return subject.erratum ? fmt::format("{:>2} {}", subject.erratum, subject.name)
                         : fmt::format(" - {}", subject.name);
}

std::string marks(const Line& line) {
  std::string text;
  for (const MatrixCell& cell : line.cells) text += mark(cell);
  return text;
}

// What the matrix knows of a mutant: who accuses it, by which claim, by how many digits.
std::string signature(const Line& line) {
  std::string text;
  for (const MatrixCell& cell : line.cells)
    text += cell.guilty ? fmt::format("|{} {:.1f}", cell.worst.claim, cell.worst.margin()) : "|";
  return text;
}

const char* cross(bool dies) { return dies ? " x " : " . "; }

constexpr std::size_t width = 44;

}  // namespace

std::string print(const std::vector<Line>& lines) {
  std::string text;
  for (std::size_t j = 0; j < judges().size(); ++j)
    text += fmt::format("{:>3} {:<18} {}\n", j + 1, judges()[j].name, judges()[j].asks);
  text += fmt::format("\n{:{}}own thy rel", "", width);
  for (std::size_t j = 0; j < judges().size(); ++j) text += fmt::format("{:>3}", j + 1);
  text += "\n";
  for (const Line& line : lines)
    text += fmt::format("{:<{}.{}} {} {} {}{}  {}\n", title(line.subject), width, width,
                        cross(line.dies_of_own()), cross(line.dies_of_claims()), cross(line.dies_shipped()),
                        marks(line), line.subject.fault);

  std::map<std::string, std::vector<const Line*>> alike;
  for (const Line& line : lines)
    if (!line.subject.fault.empty()) alike[signature(line)].push_back(&line);
  for (const auto& [same, group] : alike) {
    if (group.size() < 2) continue;
    text += "cannot be told apart:";
    for (const Line* line : group) text += fmt::format(" [{}]", title(line->subject));
    text += "\n";
  }
  for (const Line& line : lines) {
    if (!line.subject.fault.empty() && !line.dies_shipped())
      text += fmt::format("ALIVE UNDER ALL THAT IS SHIPPED {}\n", title(line.subject));
    if (!line.subject.fault.empty() && !line.caught)
      text += fmt::format("ALIVE {}: judge {}, {}\n", title(line.subject), line.subject.judge, line.seen);
    if (!line.subject.fault.empty()) continue;
    for (std::size_t j = 0; j < line.cells.size(); ++j)
      if (const MatrixCell& cell = line.cells[j]; cell.guilty)
        text += fmt::format("FALSELY ACCUSED {}: judge {}, {}: {:.3g} of {:.3g}\n", line.subject.name,
                            judges()[j].name, cell.worst.claim, cell.worst.measured, cell.worst.allowed);
  }
  return text;
}

std::string summary(const std::vector<Line>& mutants, const std::vector<Line>& correct) {
  const auto killed =
      std::count_if(mutants.begin(), mutants.end(), [](const Line& line) { return line.caught; });
  std::ptrdiff_t accusations = 0;
  for (const Line& line : correct)
    accusations +=
        std::count_if(line.cells.begin(), line.cells.end(), [](const MatrixCell& c) { return c.guilty; });
  return fmt::format(
      "{} mutants: {} die of the scenes' own claims, {} with those by theory, {} with relations; all judges: "
      "{} killed, "
      "{} alive, {} false accusations",
      mutants.size(), std::ranges::count_if(mutants, &Line::dies_of_own),
      std::ranges::count_if(mutants, &Line::dies_of_claims),
      std::ranges::count_if(mutants, &Line::dies_shipped), killed,
      static_cast<std::ptrdiff_t>(mutants.size()) - killed, accusations);
}

}  // namespace cylon::mutants
