// The ballistic stepper against the reference files of tests/data/truth.  Everything in them is a closed form
// and so is everything in the stepper: what is left is rounding.  Tolerance: 64 ulp of the largest number
// that went into a value (some ten operations per event, ten events), but never the value itself.
#include "tests/engine/ballistic/ballistic_fixture.h"

namespace cylon::engine::ballistic_test {
namespace {

constexpr Real rounding = 64 * ulp;
using nlohmann::json;

Plane plane_of(const json& contact) {
  return {vector(contact["normal"]).normalized(), real(contact["offset"])};
}

TEST(BallisticTruth, BouncingSphereFollowsItsParabolas) {
  const json file = truth("bouncing_sphere");
  Model model = spheres_of({real(file["params"]["e"]), 0}, {0, -real(file["params"]["g"]), 0});
  add_sphere(model, 1, Real(0.5), vector(file["bodies"][0]["position0"]), Vector3::Zero());
  const json& floor = file["contacts"][0];
  model.planes.push_back(plane_of(floor));
  model.plane_surfaces.push_back(0);

  const auto stepper = make_ballistic(model, number(file["horizon"]) / 32);
  std::vector<Motion> motions;
  std::vector<Impact> impacts;
  for (std::size_t k = 1; k < file["t"].size(); ++k) {
    stepper->step();
    impacts.insert(impacts.end(), stepper->impacts().begin(), stepper->impacts().end());
    stepper->read(motions);
    const auto& track = file["trajectory"]["ball"];
    EXPECT_LE((motions[0].position - vector(track["position"][k])).norm(), rounding * Real(2.5)) << k;
    EXPECT_LE((motions[0].momentum - vector(track["velocity"][k])).norm(), rounding * Real(6.3)) << k;
  }
  ASSERT_EQ(impacts.size(), file["events"].size());
  for (std::size_t k = 0; k < impacts.size(); ++k) {
    EXPECT_NEAR(impacts[k].time, number(file["events"][k]["t"]), 5 * rounding);
    EXPECT_NEAR(impacts[k].approach, -number(file["events"][k]["vy_before"]), 7 * rounding);
    EXPECT_NEAR(impacts[k].separation, number(file["events"][k]["vy_after"]), 7 * rounding);
    EXPECT_EQ(impacts[k].plane, 0);
    EXPECT_EQ(impacts[k].other, fixed_world);
  }
}

// The infinitely many bounces are over at the Zeno time; afterwards it lies at y = r without moving.
TEST(BallisticTruth, BouncingSphereComesToRestAtTheZenoTime) {
  const json file = truth("bouncing_sphere");
  Model model = spheres_of({real(file["params"]["e"]), 0}, {0, -real(file["params"]["g"]), 0});
  add_sphere(model, 1, Real(0.5), vector(file["bodies"][0]["position0"]), Vector3::Zero());
  add_plane(model, Vector3::UnitY(), 0);
  const Time dt = 1.0 / 64;
  const Outcome rest = run(model, dt, 64 * 6);
  EXPECT_EQ(rest.motions[0].position.y(), Real(0.5));
  EXPECT_EQ(rest.motions[0].momentum.norm(), 0);
  // The last impact is earlier than the Zeno time by what the rule allows, and never later than by rounding.
  const Time zeno = number(file["characteristic"]["zeno_time"]), early = zeno - rest.impacts.back().time;
  EXPECT_LE(early, 1e-9 * dt + 100 * rounding);
  EXPECT_GE(early, -100 * rounding);
}

TEST(BallisticTruth, SphereBetweenTwoWalls) {
  const json file = truth("sphere_two_walls");
  Model model = spheres_of({1, 0});
  add_sphere(model, 1, Real(0.1), vector(file["bodies"][0]["position0"]),
             vector(file["bodies"][0]["velocity0"]));
  for (const json& c : file["contacts"]) {
    model.planes.push_back(plane_of(c));
    model.plane_surfaces.push_back(0);
  }
  const auto stepper = make_ballistic(model, number(file["horizon"]) / 32);
  std::vector<Motion> motions;
  std::vector<Time> times;
  for (std::size_t k = 1; k < file["t"].size(); ++k) {
    stepper->step();
    for (const Impact& i : stepper->impacts()) times.push_back(i.time);
    stepper->read(motions);
    EXPECT_LE((motions[0].position - vector(file["trajectory"]["ball"]["position"][k])).norm(), rounding)
        << k;
  }
  ASSERT_EQ(times.size(), file["events"].size());
  for (std::size_t k = 0; k < times.size(); ++k)
    EXPECT_NEAR(times[k], number(file["events"][k]["t"]), 5 * rounding);
}

TEST(BallisticTruth, HeadOnAtEveryRestitution) {
  const json file = truth("two_sphere_head_on");
  for (const json& event : file["events"]) {
    Model model = spheres_of({real(event["restitution"]), 0});
    for (const json& b : file["bodies"])
      add_sphere(model, real(b["mass"]), real(b["radius"]), vector(b["position0"]), vector(b["velocity0"]));
    const Outcome after = run(model, 0.25, 4);
    ASSERT_EQ(after.impacts.size(), 1u) << event["restitution"];
    EXPECT_NEAR(after.impacts[0].time, number(event["t"]), rounding);
    EXPECT_NEAR(velocity_of(model, after, 0).x(), number(event["vA_after"]), 5 * rounding);
    EXPECT_NEAR(velocity_of(model, after, 1).x(), number(event["vB_after"]), 5 * rounding);
    EXPECT_NEAR(energy(model, model.motions) - energy(model, after.motions),
                number(event["kinetic_energy_loss"]), 10 * rounding);
  }
}

TEST(BallisticTruth, ObliqueHit) {
  const json file = truth("two_sphere_oblique");
  Model model = spheres_of({1, 0});
  for (const json& b : file["bodies"])
    add_sphere(model, real(b["mass"]), real(b["radius"]), vector(b["position0"]), vector(b["velocity0"]));
  const auto stepper = make_ballistic(model, number(file["horizon"]) / 32);
  std::vector<Motion> motions;
  for (std::size_t k = 1; k < file["t"].size(); ++k) {
    stepper->step();
    stepper->read(motions);
    for (std::size_t i = 0; i < 2; ++i) {
      const json& track = file["trajectory"][i == 0 ? "A" : "B"];
      EXPECT_LE((motions[i].position - vector(track["position"][k])).norm(), 4 * rounding) << k;
      EXPECT_LE((motions[i].momentum - vector(track["linear_momentum"][k])).norm(), 6 * rounding) << k;
    }
    const Eigen::Vector3d l = vector(file["system"]["angular_momentum"][k]).cast<double>();
    EXPECT_LE((angular_momentum(motions) - l).norm(), 20 * rounding) << k;
  }
}

TEST(BallisticTruth, RoughBallSticksOrSlides) {
  const json file = truth("rough_ball_bounce");
  for (const json& event : file["events"]) {
    Model model = spheres_of({real(event["restitution"]), real(event["mu"])});
    const Vector3 before = vector(event["velocity_before"]);
    add_sphere(model, 1, Real(0.5), Vector3(Real(0.3), Real(0.5), Real(-0.2)) - before / 8, before,
               vector(event["angular_velocity_before"]));
    add_plane(model, Vector3::UnitY(), 0);
    const Outcome after = run(model, 0.25, 1);
    ASSERT_EQ(after.impacts.size(), 1u);
    EXPECT_LE((velocity_of(model, after, 0) - vector(event["velocity_after"])).norm(), 10 * rounding)
        << event;
    EXPECT_LE((spin_of(model, after, 0) - vector(event["angular_velocity_after"])).norm(), 20 * rounding)
        << event;
    EXPECT_NEAR(energy(model, after.motions), number(event["kinetic_energy_after"]), 20 * rounding);
  }
}

TEST(BallisticTruth, CradleOfTouchingBalls) {
  const json file = truth("newtons_cradle");
  for (const json& event : file["events"]) {
    Model model = spheres_of({real(event["restitution"]), 0});
    const int n = file["params"]["n"].get<int>(), incoming = event["balls_incoming"].get<int>();
    const Vector3 line = Vector3(Real(0.48), Real(-0.6), Real(0.64)), start(Real(0.7), Real(-0.3), Real(1.9));
    for (int i = 0; i < n; ++i)
      add_sphere(model, 1, Real(0.5), start + static_cast<Real>(i) * line,
                 i < incoming ? Vector3(real(event["v"]) * line) : Vector3(Vector3::Zero()));
    const Outcome after = run(model, 0.125, 1);
    for (int i = 0; i < n; ++i) {
      const Vector3 v = velocity_of(model, after, static_cast<std::size_t>(i));
      EXPECT_LE((v - real(event["final_vx"][static_cast<std::size_t>(i)]) * line).norm(), 10 * rounding)
          << incoming << " in, ball " << i;
    }
    EXPECT_EQ(after.impacts.size(), event["pair_collisions"].get<std::size_t>());
  }
}

TEST(BallisticTruth, CradleWithGaps) {
  const json gapped = truth("newtons_cradle")["gapped"];
  Model model = spheres_of({real(gapped["e"]), 0});
  for (std::size_t i = 0; i < gapped["positions0_x"].size(); ++i)
    add_sphere(model, 1, Real(0.5), {real(gapped["positions0_x"][i]), 0, 0},
               {i == 0 ? real(gapped["v"]) : Real(0), 0, 0});
  const Outcome after = run(model, number(gapped["T"]) / 8, 8);
  ASSERT_EQ(after.impacts.size(), gapped["collisions"].size());
  for (std::size_t k = 0; k < after.impacts.size(); ++k) {
    EXPECT_NEAR(after.impacts[k].time, number(gapped["collisions"][k]["t"]), 5 * rounding);
    EXPECT_EQ(after.impacts[k].body, gapped["collisions"][k]["pair"][0].get<int>());
    EXPECT_EQ(after.impacts[k].other, gapped["collisions"][k]["pair"][1].get<int>());
  }
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    EXPECT_NEAR(after.motions[i].position.x(), number(gapped["final_x_at_T"][i]), 5 * rounding);
    EXPECT_NEAR(velocity_of(model, after, i).x(), number(gapped["final_vx"][i]), 5 * rounding);
  }
}

TEST(BallisticTruth, SlideToRoll) {
  const json file = truth("slide_to_roll");
  Model model = spheres_of({0, real(file["params"]["mu"])}, {0, -real(file["params"]["g"]), 0});
  const json& ball = file["bodies"][0];
  add_sphere(model, 1, Real(0.5), vector(ball["position0"]), vector(ball["velocity0"]),
             vector(ball["angular_velocity0"]));
  add_plane(model, Vector3::UnitY(), 0);
  const json& track = file["trajectory"]["ball"];
  for (std::size_t k = 1; k < file["t"].size(); ++k) {
    const Outcome now = run(model, number(file["t"][k]), 1);
    EXPECT_LE((now.motions[0].position - vector(track["position"][k])).norm(), 10 * rounding) << k;
    EXPECT_LE((velocity_of(model, now, 0) - vector(track["velocity"][k])).norm(), 5 * rounding) << k;
    EXPECT_LE((spin_of(model, now, 0) - vector(track["angular_velocity"][k])).norm(), 10 * rounding) << k;
    // it turns by 14 rad: half of that per ulp of the angle
    EXPECT_LE(angle_between(now.motions[0].orientation, quaternion(track["orientation"][k])), 14 * rounding)
        << k;
    EXPECT_TRUE(now.impacts.empty());
  }
}

TEST(BallisticTruth, SphereOnAnIncline) {
  const json file = truth("rolling_sphere_incline");
  for (const json& c : file["cases"]) {
    const Real angle = real(c["theta"]) * Real(3.14159265358979323846L) / 180;
    const Vector3 d(std::cos(angle), -std::sin(angle), 0), n(std::sin(angle), std::cos(angle), 0);
    Model model = spheres_of({Real(0.5), real(c["mu"])}, {0, -real(file["params"]["g"]), 0});
    add_sphere(model, 1, real(c["r"]), real(c["r"]) * n, Vector3::Zero());
    add_plane(model, n, 0);
    const auto stepper = make_ballistic(model, number(c["T"]) / 16);
    std::vector<Motion> motions;
    for (std::size_t k = 1; k < c["t"].size(); ++k) {
      stepper->step();
      stepper->read(motions);
      const Real scale = 10 * rounding;
      EXPECT_LE((motions[0].position - real(c["r"]) * n - real(c["s"][k]) * d).norm(), scale) << k;
      EXPECT_LE((motions[0].momentum - real(c["v"][k]) * d).norm(), scale) << k;
      EXPECT_LE(
          (angular_velocity(model.bodies[0], motions[0]) + real(c["omega"][k]) * Vector3::UnitZ()).norm(),
          2 * scale)
          << k;
      EXPECT_LE(angle_between(motions[0].orientation, quaternion(c["orientation"][k])), 3 * scale) << k;
    }
    EXPECT_FALSE(stepper->handover());
  }
}

}  // namespace
}  // namespace cylon::engine::ballistic_test
