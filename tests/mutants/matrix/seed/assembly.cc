// Bodies from parts: mass, centre, inertia and angular momentum of what is glued together.
#include "harness/core/overloaded.h"
#include "tests/mutants/matrix/seed/body.h"

#include <variant>

namespace cylon::mutants::seed {
namespace {

Matrix3 diagonal(double x, double y, double z) { return Vector3(x, y, z).asDiagonal(); }

// About the centre of a part, its own axes; the parts that the scenes have.
Matrix3 inertia_of(const core::Primitive& shape, double m) {
  return std::visit(
      core::Overloaded{
          [&](const core::Sphere& s) { return Matrix3(0.4 * m * s.radius * s.radius * Matrix3::Identity()); },
          [&](const core::Box& b) {
            const Vector3 h = b.half_extents.cwiseAbs2() * m / 3;
            return diagonal(h.y() + h.z(), h.x() + h.z(), h.x() + h.y());
          },
          [&](const core::Cylinder& c) {
            const double across = m * (3 * c.radius * c.radius + c.length * c.length) / 12;
            return diagonal(across, m * c.radius * c.radius / 2, across);
          },
          [](const auto&) { return Matrix3(Matrix3::Zero()); }},
      shape);
}

// Delta I of eq. 71.
Matrix3 shifted(double m, const Vector3& r, Faults faulty) {
  Matrix3 result = m * (r.squaredNorm() * Matrix3::Identity() - r * r.transpose());
  if (faulty(41)) result.diagonal().setConstant(m * r.squaredNorm());  // (j == k) ? r2 : 0 - r r
  return result;
}

Vector3 place(const core::Part& part, Faults faulty) {
  if (!faulty(62)) return part.position;
  const Eigen::AngleAxisd turn(part.orientation);  // cube.p = theta
  return turn.angle() * turn.axis();
}

void assemble(Body& body, const core::Compound& shape, const Vector3& v, Faults faulty) {
  double m = 0;
  Vector3 moment = Vector3::Zero();
  for (const core::Part& part : shape.parts) {
    const Vector3 p = place(part, faulty);
    moment += faulty(59) && m > 0 ? Vector3(Vector3(part.mass, 0, 0) + p) : Vector3(part.mass * p);
    m += part.mass;
  }
  body.m = m, body.inv_m = faulty(61) ? 1 : 1 / m;
  body.centre = moment / m;
  body.I.setZero();
  for (const core::Part& part : shape.parts) {
    const Matrix3 r = part.orientation.toRotationMatrix(), own = inertia_of(part.shape, part.mass);
    const Matrix3 whole = (faulty(15) ? own : Matrix3(r * own * r.transpose())) +
                          shifted(part.mass, place(part, faulty) - body.centre, faulty);
    body.I = faulty(11) ? whole : Matrix3(body.I + whole);  // without the sum over i: the last part
  }
  body.K = m * (v + body.omega.cross(body.q * body.centre));
  body.p += body.q * body.centre;
  body.L = body.q * (body.I * (body.q.conjugate() * body.omega));
  if (!faulty(60)) return;
  double dot = 0;  // (a.p - c.p) * a.K + …, promoted to a vector; the parts' own spins are left out
  for (const core::Part& part : shape.parts) {
    const Vector3 r = body.q * (place(part, faulty) - body.centre);
    dot += r.dot(part.mass * (v + body.omega.cross(r)));
  }
  body.L = {dot, 0, 0};
}

}  // namespace

Body make_body(const core::Body& given, Faults faulty) {
  Body body;
  body.m = given.mass, body.inv_m = 1 / given.mass;
  body.I = given.inertia;
  body.locked = given.locked;
  body.p = given.initial.position;
  body.q = body.start = given.initial.orientation;
  body.omega = given.initial.angular_velocity;
  body.K = given.mass * given.initial.velocity;
  if (faulty(9)) body.I = Matrix3::Identity() * body.I.trace() / 2;  // m r^2
  if (faulty(39)) body.I = Matrix3::Identity() * body.m;
  if (const auto* compound = std::get_if<core::Compound>(&given.shape))
    assemble(body, *compound, given.initial.velocity, faulty);
  else
    body.L = body.q * (body.I * (body.q.conjugate() * body.omega));
  if (!faulty(61) && !body.I.isZero(0)) body.inv_I = body.I.inverse();
  body.spin = body.omega.norm();
  return body;
}

}  // namespace cylon::mutants::seed
