#include "reference/certified/impacts.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::certified {
namespace {

constexpr slong bits_of_double = 64;

bool positive(const Ball& x) { return arb_is_positive(x.get()) != 0; }
bool negative(const Ball& x) { return arb_is_negative(x.get()) != 0; }

class Search {
 public:
  Search(const Step& step, const Contact& contact) : step_(step), contact_(contact) {}

  // Of the first root in [a, b], where the gap is open at, or just after, a.
  std::optional<Ball> root(double a, double b, int depth = 0) const {
    const Ball piece = span(a, b), middle(a + (b - a) / 2);
    const Ball rate = value(contact_.rate, piece);
    // gap over the piece, by the mean value theorem.
    Ball reach;
    arb_sub(reach.get(), piece.get(), middle.get(), bits());
    arb_mul(reach.get(), reach.get(), rate.get(), bits());
    arb_add(reach.get(), reach.get(), value(contact_.gap, middle).get(), bits());
    if (positive(rate) || positive(reach)) return std::nullopt;
    if (negative(rate)) {
      const Ball end = value(contact_.gap, Ball(b));
      if (positive(end)) return std::nullopt;
      if (negative(end)) return narrowed(piece);
    }
    constexpr int most = 90;
    const double between = a + (b - a) * 0.484375;  // off the middle, so that no symmetry puts a root there
    if (depth == most || !(a < between && between < b))
      throw Stuck(step_.start + a,
                  fmt::format("{}: near {:.6g} s it cannot be proven whether they touch: they "
                              "graze, rest, or rebound too little for the radius",
                              contact_.names, step_.offset + step_.start + a));
    if (auto found = root(a, between, depth + 1)) return found;
    return root(between, b, depth + 1);
  }

 private:
  slong bits() const { return step_.centre->bits(); }
  Ball value(int node, const Ball& since) const { return step_.within(node, since); }

  // Newton's operator m - gap(m)/gap'(X), which holds the root, until it gives no more.
  Ball narrowed(Ball x) const {
    constexpr int most = 60;
    for (int i = 0; i < most; ++i) {
      Ball middle = x, next;
      mag_zero(arb_radref(middle.get()));
      const Ball gap = value(contact_.gap, middle), rate = value(contact_.rate, x);
      arb_div(next.get(), gap.get(), rate.get(), bits());
      arb_sub(next.get(), middle.get(), next.get(), bits());
      Ball both;
      if (!arb_intersection(both.get(), x.get(), next.get(), bits())) break;
      const bool slow = !(both.radius() < 0.5 * x.radius());
      if (both.radius() < x.radius()) x = both;
      if (slow) break;
    }
    return x;
  }

  const Step& step_;
  const Contact& contact_;
};

}  // namespace

Ball span(double a, double b) {
  Ball low(a), high(b), result;
  arb_union(result.get(), low.get(), high.get(), bits_of_double);
  return result;
}

double lower(const Ball& x) {
  arf_t bound;
  arf_init(bound);
  arb_get_lbound_arf(bound, x.get(), bits_of_double);
  const double result = arf_get_d(bound, ARF_RND_FLOOR);
  arf_clear(bound);
  return result;
}

double upper(const Ball& x) {
  arf_t bound;
  arf_init(bound);
  arb_get_ubound_arf(bound, x.get(), bits_of_double);
  const double result = arf_get_d(bound, ARF_RND_CEIL);
  arf_clear(bound);
  return result;
}

std::optional<Impact> first_impact(const Model& model, const Step& step, double until) {
  std::optional<Impact> first;
  double end = std::min(step.length, until);
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    const auto found = Search(step, model.contacts[c]).root(0, end);
    if (!found) continue;
    if (first && arb_gt(found->get(), first->time.get())) continue;
    if (first && !arb_lt(found->get(), first->time.get()))
      throw Stuck(step.start, fmt::format("two impacts cannot be told apart near {:.6g} s: {}, and {}",
                                          step.offset + step.start + found->middle(),
                                          model.contacts[first->contact].names, model.contacts[c].names));
    first = Impact{*found, c};
    // A little beyond, so that a root at the same instant is seen as one.
    end = std::min(end, upper(*found) + 0x1p-20 * step.length);
  }
  return first;
}

std::vector<Ball> state_after(const Model& model, const Step& step, const Impact& impact) {
  const Contact& contact = model.contacts[impact.contact];
  std::vector<Ball> state;
  for (const int node : model.graph.states()) state.push_back(step.within(node, impact.time));
  for (const auto& [index, node] : contact.after)
    state[static_cast<std::size_t>(index)] = step.within(node, impact.time);
  return state;
}

}  // namespace cylon::certified
