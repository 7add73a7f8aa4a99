// Bodies on one joint with what acts along it: Newton's and Euler's equations hold along each free coordinate between
// events, with what remains of force and torque doing no work along it beside the law; stops turn the rate round;
// the motion is that of small steps of another method; and what is outside the domain is refused.
#include "tests/reference/exact/jointed_scenes.h"

#include "harness/core/joint_coordinates.h"
#include "reference/exact/catalogue.h"

#include <gtest/gtest.h>

#include <optional>
#include <tuple>

namespace cylon::exact {
namespace {

constexpr double horizon = 3;
constexpr unsigned seeds = 2;

core::Truth make(const core::Scene& scene, double until = horizon) {
  for (const Solution& solution : catalogue())
    if (solution.name == "jointed_body") return solution.make(scene, until);
  throw std::runtime_error("no jointed_body");
}

// ---- Along a coordinate -------------------------------------------------------------------------------------

// A free coordinate of the scene's one joint, read off states by the definitions of the format.
struct Along {
  const core::Scene& scene;
  core::JointCoordinate law;
  bool angle = false;
  core::Vector3 direction = core::Vector3::Zero();  // of a displacement

  double place(const core::State& s) const {
    const core::HeldJoint held = core::held_joint(scene, scene.joints[0]);
    return law.start +
           (angle ? core::joint_angle(held, law.which, s) : core::joint_displacement(held, law.which, s));
  }
  double rate(const core::State& s) const {
    return angle ? s[0].angular_velocity.dot(scene.joints[0].axis)
                 : (s[0].velocity - s[0].angular_velocity.cross(arm(s))).dot(direction);
  }
  // From the point that the body carries to its centre.
  core::Vector3 arm(const core::State& s) const {
    const core::BodyState& start = scene.bodies[0].initial;
    return s[0].orientation * (start.orientation.conjugate() * (start.position - scene.joints[0].point));
  }
  // dx and the turn that go with a change of the coordinate.
  core::Vector3 moves(const core::State& s) const {
    const core::Joint& joint = scene.joints[0];
    return angle ? core::Vector3(joint.axis.cross(arm(s)) + joint.pitch * joint.axis) : direction;
  }
  core::Vector3 turns() const { return angle ? scene.joints[0].axis : core::Vector3::Zero(); }

  /// The smooth law, and dry friction at a rate that is not 0.
  double force(double q, double v, double t) const {
    return law.force - law.stiffness * (q - core::target(law, t)) -
           law.damping * (v - core::target_rate(law, t)) -
           law.friction * (v > 0   ? 1
                           : v < 0 ? -1
                                   : 0);
  }
};

std::vector<Along> coordinates(const core::Scene& scene) {
  std::vector<Along> all;
  const core::Joint& joint = scene.joints[0];
  for (const core::JointDisplacement& law : joint.displacements) {
    Along along{scene, law};
    along.direction = !joint.axis_2                       ? joint.axis
                      : law.which == core::Ordinal::first ? *joint.axis_2
                                                          : joint.axis.cross(*joint.axis_2);
    all.push_back(along);
  }
  for (const core::JointAngle& law : joint.angles) all.push_back({.scene = scene, .law = law, .angle = true});
  return all;
}

// Whether nothing jumps within 5 h: no stop, no turn under friction, no hold that begins.
bool smooth_near(const Along& along, const core::Truth& truth, double t, double h) {
  if (!along.law.lower && along.law.friction == 0) return true;
  double least = 1e300, most = -1e300;
  for (int k = -6; k <= 6; ++k) {
    const double rate = along.rate(truth.state(t + k * h));
    least = std::min(least, rate), most = std::max(most, rate);
  }
  return least > 0.01 || most < -0.01;  // a stop turns the rate round, or takes it
}

// What Newton and Euler leave along the coordinate, over the forces there:
//   dx.(m v' - m g) + turn.(I w)' - Q,   by central differences of tenth order.
double violation(const Along& along, const core::Truth& truth, double t, double h) {
  constexpr double weights[] = {5.0 / 6, -5.0 / 21, 5.0 / 84, -5.0 / 504, 1.0 / 1260};
  const core::Body& body = along.scene.bodies[0];
  core::Vector3 push = core::Vector3::Zero(), twist = core::Vector3::Zero();
  for (int k = 1; k <= 5; ++k)
    for (int side : {-1, 1}) {
      const core::BodyState s = truth.state(t + side * k * h)[0];
      const double weight = side * weights[k - 1] / h;
      push += weight * body.mass * s.velocity;
      twist += weight * (core::world_inertia(body, s.orientation) * s.angular_velocity);
    }
  push -= body.mass * core::gravity(along.scene);
  const core::State now = truth.state(t);
  const double law = along.force(along.place(now), along.rate(now), t);
  const double left = along.moves(now).dot(push) + along.turns().dot(twist) - law;
  return std::abs(left) / (1 + push.norm() + twist.norm() + std::abs(law));
}

using Case = std::tuple<core::JointType, const char*>;

class JointedBody : public testing::TestWithParam<Case> {
 protected:
  core::Scene scene(unsigned seed) const {
    return JointedScenes(seed).scene(std::get<0>(GetParam()), std::get<1>(GetParam()));
  }
};

TEST_P(JointedBody, EquationsOfMotion) {
  int looked = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = this->scene(seed);
    const core::Truth truth = make(scene);
    EXPECT_LE(truth.error.position, 1e-9);
    EXPECT_LE(truth.error.velocity, 1e-8);
    const core::State start = truth.state(0);
    EXPECT_LE((start[0].position - scene.bodies[0].initial.position).norm(), truth.error.position);
    EXPECT_LE((start[0].velocity - scene.bodies[0].initial.velocity).norm(), truth.error.velocity);
    for (const Along& along : coordinates(scene))
      for (int k = 1; k < 40; ++k) {
        const double t = horizon * k / 40.3, h = 1e-3;
        if (!smooth_near(along, truth, t, h)) continue;
        ++looked;
        EXPECT_LE(violation(along, truth, t, h), 1e-9) << "t " << t;
        // The rates are those of the places.
        const auto place = [&](double s) { return along.place(truth.state(s)); };
        const double change =
            (8 * (place(t + h) - place(t - h)) - (place(t + 2 * h) - place(t - 2 * h))) / (12 * h);
        EXPECT_NEAR(std::remainder(change * h, 2 * std::numbers::pi) / h, along.rate(truth.state(t)), 1e-6);
      }
    // Nothing but what the joint leaves free moves.
    for (int k = 0; k <= 20; ++k) {
      EXPECT_LE(core::open_by(scene, scene.joints[0], truth.state(horizon * k / 20)), 1e-12);
      EXPECT_LE(core::turned_by(scene, scene.joints[0], truth.state(horizon * k / 20)), 1e-12);
    }
  }
  EXPECT_GT(looked, 1);
}

// Negative control: the truth of another law is seen.
TEST_P(JointedBody, SeesAnotherLaw) {
  const core::Scene scene = this->scene(2);
  const core::Truth truth = make(scene);
  core::Scene other = scene;
  for (core::Force& force : other.forces) std::get<core::UniformGravity>(force).acceleration *= 1.01;
  core::for_each_coordinate(other.joints[0], [](core::JointCoordinate& c) {
    c.force += 0.01, c.stiffness *= 1.01, c.damping *= 1.01, c.friction *= 1.01, c.target_amplitude *= 1.01;
  });
  double worst = 0;
  for (const Along& along : coordinates(other))
    for (int k = 1; k < 40; ++k) {
      const double t = horizon * k / 40.3;
      if (smooth_near(along, truth, t, 1e-3)) worst = std::max(worst, violation(along, truth, t, 1e-3));
    }
  EXPECT_GE(worst, 1e-4);
}

// The coordinate of a joint that has one, by the classical Runge-Kutta scheme, with the inertia and the pull of gravity
// taken from the energies:  M = 2 T/q'^2,  G = m g.dx/dq.
class BySteps {
 public:
  explicit BySteps(const Along& along) : along_(along) {
    const core::State start = core::initial_state(along.scene);
    const core::Body& body = along.scene.bodies[0];
    const core::Vector3 w = start[0].angular_velocity;
    q = along.law.start, v = along.rate(start);
    const double twice = body.mass * start[0].velocity.squaredNorm() +
                         w.dot(core::world_inertia(body, start[0].orientation) * w);
    inertia_ = twice / (v * v);
    pull_ = body.mass * core::gravity(along.scene).dot(along.moves(start));
    way_ = v > 0 ? 1 : -1;
  }

  double q, v;
  int strikes = 0, holds = 0;

  void go(double h) {
    while (h > 0) {
      const auto [end_q, end_v] = after(h);
      if (!over(end_q, end_v)) {
        q = end_q, v = end_v, time_ += h;
        return;
      }
      double early = 0, late = h;
      for (int i = 0; i < 60; ++i) {
        const double middle = (early + late) / 2;
        const auto [a, b] = after(middle);
        (over(a, b) ? late : early) = middle;
      }
      std::tie(q, v) = after(late);
      h -= late, time_ += late;
      choose();
    }
  }

 private:
  // Without what friction does.
  double drive() const { return along_.force(q, 0, time_) + pull_; }
  double rate(double x, double u, double t) const {
    if (held_) return 0;
    const double smooth = along_.force(x, u, t) + along_.law.friction * (u > 0 ? 1 : u < 0 ? -1 : 0);
    return (smooth - along_.law.friction * way_ + pull_) / inertia_;
  }
  std::pair<double, double> after(double h) const {
    if (held_) return {q, 0};
    const double t = time_, a1 = rate(q, v, t), v2 = v + h / 2 * a1, a2 = rate(q + h / 2 * v, v2, t + h / 2),
                 v3 = v + h / 2 * a2, a3 = rate(q + h / 2 * v2, v3, t + h / 2), v4 = v + h * a3,
                 a4 = rate(q + h * v3, v4, t + h);
    return {q + h / 6 * (v + 2 * v2 + 2 * v3 + v4), v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
  }
  bool over(double x, double u) const {
    const core::JointCoordinate& law = along_.law;
    if (held_) return false;
    return (law.upper && x > *law.upper && u > 0) || (law.lower && x < *law.lower && u < 0) ||
           (law.friction > 0 && u * way_ < 0);
  }
  void choose() {
    const core::JointCoordinate& law = along_.law;
    const bool above = law.upper && q >= *law.upper, below = law.lower && q <= *law.lower;
    if ((above && v > 0) || (below && v < 0)) {
      v *= -law.restitution;
      ++strikes;
      if (v != 0) {
        way_ = v > 0 ? 1 : -1;
        return;
      }
    }
    v = 0;
    const double push = drive();
    held_ = std::abs(push) <= law.friction || (above && push > 0) || (below && push < 0);
    holds += held_ ? 1 : 0;
    way_ = push > 0 ? 1 : -1;
  }

  const Along& along_;
  double inertia_, pull_, time_ = 0;
  double way_;
  bool held_ = false;
};

TEST_P(JointedBody, MovesAsBySmallSteps) {
  const auto [type, law] = GetParam();
  const core::JointKind& kind = core::kind_of(type);
  if (kind.displacements() + kind.angles() != 1) GTEST_SKIP() << "of several coordinates";
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = this->scene(seed);
    const core::Truth truth = make(scene);
    const auto all = coordinates(scene);
    BySteps steps(all[0]);
    for (int i = 1; i <= 30; ++i) {
      for (int k = 0; k < 200; ++k) steps.go(horizon / 30 / 200);
      const double place = all[0].place(truth.state(i * horizon / 30));
      const double off =
          all[0].angle ? std::remainder(place - steps.q, 2 * std::numbers::pi) : place - steps.q;
      ASSERT_NEAR(off, 0, 1e-8) << "at " << i * horizon / 30;
    }
    if (std::string(law) == "bounces") {
      EXPECT_GE(steps.strikes, 1);
    }
    if (std::string(law) == "slides_stops") {
      EXPECT_EQ(steps.holds, 1);
    }
  }
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
  return std::string(core::kind_of(std::get<0>(info.param)).name) + "_" + std::get<1>(info.param);
}
INSTANTIATE_TEST_SUITE_P(Lines, JointedBody,
                         testing::Combine(testing::Values(core::JointType::slider, core::JointType::screw),
                                          testing::ValuesIn(jointed_laws)),
                         case_name);
INSTANTIATE_TEST_SUITE_P(Turns, JointedBody,
                         testing::Combine(testing::Values(core::JointType::hinge,
                                                          core::JointType::cylindrical,
                                                          core::JointType::planar),
                                          testing::Values("under", "driven", "bounces", "friction_spring")),
                         case_name);

// Free between stops at +-d with restitution e:  the n-th flight lasts 2 d/(e^n v).
TEST(Stops, ComeAfterTheGeometricSum) {
  const double d = 0.35, e = 0.8, v = 1.7;
  core::Scene scene = JointedScenes(7).scene(core::JointType::slider, "nothing");
  std::get<core::UniformGravity>(scene.forces[0]).acceleration.setZero();
  scene.bodies[0].initial.velocity = v * scene.joints[0].axis;
  core::JointDisplacement& law = scene.joints[0].displacements.front();
  law.lower = -d, law.upper = d, law.restitution = e;
  const core::Truth truth = make(scene, 5);
  double t = d / v, speed = v;
  for (int n = 0; t + d / (e * speed) < 5; ++n) {
    speed *= e;
    const double way = n % 2 == 0 ? -1 : 1;
    EXPECT_NEAR(truth.state(t + d / speed)[0].velocity.dot(scene.joints[0].axis), way * speed, 1e-12) << n;
    EXPECT_LE((truth.state(t + d / speed)[0].position - scene.bodies[0].initial.position).norm(), 1e-12) << n;
    t += 2 * d / speed;
  }
}

struct Refusal {
  core::JointType type;
  const char* law;
  void (*change)(core::Scene&);
  const char* reason;
};
void PrintTo(const Refusal& r, std::ostream* out) { *out << r.reason; }

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithTheReason) {
  const Refusal& r = GetParam();
  core::Scene scene = JointedScenes(5).scene(r.type, r.law);
  EXPECT_NO_THROW(make(scene));
  r.change(scene);
  try {
    make(scene);
    ADD_FAILURE() << "accepted a scene with: " << r.reason;
  } catch (const core::OutOfDomain& refusal) {
    EXPECT_NE(std::string(refusal.what()).find(r.reason), std::string::npos) << refusal.what();
    EXPECT_EQ(std::string(refusal.what()).find("jointed_body"), 0u) << refusal.what();
  }
}

using Type = core::JointType;
core::JointCoordinate& first(core::Scene& s) {
  core::Joint& joint = s.joints[0];
  if (joint.displacements.empty()) return joint.angles.front();
  return joint.displacements.front();
}
const Refusal refusals[] = {
    {Type::slider, "under", [](core::Scene& s) { first(s).quadratic_damping = 0.1; },
     "has quadratic damping"},
    {Type::slider, "under",
     [](core::Scene& s) {
       first(s).target_times = {0, 1}, first(s).target_values = {0, 1};
     },
     "has a table of targets"},
    {Type::slider, "driven", [](core::Scene& s) { first(s).friction = 0.1; }, "a moving target and stops"},
    {Type::screw, "driven", [](core::Scene& s) { first(s).upper = 9; }, "a moving target and stops"},
    {Type::slider, "under", [](core::Scene& s) { s.joints.clear(); }, "must have exactly one joint"},
    {Type::slider, "under", [](core::Scene& s) { s.joints.push_back(s.joints[0]); },
     "must have exactly one joint"},
    {Type::slider, "nothing", [](core::Scene& s) { s.joints[0].type = Type::ball; }, "is of kind ball"},
    {Type::planar, "nothing", [](core::Scene& s) { s.joints[0].type = Type::universal; },
     "is of kind universal"},
    {Type::slider, "under", [](core::Scene& s) { s.bodies[0].initial.velocity.x() += 0.1; },
     "breaks its joint"},
    {Type::hinge, "under", [](core::Scene& s) { s.bodies[0].initial.angular_velocity.x() += 0.1; },
     "breaks its joint"},
    {Type::slider, "under",
     [](core::Scene& s) {
       s.forces.emplace_back(core::Drag{0, 1, 0, 0});
     },
     "a force that it does not know: drag"},
    {Type::slider, "under",
     [](core::Scene& s) {
       s.bodies.push_back(s.bodies[0]);
       s.bodies[1].name = "other";
       s.joints[0].to = 1;
     },
     "does not end on the world"},
    {Type::slider, "bounces", [](core::Scene& s) { s.bodies[0].initial.velocity *= 1000; },
     "more than 1000 times"},
};
INSTANTIATE_TEST_SUITE_P(All, Refused, testing::ValuesIn(refusals));

TEST(Refused, PendulumsAndPlatesOffTheirAxis) {
  for (const auto& [type, reason] : {std::pair{Type::hinge, "it is a pendulum"},
                                     {Type::screw, "it is a pendulum"},
                                     {Type::planar, "is off the axis of its planar joint"}}) {
    core::Scene scene = JointedScenes(5).scene(type, "nothing");
    const core::Vector3 aside = 0.3 * scene.joints[0].axis.unitOrthogonal();
    scene.joints[0].point += aside;
    scene.bodies[0].initial.velocity -= scene.bodies[0].initial.angular_velocity.cross(aside);
    std::get<core::UniformGravity>(scene.forces[0]).acceleration = {1, -9, 2};
    try {
      make(scene);
      ADD_FAILURE() << reason;
    } catch (const core::OutOfDomain& refusal) {
      EXPECT_NE(std::string(refusal.what()).find(reason), std::string::npos) << refusal.what();
    }
  }
}

}  // namespace
}  // namespace cylon::exact
