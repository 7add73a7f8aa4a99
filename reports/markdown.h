// A comparison of two builds as a comment on a merge request.
#pragma once

#include "harness/results/comparison.h"

#include <string>
#include <string_view>

namespace cylon::reports {

/// A headline with the outcome, a table of the cells that are not the same (at most 50), the rest folded
/// away, and how it was measured.  GitHub's and GitLab's Markdown.
std::string to_markdown(const results::ComparisonReport&);

/// Foreign text that stays text in a table: markup, pipes, line ends, references to people and issues do
/// nothing.
std::string markdown(std::string_view);

}  // namespace cylon::reports
