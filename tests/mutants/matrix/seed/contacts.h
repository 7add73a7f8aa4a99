// Where bodies touch, and what the blow does to them.
#pragma once

#include "tests/mutants/matrix/seed/body.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::mutants::seed {

/// Of a pair that may touch: the point, from both centres, and the normal, towards `a`.
struct Contact {
  int a = 0, b = core::world, plane = -1;
  double gap = 0;  ///< [m]
  Vector3 n = Vector3::UnitY(), ra = Vector3::Zero(), rb = Vector3::Zero();
  double c = 0, mu = 0;  ///< Restitution, friction.
  double radius = 0;     ///< Of a, where it is a sphere [m].
};

/// One contact per pair; spheres stand first.  Throws std::invalid_argument for a pair of shapes that this
/// engine does not have.
std::vector<Contact> contacts_of(const core::Scene&);

/// Gaps, normals and points; of a box on a plane the middle of the vertices that are lowest within 1e-9 m.
/// Errata 34, 35.
void update_contacts(const core::Scene&, const std::vector<Body>&, Faults, std::vector<Contact>&);

/// v_n of the contact point, a against b [m/s]; < 0: closing.  Eq. 66, errata 14, 29.
double closing(const Contact&, const std::vector<Body>&, Faults);

/// Eq. 85-97, errata 24-33, 52-58.  `restitution` replaces c.
void collide(const Contact&, double restitution, double dt, std::vector<Body>&, Faults);

/// What this engine cannot do of a scene's contacts and joints.
std::optional<std::string> missing_contact(const core::Scene&);

}  // namespace cylon::mutants::seed
