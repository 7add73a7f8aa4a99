// Leaps: parts of a step in which all contacts are solved to rounding, by the leapfrog method.
//   K(t + h/2) = K(t - h/2) + h F(t),  x(t + h) = x(t) + h K(t + h/2)/m
// with the impulses of contacts and joints at t among the forces.  What lasts is of second order, and the energy that an
// impact takes is what its impulses take, P.(u- + u+)/2.  E. Hairer, C. Lubich, G. Wanner, Acta Numer. 12 (2003) 399.
//
// Between steps motions are those of one instant, K(t) = K(t - h/2) + h/2 F(t), and the impulses of t are half in the
// step that ends there, half in the next.  What an impact gives is all in the next.
#include "engine/free_rotation.h"
#include "engine/pile/body_pile.h"

#include <algorithm>

namespace cylon::engine::pile {

namespace {

// Impacts nearer to each other than this part of a step are one.
constexpr Real same = std::max(Real(1e-6), 64 * epsilon);

Vector3 across(const Vector3& u, const Vector3& n) { return u - n.dot(u) * n; }

// What arms, normals and spaces that turned have changed of the u that the last solution left; it turns with the normal.
Vector3 bend(const Block& block) {
  if (block.kind == Block::Kind::hold) return block.space * block.before - block.past.u;
  if (block.is_along_normal())
    return (block.normal.dot(block.before) - block.past.normal.dot(block.past.u)) * block.normal;
  return block.before - Quaternion::FromTwoVectors(block.past.normal, block.normal) * block.past.u;
}

}  // namespace

bool BodyPile::leaps() const {
  if (implicit_ || (isolated_ && model_.joints.empty())) return false;
  if (divided_) return crowds_.empty() && swept_.blocks.empty();
  return static_cast<int>(blocks_.size()) <= settings_.direct_points;
}

void BodyPile::leap(Time now, Time span, bool last) {
  const Real h = static_cast<Real>(span);
  smooth_ = smooth_ && !model_.forces.jumps_within(now, now + span);
  if (h > limit_.step)
    log_.note(DiagnosticKind::unstable, now, static_cast<double>(limit_.step), {}, limit_.reason);
  if (!is_ahead_) {
    masses_.set(now, model_.bodies);
    set_kinematics();
    leave_resting();
    kick_ahead(now, 0, h);
  }
  impacts_.insert(impacts_.end(), coming_.begin(), coming_.end()), coming_.clear();
  if (keep_) note_share(false);
  taken_.clear();
  drift_ahead(h);
  model_.forces.follow_turns(model_.bodies, motions_.data(), h);

  const Time then = now + span;
  if (last) parts_ahead_ = parts_from(static_cast<Time>(steps_ + 1) * dt_);
  const Time next = last ? dt_ / parts_ahead_ : span;
  masses_.set(then - span / 2, model_.bodies);  // of the momenta that the bodies have now
  set_kinematics();
  find_contacts(then, next);
  // Of gaps as they are now: along the normals of the part before they are off by what bends the path.
  if (divided_) {
    correct_groups(then);
    if (lay_to_rest(h)) divide(static_cast<Real>(next));
  } else {
    correct_positions(then, leaps());
  }
  leave_resting();
  if (leaps())
    kick_ahead(then, h / 2, static_cast<Real>(next));
  else
    land(then, h / 2);
}

// A body that is stopped moves as before until then.
void BodyPile::drift_ahead(Real h) {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    Motion& motion = motions_[i];
    const Body& body = model_.bodies[i];
    if (body.locked) continue;
    const auto go = [&](Real span) {
      motion.position += span * velocity(body, motion);
      if (!motion.angular_momentum.isZero(0))
        motion.orientation = free_flow(body, motion.orientation, motion.angular_momentum, span);
    };
    if (stops_[i] > 0) go(stops_[i]);
    motion.momentum = ahead_[i].momentum, motion.angular_momentum = ahead_[i].angular_momentum;
    go(h - stops_[i]);
  }
}

// Bodies at rest get no forces.
void BodyPile::leave_resting() {
  taken_.clear();
  if (resting_.empty()) return;
  taken_.assign(motions_.size(), 1);
  for (const Group& group : resting_)
    for (const int body : group.bodies) taken_[index(body)] = model_.bodies[index(body)].locked;
}

// From K of `lag` before now to K in the middle of the next part, of length h.
void BodyPile::kick_ahead(Time now, Real lag, Real h) {
  const Real span = lag + h / 2;
  if (isolated_) meet_halfway(blocks_, motions_);
  set_targets(now, span, h);
  strike_in_turn(now, h, true);
  set_bias(lag, h);
  start_.resize(motions_.size()), ahead_.resize(motions_.size()), rates_.resize(motions_.size());
  for (std::size_t i = 0; i < motions_.size(); ++i)
    start_[i] = {motions_[i].momentum, motions_[i].angular_momentum};
  load_ahead(now, lag);
  kick(span, now + static_cast<Time>(h) / 2);
  for (std::size_t i = 0; i < motions_.size(); ++i)  // of the forces alone, by now
    rates_[i] = {(motions_[i].momentum - start_[i].momentum) / span,
                 (motions_[i].angular_momentum - start_[i].angular_momentum) / span};
  impacts_.swap(coming_);
  share_ = lag / span, kick_ = span;
  mark_struck(h);
  note_impacts(now);
  impacts_.swap(coming_);
  if (isolated_) islands_.note(motions_);
  solve_directly(now);
  carry_impulses();
  if (isolated_) islands_.limit_energy(motions_), set_kinematics();
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    Motion& motion = motions_[i];
    ahead_[i] = {motion.momentum, motion.angular_momentum};
    if (!jumped_[i])
      rates_[i] = {(motion.momentum - start_[i].momentum) / span,
                   (motion.angular_momentum - start_[i].angular_momentum) / span};
    motion.momentum = start_[i].momentum + lag * rates_[i].momentum;
    motion.angular_momentum = start_[i].angular_momentum + lag * rates_[i].angular_momentum;
  }
  for (Block& block : blocks_) {
    const Vector3 u = relative_velocity(block, movers_);
    block.past.u = block.kind == Block::Kind::hold ? Vector3(block.space * u) : u;
    block.past.normal =
        block.kind == Block::Kind::soft ? Vector3(block.gearing * block.normal) : block.normal;
    block.past.known = true;
  }
  if (keep_) note_share(true);
  is_ahead_ = true;
}

// The part of the impulses that belongs to the time before the last kick, or to that after it.
void BodyPile::note_share(bool before) {
  for (const Block& block : blocks_) {
    const bool jumps = jumped_[index(block.a)] || (block.b != fixed_world && jumped_[index(block.b)]);
    const Real share = jumps ? 0 : share_;
    const Vector3 impulse = takes(block) ? block.impulse : resting_impulse(block, kick_);
    note_pressed(block, (before ? share : 1 - share) * impulse, contacts_);
  }
}

// At an impact the forces have changed the velocities before the kick till now.
Real BodyPile::speed_now(const Block& block) const {
  return block.normal.dot(block.before + share_ * (relative_velocity(block, movers_) - block.before));
}

// The laws of what lasts hold for the velocity of now, where the path that they lead along is met, and not for that of the
// middle of the next part: there u differs by what bends the path.  Arms and normals have turned in the part before, of
// length 2 lag, which changed u of the same velocities by c:
//   u(t + h/2) = u(t) - c h/(4 lag)
// A normal that has jumped bends no path.
//
// Of what slips friction is against the slip of now, u(t) = u(t + h/2) - h/2 u', with u' as it was.  Only its turn matters,
// and what is about to stop is left to stop.
void BodyPile::set_bias(Real lag, Real h) {
  if (lag == 0) return;
  const auto speed = [&](int body, const Vector3& arm) {
    if (body == fixed_world) return Real(0);
    const Mover& mover = movers_[index(body)];
    return mover.v.norm() + mover.w.norm() * arm.norm();
  };
  const auto rate = [&](int body, const Vector3& arm) {
    if (body == fixed_world) return Vector3(Vector3::Zero());
    const Mover& mover = movers_[index(body)];
    const Momenta& r = rates_[index(body)];
    const Vector3 force = r.momentum - model_.bodies[index(body)].mass_rate * mover.v;  // m v' = K' - m' v
    return Vector3(mover.inverse_mass * force + (mover.inverse_inertia * r.angular_momentum).cross(arm));
  };
  forget_parts_of_pairs();
  for (Block& block : blocks_) {
    if (block.kind == Block::Kind::soft || is_impact(block)) continue;
    const bool touches = block.kind == Block::Kind::contact;
    const Vector3 bent = bend(block);
    const Real most = (speed(block.a, block.arm) + speed(block.b, block.to_arm)) / 4;
    const bool goes_on = !touches || bent.norm() <= most;
    if (block.past.known && goes_on) block.bias = h / (4 * lag) * bent;
    smooth_ = smooth_ && (goes_on || !block.past.known);
    if (!touches) continue;
    const Vector3 &n = block.normal, slip = across(block.before, n);
    const Vector3 change = h / 2 * across(rate(block.a, block.arm) - rate(block.b, block.to_arm), n);
    if (slip.norm() > 8 * change.norm())
      block.bias = n.dot(block.bias) * n + change.dot(slip) / slip.squaredNorm() * slip - change;
  }
}

// Of the points of a pair all are known or none, so that mirrored ones meet mirrored laws.
void BodyPile::forget_parts_of_pairs() {
  for (std::size_t from = 0, to = 0; from < blocks_.size(); from = to) {
    bool known = blocks_[from].past.known;
    for (to = from + 1; to < blocks_.size() && same_pair(blocks_[from], blocks_[to]); ++to)
      known &= blocks_[to].past.known;
    for (std::size_t k = from; k < to; ++k) blocks_[k].past.known = known;
  }
}

// Forces that depend on velocities take those of now, of which the last step tells the change: the method of Adams and
// Bashforth, which is stable in half as long a step as what takes the velocities of before.  In longer steps they do that.
void BodyPile::load_ahead(Time now, Real lag) {
  masses_.set(now, model_.bodies);
  if (!other_forces_) return;
  smooth_ = smooth_ && (steady_ || !model_.forces.read_velocities());
  for (std::size_t i = 0; lag > 0 && steady_ && i < motions_.size(); ++i) {
    motions_[i].momentum += lag * rates_[i].momentum;
    motions_[i].angular_momentum += lag * rates_[i].angular_momentum;
  }
  set_kinematics();
  load(now);
  for (std::size_t i = 0; i < motions_.size(); ++i)
    motions_[i].momentum = start_[i].momentum, motions_[i].angular_momentum = start_[i].angular_momentum;
}

// Bodies that touch, or are joined to, what is struck: their velocities jump.  The first impact of such a group that gives
// nothing back stops it where the surfaces meet, tau from now, and what is still apart then has the rest of the part to
// meet in.  Otherwise a part would leave the approach that just closes the gap, the next part the rest of the impact, and how
// the impact is shared between them no smaller step would settle.
void BodyPile::mark_struck(Real h) {
  jumped_.assign(motions_.size(), 0), stops_.assign(motions_.size(), 0);
  if (std::none_of(blocks_.begin(), blocks_.end(), [](const Block& block) { return block.impact; })) return;
  for (const Group& group : find_groups(blocks_, movers_)) {
    bool any = false, stopped = false;
    Real tau = h;
    for (const int k : group.blocks) {
      const Block& block = blocks_[index(k)];
      if (!block.impact) continue;
      any = true;
      if (block.restitution > 0 || isolated_) continue;
      stopped = true;
      if (const Real u = speed_now(block); u < 0) tau = std::min(tau, std::max(block.gap_now, Real(0)) / -u);
    }
    for (const int k : group.blocks) {
      Block& block = blocks_[index(k)];
      if (!stopped || !block.is_one_sided() || block.target > 0) continue;
      const Real u = speed_now(block), gap = block.gap_now + tau * u, left = h - tau;
      block.target = gap > same * h * std::abs(u) && left > 0 ? -gap / left : Real(0);
    }
    for (const int body : group.bodies) {
      if (model_.bodies[index(body)].locked) continue;
      jumped_[index(body)] = any;
      if (stopped) stops_[index(body)] = tau;
    }
  }
}

// Where steps to come are no leaps: K of now, by the forces alone.
void BodyPile::land(Time now, Real lag) {
  masses_.set(now, model_.bodies);
  set_kinematics();
  load(now);
  kick(lag, now);
  if (keep_)
    for (const Block& block : blocks_)
      if (!takes(block)) note_pressed(block, resting_impulse(block, lag), contacts_);
  for (Block& block : blocks_) block.past.known = false;
  taken_.clear(), jumped_.clear();
  is_ahead_ = false;
}

}  // namespace cylon::engine::pile
