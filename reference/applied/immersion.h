// The part of a body below a horizontal plane.
#pragma once

#include "harness/core/polyhedron.h"
#include "harness/core/scene.h"
#include "reference/applied/revolved.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cylon::applied {

struct Submerged {
  double volume = 0;                               ///< [m^3]
  core::Vector3 centroid = core::Vector3::Zero();  ///< World axes [m]; anything where the volume is zero.
};

/// A solid made ready to be cut.  A point has no volume.
class Immersion {
 public:
  /// Why a shape has no volume, or nothing: "a rod has no volume".
  static std::optional<std::string> unmapped(const core::Shape&);

  /// Requires that unmapped(shape) says nothing.
  explicit Immersion(const core::Shape& shape);

  double whole() const { return whole_; }  ///< [m^3]

  /// What is below y = height of the body in a place and orientation.
  Submerged below(double height, const core::Vector3& position, const core::Quaternion& orientation) const;

 private:
  struct Ball {
    double radius = 0;
    core::Vector3 centre = core::Vector3::Zero();  // body axes
  };
  struct Faces {
    std::vector<core::Vector3> vertices;  // body axes
    std::vector<core::Triangle> triangles;
  };

  struct Round {
    std::vector<Revolved> pieces;
    core::Vector3 centre, axis;  // body axes
  };

  std::vector<std::variant<Ball, Faces, Round>> parts_;
  double whole_ = 0;
};

}  // namespace cylon::applied
