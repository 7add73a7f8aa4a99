#include "reference/exact/turning.h"

namespace cylon::exact {
namespace {

struct Value {
  Wide f, slope;
};

Value horner(std::span<const Wide> c, Wide x) {
  Value v = {0, 0};
  for (std::size_t i = c.size(); i-- > 0;) {
    v.slope = v.slope * x + v.f;
    v.f = v.f * x + c[i];
  }
  return v;
}

// The root between `positive` and `negative`, where f has these signs.
Wide root_between(std::span<const Wide> c, Wide positive, Wide negative) {
  Wide x = (positive + negative) / 2;
  for (int i = 0; i < 400; ++i) {
    const Value v = horner(c, x);
    if (v.f == 0) return x;
    (v.f > 0 ? positive : negative) = x;
    Wide next = x - v.f / v.slope;
    if (!(std::min(positive, negative) <= next && next <= std::max(positive, negative))) {
      next = (positive + negative) / 2;
    }
    if (next == x) return x;
    x = next;
  }
  return x;
}

}  // namespace

TurningPoints turning_points(std::span<const Wide> c, Wide lo, Wide hi) {
  if (c[0] > 0) return {root_between(c, 0, lo), root_between(c, 0, hi)};
  // f = x q(x): the motion starts at a turning point and leaves it to the side of q(0)'s sign.
  const std::span<const Wide> q = c.subspan(1);
  if (q[0] > 0) return {0, root_between(q, 0, hi)};
  if (q[0] < 0) return {root_between(q, lo, 0), 0};
  return {0, 0};
}

}  // namespace cylon::exact
