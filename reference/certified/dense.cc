#include "reference/certified/dense.h"

#include "harness/core/content_hash.h"
#include "reference/certified/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace cylon::certified {
namespace {

// Beside the rounding to double this radius is nothing.
constexpr Goal goal{.radius = 1e-17, .most_bits = 512};

struct Radii {
  double position = 0, velocity = 0, orientation = 0, angular_velocity = 0;  // of a component
};

struct Outputs {
  std::array<int, Dense::numbers> nodes;

  explicit Outputs(const BodyNodes& b)
      : nodes{b.position[0],        b.position[1],    b.position[2],         b.orientation[0],
              b.orientation[1],     b.orientation[2], b.orientation[3],      b.velocity[0],
              b.velocity[1],        b.velocity[2],    b.angular_velocity[0], b.angular_velocity[1],
              b.angular_velocity[2]} {}
};

double& of_number(Radii& radii, std::size_t i) {
  return i < 3    ? radii.position
         : i < 7  ? radii.orientation
         : i < 10 ? radii.velocity
                  : radii.angular_velocity;
}

class Recorder {
 public:
  Recorder(const Model& model, Dense& dense) : model_(model), dense_(dense) {
    for (const BodyNodes& body : model.bodies) outputs_.emplace_back(body);
    for (std::size_t i = 0; i < model.initial.size(); ++i) length_.push_back(length_of_vector(i));
    dense_.first.push_back(0);
  }

  bool operator()(const Step& step) {
    dense_.starts.push_back(step.start);
    const int degree = degree_of(step);
    for (const Outputs& body : outputs_)
      for (std::size_t i = 0; i < Dense::numbers; ++i)
        keep(step, body.nodes[i], degree, of_number(radii_, i));
    dense_.first.push_back(dense_.coefficients.size());
    const double end = std::min(step.start + step.length, dense_.horizon);
    amplify(step, end);
    if (std::max({worst_.position, worst_.velocity, worst_.orientation, worst_.angular_velocity}) <= 1)
      return true;
    dense_.lost = end < dense_.horizon;
    dense_.horizon = end;
    return false;
  }

  double radius() const { return proven_; }
  // A vector has three components; a quaternion has four, is normalised, and half its angle is its distance.
  core::StateError error() const {
    const double root = std::sqrt(3.0);
    return {root * radii_.position, root * radii_.velocity, 2 * (2 * radii_.orientation + 0x1p-51),
            root * radii_.angular_velocity, 0};
  }

 private:
  // The vector that a state variable belongs to is a run of states of one body; its length at the start.
  double length_of_vector(std::size_t state) const {
    const int node = model_.graph.states()[state];
    for (const BodyNodes& b : model_.bodies) {
      if (contains(b.position, node)) return length(b.position);
      if (contains(b.velocity, node)) return length(b.velocity);
      if (contains(b.orientation, node)) return 1;
    }
    // Angular velocity in body axes: its three states follow the quaternion's.
    std::size_t first = state;
    while (!is_orientation(model_.graph.states()[first - 1])) --first;
    double sum = 0;
    for (std::size_t i = first; i < first + 3; ++i) sum += std::pow(model_.initial[i].middle(), 2);
    return std::sqrt(sum);
  }
  template <class Nodes>
  static bool contains(const Nodes& nodes, int node) {
    return std::ranges::find(nodes, node) != nodes.end();
  }
  bool is_orientation(int node) const {
    return std::ranges::any_of(model_.bodies,
                               [&](const BodyNodes& b) { return contains(b.orientation, node); });
  }
  double length(const std::array<int, 3>& nodes) const {
    double sum = 0;
    for (const int node : nodes) {
      const auto& states = model_.graph.states();
      const auto place = std::ranges::find(states, node) - states.begin();
      sum += std::pow(model_.initial[static_cast<std::size_t>(place)].middle(), 2);
    }
    return std::sqrt(sum);
  }

  // The least degree beyond which every number has less than a sixteenth of a rounding left.
  int degree_of(const Step& step) const {
    int degree = 0;
    for (const Outputs& body : outputs_)
      for (const int node : body.nodes) {
        const double size = step.tails->size(node);
        int k = step.tails->order();
        while (k > degree && step.tails->from(node)[k] <= 0x1p-57 * size) --k;
        degree = std::max(degree, k);
      }
    return degree;
  }

  // Rounding: coefficient k to double, and Horner's 2 k operations with the time that is itself rounded,
  // touch its term at most 3 k + 3 times.
  void keep(const Step& step, int node, int degree, double& radius) {
    const bool fixed = model_.graph[static_cast<std::size_t>(node)].kind == Kind::fixed;
    double rounding = 0;
    for (int k = 0; k <= degree; ++k) {
      const bool zero = fixed && k > 0;
      const arb_srcptr c = (*step.centre)[node] + (zero ? 0 : k);
      dense_.coefficients.push_back(zero ? 0 : arf_get_d(arb_midref(c), ARF_RND_NEAR));
      rounding += (3 * k + 3) * 0x1p-53 * step.tails->scaled(node, k);
    }
    if (degree < step.tails->order()) rounding += step.tails->from(node)[degree + 1];
    // The centre's coefficients are balls of a radius far below their rounding.
    const double spread = step.radius(node);
    proven_ = std::max(proven_, spread);
    radius = std::max(radius, above(rounding * (1 + 1e-9) + spread));
  }

  void amplify(const Step& step, double t) {
    const auto off = [&](int node) {
      const Eigen::VectorXd slope = step.sensitivity(node, t);
      double sum = 0;
      for (Eigen::Index j = 0; j < slope.size(); ++j)
        sum += std::abs(slope[j]) * length_[static_cast<std::size_t>(j)] * 0x1p-52;
      return sum;
    };
    const auto norm = [&](const auto& nodes) {
      double sum = 0;
      for (const int node : nodes)
        if (model_.graph[static_cast<std::size_t>(node)].kind != Kind::fixed) sum += std::pow(off(node), 2);
      return std::sqrt(sum);
    };
    for (const BodyNodes& body : model_.bodies) {
      worst_.position = std::max(worst_.position, norm(body.position));
      worst_.velocity = std::max(worst_.velocity, norm(body.velocity));
      worst_.orientation = std::max(worst_.orientation, 2 * norm(body.orientation));
      worst_.angular_velocity = std::max(worst_.angular_velocity, norm(body.angular_velocity));
    }
    dense_.ulp.push_back({t, worst_});
  }

  const Model& model_;
  Dense& dense_;
  std::vector<Outputs> outputs_;
  std::vector<double> length_;
  Radii radii_;
  core::StateError worst_;
  double proven_ = 0;
};

}  // namespace

core::State Dense::at(double t) const {
  const auto after = std::upper_bound(starts.begin(), starts.end(), t);
  const auto step = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - starts.begin() - 1));
  const double since = t - starts[step];
  const std::size_t count = (first[step + 1] - first[step]) / (bodies * numbers);
  const double* c = &coefficients[first[step]];
  core::State state(bodies);
  for (core::BodyState& body : state) {
    std::array<double, numbers> x{};
    for (double& value : x) {
      for (std::size_t k = count; k-- > 0;) value = value * since + c[k];
      c += count;
    }
    body.position = {x[0], x[1], x[2]};
    body.orientation = core::Quaternion(x[3], x[4], x[5], x[6]).normalized();
    body.velocity = {x[7], x[8], x[9]};
    body.angular_velocity = {x[10], x[11], x[12]};
  }
  return state;
}

namespace {

// Each node of the graph, for its value and for its derivative by each state, costs a convolution of all
// orders.
double work_of(const Model& model, int order, slong bits) {
  return static_cast<double>(model.graph.size()) * (1.0 + static_cast<double>(model.graph.states().size())) *
         order * order * (static_cast<double>(bits) / 128);
}

}  // namespace

void require_work(double work, double most, double time) {
  if (work > most)
    throw TooMuchWork(
        fmt::format("certified: more work than a scenario may ask for, by {:.6g} s of its time; take fewer "
                    "bodies or a shorter time, or store the truth once with `cylon truth --out`",
                    time));
}

Dense make_dense(const core::Scene& scene, double horizon, double most_work) {
  double work = 0;
  Attempts attempts(goal);
  std::string stuck;
  double radius = 0, best_radius = std::numeric_limits<double>::infinity();
  Dense best;
  do {
    radius = std::numeric_limits<double>::infinity();
    Dense dense;
    dense.bodies = scene.bodies.size();
    dense.horizon = horizon;
    const Model model = make_model(scene, horizon, attempts.effort().bits);
    const slong bits = attempts.effort().bits;
    require_work(work + work_of(model, order_of(attempts.effort()), bits), most_work, 0);
    Recorder recorder(model, dense);
    try {
      follow(model, horizon, attempts.effort(), [&](const Step& step) {
        work += work_of(model, step.tails->order(), bits);
        require_work(work, most_work, step.start);
        return recorder(step);
      });
      dense.error = recorder.error();
      radius = recorder.radius();
      if (radius < best_radius) best_radius = radius, best = std::move(dense);
    } catch (const Stuck& error) {
      stuck = error.what();
    }
  } while (attempts.next(radius));
  if (!std::isfinite(best_radius)) throw core::OutOfDomain("certified: " + stuck);
  best.work = work;
  return best;
}

std::string key_of(const core::Scene& scene, double horizon) {
  constexpr slong bits = 128;
  const Model model = make_model(scene, horizon, bits);
  core::ContentHash print;
  const auto add = [&](const Ball& x) {
    const std::unique_ptr<char, decltype(&flint_free)> text(arb_dump_str(x.get()), &flint_free);
    print.add(text.get()), print.add(";");
  };
  print.add(fmt::format("dense 1;{};{:a};", goal.radius, horizon));
  for (std::size_t i = 0; i < model.graph.size(); ++i) {
    const Node& node = model.graph[i];
    print.add(fmt::format("{} {} {};", static_cast<int>(node.op), node.a, node.b));
    if (node.op == Op::constant || node.op == Op::cosine) add(model.graph.value(static_cast<int>(i)));
  }
  for (const int rate : model.graph.rates) print.add(fmt::format("{};", rate));
  for (const Ball& x : model.initial) add(x);
  for (const BodyNodes& body : model.bodies)
    for (const int node : Outputs(body).nodes) print.add(fmt::format("{};", node));
  return print.hex();
}

}  // namespace cylon::certified
