#include "engine/pile/islands.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine::pile {
namespace {

Eigen::Matrix3d in_world(const Matrix3& m, const Motion& motion) {
  const Eigen::Matrix3d r = motion.orientation.cast<double>().toRotationMatrix();
  return r * m.cast<double>() * r.transpose();
}

// Axes without inertia, a line of points' own, stay without angular velocity.
Eigen::Matrix3d inverse_of(const Eigen::Matrix3d& inertia) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia);
  const Eigen::Vector3d& moments = axes.eigenvalues();
  Eigen::Vector3d inverse = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (moments[i] > 1e-12 * moments[2]) inverse[i] = 1 / moments[i];
  return axes.eigenvectors() * inverse.asDiagonal() * axes.eigenvectors().transpose();
}

}  // namespace

bool isolated(const Model& model) {
  const auto tied = [](const Body& body) { return body.locked || body.pinned; };
  const auto to_world = [](const Joint& joint) { return joint.to == fixed_world; };
  return model.planes.empty() && std::none_of(model.bodies.begin(), model.bodies.end(), tied) &&
         std::none_of(model.joints.begin(), model.joints.end(), to_world);
}

// A user's force may be from anywhere.
bool falls_freely(const Model& model) {
  return isolated(model) && !any_force(model.forces, []<class Force>(const Force& force) {
           const std::optional<Acted> acted = force.acts_on();
           const bool between_two =
               acted && acted->size() == 2 && std::ranges::find(*acted, fixed_world) == acted->end();
           return std::is_same_v<Force, UserForce> || !between_two;
         });
}

Vector3 common_gravity(const Model& model) {
  Vector3 weight = Vector3::Zero();
  if (!falls_freely(model)) return weight;
  if (!model.has_own_gravity()) return model.forces.gravity;
  Real mass = 0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    weight += model.bodies[i].mass * model.gravity_of(i), mass += model.bodies[i].mass;
  return weight / mass;
}

Real pressing_gravity(const Model& model) {
  const Vector3 common = common_gravity(model);
  if (common.isZero(0)) return model.strongest_gravity();
  Real strongest = 0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    strongest = std::max(strongest, (model.gravity_of(i) - common).norm());
  return strongest;
}

void meet_halfway(std::vector<Block>& blocks, const std::vector<Motion>& motions) {
  for (Block& block : blocks) {
    if (block.angular || block.is_along_normal() || block.b == fixed_world) continue;
    const Motion &a = motions[index(block.a)], &b = motions[index(block.b)];
    if (block.offset) {
      block.to_arm = a.position + block.arm - b.position;
      continue;
    }
    const Vector3 point =
        (a.position + a.orientation * block.anchor + b.position + b.orientation * block.to_anchor) / 2;
    block.arm = point - a.position, block.to_arm = point - b.position;
  }
}

void Islands::find(const std::vector<Block>& blocks) {
  root_.resize(model_.bodies.size());
  for (std::size_t i = 0; i < root_.size(); ++i) root_[i] = static_cast<int>(i);
  const auto root = [&](int i) {
    while (root_[index(i)] != i) i = root_[index(i)] = root_[index(root_[index(i)])];
    return i;
  };
  for (const Block& block : blocks) {
    const int a = root(block.a), b = root(block.b);
    root_[index(std::max(a, b))] = std::min(a, b);
  }
  // Bodies that touch nothing are left out: nothing but the forces changes them.
  std::vector<int> members(root_.size(), 0), place(root_.size(), -1);
  for (int i = 0; i < static_cast<int>(root_.size()); ++i) ++members[index(root(i))];
  islands_.clear();
  for (int i = 0; i < static_cast<int>(root_.size()); ++i) {
    const std::size_t at = index(root(i));
    if (members[at] < 2) continue;
    if (place[at] < 0) place[at] = static_cast<int>(islands_.size()), islands_.emplace_back();
    islands_[index(place[at])].bodies.push_back(i);
  }
  for (const Block& block : blocks)
    if (block.kind != Block::Kind::contact) islands_[index(place[index(root(block.a))])].jointed = true;
}

Islands::Whole Islands::whole(const Island& island, const std::vector<Motion>& motions) const {
  Whole w{V3::Zero(), V3::Zero(), V3::Zero(), M3::Zero(), 0};
  double mass = 0;
  for (int i : island.bodies) {
    const double m = static_cast<double>(model_.bodies[index(i)].mass);
    mass += m;
    w.centre += m * motions[index(i)].position.cast<double>();
    w.velocity += motions[index(i)].momentum.cast<double>();
  }
  w.centre /= mass, w.velocity /= mass;
  M3 inertia = M3::Zero();
  for (int i : island.bodies) {
    const Motion& motion = motions[index(i)];
    const Body& body = model_.bodies[index(i)];
    const double m = static_cast<double>(body.mass);
    const V3 r = motion.position.cast<double>() - w.centre,
             k = motion.momentum.cast<double>() - m * w.velocity, l = motion.angular_momentum.cast<double>();
    w.spin += r.cross(k) + l;
    inertia += m * (r.squaredNorm() * M3::Identity() - r * r.transpose()) + in_world(body.inertia, motion);
    w.energy += k.squaredNorm() / (2 * m) + l.dot(in_world(body.inverse_inertia, motion) * l) / 2;
  }
  w.inverse = inverse_of(inertia);
  return w;
}

void Islands::note(const std::vector<Motion>& motions) {
  for (Island& island : islands_) {
    const Whole now = whole(island, motions);
    island.spin = now.spin, island.energy = now.energy;
  }
}

// K += m change x r,  L += R I_0 R^T change.
void Islands::turn(const Island& island, const Whole& w, const V3& change,
                   std::vector<Motion>& motions) const {
  for (int i : island.bodies) {
    Motion& motion = motions[index(i)];
    const Body& body = model_.bodies[index(i)];
    const V3 r = motion.position.cast<double>() - w.centre;
    motion.momentum += (static_cast<double>(body.mass) * change.cross(r)).cast<Real>();
    motion.angular_momentum += (in_world(body.inertia, motion) * change).cast<Real>();
  }
}

// Until E is what was noted.  False where the rest has not so much.
bool Islands::shorten(const Island& island, std::vector<Motion>& motions) const {
  constexpr double rounding = 16 * static_cast<double>(epsilon);
  const Whole now = whole(island, motions);
  const double excess = now.energy - island.energy;
  if (!(excess > rounding * island.energy)) return true;
  const V3 w = now.inverse * now.spin;
  const double rest = now.energy - w.dot(now.spin) / 2;
  if (!(excess <= rest)) return false;
  const double away = 1 - std::sqrt(1 - excess / rest);
  for (int i : island.bodies) {
    Motion& motion = motions[index(i)];
    const Body& body = model_.bodies[index(i)];
    const V3 r = motion.position.cast<double>() - now.centre;
    const V3 k = motion.momentum.cast<double>() -
                 static_cast<double>(body.mass) * (now.velocity + w.cross(r)),
             l = motion.angular_momentum.cast<double>() - in_world(body.inertia, motion) * w;
    motion.momentum -= (away * k).cast<Real>();
    motion.angular_momentum -= (away * l).cast<Real>();
  }
  return true;
}

void Islands::limit_energy(std::vector<Motion>& motions) const {
  for (const Island& island : islands_)
    if (!island.jointed) shorten(island, motions);
}

void Islands::restore(const std::vector<Motion>& before, std::vector<Motion>& motions) const {
  for (const Island& island : islands_) {
    const Whole now = whole(island, motions);
    turn(island, now, now.inverse * (island.spin - now.spin), motions);
    if (island.jointed || shorten(island, motions)) continue;
    for (int i : island.bodies) motions[index(i)] = before[index(i)];
  }
}

}  // namespace cylon::engine::pile
