// Bob on a rigid rod of length l that swings every way: the axis of a heavy top without spin (heavy_top.cc,
// with a = 0 and beta = 2 g l/l^2), so u = cos(theta) by Jacobi's functions and the azimuth by two integrals
// Pi, phi = P+ + P-.  S and C carry signs, so that a plane swing through the vertical is no special case; nor
// are the conical pendulum and rest. Domain: bodies each on one distance joint from the centre to the world,
// gravity in any direction, spin steady; not on the separatrix of a plane swing that ends upright.
#include "reference/exact/domain.h"
#include "reference/exact/heavy_top_axis.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"
#include "reference/exact/steady_spin.h"

namespace cylon::exact {
namespace {

constexpr auto name = "spherical_pendulum";

const core::Joint& rod_of(const core::Scene& scene, std::size_t index) {
  for (const core::Joint& joint : scene.joints) {
    if (joint.body == static_cast<int>(index)) return joint;
  }
  refuse(name, named(scene, static_cast<int>(index)) + " must have exactly one joint");
}

class Bob {
 public:
  Bob(const core::Scene& scene, std::size_t index) : spin_(scene, index) {
    const core::BodyState& s = scene.bodies[index].initial;
    const core::Joint& rod = rod_of(scene, index);
    const WideVector g = widen(gravity(scene, index)), up = -g.normalized();
    pivot_ = widen(rod.point);
    length_ = rod.length;
    const WideVector d = (widen(s.position) - pivot_).normalized(), v = widen(s.velocity) / length_;
    const WideVector rate = v - d.dot(v) * d;
    axis_ = HeavyTopAxis({.direction = d, .rate = rate, .up = up, .a = 0, .beta = 2 * g.norm() / length_});
    if (!axis_.periodic()) return;

    // Azimuth at the start: from the direction, or next to the vertical from the rate,
    // (theta' cos theta + i phi' sin theta) exp(i phi).
    world_ = turn_between(WideVector::UnitZ(), up);
    const AxisState a = axis_.at(0);
    const WideVector off = d.dot(up) > 0
                               ? WideVector(d - up)
                               : WideVector(d + up);  // across the vertical, with the digits that d has not
    const WideVector e = world_.conjugate() * (off - off.dot(up) * up), de = world_.conjugate() * rate;
    const Wide across = std::hypot(e.x(), e.y()), moving = std::hypot(de.x(), de.y());
    if (moving > axis_.rate() * across) {
      const Wide upward = a.cosine * a.cosine - a.sine * a.sine;
      azimuth_ = std::atan2(de.y(), de.x()) - std::atan2(a.azimuth_rate, a.tilt_rate * upward);
    } else if (across > 0) {
      azimuth_ = a.sine * a.cosine < 0 ? std::atan2(-e.y(), -e.x()) : std::atan2(e.y(), e.x());
    }
  }

  bool periodic() const { return axis_.periodic(); }

  WideState at(Wide t) const {
    const AxisState a = axis_.at(t);
    const Wide phi = azimuth_ + a.plus + a.minus, c = std::cos(phi), s = std::sin(phi);
    const Wide across = 2 * a.sine * a.cosine, upward = a.cosine * a.cosine - a.sine * a.sine;
    WideState state;
    state.position = pivot_ + length_ * (world_ * WideVector(across * c, across * s, upward));
    const Wide tilt = a.tilt_rate, turn = a.azimuth_rate;
    state.velocity = length_ * (world_ * WideVector(tilt * upward * c - turn * s,
                                                    tilt * upward * s + turn * c, -tilt * across));
    spin_.turn(state, t);
    return state;
  }

 private:
  SteadySpin spin_;
  WideVector pivot_;
  Wide length_ = 1, azimuth_ = 0;
  WideQuaternion world_;
  HeavyTopAxis axis_;
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<Bob> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.emplace_back(scene, i);
  return together(std::move(motions));
}

void check_rod(const core::Scene& scene, int index, double horizon) {
  const std::string of = named(scene, index);
  int joints = 0;
  for (const core::Joint& joint : scene.joints) {
    if (joint.body != index && joint.to != index) continue;
    ++joints;
    if (joint.type != core::JointType::distance)
      refuse(name, "the joint of " + of + " is not a distance joint");
    if (joint.to != core::world) refuse(name, "the joint of " + of + " does not end on the world");
  }
  if (joints != 1) refuse(name, of + " must have exactly one joint");
  const core::Joint& rod = rod_of(scene, static_cast<std::size_t>(index));
  const core::BodyState& s = scene.bodies[static_cast<std::size_t>(index)].initial;
  const core::Vector3 arm = s.position - rod.point;
  if (!(rod.length > 0)) refuse(name, "the joint of " + of + " has no length");
  if (std::abs(arm.norm() - rod.length) > 1e-12 * rod.length) {
    refuse(name, of + " is not at its joint's length from the point");
  }
  if (std::abs(arm.dot(s.velocity)) > 1e-9 * rod.length * (1 + s.velocity.norm())) {
    refuse(name, "the initial velocity of " + of + " breaks its joint");
  }
  check_steady_spin(name, scene, index, horizon);
  if (!Bob(scene, static_cast<std::size_t>(index)).periodic()) {
    refuse(name, of + " is on the separatrix or too near it: it comes to rest upright");
  }
}

}  // namespace

core::Truth spherical_pendulum(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_no_contacts(name, scene);
  check_all_fall(name, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) check_rod(scene, i, horizon);
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = "Whittaker, Analytical Dynamics, section 55: the spherical pendulum",
          .horizon = horizon};
}

}  // namespace cylon::exact
