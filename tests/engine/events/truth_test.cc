// The event stepper against reference solutions in closed form: when and how spheres, blocks and boxes hit,
// slide, stick, roll and rest.
#include "tests/engine/contact/contact_fixtures.h"

namespace cylon::engine {
namespace {

constexpr Real g = Real(9.81);

TEST(EventTruth, BouncingSphere) {
  const Real e = 0.8, r = 0.5;
  Model model = with_plane(Vector3::UnitY(), 0, {e, 0});
  add_sphere(model, 1, r, {0, 2.5, 0}, Vector3::Zero(), Vector3::Zero());
  Trial run(model, 0.01);
  // t_n = t_1 + 2 u_1/g e (1 - e^(n-1))/(1 - e)
  const double t1 = std::sqrt(2 * 2.0 / 9.81), u1 = 9.81 * t1;
  run.until(5);
  const std::size_t expected =
      1 + static_cast<std::size_t>(
              std::floor(std::log(1 - (5 - t1) * (1 - 0.8) / (2 * 0.8 * u1 / 9.81)) / std::log(0.8)));
  ASSERT_EQ(run.impacts.size(), expected);
  for (std::size_t n = 0; n < run.impacts.size(); ++n) {
    const double power = std::pow(0.8, static_cast<double>(n));
    EXPECT_NEAR(run.impacts[n].time, t1 + 2 * u1 / 9.81 * 0.8 * (1 - power) / (1 - 0.8), 1e-12) << n;
    EXPECT_NEAR(run.impacts[n].approach, u1 * power, 1e-11);
  }
  EXPECT_NEAR(run.motion(0).position.y(), 0.533111931328920803818, 1e-11);
  // Zeno: 5.747 s.  Afterwards it lies still, bit by bit.
  run.until(6);
  const Motion still = run.motion(0);
  EXPECT_NEAR(still.position.y(), r, 1e-15);
  run.until(7);
  EXPECT_EQ(run.motion(0).position, still.position);
  EXPECT_TRUE(run.motion(0).momentum.isZero(0));
}

TEST(EventTruth, SlideToRoll) {
  Model model = with_plane(Vector3::UnitY(), 0, {0, 0.3});
  add_sphere(model, 1, 0.5, {0, 0.5, 0}, {5, 0, 0}, Vector3::Zero());
  Trial run(model, 0.02);
  run.until(0.4);  // slides
  EXPECT_NEAR(run.velocity(0).x(), 5 - 0.3 * 9.81 * 0.4, 1e-12);
  run.until(2);
  EXPECT_NEAR(run.motion(0).position.x(), 7.48958094960716192695, 1e-11);
  EXPECT_NEAR(run.velocity(0).x(), 25.0 / 7, 1e-12);
  EXPECT_NEAR(run.spin(0).z(), -50.0 / 7, 1e-11);
  EXPECT_NEAR(run.motion(0).position.y(), 0.5, 1e-15);
}

struct Incline {
  const char* name;
  Real theta, mu, v0, T, s, v;
};

Model block_on_incline(const Incline& c, const Quaternion& turn = Quaternion::Identity()) {
  const Real th = c.theta * Real(M_PI) / 180;
  const Vector3 normal(std::sin(th), std::cos(th), 0), along(std::cos(th), -std::sin(th), 0);
  Model model = with_plane(turn * normal, 0, {0, c.mu});
  model.forces.gravity = turn * Vector3(0, -g, 0);
  const Quaternion flat(Eigen::AngleAxis<Real>(-th, Vector3::UnitZ()));
  add_box(model, 1, {0.5, 0.1, 0.5}, turn * Vector3(0.1 * normal), turn * flat, turn * Vector3(c.v0 * along),
          Vector3::Zero());
  return model;
}

const Incline inclines[] = {{"slides", 20, 0.3, 0, 4, 4.71761778441505517513, 2.35880889220752758757},
                            {"sticks", 20, 0.5, 0, 10, 0, 0},
                            {"uphill", 20, 0.3, -3, 4, 2.89710477604845960571, 2.06977379259843086709},
                            {"stops", 20, 0.5, 2, 4, 1.59492851148150062348, 0}};

TEST(EventTruth, BlockOnIncline) {
  for (const Incline& c : inclines) {
    for (const Quaternion& turn :
         {Quaternion(Quaternion::Identity()), exponential(Vector3(0.4, -1.1, 0.7))}) {
      const Real th = c.theta * Real(M_PI) / 180;
      const Vector3 along = turn * Vector3(std::cos(th), -std::sin(th), 0);
      Trial run(block_on_incline(c, turn), 0.02);
      const Motion start = run.motion(0);
      run.until(c.T);
      const Vector3 moved = run.motion(0).position - start.position;
      EXPECT_NEAR(moved.dot(along), c.s, 1e-10) << c.name;
      EXPECT_NEAR(run.velocity(0).dot(along), c.v, 1e-10) << c.name;
      EXPECT_LT((moved - moved.dot(along) * along).norm(), 1e-12) << c.name;
      EXPECT_LT(run.motion(0).orientation.angularDistance(start.orientation), 1e-12) << c.name;
      if (c.s == 0) {
        EXPECT_TRUE(moved.isZero(0)) << c.name;
      }
      EXPECT_TRUE(sentences(run.stepper.diagnostics()).empty()) << sentences(run.stepper.diagnostics())[0];
    }
  }
}

TEST(EventTruth, RollingSphereOnIncline) {
  struct Case {
    Real theta, mu, T, a, alpha;
  };
  for (const Case c : {Case{20, 0.5, 3, 2.39658400430343590797, 4.79316800860687181595},
                       Case{40, 0.1, 2, 5.55425685232523333869, 3.75744799349858726267}}) {
    const Real th = c.theta * Real(M_PI) / 180;
    const Vector3 normal(std::sin(th), std::cos(th), 0), along(std::cos(th), -std::sin(th), 0);
    Model model = with_plane(normal, 0, {0, c.mu});
    add_sphere(model, 1, 0.5, 0.5 * normal, Vector3::Zero(), Vector3::Zero());
    Trial run(model, 0.02);
    run.until(c.T);
    EXPECT_NEAR((run.motion(0).position - 0.5 * normal).dot(along), c.a * c.T * c.T / 2, 1e-10);
    EXPECT_NEAR(run.velocity(0).dot(along), c.a * c.T, 1e-10);
    EXPECT_NEAR(run.spin(0).z(), -c.alpha * c.T, 1e-10);
    EXPECT_LT(run.motion(0).orientation.angularDistance(exponential(Vector3(0, 0, -c.alpha * c.T * c.T / 2))),
              1e-9);
  }
}

TEST(EventTruth, RodHitOffCentre) {
  Model model = without_plane({0.5, 0});
  add_sphere(model, 1, 0.2, {-1.3, 0.6, 0}, {3, 0, 0}, Vector3::Zero());
  add_box(model, 2, {0.1, 1, 0.1}, Vector3::Zero(), Quaternion::Identity(), Vector3::Zero(), Vector3::Zero());
  Trial run(model, 0.05);
  run.until(1);
  ASSERT_EQ(run.impacts.size(), 1u);
  EXPECT_NEAR(run.impacts[0].time, 1.0 / 3, 1e-12);
  EXPECT_NEAR(run.motion(0).position.x(), 0.225547445255474452555, 1e-12);
  EXPECT_NEAR(run.motion(1).position.x(), 0.737226277372262773723, 1e-12);
  EXPECT_NEAR(run.spin(1).z(), -1.97080291970802919708, 1e-12);
  EXPECT_NEAR(run.velocity(0).x(), 0.788321167883211678832, 1e-12);
  EXPECT_LT(run.motion(1).orientation.angularDistance(
                Quaternion(0.791868144499723172759, 0, 0, -0.610692100592897419784)),
            1e-11);
}

TEST(EventTruth, TwoSpheres) {
  for (const auto& [e, va, vb] : {std::array{0.0, 0.25, 0.25}, std::array{0.25, -0.6875, 0.5625},
                                  std::array{0.8, -2.75, 1.25}, std::array{1.0, -3.5, 1.5}}) {
    Model model = without_plane({static_cast<Real>(e), 0});
    add_sphere(model, 1, 0.5, {-2, 0, 0}, {4, 0, 0}, Vector3::Zero());
    add_sphere(model, 3, 0.5, {2, 0, 0}, {-1, 0, 0}, Vector3::Zero());
    Trial run(model, 0.01);
    run.until(1);
    ASSERT_GE(run.impacts.size(), 1u);
    EXPECT_NEAR(run.impacts[0].time, 0.6, 1e-12);
    EXPECT_NEAR(run.velocity(0).x(), va, 1e-13) << e;
    EXPECT_NEAR(run.velocity(1).x(), vb, 1e-13) << e;
  }
  Model model = without_plane({1, 0});
  add_sphere(model, 1, 0.5, {-3, 0.3, 0}, {4, 0, 0}, Vector3::Zero());
  add_sphere(model, 3, 0.5, {0, 0, 0}, {0, 0, 0}, Vector3::Zero());
  Trial run(model, 0.05);
  run.until(2);
  ASSERT_EQ(run.impacts.size(), 1u);
  EXPECT_NEAR(run.impacts[0].time, 0.511515199645763587712, 1e-12);
  EXPECT_LT((run.velocity(0) - Vector3(-1.46, 1.71709056255050216847, 0)).norm(), 1e-12);
  EXPECT_LT((run.velocity(1) - Vector3(1.82, -0.572363520850167389492, 0)).norm(), 1e-12);
}

TEST(EventTruth, SphereBetweenTwoWalls) {
  Model model = with_plane({-1, 0, 0}, -1, {1, 0});
  model.forces.gravity.setZero();
  model.planes.push_back({{1, 0, 0}, -1});
  model.plane_surfaces.push_back(1);
  add_sphere(model, 1, 0.1, {0.3, 0, 0}, {2, 0, 0}, Vector3::Zero());
  Trial run(model, 0.05);
  run.until(5);
  ASSERT_EQ(run.impacts.size(), 6u);
  for (std::size_t n = 0; n < 6; ++n) {
    EXPECT_NEAR(run.impacts[n].time, 0.3 + 0.9 * static_cast<double>(n), 1e-12);
  }
  EXPECT_NEAR(run.motion(0).position.x(), -0.5, 1e-12);
}

TEST(EventTruth, NewtonsCradle) {
  struct Case {
    int in;
    Real v;
  };
  for (const Case c : {Case{1, 1}, Case{2, 1}, Case{3, 1.5}}) {
    Model model = without_plane({1, 0});
    for (int i = 0; i < 5; ++i) {
      add_sphere(model, 1, 0.5, {static_cast<Real>(i) - (i < c.in ? Real(0.1) : Real(0)), 0, 0},
                 {i < c.in ? c.v : 0, 0, 0}, Vector3::Zero());
    }
    Trial run(model, 0.05);
    run.until(0.5);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(run.velocity(i).x(), static_cast<int>(i) >= 5 - c.in ? c.v : 0, 1e-13) << c.in << " " << i;
    }
  }
  Model model = without_plane({0.9, 0});
  for (int i = 0; i < 5; ++i) {
    add_sphere(model, 1, 0.5, {static_cast<Real>(1.02 * i), 0, 0}, {i == 0 ? Real(1) : Real(0), 0, 0},
               Vector3::Zero());
  }
  Trial run(model, 0.05);
  run.until(3);
  const double times[] = {0.02, 0.0410526315789473684211, 0.063213296398891966759, 0.08654033199883364922};
  const double ends[] = {0.169, 1.18055, 2.1925225, 3.204896375, 6.453031125};
  ASSERT_EQ(run.impacts.size(), 4u);
  EXPECT_NEAR(run.impacts[0].time, times[0], 1e-12);
  EXPECT_NEAR(run.impacts[2].time, times[2], 1e-12);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(run.motion(i).position.x(), ends[i], 1e-11);
}

TEST(EventTruth, BoxDropsOnItsEdge) {
  Model model = with_plane(Vector3::UnitY(), 0, {0.5, 0});
  const Vector3 half(0.5, 0.3, 0.4);
  add_box(model, 1, half, {0, 2, 0}, exponential(Vector3(0, 0, 0.436332312998582394231)), Vector3::Zero(),
          Vector3::Zero());
  Trial run(model, 0.01);
  Real energy = run.energy();
  EXPECT_NEAR(energy, 19.62, 1e-12);
  bool first = true;
  while (run.time < 12) {
    run.step();
    const Real now = run.energy();
    EXPECT_LE(now, energy + 1e-9) << run.time;
    energy = now;
    if (first && !run.impacts.empty()) {
      first = false;
      EXPECT_NEAR(run.impacts[0].time, 0.556089178933874528159, 1e-12);
      EXPECT_NEAR(run.impacts[0].approach, 5.45523484534130912124, 1e-11);
      EXPECT_NEAR(energy, 13.867057890472818034, 1e-11);
      EXPECT_NEAR(run.spin(0).z(), -12.1475026837271930934, 1e-10);
      EXPECT_NEAR(run.velocity(0).y() + 9.81 * (run.time - run.impacts[0].time), -1.23694377437844452515,
                  1e-11);
    }
  }
  const Real height = run.motion(0).position.y();
  const Real miss =
      std::min({std::abs(height - half.x()), std::abs(height - half.y()), std::abs(height - half.z())});
  EXPECT_LT(miss, 1e-12) << height;
  EXPECT_LT(run.spin(0).norm(), 1e-12);
  EXPECT_LT(run.velocity(0).y(), 1e-12);
}

}  // namespace
}  // namespace cylon::engine
