// The fast solution of many contacts: sweeps of projected Gauss-Seidel in small parts of a step.
#pragma once

#include "engine/pile/block.h"
#include "engine/pile/groups.h"
#include "engine/pile/quad.h"

#include <vector>

namespace cylon::engine::pile {

/// A step in `parts` of length h; arms and inertias are those at its start.  In each part
///   v += g h;  impulses of the part before;  a sweep with u_n >= -s/h where s > 0, else a stiff spring;
///   x += h v;  a sweep with u_n >= -max(s, 0)/h, which takes back the velocities that removed overlaps
/// with s the gap where the bodies are by now, s = gap + n.(dx_a - dx_b + dt_a x r_a - dt_b x r_b).  Nothing
/// bounces.  E. Catto, Solver2D, 2024 ("TGS" with relaxation); M. Macklin et al., Small
/// steps in physics simulation, SCA 2019.
class Crowd {
 public:
  struct Step {
    Vector3 gravity;
    Real span;  ///< [s]
    int parts;
    Real slop;  ///< Overlap that is left alone [m].
  };

  /// Advances the bodies of a group without joints, on which nothing but gravity and its contacts acts.  In:
  /// blocks as found, with the impulses of the step before, movers as of the motions.  Out: motions, and impulses
  /// as if all parts were as the last; `pressed`, per block, grows by the impulses of all
  /// parts [N s] (null: not wanted).
  void advance(const Group&, const Step&, const std::vector<Body>&, const std::vector<Mover>&,
               std::vector<Block>&, std::vector<Motion>&, std::vector<Vector3>* pressed);

  /// The largest change of a contact's velocity in the last sweep of advance(): how far it is from the
  /// solution [m/s].
  Real residual() const { return residual_; }

 private:
  struct Member {
    Quad v, w, moved, turned;  // the last two since the start of the step
    QuadMatrix inverse_inertia;
    Real inverse_mass;
  };
  struct Spot {
    Quad arm = {}, to_arm = {};
    Real gap = 0, mass = 0;                       // the inverse of K along the normal
    Real mass_11 = 0, mass_12 = 0, mass_22 = 0;   // and across it
    Real slip_mass = 0;                           // no more than the least of that
    Real normal = 0, across_1 = 0, across_2 = 0;  // impulses [N s]
  };
  struct Pair {
    int a, b;  // places in members_; b < 0: what does not move
    std::size_t first;
    int count;
    Quad n, t1, t2;  // towards a
    Real sign;       // of the impulse on a in the block's own order
    Real friction, depth;
  };
  struct Sweep {
    Real inverse_h, rate, slop, stiff, bleed;
    bool relaxes, measures;
  };

  void take(const Group&, const Step&, const std::vector<Body>&, const std::vector<Mover>&,
            const std::vector<Block>&, const std::vector<Motion>&);
  void add_pair(const Group&, std::size_t from, std::size_t to, Real share, const std::vector<Block>&,
                const std::vector<Motion>&);
  void order(const Vector3& gravity, const std::vector<Motion>&);
  void set_masses(const Pair&);
  void push(const Pair&);
  template <bool two>
  Real sweep(const Pair&, const Sweep&);
  void give(const Step&, const std::vector<Body>&, std::vector<Block>&, std::vector<Motion>&) const;
  Vector3 impulse(const Pair&, std::size_t spot) const;
  void add_to(std::vector<Vector3>& pressed) const;

  std::vector<int> place_;  // of all bodies; -1: not a member that moves
  std::vector<int> body_;   // of a member
  std::vector<Member> members_;
  std::vector<Vector3> spins_;  // of members at the start
  std::vector<Pair> pairs_;
  std::vector<Spot> spots_;
  std::vector<std::size_t> block_;  // of each spot
  Real residual_ = 0;
};

}  // namespace cylon::engine::pile
