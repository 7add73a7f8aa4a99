// Applies an event: the new motion of a body, its record, or the handover to another stepper.
#include "engine/ballistic/course.h"
#include "engine/ballistic/encounter.h"
#include "engine/ballistic/on_plane.h"

namespace cylon::engine::ballistic {

namespace {

// Of the positions that the times are found from: what passes between two of them is no time.
constexpr Time ulp = static_cast<Time>(epsilon);

}  // namespace

Side Course::side(std::size_t body) const {
  const Body& b = model_.bodies[body];
  Side result;
  if (b.locked) return result;
  result.inverse_mass = b.inverse_mass;
  result.inverse_inertia = b.inverse_moments[1];
  result.radius = result.inverse_inertia > 0 ? flights_[body].radius : 0;
  result.velocity = flights_[body].velocity;
  result.angular_momentum = turnings_[body].angular_momentum_at(now_);
  return result;
}

void Course::take(std::size_t body, const Side& side, Real speed) {
  if (model_.bodies[body].locked) return;
  Flight& flight = flights_[body];
  flight.velocity = side.velocity;
  const bool stops = size(side.velocity) <= rounding * speed;  // what is left is rounding
  if (stops) flight.velocity.setZero();
  ++flight.changes;
  Turning& turning = turnings_[body];
  if (side.angular_momentum != turning.angular_momentum || !turning.torque.isZero(0)) {
    turn_on(model_.bodies[body], turning, now_);
    turning.angular_momentum = side.angular_momentum;
  }
  if (flight.support == in_flight) return;
  const Real away = model_.planes[static_cast<std::size_t>(flight.support)].normal.dot(flight.velocity);
  if (std::abs(away) <= 4 * rounding * speed)
    rest_on(body, static_cast<std::size_t>(flight.support), true);
  else
    fly(body);
}

void Course::fly(std::size_t body) {
  flights_[body].support = in_flight;
  flights_[body].acceleration = model_.gravity_of(body);
  turnings_[body].torque.setZero();
}

void Course::rest_on(std::size_t body, std::size_t k, bool slips) {
  Flight& flight = flights_[body];
  Turning& turning = turnings_[body];
  const Plane& plane = model_.planes[k];
  turn_on(model_.bodies[body], turning, now_);
  flight.velocity -= plane.normal.dot(flight.velocity) * plane.normal;
  flight.position -= gap(flight, plane) * plane.normal;
  flight.support = static_cast<int>(k);
  ++flight.changes;
  const Supported motion = on_plane(side(body), model_.bodies[body].mass, plane.normal,
                                    model_.gravity_of(body), plane_material(body, k).friction, slips);
  flight.acceleration = motion.acceleration;
  turning.torque = motion.torque;
  slip_ends_[body] = now_ + motion.slip_ends;
  if (!motion.straight)
    hand_over("body " + std::to_string(body) + " slides with friction across the slope of plane " +
              std::to_string(k));
}

// Further bounces last 2 s (1 + e + e^2 + ...) / a = 2 s / (a (1 - e)) after a separation speed s.
bool Course::collapses(Real separation, Real restitution, Real pressing) const {
  if (pressing <= 0) return false;
  return static_cast<Time>(2 * separation) <= shortest() * static_cast<Time>(pressing * (1 - restitution));
}

Time Course::shortest() const { return std::max(1e-9 * dt_, 16 * ulp * now_); }

bool Course::is_now(Time t) const { return now_ - t <= 16 * ulp * now_; }

bool Course::hit_without_end(std::size_t body, const Vector3& normal, const Material& material) {
  Burst& burst = bursts_[body];
  if (!is_now(burst.time)) burst.time = now_, burst.impacts = 0;
  burst.velocity = flights_[body].velocity, burst.normal = normal, burst.rough = material.friction > 0;
  if (++burst.impacts <= 128 + flights_.size()) return false;
  hand_over("body " + std::to_string(body) + " has too many impacts at one instant");
  return true;
}

// Of the impact of a body with another, or with a plane (first_plane - k), that comes now: whether both approached already before the
// latest impact that one of them had with a third at this instant, on which this one depends.  Then either might
// have been the first.
void Course::look_at_order(std::size_t body, int other, const Vector3& normal, const Material& material) {
  if (model_.impacts != Impacts::sequential || is_now(ordered_)) return;
  struct Speeds {  // now, and before
    Vector3 now = Vector3::Zero();
    std::optional<Vector3> before = {};
  };
  const auto speeds = [&](int one, int partner) {
    if (one < 0) return Speeds{};
    const auto k = static_cast<std::size_t>(one);
    const Burst& burst = bursts_[k];
    Speeds result{flights_[k].velocity};
    const bool third = burst.impacts > 0 && is_now(burst.time) && last_partner_[k] != partner;
    if (!third || model_.bodies[k].locked) return result;
    const bool depends =
        burst.rough || material.friction > 0 || std::abs(normal.dot(burst.normal)) > rounding;
    if (depends) result.before = burst.velocity;
    return result;
  };
  const Speeds a = speeds(static_cast<int>(body), other), b = speeds(other, static_cast<int>(body));
  const auto approached = [&](const std::optional<Vector3>& v, const std::optional<Vector3>& w) {
    return v && w && rounded(-normal.dot(*v - *w), size(*v) + size(*w)) > 0;
  };
  if (!approached(a.before, b.now) && !approached(a.now, b.before) && !approached(a.before, b.before)) return;
  ordered_ = now_;
  log_.note(DiagnosticKind::impacts_ordered, now_);
}

// `alone`: no other impact belongs to it.
void Course::record(std::size_t body, int other, int plane, Real approach, Real separation, bool alone) {
  impacts_.push_back({now_, static_cast<int>(body), other, plane, approach, separation});
  if (keep_) note_impact(impacts_.back(), alone);
}

// J_n = (approach + separation) / (1/m_a + 1/m_b): the arms of spheres are along the normal.  Of several at
// one instant the impulse of one does not follow from its own speeds.
void Course::note_impact(const Impact& impact, bool alone) {
  const auto body = static_cast<std::size_t>(impact.body);
  const bool plane = impact.plane >= 0;
  const auto other = static_cast<std::size_t>(plane ? impact.plane : impact.other);
  const Vector3 p = flights_[body].position_at(now_);
  Contact contact{.body = impact.body, .other = impact.other, .plane = impact.plane};
  contact.normal = plane ? model_.planes[other].normal : (p - flights_[other].position_at(now_)).normalized();
  contact.point = p - flights_[body].radius * contact.normal;
  const auto inverse_mass = [&](std::size_t i) {
    return model_.bodies[i].locked ? Real(0) : model_.bodies[i].inverse_mass;
  };
  const Real both = inverse_mass(body) + (plane ? Real(0) : inverse_mass(other));
  if (alone && both > 0) contact.impulse = (impact.approach + impact.separation) / both;
  contacts_.push_back(contact);
}

// Bodies that planes bear: J = m (a - g) dt, of which N dt = -m g.n dt presses.  Who came to rest within the step pressed for a part of it, not known
// here.
void Course::note_lasting() {
  const Time begin = static_cast<Time>(steps_ - 1) * dt_, end = static_cast<Time>(steps_) * dt_;
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    const Flight& flight = flights_[i];
    if (flight.support == in_flight) continue;
    const Vector3& n = model_.planes[static_cast<std::size_t>(flight.support)].normal;
    Contact contact{.body = static_cast<int>(i), .plane = flight.support, .normal = n};
    contact.point = flight.position_at(end) - flight.radius * n;
    if (flight.since <= begin) {
      const Real mass_dt = model_.bodies[i].mass * static_cast<Real>(dt_);
      const Vector3& g = model_.gravity_of(i);
      contact.impulse = -mass_dt * g.dot(n);
      contact.friction = mass_dt * (flight.acceleration - g) - *contact.impulse * n;
    }
    contacts_.push_back(contact);
  }
}

void Course::hand_over(const std::string& reason) {
  if (handover_) return;
  handover_.emplace();
  handover_->time = now_;
  handover_->reason = reason;
}

}  // namespace cylon::engine::ballistic
