// Impacts::simultaneous: solves all connected contacts of one instant together.
#include "engine/ballistic/course.h"
#include "engine/ballistic/encounter.h"

namespace cylon::engine::ballistic {

namespace {

constexpr int the_world = 0;  // its place among the sides

}  // namespace

int Course::join(std::size_t body) {
  if (model_.bodies[body].locked) return the_world;
  if (place_in_cluster_[body] == nothing) {
    flights_[body].advance(now_);
    place_in_cluster_[body] = static_cast<int>(sides_.size());
    members_.push_back(body);
    sides_.push_back(side(body));
  }
  return place_in_cluster_[body];
}

void Course::gather_plane(std::size_t body, std::size_t k) {
  const Plane& plane = model_.planes[k];
  const Flight& flight = flights_[body];
  if (gap(flight, plane) > touching(flight, plane)) return;
  Touch contact;
  contact.a = join(body);
  contact.b = the_world;
  contact.body = static_cast<int>(body);
  contact.plane = static_cast<int>(k);
  contact.n = plane.normal;
  contact.material = plane_material(body, k);
  contact.approach = std::max(Real(0), rounded(-plane.normal.dot(flight.velocity), size(flight.velocity)));
  const Real e = contact.material.restitution;
  contact.wanted = e * contact.approach;
  const Real pressing = -plane.normal.dot(flight.acceleration);
  contact.ends = flight.support == in_flight && collapses(contact.wanted, e, pressing);
  if (contact.ends) contact.wanted = 0;
  touches_.push_back(contact);
}

void Course::gather_pair(std::size_t body, std::size_t other) {
  if (other == body || !collides_[other] || !may_touch(body, other)) return;
  const int place = place_in_cluster_[other];
  if (place != nothing && place < place_in_cluster_[body]) return;  // it has gathered this pair
  const Vector3 p = flights_[other].position_at(now_), d = flights_[body].position - p;
  const Real reach = flights_[body].radius + flights_[other].radius;
  if (d.norm() - reach > rounding * (size(flights_[body].position) + size(p) + reach)) return;
  Touch contact;
  contact.a = join(body);
  contact.b = join(other);
  contact.body = static_cast<int>(body);
  contact.other = static_cast<int>(other);
  contact.n = d.normalized();
  contact.material = material(body, other);
  const Vector3 &v = flights_[body].velocity, &w = flights_[other].velocity;
  contact.approach = std::max(Real(0), rounded(-contact.n.dot(v - w), size(v) + size(w)));
  contact.wanted = contact.material.restitution * contact.approach;
  touches_.push_back(contact);
}

void Course::gather(std::size_t body) {
  for (std::size_t k = 0; k < model_.planes.size(); ++k)
    if (may_touch_plane(body, k)) gather_plane(body, k);
  if (cells_.holds(body)) {
    for (const int other : cells_.near(cells_.cell(body), 0, -1, 1))
      gather_pair(body, static_cast<std::size_t>(other));
    for (const std::size_t other : cells_.large()) gather_pair(body, other);
  } else {
    for (std::size_t other = 0; other < flights_.size(); ++other) gather_pair(body, other);
  }
}

// Returns false, with nothing done, where there is but one contact.
bool Course::strike_all(std::size_t a, std::size_t b) {
  sides_.assign(1, Side{});
  members_.clear();
  touches_.clear();
  join(a);
  join(b);
  // NOLINTNEXTLINE(modernize-loop-convert): gather() adds members
  for (std::size_t k = 0; k < members_.size(); ++k) gather(members_[k]);
  for (const std::size_t body : members_) place_in_cluster_[body] = nothing;
  if (touches_.size() < 2) return false;
  if (!strike_at_once(touches_, sides_)) hand_over("the solution of simultaneous impacts did not converge");

  for (const Touch& c : touches_)
    if (c.approach > 0)
      record(static_cast<std::size_t>(c.body), c.other, c.plane, c.approach,
             c.n.dot(sides_[static_cast<std::size_t>(c.a)].velocity -
                     sides_[static_cast<std::size_t>(c.b)].velocity),
             false);
  for (std::size_t k = 0; k < members_.size(); ++k) {
    const std::size_t body = members_[k];
    take(body, sides_[k + 1], size(flights_[body].velocity) + size(sides_[k + 1].velocity));
    last_partner_[body] = nothing;
  }
  for (const Touch& c : touches_) {
    const auto body = static_cast<std::size_t>(c.body);
    const Vector3& v = flights_[body].velocity;
    if (c.ends && flights_[body].support == in_flight && std::abs(c.n.dot(v)) <= 4 * rounding * size(v))
      rest_on(body, static_cast<std::size_t>(c.plane), true);
  }
  for (const std::size_t body : members_) renewed(body);
  return true;
}

}  // namespace cylon::engine::ballistic
