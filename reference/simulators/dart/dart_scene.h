// A scene as DART's border takes it: trees of bodies, what closes loops, spheres and boxes that may meet.
#pragma once

#include "harness/core/collision_filter.h"
#include "harness/core/scene.h"
#include "harness/core/surfaces.h"
#include "reference/applied/forest.h"
#include "reference/simulators/dart/border/dart_world.h"

#include <vector>

namespace cylon::simulators {

/// DART's own detector knows spheres and boxes: a box stands for a plane, from the foot of its normal [m].
inline constexpr double dart_plane_reach = 1000, dart_plane_depth = 100;

/// Whose a shape of the border is, and for which material of the scene it is there: DART combines numbers of single
/// shapes, so a surface has one shape for each material that it takes part in.
struct DartSurface {
  int body = core::world, plane = -1;
  int material = -1;  ///< Index into Scene::materials.
};

/// Bodies of the scene by index, then its planes, as bodies that do not move.
std::vector<dart_border::Body> dart_bodies(const core::Scene&, const applied::Forest&);
std::vector<dart_border::Loop> dart_loops(const core::Scene&, const applied::Forest&);

class DartSurfaces {
 public:
  explicit DartSurfaces(const core::Scene&);

  const std::vector<dart_border::Shape>& shapes() const { return shapes_; }
  const DartSurface& of(int shape) const { return surfaces_[static_cast<std::size_t>(shape)]; }
  bool meet(int shape, int other) const;

 private:
  void add(const core::Scene&, const DartSurface&, const dart_border::Shape&, int kind);
  int kind_of(const DartSurface&) const;

  core::ContactRules rules_;
  core::Surfaces kinds_;
  std::vector<dart_border::Shape> shapes_;
  std::vector<DartSurface> surfaces_;
};

inline dart_border::Vector to_dart(const core::Vector3& v) { return {v.x(), v.y(), v.z()}; }
inline core::Vector3 from_dart(const dart_border::Vector& v) { return {v[0], v[1], v[2]}; }

}  // namespace cylon::simulators
