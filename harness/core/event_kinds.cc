#include "harness/core/event_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cylon::core {
namespace {

using Subject = EventSubject;
using Reading = EventReading;
using Error = EventError;
using Reason = std::optional<std::string>;

const Body& body_of(const Subject& subject) { return subject.scene.bodies[subject.body]; }

const Body& body_of(const Scene& scene, const Pair& pair) {
  return scene.bodies[static_cast<std::size_t>(pair.body)];
}

// ---- Bounce, apex: EventWatch finds them --------------------------------------------------------

Reading no_signal(const Subject&, const State&, double) { return {}; }

Error no_error(const Subject&, const State&, const StateError&) { return {}; }

// ---- Roll ---------------------------------------------------------------------------------------

// A pair counts as touching while its gap is within this part of the distance from the centre to the contact.
constexpr double near = 1e-2;

double radius(const Body& body) {
  const auto* sphere = std::get_if<Sphere>(&body.shape);
  return sphere ? sphere->radius : 0;
}

// From the centre to the contact.
double arm(const Subject& subject, const State& state) {
  if (subject.pair.plane < 0) return radius(body_of(subject));
  const Plane& plane = subject.scene.planes[static_cast<std::size_t>(subject.pair.plane)];
  return plane.normal.dot(state[subject.body].position) - plane.offset;
}

Reason no_contact_point(const Scene& scene, const Pair& pair) {
  if (pair.plane >= 0) return std::nullopt;
  for (const int index : {pair.body, pair.other}) {
    const Body& body = scene.bodies[static_cast<std::size_t>(index)];
    if (!std::holds_alternative<Sphere>(body.shape))
      return "the slip between two bodies is computed for spheres only; '" + body.name + "' is none";
  }
  return std::nullopt;
}

// v of the bodies' material at the contact, relative to each other and along the surfaces:
// v + w x (-h n), with h from the centre to the plane under it; of two spheres, on the line of centres.
Reading slip(const Subject& subject, const State& state, double) {
  const Scene& scene = subject.scene;
  const Pair& pair = subject.pair;
  const BodyState& a = state[subject.body];
  const double height = arm(subject, state);
  Vector3 normal, relative = a.velocity;
  if (pair.plane >= 0) {
    normal = scene.planes[static_cast<std::size_t>(pair.plane)].normal;
  } else {
    const auto other = static_cast<std::size_t>(pair.other);
    const BodyState& b = state[other];
    normal = (a.position - b.position).normalized();
    relative -= b.velocity + b.angular_velocity.cross(radius(scene.bodies[other]) * normal);
  }
  relative -= a.angular_velocity.cross(height * normal);
  if (!(gap(scene, pair, state) <= near * height)) return {.x = std::numeric_limits<double>::quiet_NaN()};
  return {.x = (relative - normal.dot(relative) * normal).norm()};
}

Error slip_error(const Subject& subject, const State& state, const StateError& e) {
  const double spin = state[subject.body].angular_velocity.norm();
  return {2 * (e.velocity + arm(subject, state) * e.angular_velocity + spin * e.position), 0};
}

// ---- Flip, swing: w along an axis of the body ---------------------------------------------------

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

void take_intermediate_axis(Subject& subject) {
  subject.axis = intermediate_axis(body_of(subject)).value_or(Vector3::UnitY());
}

Reason no_intermediate_axis(const Scene& scene, const Pair& pair) {
  const Body& body = body_of(scene, pair);
  if (intermediate_axis(body)) return std::nullopt;
  return "body '" + body.name + "' has no intermediate axis (three different principal moments)";
}

// The joint that leaves a body one rotation, about its axis.
const Joint* axle_of(const Scene& scene, int body) {
  for (const Joint& joint : scene.joints)
    if (kind_of(joint.type).turns_about_axis() && (joint.body == body || joint.to == body)) return &joint;
  return nullptr;
}

void take_axle(Subject& subject) {
  const Joint* axle = axle_of(subject.scene, subject.pair.body);
  if (!axle) return;
  subject.axis = body_of(subject).initial.orientation.conjugate() * axle->axis;
  subject.turns_against = axle->body == subject.pair.body ? axle->to : axle->body;
}

Reason no_axle(const Scene& scene, const Pair& pair) {
  if (axle_of(scene, pair.body)) return std::nullopt;
  return "body '" + body_of(scene, pair).name + "' has no joint that lets it turn about one axis";
}

// w . R a, less that of the body on the joint's other side: the axis is fixed in both.
Reading spin_about_axis(const Subject& subject, const State& state, double) {
  const BodyState& s = state[subject.body];
  Reading reading;
  reading.x = s.angular_velocity.dot(s.orientation * subject.axis);
  if (subject.turns_against != world)
    reading.x -= state[static_cast<std::size_t>(subject.turns_against)].angular_velocity.dot(s.orientation *
                                                                                             subject.axis);
  return reading;
}

Error spin_error(const Subject& subject, const State& state, const StateError& e) {
  return {e.angular_velocity + state[subject.body].angular_velocity.norm() * e.orientation, 0};
}

// ---- Apsis: d . d' = 0 --------------------------------------------------------------------------

Reading approach(const Subject& subject, const State& state, double) {
  const BodyState& s = state[subject.body];
  const int to = subject.pair.other;
  const BodyState* other = to == world ? nullptr : &state[static_cast<std::size_t>(to)];
  const Vector3 d = s.position - (other ? other->position : subject.about);
  Reading reading;
  reading.x = d.dot(other ? Vector3(s.velocity - other->velocity) : s.velocity);
  reading.value = d.norm();
  return reading;
}

Error approach_error(const Subject& subject, const State& state, const StateError& e) {
  const BodyState& s = state[subject.body];
  const bool two = subject.pair.other != world;
  const BodyState none;
  const BodyState& other = two ? state[static_cast<std::size_t>(subject.pair.other)] : none;
  const Vector3 from = two ? other.position : subject.about;
  return {(two ? 2 : 1) *
              ((s.position - from).norm() * e.velocity + (s.velocity - other.velocity).norm() * e.position),
          0};
}

Reason distance_from_itself(const Scene& scene, const Pair& pair) {
  if (pair.other != pair.body) return std::nullopt;
  return "body '" + body_of(scene, pair).name + "' has no distance from itself";
}

// ---- Turn: up . v = 0 ---------------------------------------------------------------------------

Reading climb(const Subject& subject, const State& state, double) {
  const BodyState& s = state[subject.body];
  return {.x = subject.up.dot(s.velocity), .value = subject.up.dot(s.position)};
}

Error climb_error(const Subject&, const State&, const StateError& e) { return {e.velocity, 0}; }

// ---- Nutation, precession: the axis about its pole ----------------------------------------------

void take_symmetry_axis(Subject& subject) {
  subject.axis = symmetry_axis(body_of(subject)).value_or(Vector3::UnitY());
}

// x = pole . (w x axis), the angle between them, and the axis' azimuth.
Reading tilt(const Subject& subject, const State& state, double) {
  const BodyState& s = state[subject.body];
  const Vector3 axis = s.orientation * subject.axis;
  Reading reading;
  reading.x = subject.pole.dot(s.angular_velocity.cross(axis));
  reading.value = std::atan2(subject.pole.cross(axis).norm(), subject.pole.dot(axis));
  reading.azimuth = std::atan2(axis.dot(subject.second), axis.dot(subject.first));
  return reading;
}

Error tilt_error(const Subject& subject, const State& state, const StateError& e) {
  const BodyState& s = state[subject.body];
  const double spin = s.angular_velocity.norm();
  const double across = subject.pole.cross(s.orientation * subject.axis).norm();  // the azimuth's lever
  return {e.angular_velocity + spin * e.orientation, e.orientation / across};
}

Reason no_axis_or_pole(const Scene& scene, const Pair& pair) {
  const Body& body = body_of(scene, pair);
  if (!symmetry_axis(body))
    return "body '" + body.name + "' has no axis of symmetry (two equal principal moments and a third)";
  if (event_pole(scene, body).isZero(0))
    return "body '" + body.name + "' has no pole: no gravity acts and it does not turn";
  return std::nullopt;
}

// ---- Crossing: the height over the water --------------------------------------------------------

// Height of the surface above or below a point at a time [m].  Cells outside the table of mode "step" are
// as the nearest one in it.
double water_surface(const Water& water, const Vector3& point, double t) {
  if (water.mode != "step") return water.level + water.wave * std::sin(point.x() - water.speed * t);
  const auto cell = [](double x) { return std::clamp(std::trunc((x + 5) / 0.25), 0.0, 40.0); };
  const double i = cell(point.x()), j = cell(point.z());
  return water.level + water.wave / 2 * (std::sin(water.speed * t + i) + std::sin(i * j / 2));
}

Reading height_over_water(const Subject& subject, const State& state, double t) {
  const BodyState& s = state[subject.body];
  return {.x = s.position.y() - water_surface(*subject.water, s.position, t)};
}

Error height_error(const Subject& subject, const State&, const StateError& e) {
  return {(1 + std::abs(subject.water->wave)) * e.position, 0};
}

Reason no_water(const Scene& scene, const Pair&) {
  if (event_water(scene)) return std::nullopt;
  return "the scene has no water";
}

// ---- The table ----------------------------------------------------------------------------------

using enum EventQuantity;

const auto& table() {  // in a function, because other sources ask for it before main
  static const std::array rows = {
      EventRow{.type = {EventKind::bounce,
                        "bounce",
                        "a pair touches and separates",
                        true,
                        1,
                        {time, speed, order, count}},
               .search = EventSearch::watch,
               .signal = no_signal,
               .error = no_error,
               .undefined = gap_undefined},
      EventRow{
          .type = {EventKind::apex, "apex", "the largest gap after a bounce", true, 0, {time, height, count}},
          .search = EventSearch::watch,
          .signal = no_signal,
          .error = no_error,
          .undefined = gap_undefined},
      EventRow{.type = {EventKind::roll, "roll", "a touching pair stops sliding", true, 1, {time, count}},
               .search = EventSearch::end_of_slip,
               .signal = slip,
               .error = slip_error,
               .undefined = no_contact_point},
      EventRow{.type = {EventKind::flip,
                        "flip",
                        "the spin about the intermediate axis changes sign",
                        false,
                        1,
                        {time, period, count}},
               .prepare = take_intermediate_axis,
               .signal = spin_about_axis,
               .error = spin_error,
               .undefined = no_intermediate_axis},
      EventRow{.type = {EventKind::swing,
                        "swing",
                        "a swing about the axis of a joint ends",
                        false,
                        1,
                        {time, period, count}},
               .prepare = take_axle,
               .signal = spin_about_axis,
               .error = spin_error,
               .undefined = no_axle},
      EventRow{.type = {EventKind::apsis,
                        "apsis",
                        "the distance from `about`, or from `to`, turns",
                        false,
                        1,
                        {time, distance, period, count}},
               .of_two_bodies = true,
               .value = &Event::distance,
               .signal = approach,
               .error = approach_error,
               .undefined = distance_from_itself},
      EventRow{.type = {EventKind::turn, "turn", "the height turns", false, 1, {time, height, period, count}},
               .value = &Event::height,
               .signal = climb,
               .error = climb_error},
      EventRow{.type = {EventKind::nutation,
                        "nutation",
                        "the axis' angle from its pole turns",
                        false,
                        1,
                        {time, angle, period, rate, count}},
               .rate_over_periods = true,
               .value = &Event::angle,
               .prepare = take_symmetry_axis,
               .signal = tilt,
               .error = tilt_error,
               .undefined = no_axis_or_pole},
      EventRow{.type = {EventKind::precession,
                        "precession",
                        "the axis has gone round its pole once more",
                        false,
                        1,
                        {time, angle, rate, count}},
               .search = EventSearch::whole_turn,
               .value = &Event::angle,
               .prepare = take_symmetry_axis,
               .signal = tilt,
               .error = tilt_error,
               .undefined = no_axis_or_pole},
      EventRow{.type = {EventKind::crossing,
                        "crossing",
                        "the centre crosses the water's surface",
                        false,
                        1,
                        {time, count}},
               .force_jumps = true,
               .signal = height_over_water,
               .error = height_error,
               .undefined = no_water},
  };
  return rows;
}

}  // namespace

const EventRow& event_row(EventKind kind) { return table()[static_cast<std::size_t>(kind)]; }

std::span<const EventType> event_types() {
  static const std::vector<EventType> types = [] {
    std::vector<EventType> result;
    for (const EventRow& row : table()) result.push_back(row.type);
    return result;
  }();
  return types;
}

}  // namespace cylon::core
