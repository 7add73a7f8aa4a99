// What no reference engine has, over time, on every engine: a frame that turns, a mass that changes, water.  Each
// against a closed form or an independent integration, with the order of the integrator, and against the scene
// without it.
#include "tests/conformance/adapters_fixture.h"
#include "tests/reference/exact/newton_euler.h"

#include <cmath>
#include <functional>

namespace cylon::conformance {
namespace {

class Applied : public EveryEngine {
 protected:
  // The error at 800 steps is a tenth (order 1) of that at 80, and a hundredth of `effect`: what is wrong
  // where the law is left out.
  void expect_order(const std::string& what, const std::function<double(std::int64_t)>& error, double effect,
                    int order = 0) {
    if (order == 0) order = subject().order;
    const double coarse = error(80), fine = error(800);
    expect_within(fmt::format("{}, {}", what, subject().id), fine,
                  1.25 * coarse / std::pow(10, order) + 2000 * subject().unit() * (1 + effect));
    expect_within(fmt::format("{}, the fine step, {}", what, subject().id), fine, effect / 100);
  }
};
INSTANTIATE_TEST_SUITE_P(Adapters, Applied, testing::ValuesIn(subjects), test_name);

core::Scene one_body(unsigned seed) {
  core::Scene scene = three_bodies(seed);
  scene.bodies.resize(1);
  return scene;
}

// ---- A frame that turns --------------------------------------------------------------------------------

// Free motion in space, seen from a frame that turns with W:  p = R^-1 p',  v = R^-1 v' - W x p,
// q = R^-1 q',  w = R^-1 w' - W.
core::BodyState seen_from_frame(const core::Scene& scene, double t) {
  const Vector3 turn = scene.frame->angular_velocity;
  core::Scene space = scene;
  space.frame.reset();
  core::BodyState& start = space.bodies[0].initial;
  start.velocity += turn.cross(start.position);
  start.angular_velocity += turn;
  core::BodyState s = exact::NewtonEuler(space, 0).at(t, 1e-2L);
  const Quaternion back(Eigen::AngleAxisd(-turn.norm() * t, turn.normalized()));
  s.position = back * s.position;
  s.velocity = back * s.velocity - turn.cross(s.position);
  s.orientation = back * s.orientation;
  s.angular_velocity = back * s.angular_velocity - turn;
  return s;
}

TEST_P(Applied, TurningFrameShowsFreeMotionTurnedBack) {
  core::Scene scene = one_body(61);
  scene.bodies[0].initial.angular_velocity *= 0.25;
  scene.frame = core::Frame{{0.3, -0.8, 0.5}, {0.35, 0.6, -0.45}};
  const double t = 0.6;
  const core::BodyState exact = seen_from_frame(scene, t);
  const auto error = [&](std::int64_t steps) {
    return difference(last(subject().choice(), scene, t / static_cast<double>(steps), steps), {exact});
  };
  core::Scene still = scene;
  still.frame.reset();
  const double effect = difference(last(subject().choice(), still, t / 800, 800), {exact});
  expect_order("a turning frame", error, effect);
}

// A frame that only moves changes nothing, to the last bit.
TEST_P(Applied, MovingFrameChangesNothing) {
  core::Scene scene = three_bodies(71);
  scene.forces = {core::UniformGravity{{2.3, -7.1, 4.9}},
                  core::Spring{0, {0.2, 0, 0.1}, 1, {0, 0.1, 0}, 17, 0.4, 1.9}, core::Drag{2, 1.1, 0.4, 0}};
  const core::State still = last(subject().choice(), scene, 1e-3, 300);
  scene.frame = core::Frame{{0.7, -0.4, 1.1}, Vector3::Zero()};
  EXPECT_EQ(difference(last(subject().choice(), scene, 1e-3, 300), still), 0);
}

// ---- A mass that changes -------------------------------------------------------------------------------

const Vector3 gravity(1.3, -6.2, 2.4), gas(-3.1, -5.7, 1.9), mist(0.4, -0.9, 0.7);

// m v' = m g + mu c:  v = v_0 + g t + c ln(m/m_0).
Vector3 rocket(const core::Body& body, double rate, double t) {
  return body.initial.velocity + t * gravity +
         std::log1p(rate * t / body.mass) * (body.initial.orientation * gas);
}

// (m v)' = m g + mu u:  m v = m_0 v_0 + mu u t + (m_0 t + mu t^2/2) g.
Vector3 gathering(const core::Body& body, double rate, double t) {
  const double m = body.mass + rate * t;
  return (body.mass * body.initial.velocity + rate * t * mist + (body.mass + rate * t / 2) * t * gravity) / m;
}

// m v' = F with F held in body axes:  v = v_0 + F/mu ln(m/m_0) + g t;  the mass leaves at rest relative to it.
Vector3 leaking(const core::Body& body, double rate, double t) {
  return body.initial.velocity + t * gravity +
         std::log1p(rate * t / body.mass) / rate * (body.initial.orientation * Vector3(2.3, -1.1, 3.7));
}

struct Changing {
  const char* name;
  double share;  // of the mass, gained or lost in a second
  std::vector<core::Thrust> thrusts;
  Vector3 (*velocity)(const core::Body&, double rate, double t);
};
const Changing changing[] = {
    {"rocket", -0.55, {{.exhaust_velocity = gas}}, rocket},
    {"accretion", 0.8, {{.exchanged_velocity = mist}}, gathering},
    {"leak under thrust",
     -0.4,
     {{.exhaust_velocity = Vector3::Zero()}, {.force = {2.3, -1.1, 3.7}}},
     leaking},
};

// MuJoCo keeps in a place of its own what a body of principal axes resists: a rocket had its first mass to the end.
TEST_P(Applied, ChangingMassFollowsItsMomentum) {
  const double t = 1.1;
  for (const bool principal : {false, true})
    for (const Changing& row : changing) {
      core::Scene scene = one_body(63);
      if (principal) scene.bodies[0].inertia = Vector3(0.31, 0.42, 0.53).asDiagonal();
      scene.bodies[0].initial.angular_velocity.setZero();
      const double rate = row.share * scene.bodies[0].mass;
      scene.forces = {core::UniformGravity{gravity}};
      for (core::Thrust thrust : row.thrusts) {
        if (thrust.force.isZero()) thrust.mass_rate = rate;
        scene.forces.emplace_back(thrust);
      }
      const Vector3 exact = row.velocity(scene.bodies[0], rate, t);
      const auto error = [&](std::int64_t steps) {
        return (last(subject().choice(), scene, t / static_cast<double>(steps), steps)[0].velocity - exact)
            .norm();
      };
      core::Scene constant = scene;
      std::get<core::Thrust>(constant.forces[1]).mass_rate = 0;
      const double effect = (last(subject().choice(), constant, t / 800, 800)[0].velocity - exact).norm();
      expect_order(fmt::format("{}{}", row.name, principal ? " of principal axes" : ""), error, effect,
                   subject().order_of_masses);
    }
}

// Of two bodies that a fixed joint ties, the one behind loses mass: (m_a + m_b) v' = mu c, both of one velocity
// and without turning, as the gas leaves along the line of centres.
TEST_P(Applied, ChangingMassActsThroughJoints) {
  core::Scene scene = three_bodies(64);
  scene.bodies.pop_back();
  core::Body &a = scene.bodies[0], &b = scene.bodies[1];
  const Vector3 along = Vector3(0.6, -0.3, 0.8).normalized();
  for (core::Body* body : {&a, &b}) body->initial.angular_velocity.setZero();
  b.initial.velocity = a.initial.velocity;
  b.initial.position = a.initial.position + 0.7 * along;
  scene.joints = {
      {.type = core::JointType::fixed, .body = 1, .to = 0, .point = a.initial.position + 0.3 * along}};
  const double rate = -0.6 * b.mass, speed = 4.2, t = 1.1;
  scene.forces = {core::Thrust{.body = 1,
                               .mass_rate = rate,
                               .exhaust_velocity = b.initial.orientation.conjugate() * (-speed * along)}};
  const Vector3 exact = a.initial.velocity - speed * std::log1p(rate * t / (a.mass + b.mass)) * along;
  const auto error = [&](std::int64_t steps) {
    const core::State end = last(subject().choice(), scene, t / static_cast<double>(steps), steps);
    return std::max((end[0].velocity - exact).norm(), (end[1].velocity - exact).norm());
  };
  const double effect = (exact - a.initial.velocity).norm();
  if (subject().iterative || subject().single)
    expect_within(fmt::format("a rocket's load, {}", subject().id), error(800), effect / 100);
  else
    expect_order("a rocket's load", error, effect, subject().order_of_masses);
}

// ---- Water ------------------------------------------------------------------------------------------------

// Of a sphere below y = height: slices pi (r^2 - z^2) dz.
double volume_below(double radius, double centre, double height) {
  const double z = std::clamp(height - centre, -radius, radius);
  return M_PI * (radius * radius * (z + radius) - (z * z * z + radius * radius * radius) / 3);
}

const double radius = 0.45;
const core::Water lake = {.level = 0.3, .wave = 0.25, .speed = 1.7, .buoyancy = 9.0, .drag = 2.3};

// A ball in a lake, with drag and wave, gravity along y: Runge-Kutta 4 of many steps.
Vector3 ball_in_lake(const core::Body& body, const core::Water& water, double g, double t) {
  using Point = Eigen::Matrix<double, 6, 1>;
  const auto rate = [&](double at, const Point& x) {
    const double height = water.level + water.wave * std::sin(x[0] - water.speed * at);
    const double volume = volume_below(radius, x[1], height), whole = 4 * M_PI / 3 * std::pow(radius, 3);
    Point dx;
    dx.head<3>() = x.tail<3>();
    dx.tail<3>() = Vector3(0, -g, 0) + (water.buoyancy * volume * g * Vector3::UnitY() -
                                        water.drag * volume / whole * x.tail<3>()) /
                                           body.mass;
    return dx;
  };
  Point x;
  x << body.initial.position, body.initial.velocity;
  const int n = 20000;
  const double h = t / n;
  for (int i = 0; i < n; ++i) {
    const Point a = rate(i * h, x), b = rate((i + 0.5) * h, x + h / 2 * a),
                c = rate((i + 0.5) * h, x + h / 2 * b), d = rate((i + 1) * h, x + h * c);
    x += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return x.head<3>();
}

core::Scene floating(unsigned seed) {
  core::Scene scene = one_body(seed);
  core::Body& ball = scene.bodies[0];
  ball.shape = core::Sphere{radius};
  ball.mass = 1.6;
  ball.initial.angular_velocity.setZero();
  return scene;
}

TEST_P(Applied, BallInALakeFollowsArchimedes) {
  if (!subject().archimedes) GTEST_SKIP() << "the adapter refuses water by volume";
  const double g = 8.3, t = 1.4;
  core::Scene scene = floating(65);
  scene.bodies[0].initial.position = {0.4, 0.9, -0.3};
  scene.bodies[0].initial.velocity = {0.5, -1.2, 0.8};
  scene.forces = {core::UniformGravity{{0, -g, 0}}, lake};
  const Vector3 exact = ball_in_lake(scene.bodies[0], lake, g, t);
  const auto error = [&](std::int64_t steps) {
    return (last(subject().choice(), scene, t / static_cast<double>(steps), steps)[0].position - exact)
        .norm();
  };
  core::Scene dry = scene;
  dry.forces.pop_back();
  const double effect = (last(subject().choice(), dry, t / 800, 800)[0].position - exact).norm();
  expect_order("a ball in a lake", error, effect);
}

// A ball that floats bobs with w^2 = density g A/m, A the area of its waterline:  y = y_0 + a cos w t  to the
// order of a/r.
TEST_P(Applied, FloatingBallBobsAboutItsWaterline) {
  if (!subject().archimedes) GTEST_SKIP() << "the adapter refuses water by volume";
  const double g = 8.3, above = 0.12, amplitude = subject().single ? 3e-3 : 1e-4;
  core::Scene scene = floating(66);
  core::Body& ball = scene.bodies[0];
  const core::Water calm = {.level = 0.3, .buoyancy = 9.0};
  ball.mass = calm.buoyancy * volume_below(radius, above, 0);
  ball.initial.velocity.setZero();
  ball.initial.position = {0.4, calm.level + above + amplitude, -0.7};
  scene.forces = {core::UniformGravity{{0, -g, 0}}, calm};
  const double area = M_PI * (radius * radius - above * above);
  const double w = std::sqrt(calm.buoyancy * g * area / ball.mass), t = 0.85 * 2 * M_PI / w;
  const auto bobs = [&](std::int64_t steps) {
    const core::State end = last(subject().choice(), scene, t / static_cast<double>(steps), steps);
    return (end[0].position.y() - calm.level - above) / amplitude;
  };
  // What a linear oscillator leaves out is a/(2 r) a period; semi-implicit Euler's phase is off by w dt/2.
  expect_within(
      fmt::format("a floating ball, {}", subject().id), std::abs(bobs(2000) - std::cos(w * t)),
      2 * amplitude / radius + (subject().order > 1 ? 0 : w * t / 2000) + 20 * subject().unit() / amplitude);
  ball.initial.position.y() -= amplitude;  // on its waterline it stays
  expect_within(
      fmt::format("a ball on its waterline, {}", subject().id),
      std::abs(last(subject().choice(), scene, t / 2000, 2000)[0].position.y() - calm.level - above),
      100 * subject().unit());
}

// Water in steps, below its surface throughout:  m v' = m g + B - d v,  L' = -L.
TEST_P(Applied, WaterInStepsLiftsDragsAndStopsSpin) {
  core::Scene scene = one_body(67);
  core::Body& cork = scene.bodies[0];
  cork.inertia = 0.37 * core::Matrix3::Identity();
  cork.initial.position = {0.6, -4.2, -1.1};
  const core::Water water = {
      .level = 3, .wave = 0.2, .speed = 0.2, .buoyancy = 11.0, .drag = 2.0, .mode = "step"};
  scene.forces = {core::UniformGravity{gravity}, water};
  const double t = 1.2, d = water.drag / cork.mass;
  const Vector3 end = gravity / d + Vector3(0, water.buoyancy / water.drag, 0);
  const Vector3 velocity = end + std::exp(-d * t) * (cork.initial.velocity - end);
  const Vector3 spin = std::exp(-t) * cork.initial.angular_velocity;
  const auto error_in = [&](const core::Scene& in, std::int64_t steps) {
    const core::BodyState s = last(subject().choice(), in, t / static_cast<double>(steps), steps)[0];
    return std::max((s.velocity - velocity).norm(), (s.angular_velocity - spin).norm());
  };
  core::Scene dry = scene;
  dry.forces.pop_back();
  expect_order(
      "water in steps", [&](std::int64_t steps) { return error_in(scene, steps); }, error_in(dry, 800));
}

// ---- What ends a run -----------------------------------------------------------------------------------------

// A mass that is used up has no motion: the run ends with a sentence, never with a mass below zero.
TEST(AppliedLimits, MassUsedUpEndsTheRun) {
  core::Scene scene = one_body(68);
  scene.bodies[0].mass = 1;
  scene.forces = {core::Thrust{.body = 0, .mass_rate = -2, .exhaust_velocity = Vector3(0, -3, 0)}};
  for (const char* id : {"bullet", "bullet-multibody", "ode"}) {
    process::RunRequest request;
    request.scene = &scene;
    request.setup.dt = 1e-2;
    request.steps = 100;
    const auto engine = process::parse_engine(id, process::default_engines(binary_dir));
    const process::RunOutcome outcome = process::run(engine, request, limits);
    EXPECT_FALSE(outcome.recording) << id;
    EXPECT_NE(outcome.reason.find("the mass of 'a' is"), std::string::npos) << id << ": " << outcome.reason;
    EXPECT_NE(outcome.reason.find("at t = 0.5"), std::string::npos) << id << ": " << outcome.reason;
  }
}

}  // namespace
}  // namespace cylon::conformance
