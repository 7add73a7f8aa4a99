// Order and sign of quaternions, frames of inertia and spin, handedness, origin, order of bodies: a mistake
// in any of them turns a general motion into another one, and breaks a symmetry that mechanics has.
#include "reference/exact/solutions.h"
#include "tests/conformance/adapters_fixture.h"

#include <array>
#include <cmath>

namespace cylon::conformance {
namespace {

class Conventions : public EveryEngine {};
INSTANTIATE_TEST_SUITE_P(Adapters, Conventions, testing::ValuesIn(subjects), test_name);
INSTANTIATE_TEST_SUITE_P(Dart, Conventions, testing::Values(dart), test_name);

// ---- Against exact rotation ------------------------------------------------------------------------

// The largest deviation from the truth after 0.5 s without gravity, orientation [rad] and angular velocity
// [rad/s] alike.
double top_error(const Subject& subject, const char* solution, unsigned seed, std::int64_t steps) {
  const double duration = 0.5;
  core::Scene scene = exact::RandomScenes(seed).scene(solution);
  scene.forces.clear();
  const core::Truth truth = std::string_view(solution) == "free_symmetric_top"
                                ? exact::free_symmetric_top(scene, duration)
                                : exact::free_asymmetric_top(scene, duration);
  return difference(last(subject.choice(), scene, duration / static_cast<double>(steps), steps),
                    truth.state(duration));
}

// At dt = 0.5 ms a first-order integrator is within T w^2 dt of the truth, with w < 7 rad/s: 1.2e-2 rad; a
// wrong convention is off by a radian.  And the error falls with dt as the integrator's order says, so it
// is the integrator's and not the adapter's; until rounding, of which 1000 steps gather two units each at
// most (Subject::drift).
void expect_true_rotation(const Subject& subject, const char* solution) {
  for (unsigned seed = 21; seed <= 24; ++seed) {
    const double fine = top_error(subject, solution, seed, 1000),
                 coarse = top_error(subject, solution, seed, 100);
    const std::string what = fmt::format("{} {}, {}", solution, seed, subject.id);
    expect_within(what, fine, 1.2e-2);
    expect_within(what + ", ten times finer", fine,
                  1.25 * coarse / std::pow(10, subject.order) + 1000 * subject.drift * subject.unit());
  }
}

TEST_P(Conventions, FreeSymmetricTopIsExact) { expect_true_rotation(subject(), "free_symmetric_top"); }
TEST_P(Conventions, FreeAsymmetricTopIsExact) { expect_true_rotation(subject(), "free_asymmetric_top"); }

// ---- Symmetries ------------------------------------------------------------------------------------
// Each test asserts that
// the transformed scene has the transformed motion.  Every integrator here keeps these
// symmetries, so what remains is rounding, amplified by the motion itself: 8 units a step (measured 2026-11:
// up to 5), or four times Subject::drift.

constexpr double dt = 0.002;
constexpr std::int64_t steps = 250;

// Three bodies tied by off-centre springs, with damping and gravity.
core::Scene tied(unsigned seed) {
  exact::RandomScenes random(seed);
  core::Scene scene = three_bodies(seed);
  scene.forces = {core::UniformGravity{{3.1, -7.3, 2.2}},
                  core::Spring{0, random.vector(0.3), 1, random.vector(0.3), 14.0, 0.6, 0.4},
                  core::Spring{2, random.vector(0.3), 1, random.vector(0.3), 9.0, 0.2, 0.0}};
  return scene;
}

double rounding(const Subject& subject) {
  return 4 * subject.drift * static_cast<double>(steps) * subject.unit();
}

core::State run(const Subject& subject, const core::Scene& scene) {
  return last(subject.choice(), scene, dt, steps);
}

// q' = q c, I' = c^T I c, anchors c^T a: other body axes, the same body.
TEST_P(Conventions, MotionDoesNotDependOnBodyAxes) {
  core::Scene scene = tied(31), relabelled = scene;
  exact::RandomScenes random(32);
  const std::array<Quaternion, 3> turns = {random.rotation(), Quaternion(0.5, 0.5, 0.5, 0.5),
                                           random.rotation()};
  for (std::size_t i = 0; i < turns.size(); ++i) {
    core::Body& body = relabelled.bodies[i];
    const core::Matrix3 c = turns[i].toRotationMatrix();
    body.initial.orientation = body.initial.orientation * turns[i];
    const core::Matrix3 turned = c.transpose() * body.inertia * c;
    body.inertia = (turned + turned.transpose()) / 2;
  }
  for (core::Force& force : relabelled.forces)
    if (auto* spring = std::get_if<core::Spring>(&force)) {
      spring->anchor = turns[static_cast<std::size_t>(spring->body)].conjugate() * spring->anchor;
      spring->to_anchor = turns[static_cast<std::size_t>(spring->to)].conjugate() * spring->to_anchor;
    }
  core::State expected = run(subject(), scene);
  for (std::size_t i = 0; i < turns.size(); ++i) expected[i].orientation = expected[i].orientation * turns[i];
  expect_within(fmt::format("body axes relabelled, {}", subject().id),
                difference(run(subject(), relabelled), expected), rounding(subject()));
}

// Everything turned by R about the origin.
TEST_P(Conventions, MotionDoesNotDependOnDirection) {
  core::Scene scene = tied(33), turned = scene;
  const Quaternion r = exact::RandomScenes(34).rotation();
  const auto turn = [&](core::BodyState& s) {
    s = {r * s.position, r * s.orientation, r * s.velocity, r * s.angular_velocity};
  };
  for (core::Body& body : turned.bodies) turn(body.initial);
  auto& g = std::get<core::UniformGravity>(turned.forces[0]).acceleration;
  g = r * g;
  core::State expected = run(subject(), scene);
  for (core::BodyState& s : expected) turn(s);
  expect_within(fmt::format("scene rotated, {}", subject().id), difference(run(subject(), turned), expected),
                rounding(subject()));
}

// Everything moved by d, pins included.  Rounding is that of the four times larger coordinates.
TEST_P(Conventions, MotionDoesNotDependOnOrigin) {
  core::Scene scene = tied(35);
  scene.forces.emplace_back(core::Spring{1, {0.1, -0.2, 0.15}, core::world, {0.4, 1.3, -0.8}, 6.0, 0.5, 0.1});
  core::Scene moved = scene;
  const Vector3 d(11.3, -7.9, 14.2);
  for (core::Body& body : moved.bodies) body.initial.position += d;
  std::get<core::Spring>(moved.forces.back()).to_anchor += d;
  core::State expected = run(subject(), scene);
  for (core::BodyState& s : expected) s.position += d;
  expect_within(fmt::format("scene moved by 20 m, {}", subject().id),
                difference(run(subject(), moved), expected), 4 * rounding(subject()));
}

// Everything set off with velocity u.  Rounding is that of the four times larger speeds.
TEST_P(Conventions, MotionDoesNotDependOnUniformVelocity) {
  core::Scene scene = tied(36), boosted = scene;
  const Vector3 u(5.1, -6.3, 4.7);
  for (core::Body& body : boosted.bodies) body.initial.velocity += u;
  core::State expected = run(subject(), scene);
  for (core::BodyState& s : expected) {
    s.position += u * (dt * static_cast<double>(steps));
    s.velocity += u;
  }
  expect_within(fmt::format("scene boosted by 9 m/s, {}", subject().id),
                difference(run(subject(), boosted), expected), 4 * rounding(subject()));
}

// Bodies listed in another order, forces in the same: nothing is computed otherwise, so not a bit changes.
TEST_P(Conventions, MotionDoesNotDependOnBodyOrder) {
  const core::Scene scene = tied(37);
  const std::array<int, 3> place = {2, 0, 1};  // of body i in the other scene
  core::Scene permuted = scene;
  for (std::size_t i = 0; i < place.size(); ++i)
    permuted.bodies[static_cast<std::size_t>(place[i])] = scene.bodies[i];
  for (core::Force& force : permuted.forces)
    if (auto* spring = std::get_if<core::Spring>(&force)) {
      spring->body = place[static_cast<std::size_t>(spring->body)];
      spring->to = place[static_cast<std::size_t>(spring->to)];
    }
  const core::State expected = run(subject(), scene), got = run(subject(), permuted);
  core::State reordered;
  for (const int i : place) reordered.push_back(got[static_cast<std::size_t>(i)]);
  expect_within(fmt::format("bodies reordered, {}", subject().id), difference(reordered, expected), 0);
}

// The symmetries are worth nothing if the check cannot see a broken one: gravity left as it was.
TEST(ConventionsAlone, DetectsBrokenSymmetry) {
  const Subject& subject = subjects[0];
  core::Scene scene = tied(33), turned = scene;
  const Quaternion r = exact::RandomScenes(34).rotation();
  for (core::Body& body : turned.bodies) body.initial.velocity = r * body.initial.velocity;
  EXPECT_GT(difference(run(subject, turned), run(subject, scene)), 0.1);
}

}  // namespace
}  // namespace cylon::conformance
