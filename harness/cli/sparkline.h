// A series as one line of text.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace cylon::cli {

/// The column, of at most `width`, in which element i of n stands: one each while they fit, else several.
std::size_t column_of(std::size_t i, std::size_t n, std::size_t width);

/// A character per column, its height the mean of the finite values there: "▁▂▃▄▅▆▇█", without UTF-8
/// "_.-:=+*#"; a column without a finite value is "?".  The heights span the values, or `least_range` about
/// their middle where they differ by less, so that noise stays flat.
std::string sparkline(std::span<const double> values, double least_range, bool utf8, std::size_t width);

/// A letter per column for the texts of a series: the first text is a, the next other one b, …, after z #; a
/// column takes the letter of its last text.
std::string letters(const std::vector<std::string>& texts, std::size_t width);

}  // namespace cylon::cli
