// Who is judged: a simulator that is right, or one that is wrong in one known way.
#pragma once

#include "harness/core/simulator.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cylon::mutants {

struct Subject {
  std::string name;
  std::string fault;  ///< One line; empty: it is right.
  int erratum =
      0;  ///< Number of the seed document's error (docs/in-house.md); 0: a fault of engines at large.
  std::function<std::unique_ptr<core::Simulator>()> make;
  core::Setup setup;  ///< The judge sets dt.
  std::string judge;  ///< Where it must be found out …
  std::string claim;  ///< … and by which claim: a prefix of its label, or "beginning*end".
};

/// An erratum that no simulator can have, and why.
struct NotCounted {
  int erratum;
  const char* reason;
};

std::vector<Subject> correct_subjects();
std::vector<Subject> decorated_mutants();
std::vector<Subject> seed_mutants();
const std::vector<NotCounted>& not_counted();

/// All mutants, decorated ones first.
std::vector<Subject> mutants();

}  // namespace cylon::mutants
