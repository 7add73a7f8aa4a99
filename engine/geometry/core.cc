#include "engine/geometry/core.h"

#include <algorithm>
#include <cassert>

namespace cylon::engine {
namespace {

// Corner i of a box: its bit k says on which side it is along axis k.
const std::vector<std::vector<int>> box_faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                 {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
const std::array<Vector3, 6> box_normals = {-Vector3::UnitX(), Vector3::UnitX(),  -Vector3::UnitY(),
                                            Vector3::UnitY(),  -Vector3::UnitZ(), Vector3::UnitZ()};
constexpr std::array<Edge, 12> box_edges = {{{0, 1, 2, 4},
                                             {0, 2, 4, 0},
                                             {0, 4, 0, 2},
                                             {1, 3, 1, 4},
                                             {1, 5, 2, 1},
                                             {2, 3, 4, 3},
                                             {2, 6, 3, 0},
                                             {3, 7, 1, 3},
                                             {4, 5, 5, 2},
                                             {4, 6, 0, 5},
                                             {5, 7, 5, 1},
                                             {6, 7, 3, 5}}};
constexpr Edge segment_edge = {0, 1, -1, -1};

}  // namespace

Core::Core(const Shape& shape) {
  vertices = own_.data();
  if (const auto* box = std::get_if<Box>(&shape)) {
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < 3; ++k)
        own_[static_cast<std::size_t>(i)][k] =
            (i >> k & 1) != 0 ? box->half_extents[k] : -box->half_extents[k];
    vertex_count = 8;
    edges = box_edges.data(), edge_count = 12;
    normals = box_normals.data(), faces = box_faces.data(), face_count = 6;
    size = box->half_extents.norm();
  } else if (const auto* hull = std::get_if<Hull>(&shape)) {
    assert(hull->normals.size() == hull->faces.size() && !hull->edges.empty() && "not of make_hull");
    vertices = hull->vertices.data(), vertex_count = static_cast<int>(hull->vertices.size());
    edges = hull->edges.data(), edge_count = static_cast<int>(hull->edges.size());
    normals = hull->normals.data(), faces = hull->faces.data();
    face_count = static_cast<int>(hull->faces.size());
    size = bounding_radius(shape);
  } else if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    own_[0] = {0, -capsule->half_length, 0};
    own_[1] = {0, capsule->half_length, 0};
    vertex_count = 2;
    edges = &segment_edge, edge_count = 1;
    radius = capsule->radius, size = capsule->half_length;
  } else {
    own_[0].setZero();
    vertex_count = 1;
    radius = bounding_radius(shape);
  }
}

Couple::Couple(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose)
    : a(body),
      b(other),
      turn(pose.rotation.transpose() * other_pose.rotation),
      shift(pose.rotation.transpose() * (other_pose.position - pose.position)),
      size(a.size + b.size + shift.norm()) {}

}  // namespace cylon::engine
