// Quantiles and tails of the distributions that intervals come from.
#pragma once

namespace cylon::statistics {

/// x with P(X > x) = tail of Student's t with `freedom` > 0 degrees; infinite: of the standard normal.  0 < tail < 1.
double student_quantile(double tail, double freedom);

/// P(X > x) of chi-squared with `freedom` > 0 degrees; x >= 0.
double chi_squared_tail(double x, double freedom);

}  // namespace cylon::statistics
