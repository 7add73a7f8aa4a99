// Two smooth spheres in free flight: at most one collision, impulse along the line of centres.
//
//     contact   |d + w t| = R, the smaller root;  d = pB - pA, w = vB - vA, R = rA + rB
//     vA += mB/(mA + mB) (1 + e) (w.n) n,   vB -= mA/(mA + mB) (1 + e) (w.n) n,   n = (d + w t)/R
//
// Uniform gravity moves both alike and leaves d and w alone.  Domain: two colliding spheres that start apart,
// no plane, no friction, steady spins.
#include "reference/exact/domain.h"
#include "reference/exact/flight.h"
#include "reference/exact/solutions.h"

#include <limits>
#include <optional>

namespace cylon::exact {
namespace {

constexpr auto name = "two_sphere_oblique";
constexpr double eps = std::numeric_limits<double>::epsilon();

struct Collision {
  Wide time = std::numeric_limits<Wide>::infinity();
  WideVector kick_a = WideVector::Zero(), kick_b = WideVector::Zero();  // velocity changes
  Wide separation = 0;
  Wide grazing = 1;  // 1/cos of the angle between w and n: what roundings of d are multiplied by
};

Collision collide(const core::Scene& scene, Wide radii, Wide restitution) {
  const core::Body &a = scene.bodies[0], &b = scene.bodies[1];
  const WideVector d = widen(b.initial.position) - widen(a.initial.position);
  const WideVector w = widen(b.initial.velocity) - widen(a.initial.velocity);
  // w^2 t^2 + 2 (d.w) t + d^2 - R^2 = 0, the discriminant as R^2 w^2 - |d x w|^2.
  const Wide closing = -d.dot(w);
  const Wide discriminant = radii * radii * w.squaredNorm() - d.cross(w).squaredNorm();
  if (closing <= 0 || discriminant <= 0) return {};
  Collision hit;
  hit.time = std::max<Wide>(0, d.squaredNorm() - radii * radii) / (closing + std::sqrt(discriminant));
  const WideVector n = (d + w * hit.time).normalized();
  const Wide approach = w.dot(n);  // < 0
  const Wide mass_a = a.mass, mass_b = b.mass;
  const WideVector kick = (1 + restitution) * approach / (mass_a + mass_b) * n;
  hit.kick_a = mass_b * kick;
  hit.kick_b = -mass_a * kick;
  hit.separation = -restitution * approach;
  hit.grazing = w.norm() / -approach;
  return hit;
}

struct Smooth {
  Flight flight;
  Wide time;
  WideVector kick;

  WideState at(Wide t) const {
    WideState s = flight.at(t);
    if (t >= time) {
      s.position += kick * (t - time);
      s.velocity += kick;
    }
    return s;
  }
};

}  // namespace

core::Truth two_sphere_oblique(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  if (scene.bodies.size() != 2) refuse(name, "the scene must have two bodies");
  if (!scene.planes.empty()) refuse(name, "the scene has a plane, '" + scene.planes.front().name + "'");
  const Wide radii = Wide(colliding_radius(name, scene, 0)) + Wide(colliding_radius(name, scene, 1));
  for (int i : {0, 1}) check_steady_spin(name, scene, i, horizon);
  const core::Pair pair = {0, 1, -1};
  check_meets(name, scene, core::ContactRules(scene), pair);
  const auto material = core::material_of(scene, pair);
  if (!material) refuse(name, "no material is given for the two bodies");
  if (material->friction != 0) refuse(name, "the spheres must be smooth; friction is not zero");

  const core::BodyState &a = scene.bodies[0].initial, &b = scene.bodies[1].initial;
  const double distance = (b.position - a.position).norm(), speed = (b.velocity - a.velocity).norm();
  const double contact = static_cast<double>(radii);
  if (distance < contact * (1 - 1e-12)) refuse(name, "the spheres overlap at the start");

  const core::Vector3 g = common_gravity(scene);
  const Collision hit = collide(scene, radii, material->restitution);
  core::Truth truth;
  truth.state = together(
      std::vector<Smooth>{{Flight(a, g), hit.time, hit.kick_a}, {Flight(b, g), hit.time, hit.kick_b}});
  truth.horizon = horizon;
  truth.source = "Landau & Lifshitz, Mechanics, section 17; Newton's restitution along the line of centres";

  // Roundings eps of what enters move p and v by eps times their terms; of d, w and R the contact point by
  // eps D/cos(a), with D the path and a the angle of incidence, so the normal turns by that over R, and the
  // velocities after by |w| (1 + e) times that turn (velocities: away from the collision by `time`).
  const double reach = std::max(a.position.norm(), b.position.norm());
  const double fast = std::max(a.velocity.norm(), b.velocity.norm()) + g.norm() * horizon;
  const double spin = std::max(a.angular_velocity.norm(), b.angular_velocity.norm());
  truth.error = {.position = 8 * eps * (reach + 2 * fast * horizon),
                 .velocity = 8 * eps * fast,
                 .orientation = 8 * eps * (1 + spin * horizon),
                 .angular_velocity = 8 * eps * spin,
                 .time = 0};
  if (hit.time <= horizon) {
    const double shift = 8 * eps * static_cast<double>(hit.grazing) * (reach + distance + contact);
    truth.error.time = shift / speed;
    truth.error.velocity += 2 * speed * (8 * eps + shift / contact);
    truth.error.position += 2 * speed * (truth.error.time + horizon * (8 * eps + shift / contact));
    if (hit.separation > 0) {
      truth.events = {{.kind = core::EventKind::bounce,
                       .pair = pair,
                       .index = 1,
                       .time = static_cast<double>(hit.time),
                       .speed = static_cast<double>(hit.separation),
                       .height = 0}};
    }
  }
  return truth;
}

}  // namespace cylon::exact
