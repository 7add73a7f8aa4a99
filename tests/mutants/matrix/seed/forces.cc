#include "tests/mutants/matrix/seed/forces.h"

#include "harness/core/overloaded.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace cylon::mutants::seed {
namespace {

struct End {
  Vector3 arm, place, velocity;  // world axes
};

End end_of(const std::vector<Body>& bodies, int index, const Vector3& anchor, const Instant& now,
           Faults faulty) {
  if (index == core::world) return {anchor, anchor, Vector3::Zero()};
  const Body& body = bodies[static_cast<std::size_t>(index)];
  if (faulty(67) && now.first) return {anchor, anchor, body.v};  // vertices of before p and R were set
  const Vector3 arm = matrix_of(body.q, faulty) * (anchor - body.centre);
  return {arm, body.p + arm, body.v + body.omega.cross(faulty(8) ? anchor : arm)};
}

// Errata 38: the constructor sets m = 1 and 1/m from its argument.
double weight_mass(const Body& body, Faults faulty) { return faulty(38) ? 1 : body.m; }

void gravity(const core::Scene& scene, std::vector<Body>& bodies, Faults faulty) {
  const double factor = faulty(3) ? 9.8 / 9.81 : 1;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies[i].F += weight_mass(bodies[i], faulty) * factor * core::gravity_of(scene, scene.bodies[i]);
}

// kappa (|d| - L) d/|d|, eq. 19, and damping along d.
void spring(const core::Spring& s, std::vector<Body>& bodies, const Instant& now, Faults faulty) {
  const End a = end_of(bodies, s.body, s.anchor, now, faulty),
            b = end_of(bodies, s.to, s.to_anchor, now, faulty);
  const bool pinned = s.to == core::world;
  const Vector3 d = pinned && faulty(47) ? Vector3(a.place - b.place) : Vector3(b.place - a.place);
  const double n = d.norm();
  if (n == 0 && !(pinned && faulty(48))) return;
  const Vector3 along =
      pinned && faulty(5) ? Vector3(b.place / n) : Vector3(d / n);  // q - p_q with p_q unset
  const double stretching = along.dot(b.velocity - a.velocity);
  const Vector3 F = (s.stiffness * (n - s.rest_length) + s.damping * stretching) * along;
  const auto add = [&](int index, const Vector3& arm, const Vector3& force) {
    if (index == core::world) return;
    Body& body = bodies[static_cast<std::size_t>(index)];
    body.F += force, body.tau += arm.cross(force);
  };
  add(s.body, a.arm, F);
  add(s.to, b.arm, -F);
}

void drag(const core::Drag& d, std::vector<Body>& bodies, const Instant& now, Faults faulty) {
  Body& body = bodies[static_cast<std::size_t>(d.body)];
  body.F -= d.linear * body.v * (faulty(49) ? now.dt : 1);
  body.tau -= d.angular * body.omega + d.momentum * body.L;
}

// dK/dt = F + mdot v_exchanged, eq. 12 with errata 2.
void thrust(const core::Thrust& t, std::vector<Body>& bodies, Faults faulty) {
  Body& body = bodies[static_cast<std::size_t>(t.body)];
  const Matrix3 R = matrix_of(body.q, faulty);
  if (faulty(64)) {
    body.K = R * t.force;  // the callback of the airplane
  } else {
    body.F += R * t.force;
  }
  if (faulty(2)) return;
  if (t.exhaust_velocity) body.F += t.mass_rate * (body.v + R * *t.exhaust_velocity);
  if (t.exchanged_velocity) body.F += t.mass_rate * *t.exchanged_velocity;
}

void attraction(const core::Attraction& a, std::vector<Body>& bodies) {
  Body &one = bodies[static_cast<std::size_t>(a.body)], &two = bodies[static_cast<std::size_t>(a.to)];
  const Vector3 d = two.p - one.p;
  const Vector3 F = a.strength * one.m * two.m / (d.squaredNorm() * d.norm()) * d;
  one.F += F, two.F -= F;
}

double surface(const core::Water& w, const Vector3& p, double t) {
  const double i = std::trunc((p.x() + 5) / 0.25), j = std::trunc((p.z() + 5) / 0.25);
  return w.level + w.wave / 2 * std::sin(w.speed * t + i) + w.wave / 2 * std::sin(0.5 * i * j);
}

void water(const core::Water& w, std::vector<Body>& bodies, const Instant& now, Faults faulty) {
  for (Body& body : bodies) {
    if (body.p.y() >= surface(w, body.p, now.t)) continue;
    const double lift = faulty(51) ? 1 : w.buoyancy, resistance = faulty(51) ? 2 : w.drag;
    body.F += (Vector3(0, lift, 0) - resistance * body.v) * (faulty(50) ? now.dt : 1);
    body.tau -= body.L;
  }
}

}  // namespace

void apply_forces(const core::Scene& scene, std::vector<Body>& bodies, const Instant& now, Faults faulty) {
  for (Body& body : bodies) body.F.setZero(), body.tau.setZero();
  gravity(scene, bodies, faulty);
  for (const core::Force& force : scene.forces)
    std::visit(core::Overloaded{[](const core::UniformGravity&) {},
                                [&](const core::Spring& s) { spring(s, bodies, now, faulty); },
                                [&](const core::Drag& d) { drag(d, bodies, now, faulty); },
                                [&](const core::Thrust& t) { thrust(t, bodies, faulty); },
                                [&](const core::Drive& d) {
                                  bodies[static_cast<std::size_t>(d.body)].F +=
                                      std::cos(d.frequency * now.t) * d.force;
                                },
                                [&](const core::Attraction& a) { attraction(a, bodies); },
                                [&](const core::Water& w) { water(w, bodies, now, faulty); },
                                [](const core::PluginForce&) {}},  // missing_force()
               force);
  if (!faulty(22)) return;  // "sum F = 0", whatever acts from outside
  Vector3 sum = Vector3::Zero();
  for (const Body& body : bodies) sum += body.F;
  for (Body& body : bodies) body.F -= sum / static_cast<double>(bodies.size());
}

void update_masses(const core::Scene& scene, std::vector<Body>& bodies, double t) {
  for (const core::Force& force : scene.forces)
    if (const auto* thrust = std::get_if<core::Thrust>(&force); thrust && thrust->mass_rate != 0) {
      const auto i = static_cast<std::size_t>(thrust->body);
      bodies[i].m = scene.bodies[i].mass + thrust->mass_rate * t;
      bodies[i].inv_m = 1 / bodies[i].m;
    }
}

void heights_over_water(const core::Scene& scene, const std::vector<Body>& bodies, double t,
                        std::vector<double>& heights) {
  heights.clear();
  for (const core::Force& force : scene.forces)
    if (const auto* w = std::get_if<core::Water>(&force))
      for (const Body& body : bodies) heights.push_back(body.p.y() - surface(*w, body.p, t));
}

std::optional<std::string> missing_force(const core::Scene& scene) {
  if (core::has_plugin_force(scene)) return "forces of plug-ins";
  for (const core::Force& force : scene.forces)
    if (const auto* w = std::get_if<core::Water>(&force); w && w->mode != "step")
      return "water by displaced volume";
  return std::nullopt;
}

}  // namespace cylon::mutants::seed
