// What the stepping path cannot keep, it says: steps too long for a force, and the order of impacts at one
// instant.
#include "tests/engine/diagnostic_scenes.h"

#include <functional>

namespace cylon::engine {
namespace {

bool says(const std::vector<std::string>& remarks, std::string_view what) {
  return std::any_of(remarks.begin(), remarks.end(),
                     [&](const std::string& remark) { return remark.find(what) != std::string::npos; });
}

Options stepping(Time dt) {
  Options options = with("auto", dt);
  options.path = "stepping";
  return options;
}

// h c/m = 2 and h^2 k/m = 4 are the limits of a step; beyond 1024 parts it is unstable.
TEST(SteppingRemarks, SayWhenStepsAreTooLongForAForce) {
  const auto remarks = [](const std::function<void(Model&)>& change, Time dt) {
    Model model = ball_over_plane(Real(5), 0);
    change(model);
    return run(model, stepping(dt), 3).remarks;
  };
  const auto divided = [&](const std::function<void(Model&)>& change, Time dt) {
    return says(remarks(change, dt), "parts");
  };
  const Time dt = 0.01;
  const Real mass = Real(0.7), h = Real(0.01);
  for (const Real share : {Real(0.9), Real(1.1)}) {
    EXPECT_EQ(divided(
                  [&](Model& m) {
                    m.forces.drags.push_back({0, share * 2 * mass / h, 0, 0});
                  },
                  dt),
              share > 1);
    EXPECT_EQ(divided(
                  [&](Model& m) {
                    m.forces.springs.push_back({.body = 0, .stiffness = share * 4 * mass / (h * h)});
                  },
                  dt),
              share > 1);
  }
  EXPECT_FALSE(divided([](Model&) {}, dt));
  for (const Real drag : {Real(100), Real(1e7)})
    EXPECT_EQ(says(remarks(
                       [&](Model& m) {
                         m.forces.drags.push_back({0, drag * mass / h, 0, 0});
                       },
                       dt),
                   "are unstable"),
              drag > 1000);
}

// A ball with drag 3 and 30 times its mass in a step reached 10^30 m/s, and a spring of 10^7 N/m threw it out of
// the world.  Now the one falls at m g/c, and the other swings no farther than it began.
TEST(StiffForces, DoNotExplodeInSteps) {
  const Real mass = Real(0.7);
  for (const Real strong : {Real(3), Real(30)}) {
    Model model = ball_over_plane(Real(5), 0);
    model.motions[0].momentum = {mass, 0, 0};
    const Real drag = strong * mass / Real(0.01);
    model.forces.drags.push_back({0, drag, 0, 0});
    const Outcome ran = run(model, stepping(0.01), 200);
    const Vector3 v = velocity(model.bodies[0], ran.motions[0]);
    EXPECT_LT((v - mass / drag * model.forces.gravity).norm(), 1e-9) << strong;
  }
  for (const Real stiffness : {Real(1e5), Real(1e7)}) {
    Model model = ball_over_plane(Real(5), 0);
    const Vector3 start = model.motions[0].position;
    model.motions[0].momentum.setZero();
    Spring spring{.body = 0, .stiffness = stiffness, .rest_length = Real(0.5)};
    spring.to_anchor = start - Real(0.6) * model.forces.gravity.normalized();
    model.forces.springs.push_back(spring);
    for (const int steps : {10, 100, 1000}) {
      const Vector3 p = run(model, stepping(0.01), steps).motions[0].position;
      EXPECT_LT((p - start).norm(), 0.25) << stiffness << ", " << steps;
    }
  }
}

// What a step can bear was asked at the start alone: a body that burns away to a hundredth of its mass on a spring, and a
// frame that turns at 150 rad/s in the end, went on in whole steps without a word.
TEST(StiffForces, AreSeenAsMassesBurnAndFramesSpinUp) {
  const Real h = Real(0.01), mass = Real(0.7);
  for (const bool burns : {false, true}) {
    Model model = ball_over_plane(Real(5), 0);
    model.bodies[0].mass_rate = burns ? -Real(0.99) * mass : Real(0);
    Spring spring{.body = 0, .stiffness = 2 * mass / (h * h), .rest_length = Real(0.5)};
    spring.to_anchor = model.motions[0].position - Real(0.51) * model.forces.gravity.normalized();
    model.forces.springs.push_back(spring);
    const Vector3 start = model.motions[0].position;
    const Outcome ran = run(model, stepping(h), 99);
    EXPECT_EQ(says(ran.remarks, "a spring is too stiff"), burns);
    EXPECT_LT((ran.motions[0].position - start).norm(), 1);
  }
  for (const Real faster : {Real(5), Real(50)}) {
    Model model = ball_over_plane(Real(5), 0);
    model.forces.frame_forces.push_back({.angular_acceleration = Vector3(0, faster, 0)});
    EXPECT_EQ(says(run(model, stepping(h), 300).remarks, "the motion of the frame is too stiff"),
              faster > 10);
  }
}

// Sweeps take what one body is struck with, and what it is pressed onto, in one; nothing said so.
TEST(SteppingRemarks, SayWhenSequentialImpactsAreSweptAtOnce) {
  const auto said = [](Model model, Impacts impacts) {
    model.impacts = impacts;
    return says(run(model, stepping(0.01), 6).remarks, "impacts = sequential was not kept");
  };
  EXPECT_TRUE(said(blow_among_many(Real(0.5)), Impacts::sequential));
  EXPECT_FALSE(said(blow_among_many(Real(0.5)), Impacts::simultaneous));
  EXPECT_FALSE(said(blow_among_many(0), Impacts::sequential));
}

}  // namespace
}  // namespace cylon::engine
