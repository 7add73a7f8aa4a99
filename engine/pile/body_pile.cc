#include "engine/pile/body_pile.h"

#include "engine/constraint.h"
#include "engine/free_rotation.h"
#include "engine/joint.h"
#include "engine/joint_points.h"
#include "engine/pile/spheres.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::engine::pile {
namespace {

constexpr int most_step_parts = 16, close_rounds = 16;
// Of a step, for stiff forces; what needs more is told as unstable.
constexpr int most_stiff_parts = 1024;

// Whether a force in a joint is not stable by itself in a step.
bool is_stiff(CoordinateLaw law, const std::vector<Body>& bodies, Time dt) {
  law.held = false;
  Forces alone;
  alone.coordinate_laws = {std::move(law)};
  return steady_step(alone, bodies, 0) < static_cast<Real>(dt);
}

}  // namespace

// Joints where nothing depends on how they are named.  What in them is solved with them: forces that are not stable by
// themselves in a step, or might not be, and rotors, which stand by themselves where the rest of their law is none of these.
Model BodyPile::as_stepped(Model model, Time dt) {
  std::vector<CoordinateLaw>& laws = model.forces.coordinate_laws;
  for (std::size_t i = 0, n = laws.size(); i < n; ++i) {
    laws[i].held = laws[i].quadratic_damping != 0 || is_stiff(laws[i], model.bodies, dt);
    if (laws[i].held || laws[i].armature == 0) continue;
    CoordinateLaw rotor;
    rotor.at = laws[i].at, rotor.armature = std::exchange(laws[i].armature, Real(0)), rotor.held = true;
    laws.push_back(std::move(rotor));
  }
  for (Joint& joint : model.joints) joint = at_centres(joint, model);
  return model;
}

BodyPile::BodyPile(const Model& model, Time dt, const PileSettings& settings, std::int64_t first)
    : model_(as_stepped(model, dt)),
      masses_(model_.bodies),
      dt_(dt),
      settings_(settings),
      threads_(settings.threads),
      motions_(model.motions),
      movers_(model.bodies.size()),
      found_(model_),
      islands_(model_),
      rest_(model_.bodies.size(), awake),
      still_(model_.bodies.size(), 0),
      stands_(model_.bodies.size(), 0),
      steps_(first),
      gravity_(pressing_gravity(model)),
      common_gravity_(common_gravity(model)),
      other_forces_(!model.forces.only_gravity() || model.has_own_gravity()),
      isolated_(isolated(model)),
      paired_(any_force(model_.forces, [this](const auto& force) {
        const std::optional<Acted> bodies = force.acts_on();
        return bodies && std::ranges::count_if(*bodies, [this](int body) {
                           return body != fixed_world && !model_.bodies[index(body)].locked;
                         }) > 1;
      })) {
  const Time start = static_cast<Time>(first) * dt;
  masses_.set(start, model_.bodies);
  model_.forces.start_turns();
  const auto stiff = std::ranges::count_if(model_.forces.coordinate_laws, [&](const CoordinateLaw& law) {
    return is_stiff(law, model_.bodies, dt);
  });
  rotors_ = std::ranges::any_of(model_.forces.coordinate_laws,
                                [](const CoordinateLaw& law) { return law.armature != 0; });
  laws_ = model.forces.coordinate_laws.size();
  implicit_ = stiff > 0;
  spheres_ = only_spheres(model);
  if (stiff > 0) log_.note(DiagnosticKind::joint_forces_implicit, start, static_cast<double>(stiff));
  changing_ = masses_.any() || std::ranges::any_of(model_.forces.frame_forces, [](const FrameForce& frame) {
                return !frame.angular_acceleration.isZero(0);
              });
  smooth_ = !model_.forces.jumps_in_space();
  find_limits(start);
  set_kinematics();
  for (std::size_t i = 0; i < movers_.size(); ++i)
    still_[i] = movers_[i].v.isZero(0) && movers_[i].w.isZero(0);
}

std::vector<Diagnostic> BodyPile::diagnostics() const {
  std::vector<Diagnostic> all = log_.all();
  for (Diagnostic& d : found_.log().all()) all.push_back(std::move(d));
  return all;
}

void BodyPile::set_kinematics() {
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Body& body = model_.bodies[i];
    if (!takes(i)) continue;
    const Matrix3 r = motions_[i].orientation.toRotationMatrix();
    movers_[i].inverse_mass = body.inverse_mass;
    movers_[i].inverse_inertia = r * body.inverse_inertia * r.transpose();
    movers_[i].v = velocity(body, motions_[i]);
    movers_[i].w = movers_[i].inverse_inertia * motions_[i].angular_momentum;
  }
}

// The forces of now; gravity alone needs none.
void BodyPile::load(Time now) {
  if (!other_forces_) return;
  kinematics_.resize(motions_.size()), loads_.resize(motions_.size());
  for (std::size_t i = 0; i < motions_.size(); ++i)
    kinematics_[i] = {motions_[i].orientation.toRotationMatrix(), movers_[i].v, movers_[i].w};
  apply(model_.forces, now, model_.bodies, motions_.size(), motions_.data(), kinematics_.data(),
        loads_.data());
}

// K += F span, L += torque span, with forces and masses of before; masses from here on those of `then`:
//   v = K(then)/m(then)
void BodyPile::kick(Real span, Time then) {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const Body& body = model_.bodies[i];
    if (body.locked || !takes(i)) continue;
    const Vector3 force = other_forces_ ? loads_[i].force : Vector3(body.mass * model_.forces.gravity);
    const Vector3 torque = other_forces_ ? loads_[i].torque : Vector3(Vector3::Zero());
    if (body.inverse_mass > 0) motions_[i].momentum += span * force;
    motions_[i].angular_momentum += span * torque;
  }
  masses_.set(then, model_.bodies);
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const Body& body = model_.bodies[i];
    if (body.locked || !takes(i)) continue;
    movers_[i].inverse_mass = body.inverse_mass;
    movers_[i].v = velocity(body, motions_[i]);
    movers_[i].w = movers_[i].inverse_inertia * motions_[i].angular_momentum;
  }
}

// Runs of blocks of the same two bodies, in colours that share no body that moves.
void BodyPile::colour() {
  std::vector<std::uint64_t> used(movers_.size(), 0);
  colours_.assign(64, {});
  for (std::size_t from = 0, to = 0; from < blocks_.size(); from = to) {
    const int a = blocks_[from].a, b = blocks_[from].b;
    while (to < blocks_.size() && blocks_[to].a == a && blocks_[to].b == b) ++to;
    if (!takes(blocks_[from])) continue;
    const bool two = b != fixed_world && movers_[index(b)].inverse_mass > 0;
    const std::uint64_t taken = used[index(a)] | (two ? used[index(b)] : 0);
    const int colour = std::min(std::countr_one(taken), 63);  // the last colour is swept by one thread
    used[index(a)] |= std::uint64_t{1} << colour;
    if (two) used[index(b)] |= std::uint64_t{1} << colour;
    colours_[index(colour)].emplace_back(from, to);
  }
}

void BodyPile::sweep(bool warm) {
  for (std::size_t c = 0; c < colours_.size(); ++c) {
    const auto run = [&](std::size_t k) {
      for (std::size_t i = colours_[c][k].first; i < colours_[c][k].second; ++i) {
        if (warm)
          push(blocks_[i], blocks_[i].impulse, movers_);
        else
          relax(blocks_[i], movers_);
      }
    };
    threads_.for_each(colours_[c].size(), c == 63 ? colours_[c].size() : 16, run);
  }
}

// K += J, L += r x J: sums of opposite impulses at one point, so both momenta are kept to rounding.
void BodyPile::carry_impulses() {
  for (const Block& block : blocks_) {
    if (!takes(block)) continue;
    const auto one = [&](int body, const Vector3& arm, const Vector3& j) {
      Motion& motion = motions_[index(body)];
      if (block.angular) {
        motion.angular_momentum += j;
        return;
      }
      if (model_.bodies[index(body)].inverse_mass > 0) motion.momentum += j;
      motion.angular_momentum += torque_of(block, arm, j);
    };
    if (!model_.bodies[index(block.a)].locked) one(block.a, block.arm, block.impulse);
    if (block.b != fixed_world && !model_.bodies[index(block.b)].locked)
      one(block.b, block.to_arm, -block.impulse);
  }
}

// p += h v with the velocity that met the contacts' laws, and for what all bodies have in common with that of the middle of
// the step; the rotation is that of a free body, exact: it keeps L and the energy.
void BodyPile::drift(Real h) {
  const Vector3 fall = h / 2 * common_gravity_;
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    if (model_.bodies[i].locked || !takes(i)) continue;
    motions_[i].position += h * (movers_[i].v - fall);
    if (movers_[i].w.isZero(0)) continue;
    motions_[i].orientation =
        free_flow(model_.bodies[i], motions_[i].orientation, motions_[i].angular_momentum, h);
  }
}

// Steps up to twice the steady one are stable for one force by itself, and are left as they are.
void BodyPile::find_limits(Time now) {
  // At the end of the step, where a body that burns is lightest and a frame that spins up fastest.
  const Time then = changing_ ? now + dt_ : now;
  masses_.set(then, model_.bodies);
  limit_ = longest_step(model_.forces, model_.bodies, then);
  const Real steps = static_cast<Real>(dt_) / steady_step(model_.forces, model_.bodies, then);
  masses_.set(now, model_.bodies);
  stiff_parts_ = 1;
  steady_ = steps <= Real(0.5);
  if (!(steps > 2 * (1 + 64 * epsilon))) return;
  stiff_parts_ = static_cast<int>(std::min(std::ceil(steps), static_cast<Real>(most_stiff_parts)));
  if (stiff_parts_ <= most_told_) return;
  most_told_ = stiff_parts_;
  log_.note(DiagnosticKind::stiff, now, stiff_parts_, {}, limit_.reason);
}

// What all bodies of an isolated model have in common brings none of them nearer to another, and divides no step.
Vector3 BodyPile::common_velocity() const {
  Vector3 momentum = Vector3::Zero();
  if (!isolated_) return momentum;
  Real mass = 0;
  for (std::size_t i = 0; i < movers_.size(); ++i)
    momentum += model_.bodies[i].mass * movers_[i].v, mass += model_.bodies[i].mass;
  return momentum / mass;
}

int BodyPile::parts_of_step() const {
  if (found_.smallest() == 0) return 1;
  const Vector3 common = common_velocity();
  Real fastest = 0;
  for (const Mover& mover : movers_) fastest = std::max(fastest, (mover.v - common).squaredNorm());
  const Real parts = std::ceil(2 * std::sqrt(fastest) * static_cast<Real>(dt_) / found_.smallest());
  return static_cast<int>(std::min(std::max(parts, Real(1)), Real(most_step_parts + 1)));
}

int BodyPile::parts_from(Time now) {
  if (changing_) find_limits(now);
  int parts = parts_of_step();
  if (parts > most_step_parts) {
    parts = most_step_parts;
    log_.note(DiagnosticKind::too_fast, now, most_step_parts);
  }
  return std::max(parts, stiff_parts_);
}

void BodyPile::step() {
  impacts_.clear(), contacts_.clear();
  swept_to_ = 0, swept_times_ = 0;
  const Time now = static_cast<Time>(steps_) * dt_;
  const int parts = is_ahead_ ? parts_ahead_ : parts_from(now);
  for (int k = 0; k < parts; ++k) advance_part(now + k * dt_ / parts, dt_ / parts, k + 1 == parts);
  std::stable_sort(impacts_.begin(), impacts_.end(),
                   [](const Impact& a, const Impact& b) { return a.time < b.time; });
  if (swept_to_ > 0) log_.note(DiagnosticKind::contacts_swept, now, swept_times_, swept_to_);
  ++steps_;
}

void BodyPile::find_contacts(Time now, Time span) {
  found_.find(motions_, movers_, common_velocity(), now, span, blocks_);
  if (isolated_) islands_.find(blocks_);
  if (keep_) pressed_.assign(blocks_.size(), Vector3::Zero());
  divide(static_cast<Real>(span));
  work_ += static_cast<std::int64_t>(motions_.size() + blocks_.size());
}

// `last` of its step.
void BodyPile::advance_part(Time now, Time span, bool last) {
  if (!is_ahead_) find_contacts(now, span);
  if (leaps()) return leap(now, span, last);
  smooth_ = false;
  if (!divided_) {
    const bool direct = static_cast<int>(blocks_.size()) <= settings_.direct_points;
    pass(now, span, direct);
    if (keep_) note_pressed();
    correct_positions(now, direct);
    return;
  }
  if (!crowds_.empty()) move_crowds(now, span);
  if (!crowds_.empty() || !resting_.empty() || !swept_.blocks.empty()) {
    taken_.assign(motions_.size(), 1);
    const auto leave = [&](const Group& group) {
      for (const int body : group.bodies) taken_[index(body)] = model_.bodies[index(body)].locked;
    };
    leave(swept_);
    for (const Group& group : crowds_) leave(group);
    for (const Group& group : resting_) leave(group);
  }
  pass(now, span, true);
  if (!swept_.blocks.empty()) {
    taken_.assign(motions_.size(), 0);
    for (const int body : swept_.bodies) taken_[index(body)] = 1;
    pass(now, span, false);
  }
  taken_.clear();
  for (const Group& group : resting_)
    for (const int k : group.blocks)
      if (keep_) pressed_[index(k)] = resting_impulse(blocks_[index(k)], static_cast<Real>(span));
  if (keep_) note_pressed();
  correct_groups(now);
  lay_to_rest(static_cast<Real>(span));
}

// Whether a pass advances what the block acts on.
bool BodyPile::takes(const Block& block) const {
  if (taken_.empty()) return true;
  const std::size_t mover = index(model_.bodies[index(block.a)].locked ? block.b : block.a);
  return taken_[mover] != 0;
}

void BodyPile::pass(Time now, Time span, bool direct) {
  const int parts = direct ? 1 : settings_.substeps;
  if (!direct) colour();
  for (int k = 0; k < parts; ++k) substep(now + k * span / parts, span / parts, direct);
  if (!direct) swept_times_ = std::max(swept_times_, parts);
}

// How far the blocks that are swept are from their laws, before the bodies move.
void BodyPile::measure_sweep() {
  for (const Block& block : blocks_)
    if (takes(block)) swept_to_ = std::max(swept_to_, static_cast<double>(unmet(block, movers_)));
}

void BodyPile::note_overlaps(Time now) {
  if (overlaps_.residual() > 0)
    log_.note(DiagnosticKind::overlaps_unsolved, now, {}, static_cast<double>(overlaps_.residual()));
}

Real BodyPile::slop(bool direct) const {
  return (direct ? settings_.direct_slop : settings_.slop) * found_.smallest();
}

Overlaps::Share BodyPile::share(bool direct) const {
  return {settings_.relaxation, direct ? settings_.at_once * found_.smallest() : 0};
}

void BodyPile::correct_positions(Time now, bool direct) {
  set_kinematics();
  look_at_stops();
  if (isolated_) islands_.note(motions_), before_ = motions_;
  const bool moved =
      overlaps_.displace(model_.bodies, blocks_, movers_, slop(direct), share(direct), direct, motions_);
  note_overlaps(now);
  close_joints(now);
  if (isolated_ && (moved || !model_.joints.empty())) islands_.restore(before_, motions_);
  set_kinematics();
}

void BodyPile::correct_groups(Time now) {
  if (!groups_.empty() || !swept_.blocks.empty()) set_kinematics();
  look_at_stops();
  const auto correct = [&](const Group& group, bool direct) {
    lists_.gather(group, blocks_, model_.bodies, movers_, motions_);
    if (!overlaps_.displace(lists_.bodies, lists_.blocks, lists_.movers, slop(direct), share(direct), direct,
                            lists_.motions))
      return false;
    note_overlaps(now);
    for (std::size_t i = 0; i < group.bodies.size(); ++i)
      if (!model_.bodies[index(group.bodies[i])].locked) motions_[index(group.bodies[i])] = lists_.motions[i];
    return true;
  };
  displaced_.resize(groups_.size());
  for (std::size_t k = 0; k < groups_.size(); ++k) displaced_[k] = correct(groups_[k], true);
  if (!swept_.blocks.empty()) correct(swept_, false);
  close_joints(now);
  set_kinematics();
}

// One by one where there are too many blocks for one solution.  Impacts that went one after another come before it, once the
// forces have changed the velocities that these found.
void BodyPile::solve_directly(Time now) {
  const auto struck = [this](const Block& block) { return takes(block) && !block.blow.isZero(0); };
  for (const Block& block : blocks_)
    if (struck(block)) push(block, block.blow, movers_);
  solve_groups(now);
  for (Block& block : blocks_)
    if (struck(block)) block.impulse += block.blow;
}

void BodyPile::solve_groups(Time now) {
  const auto note = [&](bool solved) {
    if (!solved) log_.note(DiagnosticKind::contacts_unsolved, now, {}, direct_.residual());
    smooth_ = smooth_ && solved;
    residual_ = std::max(residual_, direct_.residual());
    unsure_ = std::max(unsure_, static_cast<Real>(direct_.unsure()));
  };
  unsure_ = std::exchange(unsure_in_turn_, 0);
  if (!divided_) {
    if (!blocks_.empty()) note(direct_.solve(blocks_, model_.bodies, movers_));
    return;
  }
  for (const Group& group : groups_) {
    lists_.gather(group, blocks_, model_.bodies, movers_, motions_);
    note(direct_.solve(lists_.blocks, lists_.bodies, lists_.movers));
    for (std::size_t k = 0; k < group.blocks.size(); ++k)
      blocks_[index(group.blocks[k])].impulse = lists_.blocks[k].impulse;
    for (std::size_t i = 0; i < group.bodies.size(); ++i)
      if (!model_.bodies[index(group.bodies[i])].locked) movers_[index(group.bodies[i])] = lists_.movers[i];
  }
}

void BodyPile::substep(Time now, Time h, bool direct) {
  if (static_cast<Real>(h) > limit_.step)
    log_.note(DiagnosticKind::unstable, now, static_cast<double>(limit_.step), {}, limit_.reason);
  masses_.set(now, model_.bodies);  // a pass before this one may have left those of its end
  set_kinematics();
  if (isolated_) meet_halfway(blocks_, motions_);
  set_targets(now, static_cast<Real>(h), static_cast<Real>(h));
  if (direct) strike_in_turn(now, static_cast<Real>(h), false);
  share_ = 0;
  note_impacts(now);
  load(now);
  kick(static_cast<Real>(h), now + h);
  if (isolated_) islands_.note(motions_);
  if (direct) {
    solve_directly(now);
  } else {
    for (Block& block : blocks_) set_effective_mass(block, movers_);
    sweep(true);
    sweep(false);
    measure_sweep();
    work_ += 3 * static_cast<std::int64_t>(blocks_.size());
    note_at_once(now);
  }
  carry_impulses();
  for (std::size_t i = 0; keep_ && i < blocks_.size(); ++i)
    if (takes(blocks_[i])) pressed_[i] += blocks_[i].impulse;
  if (isolated_) islands_.limit_energy(motions_), set_kinematics();
  if (rotors_) note_rotors();
  drift(static_cast<Real>(h));
  model_.forces.follow_turns(model_.bodies, motions_.data(), static_cast<Real>(h));
}

// Of a block that bears as it did before.
Vector3 BodyPile::resting_impulse(const Block& block, Real span) {
  return block.past.acted > 0 ? Vector3(span / block.past.acted * block.impulse) : Vector3(Vector3::Zero());
}

// Bodies where they are by now, normals as they were found.
void BodyPile::note_pressed() {
  for (std::size_t i = 0; i < blocks_.size(); ++i) note_pressed(blocks_[i], pressed_[i], contacts_);
}

void BodyPile::note_pressed(const Block& block, const Vector3& impulse,
                            std::vector<Contact>& contacts) const {
  const Real pressed = block.normal.dot(impulse);
  if (block.kind != Block::Kind::contact || !(pressed > 0)) return;
  const Motion& a = motions_[index(block.a)];
  contacts.push_back({block.a, block.b, block.plane, a.position + a.orientation * block.anchor, block.normal,
                      pressed, Vector3(impulse - pressed * block.normal)});
}

// The drift of joints goes by moving and turning bodies without their velocities, all of it: Newton's method, each round
// one solution of all rows, which leaves the square of the drift.  It ends where rows are closed to their rounding, or
// where what is left is rounding that no longer halves.
void BodyPile::close_joints(Time now) {
  if (model_.joints.empty()) return;
  Real before = std::numeric_limits<Real>::infinity();
  for (int round = 0;; ++round) {
    closing_.rows.clear();
    for (const Joint& joint : model_.joints) add_rows(joint, model_.bodies, motions_.data(), closing_.rows);
    const Real open = closing_.opening();
    const Real widest = closing_.widest();
    if (closing_.closed() || (open == 0 && !(widest < before / 2))) return;
    if (round == close_rounds) {
      if (open != 0) log_.note(DiagnosticKind::joints_drifted, now, close_rounds, static_cast<double>(open));
      return;
    }
    before = widest;
    work_ += static_cast<std::int64_t>(closing_.rows.size());
    closing_.project_positions(model_.bodies, motions_.data());
  }
}

}  // namespace cylon::engine::pile
