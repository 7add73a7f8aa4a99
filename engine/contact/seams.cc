#include "engine/contact/seams.h"

#include "engine/geometry/broad_phase.h"
#include "engine/geometry/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

// Shapes nearer than this part of their size meet, and a point that near to a shape is on it: what a scene
// that is written in decimals leaves between neighbours, and far less than a step that anybody means.
constexpr Real near_part = sizeof(Real) == 8 ? Real(1e-9) : Real(1e-5);
// How far from x the other point is, in parts of the size.
constexpr Real aside_part = sizeof(Real) == 8 ? Real(1e-6) : Real(1e-3);

Vector3 nearest_on(const Shape& shape, const Pose& pose, const Vector3& x) {
  Pose point = pose;
  point.position = x;
  const Separation s = separation(Shape(Sphere{0}), point, shape, pose);
  return s.gap > 0 ? s.other_point : x;
}

Real distance(const Shape& shape, const Pose& pose, const Vector3& x) {
  Pose point = pose;
  point.position = x;
  return separation(Shape(Sphere{0}), point, shape, pose).gap;
}

// max n.(y - x) over the shape.
Real beyond(const Shape& shape, const Pose& pose, const Vector3& n, const Vector3& x) {
  const Vector3 far = farthest(shape, pose.rotation.transpose() * n);
  return n.dot(pose.position + pose.rotation * far - x);
}

// Nearer to the plane across n than this part of that, the other point is in it.
constexpr Real across_part = Real(1e-3);

}  // namespace

Seams::Seams(const Model& model) : model_(model), first_(model.bodies.size(), -1) {
  const auto touches = [&](std::size_t i) {
    return i < model.surfaces.size() && model.surfaces[i] != no_surface &&
           !std::holds_alternative<std::monostate>(model.shapes[i]);
  };
  const auto add = [&](std::size_t i, const Pose& at) {
    first_[i] = static_cast<int>(pieces_.size());
    each_part(model.shapes[i], at, [&](int, const Shape& part, const Pose& there) {
      pieces_.push_back({static_cast<int>(i), part, there, {}});
    });
  };
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    locked_.push_back(model.bodies[i].locked);
    if (!touches(i)) continue;
    const bool compound = std::holds_alternative<Compound>(model.shapes[i]);
    if (locked_[i] || compound) size_ = std::max(size_, bounding_radius(model.shapes[i]));
    if (locked_[i]) add(i, pose(model.motions[i]));
  }
  find_neighbours(0);
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (locked_[i] || !touches(i) || !std::holds_alternative<Compound>(model.shapes[i])) continue;
    const std::size_t first = pieces_.size();
    add(i, {});
    find_neighbours(first);
  }
}

// Of the pieces from `first` on.  O(n^2) in them, of which few meet.
void Seams::find_neighbours(std::size_t first) {
  const Vector3 near = Vector3::Constant(near_part * size_);
  std::vector<Bounds> boxes;
  for (std::size_t i = first; i < pieces_.size(); ++i) {
    boxes.push_back(bounds(pieces_[i].shape, pieces_[i].at));
    boxes.back() = {boxes.back().low - near, boxes.back().high + near};
  }
  BroadPhase broad_phase;
  for (const auto& [one, other] : broad_phase.pairs(boxes)) {
    Piece& a = pieces_[first + static_cast<std::size_t>(one)];
    Piece& b = pieces_[first + static_cast<std::size_t>(other)];
    if (separation(a.shape, a.at, b.shape, b.at).gap > near_part * size_) continue;
    a.beside.push_back(static_cast<int>(first) + other);
    b.beside.push_back(static_cast<int>(first) + one);
  }
}

bool Seams::covers(int body, int part, int by, const Motion& now, const Vector3& x, const Vector3& n,
                   const Vector3& centre) const {
  const int first = first_[static_cast<std::size_t>(body)];
  if (first < 0) return false;
  const Piece& piece = pieces_[static_cast<std::size_t>(first) + static_cast<std::size_t>(part)];
  if (piece.beside.empty()) return false;
  if (locked_[static_cast<std::size_t>(body)] != 0) return covers(piece, by, x, n, centre);
  const Quaternion back = now.orientation.conjugate();
  return covers(piece, by, back * (x - now.position), back * n, back * (centre - now.position));
}

bool Seams::covers(const Piece& piece, int by, const Vector3& x, const Vector3& n,
                   const Vector3& centre) const {
  const Real near = near_part * size_;
  Vector3 aside = centre - x;
  aside -= n.dot(aside) * n;
  const Real length = aside.norm();
  Vector3 x_2 = x;
  if (length > near) {
    const Vector3 there = nearest_on(piece.shape, piece.at, x + (aside_part * size_ / length) * aside);
    // Beside an edge or a corner the piece falls away from the plane across n.
    if (n.dot(there - x) > -across_part * aside_part * size_) x_2 = there;
  }
  return std::any_of(piece.beside.begin(), piece.beside.end(), [&](int beside) {
    const Piece& t = pieces_[static_cast<std::size_t>(beside)];
    return model_.may_touch(by, t.body) && distance(t.shape, t.at, x) <= near &&
           distance(t.shape, t.at, x_2) <= near && beyond(t.shape, t.at, n, x) > aside_part * size_;
  });
}

}  // namespace cylon::engine
