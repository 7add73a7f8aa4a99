// A verdict before anything is measured: which cell, what is expected, and who ran it with what.
#pragma once

#include "harness/study/cell.h"

#include <string>

namespace cylon::study {

/// The cell's names, its command, and what expected.toml says of `claim`.
results::Verdict open_row(const Cell&, const std::string& claim, const scenario::Expectations&);

/// Adds who the engine is and the terms on which it ran.
void sign(results::Verdict&, const core::Engine&, const core::Terms&, const scenario::Expectations&);

}  // namespace cylon::study
