// The smooth solutions with forces of every kind obey the equations of motion for general parameters, carry
// on from any of their states, and see it when a parameter is off by a thousandth.
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/equation_of_motion.h"
#include "tests/reference/exact/reference_file.h"
#include "tests/reference/exact/smooth_scenes.h"

#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

core::Truth make(std::string_view name, const core::Scene& scene, double horizon) {
  for (const Solution& solution : catalogue()) {
    if (solution.name == name) return solution.make(scene, horizon);
  }
  throw std::runtime_error("no solution " + std::string(name));
}

class SmoothLaws : public testing::TestWithParam<const char*> {};

// The scenes' rates, up to 70 rad/s, leave (70 h)^10/2772 = 1e-12, rounding 1e-16 s/h of their size.
constexpr double h = 0.002, allowed = 1e-9;

// A turning frame's bound is taken over the solution that it wraps, a second for each scene.
unsigned scenes_of(const std::string& name) { return name == "rotating_frame" ? 3 : 12; }

TEST_P(SmoothLaws, equations_of_motion) {
  for (unsigned seed = 1; seed <= scenes_of(GetParam()); ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = SmoothScenes(seed).scene(GetParam());
    const core::Truth truth = make(GetParam(), scene, 5);
    const core::State start = truth.state(0), expected = core::initial_state(scene);
    for (std::size_t i = 0; i < start.size(); ++i) {
      EXPECT_LE((start[i].position - expected[i].position).norm(), truth.error.position);
      EXPECT_LE((start[i].velocity - expected[i].velocity).norm(), truth.error.velocity);
      EXPECT_LE(angle_between(start[i].orientation, expected[i].orientation), truth.error.orientation);
      EXPECT_LE((start[i].angular_velocity - expected[i].angular_velocity).norm(),
                truth.error.angular_velocity);
    }
    for (double t : {0.05, 0.43, 1.7, 2.9, 4.9}) {
      EXPECT_LE(EquationOfMotion(scene, truth).violation(t, h), allowed) << "t " << t;
    }
    // The bounds say something: three digits more than what claims ask of stepping schemes.
    EXPECT_LE(truth.error.position, 1e-9);
    EXPECT_LE(truth.error.velocity, 1e-8);
  }
}

// Negative control: the truth of another mass, or of another number where the mass drops out, is seen.
TEST_P(SmoothLaws, detects_wrong_parameter) {
  const core::Scene scene = SmoothScenes(3).scene(GetParam());
  const core::Truth truth = make(GetParam(), scene, 5);
  double worst = 0;
  core::Scene other = scene;
  for (core::Body& body : other.bodies) body.mass *= 1.001;
  for (core::Joint& joint : other.joints) joint.point.x() += 1e-3;
  if (other.frame) other.frame->angular_velocity *= 1.001;
  for (core::Force& force : other.forces) {
    if (auto* thrust = std::get_if<core::Thrust>(&force)) thrust->mass_rate *= 0.999;
    if (auto* g = std::get_if<core::UniformGravity>(&force)) g->acceleration *= 1.001;
  }
  for (double t : {0.43, 1.7, 2.9}) worst = std::max(worst, EquationOfMotion(other, truth).violation(t, h));
  EXPECT_GE(worst, 1e-5);
}

// run(T1 + T2) = run(T2) after run(T1), where time and mass do not enter the equations.
TEST_P(SmoothLaws, flow) {
  for (unsigned seed = 1; seed <= scenes_of(GetParam()); ++seed) {
    SCOPED_TRACE(seed);
    core::Scene scene = SmoothScenes(300 + seed).scene(GetParam());
    const core::Truth whole = make(GetParam(), scene, 6);
    for (core::Force& force : scene.forces) {
      if (std::holds_alternative<core::Drive>(force) || std::holds_alternative<core::Water>(force)) return;
      const auto* thrust = std::get_if<core::Thrust>(&force);
      if (thrust) scene.bodies[static_cast<std::size_t>(thrust->body)].mass += 2.3 * thrust->mass_rate;
    }
    const core::State middle = whole.state(2.3);
    for (std::size_t i = 0; i < middle.size(); ++i) scene.bodies[i].initial = middle[i];
    if (scene.frame) scene.frame->angular_velocity = scene.frame->angular_velocity_at(2.3);
    const core::Truth rest = make(GetParam(), scene, 4);
    for (double t : {0.0, 1.1, 3.7}) {
      const core::State a = whole.state(2.3 + t), b = rest.state(t);
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LE((a[i].position - b[i].position).norm(), 3 * whole.error.position);
        EXPECT_LE((a[i].velocity - b[i].velocity).norm(), 3 * whole.error.velocity);
        EXPECT_LE(angle_between(a[i].orientation, b[i].orientation), 3 * whole.error.orientation);
        EXPECT_LE((a[i].angular_velocity - b[i].angular_velocity).norm(), 3 * whole.error.angular_velocity);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(all, SmoothLaws,
                         testing::Values("projectile_drag", "damped_spring", "driven_spring", "rocket",
                                         "accretion", "damped_free_top", "kepler", "physical_pendulum",
                                         "spherical_pendulum", "spring_chain", "rotating_frame",
                                         "seed_airplane"),
                         [](const auto& p) { return std::string(p.param); });

// The water's force jumps where a cork crosses the surface, so only between crossings; a crossing that was
// passed over would leave a force that is not there.
TEST(Corks, equations_of_motion_between_crossings) {
  int compared = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    core::Scene scene = SmoothScenes(seed).scene("water_step_force");
    scene.bodies.resize(1);
    const core::Truth truth = make("water_step_force", scene, 5);
    EXPECT_LE(truth.error.position, 1e-9);
    const core::Water water = std::get<core::Water>(scene.forces[1]);
    const core::Vector3 p = scene.bodies[0].initial.position;
    const auto cell = [](double x) { return std::trunc((x + 5) / 0.25); };
    const double i = cell(p.x()), j = cell(p.z());
    const auto depth = [&](double t) {
      return truth.state(t)[0].position.y() - water.level -
             water.wave / 2 * (std::sin(water.speed * t + i) + std::sin(i * j / 2));
    };
    for (int k = 1; k < 500; ++k) {
      const double t = 0.01 * k, step = 0.001;
      bool apart = true;
      for (int n = -5; n <= 5; ++n) apart = apart && depth(t + n * step) * depth(t) > 0;
      if (!apart) continue;
      ++compared;
      EXPECT_LE(EquationOfMotion(scene, truth).violation(t, step), allowed) << "t " << t;
    }
  }
  EXPECT_GE(compared, 12 * 250);
}

// A frame that only moves changes nothing.
TEST(Frames, galilei) {
  for (const char* name : {"projectile_drag", "kepler", "physical_pendulum", "spring_chain"}) {
    core::Scene scene = SmoothScenes(7).scene(name);
    const core::Truth still = make(name, scene, 3);
    scene.frame = core::Frame{{3, -1, 2}, {0, 0, 0}};
    const core::State a = still.state(2.2), b = make(name, scene, 3).state(2.2);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].position, b[i].position) << name;
  }
}

}  // namespace
}  // namespace cylon::exact
