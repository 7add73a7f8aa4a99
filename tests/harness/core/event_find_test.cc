// The event finder on motions in closed form: kind, order and quantities of each event; motions without
// events; and runs that lack one.
#include "harness/core/event_find.h"

#include "harness/core/event_signal.h"
#include "harness/core/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>

namespace {

using namespace cylon::core;
using std::numbers::pi;

Scene one_body(const Vector3& moments) {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].name = "body";
  scene.bodies[0].inertia = moments.asDiagonal();
  return scene;
}

using Motion = std::function<State(double)>;

Recording record(const Motion& motion, double dt, int steps) {
  Recording recording;
  recording.dt = dt;
  for (int n = 0; n <= steps; ++n) recording.steps.push_back(n), recording.states.push_back(motion(n * dt));
  return recording;
}

// ---- Motions -------------------------------------------------------------------------------------

// An ellipse about a point that is not the origin: half axes 1.3 and 0.4, rate 2.1, phase 0.3.
const Vector3 pin(0.2, -0.7, 0.4);
State ellipse(double t) {
  const double s = 2.1 * t + 0.3;
  State state(1);
  state[0].position = pin + Vector3(1.3 * std::cos(s), 0.4 * std::sin(s), 0);
  state[0].velocity = 2.1 * Vector3(-1.3 * std::sin(s), 0.4 * std::cos(s), 0);
  return state;
}

// The axis (body y) at inclination 0.8 + 0.2 cos(9 t + 0.4), azimuth 1.7 t + 0.1 sin(9 t), about +y.
State nodding(double t) {
  const double incline = 0.8 + 0.2 * std::cos(9 * t + 0.4), azimuth = 1.7 * t + 0.1 * std::sin(9 * t);
  const double incline_rate = -1.8 * std::sin(9 * t + 0.4), azimuth_rate = 1.7 + 0.9 * std::cos(9 * t);
  // From z to x is right-handed about y.
  const Vector3 across(std::sin(azimuth), 0, std::cos(azimuth)),
      along(std::cos(azimuth), 0, -std::sin(azimuth));
  const Vector3 axis = std::cos(incline) * Vector3::UnitY() + std::sin(incline) * across;
  const Vector3 rate = incline_rate * (-std::sin(incline) * Vector3::UnitY() + std::cos(incline) * across) +
                       std::sin(incline) * azimuth_rate * along;
  State state(1);
  state[0].orientation = Quaternion::FromTwoVectors(Vector3::UnitY(), axis);
  state[0].angular_velocity = axis.cross(rate) + 31 * axis;  // the spin about it is no concern
  return state;
}

// Turned about a general axis, spinning about body z, the intermediate one, by 5 sin(1.3 t + 0.2).
State flipping(double t) {
  State state(1);
  state[0].orientation = Quaternion(Eigen::AngleAxisd(0.9 * t, Vector3(1, -2, 0.5).normalized()));
  state[0].angular_velocity = state[0].orientation * Vector3(0.4, -0.2, 5 * std::sin(1.3 * t + 0.2));
  return state;
}

// On y = 0 at height 0.5, contact under the centre: slip = v + w_z/2 = 3.5 - 3.5 t until it rolls at t = 1.
State sliding(double t) {
  const double s = std::min(t, 1.0);
  State state(1);
  state[0].position = {3 * s - s * s + (t - s), 0.5, 0};
  state[0].velocity = {3 - 2 * s, 0, 0};
  state[0].angular_velocity = {0, 0, 1 - 3 * s};
  return state;
}

// About the hinge's axis by 0.8 sin(3 t + 0.1).
const Vector3 hinge = Vector3(1, 0.3, -0.6).normalized();
State swinging(double t) {
  State state(1);
  state[0].orientation = Quaternion(Eigen::AngleAxisd(0.8 * std::sin(3 * t + 0.1), hinge));
  state[0].angular_velocity = 2.4 * std::cos(3 * t + 0.1) * hinge;
  return state;
}

// Falls from 2 m, and with half the weight once it is below 0.3 + 0.1 sin(x - 0.7 t), x = 0.5 t.
double surface(double t) { return 0.3 + 0.1 * std::sin(-0.2 * t); }
double root(const std::function<double(double)>& f, double a, double b) {
  for (int i = 0; i < 100; ++i) (f((a + b) / 2) * f(a) > 0 ? a : b) = (a + b) / 2;
  return (a + b) / 2;
}
const double splash = root([](double t) { return 2 - 4.905 * t * t - surface(t); }, 0.1, 1);
State sinking(double t) {
  const double s = std::max(0.0, t - splash);
  State state(1);
  state[0].position = {0.5 * t, 2 - 4.905 * t * t + 4.905 / 2 * s * s, 0};
  state[0].velocity = {0.5, -9.81 * t + 4.905 * s, 0};
  return state;
}

// ---- Scenes, and what is due ---------------------------------------------------------------------

Scene with_gravity(const Vector3& moments) {
  Scene scene = one_body(moments);
  scene.forces = {UniformGravity{}};
  return scene;
}
Scene on_floor() {
  Scene scene = with_gravity({0.1, 0.1, 0.1});
  scene.bodies[0].shape = Sphere{0.5};
  scene.bodies[0].collide = true;
  scene.planes = {{.name = "floor"}};
  scene.materials = {{.between = {"*", "*"}, .restitution = 0, .friction = 0.3}};
  return scene;
}
Scene on_hinge() {
  Scene scene = one_body({1, 2, 3});
  scene.joints = {{.type = JointType::hinge, .axis = hinge}};
  return scene;
}
Scene in_water() {
  Scene scene = with_gravity({1, 1, 1});
  scene.forces.emplace_back(Water{.level = 0.3, .wave = 0.1, .speed = 0.7});
  return scene;
}

struct Row {
  EventKind kind;
  Scene scene;
  Motion motion;
  std::function<double(int)> time;  // of event k
  int count;                        // of events in 7 s, at least
  EventQuantity quantity;           // another of its numbers
  std::function<double(int)> value;
  double period = 0, rate = 0;
  bool exact = false;  // the arc is: no error to speak of at any step
};
void PrintTo(const Row& row, std::ostream* out) { *out << name(row.kind); }

Observable asked(const Row& row) {
  return {.quantity = Quantity::event,
          .about = row.kind == EventKind::apsis ? pin : Vector3::Zero(),
          .event = row.kind};
}

const Row rows[] = {
    {EventKind::apsis, one_body({1, 2, 3}), ellipse, [](int k) { return (k * pi / 2 - 0.3) / 2.1; }, 9,
     EventQuantity::distance, [](int k) { return k % 2 ? 0.4 : 1.3; }, pi / 2.1},
    {EventKind::turn, one_body({1, 2, 3}), ellipse, [](int k) { return ((k - 0.5) * pi - 0.3) / 2.1; }, 4,
     EventQuantity::height, [](int k) { return k % 2 ? -0.3 : -1.1; }, 2 * pi / 2.1},
    {EventKind::flip, one_body({1, 3, 2}), flipping, [](int k) { return (k * pi - 0.2) / 1.3; }, 2,
     EventQuantity::time, [](int k) { return (k * pi - 0.2) / 1.3; }, 2 * pi / 1.3},
    {EventKind::swing, on_hinge(), swinging, [](int k) { return ((k - 0.5) * pi - 0.1) / 3; }, 6,
     EventQuantity::time, [](int k) { return ((k - 0.5) * pi - 0.1) / 3; }, 2 * pi / 3},
    {EventKind::nutation, with_gravity({2, 1, 2}), nodding, [](int k) { return (k * pi - 0.4) / 9; }, 19,
     EventQuantity::angle, [](int k) { return k % 2 ? 0.6 : 1.0; }, 2 * pi / 9, 1.7},
    {EventKind::precession, with_gravity({2, 1, 2}), nodding,
     [](int k) {
       return root([k](double t) { return 1.7 * t + 0.1 * std::sin(9 * t) - 2 * pi * k; }, 0, 20);
     },
     1, EventQuantity::rate,
     [](int k) {
       return 2 * pi * k /
              root([k](double t) { return 1.7 * t + 0.1 * std::sin(9 * t) - 2 * pi * k; }, 0, 20);
     }},
    {EventKind::roll, on_floor(), sliding, [](int) { return 1.0; }, 1, EventQuantity::time,
     [](int) { return 1.0; }, 0, 0, true},
    {EventKind::crossing, in_water(), sinking, [](int) { return splash; }, 1, EventQuantity::time,
     [](int) { return splash; }},
};

class EventFind : public testing::TestWithParam<Row> {};

double worst_time(const Row& row, double dt) {
  const auto events = find_events(asked(row), row.scene, record(row.motion, dt, static_cast<int>(7 / dt)));
  EXPECT_GE(events.size(), static_cast<std::size_t>(row.count));
  double error = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].index, static_cast<int>(i) + 1);
    error = std::max(error, std::abs(events[i].time - row.time(static_cast<int>(i) + 1)));
  }
  return error;
}

TEST_P(EventFind, LocatesOnArcsToFourthOrder) {
  const Row& row = GetParam();
  const double coarse = worst_time(row, 0.0203), fine = worst_time(row, 0.0203 / 4);
  EXPECT_LT(coarse, row.exact ? 1e-13 : 3e-5);
  EXPECT_LT(fine, std::max(1e-13, coarse / 100));  // 4^4 = 256 in the limit
}

TEST_P(EventFind, ReadsEventQuantities) {
  const Row& row = GetParam();
  const auto events = find_events(asked(row), row.scene, record(row.motion, 0.005, 1400));
  for (const Event& event : events) {
    EXPECT_NEAR(quantity(events, event, row.quantity).value(), row.value(event.index), 1e-6);
    if (event.index != 3) continue;
    if (row.period > 0) {
      EXPECT_NEAR(quantity(events, event, EventQuantity::period).value(), row.period, 1e-6);
    }
    if (row.rate != 0) {
      EXPECT_NEAR(quantity(events, event, EventQuantity::rate).value(), row.rate, 1e-6);
    }
  }
}

// The same in a truth, which is known at any time: to rounding, and within the bound that is stated.
TEST_P(EventFind, LocatesEventsOfTruthWithinBound) {
  const Row& row = GetParam();
  Truth truth{.state = row.motion, .error = {1e-13, 1e-13, 1e-13, 1e-13, 0}};
  const Truth found = with_events(asked(row), row.scene, truth, 7, 0.005);
  ASSERT_GE(found.events.size(), static_cast<std::size_t>(row.count));
  EXPECT_LT(found.error.time, 1e-8);
  for (const Event& event : found.events) {
    EXPECT_LE(std::abs(event.time - row.time(event.index)), found.error.time) << event.index;
    EXPECT_LE(std::abs(event.time - row.time(event.index)), row.kind == EventKind::roll ? 2e-9 : 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EventFind, testing::ValuesIn(rows),
                         [](const auto& row) { return std::string(name(row.param.kind)); });

// ---- What is none --------------------------------------------------------------------------------

TEST(EventFindNone, IgnoresNoiseAboutZero) {
  const Row& row = rows[2];
  const Motion shaken = [](double t) {
    State state = flipping(t);
    state[0].angular_velocity += state[0].orientation * Vector3(0, 0, 1e-6 * std::sin(1e5 * t));
    return state;
  };
  const auto smooth = find_events(asked(row), row.scene, record(flipping, 1e-3, 7000)),
             noisy = find_events(asked(row), row.scene, record(shaken, 1e-3, 7000));
  ASSERT_EQ(noisy.size(), smooth.size());
  for (std::size_t i = 0; i < noisy.size(); ++i) EXPECT_NEAR(noisy[i].time, smooth[i].time, 2e-3);
}

TEST(EventFindNone, FindsNoneAtRestAndInFlight) {
  const Motion still = [](double) { return State(1); };
  for (const Row& row : rows)
    EXPECT_TRUE(find_events(asked(row), row.scene, record(still, 0.01, 100)).empty()) << name(row.kind);
  const Motion above = [](double t) {  // slides past, but nothing touches
    State state = sliding(t);
    state[0].position.y() += 0.1;
    return state;
  };
  EXPECT_TRUE(find_events(asked(rows[6]), rows[6].scene, record(above, 0.01, 200)).empty());
}

TEST(EventFindNone, GivesReasonWhySceneHasNoEvent) {
  const Scene plain = one_body({1, 1, 1});
  const auto why = [&](EventKind kind) {
    return event_undefined({.quantity = Quantity::event, .event = kind}, plain).value_or("");
  };
  EXPECT_EQ(why(EventKind::bounce), "no two things in the scene may touch");
  EXPECT_EQ(why(EventKind::roll), "no two things in the scene may touch");
  EXPECT_EQ(why(EventKind::flip), "body 'body' has no intermediate axis (three different principal moments)");
  EXPECT_EQ(why(EventKind::swing), "body 'body' has no joint that lets it turn about one axis");
  EXPECT_EQ(why(EventKind::apsis), "");
  EXPECT_EQ(why(EventKind::turn), "");
  EXPECT_EQ(why(EventKind::nutation),
            "body 'body' has no axis of symmetry (two equal principal moments and a third)");
  EXPECT_EQ(why(EventKind::crossing), "the scene has no water");
}

// ---- Runs that lack one --------------------------------------------------------------------------

// 5 |sin s|, with the sign of sin(s/2) where `every_other`.
Motion lacking(bool every_other) {
  return [=](double t) {
    const double s = 1.3 * t + 0.2, sign = every_other && std::sin(s / 2) < 0 ? -1 : 1;
    State state = flipping(t);
    state[0].angular_velocity = state[0].orientation * Vector3(0.4, -0.2, sign * 5 * std::abs(std::sin(s)));
    return state;
  };
}

Measured judged(const Motion& motion, int index, EventQuantity quantity) {
  const Row& row = rows[2];
  Claim claim;
  claim.observable = asked(row);
  claim.observable.index = index, claim.observable.event_quantity = quantity;
  claim.truth = with_events(claim.observable, row.scene, {.state = flipping}, 20, 0.005);
  claim.tolerance = {.relative = 1e-3, .reason = "test"};
  const Recording run = record(motion, 0.005, 4000);
  return measure(claim, row.scene, {&run, 1}, 20);
}

TEST(EventClaim, DetectsMissingFlips) {
  for (const EventQuantity quantity : {EventQuantity::time, EventQuantity::period}) {
    const Measured good = judged(flipping, 3, quantity);
    EXPECT_FALSE(good.broken) << good.detail;
    EXPECT_LE(good.value, good.allowed / 1000);
    const Measured half = judged(lacking(true), 3, quantity);
    EXPECT_GT(half.value, 10 * half.allowed) << "every other flip is missing";
    const Measured none = judged(lacking(false), 3, quantity);
    EXPECT_TRUE(none.broken);
    EXPECT_EQ(none.detail, "the flip number 3 never came");
  }
}

// Three collisions in a row; two in the other order; one too few; one too many.
TEST(EventClaim, CollisionOrderIsASequence) {
  Scene scene = one_body({1, 1, 1});
  for (const char* another : {"b", "c", "d"})
    scene.bodies.push_back(scene.bodies[0]), scene.bodies.back().name = another;
  const auto sequence = [](std::initializer_list<int> first) {
    std::vector<Event> events;
    for (const int body : first)
      events.push_back({.pair = {body, body + 1, -1}, .time = 0.1 * static_cast<double>(events.size() + 1)});
    return events;
  };
  Claim claim;
  claim.observable = {.quantity = Quantity::event, .event_quantity = EventQuantity::order};
  claim.truth = Truth{.events = sequence({0, 1, 2})};
  claim.tolerance.reason = "test";
  struct Case {
    std::initializer_list<int> run;
    double wrong;
    const char* detail;
  };
  for (const Case& row :
       {Case{{0, 1, 2}, 0, ""}, Case{{0, 2, 1}, 2, "collision 2 is of c and d, but b and c was expected"},
        Case{{0, 1}, 1, "collision 3 is of nothing, but c and d was expected"},
        Case{{0, 1, 2, 0}, 1, "collision 4 is of body and b, but nothing was expected"}}) {
    Recording run;
    run.dt = 0.1;
    run.events = sequence(row.run);
    const Measured measured = measure(claim, scene, {&run, 1}, 1);
    EXPECT_EQ(measured.value, row.wrong) << row.detail;
    EXPECT_EQ(measured.detail, row.detail);
  }
}

}  // namespace
