#include "harness/core/claim.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cylon::core {
namespace {

constexpr std::array<std::string_view, 5> reductions = {"max", "end", "mean_square", "order", "rate"};

// First-order bound on the error that a state's error makes in a quantity, by the triangle inequality.
double propagate(const Observable& q, const Scene& scene, const State& state, const StateError& e) {
  const auto sum = [&](auto term) {
    double total = 0;
    for (std::size_t i = 0; i < state.size(); ++i)
      if (!q.body || static_cast<std::size_t>(*q.body) == i) total += term(scene.bodies[i], state[i]);
    return total;
  };
  // |d(I w)| <= I |dw| + 2 I |w| dtheta, with I the largest principal moment.
  const auto largest = [](const Body& body) { return principal_axes(body.inertia).moments.maxCoeff(); };
  const auto spin = [&](const Body& body, const BodyState& s) {
    return largest(body) * (e.angular_velocity + 2 * s.angular_velocity.norm() * e.orientation);
  };
  const auto kinetic = [&](const Body& body, const BodyState& s) {
    return body.mass * s.velocity.norm() * e.velocity +
           largest(body) * s.angular_velocity.norm() *
               (e.angular_velocity + s.angular_velocity.norm() * e.orientation);
  };
  switch (q.quantity) {
    case Quantity::position:
    case Quantity::normal_gap:
      return e.position;
    case Quantity::velocity:
      return e.velocity;
    case Quantity::orientation:
    case Quantity::axis:
      return e.orientation;
    case Quantity::angular_velocity:
      return e.angular_velocity;
    case Quantity::linear_momentum:
      return sum([&](const Body& body, const BodyState&) { return body.mass * e.velocity; });
    case Quantity::angular_momentum:
      return sum([&](const Body& body, const BodyState& s) {
        return body.mass * ((s.position - q.about).norm() * e.velocity + s.velocity.norm() * e.position) +
               spin(body, s);
      });
    case Quantity::kinetic_energy:
      return sum(kinetic);
    case Quantity::energy: {
      double total = sum(kinetic);
      for (const Force& force : scene.forces) {
        if (const auto* gravity = std::get_if<UniformGravity>(&force))
          total += sum([&](const Body& body, const BodyState&) {
            return body.mass * gravity->acceleration.norm() * e.position;
          });
        if (const auto* spring = std::get_if<Spring>(&force)) {
          const BodyState& s = state[static_cast<std::size_t>(spring->body)];
          const double reach =
              s.position.norm() + spring->anchor.norm() + spring->to_anchor.norm() + spring->rest_length;
          total += spring->stiffness * reach * 2 * (e.position + spring->anchor.norm() * e.orientation);
        }
      }
      return total;
    }
    case Quantity::joint_gap: {
      double arm = 0;
      for (const Joint& joint : scene.joints)
        arm = std::max(
            arm, (joint.point - scene.bodies[static_cast<std::size_t>(joint.body)].initial.position).norm());
      return 2 * (e.position + arm * e.orientation);
    }
    case Quantity::event:
      break;
  }
  return 0;
}

// Of an event's number, first order: a turning point's height and distance do not feel the error of its time.
double event_error(const Observable& q, const Truth& truth) {
  const StateError& e = truth.error;
  switch (q.event_quantity) {
    case EventQuantity::time:
      return e.time;
    case EventQuantity::height:
      return e.position;
    case EventQuantity::speed:
      return e.velocity;
    case EventQuantity::distance:
      return q.to ? 2 * e.position : e.position;
    case EventQuantity::angle:
      return e.orientation;
    case EventQuantity::period:
      return 4 * e.time / (q.index - 1);
    case EventQuantity::rate: {  // (azimuth - azimuth_1)/(t - t_1); the axis' lever about its pole is
                                 // sin(angle)
      double bound = 0, since = 0, lever = 1;
      for (const Event& event : truth.events) {
        if (event.kind != q.event) continue;
        lever = std::min(lever, std::sin(event.angle));
        if (event.index == 1 && q.event == EventKind::nutation) since = event.time;
        const auto rate = quantity(truth.events, event, q.event_quantity);
        if (event.index == q.index && rate)
          bound = std::max(bound,
                           (2 * e.orientation / lever + 2 * std::abs(*rate) * e.time) / (event.time - since));
      }
      return bound;
    }
    case EventQuantity::order:
      break;
  }
  return 0;
}

}  // namespace

std::string_view name(Reduction reduction) { return reductions[static_cast<std::size_t>(reduction)]; }

std::string unit(const Claim& claim) {
  const std::string base(unit(claim.observable));
  switch (claim.reduction) {
    case Reduction::mean_square:
      return base.find(' ') == std::string::npos ? base + "^2" : "(" + base + ")^2";
    case Reduction::rate:
      return base + "/s";
    case Reduction::order:
      return "";
    default:
      return base;
  }
}

double truth_error(const Observable& q, const Scene& scene, const Truth& truth, double until) {
  if (q.quantity == Quantity::event) return event_error(q, truth);
  double bound = 0;
  if (!truth.times.empty()) {
    for (const double t : truth.times)
      bound = std::max(bound, propagate(q, scene, truth.state(t), truth.error));
    return bound;
  }
  constexpr int samples = 64;
  for (int i = 0; i <= samples; ++i)
    bound = std::max(
        bound, propagate(q, scene, truth.state(std::min(until, truth.horizon) * i / samples), truth.error));
  return bound;
}

}  // namespace cylon::core
