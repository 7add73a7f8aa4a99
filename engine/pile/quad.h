// A vector in one register: x, y, z and a fourth number that stays zero.
#pragma once

#include "engine/vector.h"

namespace cylon::engine::pile {

using Quad = Real __attribute__((vector_size(4 * sizeof(Real))));

[[gnu::always_inline]] inline Quad quad(const Vector3& v) { return Quad{v.x(), v.y(), v.z(), 0}; }
[[gnu::always_inline]] inline Vector3 vector(const Quad& q) { return {q[0], q[1], q[2]}; }

[[gnu::always_inline]] inline Real dot(const Quad& a, const Quad& b) {
  const Quad p = a * b;
  return p[0] + p[1] + p[2];
}

[[gnu::always_inline]] inline Quad cross(const Quad& a, const Quad& b) {
  const Quad a_yzx = __builtin_shufflevector(a, a, 1, 2, 0, 3),
             b_yzx = __builtin_shufflevector(b, b, 1, 2, 0, 3);
  const Quad c = a * b_yzx - a_yzx * b;  // z, x, y
  return __builtin_shufflevector(c, c, 1, 2, 0, 3);
}

/// A matrix by its columns.
struct QuadMatrix {
  Quad x, y, z;

  [[gnu::always_inline]] Quad operator*(const Quad& v) const { return x * v[0] + y * v[1] + z * v[2]; }
};

inline QuadMatrix quads(const Matrix3& m) { return {quad(m.col(0)), quad(m.col(1)), quad(m.col(2))}; }

}  // namespace cylon::engine::pile
