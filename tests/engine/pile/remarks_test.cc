// What the stepping path cannot keep, it says: steps too long for a force, and the order of impacts at one
// instant.
#include "tests/engine/fixtures.h"

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

// h c/m = 2 and h^2 k/m = 4 are the limits.
TEST(SteppingRemarks, SayWhenStepsAreTooLongForAForce) {
  const auto unstable = [](const std::function<void(Model&)>& change, Time dt) {
    Model model = ball_over_plane(Real(5), 0);
    change(model);
    return says(run(model, stepping(dt), 3).remarks, "are unstable");
  };
  const Time dt = 0.01;
  const Real mass = Real(0.7), h = Real(0.01);
  for (const Real share : {Real(0.9), Real(1.1)}) {
    EXPECT_EQ(unstable(
                  [&](Model& m) {
                    m.forces.drags.push_back({0, share * 2 * mass / h, 0, 0});
                  },
                  dt),
              share > 1);
    EXPECT_EQ(unstable(
                  [&](Model& m) {
                    m.forces.springs.push_back({.body = 0, .stiffness = share * 4 * mass / (h * h)});
                  },
                  dt),
              share > 1);
  }
  EXPECT_FALSE(unstable([](Model&) {}, dt));
}

// A box that lies on two planes of a corner is struck by both at once; on one plane it is one impact.
TEST(SteppingRemarks, SayWhenSequentialImpactsAreSolvedAtOnce) {
  for (const bool corner : {false, true}) {
    Model model;
    add_body(model, make_body(1, Matrix3::Identity() * Real(0.02)), {Real(0.5), Real(0.5), 0}, {0, 0, 0},
             {-1, -1, 0}, {0, 0, 0}, Box{{Real(0.2), Real(0.2), Real(0.2)}});
    model.planes.push_back({Vector3::UnitY(), 0});
    if (corner) model.planes.push_back({Vector3::UnitX(), 0});
    make_touchable(model, Real(0.5));
    EXPECT_EQ(says(run(model, stepping(0.01), 60).remarks, "impacts = sequential was not kept"), corner);
    model.impacts = Impacts::simultaneous;
    EXPECT_FALSE(says(run(model, stepping(0.01), 60).remarks, "impacts ="));
  }
}

}  // namespace
}  // namespace cylon::engine
