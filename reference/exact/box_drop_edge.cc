// A smooth box that falls on one of its edges, which is parallel to the plane: a motion in the plane across
// that edge k.  With y the height of the centre, c_j the corners of the cross section turned by w t:
//
//     first contact   the first root of min_j f_j,  f_j = y(t) + n.c_j(t)
//     impulse         J = -(1 + e) f'/(1/m + |x x n|^2/I_k) at the middle of the edge, x = c_j
//     v += J n/m,     w += (x x n) J/I_k
//
// and then free flight.  As |f_j''| <= K = G + w^2 |c|, f_j stays positive for a time s while
// f + f' s - K s^2/2 > 0: steps of that length never pass a root and converge to it like Newton's.
// Domain: one box, one plane that gravity points into, spin about the edge or none, no friction, e > 0; the
// horizon comes before the second contact.
#include "reference/exact/domain.h"
#include "reference/exact/pieces.h"
#include "reference/exact/solutions.h"

#include <algorithm>
#include <array>
#include <limits>

namespace cylon::exact {
namespace {

constexpr auto name = "box_drop_edge";

struct Contact {
  Wide time = std::numeric_limits<Wide>::infinity();
  WideVector arm;      // from the centre to the middle of the edge
  Wide rate = 0;       // of the gap, < 0 [m/s]
  Wide clearance = 0;  // height of the next corner [m]
};

// The box as seen along the edge.
class Section {
 public:
  explicit Section(const core::Scene& scene) {
    const core::Body& body = scene.bodies[0];
    normal_ = widen(scene.planes[0].normal).normalized();
    offset_ = scene.planes[0].offset;
    gravity_ = widen(common_gravity(scene));
    const WideMatrix axes = widen(body.initial.orientation).toRotationMatrix();
    const WideVector half = widen(std::get<core::Box>(body.shape).half_extents);
    axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(axes.col(k).dot(normal_)) < std::abs(axes.col(axis).dot(normal_))) axis = k;
    }
    edge = axes.col(axis);
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (std::size_t j = 0; j < 4; ++j) {
      corners_[j] = WideVector::Zero();
      corners_[j][a] = (j & 1 ? 1 : -1) * half[a];
      corners_[j][b] = (j & 2 ? 1 : -1) * half[b];
    }
    moment = widen(core::Vector3(body.inertia.col(axis)))[axis];
    mass = body.mass;
  }

  const WideVector& normal() const { return normal_; }

  /// From time 0 of a flight with this start on.
  Contact next(const WideState& start, Wide end) const {
    const Motion motion = uniform_motion(start, gravity_, WideVector::Zero());
    const Wide bend =
        std::abs(normal_.dot(gravity_)) + start.angular_velocity.squaredNorm() * corners_[0].norm();
    for (Wide t = 0; t <= end;) {
      const WideState s = motion(t);
      Wide step = std::numeric_limits<Wide>::infinity(), lowest = step, second = step;
      Contact contact;
      for (const WideVector& corner : corners_) {
        const WideVector arm = s.orientation * corner;
        const Wide gap = normal_.dot(s.position + arm) - offset_,
                   rate = normal_.dot(s.velocity + s.angular_velocity.cross(arm));
        const Wide root = std::sqrt(std::max<Wide>(0, rate * rate + 2 * bend * std::max<Wide>(0, gap)));
        step = std::min(step, rate < 0 ? 2 * std::max<Wide>(0, gap) / (root - rate) : (rate + root) / bend);
        second = std::min(second, std::max(lowest, gap));
        if (gap < lowest) lowest = gap, contact = {t, arm, rate, 0};
      }
      t += step;
      if (step > 1e-19L * (1 + t)) continue;
      contact.clearance = second;
      return contact;
    }
    return {};
  }

  WideVector edge;
  int axis;
  Wide moment, mass;

 private:
  WideVector normal_, gravity_;
  Wide offset_;
  std::array<WideVector, 4> corners_;
};

struct Fall {
  Course course;
  Contact first;
  Wide again = std::numeric_limits<Wide>::infinity();  // [s]
};

Fall solve(const core::Scene& scene, double horizon) {
  const Section section(scene);
  const core::BodyState& start = scene.bodies[0].initial;
  WideState s = {.position = widen(start.position),
                 .velocity = widen(start.velocity),
                 .angular_velocity = section.edge.dot(widen(start.angular_velocity)) * section.edge,
                 .orientation = widen(start.orientation)};
  const WideVector g = widen(common_gravity(scene));
  Fall fall;
  Track track;
  track.add(0, uniform_motion(s, g, WideVector::Zero()));
  fall.first = section.next(s, horizon * beyond);
  if (fall.first.time <= horizon * beyond) {
    s = track.at(fall.first.time);
    const auto material = core::material_of(scene, {0, core::world, 0});
    const Wide e = material ? material->restitution : 0;
    const Wide lever = section.edge.dot(fall.first.arm.cross(section.normal()));
    const Wide blow = -(1 + e) * fall.first.rate / (1 / section.mass + lever * lever / section.moment);
    s.velocity += blow / section.mass * section.normal();
    s.angular_velocity += blow * lever / section.moment * section.edge;
    track.add(fall.first.time, uniform_motion(s, g, WideVector::Zero()));
    fall.course.events.push_back({.kind = core::EventKind::bounce,
                                  .pair = {0, core::world, 0},
                                  .index = 1,
                                  .time = static_cast<double>(fall.first.time),
                                  .speed = static_cast<double>(-e * fall.first.rate)});
    if (e > 0) fall.again = fall.first.time + section.next(s, horizon).time;
  }
  fall.course.tracks.push_back(std::move(track));
  return fall;
}

void check_box(const core::Scene& scene) {
  if (scene.bodies.size() != 1 || scene.planes.size() != 1)
    refuse(name, "the scene must have one body and one plane");
  const core::Body& body = scene.bodies[0];
  if (!std::holds_alternative<core::Box>(body.shape) || !body.collide) {
    refuse(name, named(scene, 0) + " is not a box that collides");
  }
  check_meets(name, scene, core::ContactRules(scene), {0, core::world, 0});
  check_smooth(name, scene, {0, core::world, 0});
  const Section section(scene);
  if (!(section.normal().dot(widen(common_gravity(scene))) < 0))
    refuse(name, "gravity does not point into the plane");
  if (std::abs(section.edge.dot(section.normal())) > 1e-14L) refuse(name, "no edge is parallel to the plane");
  const WideVector w = widen(body.initial.angular_velocity);
  if (w.cross(section.edge).norm() > 1e-14L * w.norm())
    refuse(name, named(scene, 0) + " does not turn about that edge");
  core::Vector3 across = body.inertia.col(section.axis);
  across[section.axis] = 0;
  if (!(section.moment > 0) || across.norm() > 1e-14 * section.moment) {
    refuse(name, "the edge is not along a principal axis");
  }
  for (int j = 0; j < 8; ++j) {
    const core::Vector3 half = std::get<core::Box>(body.shape).half_extents;
    const core::Vector3 corner(j & 1 ? half.x() : -half.x(), j & 2 ? half.y() : -half.y(),
                               j & 4 ? half.z() : -half.z());
    const core::Vector3 p = body.initial.position + body.initial.orientation * corner;
    if (!(scene.planes[0].normal.dot(p) > scene.planes[0].offset))
      refuse(name, named(scene, 0) + " does not start above the plane");
  }
}

}  // namespace

core::Truth box_drop_edge(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  check_box(scene);
  const Fall fall = solve(scene, horizon);
  if (fall.first.time <= horizon) {
    const double size = std::get<core::Box>(scene.bodies[0].shape).half_extents.norm();
    if (fall.first.clearance < 1e-6L * size) refuse(name, "two edges land at once");
    if (!(fall.course.events[0].speed > 0)) refuse(name, "with restitution 0 the edge may stay on the plane");
    if (fall.again <= horizon) {
      refuse(name, "the horizon is not before the second contact, at " + std::to_string(fall.again) + " s");
    }
  }
  return truth_of(
      name, scene, [horizon](const core::Scene& s) { return solve(s, horizon).course; }, horizon,
      "Newton's restitution at the middle of the edge, between free flights");
}

}  // namespace cylon::exact
