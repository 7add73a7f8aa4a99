#include "harness/tracking/statistics/quantile.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <cmath>

namespace cylon::statistics {

double student_quantile(double tail, double freedom) {
  if (!std::isfinite(freedom))
    return boost::math::quantile(boost::math::complement(boost::math::normal(), tail));
  return boost::math::quantile(boost::math::complement(boost::math::students_t(freedom), tail));
}

double chi_squared_tail(double x, double freedom) {
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(freedom), x));
}

}  // namespace cylon::statistics
