#include "reference/certified/flow.h"

#include <fmt/format.h>
#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <span>

namespace cylon::certified {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Of the tangents: they multiply what is as small as the result's radius, and need no more than some digits.
int tangent_order(int order) { return std::max(10, order / 2); }

class Flow {
 public:
  Flow(const Model& model, double horizon, const Effort& effort)
      : model_(model),
        effort_(effort),
        order_(order_of(effort)),
        centre_(model.graph, order_, effort.bits),
        tails_(model.graph, order_),
        variation_(model.graph, tangent_order(order_)),
        gram_(model.gram.graph, 0, effort.bits),
        set_(model.initial),
        path_(MatrixXd::Identity(dimension(), dimension())) {
    // Starts of steps are multiples of a power of two, so that they and the steps are exact.
    quantum_ = std::exp2(std::ceil(std::log2(horizon)) - 46);
    end_ = std::ceil(horizon / quantum_) * quantum_;
  }

  void run(const std::function<bool(const Step&)>& show) {
    double time = 0;
    while (time < end_) {
      const double h = step(time);
      if (!show({time, h, &centre_, &tails_, &variation_, &set_, &path_, effort_.remainder, effort_.offset}))
        return;
      time += h;
      if (time < end_) advance(time - h, h);
    }
  }

 private:
  Index dimension() const { return static_cast<Index>(model_.initial.size()); }

  // C with C gram C^T = 1 about the centre, to rounding; 1 where rounding leaves no such.
  void combine(double time) {
    if (model_.combinations.empty()) return;
    gram_.expand(time, std::span(set_.centre).first(model_.gram.graph.states().size()));
    const auto n = static_cast<Index>(std::sqrt(2.0 * static_cast<double>(model_.gram.entries.size())));
    MatrixXd gram(n, n);
    auto entry = model_.gram.entries.begin();
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j <= i; ++j)
        gram(i, j) = gram(j, i) = arf_get_d(arb_midref(gram_[*entry++]), ARF_RND_NEAR);
    MatrixXd c = MatrixXd::Identity(n, n);
    if (const Eigen::LLT<MatrixXd> factors(gram); factors.info() == Eigen::Success)
      factors.matrixL().solveInPlace(c);
    if (!c.allFinite()) c.setIdentity();
    auto parameter = model_.combinations.begin();
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j <= i; ++j, ++parameter)
        centre_.choose(*parameter, c(i, j)), variation_.choose(*parameter, c(i, j));
  }

  // Expands about `time` and finds a step over which everything is proven.
  double step(double time) {
    combine(time);
    centre_.expand(time, set_.centre);
    for (std::size_t i = 0; i < model_.graph.size(); ++i) {
      const int node = static_cast<int>(i);
      const bool fixed = model_.graph[i].kind == Kind::fixed;
      for (int k = 0; k <= (fixed ? 0 : order_); ++k)
        tails_.coefficient(node, k) = largest(centre_[node] + k);
      tails_.least(node) = least(centre_[node]);
    }
    variation_.expand(time, set_.hull());
    variation_.differentiate(set_.axes);
    double h = std::min(wanted(), end_ - time);
    bool refined = false;
    constexpr int trials = 60;
    for (int trial = 0; trial < trials; ++trial, h *= 0.75) {
      h = std::max(quantum_, std::floor(h / quantum_) * quantum_);
      if (!tails_.prove(h)) continue;
      const double rest = largest_rest();
      if (!refined && rest > effort_.step_error && h > quantum_) {
        // The proof counts more than the last terms: h once more, by the order with which rests fall.
        refined = true;
        h *= std::pow(effort_.step_error / rest, 1.0 / (order_ + 1)) / 0.75;
        continue;
      }
      if (variation_.prove(h)) return h;
    }
    throw Stuck(time,
                fmt::format("the solution cannot be continued beyond {:.6g} s: a distance that divides, a "
                            "mass or the joints' equations come too near to zero, or bounds are lost",
                            time));
  }

  static double least(arb_srcptr x) {
    mag_t bound;
    mag_init(bound);
    arb_get_mag_lower(bound, x);
    const double result = below(mag_get_d(bound));
    mag_clear(bound);
    return result;
  }

  double largest_rest() const {
    double rest = 0;
    for (const int state : model_.graph.states()) rest = std::max(rest, tails_.rest(state));
    return rest;
  }

  // Where the last two terms of every state reach what may be left out: Jorba & Zou, A software package for
  // the numerical integration of ODEs by means of high-order Taylor methods (2005), section 3.2.
  double wanted() {
    double h = end_;
    for (const int state : model_.graph.states())
      for (const int k : {order_ - 1, order_}) {
        const double c = tails_.coefficient(state, k);
        if (c > 0) h = std::min(h, std::pow(effort_.step_error / c, 1.0 / k));
      }
    return h;
  }

  void advance(double start, double h) {
    const Index n = dimension();
    std::vector<Ball> image;
    MatrixXd tangents(n, n), blur(n, n);
    const Ball exact(h);
    for (Index i = 0; i < n; ++i) {
      const int state = model_.graph.states()[static_cast<std::size_t>(i)];
      image.push_back(centre_.at(state, exact));
      if (effort_.remainder) image.back().widen(tails_.rest(state));
      for (Index d = 0; d < n; ++d) {
        const Near x = variation_.tangent(state, static_cast<int>(d), h);
        tangents(i, d) = x.middle, blur(i, d) = x.radius;
      }
    }
    path_ = tangents * (set_.axes.transpose() * path_);
    set_.move(image, tangents, blur);
    if (!set_.radii.allFinite() || !path_.allFinite())
      throw Stuck(start, fmt::format("the enclosure is lost at {:.6g} s", start));
  }

  const Model& model_;
  Effort effort_;
  int order_;
  Series centre_;
  Tails tails_;
  Variation variation_;
  Series gram_;
  Enclosure set_;
  MatrixXd path_;
  double quantum_ = 0, end_ = 0;
};

}  // namespace

// Work per unit of time is about N^2/h with h = radius 10^(-digits/N), least at N = digits ln(10)/2.
int order_of(const Effort& effort) {
  return std::clamp(static_cast<int>(std::ceil(-1.15 * std::log10(effort.step_error))), 12, 400);
}

Ball Step::at(int node, double t) const {
  Ball since(t), begin(start);
  arb_sub(since.get(), since.get(), begin.get(), centre->bits());
  Ball result = centre->at(node, since);
  if (tails->graph()[static_cast<std::size_t>(node)].kind == Kind::fixed) return result;
  if (remainder) result.widen(tails->rest(node));
  double spread = 0;
  for (Index d = 0; d < set->radii.size(); ++d)
    spread =
        above(spread + variation->tangent(node, static_cast<int>(d), t - start).largest() * set->radii[d]);
  result.widen(spread);
  return result;
}

Ball Step::within(int node, const Ball& since) const {
  Ball result = centre->at(node, since);
  if (tails->graph()[static_cast<std::size_t>(node)].kind == Kind::fixed) return result;
  if (remainder) result.widen(tails->rest(node));
  const double last = std::min(length, since.largest());
  double spread = 0;
  for (Index d = 0; d < set->radii.size(); ++d)
    spread = above(spread + variation->largest(node, static_cast<int>(d), last) * set->radii[d]);
  result.widen(spread);
  return result;
}

double Step::radius(int node) const {
  if (tails->graph()[static_cast<std::size_t>(node)].kind == Kind::fixed) return 0;
  double sum = tails->rest(node);
  for (Index d = 0; d < set->radii.size(); ++d)
    sum = above(sum + variation->largest(node, static_cast<int>(d)) * set->radii[d]);
  return sum;
}

Eigen::VectorXd Step::sensitivity(int node, double t) const {
  Eigen::VectorXd along(set->radii.size());
  for (Index d = 0; d < along.size(); ++d)
    along[d] = variation->tangent(node, static_cast<int>(d), t - start).middle;
  return path->transpose() * (set->axes * along);
}

void follow(const Model& model, double horizon, const Effort& effort,
            const std::function<bool(const Step&)>& show) {
  Flow(model, horizon, effort).run(show);
}

}  // namespace cylon::certified
