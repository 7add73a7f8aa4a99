// The pair materials of a scene as a small table that a contact callback can look up in constant time.
#pragma once

#include "harness/core/scene.h"

#include <vector>

namespace cylon::simulators {

/// Surfaces that no material names are alike and share class 0; every surface that one names is a class
/// of its own.  A pair's material then depends on the two classes alone.
class Surfaces {
 public:
  struct Contact {
    double restitution = 0, friction = 0;
    bool stated = false;  ///< Whether the scene has a material for the pair.
  };

  explicit Surfaces(const core::Scene&);

  int of_body(std::size_t body) const { return body_class_[body]; }
  int of_plane(std::size_t plane) const { return plane_class_[plane]; }
  const Contact& between(int a, int b) const { return table_[index(a, b)]; }

 private:
  std::size_t index(int a, int b) const {
    return static_cast<std::size_t>(a) * classes_ + static_cast<std::size_t>(b);
  }

  std::size_t classes_ = 1;
  std::vector<int> body_class_, plane_class_;
  std::vector<Contact> table_;
};

}  // namespace cylon::simulators
