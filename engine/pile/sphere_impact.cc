#include "engine/pile/sphere_impact.h"

#include "engine/pile/islands.h"

#include <cmath>
#include <limits>

namespace cylon::engine::pile {

Real time_of_contact(const Vector3& d, const Vector3& v, Real reach) {
  // (v.v) t^2 + 2 (d.v) t + c = 0, c = d.d - reach^2 in the form that does not cancel
  const Real b = d.dot(v), length = d.norm(), c = (length - reach) * (length + reach);
  const Real root = b * b - v.squaredNorm() * c;
  if (b >= 0 || root < 0) return -1;
  return c <= 0 ? 0 : c / (std::sqrt(root) - b);
}

SphereImpacts::SphereImpacts(const Model& model)
    : planes_(model.planes), gravity_(model.forces.gravity.norm()), alone_(isolated(model)) {}

bool SphereImpacts::strike(const Approaching& pair, Real& since, Spheres& spheres, Time now, Time span,
                           std::vector<Impact>& impacts, std::vector<Contact>* contacts) const {
  using Row = Eigen::Map<Vector3>;
  const bool plane = pair.b >= spheres.count;
  Real *va = spheres.v(pair.a), *pa = spheres.p(pair.a);
  Real* vb = plane ? nullptr : spheres.v(pair.b);
  const Vector3 zero = Vector3::Zero();
  const Vector3 v_b = plane ? zero : Vector3(Row(vb)), s_b = plane ? zero : Vector3(Row(vb + 4));
  const Vector3 v = Row(va) - v_b;
  const Real ima = va[3], imb = plane ? 0 : vb[3], ka = va[7], kb = plane ? 0 : vb[7];
  Vector3 n;
  Real t = 0, lever = 1;
  if (plane) {
    const Plane& ground = planes_[static_cast<std::size_t>(pair.b - spheres.count)];
    n = ground.normal;
    const Real gap = n.dot(Row(pa)) - ground.offset - pa[3], approach = -n.dot(v);
    if (approach <= 0) return false;
    t = gap > 0 ? gap / approach : 0;
  } else {
    const Vector3 d = Row(pa) - Row(spheres.p(pair.b));
    t = time_of_contact(d + since * v, v, pa[3] + spheres.p(pair.b)[3]);
    if (t >= 0) t += since;
    n = d + t * v;
    const Real length = n.norm();
    if (!(length > 0)) return false;  // centres on each other: no direction to part in
    n /= length;
    // overlapping bodies as well meet in one point between their centres
    const Real reach = pa[3] + spheres.p(pair.b)[3];
    if (alone_ && reach > 0) lever = length / reach;
  }
  // What gravity adds within the step may bring them together a little earlier than the straight path does;
  // not to take that for an impact would let the contact swallow their speed.
  const Real h = static_cast<Real>(span), approach = -n.dot(v);
  const bool falls = plane || (va[3] == 0) != (vb[3] == 0);
  if (!(t >= 0 && (t <= h || (falls && (t - h) * approach <= gravity_ * h * h)))) return false;

  const Vector3 u = v - (Vector3(Row(va + 4)) + s_b).cross(lever * n);
  const Real u_n = n.dot(v);
  // slower than the rounding of the velocities is rest
  if (u_n >= -16 * std::numeric_limits<Real>::epsilon() * (Row(va).norm() + v_b.norm())) return false;
  const Real inverse = ima + imb;
  if (inverse <= 0) return false;
  const Real normal = -(1 + pair.material.restitution) * u_n / inverse;
  Vector3 tangential = -(u - u_n * n) / (inverse + ka + kb);
  const Real limit = pair.material.friction * normal, length = tangential.norm();
  if (length > limit) tangential *= limit / length;
  const Vector3 impulse = normal * n + tangential, turn = lever * n.cross(tangential);

  const Vector3 point = Vector3(Row(pa)) + t * Vector3(Row(va)) - pa[3] * n;

  Row(va) += ima * impulse, Row(va + 4) -= ka * turn;
  Row(pa) -= t * ima * impulse;
  if (!plane) {
    Row(vb) -= imb * impulse, Row(vb + 4) -= kb * turn;
    Row(spheres.p(pair.b)) += t * imb * impulse;
  }
  Impact impact;
  impact.time = now + static_cast<Time>(t);
  impact.body = spheres.id[static_cast<std::size_t>(pair.a)];
  if (plane)
    impact.plane = pair.b - spheres.count;
  else
    impact.other = spheres.id[static_cast<std::size_t>(pair.b)];
  impact.approach = -u_n, impact.separation = -pair.material.restitution * u_n;
  impacts.push_back(impact);
  if (contacts) contacts->push_back({impact.body, impact.other, impact.plane, point, n, normal});
  if (alone_) since = t;  // the path before it is not one that they took
  return true;
}

void SphereImpacts::resolve(const std::vector<Approaching>& pairs, Spheres& spheres, Time now, Time span,
                            std::vector<Impact>& impacts, std::vector<Contact>* contacts) {
  since_.assign(pairs.size(), 0);
  for (int sweep = 0; sweep < 64; ++sweep) {
    bool any = false;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      any |= strike(pairs[k], since_[k], spheres, now, span, impacts, contacts);
    if (!any) return;
  }
}

}  // namespace cylon::engine::pile
