#include "engine/pile/bounce.h"

#include "engine/pile/groups.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine::pile {
namespace {

// Of the work of all impulses by amount: what a direct solution leaves of it.
constexpr Real rounding_of_work = 10000 * epsilon;

// What a solution gives each block, and each body.
struct Solution {
  std::vector<Vector3> impulses, after;
  std::vector<Mover> movers;

  Solution(const std::vector<Block>& blocks, const std::vector<Mover>& solved) : movers(solved) {
    for (const Block& block : blocks)
      impulses.push_back(block.impulse), after.push_back(relative_velocity(block, solved));
  }
};

struct Work {
  Real sum = 0, size = 0;
};

// P with what impacts before gave, and without what a rotor gives, -rotor (u - turned) of it: that comes from the rotor's own energy.
Vector3 without_rotor(const Block& block, const Vector3& impulse, const Vector3& after) {
  return impulse + block.blow + block.rotor * (block.normal.dot(after) - block.turned) * block.normal;
}

// Sum of P.(u- + u+)/2 over a group.
Work work(const Group& group, const std::vector<Block>& blocks, const Solution& s) {
  Work w;
  for (const int k : group.blocks) {
    const Vector3 &before = blocks[index(k)].before, &after = s.after[index(k)];
    const Vector3 p = without_rotor(blocks[index(k)], s.impulses[index(k)], after);
    w.sum += p.dot(before + after) / 2;
    w.size += p.norm() * (before.norm() + after.norm()) / 2;
  }
  return w;
}

// W = W_0 + theta b + theta^2 sum dP.du/2,  b = W_1 - W_0 - sum dP.du/2.
Real share(const Group& group, const std::vector<Block>& blocks, const Solution& dull, const Solution& full) {
  Real square = 0;
  for (const int k : group.blocks)
    square += (without_rotor(blocks[index(k)], full.impulses[index(k)], full.after[index(k)]) -
               without_rotor(blocks[index(k)], dull.impulses[index(k)], dull.after[index(k)]))
                  .dot(full.after[index(k)] - dull.after[index(k)]) /
              2;
  const Real none = work(group, blocks, dull).sum, all = work(group, blocks, full).sum;
  return greatest_share(square, all - none - square, none);
}

}  // namespace

Real greatest_share(Real a, Real b, Real c) {
  if (!(c < 0)) return 0;
  // One root: W < 0 at 0 and W > 0 at 1.
  const Real root = std::sqrt(std::max(b * b - 4 * a * c, Real(0)));
  const Real theta = b > 0 ? -2 * c / (b + root) : (root - b) / (2 * a);
  return std::clamp(theta, Real(0), Real(1));
}

bool Bounce::solve(std::vector<Block>& blocks, const std::vector<Body>& bodies, std::vector<Mover>& movers) {
  const auto bounces = [](const Block& b) { return b.is_one_sided() && b.target > 0; };
  const bool any = std::any_of(blocks.begin(), blocks.end(), bounces);
  const std::vector<Mover> start = any ? movers : std::vector<Mover>();
  bool solved = direct_.solve(blocks, bodies, movers);
  residual_ = direct_.residual(), unsure_ = direct_.unsure();
  if (!any) return solved;

  const Solution full(blocks, movers);
  std::vector<Group> gaining = find_groups(blocks, movers);
  std::erase_if(gaining, [&](const Group& group) {
    const Work w = work(group, blocks, full);
    return !(w.sum > rounding_of_work * w.size);
  });
  if (gaining.empty()) return solved;

  std::vector<Block> without = blocks;
  for (Block& block : without)
    if (bounces(block)) block.target = 0;
  std::vector<Mover> slow = start;
  solved &= direct_.solve(without, bodies, slow);
  residual_ = std::max(residual_, direct_.residual()), unsure_ = std::max(unsure_, direct_.unsure());
  const Solution dull(without, slow);
  for (const Group& group : gaining) {
    const Real theta = share(group, blocks, dull, full);
    const auto mix = [theta](const Vector3& from, const Vector3& to) {
      return Vector3(from + theta * (to - from));
    };
    for (const int k : group.blocks)
      blocks[index(k)].impulse = mix(dull.impulses[index(k)], full.impulses[index(k)]);
    for (const int i : group.bodies) {
      movers[index(i)].v = mix(slow[index(i)].v, full.movers[index(i)].v);
      movers[index(i)].w = mix(slow[index(i)].w, full.movers[index(i)].w);
    }
  }
  return solved;
}

}  // namespace cylon::engine::pile
