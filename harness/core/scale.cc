#include "harness/core/scale.h"

#include "harness/core/event_rows.h"
#include "harness/core/force_law.h"
#include "harness/core/golden.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/joint_force.h"
#include "harness/core/observable_rows.h"
#include "harness/core/size.h"
#include "harness/core/worst.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::core {
namespace {

constexpr int samples = 256;
constexpr double steady = 1e-3;  // of the next best scale: a range below it is none

/// The times at which a truth is looked at, where it knows any: 0, `until`, and between them
/// until frac(i (sqrt 5 - 1)/2), which no period divides.
std::vector<double> times_of_range(double until) {
  std::vector<double> times = {0, until};
  for (int i = 1; i < samples; ++i) times.push_back(until * golden_part(i));
  return times;
}

std::vector<double> even_times(double until) {
  std::vector<double> times;
  for (int i = 0; i <= samples; ++i) times.push_back(until * i / samples);
  return times;
}

using Trajectory = std::vector<RequiredMotion::Instant>;

// At the times given, or at those of recorded data.
Trajectory sampled(const Truth& truth, double until, const std::vector<double>& times) {
  Trajectory path;
  for (const double t : truth.times)
    if (t <= until * (1 + 1e-9)) path.push_back({t, truth.state(t)});
  if (truth.times.empty())
    for (const double t : times) path.push_back({t, truth.state(t)});
  return path;
}

// ---- The frame ----------------------------------------------------------------------------------

Vector3 velocity_of_centre(const Scene& scene) {
  Vector3 momentum = Vector3::Zero();
  double mass = 0;
  for (const Body& body : scene.bodies) momentum += body.mass * body.initial.velocity, mass += body.mass;
  return mass > 0 ? Vector3(momentum / mass) : Vector3(Vector3::Zero());
}

// The start and the truth, as far as the claim goes, seen from what is fixed.
Trajectory motion_of(const Claim& claim, const Scene& scene, double duration) {
  const double until = std::min(claim.until, duration);
  Trajectory path = {{0, initial_state(scene)}};
  if (claim.truth && claim.truth->state) {
    const double end = std::min(until, claim.truth->horizon);
    const Trajectory more = sampled(*claim.truth, end, times_of_range(end));
    path.insert(path.end(), more.begin(), more.end());
  } else if (claim.motion) {
    const Trajectory& more = claim.motion->path(until);
    path.insert(path.end(), more.begin(), more.end());
  }
  if (anything_fixed(scene)) return path;
  const Vector3 drift = velocity_of_centre(scene);
  for (auto& [t, state] : path)
    for (BodyState& s : state) s.position -= t * drift, s.velocity -= drift;
  return path;
}

// ---- Parts of what is claimed -------------------------------------------------------------------

/// One number or vector that changes along the path.
struct Term {
  std::vector<Vector3> values;
  bool has_a_zero = false;  ///< Its size means something too.
};

double range(const Term& term) {
  double most = 0;
  for (std::size_t i = 0; i < term.values.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) most = worst((term.values[i] - term.values[j]).norm(), most);
  return most;
}

double size_of(const Term& term) {
  double most = 0;
  for (const Vector3& v : term.values) most = worst(v.norm(), most);
  return term.has_a_zero ? most : 0;
}

template <class Value>
Term term(const Trajectory& path, bool has_a_zero, Value value) {
  Term result{{}, has_a_zero};
  for (const auto& [t, state] : path) result.values.push_back(value(state));
  return result;
}

template <class Use>
void each_body(const Observable& q, const Scene& scene, Use use) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if ((!q.body || static_cast<std::size_t>(*q.body) == i) && !scene.bodies[i].locked)
      use(scene.bodies[i], i);
}

// Where a component is conserved, it is compared with the motion in all of them.
template <Vector3 BodyState::*what>
std::vector<Term> of_each_body(const Claim& claim, const Scene& scene, const Trajectory& path,
                               bool has_a_zero) {
  std::vector<Term> terms;
  each_body(claim.observable, scene, [&](const Body&, std::size_t i) {
    terms.push_back(term(path, has_a_zero, [&](const State& s) {
      return claim.truth ? only(s[i].*what, claim.observable.component) : Vector3(s[i].*what);
    }));
  });
  return terms;
}

Vector3 scalar(double x) { return {x, 0, 0}; }

// A body's momenta, whole: what one of its components is exchanged for may be another.
std::vector<Term> momenta(const Claim& claim, const Scene& scene, const Trajectory& path) {
  std::vector<Term> terms;
  each_body(claim.observable, scene, [&](const Body& body, std::size_t i) {
    terms.push_back(term(path, true, [&](const State& s) { return Vector3(body.mass * s[i].velocity); }));
  });
  return terms;
}

// Of each body its spin, and the moment of its momentum.
std::vector<Term> angular_momenta(const Claim& claim, const Scene& scene, const Trajectory& path) {
  std::vector<Term> terms;
  const Vector3& about = claim.observable.about;
  each_body(claim.observable, scene, [&](const Body& body, std::size_t i) {
    terms.push_back(term(path, true, [&](const State& s) {
      return Vector3(world_inertia(body, s[i].orientation) * s[i].angular_velocity);
    }));
    terms.push_back(term(path, true, [&](const State& s) {
      return Vector3((s[i].position - about).cross(body.mass * s[i].velocity));
    }));
  });
  return terms;
}

Term kinetic(const Claim& claim, const Scene& scene, const Trajectory& path) {
  Observable q;
  q.quantity = Quantity::kinetic_energy;
  q.body = claim.observable.body;
  return term(path, true, [&, values = Values()](const State& s) mutable {
    evaluate(q, scene, s, values);
    return scalar(values.front().x());
  });
}

// Gravity's potential has no zero; those of the others have.
std::vector<Term> energies(const Claim& claim, const Scene& scene, const Trajectory& path) {
  std::vector<Term> terms = {kinetic(claim, scene, path)};
  for (const Force& force : scene.forces)
    terms.push_back(term(path, !std::holds_alternative<UniformGravity>(force),
                         [&](const State& s) { return scalar(potential(force, scene, s)); }));
  if (states_own_gravity(scene))
    terms.push_back(
        term(path, false, [&](const State& s) { return scalar(own_gravity_potential(scene, s)); }));
  for (const Joint& joint : scene.joints)
    if (acted_on(joint))
      terms.push_back(term(path, true, [&, held = held_joint(scene, joint)](const State& s) {
        return scalar(joint_potential(held, s));
      }));
  return terms;
}

std::vector<Term> of_each_joint(const Claim& claim, const Scene& scene, const Trajectory& path) {
  Values values;
  evaluate(claim.observable, scene, path.front().state, values);
  std::vector<Term> terms;
  for (std::size_t j = 0; j < values.size(); ++j)
    terms.push_back(
        term(path, claim.observable.quantity != Quantity::joint_displacement, [&, j](const State& s) {
          Values now;
          evaluate(claim.observable, scene, s, now);
          return scalar(now[j].x());
        }));
  return terms;
}

std::vector<Term> terms_of(const Claim& claim, const Scene& scene, const Trajectory& path) {
  switch (claim.observable.quantity) {
    case Quantity::position:
      return of_each_body<&BodyState::position>(claim, scene, path, false);
    case Quantity::velocity:
      return of_each_body<&BodyState::velocity>(claim, scene, path, true);
    case Quantity::angular_velocity:
      return of_each_body<&BodyState::angular_velocity>(claim, scene, path, true);
    case Quantity::linear_momentum:
      return momenta(claim, scene, path);
    case Quantity::angular_momentum:
      return angular_momenta(claim, scene, path);
    case Quantity::energy:
      return energies(claim, scene, path);
    case Quantity::kinetic_energy:
      return {kinetic(claim, scene, path)};
    case Quantity::orientation:
    case Quantity::axis:
    case Quantity::normal_gap:
    case Quantity::joint_gap:
    case Quantity::angular_joint_gap:
    case Quantity::joint_angle:
    case Quantity::energy_share:
    case Quantity::momentum_balance:
    case Quantity::angular_momentum_balance:
    case Quantity::joint_force:
    case Quantity::joint_torque:
    case Quantity::event:
      return {};
    case Quantity::joint_displacement:
    case Quantity::joint_displacement_rate:
    case Quantity::joint_angle_rate:
      return of_each_joint(claim, scene, path);
  }
  return {};
}

// ---- Where nothing moves ------------------------------------------------------------------------

// Without gravity: what takes a body over its own size, or around a radian, within the duration.
double at_rest(const Claim& claim, const Scene& scene, double duration, double g) {
  double d = 0, m = 0, smallest = std::numeric_limits<double>::infinity();
  each_body(claim.observable, scene, [&](const Body& body, std::size_t) {
    d = std::max(d, size(body)), m = std::max(m, body.mass);
    smallest = std::min(smallest, size(body));
  });
  if (!(d > 0)) return 1;  // locked bodies alone
  const double speed = g > 0 ? g * duration : d / duration;
  switch (claim.observable.quantity) {
    case Quantity::position:
    case Quantity::joint_displacement:
      return d;
    case Quantity::velocity:
    case Quantity::joint_displacement_rate:
      return speed;
    case Quantity::orientation:
    case Quantity::axis:
    case Quantity::angular_joint_gap:
    case Quantity::joint_angle:
      return 1;
    case Quantity::angular_velocity:
    case Quantity::joint_angle_rate:
      return 1 / duration;
    case Quantity::linear_momentum:
      return m * speed;
    case Quantity::angular_momentum:
      return m * speed * d;
    case Quantity::energy:
    case Quantity::kinetic_energy:
      return g > 0 ? m * g * d : m * speed * speed;
    case Quantity::normal_gap:
    case Quantity::joint_gap:
      return 2 * smallest;
    case Quantity::momentum_balance:
    case Quantity::joint_force:
      return m * speed / duration;
    case Quantity::angular_momentum_balance:
    case Quantity::joint_torque:
      return m * speed / duration * d;
    case Quantity::energy_share:
    case Quantity::event:
      return 1;
  }
  return 1;
}

double range_of_angles(const Claim& claim, const Scene& scene, const Trajectory& path) {
  std::vector<Values> values(path.size());
  double most = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    evaluate(claim.observable, scene, path[i].state, values[i]);
    for (std::size_t j = 0; j < i; ++j) most = worst(distance(claim.observable, values[i], values[j]), most);
  }
  return most;
}

// ---- Events -------------------------------------------------------------------------------------

double largest_of_events(const Claim& claim) {
  double most = 0;
  if (claim.truth)
    for (const Event& event : claim.truth->events)
      if (claimed(claim.observable, event))
        most =
            worst(std::abs(quantity(claim.truth->events, event, claim.observable.event_quantity).value_or(0)),
                  most);
  return most;
}

double scale_of_event(const Claim& claim, const Scene& scene, double duration) {
  const Observable& q = claim.observable;
  const double value = largest_of_events(claim);
  if (q.event != EventKind::turn || q.event_quantity != EventQuantity::height) return value > 0 ? value : 1;
  double most = 0;
  const Trajectory path = motion_of(claim, scene, duration);
  each_body(q, scene, [&](const Body& body, std::size_t i) {
    const Vector3 up = event_up(scene, body);
    most =
        worst(range(term(path, false, [&](const State& s) { return scalar(up.dot(s[i].position)); })), most);
  });
  return most > 0 ? most : at_rest({.observable = {.quantity = Quantity::position}}, scene, duration, 0);
}

}  // namespace

RequiredMotion::RequiredMotion(Truth truth, double until) : truth_(std::move(truth)), until_(until) {}

const Trajectory& RequiredMotion::path(double until) const {
  const std::scoped_lock lock(mutex_);
  const double end = std::min(until, until_);
  auto known = paths_.find(end);
  if (known == paths_.end())  // kept only when it is whole
    known = paths_.emplace(end, sampled(truth_, end, times_of_range(end))).first;
  return known->second;
}

bool anything_fixed(const Scene& scene) {
  const auto holds = [](const Broken& broken) { return broken.boost != nullptr; };
  return scene.frame || !scene.planes.empty() || std::ranges::any_of(broken_by(scene), holds) ||
         std::ranges::any_of(scene.bodies, &Body::locked) ||
         std::ranges::any_of(scene.joints, [](const Joint& joint) { return joint.to == world; });
}

double scale(const Claim& claim, const Scene& scene, double duration) {
  require_truth(claim);
  if (claim.at_least) return *claim.at_least;
  const Quantity quantity = claim.observable.quantity;
  if (quantity == Quantity::event) return scale_of_event(claim, scene, duration);
  const double rest = at_rest(claim, scene, duration, strongest_gravity(scene));
  if (of_joint_forces(quantity)) {
    if (!claim.truth) return rest;
    const double most =
        largest_joint_force(claim.observable, scene, *claim.truth, std::min(claim.until, duration));
    return most > steady * rest ? most : rest;
  }
  if (quantity == Quantity::normal_gap || quantity == Quantity::joint_gap ||
      quantity == Quantity::angular_joint_gap || of_last_step(quantity) || of_chance(quantity))
    return rest;
  const Trajectory path = motion_of(claim, scene, duration);
  if (quantity == Quantity::orientation || quantity == Quantity::axis || quantity == Quantity::joint_angle) {
    const double turned = range_of_angles(claim, scene, path);
    return turned > steady ? turned : rest;
  }
  double moves = 0, sizes = 0;
  for (const Term& p : terms_of(claim, scene, path)) {
    moves = worst(range(p), moves);
    sizes = worst(size_of(p), sizes);
  }
  if (!(sizes > steady * at_rest(claim, scene, duration, 0))) sizes = rest;
  return moves <= steady * sizes ? sizes : moves;
}

double largest_value(const Claim& claim, const Scene& scene, double duration) {
  require_truth(claim);
  const Observable& q = claim.observable;
  if (q.quantity == Quantity::event) return largest_of_events(claim);
  const ObservableRow& row = observable_row(q.quantity);
  Values values;
  const auto size_of_state = [&](const State& state) {
    if (row.scale) return row.scale(scene, state);
    evaluate(q, scene, state, values);
    return row.magnitude(values);
  };
  if (!claim.truth) return size_of_state(initial_state(scene));
  double most = 0;
  const double until = std::min(claim.until, duration);
  for (const RequiredMotion::Instant& instant :
       sampled(*claim.truth, claim.truth->times.empty() ? until : std::numeric_limits<double>::infinity(),
               even_times(until)))
    most = worst(size_of_state(instant.state), most);
  return most;
}

}  // namespace cylon::core
