// How the contacts of a step are divided among what solves them: few to rounding, many by sweeps or as a crowd, and
// those of bodies at rest by nobody.
#include "engine/pile/body_pile.h"
#include "engine/pile/direct.h"
#include "engine/pile/rest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace cylon::engine::pile {
namespace {

// Of the speed that gravity gives in a step: what is slower hardly moves.
constexpr Real hardly = std::max(Real(1) / (1 << 20), 16 * epsilon);

bool is_slower(const Mover& m, const Shape& shape, Real speed) {
  return m.v.norm() + bounding_radius(shape) * m.w.norm() <= speed;
}

}  // namespace

// More blocks than are always solved to rounding are solved group by group.  Bodies of different groups must
// not act on each other, as groups move in parts of the step of their own; what keeps momenta in isolated
// scenes takes all bodies in the same parts.
void BodyPile::divide(Real span) {
  groups_.clear(), crowds_.clear(), resting_.clear(), swept_ = {};
  divided_ = static_cast<int>(blocks_.size()) > settings_.exact_points && !isolated_ && !paired_;
  if (!divided_) {  // who rests is not asked, and may move
    std::fill(rest_.begin(), rest_.end(), awake);
    std::fill(still_.begin(), still_.end(), 0);
    return;
  }
  std::vector<Group> found = find_groups(blocks_, movers_);
  const auto is_small = [&](const Group& group) {
    return static_cast<int>(group.blocks.size()) <= settings_.exact_points;
  };
  int small = 0;
  for (const Group& group : found)
    if (is_small(group) && !rests(group)) small += static_cast<int>(group.blocks.size());
  const bool few = small <= settings_.exact_total;
  for (Group& group : found) {
    if (rests(group)) {
      resting_.push_back(std::move(group));
      continue;
    }
    for (const int body : group.bodies) rest_[index(body)] = awake;
    const bool built = begins_at_rest(group) && stands(group, span);
    if (!built && !(few && is_small(group)) && is_crowd(group) && !bounces(group, span) &&
        !comes_to_rest(group, span)) {
      crowds_.push_back(std::move(group));
    } else if (built || static_cast<int>(group.blocks.size()) <= settings_.direct_points) {
      groups_.push_back(std::move(group));
    } else {
      swept_.bodies.insert(swept_.bodies.end(), group.bodies.begin(), group.bodies.end());
      swept_.blocks.insert(swept_.blocks.end(), group.blocks.begin(), group.blocks.end());
    }
  }
  std::sort(swept_.bodies.begin(), swept_.bodies.end());
  swept_.bodies.erase(std::unique(swept_.bodies.begin(), swept_.bodies.end()), swept_.bodies.end());
  std::sort(swept_.blocks.begin(), swept_.blocks.end());
}

// Blocks of joints come last.
bool BodyPile::is_crowd(const Group& group) const {
  return !other_forces_ && !masses_.any() && blocks_[index(group.blocks.back())].kind == Block::Kind::contact;
}

// Whether a pair with restitution meets within two steps, faster than what gravity gives in one: a crowd does
// not bounce, and brakes what would cross in the next step.
bool BodyPile::bounces(const Group& group, Real span) const {
  const Real fall = gravity_ * span;
  return std::any_of(group.blocks.begin(), group.blocks.end(), [&](int k) {
    const Block& block = blocks_[index(k)];
    const Real u = block.normal.dot(relative_velocity(block, movers_));
    return block.restitution > 0 && u < -fall && block.gap + 2 * (u - fall) * span <= 0;
  });
}

// Sweeps leave a group at rest with overlaps, and may not hold it: its last steps are solved to rounding, where it is
// not too large for that.
bool BodyPile::comes_to_rest(const Group& group, Real span) const {
  return settings_.rest && static_cast<int>(group.blocks.size()) <= settings_.direct_points &&
         is_slow(group, gravity_ * span / 1024);
}

// In the first step alone, of what is too large to be solved in every step.  Every body lies on something, so that what is
// about to fall costs no solution.
bool BodyPile::begins_at_rest(const Group& group) const {
  const int points = static_cast<int>(group.blocks.size());
  if (steps_ > 0 || !settings_.rest || !is_crowd(group) || points <= settings_.direct_points ||
      points > settings_.standing_points)
    return false;
  std::vector<char> lies(model_.bodies.size());
  for (const int k : group.blocks) {
    const Block& block = blocks_[index(k)];
    if (std::abs(block.gap) > slop(false)) continue;
    for (const int body : {block.a, block.b})
      if (body != fixed_world) lies[index(body)] = 1;
  }
  return std::all_of(group.bodies.begin(), group.bodies.end(), [&](int body) {
    return model_.bodies[index(body)].locked || (still_[index(body)] && lies[index(body)]);
  });
}

// Whether a step of gravity leaves it at rest, by a solution to rounding, of which work is bounded: what slides or falls has
// none that is found so soon, and is swept as it would be later.  Sweeps let what stands creep before it comes to rest.
bool BodyPile::stands(const Group& group, Real span) {
  const auto found = [&](int body) { return model_.bodies[index(body)].locked || stands_[index(body)]; };
  if (std::all_of(group.bodies.begin(), group.bodies.end(), found)) return true;
  lists_.gather(group, blocks_, model_.bodies, movers_, motions_);
  for (std::size_t i = 0; i < lists_.movers.size(); ++i)
    if (!lists_.bodies[i].locked) lists_.movers[i].v += span * model_.forces.gravity;
  for (Block& block : lists_.blocks) {
    block.before.setZero(), block.bias.setZero(), block.impulse.setZero();
    block.target = -std::max(block.gap, Real(0)) / span;
  }
  Direct direct;
  direct.give_up_after(settings_.standing_work * static_cast<std::int64_t>(lists_.blocks.size()));
  const bool solved = direct.solve(lists_.blocks, lists_.bodies, lists_.movers);
  work_ += direct.operations();
  bool at_rest = solved;
  for (std::size_t i = 0; i < lists_.movers.size(); ++i)
    at_rest = at_rest &&
              is_slower(lists_.movers[i], model_.shapes[index(group.bodies[i])], hardly * gravity_ * span);
  for (const int body : group.bodies) stands_[index(body)] = still_[index(body)] = at_rest;
  for (std::size_t k = 0; at_rest && k < group.blocks.size(); ++k) {  // where the step's own solution begins
    Block& block = blocks_[index(group.blocks[k])];
    block.impulse = lists_.blocks[k].impulse, block.past.acted = span;
  }
  return at_rest;
}

// A group that nothing has joined or left since it came to rest, and on which only gravity acts, stays at rest.
bool BodyPile::rests(const Group& group) const {
  return is_crowd(group) && std::all_of(group.bodies.begin(), group.bodies.end(), [&](int body) {
           const Motion& motion = motions_[index(body)];
           return model_.bodies[index(body)].locked ||
                  (rest_[index(body)] == static_cast<int>(group.blocks.size()) && motion.momentum.isZero(0) &&
                   motion.angular_momentum.isZero(0));
         });
}

bool BodyPile::is_on_edge(int body, const Group& group) const {
  const Shape& shape = model_.shapes[index(body)];
  return !is_round(shape) && !model_.bodies[index(body)].locked &&
         stands_on_a_line(body, group, blocks_, bounding_radius(shape));
}

// Groups that hardly move before and after a step: what is left of their velocities is the solver's.  A body
// that turns back hardly moves only once.  Whether one was laid to rest.
bool BodyPile::lay_to_rest(Real span) {
  if (!settings_.rest) return false;
  bool any = false;
  const Real speed = hardly * gravity_ * span;
  const auto look = [&](const Group& group) {
    const auto was_still = [&](int body) { return model_.bodies[index(body)].locked || still_[index(body)]; };
    const bool now = is_crowd(group) && is_slow(group, speed);
    const bool rest = now && std::all_of(group.bodies.begin(), group.bodies.end(), was_still) &&
                      std::none_of(group.bodies.begin(), group.bodies.end(),
                                   [&](int body) { return is_on_edge(body, group); });
    any |= rest;
    for (const int body : group.bodies) {
      still_[index(body)] = now;
      if (!rest || model_.bodies[index(body)].locked) continue;
      rest_[index(body)] = static_cast<int>(group.blocks.size());
      motions_[index(body)].momentum.setZero(), motions_[index(body)].angular_momentum.setZero();
      movers_[index(body)].v.setZero(), movers_[index(body)].w.setZero();
    }
  };
  for (std::size_t k = 0; k < groups_.size(); ++k)
    if (!displaced_[k]) look(groups_[k]);
  for (const Group& group : crowds_) look(group);
  return any;
}

void BodyPile::move_crowds(Time now, Time span) {
  const Real h = static_cast<Real>(span);
  const int parts = (7 * settings_.substeps + 9) / 10;  // two sweeps each
  const Crowd::Step step = {model_.forces.gravity, h, parts, crowd_slop() / 2};
  crowd_.advance(crowds_, step, model_.bodies, movers_, blocks_, motions_, keep_ ? &pressed_ : nullptr);
  for (std::size_t g = 0; g < crowds_.size(); ++g) {
    meet(crowds_[g], now, h);
    for (const int k : crowds_[g].blocks) blocks_[index(k)].past.acted = h;
    swept_to_ = std::max(swept_to_, static_cast<double>(crowd_.residual(g)));
  }
  swept_times_ = std::max(swept_times_, 2 * parts);
}

// The springs of a crowd give way by the square of the length of a part; so does what is left alone.
Real BodyPile::crowd_slop() const {
  const Real finer = Real(10) / static_cast<Real>(settings_.substeps);
  return std::clamp(settings_.slop * finer * finer, settings_.direct_slop, settings_.slop) *
         found_.smallest();
}

bool BodyPile::is_slow(const Group& group, Real speed) const {
  return std::all_of(group.bodies.begin(), group.bodies.end(), [&](int body) {
    return is_slower(movers_[index(body)], model_.shapes[index(body)], speed);
  });
}

bool BodyPile::is_at_rest() const {
  for (std::size_t i = 0; i < movers_.size(); ++i)
    if (!model_.bodies[i].locked &&
        !is_slower(movers_[i], model_.shapes[i], hardly * gravity_ * static_cast<Real>(dt_)))
      return false;
  return true;
}

// Which blocks meet within the step, for bounces and events: as set_targets.
void BodyPile::meet(const Group& group, Time now, Real h) {
  const Real slow = 4 * gravity_ * h + std::numeric_limits<Real>::min();
  for (const int k : group.blocks) {
    Block& block = blocks_[index(k)];
    const Real u = block.normal.dot(relative_velocity(block, movers_));
    const bool meets = u < 0 && block.gap + u * h <= 0;
    block.impact = meets && -u > slow;
    if (block.impact) note_impact(index(k), now, block.gap, -u);
  }
}

}  // namespace cylon::engine::pile
