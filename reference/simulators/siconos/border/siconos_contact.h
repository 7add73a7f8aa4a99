// The distance of a sphere from what it may touch, as a relation of Siconos: NewtonEuler3DR with friction, NewtonEuler1DR
// without.  Included on this side of the border only.
#pragma once

#include "reference/simulators/siconos/border/siconos_headers.h"
#include "reference/simulators/siconos/border/siconos_world.h"

#include <cmath>

namespace cylon::simulators::siconos_border {

inline void store(const Vector& v, SiconosVector& out) {
  for (unsigned k = 0; k < 3; ++k) out.setValue(k, v[k]);
}
inline Vector vector(const SiconosVector& v, unsigned from = 0) {
  return {v.getValue(from), v.getValue(from + 1), v.getValue(from + 2)};
}
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
/// a + s b
inline Vector along(const Vector& a, double s, const Vector& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

template <class Relation>
class SphereContact final : public Relation {
 public:
  explicit SphereContact(const Contact& contact) : contact_(contact) {}

  //   of a plane   gap = n . x - offset - r
  //   of a sphere  gap = |x - c| - r - r',  n = (x - c)/|x - c|
  void computeh(double /*time*/, const BlockVector& q, SiconosVector& y) override {
    const Vector x = vector(*q.getAllVect()[0]);
    Vector normal = contact_.place;
    double height = 0;  // of the centre above the partner's surface
    if (contact_.partner == Partner::plane) {
      height = dot(normal, x) - contact_.measure;
    } else {
      const Vector c =
          contact_.partner == Partner::moving_sphere ? vector(*q.getAllVect()[1]) : contact_.place;
      const Vector d = along(x, -1, c);
      const double distance = std::sqrt(dot(d, d));
      normal = {0, 1, 0};  // of two centres in one place
      if (distance > 0) normal = along({0, 0, 0}, 1 / distance, d);
      height = distance - contact_.measure;
    }
    store(along(x, -contact_.radius, normal), *this->_Pc1);
    store(along(x, -height, normal), *this->_Pc2);
    store(normal, *this->_Nc);
    y.setValue(0, height - contact_.radius);
  }

  /// Of the last step, from its impulse in the axes of the contact.
  Pressed pressed(const SiconosVector& impulse) const {
    Pressed one;
    one.point = vector(*this->_Pc1), one.normal = vector(*this->_Nc);
    one.along = impulse.getValue(0);
    for (unsigned row = 1; row < impulse.size(); ++row)
      for (unsigned k = 0; k < 3; ++k)
        one.across[k] += impulse.getValue(row) * this->_rotationAbsoluteToContactFrame->getValue(row, k);
    return one;
  }

 private:
  Contact contact_;
};

}  // namespace cylon::simulators::siconos_border
