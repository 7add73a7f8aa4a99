// The probes identify engines by their motion: a small engine with many faults, each found by its probe, and
// the engines that are built in, whose integrators are known from their sources.
#include "harness/study/probes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

namespace cylon::study {
namespace {

using core::BodyState;
using core::Scene;
using core::Vector3;

struct Traits {
  enum { semi_implicit, explicit_euler, verlet } integrator = semi_implicit;
  enum { off, from_body, exact } gyroscopic = exact;
  enum { before, after } target = before;
  int sub_steps = 1;
  bool pyramid = false, single = false, sleeps = false, linear_turns = false;
  double speed_limit = INFINITY, spin_limit = INFINITY, damping = 0, threshold = 0;
};

// One body: gravity, a spring to a pin, a floor.
class Small {
 public:
  explicit Small(const Traits& traits) : is_(traits) {}

  core::Recording operator()(const Scene& scene, double dt, std::int64_t steps, std::int64_t every) const {
    core::Recording r;
    r.dt = dt;
    BodyState s = scene.bodies[0].initial;
    for (std::int64_t n = 0; n <= steps; ++n) {
      if (n % every == 0 || n == steps) r.steps.push_back(n), r.states.push_back({s});
      for (int i = 0; i < is_.sub_steps; ++i) step(scene, s, dt / is_.sub_steps);
    }
    return r;
  }

 private:
  static Vector3 acceleration(const Scene& scene, const Vector3& p) {
    Vector3 a = Vector3::Zero();
    for (const core::Force& f : scene.forces) {
      if (const auto* g = std::get_if<core::UniformGravity>(&f)) a += g->acceleration;
      if (const auto* k = std::get_if<core::Spring>(&f))
        a += k->stiffness / scene.bodies[0].mass * (k->to_anchor - p);
    }
    return a;
  }

  void step(const Scene& scene, BodyState& s, double h) const {
    if (is_.sleeps && s.velocity.norm() < 0.01 && s.velocity.norm() > 0) s.velocity.setZero();
    const Vector3 v0 = s.velocity, a = acceleration(scene, s.position);
    s.velocity += (is_.integrator == Traits::verlet ? h / 2 : h) * a;
    touch(scene, s, v0, h);
    s.velocity *=
        std::min(1.0, is_.speed_limit / std::max(1e-300, s.velocity.norm())) * (1 - is_.damping * h);
    s.position += h * (is_.integrator == Traits::explicit_euler ? v0 : s.velocity);
    if (is_.integrator == Traits::verlet) s.velocity += h / 2 * acceleration(scene, s.position);
    turn(scene.bodies[0], s, h);
    if (is_.single)  // volatile: gcc 12 -O3 takes two casts in a row for none in all places but one
      for (double& x : s.position) {
        volatile float rounded = static_cast<float>(x);
        x = static_cast<double>(rounded);
      }
  }

  void touch(const Scene& scene, BodyState& s, const Vector3& v0, double h) const {
    if (scene.planes.empty()) return;
    const auto* box = std::get_if<core::Box>(&scene.bodies[0].shape);
    const double gap = s.position.y() - (box ? box->half_extents.y() : 0.1);
    if (gap + h * s.velocity.y() >= 0 || s.velocity.y() >= 0) return;
    const double e = scene.materials[0].restitution, mu = scene.materials[0].friction;
    const double fell = is_.target == Traits::before ? -v0.y() : -s.velocity.y();
    const double rebound = fell > is_.threshold ? e * fell : 0, push = rebound - s.velocity.y();
    s.velocity.y() = rebound;
    Vector3 slip(s.velocity.x(), 0, s.velocity.z());
    if (is_.pyramid)
      for (const int axis : {0, 2})
        s.velocity[axis] -= std::copysign(std::min(mu * push, std::abs(slip[axis])), slip[axis]);
    else if (slip.norm() > 0)
      s.velocity -= std::min(mu * push, slip.norm()) * slip.normalized();
  }

  // dw/dt = I^-1 (I w x w) in the body: left out, by Euler's step, or by small Runge-Kutta steps.
  void turn(const core::Body& body, BodyState& s, double h) const {
    const core::Matrix3& inertia = body.inertia;
    const auto change = [&](const Vector3& w) -> Vector3 {
      return inertia.diagonal().cwiseInverse().cwiseProduct((inertia * w).cross(w));
    };
    const int parts = is_.gyroscopic == Traits::exact && !is_.linear_turns ? 20 : 1;
    for (int i = 0; i < parts; ++i) {
      const double part = h / parts;
      Vector3 w = s.orientation.conjugate() * s.angular_velocity, middle = w;
      if (is_.gyroscopic == Traits::from_body) middle = w += part * change(w);
      if (is_.gyroscopic == Traits::exact) middle = w + part / 2 * change(w), w += part * change(middle);
      const Vector3 turned = is_.gyroscopic == Traits::off ? Vector3(part * s.angular_velocity)
                                                           : Vector3(s.orientation * (part * middle));
      core::Quaternion q(Eigen::AngleAxisd(
          turned.norm(), turned.norm() > 0 ? Vector3(turned.normalized()) : Vector3::UnitX()));
      if (is_.linear_turns) q = core::Quaternion(1, turned.x() / 2, turned.y() / 2, turned.z() / 2);
      s.orientation = (q * s.orientation).normalized();
      if (is_.gyroscopic != Traits::off) s.angular_velocity = s.orientation * w;
    }
    s.angular_velocity *= std::min(1.0, is_.spin_limit / std::max(1e-300, s.angular_velocity.norm()));
  }

  Traits is_;
};

std::map<std::string, Finding> ask(const Runner& run) {
  const auto findings = find_out(run);
  std::map<std::string, Finding> by_name;
  for (std::size_t i = 0; i < findings.size(); ++i) by_name[std::string(probes()[i].name)] = findings[i];
  return by_name;
}

TEST(Probes, IdentifySmallEngine) {
  struct Row {
    const char* probe;
    const char* answer;
    Traits traits;
  };
  const Row rows[] = {
      {"free fall", "semi-implicit Euler", {}},
      {"free fall", "explicit Euler", {.integrator = Traits::explicit_euler}},
      {"free fall", "semi-implicit Euler with 4 sub-steps", {.sub_steps = 4}},
      {"free fall", "second order or better", {.integrator = Traits::verlet}},
      {"spring", "order 1.0, energy bounded", {}},
      {"spring", "order 2.0, energy bounded", {.integrator = Traits::verlet}},
      {"gyroscopic torque", "off", {.gyroscopic = Traits::off}},
      {"gyroscopic torque", "explicit: adds energy", {.gyroscopic = Traits::from_body}},
      {"gyroscopic torque", "on, order 2", {}},
      {"rotation per step", "exact up to 3 rad per step", {}},
      {"rotation per step", "approximate at every angle", {.linear_turns = true}},
      {"restitution", "speed before gravity acts in the step", {}},
      {"restitution", "speed after gravity acts in the step", {.target = Traits::after}},
      {"slow bounces", "restitution is applied down to 0.01 m/s", {}},
      {"slow bounces", "no restitution at 0.3 m/s and below", {.threshold = 0.5}},
      {"friction", "Coulomb cone", {}},
      {"friction", "friction pyramid: depends on the direction", {.pyramid = true}},
      {"speed limit", "none up to 1e5 m/s", {}},
      {"speed limit", "500 m/s", {.speed_limit = 500}},
      {"spin limit", "none up to 1e4 rad/s", {}},
      {"spin limit", "47.1 rad/s", {.spin_limit = 47.1}},
      {"damping", "none", {}},
      {"damping", "linear 0.04/s, angular 0/s", {.damping = 0.04}},
      // What an engine does besides its damping.
      {"free fall", "semi-implicit Euler", {.damping = 0.04}},
      {"spring", "order 1.0, energy bounded", {.damping = 0.04}},
      {"restitution", "speed before gravity acts in the step", {.damping = 0.04}},
      {"slow bounces", "restitution is applied down to 0.01 m/s", {.damping = 0.04}},
      {"friction", "Coulomb cone", {.damping = 0.04}},
      {"speed limit", "499.7 m/s", {.speed_limit = 500, .damping = 0.04}},  // it damps what it has cut
      {"sleeping", "never", {.damping = 0.04}},
      {"sleeping", "never", {}},
      {"sleeping", "slow bodies are stopped", {.sleeps = true}},
      {"precision", "double", {}},
      {"precision", "single", {.single = true}},
  };
  for (const Row& row : rows) {
    const Small engine(row.traits);
    const Finding found = ask(engine)[row.probe];
    EXPECT_EQ(found.answer, row.answer) << row.probe << ": " << found.evidence;
  }
}

// Explicit Euler on a spring gains order late: at these steps its error is growth itself.
TEST(Probes, DetectEnergyGrowthOfExplicitEuler) {
  const Finding found = ask(Small({.integrator = Traits::explicit_euler}))["spring"];
  EXPECT_NE(found.answer.find("energy grows"), std::string::npos) << found.answer << "; " << found.evidence;
}

TEST(Probes, ReportCrashOfEngine) {
  const Runner broken = [](const Scene&, double, std::int64_t, std::int64_t) -> core::Recording {
    throw RunFailed{{.status = results::Status::crash, .reason = "signal 11"}};
  };
  for (const Finding& finding : find_out(broken)) {
    EXPECT_EQ(finding.answer, "crash");
    EXPECT_EQ(finding.evidence, "signal 11");
  }
}

}  // namespace
}  // namespace cylon::study
