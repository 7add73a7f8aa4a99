// Chains of hinges as angles, starts that err, and what parameters change.
#include "reference/measured/coordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cylon::measured {
namespace {

using core::BodyState, core::Scene, core::State, core::Vector3;

// Three arms whose centres lie off the lines between hinges, hinged about an axis of no special direction.
Experiment chain() {
  Experiment e;
  e.coordinates = Coordinates::chain;
  e.bodies = {0, 1, 2};
  e.rate = 100;
  const Vector3 axis = Vector3(0.2, -0.3, 1).normalized();
  const Vector3 points[] = {{0.1, 0.2, 0.3}, {0.15, -0.1, 0.35}, {0.05, -0.3, 0.4}};
  for (int i = 0; i < 3; ++i) {
    core::Body body;
    body.name = "arm" + std::to_string(i);
    body.initial.position = points[i] + Vector3(0.03, -0.12, 0.02 * i);
    body.initial.orientation = core::Quaternion(Eigen::AngleAxisd(0.4 + i, Vector3(1, 2, -1).normalized()));
    e.model.scene.bodies.push_back(body);
    core::Joint joint;
    joint.type = core::JointType::hinge;
    joint.body = i, joint.to = i - 1;
    joint.point = points[i], joint.axis = axis;
    e.model.scene.joints.push_back(joint);
  }
  e.start = Eigen::MatrixXd::Zero(6, 6);
  e.angle_noise = 0.001;
  return e;
}

const Eigen::VectorXd angles = Eigen::Vector3d(0.7, -1.9, 2.4), rates = Eigen::Vector3d(1.3, -0.4, 2.2);

// Where a hinge is, as the body carries it.
Vector3 carried(const Scene& scene, int body, const Vector3& point, const BodyState& s) {
  const BodyState& model = scene.bodies[static_cast<std::size_t>(body)].initial;
  return s.position + s.orientation * (model.orientation.conjugate() * (point - model.position));
}

TEST(Chain, BodiesMeetInTheirHingesAndVelocitiesAreDerivatives) {
  const Experiment e = chain();
  const Scene& scene = e.model.scene;
  const State s = chain_state(scene, e.bodies, angles, rates);
  EXPECT_LT((carried(scene, 0, scene.joints[0].point, s[0]) - scene.joints[0].point).norm(), 1e-15);
  for (int i = 1; i < 3; ++i) {
    const Vector3& point = scene.joints[static_cast<std::size_t>(i)].point;
    EXPECT_LT((carried(scene, i, point, s[static_cast<std::size_t>(i)]) -
               carried(scene, i - 1, point, s[static_cast<std::size_t>(i - 1)]))
                  .norm(),
              1e-15);
  }
  constexpr double h = 1e-5;
  const State later = chain_state(scene, e.bodies, angles + h * rates, rates),
              before = chain_state(scene, e.bodies, angles - h * rates, rates);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(((later[i].position - before[i].position) / (2 * h) - s[i].velocity).norm(), 1e-9);
    const Eigen::AngleAxisd turn(later[i].orientation * before[i].orientation.conjugate());
    EXPECT_LT((turn.angle() / (2 * h) * turn.axis() - s[i].angular_velocity).norm(), 1e-8);
  }
  EXPECT_LT((chain_angles(scene, e.bodies, s) - angles).norm(), 1e-12);
  EXPECT_LT((chain_rates(scene, e.bodies, s) - rates).norm(), 1e-12);
}

TEST(Chain, StartsWithItsHingesWhereTheBodiesAre) {
  const Experiment e = chain();
  const State s = chain_state(e.model.scene, e.bodies, angles, rates);
  const Scene scene = started(e, s);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT((scene.bodies[i].initial.position - s[i].position).norm(), 1e-12);
    EXPECT_LT((scene.joints[i].point -
               carried(e.model.scene, static_cast<int>(i), e.model.scene.joints[i].point, s[i]))
                  .norm(),
              1e-12);
  }
}

TEST(Chain, DiffersByAnglesAndMovesByThem) {
  const Experiment e = chain();
  const State s = chain_state(e.model.scene, e.bodies, angles, rates);
  Eigen::VectorXd by(6);
  by << 0.01, -0.02, 0.03, 0.4, 0.5, -0.6;
  const State there = moved(e, s, by);
  EXPECT_LT((difference(e, there, s) - by.head(3)).norm(), 1e-12);
  EXPECT_LT((chain_rates(e.model.scene, e.bodies, there) - rates - by.tail(3)).norm(), 1e-12);
  EXPECT_EQ(coordinates(e), 6);
  EXPECT_EQ(noise(e), Eigen::VectorXd::Constant(3, 0.001));
}

TEST(Chain, SaysWhyBodiesAreNone) {
  Experiment e = chain();
  EXPECT_EQ(no_chain(e.model.scene, e.bodies), "");
  const std::vector<std::size_t> backwards = {1, 0, 2};
  EXPECT_EQ(no_chain(e.model.scene, backwards), "the hinge of 'arm1' does not go to the world");
  e.model.scene.joints[1].axis = Vector3::UnitX();
  EXPECT_EQ(no_chain(e.model.scene, e.bodies), "the axis of 'arm1' is not that of the first hinge");
  e.model.scene.joints[1].type = core::JointType::ball;
  EXPECT_EQ(no_chain(e.model.scene, e.bodies), "'arm1' is the body of no hinge");
}

double distance(const Scene& scene, std::size_t a, std::size_t b) {
  return (scene.joints[a].point - scene.joints[b].point).norm();
}

TEST(Parameters, ChangeWhatTheySay) {
  Experiment e = chain();
  e.model.scene.materials = {core::Material{{"arm0", "arm1"}, 0.3, 0.4}};
  e.model.scene.forces = {core::UniformGravity{{1, -9, 2}}};
  const auto with = [&](const char* kind, const char* body, double value) {
    const std::vector<Parameter> one = {{"p", kind, body, 0.1, 1, 3}};
    return with_values(e, one, std::vector<double>{value}).model.scene;
  };
  const Scene& was = e.model.scene;
  EXPECT_EQ(with("friction", "", 0.7).materials[0].friction, 0.7);
  EXPECT_EQ(with("restitution", "", 0.7).materials[0].restitution, 0.7);
  EXPECT_EQ(with("mass", "arm1", 2).bodies[1].mass, 2 * was.bodies[1].mass);
  EXPECT_EQ(with("mass", "arm1", 2).bodies[1].inertia, was.bodies[1].inertia);
  EXPECT_EQ(with("mass", "arm1", 2).bodies[0].mass, was.bodies[0].mass);
  EXPECT_EQ(with("inertia", "", 1.5).bodies[2].inertia, 1.5 * was.bodies[2].inertia);
  EXPECT_EQ(std::get<core::UniformGravity>(with("gravity", "", 0.5).forces[0]).acceleration,
            Vector3(0.5, -4.5, 1));
  const Scene centred = with("centre", "arm2", 1.5);
  EXPECT_LT((centred.bodies[2].initial.position - was.joints[2].point -
             1.5 * (was.bodies[2].initial.position - was.joints[2].point))
                .norm(),
            1e-15);
  const Scene longer = with("arm", "arm0", 1.25);
  EXPECT_NEAR(distance(longer, 0, 1), 1.25 * distance(was, 0, 1), 1e-15);
  EXPECT_NEAR(distance(longer, 1, 2), distance(was, 1, 2), 1e-15);
  EXPECT_EQ(longer.bodies[0].initial.position, was.bodies[0].initial.position);
  EXPECT_LT((longer.bodies[2].initial.position - longer.joints[2].point - was.bodies[2].initial.position +
             was.joints[2].point)
                .norm(),
            1e-15);
  // Every arm: the last has no next hinge.
  EXPECT_NEAR(distance(with("arm", "", 2), 1, 2), 2 * distance(was, 1, 2), 1e-15);
}

TEST(Parameters, LossesAreOfTheHingeOfTheirBody) {
  Experiment e = chain();
  e.model.scene.joints[1].angles = {{{.lower = -2, .damping = 0.3, .friction = 0.4}}};
  const std::vector<Parameter> three = {{"c", "hinge_damping", "arm1", 0, 1, 3},
                                        {"d", "hinge_quadratic_damping", "", 0, 1, 3},
                                        {"f", "hinge_friction", "arm2", 0, 1, 3}};
  const Scene scene = with_values(e, three, std::vector<double>{0.7, 0.02, 0.05}).model.scene;
  struct Row {
    double damping, quadratic, friction;
  };
  const Row rows[] = {{0, 0.02, 0}, {0.7, 0.02, 0.4}, {0, 0.02, 0.05}};
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(scene.joints[i].angles.size(), 1u);
    const core::JointAngle& q = scene.joints[i].angles[0];
    EXPECT_EQ(q.damping, rows[i].damping);
    EXPECT_EQ(q.quadratic_damping, rows[i].quadratic);
    EXPECT_EQ(q.friction, rows[i].friction);
  }
  EXPECT_EQ(scene.joints[1].angles[0].lower, -2);  // what else acts there stays
  EXPECT_TRUE(with_values(e, {}, {}).model.scene.joints[0].angles.empty());
}

TEST(Parameters, LengthIsOfTheDataAndOfTheirErrors) {
  Experiment e;
  e.bodies = {0};
  e.model.scene.bodies = {core::Body{}};
  e.noise = 0.01, e.angle_noise = 0.02;
  Eigen::VectorXd deviations = Eigen::VectorXd::LinSpaced(12, 1, 12);
  e.start = deviations.asDiagonal();
  BodyState s;
  s.position = {1, 2, 3}, s.velocity = {4, 5, 6}, s.angular_velocity = {7, 8, 9};
  e.runs = {{"a", {{s}}}};
  const std::vector<Parameter> one = {{"l", "length", "", 0.5, 1, 3}};
  const Experiment made = with_values(e, one, std::vector<double>{2});
  EXPECT_EQ(made.runs[0].states[0][0].position, Vector3(0.5, 1, 1.5));
  EXPECT_EQ(made.runs[0].states[0][0].velocity, Vector3(2, 2.5, 3));
  EXPECT_EQ(made.runs[0].states[0][0].angular_velocity, s.angular_velocity);
  EXPECT_EQ(made.start(1, 1), 1);
  EXPECT_EQ(made.start(4, 4), 5);
  EXPECT_EQ(made.start(7, 7), 4);
  // In lengths of the data nothing has changed.
  EXPECT_EQ(noise(made), noise(e));
  const State other = moved(made, {made.runs[0].states[0][0]}, Eigen::VectorXd::Constant(12, 1e-3));
  EXPECT_NEAR(difference(made, made.runs[0].states[0], other)[0], -2e-3, 1e-15);
}

}  // namespace
}  // namespace cylon::measured
