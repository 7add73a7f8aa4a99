#include "engine/pile/spheres.h"

#include "engine/methods.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace cylon::engine::pile {
namespace {

Real radius_of(const Shape& shape) {
  const auto* sphere = std::get_if<Sphere>(&shape);
  return sphere ? sphere->radius : 0;
}

template <class T, class Allocator>
void take(std::vector<T, Allocator>& rows, const std::vector<int>& order, int stride) {
  std::vector<T, Allocator> old(rows);
  for (std::size_t k = 0; k < order.size(); ++k)
    std::copy_n(old.begin() + stride * order[k], stride, rows.begin() + stride * static_cast<int>(k));
}

// Every third bit.  Public domain bit trick; G. M. Morton, A computer oriented geodetic data base (1966).
std::uint64_t spaced(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

}  // namespace

bool only_spheres(const Model& model) {
  if (!missing(Method::sphere_steps, model).empty()) return false;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const bool ball = std::holds_alternative<Sphere>(model.shapes[i]) ||
                      std::holds_alternative<std::monostate>(model.shapes[i]);
    const Matrix3& k = body.inverse_inertia;
    const Real uneven = (k - k(0, 0) * Matrix3::Identity()).cwiseAbs().maxCoeff();
    if (!ball || (!body.locked && uneven > 8 * epsilon * k(0, 0))) return false;
  }
  return true;
}

Spheres::Spheres(const Model& model, int spare) : count(static_cast<int>(model.bodies.size())) {
  const std::size_t n = model.bodies.size(), rows = n + static_cast<std::size_t>(spare);
  velocity.assign(velocity_stride * rows, 0);
  before = kick = velocity;
  place.assign(place_stride * rows, 0);
  orientation.assign(place_stride * n, 0);
  inverse_radius.assign(n, 0);
  free_spin.assign(n, Vector3::Zero());
  surface = model.surfaces;
  filter = model.filters;
  id.resize(n);
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Body& body = model.bodies[k];
    const Motion& motion = model.motions[k];
    const Real r = radius_of(model.shapes[k]);
    const Vector3 speed = engine::velocity(body, motion), spin = angular_velocity(body, motion);
    for (int c = 0; c < 3; ++c) {
      v(i)[c] = speed[c];
      v(i)[c + 4] = r * spin[c];
      p(i)[c] = motion.position[c];
    }
    v(i)[3] = body.inverse_mass;
    v(i)[7] = r * r * body.inverse_inertia(0, 0);
    p(i)[3] = r;
    Real* q = orientation.data() + place_stride * i;
    q[0] = motion.orientation.w(), q[1] = motion.orientation.x();
    q[2] = motion.orientation.y(), q[3] = motion.orientation.z();
    inverse_radius[k] = r > 0 ? 1 / r : 0;
    if (r == 0) free_spin[k] = spin;
    id[k] = i;
  }
}

void Spheres::read(const std::vector<Body>& bodies, std::vector<Motion>& motions) const {
  motions.resize(bodies.size());
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Body& body = bodies[static_cast<std::size_t>(id[k])];
    const Real* q = orientation.data() + place_stride * i;
    motions[static_cast<std::size_t>(id[k])] =
        make_motion(body, Vector3(p(i)[0], p(i)[1], p(i)[2]), Quaternion(q[0], q[1], q[2], q[3]),
                    Vector3(v(i)[0], v(i)[1], v(i)[2]), spin(i));
  }
}

void Spheres::reorder(const std::vector<int>& order) {
  take(velocity, order, velocity_stride);
  take(kick, order, velocity_stride);
  take(place, order, place_stride);
  take(orientation, order, place_stride);
  take(inverse_radius, order, 1);
  take(free_spin, order, 1);
  take(surface, order, 1);
  if (!filter.empty()) take(filter, order, 1);
  take(id, order, 1);
}

std::vector<int> order_in_space(const Spheres& spheres, Real cell) {
  const int n = spheres.count;
  Vector3 low = Vector3::Zero();
  for (int i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) low[c] = i == 0 ? spheres.p(i)[c] : std::min(low[c], spheres.p(i)[c]);
  std::vector<std::pair<std::uint64_t, int>> keys(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    std::uint64_t key = 0;
    for (int c = 0; c < 3; ++c) {
      const Real at = std::min((spheres.p(i)[c] - low[c]) / cell, Real(1 << 20));  // a NaN stays below
      key |= spaced(at > 0 ? static_cast<std::uint64_t>(at) : 0) << c;
    }
    keys[static_cast<std::size_t>(i)] = {key, i};
  }
  std::stable_sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<int> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& key) { return key.second; });
  return order;
}

}  // namespace cylon::engine::pile
