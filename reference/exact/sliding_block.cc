// Boxes that lie flat on a plane and slide, stop or stay, without turning.  Per mass, with n the normal,
// G = -g.n > 0 and g_t gravity along the plane:
//
//     v' = g_t - mu G v/|v|;   at v = 0 it stays if |g_t| <= mu G (tan(theta) <= mu)
//
// along one line, as the velocity is along g_t or g_t is zero.  The plane's force acts where it balances the
// torque of friction: F_t/F_n half heights from the centre, inside the base (no tipping).
// Domain: boxes on one plane that gravity points into, flat, not turning, too far apart to meet.
#include "reference/exact/domain.h"
#include "reference/exact/pieces.h"
#include "reference/exact/slip.h"
#include "reference/exact/solutions.h"

#include <algorithm>

namespace cylon::exact {
namespace {

constexpr auto name = "sliding_block";

std::size_t index_of(int body) { return static_cast<std::size_t>(body); }

// What the plane does to one box.
struct Slope {
  WideVector normal, along;  // unit vectors; along: of the line of motion
  Wide load = 0, pull = 0;   // G, and g_t on `along` [m/s^2]
  WideVector gravity_along;  // g_t

  Slope(const core::Scene& scene, int i) {
    const WideVector g = widen(common_gravity(scene)), v = widen(scene.bodies[index_of(i)].initial.velocity);
    normal = widen(scene.planes[0].normal).normalized();
    load = -normal.dot(g);
    gravity_along = g + load * normal;
    const WideVector v_along = v - normal.dot(v) * normal;
    along = v_along.isZero(0) ? gravity_along : v_along;
    if (!along.isZero(0)) along.normalize();
    pull = along.dot(gravity_along);
  }
};

core::Event stop_of(int body, Wide time) {
  return {.kind = core::EventKind::roll,
          .pair = {body, core::world, 0},
          .index = 1,
          .time = static_cast<double>(time)};
}

Course solve(const core::Scene& scene, double horizon) {
  Course course;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    const core::BodyState& start = scene.bodies[index_of(i)].initial;
    const Slope slope(scene, i);
    const auto material = core::material_of(scene, {i, core::world, 0});
    const Wide drag = (material ? Wide(material->friction) : 0) * slope.load;
    Track track;
    WideState s = {.position = widen(start.position),
                   .velocity = widen(start.velocity),
                   .angular_velocity = WideVector::Zero(),
                   .orientation = widen(start.orientation)};
    s.velocity -= slope.normal.dot(s.velocity) * slope.normal;
    for (const SlipPhase& phase : slip_phases(slope.along.dot(s.velocity), slope.pull, drag, 0)) {
      if (phase.start > horizon * beyond) break;
      if (phase.start > 0) {
        s.position = track.at(phase.start).position;
        if (phase.sign == 0) course.events.push_back(stop_of(i, phase.start));
      }
      s.velocity = phase.slip * slope.along;
      track.add(phase.start, uniform_motion(s, phase.rate * slope.along, WideVector::Zero()));
    }
    course.tracks.push_back(std::move(track));
  }
  return course;
}

// The axes of the box that lie in the plane, and the half extents along all three.
struct Base {
  WideVector first, second;
  Wide half_first, half_second, half_height;
};

Base base_of(const core::Scene& scene, int i, const WideVector& normal) {
  const core::Body& body = scene.bodies[index_of(i)];
  const auto* box = std::get_if<core::Box>(&body.shape);
  if (!box || !body.collide) refuse(name, named(scene, i) + " is not a box that collides");
  const WideMatrix axes = widen(body.initial.orientation).toRotationMatrix();
  int up = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(axes.col(k).dot(normal)) > std::abs(axes.col(up).dot(normal))) up = k;
  }
  if (axes.col(up).cross(normal).norm() > 1e-12L) refuse(name, named(scene, i) + " does not lie flat");
  const int a = (up + 1) % 3, b = (up + 2) % 3;
  return {axes.col(a), axes.col(b), box->half_extents[a], box->half_extents[b], box->half_extents[up]};
}

// What the solution leaves out of one box's scene.
struct Remainder {
  Wide aside, gap;  // gravity across the line of motion [m/s^2]; distance from the plane [m]
};

Remainder check_block(const core::Scene& scene, int i) {
  const core::Body& body = scene.bodies[index_of(i)];
  const core::Plane& plane = scene.planes[0];
  const Slope slope(scene, i);
  if (!(slope.load > 0)) refuse(name, "gravity does not point into plane '" + plane.name + "'");
  const Base base = base_of(scene, i, slope.normal);
  const Wide gap = slope.normal.dot(widen(body.initial.position)) - plane.offset - base.half_height;
  if (std::abs(gap) > 1e-12L * (base.half_height + widen(body.initial.position).norm())) {
    refuse(name, named(scene, i) + " does not touch the plane");
  }
  const WideVector v = widen(body.initial.velocity);
  if (std::abs(slope.normal.dot(v)) > 1e-14L * v.norm()) {
    refuse(name, named(scene, i) + " does not move along the plane");
  }
  if (!body.initial.angular_velocity.isZero(0)) refuse(name, named(scene, i) + " turns");
  const WideVector aside = slope.gravity_along - slope.pull * slope.along;
  if (aside.norm() > 1e-14L * slope.load) {
    refuse(name, named(scene, i) + " does not slide along the line of steepest descent");
  }
  const auto material = core::material_of(scene, {i, core::world, 0});
  if (!material) refuse(name, "no material is given for " + named(scene, i) + " and the plane");
  // The largest friction: mu G while it slips; g_t, which is less, while it stays.
  const bool rests = v.isZero(0) && std::abs(slope.pull) <= material->friction * slope.load;
  const Wide arm = base.half_height * (rests ? std::abs(slope.pull) / slope.load : Wide(material->friction));
  if (arm * std::abs(slope.along.dot(base.first)) >= base.half_first ||
      arm * std::abs(slope.along.dot(base.second)) >= base.half_second) {
    refuse(name, named(scene, i) + " may tip over");
  }
  return {aside.norm(), std::abs(gap)};
}

}  // namespace

core::Truth sliding_block(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  if (scene.planes.size() != 1) refuse(name, "the scene must have one plane");
  const core::ContactRules may_touch(scene);
  const int count = static_cast<int>(scene.bodies.size());
  Remainder left_out = {0, 0};
  for (int i = 0; i < count; ++i) {
    check_meets(name, scene, may_touch, {i, core::world, 0});
    const Remainder r = check_block(scene, i);
    left_out = {std::max(left_out.aside, r.aside), std::max(left_out.gap, r.gap)};
  }
  const auto course = [horizon](const core::Scene& s) { return solve(s, horizon); };
  const auto radius = [&](int i) {
    return std::get<core::Box>(scene.bodies[index_of(i)].shape).half_extents.norm();
  };
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      if (!may_touch.bodies(j, i)) continue;
      check_apart(name, scene, course(scene), j, i, radius(i) + radius(j), horizon);
    }
  }
  core::Truth truth = truth_of(name, scene, course, horizon, "Coulomb's friction on an incline");
  truth.error.position += static_cast<double>(left_out.gap + left_out.aside * horizon * horizon / 2);
  truth.error.velocity += static_cast<double>(left_out.aside * horizon);
  return truth;
}

}  // namespace cylon::exact
