// Surfaces made of several shapes that keep their places, of locked bodies or of the parts of a compound: where they
// meet, the edges and faces inside are no surface.
#pragma once

#include "engine/geometry/pose.h"
#include "engine/model.h"

#include <vector>

namespace cylon::engine {

class Seams {
 public:
  /// All parts of locked bodies that touch something make one surface, and those of each other compound one.
  /// The model must outlive this.
  explicit Seams(const Model&);

  /// Whether a contact on a part of a body (each_part()) that is here now, at x with the unit normal n out of it, is
  /// inside the surface that the part makes with another one, T.  It is where T reaches beyond the plane through x
  /// across n, and holds x and the point of the part a little nearer to `centre`, a point of what touches, if that is
  /// in the plane too: beside a wall a floor is free towards that, and the wall is; a face that another covers is not.
  /// What `by`, the body that touches, may not touch covers nothing for it.
  bool covers(int body, int part, int by, const Motion& now, const Vector3& x, const Vector3& n,
              const Vector3& centre) const;

 private:
  struct Piece {
    int body;
    Shape shape;
    Pose at;                  // world axes of a locked body, else body axes
    std::vector<int> beside;  // pieces of the same surface that it touches
  };

  void find_neighbours(std::size_t first);
  bool covers(const Piece&, int by, const Vector3& x, const Vector3& n, const Vector3& centre) const;

  const Model& model_;
  std::vector<Piece> pieces_;
  std::vector<int> first_;    // of a body in pieces_; -1: it makes no surface with others
  std::vector<char> locked_;  // bodies
  Real size_ = 0;             // of the shapes [m]
};

}  // namespace cylon::engine
