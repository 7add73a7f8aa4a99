// How unlike two halves of a series are, for every place where it may be cut.
#pragma once

#include <span>
#include <vector>

namespace cylon::statistics {

/// The scaled energy statistic of every cut of x_0 … x_{N-1} into X = the first n and Y = the other m,
///     Q(n) = n m / (n + m) (2 / (n m) sum |X_i - Y_j| - 2 / (n (n-1)) sum_{i<k} |X_i - X_k|
///                                                    - 2 / (m (m-1)) sum_{j<k} |Y_j - Y_k|),
/// Matteson and James 2014 (J. Am. Stat. Assoc. 109, 334), equations 5 to 7 with exponent 1.  Element n of
/// the result is Q(n); it is -infinity where n or m is below 2, as one value has no spread.  O(N^2).
std::vector<double> energy_of_cuts(std::span<const double>);

}  // namespace cylon::statistics
