#include "engine/pile/sphere_impact.h"

#include "engine/pile/islands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::engine::pile {
namespace {

// In each the time gains a factor of 2 u/(a s): a hundred where a body of 1 m/s falls for 2 ms.
constexpr int most_rounds = 8;

}  // namespace

Real time_of_contact(const Vector3& d, const Vector3& v, Real reach) {
  // (v.v) t^2 + 2 (d.v) t + c = 0, c = d.d - reach^2 in the form that does not cancel
  const Real b = d.dot(v), length = d.norm(), c = (length - reach) * (length + reach);
  const Real root = b * b - v.squaredNorm() * c;
  if (b >= 0 || root < 0) return -1;
  return c <= 0 ? 0 : c / (std::sqrt(root) - b);
}

SphereImpacts::SphereImpacts(const Model& model, int parts)
    : planes_(model.planes),
      gravity_(pressing_gravity(model)),
      parts_(static_cast<Real>(parts)),
      alone_(isolated(model)) {}

// From where the paths of both began, since: before that they were elsewhere.  Rows of places and velocities are those of
// now, of paths that are carried back there: a body is at p + t v + g t^2/2 and has v + g t.  Bodies with the same g move
// straight against each other; else with a between them, at a plane the gap is
//   gap + u s + a s^2/2,  s = t - since,  u and gap of since
// and of spheres |d + s (u + a s/2)| = reach, in rounds.  What moves apart at `since` and falls back within the step is left to
// the contact: else what rests would bounce for ever.
SphereImpacts::Meeting SphereImpacts::meeting(const Approaching& pair, const Spheres& spheres,
                                              Real span) const {
  using Row = Eigen::Map<const Vector3>;
  const bool plane = pair.b >= spheres.count;
  const Real *va = spheres.v(pair.a), *pa = spheres.p(pair.a);
  const Vector3 none = Vector3::Zero(), v_b = plane ? none : Vector3(Row(spheres.v(pair.b)));
  const Real inverse_b = plane ? 0 : spheres.v(pair.b)[3];
  const Vector3 pull = Row(spheres.g(pair.a)) - (plane ? none : Vector3(Row(spheres.g(pair.b))));
  Real since = since_[static_cast<std::size_t>(pair.a)];
  if (!plane) since = std::max(since, since_[static_cast<std::size_t>(pair.b)]);
  Meeting m;
  m.velocity = Row(va) - v_b;
  const Vector3 u = m.velocity + since * pull;
  Real t = 0;
  if (plane) {
    const Plane& ground = planes_[static_cast<std::size_t>(pair.b - spheres.count)];
    m.normal = ground.normal;
    const Real toward = -m.normal.dot(u), faster = -m.normal.dot(pull);
    if (toward <= 0) return {};
    const Real gap = m.normal.dot(Row(pa)) - ground.offset - pa[3] - since * (toward - faster * since / 2);
    t = since;
    if (gap > 0) {
      const Real root = toward * toward + 2 * faster * gap;
      if (root < 0) return {};  // gravity turns it back
      t += 2 * gap / (toward + std::sqrt(root));
    }
  } else {
    const Real reach = pa[3] + spheres.p(pair.b)[3];
    const Vector3 d = Row(pa) - Row(spheres.p(pair.b)) + since * (m.velocity + since / 2 * pull);
    Real s = time_of_contact(d, u, reach);
    for (int round = 0; round < most_rounds && s > 0 && !pull.isZero(0); ++round)
      s = time_of_contact(d, u + s / 2 * pull, reach);
    t = s >= 0 ? since + s : s;
    m.normal = d + s * (u + s / 2 * pull);
    const Real length = m.normal.norm();
    if (!(length > 0)) return {};  // centres on each other: no direction to part in
    m.normal /= length;
    // overlapping bodies as well meet in one point between their centres
    if (alone_ && reach > 0) m.lever = length / reach;
  }
  m.velocity += t * pull;
  // In the last part h the contact wants gap + h u >= 0 with u of its end, which is short of what the fall makes by g h^2/2.
  // Not to take that for an impact would let the contact swallow the speed.
  m.approach = -m.normal.dot(m.velocity);
  const Real last = span / parts_;
  const bool falls = plane || (va[3] == 0) != (inverse_b == 0);
  if (!(t >= 0 && (t <= span || (falls && (t - span) * m.approach <= gravity_ * last * last / 2)))) return {};
  // slower than the rounding of the velocities is rest
  if (m.approach <= 16 * epsilon * (Row(va).norm() + v_b.norm())) return {};
  // nor is what gravity brings: a contact takes that
  if (pair.material.restitution == 0 && m.approach <= 2 * gravity_ * span) return {};
  if (va[3] + inverse_b <= 0) return {};
  m.time = t;
  return m;
}

void SphereImpacts::strike(const Approaching& pair, const Meeting& m, Spheres& spheres, Time now,
                           std::vector<Impact>& impacts, std::vector<Contact>* contacts) {
  using Row = Eigen::Map<Vector3>;
  const bool plane = pair.b >= spheres.count;
  Real *va = spheres.v(pair.a), *pa = spheres.p(pair.a);
  Real* vb = plane ? nullptr : spheres.v(pair.b);
  const Vector3 s_b = plane ? Vector3(Vector3::Zero()) : Vector3(Row(vb + 4));
  const Real ima = va[3], imb = plane ? 0 : vb[3], ka = va[7], kb = plane ? 0 : vb[7];
  const Vector3& n = m.normal;
  const Vector3 u = m.velocity - (Vector3(Row(va + 4)) + s_b).cross(m.lever * n);
  const Real inverse = ima + imb, u_n = -m.approach, t = m.time;
  const Real normal = -(1 + pair.material.restitution) * u_n / inverse;
  Vector3 tangential = -(u - u_n * n) / (inverse + ka + kb);
  const Real limit = pair.material.friction * normal, length = tangential.norm();
  if (length > limit) tangential *= limit / length;
  const Vector3 impulse = normal * n + tangential, turn = m.lever * n.cross(tangential);

  const Vector3 g = Eigen::Map<const Vector3>(spheres.g(pair.a));
  const Vector3 point = Vector3(Row(pa)) + t * (Vector3(Row(va)) + t / 2 * g) - pa[3] * n;

  const auto change = [&](int i, Real sign) {
    Real *v = spheres.v(i), *p = spheres.p(i), *q = spheres.orientation.data() + place_stride * i;
    const Vector3 kick = sign * v[3] * impulse, spin = spheres.spin(i);
    Row(v) += kick, Row(v + 4) -= v[7] * turn;
    Row(p) -= t * kick;
    const Quaternion then = turned(turned({q[0], q[1], q[2], q[3]}, t * spin), -t * spheres.spin(i));
    q[0] = then.w(), q[1] = then.x(), q[2] = then.y(), q[3] = then.z();
    since_[static_cast<std::size_t>(i)] = t;
  };
  change(pair.a, 1);
  if (!plane) change(pair.b, -1);
  Impact impact;
  impact.time = now + static_cast<Time>(t);
  impact.body = spheres.id[static_cast<std::size_t>(pair.a)];
  if (plane)
    impact.plane = pair.b - spheres.count;
  else
    impact.other = spheres.id[static_cast<std::size_t>(pair.b)];
  impact.approach = -u_n, impact.separation = -pair.material.restitution * u_n;
  impacts.push_back(impact);
  if (contacts) contacts->push_back({impact.body, impact.other, impact.plane, point, n, normal, tangential});
}

bool SphereImpacts::resolve(const std::vector<Approaching>& pairs, Spheres& spheres, Time now, Time span,
                            std::vector<Impact>& impacts, std::vector<Contact>* contacts) {
  const Real h = static_cast<Real>(span), never = std::numeric_limits<Real>::max();
  since_.resize(static_cast<std::size_t>(spheres.count)), next_.resize(since_.size());
  time_.resize(pairs.size());
  const auto bodies = [&](const Approaching& pair) {
    const auto a = static_cast<std::size_t>(pair.a);
    return std::pair(a, pair.b < spheres.count ? static_cast<std::size_t>(pair.b) : a);
  };
  for (const Approaching& pair : pairs) {
    const auto [a, b] = bodies(pair);
    since_[a] = since_[b] = 0;
  }
  for (int sweep = 0; sweep < most_impact_sweeps; ++sweep) {
    // What touches already meets at once, one after another.
    bool any = false, later = false;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [a, b] = bodies(pairs[k]);
      const Meeting m = meeting(pairs[k], spheres, h);
      time_[k] = m.time;
      if (!(m.time >= 0)) continue;
      if (m.time == since_[a] && m.time == since_[b])
        strike(pairs[k], m, spheres, now, impacts, contacts), any = true;
      else
        later = true;
    }
    if (any) continue;
    if (!later) return true;
    // Nothing does: of what meets later, what both bodies meet first.
    for (const Approaching& pair : pairs) {
      const auto [a, b] = bodies(pair);
      next_[a] = next_[b] = never;
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (!(time_[k] >= 0)) continue;
      const auto [a, b] = bodies(pairs[k]);
      next_[a] = std::min(next_[a], time_[k]), next_[b] = std::min(next_[b], time_[k]);
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [a, b] = bodies(pairs[k]);
      if (!(time_[k] >= 0) || time_[k] > next_[a] || time_[k] > next_[b]) continue;
      strike(pairs[k], meeting(pairs[k], spheres, h), spheres, now, impacts, contacts);
      next_[a] = next_[b] = -1;  // the others look again
    }
  }
  return std::none_of(pairs.begin(), pairs.end(),
                      [&](const Approaching& pair) { return meeting(pair, spheres, h).time >= 0; });
}

}  // namespace cylon::engine::pile
