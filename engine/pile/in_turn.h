// Impacts of a part of a step one after another, where a group of bodies is solved to rounding.
#pragma once

#include "engine/contact/impact.h"
#include "engine/pile/bounce.h"
#include "engine/pile/groups.h"

namespace cylon::engine::pile {

/// The law of engine/contact/impact.h, `sequential`: pair by pair in the order of the bodies in the scene, of one body planes
/// first and stops of joints last, again and again until nothing approaches.  The points of a pair act at once, joints keep
/// their rates, rotors turn with them, and forces do nothing meanwhile.  A block approaches if it meets within the part,
/// faster than gravity would make it.
class InTurn {
 public:
  /// Where `stops`, a group that an impact gives nothing back stops when the surfaces meet; else its gap may close in the part.
  struct Part {
    Real length;  ///< h [s].
    Real slow;    ///< Speeds up to this are no impact [m/s].
    Real unsure;  ///< Nor are rates of blocks up to this, the error of the last solution [m/s, rad/s].
    bool stops;
    bool dull;  ///< Also of a group in which nothing bounces.
  };
  struct Outcome {
    bool ordered = false;  ///< Another order might have done something else.
    bool ended =
        true;  ///< Nothing approached before most_impact_rounds, or a bounded number of operations, were over.
    int rounds = 0;
    bool solved = true;  ///< As Direct::solve().
  };

  /// In: blocks whose targets are set.  Out, of those of the group: the impulses of all impacts, how fast each was approached, and
  /// targets that keep what the impacts leave while forces act; what still approaches then is left to the
  /// solution of the part, without restitution.  A single impact is left to it whole, unless a joint
  /// might share its load with what touches.  Motions are not changed.
  Outcome strike(const Group&, const Part&, std::vector<Block>&, const std::vector<Body>&,
                 const std::vector<Mover>&, const std::vector<Motion>&);

  double residual() const { return residual_; }
  /// As Direct's, of all impacts of the last group.
  Real unsure() const { return unsure_; }
  std::int64_t operations() const { return bounce_.operations(); }

 private:
  struct Pair {
    std::size_t from, to;  // of the group's blocks
    int first, kind, second;
  };

  void find_pairs();
  Real gap_now(std::size_t k) const;
  bool approaches(std::size_t k, const Part&) const;
  bool solve(const Pair&, const Part&);
  void write_back(const Group&, std::vector<Block>&) const;

  GroupLists lists_;
  std::vector<Pair> pairs_;
  std::vector<Vector3> blows_;
  std::vector<Real> approach_;
  std::vector<Block> part_;
  std::vector<std::size_t> place_;  // of each block of the part in the group
  Bounce bounce_;
  Real unsure_ = 0;
  double residual_ = 0;
};

}  // namespace cylon::engine::pile
