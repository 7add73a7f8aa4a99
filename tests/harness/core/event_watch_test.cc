// The event watch on arcs in closed form, and on motions that are not bounces.
#include "harness/core/event_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using namespace cylon::core;

constexpr double g = 9.81;

Scene ball_over_floor() {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].name = "ball";
  scene.bodies[0].shape = Sphere{0.5};
  scene.bodies[0].collide = true;
  scene.planes = {{.name = "floor"}};
  return scene;
}

std::vector<Event> watch(const Scene& scene, double dt, int steps,
                         const std::function<void(double, BodyState&)>& motion) {
  EventWatch watcher(scene, {{0, world, 0}}, dt);
  State state(1);
  for (int n = 0; n <= steps; ++n) {
    motion(n * dt, state[0]);
    watcher.observe(n, state);
  }
  return watcher.take();
}

// Exact bouncing: dropped from gap h with restitution e.
void bounce(double h, double e, double t, BodyState& s) {
  double u = std::sqrt(2 * g * h), start = u / g, y = 0, v = 0;
  if (t < start) {
    y = h - g * t * t / 2, v = -g * t;
  } else {
    t -= start;
    u *= e;
    while (t > 2 * u / g) t -= 2 * u / g, u *= e;
    y = u * t - g * t * t / 2, v = u - g * t;
  }
  s.position = {0.3 * t, 0.5 + y, 0};
  s.velocity = {0.3, v, 0};
}

TEST(EventWatch, FindsBouncesAndApexesOfExactArcsToRounding) {
  const double h = 2, e = 0.8, u = std::sqrt(2 * g * h);
  const auto events =
      watch(ball_over_floor(), 0.001, 3000, [&](double t, BodyState& s) { bounce(h, e, t, s); });
  ASSERT_GE(events.size(), 6u);
  double time = u / g, speed = u;
  for (std::size_t i = 0; i < 6; ++i) {
    const Event& event = events[i];
    EXPECT_EQ(event.index, static_cast<int>(i / 2) + 1);
    if (i % 2 == 0) {
      speed *= e;
      EXPECT_EQ(event.kind, EventKind::bounce);
      EXPECT_NEAR(event.time, time, 1e-12);
      EXPECT_NEAR(event.speed, speed, 1e-11);
    } else {
      EXPECT_EQ(event.kind, EventKind::apex);
      EXPECT_NEAR(event.height, speed * speed / (2 * g), 1e-11);
      time += 2 * speed / g;
    }
  }
}

TEST(EventWatch, IgnoresSmoothTurningPoints) {  // a ball on a stiff spring, with gravity
  const auto events = watch(ball_over_floor(), 0.001, 2000, [](double t, BodyState& s) {
    s.position = {0, 1 + 0.3 * std::cos(20 * t), 0};
    s.velocity = {0, -6 * std::sin(20 * t), 0};
  });
  for (const Event& event : events) EXPECT_EQ(event.kind, EventKind::apex);
}

TEST(EventWatch, IgnoresRestingContact) {  // dropped once, then jitter of one part in 10^9 for ever
  const auto events = watch(ball_over_floor(), 0.01, 1000, [](double t, BodyState& s) {
    if (t < 0.3) return bounce(0.5, 0, t, s);
    s.position = {0, 0.5, 0};
    s.velocity = {0, 3e-9 * std::sin(1e4 * t), 0};
  });
  EXPECT_EQ(events.size(), 0u);
}

TEST(EventWatch, CountsPerPair) {
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t i = 0; i < 2; ++i) scene.bodies[i].shape = Sphere{0.5}, scene.bodies[i].collide = true;
  EventWatch watcher(scene, {{0, 1, -1}}, 0.01);
  State state(2);
  for (int n = 0; n <= 100; ++n) {  // meet at t = 0.5 head on, part again
    const double t = n * 0.01 - 0.503;
    state[1].position = {1 + std::abs(t) * 2, 0, 0};
    state[1].velocity = {t < 0 ? -2.0 : 2.0, 0, 0};
    watcher.observe(n, state);
  }
  const auto events = watcher.take();
  ASSERT_EQ(events.size(), 1u);
  EXPECT_NEAR(events[0].time, 0.503, 1e-12);
  EXPECT_NEAR(events[0].speed, 2, 1e-12);
  EXPECT_EQ(events[0].pair, (Pair{0, 1, -1}));
}

// A third body hits the farther of two that approach each other, a metre apart: they part without having met.
TEST(EventWatch, IgnoresImpulsesFromThirdBody) {
  Scene scene;
  scene.bodies.resize(2);
  for (std::size_t i = 0; i < 2; ++i) scene.bodies[i].shape = Sphere{0.5}, scene.bodies[i].collide = true;
  for (const bool meets : {false, true}) {
    EventWatch watcher(scene, {{0, 1, -1}}, 0.01);
    State state(2);
    for (int n = 0; n <= 100; ++n) {
      const double t = n * 0.01 - 0.503;
      state[1].position = {(meets ? 1 : 2) + std::abs(t) * 0.3, 0, 0};
      state[1].velocity = {t < 0 ? -0.3 : 0.3, 0, 0};
      watcher.observe(n, state);
    }
    EXPECT_EQ(watcher.take().size(), meets ? 1u : 0u);
  }
}

}  // namespace
