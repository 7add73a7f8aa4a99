#include "reference/certified/tails.h"

#include <algorithm>

namespace cylon::certified {

Tails::Tails(const Graph& graph, int order)
    : graph_(graph),
      order_(order),
      stride_(static_cast<std::size_t>(order) + 1),
      given_(graph.size() * stride_),
      scaled_(graph.size() * stride_),
      from_(graph.size() * stride_),
      least_(graph.size()),
      beyond_(graph.size()),
      rest_(graph.size()) {}

double Tails::beyond(const double* a, const double* b_from) const {
  double sum = 0;
  for (int j = 1; j <= order_; ++j) sum += a[j] * b_from[order_ + 1 - j];
  return above(sum);
}

double Tails::smallest(int node) const {
  const auto i = static_cast<std::size_t>(node);
  return below(least_[i] - (order_ > 0 ? from_[index(node, 1)] : 0) - rest_[i]);
}

void Tails::scale(double h) {
  step_ = h;
  std::vector<double> power(stride_, 1);
  for (std::size_t k = 1; k < stride_; ++k) power[k] = above(power[k - 1] * h);
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    double sum = 0;
    for (std::size_t k = stride_; k-- > 0;) {
      const double m = above(given_[i * stride_ + k] * power[k]);
      scaled_[i * stride_ + k] = m;
      from_[i * stride_ + k] = sum = above(sum + m);
    }
  }
  // The part of each rest that does not depend on the others.
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    const Node& node = graph_[i];
    const int c = static_cast<int>(i);
    beyond_[i] = 0;
    if (node.op == Op::cosine) {  // (f h)^(N+1)/(N+1)!, Lagrange's remainder
      const double x = above(graph_.value(c).largest() * h);
      double bound = 1;
      for (int k = 1; k <= order_ + 1; ++k) bound = above(bound * x / k);
      beyond_[i] = bound;
    }
    if (node.op == Op::multiply && !graph_.steady(node.a)) beyond_[i] = beyond(scaled(node.a), from(node.b));
    if (node.op == Op::divide) beyond_[i] = beyond(scaled(node.b), from(c));
    if (node.op == Op::root) beyond_[i] = beyond(scaled(c), from(c));
  }
}

// Rests of all nodes from those of the states; false where a divisor may vanish.
bool Tails::spread() {
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    const Node& node = graph_[i];
    const int c = static_cast<int>(i);
    const bool leaf = node.op < Op::add;
    const double a = leaf ? 0 : rest(node.a), b = leaf ? 0 : rest(node.b);
    switch (node.op) {
      case Op::constant:
      case Op::parameter:
      case Op::state:
      case Op::time:
        break;
      case Op::cosine:
        rest_[i] = beyond_[i];
        break;
      case Op::add:
      case Op::subtract:
        rest_[i] = above(a + b);
        break;
      case Op::multiply:
        rest_[i] = above(beyond_[i] + a * size(node.b) + size(node.a) * b + a * b);
        break;
      case Op::divide: {
        const double divisor = smallest(node.b);
        if (!(divisor > 0)) return false;
        rest_[i] = above((beyond_[i] + a + b * size(c)) / divisor);
        break;
      }
      case Op::root: {
        // The exact root is at least sqrt(min a), the polynomial at least its first coefficient less the
        // others.
        const double radicand = smallest(node.a), polynomial = below(least_[i] - from_[index(c, 1)]);
        if (!(radicand > 0) || !(polynomial > 0)) return false;
        rest_[i] = above((beyond_[i] + a) / below(std::sqrt(radicand) + polynomial));
        break;
      }
    }
  }
  return true;
}

bool Tails::prove(double h) {
  scale(h);
  std::ranges::fill(rest_, 0.0);
  constexpr int trials = 25;
  for (int trial = 0; trial < trials; ++trial) {
    if (!spread()) return false;
    bool proven = true;
    for (std::size_t s = 0; s < graph_.rates.size(); ++s) {
      const int rate = graph_.rates[s];
      const int x = graph_.states()[s];
      const double needed = above(above(scaled(rate, order_) * h / (order_ + 1)) + h * rest(rate));
      if (needed <= rest(x)) continue;
      proven = false;
      if (!(needed < 1e100)) return false;
      rest_[static_cast<std::size_t>(x)] = above(1.25 * needed);
    }
    if (proven) return true;
  }
  return false;
}

}  // namespace cylon::certified
