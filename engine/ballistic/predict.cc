// Predicts the next event of a body.  A prediction starts from the reference times of the bodies, not from
// the present time, so it has the same bits whenever it is made and whichever body of the pair asks for it.
#include "engine/ballistic/course.h"
#include "engine/ballistic/encounter.h"

namespace cylon::engine::ballistic {

namespace {

constexpr Time forever = std::numeric_limits<Time>::infinity();

}  // namespace

void Course::consider(std::size_t body, Time time, int partner, unsigned changes) {
  Next& next = next_[body];
  time = std::max(time, now_);
  if (time < next.time || (time == next.time && partner < next.partner)) next = {time, partner, changes};
}

void Course::consider(std::size_t body, std::size_t other) {
  if (other == body) return;
  const Flight &a = flights_[std::min(body, other)], &b = flights_[std::max(body, other)];
  if (a.radius + b.radius == 0 || !may_touch(body, other)) return;  // points meet nowhere
  const Meeting meeting = contact(a, b);
  if (starting_ && meeting.overlap) hand_over("spheres overlap at the start");
  if (meeting.time == forever) return;
  consider(body, meeting.time, static_cast<int>(other), flights_[other].changes);
}

// For the same as consider(body, other), a crowd at a time.
void Course::join_crowd(std::size_t body, std::size_t other) {
  if (other == body || !may_touch(body, other)) return;
  if (!weightless_ && flights_[body].acceleration != flights_[other].acceleration) {
    consider(body, other);
    return;
  }
  crowd_.add(other);
  if (crowd_.full()) consider_crowd(body);
}

void Course::consider_crowd(std::size_t body) {
  crowd_.meet(flights_[body], flights_);
  for (std::size_t i = 0; i < crowd_.size(); ++i) {
    const std::size_t other = crowd_.body(i);
    if (crowd_.near(i))
      consider(body, other);
    else if (crowd_.time(i) <= next_[body].time)
      consider(body, crowd_.time(i), static_cast<int>(other), flights_[other].changes);
  }
  crowd_.clear();
}

void Course::foresee(std::size_t body) {
  if (!collides_[body] || model_.bodies[body].locked) return;
  const Flight& flight = flights_[body];
  next_[body] = {forever, nothing, 0};
  for (std::size_t k = 0; k < model_.planes.size(); ++k) {
    if (!may_touch_plane(body, k) || flight.support == static_cast<int>(k)) continue;
    const Time after = static_cast<Time>(contact(flight, model_.planes[k]));
    if (after < forever) consider(body, flight.since + after, first_plane - static_cast<int>(k), 0);
  }
  if (flight.support != in_flight && slip_ends_[body] < forever)
    consider(body, slip_ends_[body], slip_ends, 0);
  if (cells_.holds(body)) {
    for (const int other : cells_.near(cells_.cell(body), 0, -1, 1))
      join_crowd(body, static_cast<std::size_t>(other));
    consider_crowd(body);
    for (const std::size_t other : cells_.large()) consider(body, other);
  } else {
    for (std::size_t other = 0; other < flights_.size(); ++other)
      if (collides_[other]) consider(body, other);
  }
  enqueue(body);
}

void Course::foresee_crossing(std::size_t body) {
  Crossing& crossing = crossings_[body];
  crossing.time = forever;
  if (!gridded_ || !cells_.holds(body) || model_.bodies[body].locked) return;
  const Flight& flight = flights_[body];
  const Vector3 p = flight.position_at(now_), v = flight.velocity_at(now_);
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k), index = cells_.cell(body)[k];
    const auto leave = [&](Real distance, Real rate, Real acceleration, std::int8_t step) {
      const Time time = now_ + static_cast<Time>(first_contact(distance, rate, acceleration));
      if (time < crossing.time) crossing = {time, static_cast<std::uint8_t>(k), step};
    };
    const Real a = flight.acceleration[axis];
    if (v[axis] > 0 || a > 0) leave(cells_.upper(k, index) - p[axis], -v[axis], -a, 1);
    if (v[axis] < 0 || a < 0) leave(p[axis] - cells_.lower(k, index), v[axis], a, -1);
  }
}

void Course::enqueue(std::size_t body) {
  const Next& next = next_[body];
  const int own = static_cast<int>(body), partner = next.partner;
  if (crossings_[body].time < next.time) {
    queue_.set(body, {crossings_[body].time, own, nothing});
  } else if (partner >= 0) {
    queue_.set(body, {next.time, std::min(own, partner), std::max(own, partner)});
  } else {
    queue_.set(body, {next.time, own, partner});
  }
}

void Course::cross(std::size_t body) {
  const Crossing crossing = crossings_[body];
  ++crossed_;
  cells_.move(body, crossing.axis, crossing.step);
  foresee_crossing(body);
  if (!cells_.holds(body)) {
    foresee(body);
    return;
  }
  for (const int other : cells_.near(cells_.cell(body), crossing.axis, crossing.step, crossing.step))
    join_crowd(body, static_cast<std::size_t>(other));
  consider_crowd(body);
  enqueue(body);
}

void Course::foresee_all() {
  std::size_t held = 0;
  for (std::size_t i = 0; i < flights_.size(); ++i) held += cells_.holds(i) ? 1 : 0;
  gridded_ = held > 0 && cells_.divided();
  for (std::size_t i = 0; i < flights_.size(); ++i) {
    foresee_crossing(i);
    foresee(i);
  }
}

// The grid stays where it was made; bodies that have left it are all neighbours of each other.
void Course::renew_cells() {
  if (crossed_ < flights_.size()) return;
  crossed_ = 0;
  std::size_t outside = 0;
  for (std::size_t i = 0; i < flights_.size(); ++i)
    if (cells_.holds(i) && cells_.outside(flights_[i].position_at(now_))) ++outside;
  if (outside <= flights_.size() / 8) return;
  cells_.build(flights_, collides_, now_);
  foresee_all();
}

}  // namespace cylon::engine::ballistic
