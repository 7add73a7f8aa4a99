// A smooth sphere that strikes a free box off its centre, once.  Until then nothing turns but the sphere, and
// the box sees its centre move along a line, d + w t; f(t) = distance of that point from the box is convex:
//
//     contact  f(t) = r, by Newton's method from t = 0, which never passes the root of a convex function
//     impulse  J = (1 + e)|w.n|/(1/m_s + 1/m_b + (x x n).I^-1 (x x n)), n from the sphere into the box,
//              x from the box's centre to the point of contact (the inertia in world axes)
//     v_s -= J n/m_s,   v_b += J n/m_b,   w_b = I^-1 (x x J n)
//
// Afterwards the box turns freely, as Euler and Jacobi say.  Domain: a sphere and a box in space, gravity or
// none, no friction, e > 0, the box without spin, apart at the start and not in touch again by the horizon.
#include "reference/exact/domain.h"
#include "reference/exact/free_rotation.h"
#include "reference/exact/pieces.h"
#include "reference/exact/solutions.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace cylon::exact {
namespace {

constexpr auto name = "rod_offcentre_hit";

// Which body is which.
struct Pairing {
  int sphere, box;
  Wide radius;
  WideVector half;

  explicit Pairing(const core::Scene& scene) {
    sphere = std::holds_alternative<core::Sphere>(scene.bodies[0].shape) ? 0 : 1;
    box = 1 - sphere;
    radius = std::get<core::Sphere>(body(scene, sphere).shape).radius;
    half = widen(std::get<core::Box>(body(scene, box).shape).half_extents);
  }

  static const core::Body& body(const core::Scene& scene, int i) {
    return scene.bodies[static_cast<std::size_t>(i)];
  }

  // The box's point nearest to p, both in the box's axes.
  WideVector nearest(const WideVector& p) const { return p.cwiseMax(-half).cwiseMin(half); }
};

struct Hit {
  Wide time;
  WideVector normal, arm;  // from the sphere into the box; from the box's centre to the contact; world axes
};

std::optional<Hit> hit_of(const core::Scene& scene, const Pairing& pair, Wide end) {
  const core::BodyState &s = Pairing::body(scene, pair.sphere).initial,
                        &b = Pairing::body(scene, pair.box).initial;
  const WideQuaternion q = widen(b.orientation);
  const WideVector d = q.conjugate() * WideVector(widen(s.position) - widen(b.position)),
                   w = q.conjugate() * WideVector(widen(s.velocity) - widen(b.velocity));
  Wide t = 0;
  for (int i = 0; i < 200; ++i) {
    const WideVector p = d + w * t, away = p - pair.nearest(p);
    const Wide distance = away.norm(), rate = away.dot(w) / distance;
    if (!(rate < 0)) return {};
    const Wide step = (distance - pair.radius) / -rate;
    t += std::max<Wide>(0, step);
    if (t > end) return {};
    if (step <= 1e-19L * (1 + t)) break;
  }
  const WideVector p = d + w * t, x = pair.nearest(p);
  return Hit{t, q * WideVector((x - p).normalized()), q * x};
}

Motion steady(const core::BodyState& s, const WideVector& g) {
  return uniform_motion({.position = widen(s.position),
                         .velocity = widen(s.velocity),
                         .angular_velocity = widen(s.angular_velocity),
                         .orientation = widen(s.orientation)},
                        g, WideVector::Zero());
}

Course solve(const core::Scene& scene, double horizon) {
  const Pairing pair(scene);
  const WideVector g = widen(common_gravity(scene));
  Course course;
  course.tracks.resize(2);
  for (std::size_t i : {0u, 1u}) course.tracks[i].add(0, steady(scene.bodies[i].initial, g));
  const auto hit = hit_of(scene, pair, horizon * beyond);
  if (!hit) return course;
  const core::Body &sphere = Pairing::body(scene, pair.sphere), &box = Pairing::body(scene, pair.box);
  Track &sphere_track = course.tracks[static_cast<std::size_t>(pair.sphere)],
        &box_track = course.tracks[static_cast<std::size_t>(pair.box)];
  WideState s = sphere_track.at(hit->time), b = box_track.at(hit->time);
  const WideMatrix r = b.orientation.toRotationMatrix();
  const WideMatrix inverse = r * box.inertia.cast<Wide>().inverse() * r.transpose();
  const WideVector lever = hit->arm.cross(hit->normal);
  const auto material = core::material_of(scene, {0, 1, -1});
  const Wide e = material ? material->restitution : 0;
  const Wide approach = hit->normal.dot(s.velocity - b.velocity);
  const Wide blow =
      (1 + e) * approach / (1 / Wide(sphere.mass) + 1 / Wide(box.mass) + lever.dot(inverse * lever));
  s.velocity -= blow / sphere.mass * hit->normal;
  b.velocity += blow / box.mass * hit->normal;
  b.angular_velocity = inverse * lever * blow;
  sphere_track.add(hit->time, uniform_motion(s, g, WideVector::Zero()));
  core::Scene after = scene;
  after.bodies = {box};
  after.bodies[0].initial = narrow(b);
  box_track.add(hit->time, free_rotation(after, 0));
  course.events.push_back({.kind = core::EventKind::bounce,
                           .pair = {0, 1, -1},
                           .index = 1,
                           .time = static_cast<double>(hit->time),
                           .speed = static_cast<double>(e * approach)});
  return course;
}

constexpr int most_looks = 100000;  // half a second

// No second contact: right after the first the gap opens at the rate u and bends by at most k, so that it is
// open for u/k; from then on it shrinks no faster than `fastest`.
void check_once(const core::Scene& scene, const Course& course, double horizon) {
  if (course.events.empty()) return;
  const Pairing pair(scene);
  const core::Body& box = Pairing::body(scene, pair.box);
  const Track &sphere_track = course.tracks[static_cast<std::size_t>(pair.sphere)],
              &box_track = course.tracks[static_cast<std::size_t>(pair.box)];
  const Wide start = course.events[0].time;
  const WideState s = sphere_track.pieces()[1].motion(0), b = box_track.pieces()[1].motion(0);
  const core::Vector3 moments = core::principal_axes(box.inertia).moments;
  // |w| stays below |L|/I_min, its rate of change below |w| |L|/I_min.
  const Wide spin = b.angular_velocity.norm() * moments.maxCoeff() / moments.minCoeff();
  const Wide drift = (s.velocity - b.velocity).norm(), span = horizon - start;
  const Wide far = pair.half.norm() + pair.radius + drift * span;
  const Wide fastest = drift + spin * far,
             bend = spin * (2 * drift + 2 * spin * far) + fastest * fastest / pair.radius;
  const Wide opening = course.events[0].speed;
  if (!(opening > 0)) refuse(name, "with restitution 0 the two may stay in touch");
  int looks = 0;
  for (Wide t = start + opening / bend; t < horizon;) {
    if (++looks > most_looks)
      refuse(name, "whether the two touch again before the horizon takes too long to see");
    const WideState at_s = sphere_track.at(t), at_b = box_track.at(t);
    const WideVector p = at_b.orientation.conjugate() * WideVector(at_s.position - at_b.position);
    const Wide gap = (p - pair.nearest(p)).norm() - pair.radius;
    if (!(gap > opening * opening / bend / 16)) refuse(name, "the two touch again before the horizon");
    t += gap / fastest;
  }
}

}  // namespace

core::Truth rod_offcentre_hit(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  if (scene.bodies.size() != 2) refuse(name, "the scene must have two bodies");
  if (!scene.planes.empty()) refuse(name, "the scene has plane '" + scene.planes[0].name + "'");
  int boxes = 0;
  for (int i : {0, 1}) {
    const core::Body& body = Pairing::body(scene, i);
    if (!body.collide) refuse(name, named(scene, i) + " does not collide");
    if (std::holds_alternative<core::Box>(body.shape)) {
      ++boxes;
      if (!body.initial.angular_velocity.isZero(0))
        refuse(name, named(scene, i) + " turns before it is struck");
    } else if (!std::holds_alternative<core::Sphere>(body.shape)) {
      refuse(name, named(scene, i) + " is neither a sphere nor a box");
    }
  }
  if (boxes != 1) refuse(name, "the scene must have one sphere and one box");
  check_meets(name, scene, core::ContactRules(scene), {0, 1, -1});
  check_smooth(name, scene, {0, 1, -1});
  const Pairing pair(scene);
  check_steady_spin(name, scene, pair.sphere, horizon);
  const core::Body& box = Pairing::body(scene, pair.box);
  const WideVector p =
      widen(box.initial.orientation).conjugate() *
      WideVector(widen(Pairing::body(scene, pair.sphere).initial.position) - widen(box.initial.position));
  if ((p - pair.nearest(p)).norm() < pair.radius * (1 - 1e-12L)) refuse(name, "the two overlap at the start");
  if (!(core::principal_axes(box.inertia).moments.minCoeff() > 0)) {
    refuse(name, named(scene, pair.box) + " has a moment of inertia that is not positive");
  }
  const auto course = [horizon](const core::Scene& s) { return solve(s, horizon); };
  check_once(scene, course(scene), horizon);
  return truth_of(name, scene, course, horizon,
                  "Newton's restitution at a point off the centre; Euler's free top");
}

}  // namespace cylon::exact
