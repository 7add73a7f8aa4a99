#include "tests/mutants/matrix/matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <string_view>
#include <thread>

namespace cylon::mutants {
namespace {

MatrixCell cell_of(const std::vector<Finding>& findings) {
  MatrixCell cell;
  cell.run = true;
  cell.asked = findings.size();
  for (const Finding& finding : findings) {
    cell.guilty = cell.guilty || finding.guilty();
    cell.own = cell.own || (finding.guilty() && finding.of_file());
    cell.claim = cell.claim || (finding.guilty() && !finding.of_relation());
    if (&finding == &findings.front() || finding.margin() > cell.worst.margin()) cell.worst = finding;
  }
  return cell;
}

// A prefix of the label, or a beginning and an end with a * between them; by theory or as the file has it, where
// the claim does not say which.
bool matches(std::string label, const std::string& claim) {
  constexpr std::string_view by_theory = "theory: ";
  if (label.starts_with(by_theory) && !claim.starts_with(by_theory)) label.erase(0, by_theory.size());
  const std::size_t star = claim.find('*');
  if (star == std::string::npos) return label.starts_with(claim);
  return label.starts_with(claim.substr(0, star)) && label.ends_with(claim.substr(star + 1));
}

void hear(Line& line, const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    if (!matches(finding.claim, line.subject.claim)) continue;
    line.caught = line.caught || finding.guilty();
    line.seen += fmt::format("{}{}: {:.3g} of {:.3g}", line.seen.empty() ? "" : "; ", finding.claim,
                             finding.measured, finding.allowed);
  }
}

Line judged(const Subject& subject, bool all) {
  Line line{subject, {}, false, ""};
  for (const Judge& judge : judges()) {
    MatrixCell cell;
    const bool made_for_it = judge.name == subject.judge;
    if (all || made_for_it)
      if (const auto findings = judge.findings(subject)) {
        cell = cell_of(*findings);
        if (made_for_it) hear(line, *findings);
      }
    line.cells.push_back(cell);
  }
  if (line.seen.empty()) line.seen = "the claim was not asked";
  return line;
}

}  // namespace

bool Line::guilty() const {
  return std::any_of(cells.begin(), cells.end(), [](const MatrixCell& cell) { return cell.guilty; });
}

bool Line::dies_of_own() const {
  for (std::size_t j = 0; j < cells.size(); ++j)
    if (cells[j].own && judges()[j].shipped) return true;
  return false;
}

bool Line::dies_of_claims() const {
  for (std::size_t j = 0; j < cells.size(); ++j)
    if (cells[j].claim && judges()[j].shipped) return true;
  return false;
}

bool Line::dies_shipped() const {
  for (std::size_t j = 0; j < cells.size(); ++j)
    if (cells[j].guilty && judges()[j].shipped) return true;
  return false;
}

Line judge_all(const Subject& subject) { return judged(subject, true); }
Line judge_one(const Subject& subject) { return judged(subject, false); }

std::vector<Line> judge_all(const std::vector<Subject>& subjects, int threads) {
  judges();  // made once, before there are threads
  std::vector<Line> lines(subjects.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = 0; (i = next++) < subjects.size();) lines[i] = judge_all(subjects[i]);
  };
  std::vector<std::jthread> pool;
  for (int i = 1; i < threads; ++i) pool.emplace_back(work);
  work();
  pool.clear();
  return lines;
}

}  // namespace cylon::mutants
