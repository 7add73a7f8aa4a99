// A shape as a polytope with a rounding radius: what the general algorithms know of a shape.
//   sphere = point + r, capsule = segment + r, box and hull = themselves + 0.
#pragma once

#include "engine/geometry/pose.h"

#include <array>
#include <vector>

namespace cylon::engine {

using Edge = std::array<int, 4>;  ///< As in Hull; the faces of a segment's edge are -1.

/// Body axes.  Points into the shape, or into itself (hence no copies): lives for one query.
struct Core {
  explicit Core(const Shape&);
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;
  ~Core() = default;

  const Vector3* vertices = nullptr;
  const Edge* edges = nullptr;
  const Vector3* normals = nullptr;  ///< One per face.
  const std::vector<int>* faces = nullptr;
  int vertex_count = 0, edge_count = 0, face_count = 0;
  Real radius = 0;  ///< Of the rounding [m].
  Real size = 0;    ///< Of the core, about the reference point [m].

  /// The vertex farthest along a direction.
  int support(const Vector3& direction) const {
    int best = 0;
    Real most = direction.dot(vertices[0]);
    for (int i = 1; i < vertex_count; ++i) {
      const Real along = direction.dot(vertices[i]);
      if (along > most) most = along, best = i;
    }
    return best;
  }

 private:
  std::array<Vector3, 8> own_;
};

/// Two cores in the axes of the first: differences of positions are taken before anything is rotated, so
/// rounding goes with the distance between the two and not with that from the world's origin.
struct Couple {
  Couple(const Shape& body, const Pose&, const Shape& other, const Pose& other_pose);

  Core a, b;
  Matrix3 turn;   ///< b's axes to a's.
  Vector3 shift;  ///< b's reference point in a's axes [m].
  Real size;      ///< Of the pair; rounding of all lengths is a few eps times this [m].

  Vector3 vertex_a(int i) const { return a.vertices[i]; }
  Vector3 vertex_b(int j) const { return turn * b.vertices[j] + shift; }

  /// The supports of the two, a's along a direction (a's axes), b's against it.
  int support_a(const Vector3& direction) const { return a.support(direction); }
  int support_b(const Vector3& direction) const { return b.support(turn.transpose() * direction); }

  /// min_a n.x - max_b n.x: what a plane with normal n has between the two; < 0 overlap along n.
  Real between(const Vector3& n) const { return n.dot(vertex_a(support_a(-n)) - vertex_b(support_b(n))); }
};

}  // namespace cylon::engine
