#include "harness/core/observable_rows.h"

#include "harness/core/equipartition.h"
#include "harness/core/event_signal.h"
#include "harness/core/force_balance.h"
#include "harness/core/force_law.h"
#include "harness/core/held_joint.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/joint_force.h"
#include "harness/core/joint_observables.h"
#include "harness/core/loads.h"
#include "harness/core/near_pairs.h"
#include "harness/core/solid.h"
#include "harness/core/surfaces.h"
#include "harness/core/worst.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cylon::core {
namespace {

using Entry = Eigen::Vector4d;

Entry vector(const Vector3& v, Component component) {
  Entry entry = Entry::Zero();
  Eigen::Index next = 0;
  for (const int axis : axes(component)) entry[next++] = v[axis];
  return entry;
}

Entry scalar(double x) { return {x, 0, 0, 0}; }

// ---- Bodies that an observable concerns ---------------------------------------------------------

// Calls use(body, state) for the observable's body, or for all.
template <class Use>
void each_body(const Observable& q, const Scene& scene, const State& state, Use use) {
  const std::size_t first = q.body ? static_cast<std::size_t>(*q.body) : 0;
  const std::size_t last = q.body ? first + 1 : state.size();
  for (std::size_t i = first; i < last; ++i) use(scene.bodies[i], state[i]);
}

template <class Term>
double sum(const Observable& q, const Scene& scene, const State& state, Term term) {
  double total = 0;
  each_body(q, scene, state, [&](const Body& body, const BodyState& s) { total += term(body, s); });
  return total;
}

bool concerns(const Observable& q, int body, int other) {
  return !q.body || *q.body == body || *q.body == other;
}

// ---- Distances and magnitudes -------------------------------------------------------------------

double norm(const Entry& v) { return v.norm(); }

double norm_of_difference(const Entry& a, const Entry& b) { return (a - b).norm(); }

// Of two quaternions: 4 asin(|q - q'| / 2) after the sign fix.
double rotation_angle(const Entry& a, const Entry& b) {
  const double chord = std::min((a - b).norm(), (a + b).norm());
  return std::isnan((a - b).norm()) ? std::nan("") : 4 * std::asin(std::min(1.0, chord / 2));
}

// Of two unit vectors: 2 asin(|a - b| / 2), exact for small angles, where acos of a product is not.
double axis_angle(const Entry& a, const Entry& b) {
  const double chord = (a - b).norm();
  return std::isnan(chord) ? chord : 2 * std::asin(std::min(1.0, chord / 2));
}

// Of two angles about one axis, up to whole turns.
double turn_between_angles(const Entry& a, const Entry& b) {
  return std::abs(std::remainder(a.x() - b.x(), 2 * std::numbers::pi));
}

template <double (*apart)(const Entry&, const Entry&)>
double worst_of(const Values& a, const Values& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result = worst(apart(a[i], b[i]), result);
  return result;
}

template <double (*size)(const Entry&)>
double largest_of(const Values& values) {
  double result = 0;
  for (const Entry& v : values) result = worst(size(v), result);
  return result;
}

double no_magnitude(const Values&) { return 0; }  // angles

// The worst difference of two lists of gaps, both in the order of their pairs; who is in one alone is apart
// in the other.
double overlap_distance(const Values& a, const Values& b) {
  const auto pair = [](const Entry& v) { return std::array{v[1], v[3], v[2]}; };
  double result = 0;
  auto x = a.begin(), y = b.begin();
  while (x != a.end() || y != b.end()) {
    const bool only_x = y == b.end() || (x != a.end() && pair(*x) < pair(*y));
    const bool only_y = x == a.end() || (y != b.end() && pair(*y) < pair(*x));
    result = worst(std::abs((only_y ? 0 : x->x()) - (only_x ? 0 : y->x())), result);
    if (!only_y) ++x;
    if (!only_x) ++y;
  }
  return result;
}

double depth(const Entry& overlap) { return std::abs(overlap.x()); }  // the other numbers say whose

// ---- Errors that are those of the state ---------------------------------------------------------

template <double StateError::*which>
double error_of_state(const Observable&, const Scene&, const State&, const StateError& e) {
  return e.*which;
}

std::optional<std::string> always_defined(const Observable&, const Scene&) { return std::nullopt; }

std::optional<std::string> energy_undefined(const Observable&, const Scene& scene) {
  if (has_plugin_force(scene)) return "a plug-in's force acts, whose potential energy is not known";
  return std::nullopt;
}

// ---- Motion of each body ------------------------------------------------------------------------

template <Vector3 BodyState::*what>
void vector_of_each(const Observable& q, const Scene& scene, const State& state, Values& values) {
  each_body(q, scene, state,
            [&](const Body&, const BodyState& s) { values.push_back(vector(s.*what, q.component)); });
}

void orientation_of_each(const Observable& q, const Scene& scene, const State& state, Values& values) {
  each_body(q, scene, state, [&](const Body&, const BodyState& s) {
    values.emplace_back(s.orientation.w(), s.orientation.x(), s.orientation.y(), s.orientation.z());
  });
}

void axis_of_each(const Observable& q, const Scene& scene, const State& state, Values& values) {
  each_body(q, scene, state, [&](const Body& body, const BodyState& s) {
    values.push_back(vector(s.orientation * symmetry_axis(body).value_or(Vector3::UnitY()), Component::all));
  });
}

std::optional<std::string> axis_undefined(const Observable& q, const Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if ((!q.body || static_cast<std::size_t>(*q.body) == i) && !symmetry_axis(scene.bodies[i]))
      return "body '" + scene.bodies[i].name +
             "' has no axis of symmetry (two equal principal moments and a third)";
  return std::nullopt;
}

// ---- Momenta ------------------------------------------------------------------------------------

// L_spin = R I0 R^T w.
Vector3 spin(const Body& body, const BodyState& s) {
  return s.orientation * (body.inertia * (s.orientation.conjugate() * s.angular_velocity));
}

// |d(I w)| <= I |dw| + 2 I |w| dtheta, with I the largest principal moment.
double spin_error(const Body& body, const BodyState& s, const StateError& e) {
  return largest_moment(body) * (e.angular_velocity + 2 * s.angular_velocity.norm() * e.orientation);
}

// p = sum m v
void linear_momentum(const Observable& q, const Scene& scene, const State& state, Values& values) {
  Vector3 total = Vector3::Zero();
  each_body(q, scene, state, [&](const Body& body, const BodyState& s) { total += body.mass * s.velocity; });
  values.push_back(vector(total, q.component));
}

// |dp| <= sum m |dv|
double linear_momentum_error(const Observable& q, const Scene& scene, const State& state,
                             const StateError& e) {
  return sum(q, scene, state, [&](const Body& body, const BodyState&) { return body.mass * e.velocity; });
}

// L = sum (x - about) x m v + R I0 R^T w
void angular_momentum(const Observable& q, const Scene& scene, const State& state, Values& values) {
  Vector3 total = Vector3::Zero();
  each_body(q, scene, state, [&](const Body& body, const BodyState& s) {
    total += (s.position - q.about).cross(body.mass * s.velocity) + spin(body, s);
  });
  values.push_back(vector(total, q.component));
}

// |dL| <= sum m (|x - about| |dv| + |v| |dx|) + |d(I w)|
double angular_momentum_error(const Observable& q, const Scene& scene, const State& state,
                              const StateError& e) {
  return sum(q, scene, state, [&](const Body& body, const BodyState& s) {
    return body.mass * ((s.position - q.about).norm() * e.velocity + s.velocity.norm() * e.position) +
           spin_error(body, s, e);
  });
}

// ---- Energies -----------------------------------------------------------------------------------

// m v^2/2 + w.I0 w/2, the second in body axes.
double kinetic(const Body& body, const BodyState& s) {
  const Vector3 w = s.orientation.conjugate() * s.angular_velocity;
  return 0.5 * body.mass * s.velocity.squaredNorm() + 0.5 * w.dot(body.inertia * w);
}

// Calls f(joint, as it is held) for each joint that has a rotor.
template <class F>
void each_rotor(const Scene& scene, F f) {
  for (const Joint& joint : scene.joints) {
    bool turns_one = false;
    for_each_coordinate(joint, [&](const JointCoordinate& c) { turns_one = turns_one || has_rotor(c); });
    if (turns_one) f(held_joint(scene, joint));
  }
}

double kinetic_total(const Scene& scene, const State& state) {
  double total = 0;
  for (std::size_t i = 0; i < state.size(); ++i) total += kinetic(scene.bodies[i], state[i]);
  each_rotor(scene, [&](const HeldJoint& joint) { total += rotor_energy(joint, state); });
  return total;
}

void kinetic_energy(const Observable& q, const Scene& scene, const State& state, Values& values) {
  values.push_back(scalar(q.body ? sum(q, scene, state, kinetic) : kinetic_total(scene, state)));
}

// |dT| <= sum m |v| |dv| + I |w| (|dw| + |w| dtheta), with I the largest principal moment, and the rotors of all joints.
double kinetic_energy_error(const Observable& q, const Scene& scene, const State& state,
                            const StateError& e) {
  double error = sum(q, scene, state, [&](const Body& body, const BodyState& s) {
    return body.mass * s.velocity.norm() * e.velocity +
           largest_moment(body) * s.angular_velocity.norm() *
               (e.angular_velocity + s.angular_velocity.norm() * e.orientation);
  });
  if (!q.body)
    each_rotor(scene, [&](const HeldJoint& joint) { error += rotor_energy_error(joint, state, e); });
  return error;
}

void energy(const Observable&, const Scene& scene, const State& state, Values& values) {
  values.push_back(scalar(kinetic_total(scene, state) + potential_total(scene, state)));
}

// |dE| <= |dT| + sum |dU|
double energy_error(const Observable&, const Scene& scene, const State& state, const StateError& e) {
  return kinetic_energy_error({}, scene, state, e) + potential_error_total(scene, state, e);
}

void share_of_energy(const Observable& q, const Scene& scene, const State& state, Values& values) {
  values.push_back(scalar(energy_share(q, scene, state)));
}

// ---- Gaps ---------------------------------------------------------------------------------------

bool only_spheres_collide(const Scene& scene) {
  return std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) {
    return !collides(body) || std::holds_alternative<Sphere>(body.shape);
  });
}

std::optional<std::string> normal_gap_undefined(const Observable& q, const Scene& scene) {
  std::optional<std::string> why = "no two things in the scene may touch";
  const auto undefined = [&](const Pair& pair) { return (why = gap_undefined(scene, pair)).has_value(); };
  if (q.body) {
    for (const Pair& pair : touching_pairs(scene, *q.body))
      if (undefined(pair)) break;
  } else if (only_spheres_collide(scene)) {
    any_touching_pair(scene, [&](const Pair&) { return why.reset(), true; });
  } else {
    any_touching_pair(scene, undefined);
  }
  return why;
}

// By the balls around two bodies; false where a number is none.
bool surely_apart(const Scene& scene, const Pair& pair, const State& state) {
  if (pair.plane >= 0) return false;
  const auto a = static_cast<std::size_t>(pair.body), b = static_cast<std::size_t>(pair.other);
  const double reach = bounding_radius(scene.bodies[a].shape) + bounding_radius(scene.bodies[b].shape);
  return (state[a].position - state[b].position).norm() > reach;
}

void normal_gap(const Observable& q, const Scene& scene, const State& state, Values& values) {
  for (const Pair& pair : q.body ? touching_pairs(scene, *q.body) : near_pairs(scene, state)) {
    if (surely_apart(scene, pair, state)) continue;
    const double g = gap(scene, pair, state);
    if (!(g >= 0)) values.emplace_back(g, pair.body, pair.other, pair.plane);  // NaN stays
  }
}

std::optional<std::string> joint_gap_undefined(const Observable&, const Scene& scene) {
  if (scene.joints.empty()) return "the scene has no joint";
  return std::nullopt;
}

void joint_gap(const Observable& q, const Scene& scene, const State& state, Values& values) {
  for (const Joint& joint : scene.joints)
    if (concerns(q, joint.body, joint.to)) values.push_back(scalar(open_by(scene, joint, state)));
}

// |dg| <= 2 (|dx| + arm dtheta), with the longest arm of all joints.
double joint_gap_error(const Observable&, const Scene& scene, const State&, const StateError& e) {
  double arm = 0;
  for (const Joint& joint : scene.joints)
    arm = std::max(
        arm, (joint.point - scene.bodies[static_cast<std::size_t>(joint.body)].initial.position).norm());
  return 2 * (e.position + arm * e.orientation);
}

std::optional<std::string> angular_joint_gap_undefined(const Observable& q, const Scene& scene) {
  for (const Joint& joint : scene.joints)
    if (concerns(q, joint.body, joint.to) && !kind_of(joint.type).turns_freely()) return std::nullopt;
  return "no joint there keeps bodies from turning against each other";
}

void angular_joint_gap(const Observable& q, const Scene& scene, const State& state, Values& values) {
  for (const Joint& joint : scene.joints)
    if (concerns(q, joint.body, joint.to)) values.push_back(scalar(turned_by(scene, joint, state)));
}

// Each of the two bodies may be turned.
double angular_joint_gap_error(const Observable&, const Scene&, const State&, const StateError& e) {
  return 2 * e.orientation;
}

// ---- Not of one state: event_rows.h, force_balance.h, joint_force.h ---------------------------

void no_values(const Observable&, const Scene&, const State&, Values&) {}

double no_error(const Observable&, const Scene&, const State&, const StateError&) { return 0; }

// ---- The table ----------------------------------------------------------------------------------

constexpr auto norms = worst_of<norm_of_difference>;
constexpr auto largest = largest_of<norm>;

constexpr std::array rows = {
    ObservableRow{Quantity::position, "position", "m", always_defined, vector_of_each<&BodyState::position>,
                  norms, largest, nullptr, error_of_state<&StateError::position>},
    ObservableRow{Quantity::velocity, "velocity", "m/s", always_defined, vector_of_each<&BodyState::velocity>,
                  norms, largest, nullptr, error_of_state<&StateError::velocity>},
    ObservableRow{Quantity::orientation, "orientation", "rad", always_defined, orientation_of_each,
                  worst_of<rotation_angle>, no_magnitude, nullptr, error_of_state<&StateError::orientation>},
    ObservableRow{Quantity::axis, "axis", "rad", axis_undefined, axis_of_each, worst_of<axis_angle>,
                  no_magnitude, nullptr, error_of_state<&StateError::orientation>},
    ObservableRow{Quantity::angular_velocity, "angular_velocity", "rad/s", always_defined,
                  vector_of_each<&BodyState::angular_velocity>, norms, largest, nullptr,
                  error_of_state<&StateError::angular_velocity>},
    ObservableRow{Quantity::linear_momentum, "linear_momentum", "kg m/s", always_defined, linear_momentum,
                  norms, largest, nullptr, linear_momentum_error},
    ObservableRow{Quantity::angular_momentum, "angular_momentum", "kg m^2/s", always_defined,
                  angular_momentum, norms, largest, nullptr, angular_momentum_error},
    ObservableRow{Quantity::energy, "energy", "J", energy_undefined, energy, norms, largest, energy_scale,
                  energy_error},
    ObservableRow{Quantity::kinetic_energy, "kinetic_energy", "J", always_defined, kinetic_energy, norms,
                  largest, nullptr, kinetic_energy_error},
    ObservableRow{Quantity::energy_share, "energy_share", "", energy_share_undefined, share_of_energy, norms,
                  largest, nullptr, no_error},
    ObservableRow{Quantity::normal_gap, "normal_gap", "m", normal_gap_undefined, normal_gap, overlap_distance,
                  largest_of<depth>, nullptr, error_of_state<&StateError::position>},
    ObservableRow{Quantity::joint_gap, "joint_gap", "m", joint_gap_undefined, joint_gap, norms, largest,
                  nullptr, joint_gap_error},
    ObservableRow{Quantity::angular_joint_gap, "angular_joint_gap", "rad", angular_joint_gap_undefined,
                  angular_joint_gap, norms, no_magnitude, nullptr, angular_joint_gap_error},
    ObservableRow{Quantity::joint_displacement, "joint_displacement", "m", joint_value_undefined,
                  joint_values, norms, largest, nullptr, joint_value_error},
    ObservableRow{Quantity::joint_displacement_rate, "joint_displacement_rate", "m/s", joint_value_undefined,
                  joint_values, norms, largest, nullptr, joint_value_error},
    ObservableRow{Quantity::joint_angle, "joint_angle", "rad", joint_value_undefined, joint_values,
                  worst_of<turn_between_angles>, no_magnitude, nullptr, joint_value_error},
    ObservableRow{Quantity::joint_angle_rate, "joint_angle_rate", "rad/s", joint_value_undefined,
                  joint_values, norms, largest, nullptr, joint_value_error},
    ObservableRow{Quantity::momentum_balance, "momentum_balance", "N", balance_undefined, no_values, norms,
                  largest, nullptr, no_error},
    ObservableRow{Quantity::angular_momentum_balance, "angular_momentum_balance", "N m", balance_undefined,
                  no_values, norms, largest, nullptr, no_error},
    ObservableRow{Quantity::joint_force, "joint_force", "N", joint_force_undefined, no_values, norms, largest,
                  nullptr, no_error},
    ObservableRow{Quantity::joint_torque, "joint_torque", "N m", joint_force_undefined, no_values, norms,
                  largest, nullptr, no_error},
    ObservableRow{Quantity::event, "event", "", event_undefined, no_values, norms, largest, nullptr,
                  no_error},
};
static_assert([] {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].quantity) != i) return false;
  return rows.back().quantity == Quantity::event;
}());

}  // namespace

const ObservableRow& observable_row(Quantity quantity) { return rows[static_cast<std::size_t>(quantity)]; }

double energy_scale(const Scene& scene, const State& state) {
  return kinetic_total(scene, state) + potential_total(scene, state, [](double x) { return std::abs(x); });
}

}  // namespace cylon::core
