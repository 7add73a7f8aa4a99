#include "reference/certified/series.h"

namespace cylon::certified {

Series::Series(const Graph& graph, int order, slong bits)
    : graph_(graph),
      order_(order),
      bits_(bits),
      stride_(static_cast<std::size_t>(order) + 1),
      coefficients_(_arb_vec_init(static_cast<slong>(graph.size() * stride_))) {
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const int node = static_cast<int>(i);
    if (graph[i].op == Op::constant) arb_set(row(node), graph.value(node).get());
    if (graph[i].op > Op::parameter && graph[i].op != Op::state) active_.push_back(node);
  }
}

Series::~Series() { _arb_vec_clear(coefficients_, static_cast<slong>(graph_.size() * stride_)); }

// With c_k the coefficient k:  a b: sum_j a_j b_(k-j).   c = a/b from c b = a, c = sqrt a from c c = a,
// solved for c_k.   cos(f t): f^k/k! cos(f time + k pi/2).
void Series::next(int i, int k) {
  const Node& node = graph_[static_cast<std::size_t>(i)];
  arb_ptr c = row(i);
  const arb_srcptr a = node.op < Op::add ? nullptr : row(node.a), b = node.b < 0 ? nullptr : row(node.b);
  switch (node.op) {
    case Op::constant:
    case Op::parameter:
    case Op::state:
      return;
    case Op::time:
      return k == 0 ? arb_set_d(c, time_) : k == 1 ? arb_one(c + 1) : arb_zero(c + k);
    case Op::cosine: {
      const Ball& frequency = graph_.value(i);
      Ball angle(time_), s;
      arb_mul(angle.get(), angle.get(), frequency.get(), bits_ + 32);
      arb_sin_cos(s.get(), c + k, angle.get(), bits_);
      if (k % 2 == 1) arb_set(c + k, s.get());
      if (k % 4 == 1 || k % 4 == 2) arb_neg(c + k, c + k);
      for (int j = 1; j <= k; ++j) {
        arb_mul(c + k, c + k, frequency.get(), bits_);
        arb_div_si(c + k, c + k, j, bits_);
      }
      return;
    }
    case Op::add:
      return arb_add(c + k, a + k, b + k, bits_);
    case Op::subtract:
      return arb_sub(c + k, a + k, b + k, bits_);
    case Op::multiply:
      if (graph_.steady(node.a)) return arb_mul(c + k, a, b + k, bits_);
      return arb_dot(c + k, nullptr, 0, a, 1, b + k, -1, k + 1, bits_);
    case Op::divide:
      if (k > 0) arb_dot(c + k, a + k, 1, b + 1, 1, c + k - 1, -1, k, bits_);
      return arb_div(c + k, k > 0 ? c + k : a, b, bits_);
    case Op::root: {
      if (k == 0) return arb_sqrt(c, a, bits_);
      Ball twice;
      arb_dot(c + k, a + k, 1, c + 1, 1, c + k - 1, -1, k - 1, bits_);
      arb_mul_2exp_si(twice.get(), c, 1);
      return arb_div(c + k, c + k, twice.get(), bits_);
    }
  }
}

void Series::expand(double time, std::span<const Ball> states) {
  time_ = time;
  for (std::size_t s = 0; s < states.size(); ++s) arb_set(row(graph_.states()[s]), states[s].get());
  for (int k = 0; k <= order_; ++k) {
    for (const int node : active_) next(node, k);
    if (k == order_) break;
    for (std::size_t s = 0; s < states.size(); ++s) {
      const int rate = graph_.rates[s];
      arb_ptr next_one = row(graph_.states()[s]) + k + 1;
      if (graph_[static_cast<std::size_t>(rate)].kind == Kind::fixed && k > 0)
        arb_zero(next_one);
      else
        arb_div_si(next_one, row(rate) + k, k + 1, bits_);
    }
  }
}

Ball Series::at(int node, const Ball& t) const {
  Ball sum;
  if (graph_[static_cast<std::size_t>(node)].kind == Kind::fixed) {
    arb_set(sum.get(), row(node));
    return sum;
  }
  for (int k = order_; k >= 0; --k) {
    arb_mul(sum.get(), sum.get(), t.get(), bits_);
    arb_add(sum.get(), sum.get(), row(node) + k, bits_);
  }
  return sum;
}

}  // namespace cylon::certified
