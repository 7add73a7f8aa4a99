#include "harness/core/observable.h"

#include "harness/core/event_signal.h"
#include "harness/core/near_pairs.h"
#include "harness/core/surfaces.h"
#include "harness/core/worst.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cylon::core {
namespace {

struct Row {
  Quantity quantity;
  std::string_view name, unit;
};
constexpr std::array rows = {
    Row{Quantity::position, "position", "m"},
    Row{Quantity::velocity, "velocity", "m/s"},
    Row{Quantity::orientation, "orientation", "rad"},
    Row{Quantity::axis, "axis", "rad"},
    Row{Quantity::angular_velocity, "angular_velocity", "rad/s"},
    Row{Quantity::linear_momentum, "linear_momentum", "kg m/s"},
    Row{Quantity::angular_momentum, "angular_momentum", "kg m^2/s"},
    Row{Quantity::energy, "energy", "J"},
    Row{Quantity::kinetic_energy, "kinetic_energy", "J"},
    Row{Quantity::normal_gap, "normal_gap", "m"},
    Row{Quantity::joint_gap, "joint_gap", "m"},
    Row{Quantity::event, "event", ""},
};
static_assert([] {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].quantity) != i) return false;
  return true;
}());

Eigen::Vector4d vector(const Vector3& v, Component component) {
  switch (component) {
    case Component::all:
      return {v.x(), v.y(), v.z(), 0};
    case Component::x:
      return {v.x(), 0, 0, 0};
    case Component::y:
      return {v.y(), 0, 0, 0};
    case Component::z:
      return {v.z(), 0, 0, 0};
    case Component::horizontal:
      return {v.x(), v.z(), 0, 0};
  }
  return {};
}

Eigen::Vector4d scalar(double x) { return {x, 0, 0, 0}; }

// L_spin = R I0 R^T w.
Vector3 spin(const Body& body, const BodyState& s) {
  return s.orientation * (body.inertia * (s.orientation.conjugate() * s.angular_velocity));
}

// m v^2/2 + w.I0 w/2, the second in body axes.
double kinetic(const Body& body, const BodyState& s) {
  const Vector3 w = s.orientation.conjugate() * s.angular_velocity;
  return 0.5 * body.mass * s.velocity.squaredNorm() + 0.5 * w.dot(body.inertia * w);
}

Vector3 anchor(const State& state, int body, const Vector3& local) {
  if (body == world) return local;
  const BodyState& s = state[static_cast<std::size_t>(body)];
  return s.position + s.orientation * local;
}

// Potential energies; forces that have none (drag, thrust, drive, water) contribute nothing: their
// work is not part of a conserved energy.
double potential(const UniformGravity& gravity, const Scene& scene, const State& state,
                 double (*size)(double)) {
  double total = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (!scene.bodies[i].locked)
      total += size(-scene.bodies[i].mass * gravity.acceleration.dot(state[i].position));
  return total;
}

double potential(const Spring& spring, const Scene&, const State& state, double (*size)(double)) {
  const Vector3 d = anchor(state, spring.to, spring.to_anchor) - anchor(state, spring.body, spring.anchor);
  const double stretch = d.norm() - spring.rest_length;
  return size(0.5 * spring.stiffness * stretch * stretch);
}

double potential(const Attraction& pull, const Scene& scene, const State& state, double (*size)(double)) {
  const auto a = static_cast<std::size_t>(pull.body), b = static_cast<std::size_t>(pull.to);
  const double distance = (state[b].position - state[a].position).norm();
  return size(-pull.strength * scene.bodies[a].mass * scene.bodies[b].mass / distance);
}

template <class Other>
double potential(const Other&, const Scene&, const State&, double (*)(double)) {
  return 0;
}

double kinetic_total(const Scene& scene, const State& state) {
  double total = 0;
  for (std::size_t i = 0; i < state.size(); ++i) total += kinetic(scene.bodies[i], state[i]);
  return total;
}

double potential_total(const Scene& scene, const State& state, double (*size)(double)) {
  double total = 0;
  for (const Force& force : scene.forces)
    total += std::visit([&](const auto& f) { return potential(f, scene, state, size); }, force);
  return total;
}

// Anchors of a joint in the frames of its two bodies, from the motion at t = 0.
double joint_gap(const Scene& scene, const Joint& joint, const State& state) {
  const auto local = [&](int body, const Vector3& point) -> Vector3 {
    if (body == world) return point;
    const BodyState& s = scene.bodies[static_cast<std::size_t>(body)].initial;
    return s.orientation.conjugate() * (point - s.position);
  };
  if (joint.type == JointType::distance) {
    const Vector3 from = anchor(state, joint.body, Vector3::Zero());
    const Vector3 to = joint.to == world ? joint.point : anchor(state, joint.to, Vector3::Zero());
    return (to - from).norm() - joint.length;
  }
  return (anchor(state, joint.to, local(joint.to, joint.point)) -
          anchor(state, joint.body, local(joint.body, joint.point)))
      .norm();
}

bool only_spheres_collide(const Scene& scene) {
  return std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) {
    return !collides(body) || std::holds_alternative<Sphere>(body.shape);
  });
}

// The worst difference of two lists of gaps, both in the order of their pairs; who is in one alone is apart
// in the other.
double overlap_distance(const Values& a, const Values& b) {
  const auto pair = [](const Eigen::Vector4d& v) { return std::array{v[1], v[3], v[2]}; };
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

bool concerns(const Observable& q, int body, int other) {
  return !q.body || *q.body == body || *q.body == other;
}

}  // namespace

std::string_view name(Quantity quantity) { return rows[static_cast<std::size_t>(quantity)].name; }

std::string_view unit(const Observable& q) {
  if (q.quantity != Quantity::event) return rows[static_cast<std::size_t>(q.quantity)].unit;
  return unit(q.event_quantity);
}

std::optional<Vector3> symmetry_axis(const Body& body) {
  const PrincipalAxes principal = principal_axes(body.inertia);
  const Vector3& m = principal.moments;
  const double tolerance = 1e-9 * m.maxCoeff();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (std::abs(m[j] - m[k]) <= tolerance && std::abs(m[i] - m[j]) > tolerance)
      return principal.rotation * Vector3::Unit(i);
  }
  return std::nullopt;
}

std::optional<std::string> undefined_in(const Observable& q, const Scene& scene) {
  switch (q.quantity) {
    case Quantity::axis:
      for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if ((!q.body || static_cast<std::size_t>(*q.body) == i) && !symmetry_axis(scene.bodies[i]))
          return "body '" + scene.bodies[i].name +
                 "' has no axis of symmetry (two equal principal moments and a third)";
      return std::nullopt;
    case Quantity::joint_gap:
      if (scene.joints.empty()) return "the scene has no joint";
      return std::nullopt;
    case Quantity::event:
      return event_undefined(q, scene);
    case Quantity::normal_gap: {
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
    default:
      return std::nullopt;
  }
}

void evaluate(const Observable& q, const Scene& scene, const State& state, Values& values) {
  values.clear();
  const std::size_t first = q.body ? static_cast<std::size_t>(*q.body) : 0;
  const std::size_t last = q.body ? first + 1 : state.size();
  const auto each = [&](auto value) {
    for (std::size_t i = first; i < last; ++i) values.push_back(value(scene.bodies[i], state[i]));
  };
  Vector3 sum = Vector3::Zero();
  double total = 0;
  switch (q.quantity) {
    case Quantity::position:
      return each([&](const Body&, const BodyState& s) { return vector(s.position, q.component); });
    case Quantity::velocity:
      return each([&](const Body&, const BodyState& s) { return vector(s.velocity, q.component); });
    case Quantity::angular_velocity:
      return each([&](const Body&, const BodyState& s) { return vector(s.angular_velocity, q.component); });
    case Quantity::orientation:
      return each([](const Body&, const BodyState& s) {
        return Eigen::Vector4d(s.orientation.w(), s.orientation.x(), s.orientation.y(), s.orientation.z());
      });
    case Quantity::axis:
      return each([](const Body& body, const BodyState& s) {
        return vector(s.orientation * symmetry_axis(body).value_or(Vector3::UnitY()), Component::all);
      });
    case Quantity::linear_momentum:
      for (std::size_t i = first; i < last; ++i) sum += scene.bodies[i].mass * state[i].velocity;
      return values.push_back(vector(sum, q.component));
    case Quantity::angular_momentum:
      for (std::size_t i = first; i < last; ++i)
        sum += (state[i].position - q.about).cross(scene.bodies[i].mass * state[i].velocity) +
               spin(scene.bodies[i], state[i]);
      return values.push_back(vector(sum, q.component));
    case Quantity::kinetic_energy:
      for (std::size_t i = first; i < last; ++i) total += kinetic(scene.bodies[i], state[i]);
      return values.push_back(scalar(total));
    case Quantity::energy:
      return values.push_back(
          scalar(kinetic_total(scene, state) + potential_total(scene, state, [](double x) { return x; })));
    case Quantity::normal_gap:
      for (const Pair& pair : q.body ? touching_pairs(scene, *q.body) : near_pairs(scene, state)) {
        const double g = gap(scene, pair, state);
        if (!(g >= 0)) values.emplace_back(g, pair.body, pair.other, pair.plane);  // NaN stays
      }
      return;
    case Quantity::joint_gap:
      for (const Joint& joint : scene.joints)
        if (concerns(q, joint.body, joint.to)) values.push_back(scalar(joint_gap(scene, joint, state)));
      return;
    case Quantity::event:
      return;
  }
}

double distance(const Observable& q, const Values& a, const Values& b) {
  if (q.quantity == Quantity::normal_gap) return overlap_distance(a, b);
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double d = 0;
    if (q.quantity == Quantity::orientation) {
      // 4 asin(|q - q'| / 2) after the sign fix.
      const double chord = std::min((a[i] - b[i]).norm(), (a[i] + b[i]).norm());
      d = std::isnan((a[i] - b[i]).norm()) ? std::nan("") : 4 * std::asin(std::min(1.0, chord / 2));
    } else if (q.quantity == Quantity::axis) {
      // 2 asin(|a - b| / 2): exact for small angles, where acos of a product is not.
      const double chord = (a[i] - b[i]).norm();
      d = std::isnan(chord) ? chord : 2 * std::asin(std::min(1.0, chord / 2));
    } else {
      d = (a[i] - b[i]).norm();
    }
    result = worst(d, result);
  }
  return result;
}

double magnitude(const Observable& q, const Values& values) {
  if (q.quantity == Quantity::orientation || q.quantity == Quantity::axis) return 0;
  const bool is_gap = q.quantity == Quantity::normal_gap;  // the other numbers say whose
  double result = 0;
  for (const auto& v : values) result = worst(is_gap ? std::abs(v.x()) : v.norm(), result);
  return result;
}

double energy_scale(const Scene& scene, const State& state) {
  return kinetic_total(scene, state) + potential_total(scene, state, [](double x) { return std::abs(x); });
}

}  // namespace cylon::core
