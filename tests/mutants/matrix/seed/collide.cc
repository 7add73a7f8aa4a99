#include "tests/mutants/matrix/seed/contacts.h"

#include <algorithm>
#include <cmath>

namespace cylon::mutants::seed {
namespace {

// What an impulse at the contact does to one side; a plane has none.
struct Side {
  Body* body = nullptr;
  Vector3 r = Vector3::Zero();
  double inv_m = 0;
  Matrix3 inv_I = Matrix3::Zero();
};

Side side_of(int index, const Vector3& r, std::vector<Body>& bodies, Faults faulty) {
  if (index == core::world) return {};
  Body& body = bodies[static_cast<std::size_t>(index)];
  if (body.locked && !faulty(57)) return {};
  return {&body, r, body.inv_m, inverse_inertia(body, faulty)};
}

Vector3 point_velocity(int index, const Vector3& r, const std::vector<Body>& bodies, bool unrotated,
                       Faults faulty) {
  if (index == core::world) return Vector3::Zero();
  const Body& body = bodies[static_cast<std::size_t>(index)];
  const Vector3 arm = unrotated ? Vector3(matrix_of(body.q, faulty).transpose() * r) : r;
  return body.inv_m * body.K + (inverse_inertia(body, faulty) * body.L).cross(arm);
}

Vector3 contact_velocity(const Contact& c, const std::vector<Body>& bodies, Faults faulty) {
  const bool unrotated = c.plane >= 0 ? faulty(14) : faulty(29);
  return point_velocity(c.a, c.ra, bodies, unrotated, faulty) -
         point_velocity(c.b, c.rb, bodies, unrotated, faulty);
}

// Velocity that an impulse J gives to the side's point: J/m + (I^-1 (r x J)) x r, the bracket of eq. 92.
Vector3 answer(const Side& s, const Vector3& J, Faults faulty) {
  const Vector3 turning =
      faulty(28) ? Vector3(s.inv_I * s.r.cross(J).cross(s.r)) : Vector3((s.inv_I * s.r.cross(J)).cross(s.r));
  return s.inv_m * J + turning;
}

struct Pair {
  Side a, b;
  Vector3 answer(const Vector3& J, Faults faulty) const {
    return seed::answer(a, J, faulty) + seed::answer(b, J, faulty);
  }
};

// The impulse that leaves u_n' = -c u_n and no slip, or Coulomb's slip: |J_t| = mu J_n against the slip that
// is left, found by iteration (one round where the slip only slows).
Vector3 coulomb(const Pair& pair, const Vector3& n, const Vector3& u, double c, double mu, Faults faulty) {
  const double un = n.dot(u);
  Matrix3 M;
  for (int i = 0; i < 3; ++i) M.col(i) = pair.answer(Vector3::Unit(i), faulty);
  if (mu > 0) {
    const Vector3 stick = M.inverse() * (-c * un * n - u);
    const double normal = n.dot(stick);
    if (normal >= 0 && (stick - normal * n).norm() <= mu * normal) return stick;
  }
  Vector3 J = Vector3::Zero();
  Vector3 slip = u - un * n;
  for (int round = 0; round < 50; ++round) {
    const Vector3 s = slip.norm() > 0 && mu > 0 ? Vector3(slip.normalized()) : Vector3(Vector3::Zero());
    const Vector3 direction = n - mu * s;
    J = -(1 + c) * un / n.dot(M * direction) * direction;
    const Vector3 left = u + M * J, next = left - n.dot(left) * n;
    if ((next.normalized() - s).norm() < 1e-14) break;
    slip = next;
  }
  return J;
}

// Eq. 92 and 93 as they are, each for itself (errata 32).
Vector3 uncoupled(const Pair& pair, const Vector3& n, const Vector3& u, double c, double mu, Faults faulty) {
  const Vector3 normal = -(1 + c) * n.dot(u) / n.dot(pair.answer(n, faulty)) * n;
  const Vector3 slip = u - n.dot(u) * n;
  if (slip.norm() == 0) return normal;
  const Vector3 t = slip.normalized();
  const double stop = slip.norm() / t.dot(pair.answer(t, faulty));
  return normal - std::min(stop, mu * normal.norm()) * t;
}

// Eq. 93 as printed: c_f is a restitution along the slip (errata 31).
Vector3 tangential_restitution(const Pair& pair, const Vector3& n, const Vector3& u, double c, double cf,
                               Faults faulty) {
  const Vector3 slip = u - n.dot(u) * n;
  Vector3 J = -(1 + c) * n.dot(u) / n.dot(pair.answer(n, faulty)) * n;
  if (slip.norm() > 0) {
    const Vector3 t = slip.normalized();
    J -= (1 + cf) * slip.norm() / t.dot(pair.answer(t, faulty)) * t;
  }
  return J;
}

Vector3 impulse(const Contact& c, const Pair& pair, const Vector3& u, double e, Faults faulty) {
  const bool bodies = c.plane < 0;
  const double m_red = 1 / (pair.a.inv_m + pair.b.inv_m);
  if (bodies && faulty(58)) return Vector3::Zero();       // (v_cB - v_cB)
  if (!bodies && faulty(26)) return Vector3::Zero();      // lim m_A -> infinity
  if (bodies && faulty(24)) return -(1 + e) * m_red * u;  // eq. 90: the whole vector
  if (bodies && faulty(55)) return -(1 + e) * m_red * u;  // the same in All2All
  if (bodies && faulty(54)) return -e * m_red * c.n.dot(u) * c.n;
  const double mu = faulty(30) ? 0 : c.mu;  // t orthogonal to the slip: nothing to stop
  if (faulty(31) && c.mu > 0) return tangential_restitution(pair, c.n, u, e, mu, faulty);
  if (faulty(32)) return uncoupled(pair, c.n, u, e, mu, faulty);
  const Vector3 J = coulomb(pair, c.n, u, e, mu, faulty);
  return bodies && faulty(27) ? Vector3(-J) : J;
}

void push(const Side& side, const Vector3& J, double dt, bool pair, Faults faulty) {
  if (!side.body) return;
  side.body->K += pair && faulty(25) ? Vector3(J * side.inv_m) : J;
  side.body->L += side.r.cross(J) * (faulty(33) ? dt : 1);
}

// PlaneConstraint: the normal part on K alone, and L set to what a rolling hoop has (errata 52, 53).
void seed_plane(const Contact& c, double e, Body& body, bool promoted) {
  const double along = c.n.dot(body.K);
  const Vector3 n = -c.n;  // the seed's normal points into the plane
  const Vector3 left = body.K - (promoted ? Vector3(-along, 0, 0) : Vector3(along * c.n));
  body.L = n.dot(body.L) * n - c.radius * n.cross(left);
  if (along < 0) body.K -= (1 + e) * along * c.n;
}

}  // namespace

double closing(const Contact& c, const std::vector<Body>& bodies, Faults faulty) {
  return c.n.dot(contact_velocity(c, bodies, faulty));
}

void collide(const Contact& c, double restitution, double dt, std::vector<Body>& bodies, Faults faulty) {
  if (c.plane >= 0 && (faulty(52) || faulty(53)))
    return seed_plane(c, restitution, bodies[static_cast<std::size_t>(c.a)], faulty(52));
  const Pair pair{side_of(c.a, c.ra, bodies, faulty), side_of(c.b, c.rb, bodies, faulty)};
  const Vector3 J = impulse(c, pair, contact_velocity(c, bodies, faulty), restitution, faulty);
  const int times =
      c.plane < 0 && faulty(56) ? 2 : 1;  // (A, B) and (B, A), both with the velocities of before
  for (int i = 0; i < times; ++i) {
    push(pair.a, J, dt, c.plane < 0, faulty);
    push(pair.b, -J, dt, c.plane < 0, faulty);
  }
  if (faulty(36) && pair.a.body) pair.a.body->p -= c.ra;  // "penetration p - q", p the centre
}

}  // namespace cylon::mutants::seed
