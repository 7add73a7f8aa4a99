// Groups of bodies that touch, or are joined to, each other and nothing else: nothing from outside acts on
// such a group, so it keeps its angular momentum whatever is done about overlaps, and gains no energy.
#pragma once

#include "engine/pile/block.h"

#include <vector>

namespace cylon::engine::pile {

/// Nothing in the model can take up momentum: no plane, no locked body, no joint to the world.
bool isolated(const Model&);

/// Nothing from outside acts on an isolated model but gravity: no force on one body alone, as a spring that hangs from the world,
/// which would have its bodies carry each other's weight.
bool falls_freely(const Model&);

/// Of the centre of mass of a model that falls freely [m/s^2]: with it all bodies fall alike, and none presses on another.
/// Otherwise none.
Vector3 common_gravity(const Model&);
/// With how much bodies can press on each other by their weight [m/s^2]: the strongest gravity, beside the common one.
Real pressing_gravity(const Model&);

/// Impulses act on both bodies at one point, midway between the two anchors, wherever these have moved since
/// the contact was found: then they change neither momentum of the pair.  Where a joint keeps its points apart, at that
/// which was found.
void meet_halfway(std::vector<Block>&, const std::vector<Motion>&);

/// Of an island, about its centre of mass X and in its rest frame, with r = p - X, v = K/m:
///   J = sum r x K + L,   I = sum m (r^2 1 - r r^T) + R I_0 R^T,   E = sum m (v - V)^2/2 + L.w/2
/// Its motion is a rigid one, of angular velocity I^-1 J, and the rest: K - m (V + I^-1 J x r), L - R I_0 R^T
/// I^-1 J, which has no momentum, and to which alone the points of contact owe their relative velocities.  So
/// the rest can be shortened by any factor: impacts then give back less, whatever touches still touches, what
/// sticks still sticks, and the energy falls to J.I^-1 J/2 at least.
class Islands {
 public:
  explicit Islands(const Model& model) : model_(model) {}

  void find(const std::vector<Block>&);

  /// Keeps J and E of now.
  void note(const std::vector<Motion>&);

  /// After impulses, before anything moves: shortens the rest where E has grown (Newton's restitution with
  /// friction, or at several points at once, can do that: T. R. Kane, D. A. Levinson, Dynamics, 1985, 5.8).
  /// Islands with joints are left alone.
  void limit_energy(std::vector<Motion>&) const;

  /// After bodies were moved without their momenta, `before` being where they were: gives J back by a rigid
  /// change of the angular velocity, and what energy that costs is taken from the rest.  Where there is not
  /// so much, the bodies go back; those of an island with joints do not, and gain it.
  void restore(const std::vector<Motion>& before, std::vector<Motion>&) const;

 private:
  using V3 = Eigen::Vector3d;
  using M3 = Eigen::Matrix3d;
  struct Island {
    std::vector<int> bodies;
    bool jointed = false;
    V3 spin = V3::Zero();  // J
    double energy = 0;
  };
  struct Whole {
    V3 centre, velocity, spin;
    M3 inverse;  // I^-1; 0 about an axis without inertia
    double energy;
  };

  Whole whole(const Island&, const std::vector<Motion>&) const;
  void turn(const Island&, const Whole&, const V3& change, std::vector<Motion>&) const;
  bool shorten(const Island&, std::vector<Motion>&) const;

  const Model& model_;
  std::vector<int> root_;
  std::vector<Island> islands_;
};

}  // namespace cylon::engine::pile
