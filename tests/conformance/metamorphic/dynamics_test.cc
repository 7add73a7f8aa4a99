// Related motions: boost, time reversal, free fall, split runs, superposition, fixed joints.
#include "tests/conformance/metamorphic/random_scenes.h"

namespace cylon::core {
namespace {

constexpr double duration = dt * steps;
const Ingredients isolated = {.outside = false}, conservative = {.losses = false};

// The scene with another start; the points of joints go where the first body takes them.
Scene from(Scene scene, const State& start) {
  for (Joint& j : scene.joints) {
    const BodyState &a = scene.bodies[0].initial, &b = start[0];
    j.point = b.position + b.orientation * (a.orientation.conjugate() * (j.point - a.position));
  }
  for (std::size_t i = 0; i < start.size(); ++i) scene.bodies[i].initial = start[i];
  return scene;
}

State turned_round(State state) {
  for (BodyState& b : state) b.velocity = -b.velocity, b.angular_velocity = -b.angular_velocity;
  return state;
}

// 3. Isolated bodies: p + u t, v + u, the same turns.  Errata 2.
TEST(Relation3, BoostAddsUniformMotion) {
  for (int seed = 0; seed < scene_count; ++seed) {
    const Scene scene = random_scene(seed, isolated);
    const Vector3 u = Random(seed + 1000).vector(3);
    Scene boosted = scene;
    for (Body& b : boosted.bodies) b.initial.velocity += u;
    State expected = run(scene, with(integrator_of(seed)));
    for (BodyState& b : expected) b.position += duration * u, b.velocity += u;
    EXPECT_LE(distance(run(boosted, with(integrator_of(seed))), expected), bound(integrator_of(seed)))
        << "seed " << seed << ", " << integrator_of(seed);
  }
}

// 5. Without losses the film runs backwards; reversible integrators to rounding, auto to its tolerance.
TEST(Relation5, MotionIsTimeReversible) {
  for (int seed = 0; seed < scene_count; ++seed) {
    const std::string names[] = {"velocity-verlet", "yoshida4", "stormer-verlet", "yoshida6", "auto"};
    const std::string& integrator = names[seed % 5];
    const Scene scene = random_scene(seed, conservative);
    const State there = run(scene, with(integrator));
    const State home = turned_round(run(from(scene, turned_round(there)), with(integrator)));
    EXPECT_LE(distance(home, initial_state(scene)), 10 * bound(integrator))
        << "seed " << seed << ", " << integrator;
  }
}

// 9. In uniform gravity an isolated system only falls: p + g t^2/2, v + g t.
TEST(Relation9, FreeFallDoesNotDependOnMass) {
  for (int seed = 0; seed < scene_count; ++seed) {
    const std::string integrator = integrator_of(seed);
    const Scene scene = random_scene(seed, isolated);
    const Vector3 g = Random(seed + 1000).vector(10);
    Scene falling = scene;
    falling.forces.emplace_back(UniformGravity{g});
    State expected = run(scene, with(integrator));
    for (BodyState& b : expected) b.position += duration * duration / 2 * g, b.velocity += duration * g;
    EXPECT_LE(distance(run(falling, with(integrator)), expected), bound(integrator))
        << "seed " << seed << ", " << integrator;
  }
}

// 11. A run that stops half-way and starts again from what was read; without a clock in the forces.
TEST(Relation11, ARunMayBeSplit) {
  for (int seed = 0; seed < scene_count; ++seed) {
    const std::string integrator = integrator_of(seed);
    Scene scene = random_scene(seed, {});
    std::erase_if(scene.forces, [](const Force& f) { return std::holds_alternative<Drive>(f); });
    const State whole = run(scene, with(integrator)), half = run(scene, with(integrator), steps / 2);
    EXPECT_LE(distance(run(from(scene, half), with(integrator), steps / 2), whole), 10 * bound(integrator))
        << "seed " << seed << ", " << integrator;
  }
}

// 12. Springs without length are linear: solutions add, axes do not know of each other.
TEST(Relation12, SpringsWithoutLengthSuperpose) {
  for (int seed = 0; seed < scene_count; ++seed) {
    const std::string integrator = integrator_of(seed);
    Random random(seed);
    Scene a;
    for (int i = 0; i < 3; ++i) {
      Body body;
      body.mass = random.in(0.5, 2);
      body.inertia.setZero();
      body.initial = {random.vector(1), Quaternion::Identity(), random.vector(1), Vector3::Zero()};
      a.bodies.push_back(body);
      a.forces.emplace_back(
          Spring{i, Vector3::Zero(), i == 0 ? world : i - 1, Vector3::Zero(), random.in(2, 20), 0, 0});
    }
    Scene b = a, sum = a;
    for (std::size_t i = 0; i < 3; ++i) {
      b.bodies[i].initial.position = random.vector(1);
      b.bodies[i].initial.velocity = random.vector(1);
      sum.bodies[i].initial.position += b.bodies[i].initial.position;
      sum.bodies[i].initial.velocity += b.bodies[i].initial.velocity;
    }
    State expected = run(a, with(integrator));
    const State other = run(b, with(integrator));
    for (std::size_t i = 0; i < 3; ++i) {
      expected[i].position += other[i].position;
      expected[i].velocity += other[i].velocity;
    }
    EXPECT_LE(distance(run(sum, with(integrator)), expected), bound(integrator))
        << "seed " << seed << ", " << integrator;
  }
}

Scene heavy_top(Random& random, double moment, double about_axis, double spin) {
  Scene scene;
  Body body;
  body.mass = random.in(0.5, 1.5);
  const double length = random.in(0.2, 0.4);
  body.inertia = Vector3(moment, about_axis, moment).asDiagonal();
  const Quaternion q = random.turn();
  const Vector3 arm = q * Vector3(0, length, 0), tip = random.vector(1);
  const Vector3 w = q * Vector3(random.in(-1, 1), spin, random.in(-1, 1));
  body.initial = {tip + arm, q, w.cross(arm), w};
  scene.bodies.push_back(body);
  scene.forces.emplace_back(UniformGravity{});
  scene.joints.push_back({JointType::ball, 0, world, tip});
  return scene;
}

// 13. The path of a symmetric top's axis depends on I3 w3 alone.
TEST(Relation13, AxisOfTopDependsOnlyOnI3TimesSpin) {
  for (int seed = 0; seed < scene_count; ++seed) {
    const std::string integrator = integrator_of(seed);
    Random first(seed), second(seed);
    const Scene slow = heavy_top(first, 0.03, 0.04, 10), fast = heavy_top(second, 0.03, 0.02, 20);
    const State a = run(slow, with(integrator)), b = run(fast, with(integrator));
    const Vector3 x = a[0].orientation * Vector3::UnitY(), y = b[0].orientation * Vector3::UnitY();
    // Splittings turn both exactly between kicks that know only the axis; a Runge-Kutta step errs by its own
    // truncation of each spin, which half the step shows.
    const double truncation = integrator == "rk4" || integrator == "rk8"
                                  ? 2 * (distance(a, run(slow, with(integrator, dt / 2), 2 * steps)) +
                                         distance(b, run(fast, with(integrator, dt / 2), 2 * steps)))
                                  : 0;
    EXPECT_LE((x - y).norm(), bound(integrator) + truncation) << "seed " << seed << ", " << integrator;
    EXPECT_GT(angle(a[0].orientation, b[0].orientation), 1e-3);  // the spin itself differs
  }
}

// 14. Drag by c L slows a free top's clock: q(t) = q_free((1 - e^-ct)/c), w = e^-ct w_free.
TEST(Relation14, DampedTopIsFreeTopInScaledTime) {
  for (int seed = 0; seed < scene_count; ++seed) {
    Random random(seed);
    Scene free;
    Body body;
    body.inertia = random.inertia(0.4);
    body.initial = {random.vector(1), random.turn(), Vector3::Zero(), random.vector(4)};
    free.bodies.push_back(body);
    const double c = random.in(0.2, 2), slow = (1 - std::exp(-c * duration)) / c;
    Scene damped = free;
    damped.forces.emplace_back(Drag{0, 0, 0, c});
    State expected = run(free, with("auto", slow), 1);
    expected[0].angular_velocity *= std::exp(-c * duration);
    EXPECT_LE(distance(run(damped, with("auto")), expected), bound("auto")) << "seed " << seed;
  }
}

// 15. Parts that are held fast are one body: summed mass, centre and I = sum R I R^T + m (d^2 1 - d d^T).
TEST(Relation15, FixedPartsActAsOneBody) {
  for (int seed = 0; seed < scene_count; ++seed) {
    Random random(seed);
    Scene parts, whole;
    const Vector3 w = random.vector(3), v = random.vector(1), g = random.vector(10);
    Body one;
    one.mass = 0;
    Vector3 moment = Vector3::Zero();
    for (int i = 0; i < 2; ++i) {
      Body body;
      body.mass = random.in(0.5, 2);
      body.inertia = random.inertia(0.1);
      body.initial = {random.vector(0.5), random.turn(), Vector3::Zero(), w};
      body.initial.velocity = v + w.cross(body.initial.position);
      one.mass += body.mass;
      moment += body.mass * body.initial.position;
      parts.bodies.push_back(body);
    }
    const Vector3 centre = moment / one.mass;
    one.inertia.setZero();
    for (const Body& b : parts.bodies) {
      const Matrix3 r = b.initial.orientation.toRotationMatrix();
      const Vector3 d = b.initial.position - centre;
      one.inertia += r * b.inertia * r.transpose() +
                     b.mass * (d.squaredNorm() * Matrix3::Identity() - d * d.transpose());
    }
    one.inertia = (one.inertia + one.inertia.transpose()).eval() / 2;
    one.initial = {centre, Quaternion::Identity(), v + w.cross(centre), w};
    whole.bodies.push_back(one);
    parts.joints.push_back({JointType::fixed, 0, 1, random.vector(0.5)});
    for (Scene* s : {&parts, &whole}) s->forces.emplace_back(UniformGravity{g});
    const State a = run(parts, with("auto")), b = run(whole, with("auto"));
    for (std::size_t i = 0; i < 2; ++i) {
      const BodyState& start = parts.bodies[i].initial;
      const Vector3 place = b[0].position + b[0].orientation * (start.position - centre);
      EXPECT_LE((a[i].position - place).norm(), bound("auto")) << "seed " << seed;
      EXPECT_LE(angle(a[i].orientation, b[0].orientation * start.orientation), bound("auto"))
          << "seed " << seed;
      EXPECT_LE((a[i].angular_velocity - b[0].angular_velocity).norm(), bound("auto")) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace cylon::core
