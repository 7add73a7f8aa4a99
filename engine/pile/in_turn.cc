#include "engine/pile/in_turn.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace cylon::engine::pile {
namespace {

// Of all rounds together; about a third of a second.
constexpr std::int64_t most_operations = std::int64_t{1} << 22;

// Of u_n at a block by all speeds that it is the difference of [m/s].
Real speed_rounding(const Block& block, const std::vector<Mover>& movers) {
  const auto size = [&](int body, const Vector3& arm) {
    if (body == fixed_world) return Real(0);
    const Mover& m = movers[index(body)];
    return block.angular ? m.w.norm() : m.v.norm() + m.w.norm() * arm.norm();
  };
  return 32 * epsilon * (size(block.a, block.arm) + size(block.b, block.to_arm));
}

// What gravity brings of the rate of an angle for each of a speed: weight that hangs at d turns a body of radius of gyration k
// by at most g d/(k^2 + d^2) <= g/(2 k) [1/m].
Real rate_for_speed(const Block& block, const std::vector<Mover>& movers) {
  if (!block.angular) return 1;
  const auto half_over_k = [&](int body) {
    if (body == fixed_world) return Real(0);
    const Mover& m = movers[index(body)];
    const Real turns = block.normal.dot(m.inverse_inertia * block.normal);
    return m.inverse_mass > 0 ? std::sqrt(turns / m.inverse_mass) / 2 : Real(0);
  };
  return half_over_k(block.a) + half_over_k(block.b);
}

}  // namespace

// Blocks of a pair of bodies are beside each other; each stop is a pair by itself.
void InTurn::find_pairs() {
  const std::vector<Block>& blocks = lists_.blocks;
  pairs_.clear();
  for (std::size_t from = 0, to = 0; from < blocks.size(); from = to) {
    const Block& first = blocks[from];
    to = from + 1;
    if (!first.is_one_sided()) continue;
    if (first.kind == Block::Kind::stop) {
      pairs_.push_back({from, to, static_cast<int>(lists_.bodies.size()), 0, static_cast<int>(from)});
      continue;
    }
    while (to < blocks.size() && same_pair(first, blocks[to])) ++to;
    const bool plane = first.b == fixed_world;
    pairs_.push_back({from, to, plane ? first.a : std::min(first.a, first.b), plane ? 0 : 1,
                      plane ? first.plane : std::max(first.a, first.b)});
  }
  std::stable_sort(pairs_.begin(), pairs_.end(), [](const Pair& x, const Pair& y) {
    return std::tie(x.first, x.kind, x.second) < std::tie(y.first, y.kind, y.second);
  });
}

// A pair that was struck touches: what is apart when the part begins meets within it.
Real InTurn::gap_now(std::size_t k) const { return approach_[k] > 0 ? Real(0) : lists_.blocks[k].gap_now; }

// What approached already before the first impact, and was found to be no impact, is what lasts: only what an impact adds counts.
bool InTurn::approaches(std::size_t k, const Part& part) const {
  const Block& block = lists_.blocks[k];
  const Real u = block.normal.dot(relative_velocity(block, lists_.movers));
  const Real lasts = block.impact ? Real(0) : std::max<Real>(0, -block.normal.dot(block.before));
  const Real slow = part.slow * rate_for_speed(block, lists_.movers);
  return -u > lasts + std::max({slow, part.unsure, speed_rounding(block, lists_.movers), unsure_}) &&
         gap_now(k) + u * part.length <= 0;
}

bool InTurn::solve(const Pair& pair, const Part& part) {
  part_.clear(), place_.clear();
  for (std::size_t k = 0; k < lists_.blocks.size(); ++k) {
    const Block& given = lists_.blocks[k];
    const bool joins = given.kind == Block::Kind::hold || given.rotor != 0;
    if (!joins && (k < pair.from || k >= pair.to)) continue;
    Block block = given;
    block.before = relative_velocity(block, lists_.movers);
    block.impulse.setZero(), block.bias.setZero(), block.blow.setZero();
    const Real u = block.normal.dot(block.before);
    if (block.kind == Block::Kind::hold) {
      block.bias = -(block.space * block.before);
    } else if (joins) {
      block.drag = block.rotor, block.push = block.rotor * u, block.turned = u;
    } else {
      block.target = -std::max(gap_now(k), Real(0)) / part.length;
      if (approaches(k, part)) {
        approach_[k] = std::max(approach_[k], -u);
        if (block.restitution > 0)
          block.target = -block.restitution * u;
        else if (part.stops)
          block.target = 0;
      }
    }
    part_.push_back(block), place_.push_back(k);
  }
  const bool solved = bounce_.solve(part_, lists_.bodies, lists_.movers);
  residual_ = std::max(residual_, bounce_.residual());
  unsure_ = std::max(unsure_, static_cast<Real>(bounce_.unsure()));
  for (std::size_t i = 0; i < part_.size(); ++i) blows_[place_[i]] += part_[i].impulse;
  return solved;
}

void InTurn::write_back(const Group& group, std::vector<Block>& blocks) const {
  for (std::size_t k = 0; k < group.blocks.size(); ++k) {
    Block& block = blocks[index(group.blocks[k])];
    block.blow = blows_[k], block.struck = approach_[k];
    // A rotor answers the whole change of its rate, of which this is a part.
    if (block.rotor != 0) block.push -= block.normal.dot(block.blow);
    if (!(block.struck > 0) || !(block.restitution > 0)) continue;
    block.target = std::max<Real>(0, block.normal.dot(relative_velocity(lists_.blocks[k], lists_.movers)));
  }
}

InTurn::Outcome InTurn::strike(const Group& group, const Part& part, std::vector<Block>& blocks,
                               const std::vector<Body>& bodies, const std::vector<Mover>& movers,
                               const std::vector<Motion>& motions) {
  Outcome outcome;
  residual_ = 0, unsure_ = 0;
  const auto any = [&](const auto& is) {
    return std::any_of(group.blocks.begin(), group.blocks.end(), [&](int k) { return is(blocks[index(k)]); });
  };
  const bool bounces = part.dull || any([](const Block& b) { return b.is_one_sided() && b.restitution > 0; });
  if (!bounces || !any([](const Block& b) { return b.impact; })) return outcome;

  lists_.gather(group, blocks, bodies, movers, motions);
  find_pairs();
  blows_.assign(lists_.blocks.size(), Vector3::Zero()), approach_.assign(lists_.blocks.size(), 0);
  const auto struck = [&](const Pair& pair) {
    for (std::size_t k = pair.from; k < pair.to; ++k)
      if (approaches(k, part)) return true;
    return false;
  };
  // What the pairs that approach beside this one would find.
  std::vector<std::pair<std::size_t, Vector3>> found;
  const auto look = [&](const Pair& next) {
    found.clear();
    for (const Pair& pair : pairs_)
      for (std::size_t k = pair.from; k < pair.to && &pair != &next; ++k)
        if (approaches(k, part)) found.emplace_back(k, relative_velocity(lists_.blocks[k], lists_.movers));
  };
  const auto changed = [&](const std::pair<std::size_t, Vector3>& one) {
    const Block& block = lists_.blocks[one.first];
    const Vector3 change = relative_velocity(block, lists_.movers) - one.second;
    const Real size = block.friction > 0 && block.kind == Block::Kind::contact
                          ? change.norm()
                          : std::abs(block.normal.dot(change));
    return size > 64 * speed_rounding(block, lists_.movers);
  };
  int strikes = 0;
  outcome.ended = false;
  const std::int64_t last = bounce_.operations() + most_operations;
  while (!outcome.ended && outcome.rounds < most_impact_rounds && bounce_.operations() <= last) {
    ++outcome.rounds;
    outcome.ended = true;
    for (const Pair& pair : pairs_) {
      if (!struck(pair)) continue;
      outcome.ended = false;
      if (bounce_.operations() > last) break;
      ++strikes;
      if (!outcome.ordered) look(pair);
      outcome.solved &= solve(pair, part);
      outcome.ordered = outcome.ordered || std::any_of(found.begin(), found.end(), changed);
    }
  }
  // A single impact is the solution of the part, unless a joint might share its load with what touches and is not approached.
  const bool shares = pairs_.size() > 1 && any([](const Block& b) { return b.kind == Block::Kind::hold; });
  if (strikes < (shares ? 1 : 2)) return {};
  write_back(group, blocks);
  return outcome;
}

}  // namespace cylon::engine::pile
