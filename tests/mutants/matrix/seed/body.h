// A body as the seed keeps it: position, momentum K, orientation, angular momentum L about its centre.
#pragma once

#include "harness/core/scene.h"
#include "tests/mutants/matrix/seed/faults.h"

namespace cylon::mutants::seed {

using core::Matrix3;
using core::Quaternion;
using core::Vector3;

struct Body {
  double m = 1, inv_m = 1;                                       // [kg]
  Matrix3 I = Matrix3::Identity(), inv_I = Matrix3::Identity();  // body axes [kg m^2]
  Vector3 p = Vector3::Zero(), K = Vector3::Zero(), L = Vector3::Zero();
  Quaternion q = Quaternion::Identity(), start = q;
  Vector3 F = Vector3::Zero(), tau = Vector3::Zero();
  Vector3 v = Vector3::Zero(), omega = Vector3::Zero();  // as last computed
  Vector3 centre = Vector3::Zero();  // of mass, from the origin of the scene's body axes, in those axes
  Vector3 turned = Vector3::Zero();  // sum of all turns (errata 19)
  double spin = 0;                   // |omega| at the start (errata 23)
  bool locked = false;
};

/// Eq. 74, errata 16-18.
Matrix3 matrix_of(const Quaternion&, Faults);

/// The orientation after a turn by the vector beta.  Eq. 73, 75-78, errata 6, 7, 12, 19-21, 45, 46.
void turn(Body&, const Vector3& beta, double t, Faults);

/// (R I R^T)^-1.  Eq. 72, errata 40, 42.
Matrix3 inverse_inertia(const Body&, Faults);

/// v = K / m, omega = I^-1 L.  Eq. 59, 60.
void update_velocities(Body&, Faults);

/// From the scene's body; composite shapes are assembled here.  Eq. 68-72, errata 9, 11, 15, 38, 39, 41,
/// 59-62.
Body make_body(const core::Body&, Faults);

}  // namespace cylon::mutants::seed
