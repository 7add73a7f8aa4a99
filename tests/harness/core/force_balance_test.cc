// The balance of a body on an incline, against forces that follow from Newton's law by hand.
#include "harness/core/force_balance.h"
#include "harness/core/measure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace cylon::core;

constexpr double dt = 0.01, mass = 2.5, g = 9.81, slope = 0.3, mu = 0.2;
const Vector3 up_the_slope(-std::cos(slope), std::sin(slope), 0), normal(std::sin(slope), std::cos(slope), 0);

// A box that slides down and, upon a locked one, one that rests.
Scene scene() {
  Scene scene;
  scene.bodies.resize(3);
  for (Body& body : scene.bodies) {
    body.mass = mass;
    body.shape = Box{{0.3, 0.2, 0.1}};
    body.collide = true;
  }
  scene.bodies[0].name = "slides", scene.bodies[1].name = "rests", scene.bodies[2].name = "slab";
  scene.bodies[1].initial.position = {5, 1, 0};
  scene.bodies[2].initial.position = {5, 0.6, 0};
  scene.bodies[2].locked = true;
  scene.forces = {UniformGravity{{0, -g, 0}}};
  scene.planes = {{"incline", normal, 0}};
  scene.materials = {{{"*", "*"}, 0, mu}};
  return scene;
}

// v_n - v_{n-1} = -(g sin a - mu g cos a) dt up the slope; four corners bear the box at rest.
Recording recording() {
  Recording result;
  result.dt = dt;
  State before = initial_state(scene()), now = before;
  const double along = g * (std::sin(slope) - mu * std::cos(slope)) * dt;
  before[0].velocity = -3 * up_the_slope, now[0].velocity = before[0].velocity - along * up_the_slope;
  now[0].position = dt * now[0].velocity;
  result.steps = {0, 6, 7}, result.states = {before, before, now};
  const double bears = mass * g * std::cos(slope) * dt;
  result.contacts = {{{0, world, 0}, now[0].position, normal, bears, mu * bears * up_the_slope}};
  for (const double x : {-0.3, 0.3})
    for (const double z :
         {-0.1, 0.1})  // told with the locked body first: the force on `rests` is the opposite
      result.contacts->push_back(
          {{2, 1, -1}, {5 + x, 0.8, z}, {0, -1, 0}, mass * g * dt / 4, Vector3::Zero()});
  return result;
}

const Observable force{.quantity = Quantity::momentum_balance},
    moment{.quantity = Quantity::angular_momentum_balance};

TEST(ForceBalance, IsZeroWhereForcesAreThoseThatActed) {
  EXPECT_NEAR(force_imbalance(force, scene(), recording()), 0, 1e-12);
  Recording run = recording();
  run.contacts->front().point -= 0.2 * normal + 0 * up_the_slope;
  run.contacts->front().friction->setZero();
  Observable rests = moment;
  rests.body = 1;
  EXPECT_NEAR(force_imbalance(rests, scene(), run), 0, 1e-12);
  EXPECT_FALSE(untold(force, scene(), run));
}

TEST(ForceBalance, IsWhatForcesAreOffBy) {
  const struct {
    const char* name;
    void (*change)(Recording&);
    Observable observable;
    double expected;
  } rows[] = {
      {"a normal force a percent too large", [](Recording& r) { *r.contacts->front().impulse *= 1.01; },
       force, 0.01 * mass * g * std::cos(slope)},
      {"friction on the other body", [](Recording& r) { *r.contacts->front().friction *= -1; }, force,
       2 * mu * mass * g * std::cos(slope)},
      {"a corner that is not told", [](Recording& r) { r.contacts->pop_back(); }, force, mass * g / 4},
      {"nothing told", [](Recording& r) { r.contacts.reset(); }, force, mass * g},
      {"a point a millimetre aside",
       [](Recording& r) { r.contacts->back().point.x() += 1e-3; },
       {.quantity = Quantity::angular_momentum_balance, .body = 1},
       1e-3 * mass * g / 4},
      {"spin that no force gives",
       [](Recording& r) { r.states.back()[1].angular_velocity.y() = 0.7; },
       {.quantity = Quantity::angular_momentum_balance, .body = 1},
       0.7 * 1.0 / dt},
  };
  for (const auto& row : rows) {
    Recording run = recording();
    row.change(run);
    EXPECT_NEAR(force_imbalance(row.observable, scene(), run), row.expected, 1e-9) << row.name;
  }
}

TEST(ForceBalance, OfALockedBodyIsNotAsked) {
  Scene s = scene();
  EXPECT_FALSE(balance_undefined(force, s));
  EXPECT_TRUE(balance_undefined({.quantity = Quantity::momentum_balance, .body = 2}, s));
  s.bodies[1].collide = false;
  EXPECT_TRUE(balance_undefined({.quantity = Quantity::momentum_balance, .body = 1}, s)) << "touches nothing";
}

TEST(ForceBalance, IsNotDrawnWhereOtherForcesAct) {
  const struct {
    const char* name;
    void (*change)(Scene&);
  } rows[] = {
      {"drag", [](Scene& s) { s.forces.emplace_back(Drag{}); }},
      {"spring", [](Scene& s) { s.forces.emplace_back(Spring{}); }},
      {"frame", [](Scene& s) { s.frame.emplace(); }},
  };
  for (const auto& row : rows) {
    Scene s = scene();
    row.change(s);
    EXPECT_TRUE(balance_undefined(force, s)) << row.name;
  }
}

TEST(ForceBalance, NeedsWhatTheEngineTells) {
  const struct {
    const char* name;
    void (*change)(Recording&);
  } rows[] = {
      {"no contacts", [](Recording& r) { r.contacts.reset(); }},
      {"an empty list", [](Recording& r) { r.contacts->clear(); }},
      {"no impulse", [](Recording& r) { r.contacts->front().impulse.reset(); }},
      {"no friction", [](Recording& r) { r.contacts->front().friction.reset(); }},
  };
  for (const auto& row : rows) {
    Recording run = recording();
    row.change(run);
    EXPECT_TRUE(untold(force, scene(), run)) << row.name;
  }
  Claim claim;
  claim.observable = force, claim.tolerance.absolute = 1e-9;
  const Recording told = recording();
  EXPECT_FALSE(measure(claim, scene(), {&told, 1}, 7 * dt).unanswered);
  Recording silent = recording();
  silent.contacts.reset();
  const Measured measured = measure(claim, scene(), {&silent, 1}, 7 * dt);
  EXPECT_TRUE(measured.unanswered) << "neither passed nor failed";
  EXPECT_EQ(measured.detail, "the engine tells no contact forces");
  EXPECT_TRUE(std::isnan(measured.value));
  Scene smooth = scene();
  smooth.materials.front().friction = 0;
  Recording run = recording();
  for (Contact& c : *run.contacts) c.friction.reset();
  EXPECT_FALSE(untold(force, smooth, run)) << "smooth surfaces have no friction to tell";
  run.steps.back() = 9;
  EXPECT_THROW(static_cast<void>(force_imbalance(force, scene(), run)), std::logic_error);
}

// A beam that a fixed joint holds at its end, and a ball that swings from the beam's other end:
//   on the beam  (m + M) g + M l w^2  up and  m g b + (M g + M l w^2) 2 b  about its end, the lowest point passed.
struct Hung {
  static constexpr double beam = 1.5, ball = 0.7, half = 0.4, length = 0.9, rate = 1.3;
  static Scene scene() {
    Scene s;
    s.bodies.resize(2);
    s.bodies[0].mass = beam, s.bodies[0].initial.position = {half, 0, 0};
    s.bodies[1].mass = ball, s.bodies[1].initial.position = {2 * half, -length, 0};
    s.joints = {{JointType::fixed, 0, world}, {JointType::ball, 0, 1}};
    s.forces = {UniformGravity{{0, -g, 0}}};
    return s;
  }
  // v turns by w dt about the lowest point, from before it to after it.
  static Recording recording() {
    Recording r;
    r.dt = dt;
    State before = initial_state(scene()), now = before;
    before[1].velocity = length * rate * Vector3(1, -rate * dt / 2, 0);
    now[1].velocity = length * rate * Vector3(1, rate * dt / 2, 0);
    r.steps = {3, 4}, r.states = {before, now};
    const double pull = ball * (g + length * rate * rate);
    r.contacts.emplace();
    r.reactions = {{0, {half, 0, 0}, dt * Vector3(0, beam * g + pull, 0), dt * Vector3(0, 0, half * pull)},
                   {1, {2 * half, 0, 0}, dt * Vector3(0, -pull, 0), Vector3::Zero()}};
    return r;
  }
};

TEST(ForceBalance, CountsWhatJointsDoToBothBodies) {
  const Scene scene = Hung::scene();
  Observable beam = moment;
  beam.body = 0;
  EXPECT_FALSE(balance_undefined(force, scene));
  EXPECT_FALSE(untold(force, scene, Hung::recording()));
  EXPECT_NEAR(force_imbalance(force, scene, Hung::recording()), 0, 1e-12);
  EXPECT_NEAR(force_imbalance(beam, scene, Hung::recording()), 0, 1e-12);
  const struct {
    const char* name;
    void (*change)(Recording&);
    const Observable& observable;
    double expected;
  } rows[] = {
      {"the force of the other body", [](Recording& r) { r.reactions->front().impulse *= -1; }, force,
       2 * (Hung::beam * g + Hung::ball * (g + Hung::length * Hung::rate * Hung::rate))},
      {"a joint that is not told", [](Recording& r) { r.reactions->pop_back(); }, force,
       Hung::ball * (g + Hung::length * Hung::rate * Hung::rate)},
      {"a moment that is not told", [](Recording& r) { r.reactions->front().moment.setZero(); }, beam,
       Hung::half * Hung::ball * (g + Hung::length * Hung::rate * Hung::rate)},
      {"a point a millimetre aside", [](Recording& r) { r.reactions->front().point.x() += 1e-3; }, beam,
       1e-3 * (Hung::beam * g + Hung::ball * (g + Hung::length * Hung::rate * Hung::rate))},
  };
  for (const auto& row : rows) {
    Recording run = Hung::recording();
    row.change(run);
    EXPECT_NEAR(force_imbalance(row.observable, scene, run), row.expected, 1e-9) << row.name;
  }
}

TEST(ForceBalance, NeedsEveryJointThatHoldsTheBody) {
  const Scene scene = Hung::scene();
  Recording none = Hung::recording(), one = none;
  none.reactions.reset(), one.reactions->erase(one.reactions->begin());
  Observable ball = force;
  ball.body = 1;
  EXPECT_TRUE(untold(force, scene, none));
  EXPECT_TRUE(untold(force, scene, one));
  EXPECT_FALSE(untold(ball, scene, one)) << "the joint at the wall does not hold the ball";
}

}  // namespace
