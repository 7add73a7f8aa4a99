// The fast solution of many contacts: sweeps of projected Gauss-Seidel in small parts of a step.
#pragma once

#include "engine/lanes.h"
#include "engine/pile/block.h"
#include "engine/pile/groups.h"

#include <vector>

namespace cylon::engine::pile {

/// A step in `parts` of length h; arms and inertias are those at its start.  In each part
///   v += g h;  impulses of the part before;  a sweep with u_n >= -s/h where s > 0, else a stiff spring;
///   x += h v;  a sweep with u_n >= -max(s, 0)/h, which takes back the velocities that removed overlaps
/// with s the gap where the bodies are by now, s = gap + n.(dx_a - dx_b + dt_a x r_a - dt_b x r_b).  Nothing
/// bounces.  E. Catto, Solver2D, 2024 ("TGS" with relaxation); M. Macklin et al., Small
/// steps in physics simulation, SCA 2019.
///
/// Pairs that share no body that moves are swept side by side, in lanes.  Of two that share one the upper comes
/// first, as it would if pairs were swept one by one: how many lanes there are changes no bit.
class Crowd {
 public:
  struct Step {
    Vector3 gravity;
    Real span;  ///< [s]
    int parts;
    Real slop;  ///< Overlap that is left alone [m].
  };

  /// Advances the bodies of groups without joints, on which nothing but gravity and their contacts acts; each as it
  /// would be alone.  In: blocks where they are now, with the impulses of the step before, movers as of the motions.
  /// Out: motions, and impulses as if all parts were as the last; `pressed`, per block, grows by the impulses of all
  /// parts [N s] (null: not wanted).
  void advance(const std::vector<Group>&, const Step&, const std::vector<Body>&, const std::vector<Mover>&,
               std::vector<Block>&, std::vector<Motion>&, std::vector<Vector3>* pressed);

  /// The largest change of a velocity in a contact of a group in the last sweep of advance(): how far it is from
  /// the solution [m/s].
  Real residual(std::size_t group) const { return residuals_[group]; }

  /// Contacts, over all sweeps so far (Stepper::operations()).
  std::int64_t operations() const { return operations_; }

 private:
  // Rows of four, which lanes read: v; w; the diagonal of the inverse inertia and the inverse mass; its xy, xz, yz;
  // how far the body has moved and turned since the start of the step.
  struct alignas(32) Member {
    Real v[4], w[4], diagonal[4], beside[4], moved[4], turned[4];
  };
  static constexpr std::ptrdiff_t stride = sizeof(Member) / sizeof(Real);
  struct Side;

  // Contacts of two bodies along one normal, blocks `from` to `to` of a group.
  struct Pair {
    int group;
    int a, b;  // places in members_; the last is what does not move
    std::size_t from, to;
    bool turned;  // a is the second body of its blocks
    Real depth;
  };
  struct Spot {
    Lanes3 arm, to_arm;
    Lanes first_gap, gap;              // at the start of the step, and by now
    Lanes mass, yield;                 // the inverse of K along the normal, and K there
    Lanes mass_11, mass_12, mass_22;   // and across it
    Lanes slip_mass;                   // no more than the least of that
    Lanes normal, across_1, across_2;  // impulses [N s]
  };
  struct Batch {
    int a[lane_count], b[lane_count], group[lane_count];
    Lanes3 n, t1, t2;  // towards a
    Lanes sign;        // of the impulse on a in the block's own order
    Lanes friction;
    std::size_t first;  // of its spots
    int count, filled;  // spots, lanes
  };
  struct Sweep {
    Real inverse_h, rate, slop, stiff, bleed;
  };

  void take_bodies(const std::vector<Group>&, const std::vector<Body>&, const std::vector<Mover>&);
  void take_pairs(const std::vector<Group>&, const Vector3& gravity, const std::vector<Block>&,
                  const std::vector<Motion>&);
  void schedule();
  void fill(const std::vector<Group>&, Real share, const std::vector<Block>&, const std::vector<Motion>&);
  void set_masses(const Batch&);
  Side side(const int* members) const;
  void put(const int* members, const Side&);
  void push(const Batch&);
  template <bool relaxes>
  void sweep(const Batch&, const Sweep&, Lanes* worst);
  void give(const Step&, const std::vector<Body>&, std::vector<Block>&, std::vector<Motion>&) const;
  template <class Use>
  void for_each_impulse(Use use) const;  // use(block, impulse)

  std::vector<int> place_;  // of all bodies
  std::vector<int> body_;   // of a member
  std::vector<Member> members_;
  std::vector<Vector3> spins_;  // of members at the start
  std::vector<Pair> pairs_;     // from the top down
  std::vector<int> batch_;      // of each pair
  std::vector<int> lane_;       // and its place there
  std::vector<int> last_, open_;
  std::vector<Batch> batches_;
  std::vector<Spot> spots_;
  std::vector<int> block_;       // of each lane of each spot; -1: none
  std::vector<Real> residuals_;  // of each group
  std::int64_t operations_ = 0;
};

}  // namespace cylon::engine::pile
