// Spheres over one plane with Coulomb friction: they fly, bounce, slide and roll.  Per mass, with n the
// normal, G = -g.n, g_t gravity along the plane, k = I/(m r^2) (2/5 if solid) and c = 1 + 1/k (7/2):
//
//     slip       u = v_t - r w x n,  the velocity of the point of contact
//     impact     J_n = (1 + e)|v_n|;  J_t = -u/c if |u| <= c mu J_n (sticks), else -mu J_n u/|u|
//     sliding    u' = g_t - c mu G u/|u|,  v' = g_t - mu G u/|u|,  w' = mu G/(k r) n x u/|u|
//     rolling    if |g_t| <= c mu G (tan(theta) <= 7 mu/2):  v' = g_t/(1 + k),  w = n x v/r + w_n n
//
// An impact changes v by J and w by -(n x J_t)/(k r).  Bounces end after Zeno's time, 2 e U/(G (1 - e)) from
// the first one; the last of them, 1e-18 of the first, are one.  The spin w_n about the normal stays.
// Domain: spheres with one moment of inertia on one plane that gravity does not point out of, too far apart
// to meet; while one slides on an incline its slip is along the slope.
#include "reference/exact/domain.h"
#include "reference/exact/pieces.h"
#include "reference/exact/slip.h"
#include "reference/exact/solutions.h"

#include <algorithm>

namespace cylon::exact {
namespace {

constexpr auto name = "rough_sphere";
constexpr long most_bounces = 20000;
constexpr Wide shortest_flight = 1e-9L;  // [s]; no events are listed after it, on the way to rest
constexpr Wide faintest = 1e-18L;        // of the first impact's speed

class Run {
 public:
  Run(const core::Scene& scene, int index, Wide horizon, std::vector<core::Event>& events)
      : pair_{index, core::world, 0}, end_(horizon * beyond), events_(events) {
    const core::Body& body = scene.bodies[static_cast<std::size_t>(index)];
    const auto material = core::material_of(scene, pair_);
    if (material) restitution_ = material->restitution, friction_ = material->friction;
    radius_ = std::get<core::Sphere>(body.shape).radius;
    ratio_ = Wide(body.inertia.trace()) / 3 / (Wide(body.mass) * radius_ * radius_);
    gravity_ = widen(common_gravity(scene));
    normal_ = widen(scene.planes[0].normal).normalized();
    load_ = std::max<Wide>(0, -normal_.dot(gravity_));
    along_ = gravity_ + load_ * normal_;
    if (along_.norm() < level * gravity_.norm()) gravity_ -= along_, along_.setZero();
    state_ = {.position = widen(body.initial.position),
              .velocity = widen(body.initial.velocity),
              .angular_velocity = widen(body.initial.angular_velocity),
              .orientation = widen(body.initial.orientation)};
    gap_ = normal_.dot(state_.position) - scene.planes[0].offset - radius_;
    if (gap_ < resting_gap * radius_) gap_ = 0;
  }

  static constexpr Wide level = 1e-8L;        // slope, as a tangent, that is none: nor is it when nudged
  static constexpr Wide resting_gap = 1e-7L;  // of the radius: a nudged scene rests where its own does

  Track solve() {
    const Wide rate = normal_.dot(state_.velocity);
    if (gap_ > 0 || std::abs(rate) > 1e-9L * state_.velocity.norm()) {
      if (!fly()) return std::move(track_);
    }
    touch();
    return std::move(track_);
  }

  /// The slip that is left out when the sphere comes to stay: across the slope, or a rounding [m/s].
  Wide slip_left_out() const { return left_out_; }

 private:
  WideVector along(const WideVector& x) const { return x - normal_.dot(x) * normal_; }
  WideVector slip() const {
    return along(state_.velocity) - radius_ * state_.angular_velocity.cross(normal_);
  }

  void go(const WideVector& acceleration, const WideVector& spin_up) {
    track_.add(now_, uniform_motion(state_, acceleration, spin_up));
  }

  void advance(Wide to) {
    state_ = track_.at(to);
    now_ = to;
  }

  // Flights and impacts until the sphere stays; false if the horizon comes first.
  bool fly() {
    Wide first = 0;
    for (int bounce = 1;; ++bounce) {
      go(gravity_, WideVector::Zero());
      const Wide rate = normal_.dot(state_.velocity), height = bounce == 1 ? gap_ : 0;
      if (load_ > 0 && 2 * rate > shortest_flight * load_) {
        list(core::EventKind::apex, bounce - 1, now_ + rate / load_, 0, height + rate * rate / (2 * load_));
      }
      const Wide impact = std::sqrt(rate * rate + 2 * load_ * height);
      if (impact == 0 || (load_ == 0 && rate >= 0)) return false;
      const Wide flight = load_ == 0 ? height / -rate
                          : rate > 0 ? (rate + impact) / load_
                                     : 2 * height / (impact - rate);
      if (now_ + flight > end_) return false;
      if (bounce > most_bounces) refuse(name, "more than 20000 bounces before the horizon");
      advance(now_ + flight);
      if (bounce == 1) first = impact;
      const bool last = restitution_ * impact <= faintest * first;
      strike(impact, last);
      if (last) return true;
      if (2 * restitution_ * impact > shortest_flight * load_) {
        list(core::EventKind::bounce, bounce, now_, restitution_ * impact, 0);
      }
    }
  }

  // The velocity's normal part is set, not changed, so that no rounding is left of it.
  void strike(Wide impact, bool last) {
    const Wide blow = (1 + (last ? 0 : restitution_)) * impact, size = slip().norm();
    WideVector kick = WideVector::Zero();
    if (size > 0) kick = -std::min(size / (1 + 1 / ratio_), friction_ * blow) / size * slip();
    state_.velocity = along(state_.velocity) + kick + (last ? 0 : restitution_ * impact) * normal_;
    state_.angular_velocity -= normal_.cross(kick) / (ratio_ * radius_);
  }

  // Slides, and rolls in the end.
  void touch() {
    state_.velocity = along(state_.velocity);
    const WideVector u = slip();
    const Wide pull = along_.norm();
    WideVector line = pull > 0 ? along_ : u;
    if (!line.isZero(0)) line.normalize();
    // Slip that is a rounding of what it is made of is none.
    const Wide rounding = 1e-9L * (state_.velocity.norm() + radius_ * state_.angular_velocity.norm());
    const bool slips = u.norm() > rounding;
    const Wide start = slips ? line.dot(u) : 0;
    left_out_ = (u - start * line).norm();
    const Wide c = 1 + 1 / ratio_;
    for (const SlipPhase& phase : slip_phases(start, pull, c * friction_ * load_, now_)) {
      if (phase.start > end_) return;
      if (phase.start > now_) {
        advance(phase.start);
        if (phase.sign == 0) list(core::EventKind::roll, 1, now_, 0, 0);
      }
      const Wide grip = phase.sign * friction_ * load_;
      if (phase.sign != 0) {
        go(along_ - grip * line, grip / (ratio_ * radius_) * normal_.cross(line));
      } else {
        const WideVector acceleration = along_ / (1 + ratio_);
        go(acceleration, normal_.cross(acceleration) / radius_);
      }
    }
  }

  void list(core::EventKind kind, int index, Wide time, Wide speed, Wide height) {
    if (time > end_) return;
    events_.push_back({.kind = kind,
                       .pair = pair_,
                       .index = index,
                       .time = static_cast<double>(time),
                       .speed = static_cast<double>(speed),
                       .height = static_cast<double>(height)});
  }

  core::Pair pair_;
  Wide end_, restitution_ = 0, friction_ = 0, radius_ = 0, ratio_ = 0, load_ = 0, gap_ = 0, now_ = 0,
             left_out_ = 0;
  WideVector gravity_, normal_, along_;
  WideState state_;
  Track track_;
  std::vector<core::Event>& events_;
};

// The gap of a sphere that rests, which is a rounding [m].
Wide check_sphere(const core::Scene& scene, int i) {
  const core::Body& body = scene.bodies[static_cast<std::size_t>(i)];
  const core::Plane& plane = scene.planes[0];
  const double r = colliding_radius(name, scene, i), moment = body.inertia(0, 0);
  if (!(moment > 0) || !body.inertia.isApprox(moment * core::Matrix3::Identity(), 1e-14)) {
    refuse(name, named(scene, i) + " has not the same moment of inertia about every axis");
  }
  if (!core::material_of(scene, {i, core::world, 0})) {
    refuse(name, "no material is given for " + named(scene, i) + " and the plane");
  }
  const WideVector normal = widen(plane.normal).normalized(), v = widen(body.initial.velocity);
  const Wide gap = normal.dot(widen(body.initial.position)) - plane.offset - r,
             rate = std::abs(normal.dot(v)), rounding = 1e-12L * (r + body.initial.position.norm());
  if (gap < -rounding) refuse(name, named(scene, i) + " starts inside the plane");
  if (gap > rounding && gap < 1e-5L * r) refuse(name, named(scene, i) + " is not clear of the plane");
  if (gap <= rounding && rate > 1e-14L * v.norm() && rate < 1e-6L * v.norm()) {
    refuse(name, named(scene, i) + " grazes the plane");
  }
  return gap > rounding ? 0 : std::abs(gap);
}

// Gravity along a plane that is level but for a rounding [m/s^2].
Wide check_level(const core::Scene& scene) {
  const WideVector g = widen(common_gravity(scene)), n = widen(scene.planes[0].normal).normalized();
  const Wide along = (g - n.dot(g) * n).norm();
  if (along > 1e-14L * g.norm() && along < 1e-6L * g.norm()) {
    refuse(name, "plane '" + scene.planes[0].name + "' is neither level nor a slope");
  }
  return along == 0 || along > 1e-6L * g.norm() ? 0 : along + 1e-15L * g.norm();
}

}  // namespace

core::Truth rough_sphere(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  if (scene.planes.size() != 1) refuse(name, "the scene must have one plane");
  if (scene.planes[0].normal.dot(common_gravity(scene)) > 0) {
    refuse(name, "gravity points out of plane '" + scene.planes[0].name + "'");
  }
  const core::ContactRules may_touch(scene);
  const int count = static_cast<int>(scene.bodies.size());
  for (int i = 0; i < count; ++i) check_meets(name, scene, may_touch, {i, core::world, 0});
  const Wide tilt = check_level(scene);
  Wide gap = 0, slip = 0;
  for (int i = 0; i < count; ++i) gap = std::max(gap, check_sphere(scene, i));
  const auto solve = [horizon](const core::Scene& s) {
    Course course;
    for (int i = 0; i < static_cast<int>(s.bodies.size()); ++i) {
      course.tracks.push_back(Run(s, i, horizon, course.events).solve());
    }
    return course;
  };
  const Course course = solve(scene);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      if (!may_touch.bodies(j, i)) continue;
      const double reach = colliding_radius(name, scene, i) + colliding_radius(name, scene, j);
      check_apart(name, scene, course, j, i, reach, horizon);
    }
    std::vector<core::Event> none;
    Run run(scene, i, horizon, none);
    run.solve();
    const core::BodyState& s = scene.bodies[static_cast<std::size_t>(i)].initial;
    const double size = s.velocity.norm() + colliding_radius(name, scene, i) * s.angular_velocity.norm();
    if (run.slip_left_out() > 1e-14L * size) {
      refuse(name, named(scene, i) + " has a slip that is neither none nor along the slope");
    }
    slip = std::max(slip, run.slip_left_out());
  }
  core::Truth truth = truth_of(name, scene, solve, horizon,
                               "Coulomb's friction and Newton's restitution of a sphere on a plane");
  truth.error.velocity += static_cast<double>(slip + tilt * horizon);
  truth.error.position += static_cast<double>(gap + slip * horizon + tilt * horizon * horizon / 2);
  return truth;
}

}  // namespace cylon::exact
