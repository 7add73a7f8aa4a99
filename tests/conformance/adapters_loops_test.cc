// Joints that close a loop, against motions that share nothing with an engine: a body on two ball joints is a
// physical pendulum, three bodies joined in a ring turn as one, and a fixed joint holds.
#include "tests/conformance/adapters_fixture.h"

#include <cmath>
#include <string_view>

namespace cylon::conformance {
namespace {

class Loops : public EveryEngine {};

// MuJoCo closes loops by springs.  Their time is its own, 0.02 s, whatever the step, or two steps where less is asked for:
// then the error falls with the step as that of the others does.
std::vector<Subject> with_stiff_loops() {
  std::vector<Subject> all(std::begin(subjects), std::end(subjects));
  for (Subject& subject : all) {
    if (std::string_view(subject.id) == "mujoco") subject.id = "mujoco/solref-time=1e-9";
    if (std::string_view(subject.id) == "mujoco3") subject.id = "mujoco3/solref-time=1e-9";
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Adapters, Loops, testing::ValuesIn(with_stiff_loops()), test_name);

core::Joint ball(int body, int to, const Vector3& point) {
  core::Joint joint;
  joint.body = body, joint.to = to, joint.point = point;
  return joint;
}

// ---- A body on two ball joints -------------------------------------------------------------------

// What a body of a loop is, besides its joints.
struct Kind {
  const char* name;
  double mass;
  bool shape;
};
const Kind kinds[] = {
    {"without a shape", 1.7, false},
    {"with a shape", 1.7, true},
    // 1e4 N s in a step: a limit of the impulse shows.
    {"heavy", 1.7e6, false},
    {"heavy, with a shape", 1.7e6, true},
};

// A body that starts at rest, on ball joints at two points of an axis.
struct Pendulum {
  core::Scene scene;
  Vector3 pivot, axis, gravity;

  explicit Pendulum(const Kind& kind) {
    exact::RandomScenes random(171);
    pivot = random.vector(0.5), axis = random.vector(1).normalized();
    gravity = 9.81 * random.vector(1).normalized();
    core::Body body = random.body({0.04, 0.06, 0.075});
    body.name = "a";
    body.inertia *= kind.mass / body.mass, body.mass = kind.mass;
    body.initial.position = pivot + Vector3(0.3, -0.2, 0.25);
    body.initial.velocity = body.initial.angular_velocity = Vector3::Zero();
    if (kind.shape) body.shape = core::Sphere{0.1}, body.collide = true;
    scene.bodies = {body};
    scene.forces = {core::UniformGravity{gravity}};
    scene.joints = {ball(0, core::world, pivot), ball(0, core::world, pivot + 0.4 * axis)};
  }

  // The centre at time t: with the arm d across the axis u,
  //   (u.I u + m d^2) angle'' = u.(d(angle) x m g),
  // by the Stoermer-Verlet scheme, twice, and Richardson's extrapolation.
  Vector3 centre(double t) const {
    const core::Body& body = scene.bodies[0];
    const Vector3 from_pivot = body.initial.position - pivot;
    const Vector3 along = axis.dot(from_pivot) * axis, arm = from_pivot - along;
    const core::Matrix3 inertia = core::world_inertia(body, body.initial.orientation);
    const double moment = axis.dot(inertia * axis) + body.mass * arm.squaredNorm();
    const auto turned = [&](double angle) { return Eigen::AngleAxisd(angle, axis) * arm; };
    const auto angle_at_end = [&](int steps) {
      const double h = t / steps;
      double angle = 0, rate = 0;
      const auto kick = [&] {
        rate += h / 2 * axis.dot(Vector3(turned(angle)).cross(body.mass * gravity)) / moment;
      };
      for (int i = 0; i < steps; ++i) kick(), angle += h * rate, kick();
      return angle;
    };
    return pivot + along + turned((4 * angle_at_end(8000) - angle_at_end(4000)) / 3);
  }
};

TEST_P(Loops, ABodyOnTwoBallJointsIsAPhysicalPendulum) {
  constexpr double end = 0.6;
  for (const Kind& kind : kinds) {
    const Pendulum pendulum(kind);
    const Vector3 exact = pendulum.centre(end);
    ASSERT_GT((exact - pendulum.scene.bodies[0].initial.position).norm(), 0.2) << "hardly a motion";
    const auto error = [&](std::int64_t steps) {
      const core::State state =
          last(subject().choice(), pendulum.scene, end / static_cast<double>(steps), steps);
      return (state[0].position - exact).norm();
    };
    const std::string what = fmt::format("pendulum on two balls, {}, {}", kind.name, subject().id);
    const double coarse = error(600), fine = error(1200);
    // A step of semi-implicit Euler is off by dt T |x''|/2 <= 3e-3 m at 1 ms.
    expect_within(what, coarse, subject().order > 1 ? 1e-6 : 3e-3);
    expect_within(what + ", half the step", fine, 0.6 * coarse + 1e4 * subject().unit());
  }
}

// Without the second joint it is another motion, so the test can fail.
TEST(LoopsAlone, OneBallJointIsAnotherMotion) {
  Pendulum pendulum(kinds[0]);
  const Vector3 exact = pendulum.centre(0.6);
  pendulum.scene.joints.pop_back();
  EXPECT_GT((last(subjects[0].choice(), pendulum.scene, 1e-3, 600)[0].position - exact).norm(), 0.05);
}

// ---- A ring of three ------------------------------------------------------------------------------

constexpr double ring_rate = 2.5;  // [rad/s]

// Three bodies whose joints are the corners of a triangle, all turning as one about their common centre of
// mass: the joints pull each body inwards, and a triangle cannot fold.  Only the bodies in `shaped` have
// shapes.
core::Scene ring(const std::vector<int>& shaped) {
  exact::RandomScenes random(172);
  const Quaternion turn = random.rotation();
  const Vector3 normal = turn * Vector3::UnitZ(), drift = random.vector(1);
  const Vector3 corners[] = {turn * Vector3(0, 0, 0), turn * Vector3(1.1, 0.1, 0),
                             turn * Vector3(0.3, 0.9, 0)};
  core::Scene scene;
  double mass = 0;
  Vector3 centre = Vector3::Zero();
  for (int i = 0; i < 3; ++i) {
    core::Body body;
    body.name = std::string(1, "abc"[i]);
    body.mass = 1 + 0.4 * i;
    body.inertia = Vector3(0.03 + 0.01 * i, 0.05, 0.06).asDiagonal();
    body.initial.orientation = turn * Quaternion(Eigen::AngleAxisd(0.7 * i, Vector3::UnitZ()));
    body.initial.position = (corners[i] + corners[(i + 1) % 3]) / 2;
    mass += body.mass, centre += body.mass * body.initial.position;
    scene.bodies.push_back(body);
    scene.joints.push_back(ball(i, (i + 1) % 3, corners[(i + 1) % 3]));
  }
  centre /= mass;
  for (core::Body& body : scene.bodies) {
    body.initial.angular_velocity = ring_rate * normal;
    body.initial.velocity = drift + body.initial.angular_velocity.cross(body.initial.position - centre);
  }
  for (const int i : shaped) {
    core::Body& body = scene.bodies[static_cast<std::size_t>(i)];
    body.shape = core::Sphere{0.1}, body.collide = true;
  }
  scene.materials = {{{"*", "*"}, 0, 0}};
  return scene;
}

// Every state of the ring at time t: its centre drifts, and it turns by rate t.
core::State turned_ring(const core::Scene& scene, double t) {
  double mass = 0;
  Vector3 centre = Vector3::Zero(), drift = Vector3::Zero();
  for (const core::Body& body : scene.bodies) {
    mass += body.mass;
    centre += body.mass * body.initial.position, drift += body.mass * body.initial.velocity;
  }
  centre /= mass, drift /= mass;
  const Vector3 w = scene.bodies[0].initial.angular_velocity;
  const Quaternion turn(Eigen::AngleAxisd(w.norm() * t, w.normalized()));
  core::State state;
  for (const core::Body& body : scene.bodies) {
    const Vector3 arm = turn * (body.initial.position - centre);
    state.push_back({centre + drift * t + arm, turn * body.initial.orientation, drift + w.cross(arm), w});
  }
  return state;
}

TEST_P(Loops, ARingOfThreeTurnsAsOne) {
  constexpr double end = 0.5;
  for (const std::vector<int>& shaped : {std::vector<int>{}, {1}, {0, 1, 2}}) {
    const core::Scene scene = ring(shaped);
    const auto error = [&](std::int64_t steps) {
      return difference(last(subject().choice(), scene, end / static_cast<double>(steps), steps),
                        turned_ring(scene, end));
    };
    const std::string what = fmt::format("ring, {} with shapes, {}", shaped.size(), subject().id);
    const double coarse = error(500), fine = error(1000);
    expect_within(what, coarse, 2e-2);
    expect_within(what + ", half the step", fine, 0.6 * coarse + 1e5 * subject().unit());
  }
}

// An open chain unfolds, so the test can fail.
TEST(LoopsAlone, AnOpenRingIsAnotherMotion) {
  core::Scene scene = ring({});
  scene.joints.pop_back();
  EXPECT_GT(difference(last(subjects[0].choice(), scene, 1e-3, 500), turned_ring(scene, 0.5)), 0.1);
}

// ---- A fixed joint ----------------------------------------------------------------------------------

// Hung on a ball and held by a fixed joint elsewhere, a body stays where it is.
TEST_P(Loops, AFixedJointHoldsWhatABallCarries) {
  for (const double mass : {1.7, 1.7e6}) {
    core::Scene scene = Pendulum({"", mass, false}).scene;
    scene.joints[1].type = core::JointType::fixed;
    const core::State start = core::initial_state(scene);
    core::State end = last(subject().choice(), scene, 1e-3, 600);
    // The solver's feedback holds a displacement of g dt^2/erp = 5e-5 m at most, and a drift is none.
    expect_within(fmt::format("held at {} kg, {}", mass, subject().id),
                  (end[0].position - start[0].position).norm(), 1e-4);
  }
}

}  // namespace
}  // namespace cylon::conformance
