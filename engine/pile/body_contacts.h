// Where bodies of any shape touch, or will within the step, as blocks; joints as blocks too.
#pragma once

#include "engine/contact/seams.h"
#include "engine/diagnostic.h"
#include "engine/geometry/broad_phase.h"
#include "engine/geometry/manifold.h"
#include "engine/pile/block.h"

#include <utility>
#include <vector>

namespace cylon::engine::pile {

class BodyContacts {
 public:
  explicit BodyContacts(const Model&);

  /// Fills `blocks` with the contacts that can matter within `span` [s], each with the impulse that the same
  /// point had in `blocks` before, and with the joints.  A velocity that all have in common brings none near another.
  void find(const std::vector<Motion>&, const std::vector<Mover>&, const Vector3& common, Time now, Time span,
            std::vector<Block>& blocks);

  /// What find() could not do as it should so far.
  const DiagnosticLog& log() const { return log_; }

  /// The least half-width of any shape [m]; 0: there is none.
  Real smallest() const { return smallest_; }

 private:
  /// Where the bodies of a pair were when their contacts were found: b in a's axes; of a plane its normal in
  /// a's axes, and a's height.
  struct Found {
    int a, b, plane;
    Quaternion turn;
    Vector3 shift;
    Real margin;  // within which they were looked for
  };

  void find_near(const std::vector<Motion>&);
  void find_pairs(const std::vector<Motion>&);
  Found now(const std::vector<Motion>&, int a, int b, int plane) const;
  bool holds(const Found& before, const Found& now, Real margin, bool any) const;
  void touch(const std::vector<Motion>&, int a, int b, int plane, Real margin, std::vector<Block>&);
  void keep(const std::vector<Motion>&, const Found&, std::size_t from, std::size_t to, std::vector<Block>&);
  bool are_one_place(const Block& old, const Block& now) const;
  void find_points(const std::vector<Motion>&, int a, int b, int plane, Real margin);
  void leave_out_inside(const std::vector<Motion>&, int a, int b, PartManifold&) const;
  void add_joints(const std::vector<Motion>&, const std::vector<Block>& old, std::vector<Block>&) const;

  const Model& model_;
  Seams seams_;
  Real gravity_;  // pressing_gravity() [m/s^2]
  Real smallest_ = 0;
  std::vector<Real> radius_, margin_;
  std::vector<Travel> travel_;  // in the step, per body
  std::vector<char> round_;
  std::vector<PartBoxes> boxes_;
  std::vector<Bounds> bounds_;
  BroadPhase broad_phase_;
  std::vector<Vector3> places_;             // where the bodies were when near_ was found
  std::vector<Real> room_;                  // how far each, with its reach, may go from there
  std::vector<std::pair<int, int>> near_;   // pairs that may meet until one does
  std::vector<std::pair<int, int>> pairs_;  // that may meet now
  bool persistent_ = false;                 // contacts are kept while the bodies hardly move
  std::vector<Found> found_, old_found_;    // per pair, in the order of the blocks
  std::vector<PartManifold> points_;        // of the pair that is looked at
  std::vector<Block> old_;
  std::vector<const Block*> matched_;  // in old_, of each new block of the pair that is looked at
  DiagnosticLog log_;
  Time now_ = 0;                           // of find() [s]
  std::size_t next_ = 0, next_found_ = 0;  // of the pair that is looked at, in old_ and old_found_
};

/// Body to world; the identity for the world.
Quaternion orientation_of(int body, const std::vector<Motion>&);

/// The arm on `to` of a joint along an axis or in a plane: it pushes on the point where that on `body` is.
void place_hold(const Joint&, Block&, const std::vector<Motion>&);

/// The gap of a contact, or the distance from one point to the other of a part of a joint, now.
Vector3 offset(const Block&, const std::vector<Motion>&);

}  // namespace cylon::engine::pile
