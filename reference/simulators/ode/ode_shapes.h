// The shapes of a scene as ODE's geoms.
#pragma once

#include "harness/core/scene.h"

#include <cstdint>
#include <deque>
#include <vector>

struct dxBody;   // ODE's body
struct dxSpace;  // its space of geoms
struct dxGeom;
struct dxTriMeshData;

namespace cylon::simulators {

/// Owns the triangles that geoms refer to: outlives their space.
class OdeSurfaces {
 public:
  OdeSurfaces() = default;
  OdeSurfaces(const OdeSurfaces&) = delete;
  OdeSurfaces& operator=(const OdeSurfaces&) = delete;
  ~OdeSurfaces();

  dxGeom* make(dxSpace*, const core::Mesh&);

 private:
  struct Triangles {
    std::vector<double> corners;
    std::vector<std::uint32_t> indices;
    dxTriMeshData* id = nullptr;
  };
  std::deque<Triangles> all_;
};

/// Adds a body's primitives to the space: fixed to ODE's body, or at rest in the world where that is null.
/// Each carries `owner` as its data.  Shapes that ODE lacks are left out.
void ode_add_shape(dxSpace*, OdeSurfaces&, const core::Body&, dxBody*, void* owner);

/// Whether two moving bodies touch each other at the start, or would if each were larger by a millionth.
bool ode_stacked(const core::Scene&);

}  // namespace cylon::simulators
