#include "engine/pile/overlap.h"

#include <algorithm>
#include <limits>

namespace cylon::engine::pile {
namespace {

constexpr int sweeps = 4;
constexpr Real rounding_of_gap = 64 * epsilon;  // of a coordinate [m, rad]
constexpr Real negligible = Real(1) / 1024;     // of the slop: overlaps tend to it and never reach it

// Of a gap, where the places of its bodies are stored [m].
Real rounding_of_places(const Block& block, const std::vector<Motion>& motions) {
  const auto far = [&](int body) { return motions[index(body)].position.cwiseAbs().maxCoeff(); };
  return 4 * epsilon * (block.b == fixed_world ? far(block.a) : std::max(far(block.a), far(block.b)));
}

}  // namespace

bool Overlaps::displace(const std::vector<Body>& bodies, const std::vector<Block>& blocks,
                        const std::vector<Mover>& movers, Real slop, Share share, bool direct,
                        std::vector<Motion>& motions) {
  bool any = false;
  residual_ = 0;
  blocks_ = blocks;
  for (Block& block : blocks_) {
    block.impulse.setZero(), block.bias.setZero();
    block.limit = block.push = block.drag = 0;  // friction and springs resist no displacement
    if (block.kind == Block::Kind::stop) {
      any |= block.gap < -rounding_of_gap;
      block.target = -block.gap;  // all of it: nothing else lies in a stop
    }
    if (block.kind != Block::Kind::contact) continue;
    const Real depth = -(block.gap + block.normal.dot(offset(block, motions))) - slop;
    any |= depth > negligible * slop + rounding_of_places(block, motions);
    block.friction = 0;
    block.target = depth > 0 ? std::max(share.part * depth, std::min(depth, share.at_once)) : depth;
  }
  if (!any) return false;
  movers_ = movers;
  for (Mover& mover : movers_) mover.v.setZero(), mover.w.setZero();
  if (direct) {
    if (!direct_.solve(blocks_, bodies, movers_)) residual_ = static_cast<Real>(direct_.residual());
  } else {
    for (Block& block : blocks_) set_effective_mass(block, movers_);
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (Block& block : blocks_) relax(block, movers_);
    swept_ += sweeps * static_cast<std::int64_t>(blocks_.size());
    for (const Block& block : blocks_) residual_ = std::max(residual_, unmet(block, movers_));
  }
  if (residual_ <= negligible * slop) residual_ = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    motions[i].position += movers_[i].v;
    if (!movers_[i].w.isZero(0)) motions[i].orientation = turned(motions[i].orientation, movers_[i].w);
  }
  return true;
}

}  // namespace cylon::engine::pile
