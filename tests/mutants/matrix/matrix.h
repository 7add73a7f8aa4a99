// The kill matrix: every subject before every judge.
#pragma once

#include "tests/mutants/matrix/judge.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::mutants {

struct MatrixCell {
  bool run = false;
  bool guilty = false;
  Finding worst;  ///< Of the largest margin.
};

struct Line {
  Subject subject;
  std::vector<MatrixCell> cells;  ///< One per judge.
  bool caught = false;            ///< By the claim that was made for it.
  std::string seen;               ///< What that claim said, or that it was not asked.
  bool guilty() const;            ///< Accused by anyone.
};

/// One subject before all judges, or before the one that was made for it alone.
Line judge_all(const Subject&);
Line judge_one(const Subject&);

/// The same for many, on `threads` threads, in the order of the subjects.
std::vector<Line> judge_all(const std::vector<Subject>&, int threads);

/// The table with its legend, one line per subject, and the groups of mutants that it cannot tell apart.
std::string print(const std::vector<Line>&);

/// "N mutants, K killed, A alive, F false accusations".
std::string summary(const std::vector<Line>& mutants, const std::vector<Line>& correct);

}  // namespace cylon::mutants
