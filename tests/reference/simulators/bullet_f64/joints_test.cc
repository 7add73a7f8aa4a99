// What Bullet's constraints have is what the scene says: points, axes, free and locked coordinates, limits, restitution and
// friction, each read from the constraint; and that what Bullet does not have is refused.
#include "reference/simulators/bullet/bullet_border.h"
#include "reference/simulators/bullet/bullet_joints.h"
#include "reference/simulators/bullet/bullet_tree.h"

#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>

namespace cylon::simulators {
namespace {

using core::Joint;
using core::Vector3;
using Type = core::JointType;

constexpr double rounding = 64 * 0x1p-53;
constexpr double dt = 1e-3;
const Vector3 axis = Vector3(1, -2, 0.5).normalized();
const Vector3 axis_2 = Vector3(0.3, 1, -0.2).cross(axis).normalized();
const Vector3 point(0.2, -0.1, 0.4);

Joint joint_of(Type type, int body = 0, int to = core::world) {
  Joint joint{.type = type, .body = body, .to = to, .point = point, .axis = axis};
  if (core::kind_of(type).has_second_axis()) joint.axis_2 = axis_2;
  return joint;
}

struct Bodies {
  btEmptyShape shape;
  std::vector<std::unique_ptr<btRigidBody>> all;

  // Two, turned and placed in general.
  Bodies() {
    for (const double k : {1., 2.}) {
      all.push_back(std::make_unique<btRigidBody>(
          btRigidBody::btRigidBodyConstructionInfo(k, nullptr, &shape, btVector3(0.1, 0.2, 0.25))));
      all.back()->setCenterOfMassTransform(
          btTransform(btQuaternion(btVector3(k, 1, -2).normalized(), 0.7 * k), btVector3(0.3 * k, -k, 0.5)));
    }
  }
  btRigidBody& operator[](std::size_t i) { return *all[i]; }
};

std::unique_ptr<btTypedConstraint> made(Bodies& bodies, const Joint& joint,
                                        const BulletStops& stops = {true, 1}) {
  btRigidBody* const to = joint.to == core::world ? nullptr : &bodies[static_cast<std::size_t>(joint.to)];
  return make_joint(joint, bodies[static_cast<std::size_t>(joint.body)], to, dt, stops);
}

void expect_axis(const btMatrix3x3& frame, int column, const Vector3& expected) {
  EXPECT_LT((from_bullet(frame.getColumn(column)) - expected).norm(), rounding) << "column " << column;
}

// Of a joint of six freedoms: both frames stand in the same place, and these coordinates are free.
const btGeneric6DofSpring2Constraint& six(const std::unique_ptr<btTypedConstraint>& made,
                                          const std::array<bool, 6>& free) {
  auto& joint = dynamic_cast<btGeneric6DofSpring2Constraint&>(*made);
  joint.calculateTransforms();
  const btTransform &a = joint.getCalculatedTransformA(), &b = joint.getCalculatedTransformB();
  EXPECT_LT((a.getOrigin() - b.getOrigin()).length(), rounding);
  for (int i = 0; i < 3; ++i) expect_axis(b.getBasis(), i, from_bullet(a.getBasis().getColumn(i)));
  for (int i = 0; i < 6; ++i)
    EXPECT_EQ(joint.isLimited(i), !free[static_cast<std::size_t>(i)]) << "coordinate " << i;
  return joint;
}

TEST(BulletJoint, SixFreedomsHaveTheAxesOfTheScene) {
  Bodies bodies;
  {
    const auto made_ = made(bodies, joint_of(Type::slider));
    const auto& joint = six(made_, {true, false, false, false, false, false});
    expect_axis(joint.getCalculatedTransformA().getBasis(), 0, axis);
    EXPECT_EQ(&joint.getRigidBodyB(),
              &bodies[0]);  // displacements are of the second body along the first's axes
  }
  {
    const auto made_ = made(bodies, joint_of(Type::cylindrical));
    const auto& joint = six(made_, {true, false, false, true, false, false});
    expect_axis(joint.getCalculatedTransformA().getBasis(), 0, axis);
    const Vector3 on_axis = from_bullet(joint.getCalculatedTransformA().getOrigin()) - point;
    EXPECT_LT(on_axis.cross(axis).norm(), rounding);
  }
  {
    const auto made_ = made(bodies, joint_of(Type::planar));
    const auto& joint = six(made_, {false, true, true, true, false, false});
    expect_axis(joint.getCalculatedTransformA().getBasis(), 0, axis);
    expect_axis(joint.getCalculatedTransformA().getBasis(), 1, axis_2);
    EXPECT_LT((from_bullet(joint.getCalculatedTransformA().getOrigin()) - point).norm(), rounding);
  }
  for (const int to : {core::world, 1}) {
    const auto made_ = made(bodies, joint_of(Type::universal, 0, to));
    const auto& joint = six(made_, {false, false, false, true, false, true});
    expect_axis(joint.getCalculatedTransformA().getBasis(), 2, axis);
    expect_axis(joint.getCalculatedTransformB().getBasis(), 0, axis_2);
    EXPECT_LT((from_bullet(joint.getCalculatedTransformA().getOrigin()) - point).norm(), rounding);
  }
}

// Displacements count as the scene's, angles the other way; limits count from the start.
TEST(BulletJoint, SixFreedomsHaveTheLimitsOfTheScene) {
  Bodies bodies;
  Joint joint = joint_of(Type::cylindrical);
  joint.displacements = {{{.start = 0.2, .lower = -0.3, .restitution = 0.4, .friction = 3}}};
  joint.angles = {{{.start = 0.1, .lower = -0.5, .upper = 1.2, .restitution = 0.7, .friction = 0.8}}};
  for (const std::optional<double> erp : {std::optional(0.7), std::optional<double>()}) {
    const auto made_ = made(bodies, joint, {true, erp});
    auto& has = dynamic_cast<btGeneric6DofSpring2Constraint&>(*made_);
    const btTranslationalLimitMotor2& slides = *has.getTranslationalLimitMotor();
    EXPECT_NEAR(slides.m_lowerLimit[0], -0.5, rounding);
    EXPECT_GT(slides.m_upperLimit[0], 1e9);
    EXPECT_EQ(slides.m_bounce[0], 0.4);
    EXPECT_TRUE(slides.m_enableMotor[0]);
    EXPECT_EQ(slides.m_targetVelocity[0], 0);
    EXPECT_EQ(slides.m_maxMotorForce[0], 3);
    const btRotationalLimitMotor2& turns = *has.getRotationalLimitMotor(0);
    EXPECT_NEAR(turns.m_loLimit, -1.1, rounding);
    EXPECT_NEAR(turns.m_hiLimit, 0.6, rounding);
    EXPECT_EQ(turns.m_bounce, 0.7);
    EXPECT_EQ(turns.m_maxMotorForce, 0.8);
    EXPECT_TRUE(turns.m_enableMotor);
    if (erp) {
      EXPECT_EQ(has.getParam(BT_CONSTRAINT_STOP_ERP, 0), 0.7);
      EXPECT_EQ(has.getParam(BT_CONSTRAINT_STOP_ERP, 3), 0.7);
    } else {
      EXPECT_EQ(slides.m_stopERP[0], btScalar(0.2F));
    }
  }
}

TEST(BulletJoint, HingesHaveTheLimitsOfTheScene) {
  Bodies bodies;
  for (const int to : {core::world, 1}) {
    Joint joint = joint_of(Type::hinge, 0, to);
    joint.angles = {{{.start = 0.1, .lower = -0.5, .upper = 1.2, .restitution = 0.7, .friction = 0.8}}};
    for (const std::optional<double> erp : {std::optional(0.7), std::optional<double>()}) {
      const auto made_ = made(bodies, joint, {false, erp});
      auto& has = dynamic_cast<btHingeConstraint&>(*made_);
      EXPECT_EQ(&has.getRigidBodyA(), &bodies[0]);
      EXPECT_NEAR(has.getHingeAngle(), 0, rounding);
      EXPECT_NEAR(has.getLowerLimit(), -0.6, rounding);
      EXPECT_NEAR(has.getUpperLimit(), 1.1, rounding);
      EXPECT_EQ(has.getLimitRelaxationFactor(), 0.7);
      EXPECT_EQ(has.getLimitBiasFactor(), 1);
      EXPECT_TRUE(has.getEnableAngularMotor());
      EXPECT_NEAR(has.getMaxMotorImpulse(), 0.8 * dt, rounding);
      EXPECT_TRUE(has.getUseFrameOffset());  // Bullet's own
      if (erp) {
        EXPECT_EQ(has.getParam(BT_CONSTRAINT_STOP_ERP, 5), 0.7);
      }
      const btTransform frame = bodies[0].getWorldTransform() * has.getAFrame();
      expect_axis(frame.getBasis(), 2, axis);
      EXPECT_LT((from_bullet(frame.getOrigin()) - point).norm(), rounding);
    }
  }
}

// Ahead of its stops a hinge is a joint of six freedoms with one free; without stops it stays a hinge.
TEST(BulletJoint, HingesThatStopAheadAreOfSixFreedoms) {
  Bodies bodies;
  for (const int to : {core::world, 1}) {
    Joint joint = joint_of(Type::hinge, 0, to);
    joint.angles = {{{.start = 0.1, .lower = -0.5, .upper = 1.2, .restitution = 0.7, .friction = 0.8}}};
    const auto made_ = made(bodies, joint);
    auto& has = dynamic_cast<btGeneric6DofSpring2Constraint&>(*made_);
    has.calculateTransforms();
    expect_axis(has.getCalculatedTransformA().getBasis(), 0, axis);
    EXPECT_LT((from_bullet(has.getCalculatedTransformA().getOrigin()) - point).norm(), rounding);
    const btRotationalLimitMotor2& turns = *has.getRotationalLimitMotor(0);
    EXPECT_NEAR(turns.m_loLimit, -1.1, rounding);
    EXPECT_NEAR(turns.m_hiLimit, 0.6, rounding);
    EXPECT_EQ(turns.m_bounce, 0.7);
    EXPECT_EQ(turns.m_maxMotorForce, 0.8);
    EXPECT_EQ(has.getParam(BT_CONSTRAINT_STOP_ERP, 3), 1);
    for (const int locked : {0, 1, 2, 4, 5}) {
      const bool slides = locked < 3;
      EXPECT_EQ(slides ? has.getTranslationalLimitMotor()->m_lowerLimit[locked]
                       : has.getRotationalLimitMotor(locked - 3)->m_loLimit,
                0);
      EXPECT_EQ(slides ? has.getTranslationalLimitMotor()->m_upperLimit[locked]
                       : has.getRotationalLimitMotor(locked - 3)->m_hiLimit,
                0);
    }
    joint.angles = {{{.friction = 0.8}}};
    const auto free = made(bodies, joint);
    EXPECT_TRUE(dynamic_cast<btHingeConstraint*>(free.get()));
  }
}

// A positive turn of the body is a positive angle: its velocity about the axis moves the hinge that way.
TEST(BulletJoint, HingesCountAsTheSceneDoes) {
  Bodies bodies;
  Joint joint = joint_of(Type::hinge, 0, 1);
  joint.angles = {{{.lower = -1, .upper = 1}}};
  const auto made_ = made(bodies, joint, {false, {}});
  const btQuaternion turn(to_bullet(axis), 0.3);
  bodies[0].setCenterOfMassTransform(btTransform(turn * bodies[0].getWorldTransform().getRotation(),
                                                 bodies[0].getWorldTransform().getOrigin()));
  EXPECT_NEAR(dynamic_cast<btHingeConstraint&>(*made_).getHingeAngle(), 0.3, rounding);
}

TEST(BulletJoint, SlidersBetweenTwoMoversHaveTheScenes) {
  for (const Type type : {Type::slider, Type::cylindrical}) {
    Bodies bodies;
    Joint joint = joint_of(type, 0, 1);
    joint.displacements = {{{.start = 0.2, .lower = -0.3, .upper = 0.9, .friction = 3}}};
    const BulletStops own{false, 0.7};
    const auto made_ = made(bodies, joint, own);
    EXPECT_FALSE(make_stop(joint, bodies[0], &bodies[1], own));
    auto& has = dynamic_cast<btSliderConstraint&>(*made_);
    EXPECT_NEAR(has.getLowerLinLimit(), -0.5, rounding);
    EXPECT_NEAR(has.getUpperLinLimit(), 0.7, rounding);
    EXPECT_EQ(has.getDampingLimLin(), 1);  // 1 less the restitution
    EXPECT_TRUE(has.getPoweredLinMotor());
    EXPECT_EQ(has.getTargetLinMotorVelocity(), 0);
    EXPECT_EQ(has.getMaxLinMotorForce(), 3);
    EXPECT_EQ(has.getLowerAngLimit() > has.getUpperAngLimit(), type == Type::cylindrical);
    EXPECT_EQ(has.getParam(BT_CONSTRAINT_STOP_ERP, 0), 0.7);
    bodies[0].translate(to_bullet(Vector3(0.25 * axis)));  // of `body` along the axis of `to`
    has.calculateTransforms(has.getRigidBodyA().getWorldTransform(), has.getRigidBodyB().getWorldTransform());
    has.testLinLimits();
    EXPECT_NEAR(has.getLinearPos(), 0.25, rounding);
    expect_axis(has.getCalculatedTransformA().getBasis(), 0, axis);
  }
}

// The slider leaves its stops to a constraint that has a row along the axis and no other.
TEST(BulletJoint, SlidersBetweenTwoMoversStopAheadByOneRow) {
  for (const Type type : {Type::slider, Type::cylindrical}) {
    Bodies bodies;
    Joint joint = joint_of(type, 0, 1);
    joint.displacements = {{{.start = 0.2, .lower = -0.3, .upper = 0.9, .restitution = 0.4, .friction = 3}}};
    const auto guide = made(bodies, joint);
    auto& slides = dynamic_cast<btSliderConstraint&>(*guide);
    EXPECT_GT(slides.getLowerLinLimit(), slides.getUpperLinLimit());  // no limits
    EXPECT_EQ(slides.getMaxLinMotorForce(), 3);
    const auto stop = make_stop(joint, bodies[0], &bodies[1], {true, 1});
    const auto& has = six(stop, {false, true, true, true, true, true});
    const btTranslationalLimitMotor2& row =
        *dynamic_cast<btGeneric6DofSpring2Constraint&>(*stop).getTranslationalLimitMotor();
    EXPECT_NEAR(row.m_lowerLimit[0], -0.5, rounding);
    EXPECT_NEAR(row.m_upperLimit[0], 0.7, rounding);
    EXPECT_EQ(row.m_bounce[0], 0.4);
    EXPECT_FALSE(row.m_enableMotor[0]);
    EXPECT_EQ(row.m_stopERP[0], 1);
    EXPECT_EQ(&has.getRigidBodyB(), &bodies[0]);  // displacements are of the second along the first's axes
    expect_axis(has.getCalculatedTransformA().getBasis(), 0, axis);
    EXPECT_FALSE(make_stop(joint_of(type, 0, 1), bodies[0], &bodies[1], {true, 1}));
    joint.to = core::world;
    EXPECT_FALSE(make_stop(joint, bodies[0], nullptr, {true, 1}));
  }
}

// ---- What is refused ------------------------------------------------------------------------------------

// Bodies 0 and 1 move, 2 is locked.
core::Scene scene_of(const Joint& joint) {
  core::Scene scene;
  for (const char* name : {"a", "b", "wall"}) scene.bodies.emplace_back().name = name;
  scene.bodies[2].locked = true;
  scene.joints = {joint};
  return scene;
}
std::optional<std::string> refused(const Joint& joint, bool ahead = true) {
  return unsupported(scene_of(joint), joint, ahead);
}

TEST(BulletJoint, TellsWhatBulletLacks) {
  EXPECT_TRUE(missing(joint_of(Type::screw)));
  EXPECT_TRUE(missing(joint_of(Type::distance)));
  for (const Type type : {Type::ball, Type::hinge, Type::fixed, Type::slider, Type::cylindrical, Type::planar,
                          Type::universal}) {
    EXPECT_FALSE(missing(joint_of(type)));
    EXPECT_FALSE(refused(joint_of(type)));
    EXPECT_FALSE(refused(joint_of(type, 0, 2)));
    EXPECT_FALSE(refused(joint_of(type, 2, 0)));
    EXPECT_EQ(refused(joint_of(type, 0, 1)).has_value(), type == Type::planar);
  }
}

TEST(BulletJoint, TellsWhichStopsBulletLacks) {
  const auto with_angle = [](Type type, int to, const core::JointCoordinate& c, bool ahead = true) {
    Joint joint = joint_of(type, 0, to);
    joint.angles = {{c}};
    return refused(joint, ahead);
  };
  const auto with_displacement = [](Type type, int body, int to, const core::JointCoordinate& c,
                                    bool ahead = true) {
    Joint joint = joint_of(type, body, to);
    joint.displacements = {{c}};
    return refused(joint, ahead);
  };
  EXPECT_TRUE(with_angle(Type::hinge, core::world, {.lower = -1}));
  EXPECT_TRUE(with_angle(Type::universal, core::world, {.upper = 1}));
  EXPECT_TRUE(with_angle(Type::hinge, core::world, {.lower = -1, .upper = 3.2}));
  EXPECT_FALSE(with_angle(Type::hinge, core::world, {.start = 0.1, .lower = -1, .upper = 3.2}));
  EXPECT_FALSE(with_angle(Type::hinge, 1, {.lower = -1, .upper = 1, .restitution = 0.5, .friction = 1}));
  EXPECT_FALSE(with_angle(Type::cylindrical, 1, {.friction = 1}, false));
  EXPECT_FALSE(with_angle(Type::cylindrical, 1, {.lower = -1, .upper = 1}));
  EXPECT_TRUE(with_angle(Type::cylindrical, 1, {.lower = -1, .upper = 1}, false));
  EXPECT_FALSE(with_angle(Type::cylindrical, core::world, {.friction = 1}));

  EXPECT_FALSE(with_displacement(Type::slider, 0, core::world, {.lower = -1, .restitution = 0.5}));
  EXPECT_FALSE(with_displacement(Type::slider, 0, 1, {.lower = -1}));
  EXPECT_FALSE(with_displacement(Type::slider, 0, 1, {.lower = -1, .restitution = 0.5}));
  EXPECT_TRUE(with_displacement(Type::slider, 0, 1, {.lower = -1, .restitution = 0.5}, false));
  EXPECT_FALSE(with_displacement(Type::planar, 0, 2, {.friction = 1}));
  EXPECT_TRUE(with_displacement(Type::planar, 2, 0, {.friction = 1}));
}

// ---- Trees ----------------------------------------------------------------------------------------------

TEST(BulletTree, TellsWhatMultibodyLacks) {
  const auto untree = [](const Joint& joint) { return untreelike(scene_of(joint)).has_value(); };
  for (const int to : {core::world, 1, 2}) {
    EXPECT_FALSE(untree(joint_of(Type::slider, 0, to)));
    EXPECT_FALSE(untree(joint_of(Type::planar, 0, to)));
    EXPECT_TRUE(untree(joint_of(Type::universal, 0, to)));
    EXPECT_TRUE(untree(joint_of(Type::cylindrical, 0, to)));
  }
  Joint stopped = joint_of(Type::slider);
  stopped.displacements = {{{.lower = -1, .friction = 2}}};
  EXPECT_FALSE(untree(stopped));
  stopped.displacements[0].restitution = 0.1;
  EXPECT_TRUE(untree(stopped));
  Joint rubbing = joint_of(Type::planar);
  rubbing.angles = {{{.friction = 2}}};
  EXPECT_TRUE(untree(rubbing));
  core::Scene loop = scene_of(joint_of(Type::ball));
  loop.joints.push_back(joint_of(Type::slider));
  EXPECT_TRUE(untreelike(loop));  // the second of two joints to the world closes a loop
}

}  // namespace
}  // namespace cylon::simulators
