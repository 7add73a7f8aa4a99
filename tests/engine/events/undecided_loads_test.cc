// What slides on more points than three while it turns: rigid bodies leave open how they share the load, and the motion
// depends on it.
#include "engine/diagnostic.h"
#include "engine/geometry/hull.h"
#include "tests/engine/diagnostic_scenes.h"

#include <algorithm>
#include <optional>

namespace cylon::engine {
namespace {

using K = DiagnosticKind;

const std::vector<Vector3> feet = {
    {0.5, -0.2, 0.3}, {-0.5, -0.2, 0.3}, {-0.5, -0.2, -0.3}, {0.5, -0.2, -0.3}};

// A table of 2 kg that slides, without the foot of that number.
Model table(const Vector3& velocity, const Vector3& spin, int without = -1, Real friction = Real(0.3)) {
  Model model = floor({0, friction});
  std::vector<Vector3> points = {{0, Real(0.2), 0}};
  for (int i = 0; i < 4; ++i)
    if (i != without) points.push_back(feet[static_cast<std::size_t>(i)]);
  const Body body = make_body(2, Vector3(Real(0.1), Real(0.12), Real(0.05)).asDiagonal());
  add(model, body, make_hull(points),
      make_motion(body, {0, Real(0.2), 0}, Quaternion::Identity(), velocity, spin));
  return model;
}

const Vector3 along(Real(1.5), 0, Real(0.4)), spin(0, 3, 0);

std::optional<Diagnostic> undecided(const Model& model) {
  World world(model, with("auto", 1e-4));
  world.step();
  for (const Diagnostic& d : world.diagnostics())
    if (d.kind == K::loads_undecided) return d;
  return std::nullopt;
}

// What the feet's places accelerate by.
std::vector<Vector3> accelerations(const Model& model) {
  constexpr Time dt = 1e-5;
  World world(model, with("auto", dt));
  world.step();
  const Motion& after = world.motions()[0];
  const auto slip = [&](const Motion& m, const Vector3& foot) {
    const Body& body = model.bodies[0];
    return Vector3(velocity(body, m) + angular_velocity(body, m).cross(m.orientation * foot));
  };
  std::vector<Vector3> result;
  for (const Vector3& foot : feet)
    result.push_back((slip(after, foot) - slip(model.motions[0], foot)) / static_cast<Real>(dt));
  return result;
}

// The loads of four feet lie between those of a table without a foot of one diagonal and one without a foot of the other, of
// each diagonal the foot without which it stands.  An even sharing is farther from one end than from the other.
TEST(UndecidedLoads, AreToldWithWhatTheyLeaveOpen) {
  const std::optional<Diagnostic> told = undecided(table(along, spin));
  ASSERT_TRUE(told);
  EXPECT_EQ(told->since, 0);
  std::vector<std::vector<Vector3>> ends;
  for (int without = 0; without < 4; ++without) {
    const Model three = table(along, spin, without);
    EXPECT_FALSE(undecided(three)) << without;
    const std::vector<Vector3> all = accelerations(three);
    const bool stands =
        std::all_of(all.begin(), all.end(), [](const Vector3& a) { return std::abs(a.y()) < 0.01; });
    if (stands) ends.push_back(all);
  }
  ASSERT_EQ(ends.size(), 2u);
  Real whole = 0;
  for (std::size_t i = 0; i < feet.size(); ++i) whole = std::max(whole, (ends[0][i] - ends[1][i]).norm());
  EXPECT_LT(*told->reached, 0.501 * static_cast<double>(whole));
  EXPECT_GT(*told->reached, 0.1 * static_cast<double>(whole));
}

// Of its own island alone, and not of a top that it never meets.
TEST(UndecidedLoads, AreOfTheirIsland) {
  Model model = table(along, spin);
  add_body(model, make_body(1, Vector3(1, 2, Real(1.5)).asDiagonal()), {100, 5, 0}, {0, 0, 0}, {0, 0, 0},
           {1, 20, 0});
  const std::optional<Diagnostic> told = undecided(model);
  ASSERT_TRUE(told);
  EXPECT_EQ(told->island.bodies, std::vector<int>{0});
  EXPECT_FALSE(told->island.whole);
}

struct Decided {
  const char* name;
  Vector3 velocity, spin;
  Real friction;
};
class DecidedLoads : public testing::TestWithParam<Decided> {};

// Where all points slide one way, or not at all, or without friction, or about the middle, all loads give one motion.
TEST_P(DecidedLoads, AreNotTold) {
  const Decided& c = GetParam();
  EXPECT_FALSE(undecided(table(c.velocity, c.spin, -1, c.friction)));
}

INSTANTIATE_TEST_SUITE_P(All, DecidedLoads,
                         testing::Values(Decided{"OneWay", along, Vector3::Zero(), Real(0.3)},
                                         Decided{"AtRest", Vector3::Zero(), Vector3::Zero(), Real(0.3)},
                                         Decided{"Smooth", along, spin, 0},
                                         Decided{"AboutTheMiddle", Vector3::Zero(), spin, Real(0.3)}),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace cylon::engine
