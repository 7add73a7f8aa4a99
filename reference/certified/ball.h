// A real number known to lie in a ball: Arb's arb_t with the manners of a value.
#pragma once

#include <arb.h>

#include <string>
#include <utility>

namespace cylon::certified {

/// Midpoint and radius; every operation of Arb on it encloses the exact result.
class Ball {
 public:
  Ball() { arb_init(x_); }
  explicit Ball(double exact) : Ball() { arb_set_d(x_, exact); }
  /// The decimal number itself, enclosed to `bits`; "0.1" is a tenth.  Throws std::invalid_argument.
  Ball(const std::string& decimal, slong bits);
  Ball(const Ball& other) : Ball() { arb_set(x_, other.x_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(x_, other.x_); }
  Ball& operator=(const Ball& other) {
    arb_set(x_, other.x_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    arb_swap(x_, other.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }

  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }

  double middle() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }
  double radius() const { return mag_get_d(arb_radref(x_)); }  ///< Not below the exact radius.
  double largest() const;                                      ///< |x| <= largest().
  double smallest() const;                                     ///< |x| >= smallest(); 0 where it may vanish.
  /// What lies between the midpoint rounded to double and the farthest point of the ball.
  double radius_of_middle() const;
  bool is(double value) const { return arb_equal_d(value); }
  bool finite() const { return arb_is_finite(x_) != 0; }

  /// Adds to the radius.
  void widen(double by);

  /// Midpoint in decimal with so many significant digits.
  std::string text(int digits) const;

 private:
  bool arb_equal_d(double value) const { return arb_is_exact(x_) && arf_cmp_d(arb_midref(x_), value) == 0; }
  arb_t x_;
};

/// |x| <= the result, exact but for numbers that a double cannot hold.
double largest(arb_srcptr);

}  // namespace cylon::certified
