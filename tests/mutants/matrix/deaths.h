// By what each mutant dies, as tests/mutants/deaths.txt has it: the counts of README.md are of that file.
#pragma once

#include "tests/mutants/matrix/matrix.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::mutants {

/// A line of deaths.txt, with tabs between.
struct Death {
  std::string means;   ///< "own": a claim as it stands in its file; "theory": one by theory; "relations".
  std::string judge;   ///< One that is shipped, and accuses the mutant by that.
  std::string mutant;  ///< Its name.

  bool operator==(const Death&) const = default;
};

/// The first of own, theory and relations by which the mutant dies, and who accuses it so: the judge that was made for it, or else
/// the first.  Nothing where it lives.
std::optional<Death> death_of(const Subject&);

/// The same for all mutants, on `threads` threads, in their order; those that live are left out.
std::vector<Death> deaths(int threads);

/// Whether that judge accuses the mutant by that.
bool holds(const Death&, const Subject&);

/// The first of own, theory and relations by which a mutant dies that stood before all judges; "" where it lives.
std::string means_of(const Line&);

/// What deaths.txt has; its text.
std::vector<Death> listed_deaths();
std::string text(const std::vector<Death>&);

}  // namespace cylon::mutants
