#include "reference/certified/graph.h"

#include <algorithm>

namespace cylon::certified {

bool Graph::is(int node, double value) const {
  return nodes_[static_cast<std::size_t>(node)].op == Op::constant && this->value(node).is(value);
}

int Graph::make(Op op, int a, int b, Kind kind, const Ball& value) {
  nodes_.push_back({op, a, b, kind});
  values_.push_back(value);
  return static_cast<int>(nodes_.size()) - 1;
}

int Graph::constant(const Ball& value) {
  // Exact doubles are shared, so that zeros and ones are known again.
  const double middle = value.middle();
  if (!value.is(middle)) return make(Op::constant, -1, -1, Kind::fixed, value);
  const auto [place, fresh] = exact_.try_emplace(middle == 0 ? 0 : middle, 0);
  if (fresh) place->second = make(Op::constant, -1, -1, Kind::fixed, value);
  return place->second;
}

// Of the kind of what depends on time, so that it is not folded.
int Graph::parameter() { return make(Op::parameter, -1, -1, Kind::timed); }

int Graph::time() {
  const auto [place, fresh] = known_.try_emplace({Op::time, -1, -1}, 0);
  if (fresh) place->second = make(Op::time, -1, -1, Kind::timed);
  return place->second;
}

int Graph::cosine(const Ball& frequency) {
  if (frequency.is(0)) return constant(1.0);
  const auto [place, fresh] = cosines_.try_emplace(frequency.middle(), 0);
  if (fresh) place->second = make(Op::cosine, -1, -1, Kind::timed, frequency);
  return place->second;
}

int Graph::state() {
  states_.push_back(make(Op::state, static_cast<int>(states_.size()), -1, Kind::moving));
  return states_.back();
}

int Graph::fold(Op op, int a, int b) {
  Ball result;
  const arb_srcptr x = value(a).get(), y = value(b).get();
  if (op == Op::add) arb_add(result.get(), x, y, bits_);
  if (op == Op::subtract) arb_sub(result.get(), x, y, bits_);
  if (op == Op::multiply) arb_mul(result.get(), x, y, bits_);
  if (op == Op::divide) arb_div(result.get(), x, y, bits_);
  if (op == Op::root) arb_sqrt(result.get(), x, bits_);
  return constant(result);
}

int Graph::binary(Op op, int a, int b) {
  if (fixed(a, b)) return fold(op, a, b);
  const auto [place, fresh] = known_.try_emplace({op, a, b}, 0);
  if (fresh) place->second = make(op, a, b, std::max(kind(a), kind(b)));
  return place->second;
}

int Graph::add(int a, int b) {
  if (is(a, 0)) return b;
  if (is(b, 0)) return a;
  return binary(Op::add, std::min(a, b), std::max(a, b));
}

int Graph::subtract(int a, int b) {
  if (is(b, 0)) return a;
  if (a == b) return constant(0.0);
  if (is(a, 0)) return multiply(constant(-1.0), b);
  return binary(Op::subtract, a, b);
}

// A constant factor stands first, then a parameter.
int Graph::multiply(int a, int b) {
  const auto rank = [&](int node) { return std::tuple(kind(node) != Kind::fixed, !steady(node)); };
  if (rank(b) < rank(a) || (rank(a) == rank(b) && kind(a) != Kind::fixed && a > b)) std::swap(a, b);
  if (is(a, 0) || is(b, 0)) return constant(0.0);
  if (is(a, 1)) return b;
  return binary(Op::multiply, a, b);
}

int Graph::divide(int a, int b) {
  if (is(a, 0)) return a;
  if (kind(b) == Kind::fixed) return multiply(fold(Op::divide, constant(1.0), b), a);
  return binary(Op::divide, a, b);
}

int Graph::root(int a) {
  if (kind(a) == Kind::fixed) return fold(Op::root, a, a);
  return binary(Op::root, a, a);
}

}  // namespace cylon::certified
