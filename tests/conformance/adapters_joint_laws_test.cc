// Sliders, screws, universal joints and what acts along them, on every engine that takes them, against the certified
// solution of the scene.
#include "harness/core/held_joint.h"
#include "harness/scenario/input.h"
#include "harness/scenario/scenario.h"
#include "reference/certified/truth.h"
#include "tests/conformance/adapters_joint_cases.h"

#include <cmath>
#include <filesystem>
#include <functional>

namespace cylon::conformance {
namespace {

using core::JointType;

const Vector3 gravity(0.4, -9.81, 0.2);

struct Machine {
  const char* name;
  std::function<core::Scene()> scene;
};

core::Scene on_a_spring(JointType type) {
  core::Scene scene = at_rest(1);
  scene.forces = {core::UniformGravity{gravity}};
  core::Joint joint = joint_of(type);
  const core::JointCoordinate acts{
      .start = 0.2, .force = 1.1, .stiffness = 30, .damping = 1.5, .target = -0.3};
  if (core::kind_of(type).displacements() > 0) joint.displacements.push_back({acts});
  if (core::kind_of(type).displacements() > 1)
    joint.displacements.push_back({{.which = core::Ordinal::second, .stiffness = 20}});
  if (core::kind_of(type).angles() > 0) joint.angles.push_back({acts});
  if (core::kind_of(type).angles() > 1)
    joint.angles.push_back({{.which = core::Ordinal::second, .damping = 0.7}});
  if (core::kind_of(type).angles() > 2)
    joint.angles.push_back({{.which = core::Ordinal::third, .stiffness = 12, .target = 0.2}});
  scene.joints = {joint};
  return scene;
}

const Machine machines[] = {
    {"slider", [] { return on_a_spring(JointType::slider); }},
    {"hinge", [] { return on_a_spring(JointType::hinge); }},
    {"cylindrical", [] { return on_a_spring(JointType::cylindrical); }},
    {"planar", [] { return on_a_spring(JointType::planar); }},
    {"universal", [] { return on_a_spring(JointType::universal); }},
    {"screw", [] { return on_a_spring(JointType::screw); }},
    {"gimbal", [] { return on_a_spring(JointType::gimbal); }},
    {"rectangular", [] { return on_a_spring(JointType::rectangular); }},
    {"offset universal", [] { return on_a_spring(JointType::offset_universal); }},
};

class JointLaws : public EveryEngine {};
INSTANTIATE_TEST_SUITE_P(Adapters, JointLaws, testing::ValuesIn(subjects_with_dart()), test_name);

constexpr double end = 0.6;

// The exact motion, and how fast it changes: the largest size of its k-th time derivative, by central differences.
class Motion {
 public:
  explicit Motion(const core::Scene& scene) {
    const certified::Solution exact = certified::solution(scene, end, 1e11);
    for (int i = 0; i <= points; ++i) numbers_.push_back(numbers(exact.truth.state(end * i / points)));
    last_ = exact.truth.state(end);
  }
  const core::State& last() const { return last_; }

  double size(int k) const {
    std::vector<Eigen::VectorXd> d = numbers_;
    for (int i = 0; i < k; ++i) {
      for (std::size_t j = 0; j + 1 < d.size(); ++j) d[j] = (d[j + 1] - d[j]) * points / end;
      d.pop_back();
    }
    double most = 0;
    for (const Eigen::VectorXd& one : d) most = std::max(most, one.norm());
    return most;
  }

 private:
  static constexpr int points = 60;

  static Eigen::VectorXd numbers(const core::State& state) {
    Eigen::VectorXd all(13 * static_cast<Eigen::Index>(state.size()));
    Eigen::Index at = 0;
    for (const core::BodyState& body : state) {
      all.segment<3>(at) = body.position, all.segment<4>(at + 3) = 2 * body.orientation.coeffs();
      all.segment<3>(at + 7) = body.velocity, all.segment<3>(at + 10) = body.angular_velocity;
      at += 13;
    }
    return all;
  }

  std::vector<Eigen::VectorXd> numbers_;
  core::State last_;
};

// A step of a scheme of order p adds  dt^(p+1) |y^(p+1)|/(p+1)!  at most where y is its Taylor polynomial, and a run of
// T adds T/dt of them.  A Runge-Kutta scheme has the size of that, not the number: ten times it.
double truncation(const Subject& subject, const Motion& motion, double dt) {
  const int p = subject.order;
  const double taylor = end * std::pow(dt, p) * motion.size(p + 1) / std::tgamma(p + 2);
  return p > 1 ? 10 * taylor : taylor;
}
// Four roundings of the largest number of the state in each step.
double rounding(const Subject& subject, const Motion& motion, std::int64_t steps) {
  return 4 * static_cast<double>(steps) * subject.unit() * motion.size(0);
}

TEST_P(JointLaws, MoveAsCertified) {
  const core::Engine engine = process::describe(subject().choice(), limits);
  int run = 0;
  std::string refused;
  for (const Machine& machine : machines) {
    const core::Scene scene = machine.scene();
    if (const auto reason = refusal(engine, subject().choice(), scene)) {
      refused += fmt::format("\n  {}: {}", machine.name, *reason);
      continue;
    }
    ++run;
    const Motion motion(scene);
    ASSERT_GT(difference(motion.last(), core::initial_state(scene)), 0.1)
        << machine.name << ": hardly a motion";
    for (const std::int64_t steps : {1200, 2400}) {
      const double dt = end / static_cast<double>(steps);
      expect_within(fmt::format("{}, {}, {} steps", machine.name, subject().id, steps),
                    difference(last(subject().choice(), scene, dt, steps), motion.last()),
                    truncation(subject(), motion, dt) + rounding(subject(), motion, steps));
    }
  }
  EXPECT_EQ(run, taken_by(subject()).machines) << "refused:" << refused;
  if (run == 0) GTEST_SKIP() << "takes none of these scenes:" << refused;
}

// ---- Joints of several turns are hinges with rings of no mass between them ---------------------------------

core::Joint hinge(int body, int to, const Vector3& at, const Vector3& about, core::JointAngle angle) {
  angle.which = core::Ordinal::first;
  core::Joint joint{.type = JointType::hinge, .body = body, .to = to, .point = at, .axis = about};
  joint.angles = {angle};
  return joint;
}
core::Body ring_of(const core::Body& like, double part, const char* name, const Vector3& spin) {
  core::Body ring = like;
  ring.name = name, ring.mass = part, ring.inertia = part * core::Matrix3::Identity();
  ring.initial = {.position = point, .angular_velocity = spin};
  return ring;
}

const core::JointAngle first_law{
    {.start = 0.2, .stiffness = 6, .damping = 0.3, .armature = 0.4, .target = -0.3}};
const core::JointAngle second_law{{.which = core::Ordinal::second, .force = 0.7, .armature = 0.2}};
const core::JointAngle third_law{{.which = core::Ordinal::third, .stiffness = 9, .armature = 0.3}};

// The certified motion, and that of the in-house engine with rings of so much inertia, which comes to it as that goes to 0.
void expect_limit(const core::Scene& exact, const std::function<core::Scene(double)>& with_rings) {
  const core::BodyState end_of_truth = certified::solution(exact, end, 1e11).truth.state(end)[0];
  ASSERT_GT((end_of_truth.position - exact.bodies[0].initial.position).norm(), 0.1) << "hardly a motion";
  const auto off = [&](double part) {
    const core::BodyState state =
        last(process::parse_engine("in-house", process::default_engines(binary_dir)), with_rings(part),
             end / 600, 600)[0];
    return (state.position - end_of_truth.position).norm() +
           (state.angular_velocity - end_of_truth.angular_velocity).norm();
  };
  const double coarse = off(1e-4), fine = off(1e-5);
  EXPECT_LT(coarse, 5e-3);
  EXPECT_NEAR(coarse / fine, 10, 0.1);
}

TEST(JointLawsAlone, GimbalIsThreeHingesWithoutRings) {
  core::Scene scene = at_rest(1);
  scene.forces = {core::UniformGravity{gravity}};
  core::Joint gimbal = joint_of(JointType::gimbal);
  gimbal.angles = {first_law, second_law, third_law};
  scene.joints = {gimbal};
  const Vector3 tilted = *gimbal.axis_2, between = axis.cross(tilted).normalized();
  core::BodyState& start = scene.bodies[0].initial;
  start.angular_velocity = 0.9 * axis - 0.6 * between + 0.5 * tilted;
  start.velocity = start.angular_velocity.cross(start.position - point);
  expect_limit(scene, [&](double part) {
    core::Scene rings = scene;
    rings.bodies.push_back(ring_of(scene.bodies[0], part, "outer", 0.9 * axis));
    rings.bodies.push_back(ring_of(scene.bodies[0], part, "inner", 0.9 * axis - 0.6 * between));
    rings.joints = {hinge(1, core::world, point, axis, first_law), hinge(2, 1, point, between, third_law),
                    hinge(0, 2, point, tilted, second_law)};
    return rings;
  });
}

TEST(JointLawsAlone, OffsetUniversalIsTwoHingesWithoutARing) {
  core::Scene scene = at_rest(1);
  scene.forces = {core::UniformGravity{gravity}};
  core::Joint joint = joint_of(JointType::offset_universal);
  joint.angles = {first_law, second_law};
  scene.joints = {joint};
  const Vector3 far = core::held_point_of_body(joint), ring_spin = 0.9 * axis;
  core::BodyState& start = scene.bodies[0].initial;
  start.angular_velocity = ring_spin + 0.5 * axis_2;
  start.velocity = ring_spin.cross(far - point) + start.angular_velocity.cross(start.position - far);
  expect_limit(scene, [&](double part) {
    core::Scene rings = scene;
    rings.bodies.push_back(ring_of(scene.bodies[0], part, "ring", ring_spin));
    rings.joints = {hinge(1, core::world, point, axis, first_law), hinge(0, 1, far, axis_2, second_law)};
    return rings;
  });
}

// A machine is not what it is without a part of it: the test above sees each.
TEST(JointLawsAlone, EveryPartMatters) {
  const core::Scene whole = on_a_spring(JointType::slider);
  const core::State exact = certified::solution(whole, end, 1e11).truth.state(end);
  double core::JointCoordinate::*const parts[] = {
      &core::JointCoordinate::start, &core::JointCoordinate::force, &core::JointCoordinate::stiffness,
      &core::JointCoordinate::damping, &core::JointCoordinate::target};
  for (const auto part : parts) {
    core::Scene other = whole;
    other.joints[0].displacements[0].*part = 0;
    EXPECT_GT(difference(certified::solution(other, end, 1e11).truth.state(end), exact), 0.02);
  }
}

// ---- Mixes ------------------------------------------------------------------------------------------

scenario::Scenario mix(const std::string& name) {
  return scenario::load(std::filesystem::path(source_dir) / ("tests/data/mixes/" + name + ".toml"));
}

core::State end_of(const scenario::Scenario& scenario, const std::string& engine, std::int64_t per_second) {
  return last(process::parse_engine(engine, process::default_engines(binary_dir)), scenario.scene,
              1 / static_cast<double>(per_second),
              std::llround(scenario.duration * static_cast<double>(per_second)));
}

double apart(const core::State& a, const core::State& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, (a[i].position - b[i].position).norm());
  return worst;
}

// Stops, dry friction and springs of joints beside contacts that bounce and rub.  ODE sees an event a step late, which moves
// a body by v dt: of some ten events at 4 m/s.
TEST(JointLawsAlone, BesideContactsAgreeWithOde) {
  for (const char* name : {"piston_on_floor", "flap_of_puck"}) {
    const scenario::Scenario scenario = mix(name);
    const core::State here = end_of(scenario, "in-house", 1000);
    constexpr std::int64_t per_second = 20'000;
    EXPECT_LT(apart(end_of(scenario, "ode", per_second), here), 10 * 4.0 / per_second) << name;
    for (double core::JointCoordinate::*const part :
         {&core::JointCoordinate::friction, &core::JointCoordinate::restitution}) {
      scenario::Scenario other = scenario;  // a motion that tells each part from its absence
      for (core::Joint& joint : other.scene.joints) {
        for (auto& c : joint.displacements) c.*part = 0;
        for (auto& c : joint.angles) c.*part = 0;
      }
      EXPECT_GT(apart(end_of(other, "in-house", 1000), here), 2 * 10 * 4.0 / per_second) << name;
    }
  }
}

// A blow of a stop while the body that carries it rubs on a floor, in fixed steps and by events.  Steps see a blow late by
// up to dt, which moves a body by v dt: of some ten blows at 2 m/s.
TEST(JointLawsAlone, BesideFrictionAgreeInStepsAndByEvents) {
  const scenario::Scenario scenario = mix("arm_on_sliding_base");
  const core::State events = end_of(scenario, "in-house/path=events", 1000);
  for (const std::int64_t per_second : {2000, 16'000})
    EXPECT_LT(apart(end_of(scenario, "in-house/path=stepping", per_second), events),
              10 * 2.0 / static_cast<double>(per_second));
}

// A screw, a universal joint, damping, a target that moves, drag and thrust: error control against 12 000 steps of order 4.
TEST(JointLawsAlone, BesideForcesAgreeWithSmallSteps) {
  const scenario::Scenario scenario = mix("arm_on_screw");
  EXPECT_LT(apart(end_of(scenario, "in-house", 1000), end_of(scenario, "in-house/integrator=rk4", 8000)),
            1e-10);
}

}  // namespace
}  // namespace cylon::conformance
