// The kill matrix: every subject before every judge.
#pragma once

#include "tests/mutants/matrix/judge.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cylon::mutants {

struct MatrixCell {
  bool run = false;
  std::size_t asked = 0;  ///< Claims.
  bool guilty = false;
  bool own = false;    ///< Of a scene's claim as it stands in its file.
  bool claim = false;  ///< Of that, or of one by theory.
  Finding worst;       ///< Of the largest margin.
};

struct Line {
  Subject subject;
  std::vector<MatrixCell> cells;  ///< One per judge.
  bool caught = false;            ///< By the claim that was made for it.
  std::string seen;               ///< What that claim said, or that it was not asked.
  bool guilty() const;            ///< Accused by anyone.
  bool dies_of_own() const;       ///< Accused by a claim as it stands in a shipped file.
  bool dies_of_claims() const;    ///< By that, or by theory in a shipped scene.
  bool dies_shipped() const;      ///< By those, or by a relation that is shipped.
};

/// One subject before all judges, or before the one that was made for it alone.
Line judge_all(const Subject&);
Line judge_one(const Subject&);

/// The same for many, on `threads` threads, in the order of the subjects.
std::vector<Line> judge_all(const std::vector<Subject>&, int threads);

/// The table with its legend, one line per subject, and the groups of mutants that it cannot tell apart.
std::string print(const std::vector<Line>&);

/// "N mutants: O die of the scenes' own claims, T with those by theory, R with relations; all judges: K
/// killed,
/// A alive, F false accusations".
std::string summary(const std::vector<Line>& mutants, const std::vector<Line>& correct);

}  // namespace cylon::mutants
