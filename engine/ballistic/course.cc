#include "engine/ballistic/course.h"

#include "engine/ballistic/encounter.h"
#include "engine/ballistic/scene.h"
#include "engine/operations.h"

namespace cylon::engine::ballistic {

Course::Course(const Model& model, Time dt)
    : model_(model), dt_(dt), weightless_(!(model.strongest_gravity() > 0)), queue_(model.bodies.size()) {
  const std::size_t n = model.bodies.size();
  surfaces_.resize(n);
  collides_.resize(n);
  flights_.resize(n);
  turnings_.resize(n);
  slip_ends_.resize(n, std::numeric_limits<Time>::infinity());
  next_.resize(n, {std::numeric_limits<Time>::infinity(), nothing, 0});
  crossings_.resize(n, {std::numeric_limits<Time>::infinity(), 0, 0});
  bursts_.resize(n);
  last_partner_.resize(n, nothing);
  place_in_cluster_.resize(n, nothing);
  impacts_.reserve(n + 64);
  for (std::size_t i = 0; i < n; ++i) {
    const Body& body = model.bodies[i];
    const Motion& motion = model.motions[i];
    surfaces_[i] = surface(model, i);
    collides_[i] = surfaces_[i] != no_surface;
    flights_[i].position = motion.position;
    flights_[i].velocity = velocity(body, motion);
    flights_[i].acceleration = body.locked ? Vector3(Vector3::Zero()) : model.gravity_of(i);
    if (collides_[i]) flights_[i].radius = std::get<Sphere>(model.shapes[i]).radius;
    turnings_[i].orientation = motion.orientation;
    turnings_[i].angular_momentum = body.locked ? Vector3(Vector3::Zero()) : motion.angular_momentum;
  }
  cells_.build(flights_, collides_, 0);
  settle_at_start();
  foresee_all();
  starting_ = false;
  if (handover_) read_at(now_, handover_->motions);
}

// Bodies that lie on a plane from the beginning make no impact with it.
void Course::settle_at_start() {
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    if (!collides_[i] || model_.bodies[i].locked) continue;
    for (std::size_t k = 0; k < model_.planes.size(); ++k) {
      if (!may_touch_plane(i, k)) continue;
      const Plane& plane = model_.planes[k];
      const Real distance = gap(flights_[i], plane), touch = touching(flights_[i], plane);
      if (distance < -16 * touch) hand_over("body " + std::to_string(i) + " is inside a plane at the start");
      const Vector3& v = flights_[i].velocity;
      const bool lies = distance <= touch && rounded(plane.normal.dot(v), size(v)) == 0;
      const Vector3& g = model_.gravity_of(i);
      const bool pressed = plane.normal.dot(g) < -rounding * size(g);
      if (lies && pressed && flights_[i].support == in_flight) rest_on(i, k, true);
    }
  }
}

void Course::step() {
  impacts_.clear(), contacts_.clear();
  if (handover_) return;
  ++steps_;
  run_until(static_cast<Time>(steps_) * dt_);
  if (handover_) {
    read_at(now_, handover_->motions);
    return;
  }
  for (std::size_t i = 0; i < turnings_.size(); ++i) follow(model_.bodies[i], turnings_[i], now_);
  renew_cells();
  if (keep_) note_lasting();
}

void Course::run_until(Time end) {
  while (!handover_) {
    const std::size_t body = queue_.first();
    const Time time = queue_.key(body).time;
    if (!(time <= end)) break;
    now_ = time;
    ++events_;
    const Next next = next_[body];
    if (crossings_[body].time < next.time) {
      cross(body);
    } else if (next.partner == slip_ends) {
      end_slip(body);
    } else if (next.partner < 0) {
      meet_plane(body, static_cast<std::size_t>(first_plane - next.partner));
    } else if (const auto other = static_cast<std::size_t>(next.partner);
               next.changes != flights_[other].changes) {
      foresee(body);
    } else {
      meet(std::min(body, other), std::max(body, other));
    }
  }
  if (!handover_) now_ = end;
}

// An event asks the bodies in the cells around, a step looks at all.
std::int64_t Course::operations() const {
  return steps_ * static_cast<std::int64_t>(flights_.size()) + sweep_operations(events_);
}

void Course::renewed(std::size_t body) {
  foresee_crossing(body);
  foresee(body);
}

void Course::end_slip(std::size_t body) {
  flights_[body].advance(now_);
  rest_on(body, static_cast<std::size_t>(flights_[body].support), false);
  renewed(body);
}

void Course::meet_plane(std::size_t body, std::size_t k) {
  Flight& flight = flights_[body];
  const Plane& plane = model_.planes[k];
  flight.advance(now_);
  flight.position -= gap(flight, plane) * plane.normal;  // rounding of the instant; so it never adds up
  const Real speed = size(flight.velocity);
  const Real approach = std::max(Real(0), rounded(-plane.normal.dot(flight.velocity), speed));
  const auto pressing = [&] {
    return rounded(-plane.normal.dot(flight.acceleration), size(flight.acceleration));
  };
  Material material = plane_material(body, k);
  const Real separation = material.restitution * approach;
  const bool ends = flight.support == in_flight && collapses(separation, material.restitution, pressing());
  if (approach > 0) {
    look_at_order(body, first_plane - static_cast<int>(k), plane.normal, material);
    if (hit_without_end(body, plane.normal, material)) return;
    if (model_.impacts == Impacts::simultaneous && strike_all(body, body)) return;
    if (ends) material.restitution = 0;
    Side ball = side(body), world;
    strike(ball, world, plane.normal, material);
    record(body, fixed_world, static_cast<int>(k), approach, separation, true);
    take(body, ball, speed + size(ball.velocity));
    last_partner_[body] = first_plane - static_cast<int>(k);
  }
  if (ends) {
    rest_on(body, k, true);
  } else if (flight.support != in_flight && collapses(separation, material.restitution, pressing())) {
    hand_over("body " + std::to_string(body) + " is pressed against planes " +
              std::to_string(flight.support) + " and " + std::to_string(k));
  }
  renewed(body);
}

void Course::meet(std::size_t a, std::size_t b) {
  Flight &one = flights_[a], &other = flights_[b];
  const Time since = std::max(one.since, other.since);
  one.advance(now_);
  other.advance(now_);
  const Vector3 d = one.position - other.position;
  const Vector3 n = d.normalized();
  const Real speed = size(one.velocity) + size(other.velocity);
  const Real approach = std::max(Real(0), rounded(-n.dot(one.velocity - other.velocity), speed));
  const Vector3 acceleration = one.acceleration - other.acceleration;
  const bool pressed = acceleration.dot(n) < -rounding * (size(one.acceleration) + size(other.acceleration));
  const Material& pair = material(a, b);
  const bool again = last_partner_[a] == static_cast<int>(b) && last_partner_[b] == static_cast<int>(a);
  if (pressed && (approach == 0 || (again && pair.restitution < 1 && now_ - since <= shortest())))
    return hand_over("bodies " + std::to_string(a) + " and " + std::to_string(b) + " stay pressed together");
  if (approach > 0) {
    look_at_order(a, static_cast<int>(b), n, pair);
    if (hit_without_end(a, n, pair) || hit_without_end(b, n, pair)) return;
    if (model_.impacts == Impacts::simultaneous && strike_all(a, b)) return;
    Side left = side(a), right = side(b);
    strike(left, right, n, pair);
    record(a, static_cast<int>(b), -1, approach, pair.restitution * approach, true);
    take(a, left, speed + size(left.velocity));
    take(b, right, speed + size(right.velocity));
    last_partner_[a] = static_cast<int>(b);
    last_partner_[b] = static_cast<int>(a);
  }
  renewed(a);
  renewed(b);
}

void Course::read_at(Time t, std::vector<Motion>& motions) const {
  motions.resize(flights_.size());
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    const Body& body = model_.bodies[i];
    Motion& motion = motions[i];
    if (body.locked) {
      motion = model_.motions[i];
      continue;
    }
    motion.position = flights_[i].position_at(t);
    motion.momentum = body.mass * flights_[i].velocity_at(t);
    motion.orientation = orientation_at(body, turnings_[i], t);
    motion.angular_momentum = turnings_[i].angular_momentum_at(t);
  }
}

void Course::read(std::vector<Motion>& motions) const { read_at(now_, motions); }

}  // namespace cylon::engine::ballistic

namespace cylon::engine {

std::unique_ptr<Ballistic> make_ballistic(const Model& model, Time dt) {
  return std::make_unique<ballistic::Course>(model, dt);
}

}  // namespace cylon::engine
