// A verdict before anything is measured: which cell, what is expected, and who ran it with what.
#pragma once

#include "harness/study/cell.h"

#include <string>

namespace cylon::study {

/// The cell's names, its command, and what expected.toml says of `claim`.
results::Verdict open_row(const Cell&, const std::string& claim, const scenario::Expectations&);

/// Adds who the engine is and the terms on which it ran.
void sign(results::Verdict&, const core::Engine&, const core::Terms&, const scenario::Expectations&);

/// Adds a sentence to what the row says of itself.
void add_detail(results::Verdict&, const std::string& sentence);

/// Runs that start one ulp apart: as many as were asked for, else two of a scenario that says it is chaotic.
int copies_of(const Cell&);
/// Adds how far they got from the first, where the row knows.
void tell_spread(results::Verdict&, int copies);
/// Adds what became of such a run, from 0, that did not end.
void tell_failed_copy(results::Verdict&, int copy, const process::RunOutcome&);

}  // namespace cylon::study
