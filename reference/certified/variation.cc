#include "reference/certified/variation.h"

#include "reference/certified/near_series.h"

#include <algorithm>

namespace cylon::certified {
namespace {

Near near(const Ball& x) { return {x.middle(), x.radius_of_middle()}; }

// Coefficient k of cos(f (time + t)): f^k/k! cos(f time + k pi/2).
Near cosine_coefficient(const Ball& frequency, double time, int k) {
  constexpr slong bits = 96;
  Ball angle(time), s, c;
  arb_mul(angle.get(), angle.get(), frequency.get(), bits);
  arb_sin_cos(s.get(), c.get(), angle.get(), bits);
  Ball result = k % 2 == 1 ? s : c;
  if (k % 4 == 1 || k % 4 == 2) arb_neg(result.get(), result.get());
  for (int j = 1; j <= k; ++j) {
    arb_mul(result.get(), result.get(), frequency.get(), bits);
    arb_div_si(result.get(), result.get(), j, bits);
  }
  return near(result);
}

}  // namespace

Variation::Variation(const Graph& graph, int order)
    : graph_(graph),
      order_(order),
      stride_(static_cast<std::size_t>(order) + 1),
      middle_(graph.size() * stride_),
      radius_(graph.size() * stride_),
      tails_(graph, order),
      scaled_(graph.size() * stride_),
      from_(graph.size() * stride_),
      beyond_(graph.size()) {
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const int node = static_cast<int>(i);
    if (graph[i].op == Op::constant) {
      const Near x = near(graph.value(node));
      *value(node).middle = x.middle, *value(node).radius = x.radius;
    } else if (graph[i].op != Op::state && graph[i].op != Op::parameter) {
      active_.push_back(node);
      if (graph[i].kind == Kind::moving) moving_.push_back(node);
    }
  }
}

// ---- Coefficients ----------------------------------------------------------------------------------

void Variation::next(int i, int k) {
  const Node& node = graph_[static_cast<std::size_t>(i)];
  const Field c = value(i);
  const bool leaf = node.op < Op::add;
  const Field a = leaf ? c : value(node.a), b = leaf ? c : value(node.b);
  Sum sum;
  Near result;
  switch (node.op) {
    case Op::constant:
    case Op::parameter:
    case Op::state:
      return;
    case Op::time:
      result.middle = k == 0 ? time_ : k == 1 ? 1 : 0;
      break;
    case Op::cosine:
      result = cosine_coefficient(graph_.value(i), time_, k);
      break;
    case Op::add:
    case Op::subtract:
      sum.add(1, a.middle[k], a.radius[k]);
      sum.add(node.op == Op::add ? 1 : -1, b.middle[k], b.radius[k]);
      result = sum.result();
      break;
    case Op::multiply: {
      const bool scaled = graph_.steady(node.a);
      sum.add(1, a.middle, a.radius, b.middle, b.radius, k, 0, scaled ? 0 : k);
      result = sum.result();
      break;
    }
    case Op::divide:
      sum.add(1, a.middle[k], a.radius[k]);
      sum.add(-1, b.middle, b.radius, c.middle, c.radius, k, 1, k);
      result = quotient(sum.result(), {b.middle[0], b.radius[0]});
      break;
    case Op::root:
      if (k == 0) {
        result = root({a.middle[0], a.radius[0]});
        break;
      }
      sum.add(1, a.middle[k], a.radius[k]);
      sum.add(-1, c.middle, c.radius, c.middle, c.radius, k, 1, k - 1);
      result = quotient(sum.result(), {2 * c.middle[0], 2 * c.radius[0]});
      break;
  }
  c.middle[k] = result.middle, c.radius[k] = result.radius;
}

void Variation::next_slope(int i, int d, int k) {
  const Node& node = graph_[static_cast<std::size_t>(i)];
  const Field c = value(i), a = value(node.a), b = value(node.b);
  const Field s = slope(i, d), da = slope(node.a, d), db = slope(node.b, d);
  const bool a_moves = graph_[static_cast<std::size_t>(node.a)].kind == Kind::moving,
             b_moves = graph_[static_cast<std::size_t>(node.b)].kind == Kind::moving,
             a_fixed = graph_.steady(node.a);
  Sum sum;
  Near result;
  switch (node.op) {
    case Op::constant:
    case Op::parameter:
    case Op::time:
    case Op::cosine:
    case Op::state:
      return;
    case Op::add:
    case Op::subtract:
      if (a_moves) sum.add(1, da.middle[k], da.radius[k]);
      if (b_moves) sum.add(node.op == Op::add ? 1 : -1, db.middle[k], db.radius[k]);
      result = sum.result();
      break;
    case Op::multiply:
      if (a_moves) sum.add(1, da.middle, da.radius, b.middle, b.radius, k, 0, k);
      if (b_moves) sum.add(1, a.middle, a.radius, db.middle, db.radius, k, 0, a_fixed ? 0 : k);
      result = sum.result();
      break;
    case Op::divide:
      if (a_moves) sum.add(1, da.middle[k], da.radius[k]);
      if (b_moves) sum.add(-1, db.middle, db.radius, c.middle, c.radius, k, 0, k);
      sum.add(-1, b.middle, b.radius, s.middle, s.radius, k, 1, k);
      result = quotient(sum.result(), {b.middle[0], b.radius[0]});
      break;
    case Op::root:
      sum.add(0.5, da.middle[k], da.radius[k]);
      sum.add(-1, c.middle, c.radius, s.middle, s.radius, k, 1, k);
      result = quotient(sum.result(), {c.middle[0], c.radius[0]});
      break;
  }
  s.middle[k] = result.middle, s.radius[k] = result.radius;
}

void Variation::expand(double time, std::span<const Near> box) {
  time_ = time;
  for (std::size_t s = 0; s < box.size(); ++s) {
    const Field x = value(graph_.states()[s]);
    *x.middle = box[s].middle, *x.radius = box[s].radius;
  }
  for (int k = 0; k <= order_; ++k) {
    for (const int node : active_) next(node, k);
    for (std::size_t s = 0; k < order_ && s < box.size(); ++s) {
      const Field x = value(graph_.states()[s]), rate = value(graph_.rates[s]);
      const Near q = quotient({rate.middle[k], rate.radius[k]}, {k + 1.0, 0});
      x.middle[k + 1] = q.middle, x.radius[k + 1] = q.radius;
    }
  }
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    const int node = static_cast<int>(i);
    const Field c = value(node);
    for (int k = 0; k <= order_; ++k) tails_.coefficient(node, k) = Near{c.middle[k], c.radius[k]}.largest();
    tails_.least(node) = below(std::abs(*c.middle) - *c.radius);
  }
}

void Variation::differentiate(const Eigen::MatrixXd& directions) {
  const int count = static_cast<int>(directions.cols());
  if (count != directions_) {
    directions_ = count;
    const std::size_t all = static_cast<std::size_t>(count) * graph_.size();
    slope_middle_.assign(all * stride_, 0);
    slope_radius_.assign(all * stride_, 0);
    size_.assign(all, 0);
    rest_.assign(all, 0);
  }
  for (int d = 0; d < count; ++d) {
    for (std::size_t s = 0; s < graph_.states().size(); ++s)
      *slope(graph_.states()[s], d).middle = directions(static_cast<Eigen::Index>(s), d);
    for (int k = 0; k <= order_; ++k) {
      for (const int node : moving_) next_slope(node, d, k);
      for (std::size_t s = 0; k < order_ && s < graph_.states().size(); ++s) {
        const Field x = slope(graph_.states()[s], d), rate = slope(graph_.rates[s], d);
        const Near q = quotient({rate.middle[k], rate.radius[k]}, {k + 1.0, 0});
        x.middle[k + 1] = q.middle, x.radius[k + 1] = q.radius;
      }
    }
  }
}

// ---- What the polynomials leave out ----------------------------------------------------------------

void Variation::scale(int d) {
  std::vector<double> power(stride_, 1);
  for (std::size_t k = 1; k < stride_; ++k) power[k] = above(power[k - 1] * tails_.step());
  const auto sizes = size_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(d) * graph_.size());
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    const Field s = slope(static_cast<int>(i), d);
    double sum = 0;
    for (std::size_t k = stride_; k-- > 0;) {
      const double m = above((std::abs(s.middle[k]) + s.radius[k]) * power[k]);
      scaled_[i * stride_ + k] = m;
      from_[i * stride_ + k] = sum = above(sum + m);
    }
    sizes[static_cast<std::ptrdiff_t>(i)] = sum;
  }
  for (const int i : moving_) {
    const Node& node = graph_[static_cast<std::size_t>(i)];
    const bool linear = graph_.steady(node.a);
    double& sum = beyond_[static_cast<std::size_t>(i)];
    sum = 0;
    if (node.op == Op::multiply && !linear)
      sum = tails_.beyond(&scaled_[at(node.a)], tails_.from(node.b)) +
            tails_.beyond(tails_.scaled(node.a), &from_[at(node.b)]);
    if (node.op == Op::divide)
      sum = tails_.beyond(&scaled_[at(node.b)], tails_.from(i)) +
            tails_.beyond(tails_.scaled(node.b), &from_[at(i)]);
    if (node.op == Op::root) sum = 2 * tails_.beyond(tails_.scaled(i), &from_[at(i)]);
  }
}

void Variation::spread(int d) {
  double* rest = &rest_[static_cast<std::size_t>(d) * graph_.size()];
  const double* size = &size_[static_cast<std::size_t>(d) * graph_.size()];
  for (const int i : moving_) {
    const Node& node = graph_[static_cast<std::size_t>(i)];
    const double ra = rest[node.a], rb = rest[node.b], beyond = beyond_[static_cast<std::size_t>(i)];
    const auto whole = [&](int n) { return tails_.size(n) + tails_.rest(n); };
    switch (node.op) {
      case Op::constant:
      case Op::parameter:
      case Op::time:
      case Op::cosine:
      case Op::state:
        break;
      case Op::add:
      case Op::subtract:
        rest[i] = above(ra + rb);
        break;
      case Op::multiply:
        rest[i] = above(beyond + ra * whole(node.b) + size[node.a] * tails_.rest(node.b) +
                        rb * whole(node.a) + size[node.b] * tails_.rest(node.a));
        break;
      case Op::divide:
        rest[i] = above(
            (beyond + ra + rb * whole(i) + size[node.b] * tails_.rest(i) + tails_.rest(node.b) * size[i]) /
            tails_.smallest(node.b));
        break;
      case Op::root:
        rest[i] = above((beyond + ra + 2 * tails_.rest(i) * size[i]) /
                        below(2 * std::sqrt(below(tails_.smallest(node.a)))));
        break;
    }
  }
}

bool Variation::prove(int d) {
  scale(d);
  double* rest = &rest_[static_cast<std::size_t>(d) * graph_.size()];
  std::fill_n(rest, graph_.size(), 0.0);
  constexpr int trials = 25;
  const double h = tails_.step();
  for (int trial = 0; trial < trials; ++trial) {
    spread(d);
    bool proven = true;
    for (std::size_t s = 0; s < graph_.rates.size(); ++s) {
      const int rate = graph_.rates[s], x = graph_.states()[s];
      const double last = scaled_[at(rate) + stride_ - 1];
      const double needed = above(above(last * h / (order_ + 1)) + h * rest[rate]);
      if (needed <= rest[x]) continue;
      proven = false;
      if (!(needed < 1e100)) return false;
      rest[x] = above(1.25 * needed);
    }
    if (proven) return true;
  }
  return false;
}

bool Variation::prove(double h) {
  if (!tails_.prove(h)) return false;
  for (int d = 0; d < directions_; ++d)
    if (!prove(d)) return false;
  return true;
}

// ---- Results ---------------------------------------------------------------------------------------

Near Variation::tangent(int node, int d, double t) const {
  const std::size_t first = block(d) + at(node);
  double sum = 0, size = 0, blur = 0;
  for (std::size_t k = stride_; k-- > 0;) {
    sum = sum * t + slope_middle_[first + k];
    size = size * t + std::abs(slope_middle_[first + k]);
    blur = blur * t + slope_radius_[first + k];
  }
  const double rest = rest_[static_cast<std::size_t>(d) * graph_.size() + static_cast<std::size_t>(node)];
  return {sum, above(blur + rest + size * 0x1p-50 * (order_ + 2))};
}

double Variation::largest(int node, int d, double t) const {
  const std::size_t first = block(d) + at(node);
  double sum = 0;
  for (std::size_t k = stride_; k-- > 0;)
    sum = above(sum * t + std::abs(slope_middle_[first + k]) + slope_radius_[first + k]);
  return above(sum + rest_[static_cast<std::size_t>(d) * graph_.size() + static_cast<std::size_t>(node)]);
}

double Variation::largest(int node, int d) const {
  const std::size_t i = static_cast<std::size_t>(d) * graph_.size() + static_cast<std::size_t>(node);
  return above(size_[i] + rest_[i]);
}

}  // namespace cylon::certified
