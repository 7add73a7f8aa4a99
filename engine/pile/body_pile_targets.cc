// What each contact, limit and force in a joint asks of a part of a step, and the impacts that follow.
#include "engine/pile/body_pile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine::pile {

// Newton's restitution against the velocity before the forces of the step; a gap may close, but not more.
//   u_n >= -e u_n(before) where the points meet within h;  else u_n >= -max(gap, 0)/h
// Forces act for `span`.  What joints and contacts bore of a blow they go on to press against each other with, if the solution
// begins there: nothing moves by that, but friction would hold.
void BodyPile::set_targets(Time now, Real span, Real h) {
  const Real slow = std::max(4 * gravity_ * h + std::numeric_limits<Real>::min(), unsure_);
  const auto jumped = [this](int body) {
    return body != fixed_world && !jumped_.empty() && jumped_[index(body)];
  };
  for (Block& block : blocks_) {
    if (!takes(block)) continue;
    block.before = relative_velocity(block, movers_);
    block.bias.setZero(), block.blow.setZero(), block.struck = 0;
    if (block.past.acted > 0) block.impulse *= span / block.past.acted;  // where the solution begins
    if (!model_.joints.empty() && (jumped(block.a) || jumped(block.b))) block.impulse.setZero();
    block.limit = block.friction * span, block.past.acted = span;
    if (block.kind == Block::Kind::soft) soften(block, now, span, h);
    if (!block.is_one_sided()) continue;
    const bool stop = block.kind == Block::Kind::stop;
    const Real gap = stop ? gap_of_stop(block) : block.gap + block.normal.dot(offset(block, motions_));
    // Of a stop the rate in the middle of the last part, where its axis had turned half as far.
    Real u = block.normal.dot(block.before);
    if (stop && block.past.known) u = (u + block.past.normal.dot(block.past.u)) / 2;
    const bool meets = u < 0 && gap + u * h <= 0;
    const bool bounces = meets && block.restitution > 0 && -u > unsure_;
    block.target = bounces ? -block.restitution * u : -std::max(gap, Real(0)) / h;
    // Where arms and normals have turned since the last solution, what lasts seems to approach.
    const Real approach = block.past.known ? std::min(-u, -block.past.normal.dot(block.past.u)) : -u;
    block.impact = meets && (stop ? block.impulse.isZero(0) : approach > slow);
    block.gap_now = gap;
  }
}

// Before the forces of the part, whose length is h: impacts one after another, where that was asked for and there are several.
// Where a part is a leap, a group that gives nothing back stops when the surfaces meet.  Of other bodies than spheres, which meet
// at many points and jam, what gives nothing back is solved at once: round after round leads dominoes out of their plane.
void BodyPile::strike_in_turn(Time now, Real h, bool leaps) {
  if (model_.impacts != Impacts::sequential) return;
  if (std::none_of(blocks_.begin(), blocks_.end(), [](const Block& b) { return b.impact; })) return;
  const InTurn::Part part = {h, 4 * gravity_ * h, unsure_, leaps && !isolated_, spheres_};
  const std::vector<Group> all = divided_ ? std::vector<Group>() : find_groups(blocks_, movers_);
  for (const Group& group : divided_ ? groups_ : all) {
    const InTurn::Outcome outcome = in_turn_.strike(group, part, blocks_, model_.bodies, movers_, motions_);
    unsure_in_turn_ = std::max(unsure_in_turn_, in_turn_.unsure());
    if (outcome.ordered) log_.note(DiagnosticKind::impacts_ordered, now);
    if (!outcome.ended) log_.note(DiagnosticKind::impacts_unending, now, outcome.rounds);
    if (outcome.solved) continue;
    log_.note(DiagnosticKind::contacts_unsolved, now, {}, in_turn_.residual());
    residual_ = std::max(residual_, in_turn_.residual());
  }
}

void BodyPile::note_impacts(Time now) {
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    const Block& block = blocks_[k];
    if (!takes(block) || !is_impact(block)) continue;
    smooth_ = false;
    if (block.kind != Block::Kind::stop)
      note_impact(k, now, block.gap_now, block.impact ? -speed_now(block) : block.struck);
  }
}

// The law at the end of the part, with q there = q + h u; s the span for which it acts:
//   J = s Q = s (F - k (q - r) + c r') - s (c + c_2 |u_before| + h k) u,  r the target at the end
// and of a rotor, which has turned at u_before,  J = -A (u - u_before);  of a coordinate geared to u, gearing times what
// gearing u makes of it.
void BodyPile::soften(Block& block, Time now, Real span, Real h) const {
  const CoordinateLaw& law = model_.forces.coordinate_laws[index(block.law)];
  const Real q = row_of(law.at, model_.bodies, motions_.data()).offset;
  const Target::Now target = law.target.at(now + static_cast<Time>(h));
  const Real gearing = block.gearing;
  block.push = gearing * span * (law.force - law.stiffness * (q - target.value) + law.damping * target.rate);
  const Real speed = gearing * std::abs(block.normal.dot(block.before));
  block.drag = gearing * gearing * span * (law.damping + law.quadratic_damping * speed + h * law.stiffness);
  if (law.armature == 0) return;
  // As the last part left it: since then axes have turned, and gearings changed, which a rotor answers too.
  const Past& past = block.past;
  const Real turned = past.known ? past.normal.dot(past.u) / gearing : block.normal.dot(block.before);
  const Real rotor = gearing * gearing * law.armature;
  block.push += rotor * turned, block.drag += rotor;
  block.rotor = rotor, block.turned = turned;
}

// How fast rotors turn, before the drift turns their axes.
void BodyPile::note_rotors() {
  for (Block& block : blocks_) {
    if (block.kind != Block::Kind::soft || !takes(block)) continue;
    if (model_.forces.coordinate_laws[index(block.law)].armature == 0) continue;
    block.past.u = relative_velocity(block, movers_), block.past.normal = block.gearing * block.normal;
    block.past.known = true;
  }
}

// How far the limit is along the block's normal now, negative beyond [m, rad].
Real BodyPile::gap_of_stop(const Block& block) const {
  const CoordinateLaw& law = model_.forces.coordinate_laws[index(block.law)];
  const Real q = row_of(law.at, model_.bodies, motions_.data()).offset;
  return (block.upper ? law.upper - q : q - law.lower) / block.gearing;
}

// Before overlaps are removed: where the step has left coordinates.
void BodyPile::look_at_stops() {
  for (Block& block : blocks_)
    if (block.kind == Block::Kind::stop) block.gap = gap_of_stop(block);
}

// Points of one pair are one impact.
void BodyPile::note_impact(std::size_t k, Time now, Real gap, Real approach) {
  const Block& block = blocks_[k];
  if (!impacts_.empty() && k > 0 && is_impact(blocks_[k - 1]) && same_pair(blocks_[k - 1], block)) return;
  impacts_.push_back({now + static_cast<Time>(gap > 0 ? gap / approach : 0), block.a, block.b, block.plane,
                      approach, block.restitution * approach});
}

// Sweeps take all impacts at once, of one body several, or one and what it presses the body onto: one after the other the body
// would have given way, and met that afterwards.
void BodyPile::note_at_once(Time now) {
  if (model_.impacts != Impacts::sequential) return;
  const auto blows = [&](const Block& b) {
    return takes(b) && b.impact && b.is_one_sided() && b.restitution > 0;
  };
  if (std::none_of(blocks_.begin(), blocks_.end(), blows)) return;
  const auto said = [&] { log_.note(DiagnosticKind::solved_at_once, now); };
  std::vector<Mover> blown = movers_;
  for (Mover& mover : blown) mover.v.setZero(), mover.w.setZero();
  std::vector<char> struck(movers_.size(), 0);
  for (std::size_t k = 0; k < blocks_.size(); ++k) {
    const Block& block = blocks_[k];
    if (!blows(block)) continue;
    push(block, block.impulse, blown);
    if (k > 0 && blows(blocks_[k - 1]) && same_pair(blocks_[k - 1], block)) continue;
    for (const int body : {block.a, block.b}) {
      if (body == fixed_world || model_.bodies[index(body)].locked) continue;
      if (struck[index(body)]) return said();
      struck[index(body)] = 1;
    }
  }
  const auto presses = [&](const Block& b) {
    if (!takes(b) || !b.is_one_sided() || blows(b) || !(b.normal.dot(b.impulse) > 0)) return false;
    const Vector3 given = relative_velocity(b, blown);
    return b.normal.dot(given) < -Real(1e-6) * given.norm();
  };
  if (std::any_of(blocks_.begin(), blocks_.end(), presses)) said();
}

}  // namespace cylon::engine::pile
