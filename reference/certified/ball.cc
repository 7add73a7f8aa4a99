#include "reference/certified/ball.h"

#include <cmath>
#include <memory>
#include <stdexcept>

namespace cylon::certified {

Ball::Ball(const std::string& decimal, slong bits) : Ball() {
  if (arb_set_str(x_, decimal.c_str(), bits) != 0)
    throw std::invalid_argument("'" + decimal + "' is no decimal number");
}

double largest(arb_srcptr x) {
  mag_t bound;
  mag_init(bound);
  arb_get_mag(bound, x);
  const double result = mag_get_d(bound);  // exact: a mag_t has 30 bits
  mag_clear(bound);
  return result;
}

double Ball::largest() const { return certified::largest(x_); }

double Ball::smallest() const {
  mag_t bound;
  mag_init(bound);
  arb_get_mag_lower(bound, x_);
  const double result = mag_get_d(bound);
  mag_clear(bound);
  return result;
}

double Ball::radius_of_middle() const {
  Ball difference(middle());
  arb_sub(difference.x_, x_, difference.x_, 64);
  return difference.largest();
}

void Ball::widen(double by) {
  mag_t more;
  mag_init(more);
  mag_set_d(more, by);  // an upper bound
  mag_add(arb_radref(x_), arb_radref(x_), more);
  mag_clear(more);
}

std::string Ball::text(int digits) const {
  Ball middle;
  arf_set(arb_midref(middle.x_), arb_midref(x_));
  const std::unique_ptr<char, decltype(&flint_free)> text(arb_get_str(middle.x_, digits, ARB_STR_NO_RADIUS),
                                                          &flint_free);
  return text.get();
}

}  // namespace cylon::certified
