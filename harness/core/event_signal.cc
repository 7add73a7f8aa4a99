#include "harness/core/event_signal.h"

#include "harness/core/water_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cylon::core {
namespace {

Vector3 gravity(const Scene& scene) {
  Vector3 sum = Vector3::Zero();
  for (const Force& force : scene.forces)
    if (const auto* uniform = std::get_if<UniformGravity>(&force)) sum += uniform->acceleration;
  return sum;
}

Vector3 up(const Scene& scene) {
  const Vector3 g = gravity(scene);
  return g.isZero(0) ? Vector3::UnitY() : Vector3(-g.normalized());
}

// Zero where there is none.
Vector3 pole(const Scene& scene, const Body& body) {
  if (!gravity(scene).isZero(0)) return up(scene);
  const BodyState& s = body.initial;
  const Vector3 spin = world_inertia(body, s.orientation) * s.angular_velocity;
  return spin.isZero(0) ? spin : Vector3(spin.normalized());
}

std::optional<Vector3> intermediate_axis(const Body& body) {
  const PrincipalAxes principal = principal_axes(body.inertia);
  std::array<int, 3> by_size = {0, 1, 2};
  std::sort(by_size.begin(), by_size.end(),
            [&](int a, int b) { return principal.moments[a] < principal.moments[b]; });
  const auto moment = [&](int rank) { return principal.moments[by_size[static_cast<std::size_t>(rank)]]; };
  const double apart = 1e-9 * moment(2);
  if (moment(1) - moment(0) <= apart || moment(2) - moment(1) <= apart) return std::nullopt;
  return principal.rotation * Vector3::Unit(by_size[1]);
}

// The hinge that a body turns on.
const Joint* hinge_of(const Scene& scene, int body) {
  for (const Joint& joint : scene.joints)
    if (joint.type == JointType::hinge && (joint.body == body || joint.to == body)) return &joint;
  return nullptr;
}

const Water* water_of(const Scene& scene) {
  for (const Force& force : scene.forces)
    if (const auto* water = std::get_if<Water>(&force)) return water;
  return nullptr;
}

double radius(const Body& body) {
  const auto* sphere = std::get_if<Sphere>(&body.shape);
  return sphere ? sphere->radius : 0;
}

// A pair counts as touching while its gap is within this part of the distance from the centre to the contact.
constexpr double near = 1e-2;

}  // namespace

EventSignal::EventSignal(const Observable& q, const Scene& scene, const Pair& pair)
    : scene_(scene),
      kind_(q.event),
      pair_(pair),
      body_(static_cast<std::size_t>(pair.body)),
      about_(q.about),
      up_(up(scene)),
      pole_(pole(scene, scene.bodies[body_])),
      water_(water_of(scene)) {
  const Body& body = scene.bodies[body_];
  axis_ =
      (kind_ == EventKind::flip ? intermediate_axis(body) : symmetry_axis(body)).value_or(Vector3::UnitY());
  if (const Joint* hinge = kind_ == EventKind::swing ? hinge_of(scene, pair.body) : nullptr) {
    axis_ = body.initial.orientation.conjugate() * hinge->axis;
    hinged_to_ = hinge->body == pair.body ? hinge->to : hinge->body;
  }
  int least = 0;  // the world axis farthest from the pole
  pole_.cwiseAbs().minCoeff(&least);
  first_ = pole_.cross(Vector3::Unit(least)).normalized();
  second_ = pole_.cross(first_);
}

double EventSignal::arm(const State& state) const {
  if (pair_.plane < 0) return radius(scene_.bodies[body_]);
  const Plane& plane = scene_.planes[static_cast<std::size_t>(pair_.plane)];
  return plane.normal.dot(state[body_].position) - plane.offset;
}

// v of the bodies' material at the contact, relative to each other and along the surfaces:
// v + w x (-h n), with h from the centre to the plane under it; of two spheres, on the line of centres.
double EventSignal::slip(const State& state) const {
  const BodyState& a = state[body_];
  const double height = arm(state);
  Vector3 normal, relative = a.velocity;
  if (pair_.plane >= 0) {
    normal = scene_.planes[static_cast<std::size_t>(pair_.plane)].normal;
  } else {
    const auto other = static_cast<std::size_t>(pair_.other);
    const BodyState& b = state[other];
    normal = (a.position - b.position).normalized();
    relative -= b.velocity + b.angular_velocity.cross(radius(scene_.bodies[other]) * normal);
  }
  relative -= a.angular_velocity.cross(height * normal);
  if (!(gap(scene_, pair_, state) <= near * height)) return std::numeric_limits<double>::quiet_NaN();
  return (relative - normal.dot(relative) * normal).norm();
}

EventSignal::Reading EventSignal::operator()(const State& state, double t) const {
  const BodyState& s = state[body_];
  Reading reading;
  switch (kind_) {
    case EventKind::bounce:
    case EventKind::apex:
      break;  // EventWatch finds those
    case EventKind::roll:
      reading.x = slip(state);
      break;
    case EventKind::flip:
      reading.x = s.angular_velocity.dot(s.orientation * axis_);
      break;
    case EventKind::swing:  // the axis is fixed in both bodies, so in this one
      reading.x = s.angular_velocity.dot(s.orientation * axis_);
      if (hinged_to_ != world)
        reading.x -= state[static_cast<std::size_t>(hinged_to_)].angular_velocity.dot(s.orientation * axis_);
      break;
    case EventKind::apsis: {
      const BodyState* other = pair_.other == world ? nullptr : &state[static_cast<std::size_t>(pair_.other)];
      const Vector3 d = s.position - (other ? other->position : about_);
      reading.x = d.dot(other ? Vector3(s.velocity - other->velocity) : s.velocity);
      reading.value = d.norm();
      break;
    }
    case EventKind::turn:
      reading.x = up_.dot(s.velocity);
      reading.value = up_.dot(s.position);
      break;
    case EventKind::nutation:
    case EventKind::precession: {
      const Vector3 axis = s.orientation * axis_;
      reading.x = pole_.dot(s.angular_velocity.cross(axis));
      reading.value = std::atan2(pole_.cross(axis).norm(), pole_.dot(axis));
      reading.azimuth = std::atan2(axis.dot(second_), axis.dot(first_));
      break;
    }
    case EventKind::crossing:
      reading.x = s.position.y() - water_surface(*water_, s.position, t);
      break;
  }
  return reading;
}

EventSignal::Error EventSignal::error(const State& state, const StateError& e) const {
  const BodyState& s = state[body_];
  const double spin = s.angular_velocity.norm();
  switch (kind_) {
    case EventKind::bounce:
    case EventKind::apex:
      break;
    case EventKind::roll:
      return {2 * (e.velocity + arm(state) * e.angular_velocity + spin * e.position), 0};
    case EventKind::flip:
    case EventKind::swing:
      return {e.angular_velocity + spin * e.orientation, 0};
    case EventKind::apsis: {
      const bool two = pair_.other != world;
      const BodyState none;
      const BodyState& other = two ? state[static_cast<std::size_t>(pair_.other)] : none;
      const Vector3 from = two ? other.position : about_;
      return {(two ? 2 : 1) * ((s.position - from).norm() * e.velocity +
                               (s.velocity - other.velocity).norm() * e.position),
              0};
    }
    case EventKind::turn:
      return {e.velocity, 0};
    case EventKind::nutation:
    case EventKind::precession: {
      const double across = pole_.cross(s.orientation * axis_).norm();  // the azimuth's lever
      return {e.angular_velocity + spin * e.orientation, e.orientation / across};
    }
    case EventKind::crossing:
      return {(1 + std::abs(water_->wave)) * e.position, 0};
  }
  return {};
}

std::vector<Pair> event_subjects(const Observable& q, const Scene& scene) {
  if (event_type(q.event).of_pairs) return q.body ? touching_pairs(scene, *q.body) : touching_pairs(scene);
  std::vector<Pair> bodies;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i)
    if (q.body ? *q.body == i : !scene.bodies[static_cast<std::size_t>(i)].locked && q.to != i)
      bodies.push_back({i, q.to.value_or(world), -1});
  return bodies;
}

std::optional<std::string> event_undefined(const Observable& q, const Scene& scene) {
  const std::vector<Pair> subjects = event_subjects(q, scene);
  if (subjects.empty())
    return event_type(q.event).of_pairs ? "no two things in the scene may touch" : "no body moves";
  for (const Pair& pair : subjects) {
    const Body& body = scene.bodies[static_cast<std::size_t>(pair.body)];
    switch (q.event) {
      case EventKind::bounce:
      case EventKind::apex:
        if (auto why = gap_undefined(scene, pair)) return why;
        if (!std::holds_alternative<Sphere>(body.shape))
          return "bounces and apexes are watched on spheres; '" + body.name + "' is none";
        break;
      case EventKind::roll:
        if (auto why = gap_undefined(scene, pair)) return why;
        break;
      case EventKind::flip:
        if (!intermediate_axis(body))
          return "body '" + body.name + "' has no intermediate axis (three different principal moments)";
        break;
      case EventKind::swing:
        if (!hinge_of(scene, pair.body)) return "body '" + body.name + "' turns on no hinge";
        break;
      case EventKind::apsis:
        if (pair.other == pair.body) return "body '" + body.name + "' has no distance from itself";
        break;
      case EventKind::turn:
        break;
      case EventKind::nutation:
      case EventKind::precession:
        if (!symmetry_axis(body))
          return "body '" + body.name + "' has no axis of symmetry (two equal principal moments and a third)";
        if (pole(scene, body).isZero(0))
          return "body '" + body.name + "' has no pole: no gravity acts and it does not turn";
        break;
      case EventKind::crossing:
        if (!water_of(scene)) return "the scene has no water";
        break;
    }
  }
  return std::nullopt;
}

}  // namespace cylon::core
