// Every force of a scene, as core/scene.h defines it.
#include "reference/certified/builder.h"

namespace cylon::certified {
namespace {

// A point of a body, or of the world.
struct Point {
  Vector position, velocity;
};

Point point_of(const Builder& b, const std::vector<Motion>& motions, int body, const core::Vector3& anchor) {
  if (body == core::world) return {b.vector(anchor), b.zero()};
  const Motion& m = motions[static_cast<std::size_t>(body)];
  const Vector arm = b.vector(anchor);
  return {m.position + m.rotation * arm, m.velocity + m.rotation * cross(m.spin, arm)};
}

void pull(const Builder& b, std::vector<Motion>& motions, int body, const core::Vector3& anchor,
          const Vector& force) {
  if (body == core::world) return;
  Motion& m = motions[static_cast<std::size_t>(body)];
  m.force = m.force + force;
  if (!anchor.isZero(0)) m.torque = m.torque + cross(b.vector(anchor), transposed(m.rotation) * force);
}

// F = (k (1 - L/|d|) + c d.d'/|d|^2) d; without rest length and damping it is linear and needs no |d|.
void add(const Builder& b, const core::Spring& s, std::vector<Motion>& motions) {
  const Point from = point_of(b, motions, s.body, s.anchor), to = point_of(b, motions, s.to, s.to_anchor);
  const Vector d = to.position - from.position;
  const Expr square = dot(d, d);
  Expr factor = b.number(s.stiffness);
  if (s.rest_length != 0) factor = factor * (b.exact(1) - b.number(s.rest_length) / sqrt(square));
  if (s.damping != 0) factor = factor + b.number(s.damping) * dot(d, to.velocity - from.velocity) / square;
  const Vector force = factor * d;
  pull(b, motions, s.body, s.anchor, force);
  pull(b, motions, s.to, s.to_anchor, -force);
}

void add(const Builder& b, const core::UniformGravity& g, std::vector<Motion>& motions) {
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (!b.scene.bodies[i].gravity)
      motions[i].force = motions[i].force + b.bodies[i].mass * b.vector(g.acceleration);
}

void add(const Builder& b, const core::Drag& drag, std::vector<Motion>& motions) {
  const auto body = static_cast<std::size_t>(drag.body);
  Motion& m = motions[body];
  m.force = m.force - b.number(drag.linear) * m.velocity;
  m.torque = m.torque - b.number(drag.angular) * m.spin -
             b.number(drag.momentum) * (b.bodies[body].inertia * m.spin);
}

// m v' = F + (dm/dt) (velocity of what comes or goes - v); it does so at the centre and leaves the inertia
// alone.
void add(const Builder& b, const core::Thrust& t, std::vector<Motion>& motions) {
  Motion& m = motions[static_cast<std::size_t>(t.body)];
  m.force = m.force + m.rotation * b.vector(t.force);
  const Expr rate = b.number(t.mass_rate);
  if (t.exhaust_velocity) m.force = m.force + rate * (m.rotation * b.vector(*t.exhaust_velocity));
  if (t.exchanged_velocity) m.force = m.force + rate * (b.vector(*t.exchanged_velocity) - m.velocity);
}

void add(const Builder& b, const core::Drive& d, std::vector<Motion>& motions) {
  Motion& m = motions[static_cast<std::size_t>(d.body)];
  const Expr wave{&b.graph, b.graph.cosine(b.numbers(d.frequency))};
  m.force = m.force + wave * b.vector(d.force);
}

void add(const Builder& b, const core::Attraction& a, std::vector<Motion>& motions) {
  const auto i = static_cast<std::size_t>(a.body), j = static_cast<std::size_t>(a.to);
  const Vector d = motions[j].position - motions[i].position;
  const Expr square = dot(d, d);
  const Vector force =
      (b.number(a.strength) * b.bodies[i].mass * b.bodies[j].mass / (square * sqrt(square))) * d;
  motions[i].force = motions[i].force + force;
  motions[j].force = motions[j].force - force;
}

void add(const Builder&, const core::Water&, std::vector<Motion>&) {
  refuse("water has a surface, which is no smooth law");
}

void add(const Builder&, const core::PluginForce&, std::vector<Motion>&) {
  refuse("the law of a plug-in is code, and no formula");
}

}  // namespace

void add_forces(const Builder& b, std::vector<Motion>& motions) {
  for (const core::Force& force : b.scene.forces)
    std::visit([&](const auto& f) { add(b, f, motions); }, force);
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (const auto& own = b.scene.bodies[i].gravity)
      motions[i].force = motions[i].force + b.bodies[i].mass * b.vector(*own);
}

}  // namespace cylon::certified
