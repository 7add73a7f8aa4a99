// From a foreign model to a scene, without any library of a format.
#include "harness/imports/steps.h"

#include "harness/core/collision_filter.h"
#include "harness/core/input_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::imports {
namespace {

using foreign::Body;
using foreign::Freedom;
using foreign::Joint;
using foreign::Model;
using foreign::Quaternion;
using foreign::Vector3;

Body body(const std::string& name, double mass, const Vector3& at = {0.3, -0.2, 0.7}) {
  Body b;
  b.name = name, b.place.element = "link '" + name + "'";
  b.mass = mass;
  b.inertia = mass * foreign::Matrix3{{0.2, 0.01, -0.02}, {0.01, 0.3, 0.03}, {-0.02, 0.03, 0.25}};
  b.pose = {at, Quaternion(0.9, 0.1, -0.3, 0.2).normalized()};
  return b;
}

TEST(TurnUp, TakesZToYWithoutRounding) {
  Model model;
  model.gravity = {0.1, 0.2, -9.7};
  model.bodies = {body("a", 1.5)};
  model.joints = {{.body = 0, .point = {1, 2, 3}, .freedoms = {{.kind = "turn", .axis = {0, 0.6, 0.8}}}}};
  const Body before = model.bodies[0];
  turn_up(model, false);
  const Body& after = model.bodies[0];
  EXPECT_EQ(model.gravity, Vector3(0.1, -9.7, -0.2));
  EXPECT_EQ(model.joints[0].point, Vector3(1, 3, -2));
  EXPECT_EQ(model.joints[0].freedoms[0].axis, Vector3(0, 0.8, -0.6));
  EXPECT_EQ(after.pose.position, Vector3(0.3, 0.7, 0.2));
  // A vector of the body turns as its world image does: P (q v) = (P q P^-1)(P v).
  const auto p = [](const Vector3& v) { return Vector3(v.x(), v.z(), -v.y()); };
  const Vector3 v(0.3, -1.1, 0.7);
  EXPECT_LT((after.pose.turn * p(v) - p(before.pose.turn * v)).norm(), 1e-15);
  EXPECT_LT((after.inertia * p(v) - p(before.inertia * v)).norm(), 1e-15);
}

TEST(TurnUp, KeepsAxesAndStandsShapesOfRevolutionAlongY) {
  for (const bool keep : {false, true}) {
    Model model;
    model.bodies = {body("a", 1)};
    model.bodies[0].solids = {{.kind = "capsule", .size = {0.1, 0.5, 0}}};
    const Vector3 axis = model.bodies[0].pose.turn * Vector3::UnitZ();
    turn_up(model, keep);
    const foreign::Pose pose = model.bodies[0].pose * model.bodies[0].solids[0].pose;
    const Vector3 expected = keep ? axis : Vector3(axis.x(), axis.z(), -axis.y());
    EXPECT_LT((pose.turn * Vector3::UnitY() - expected).norm(), 1e-15) << keep;
  }
}

// The mass, the centre and the inertia of the whole about a point of the world, from its parts.
TEST(MergeFixed, AddsMassesAboutTheCommonCentre) {
  Model model;
  model.bodies = {body("a", 1.5), body("frame", 0, {1, 1, 1}), body("b", 0.7, {0.5, 0.1, -0.4})};
  model.joints = {{.body = 1, .to = 0}, {.body = 2, .to = 1}};
  const std::vector<Body> parts = {model.bodies[0], model.bodies[2]};
  merge_fixed(model, "f");
  ASSERT_EQ(model.bodies.size(), 1u);
  EXPECT_TRUE(model.joints.empty());
  const Body& whole = model.bodies[0];
  EXPECT_DOUBLE_EQ(whole.mass, 2.2);
  const auto about_origin = [](const Body& b) {
    const foreign::Matrix3 r = b.pose.turn.toRotationMatrix();
    const Vector3& c = b.pose.position;
    return foreign::Matrix3(r * b.inertia * r.transpose() +
                            b.mass * (c.squaredNorm() * foreign::Matrix3::Identity() - c * c.transpose()));
  };
  EXPECT_LT(
      (whole.pose.position - (1.5 * parts[0].pose.position + 0.7 * parts[1].pose.position) / 2.2).norm(),
      1e-15);
  EXPECT_LT((about_origin(whole) - about_origin(parts[0]) - about_origin(parts[1])).norm(), 1e-14);
}

TEST(MergeFixed, PreservesAFixedJointOfTwoBodiesWithMass) {
  Model model;
  model.bodies = {body("a", 1), body("b", 2)};
  model.joints = {{.body = 1, .to = 0}};
  merge_fixed(model, "f");
  EXPECT_EQ(model.bodies.size(), 2u);
  EXPECT_EQ(model.joints.size(), 1u);
}

struct Bad {
  const char* name;
  Model model;
  const char* says;
};
Model bad(std::vector<Body> bodies, std::vector<Joint> joints) {
  Model model;
  model.bodies = std::move(bodies), model.joints = std::move(joints);
  return model;
}
TEST(BadModels, AreRefusedWithFileLineAndElement) {
  Joint joint{.place = {"joint 'j'", "part.sdf", 7}, .body = 1, .to = 0, .freedoms = {{.kind = "turn"}}};
  Joint self = joint, limits = joint;
  self.to = 1;
  limits.freedoms[0].lower = 0.5, limits.freedoms[0].upper = -0.5;
  Body thin = body("thin", 1);
  thin.inertia = Vector3(1, 1, 3).asDiagonal();
  const Bad rows[] = {
      {"a joint of a body with itself", bad({body("a", 1), body("b", 1)}, {self}),
       "part.sdf:7:0: joint 'j': it joins a body with itself"},
      {"limits the wrong way", bad({body("a", 1), body("b", 1)}, {limits}),
       "part.sdf:7:0: joint 'j': its limits are 0.5 and -0.5: the lower must be < the upper"},
      {"no mass", bad({body("a", 1), body("b", 0)}, {joint}),
       "f: link 'b': it moves, but its mass is 0 kg; it must state its inertia, with a mass > 0"},
      {"no body has this inertia", bad({thin}, {}),
       "f: link 'thin': its inertia: principal moments 1, 1, 3 kg m^2"},
  };
  for (const Bad& row : rows) {
    Model model = row.model;
    try {
      check_limits(model, "f");
      merge_fixed(model, "f");
      ADD_FAILURE() << row.name;
    } catch (const core::InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(row.says)) << row.name << ": " << error.what();
    }
  }
}

struct Mapped {
  std::vector<Freedom> freedoms;
  std::optional<core::JointType> type;  // nothing: it is lost
  double offset = 0;
};
TEST(JointsOf, MapsMotionsToTheJointThatLeavesThem) {
  const Vector3 n(0.6, 0, 0.8), u(0, 1, 0), w = n.cross(u), skew(1, 0, 0);
  using core::JointType;
  const Mapped rows[] = {
      {{}, JointType::fixed},
      {{{.kind = "ball"}}, JointType::ball},
      {{{.kind = "turn", .axis = n}}, JointType::hinge},
      {{{.kind = "slide", .axis = n}}, JointType::slider},
      {{{.kind = "screw", .axis = n, .pitch = 0.1}}, JointType::screw},
      {{{.kind = "slide", .axis = n}, {.kind = "turn", .axis = -n}}, JointType::cylindrical},
      {{{.kind = "slide", .axis = n}, {.kind = "turn", .axis = u}}, std::nullopt},
      {{{.kind = "turn", .axis = n}, {.kind = "turn", .axis = u}}, JointType::universal},
      {{{.kind = "turn", .axis = n}, {.kind = "turn", .axis = skew}}, std::nullopt},
      {{{.kind = "slide", .axis = u}, {.kind = "slide", .axis = w}, {.kind = "turn", .axis = n}},
       JointType::planar},
      {{{.kind = "turn", .axis = n}, {.kind = "turn", .axis = u}, {.kind = "turn", .axis = w}},
       JointType::ball},
      {{{.kind = "turn", .axis = n},
        {.kind = "turn", .axis = u},
        {.kind = "turn", .axis = (n + w).normalized()}},
       JointType::ball},
      {{{.kind = "turn", .axis = n}, {.kind = "turn", .axis = u}, {.kind = "turn", .axis = -n}},
       std::nullopt},
      {{{.kind = "turn", .axis = n}, {.kind = "turn", .axis = u, .damping = 1}, {.kind = "turn", .axis = w}},
       JointType::gimbal},
      {{{.kind = "turn", .axis = n}, {.kind = "turn", .axis = u}, {.kind = "turn", .axis = w, .armature = 1}},
       JointType::gimbal},
      {{{.kind = "turn", .axis = n},
        {.kind = "turn", .axis = skew},
        {.kind = "turn", .axis = w, .damping = 1}},
       std::nullopt},
      {{{.kind = "turn", .axis = n}, {.kind = "turn", .axis = u}}, JointType::offset_universal, -0.2},
      {{{.kind = "turn", .axis = n}, {.kind = "turn", .axis = skew}}, std::nullopt, 0.2},
      {{{.kind = "slide", .axis = n}, {.kind = "slide", .axis = u}}, JointType::rectangular},
      {{{.kind = "slide", .axis = n}, {.kind = "slide", .axis = skew}}, std::nullopt},
  };
  for (const Mapped& row : rows) {
    Model model;
    model.bodies = {body("a", 1)};
    model.joints = {{.body = 0, .offset = row.offset, .freedoms = row.freedoms}};
    const std::vector<core::Joint> joints = joints_of(model);
    ASSERT_EQ(joints.size(), row.type ? 1u : 0u);
    EXPECT_EQ(model.losses.size(), row.type ? 0u : 1u);
    if (row.type) {
      EXPECT_EQ(joints[0].type, *row.type);
    }
  }
}

// The middle turn of three is the third angle, counted as the angle between the other two axes grows.
TEST(JointsOf, CountsTheAnglesOfAGimbal) {
  const Vector3 n(0.6, 0, 0.8), u(0, 1, 0), w = n.cross(u);
  for (const double sign : {1.0, -1.0}) {
    Model model;
    model.bodies = {body("a", 1)};
    model.joints = {{.body = 0,
                     .freedoms = {{.kind = "turn", .axis = n, .stiffness = 1},
                                  {.kind = "turn", .axis = sign * w, .lower = -0.1, .upper = 0.3},
                                  {.kind = "turn", .axis = u, .armature = 3}}}};
    const core::Joint joint = joints_of(model).at(0);
    EXPECT_EQ(joint.axis, n);
    EXPECT_EQ(*joint.axis_2, u);
    ASSERT_EQ(joint.angles.size(), 3u);
    EXPECT_EQ(joint.angles[0].which, core::Ordinal::first);
    EXPECT_EQ(joint.angles[0].stiffness, 1);
    EXPECT_EQ(joint.angles[1].which, core::Ordinal::third);
    EXPECT_EQ(joint.angles[1].lower, sign > 0 ? -0.1 : -0.3);
    EXPECT_EQ(joint.angles[1].upper, sign > 0 ? 0.3 : 0.1);
    EXPECT_EQ(joint.angles[2].which, core::Ordinal::second);
    EXPECT_EQ(joint.angles[2].armature, 3);
  }
}

// A length is positive: an offset against the product of the axes turns the first of them, and its angle.
TEST(JointsOf, CountsTheOffsetOfAxesTowardsTheirProduct) {
  for (const double offset : {0.2, -0.2}) {
    Model model;
    model.bodies = {body("a", 1)};
    model.joints = {{.body = 0,
                     .offset = offset,
                     .freedoms = {{.kind = "turn", .axis = {1, 0, 0}, .force = 2},
                                  {.kind = "turn", .axis = {0, 1, 0}, .force = 3}}}};
    const core::Joint joint = joints_of(model).at(0);
    const double sign = offset > 0 ? 1 : -1;
    EXPECT_EQ(joint.length, 0.2);
    EXPECT_EQ(joint.axis, Vector3(sign, 0, 0));
    EXPECT_EQ(joint.angles.at(0).force, 2 * sign);
    EXPECT_EQ(joint.angles.at(1).force, 3);
  }
}

TEST(JointsOf, CountsAnOppositeAxisTheOtherWay) {
  const Vector3 n(0.6, 0, 0.8);
  Model model;
  model.bodies = {body("a", 1)};
  model.joints = {
      {.body = 0,
       .freedoms = {{.kind = "slide", .axis = n, .stiffness = 2, .rest = 0.3},
                    {.kind = "turn", .axis = -n, .start = 0.1, .lower = -0.2, .upper = 0.5, .force = 3}}}};
  const core::Joint joint = joints_of(model).at(0);
  EXPECT_EQ(joint.axis, n);
  ASSERT_EQ(joint.displacements.size(), 1u);
  EXPECT_EQ(joint.displacements[0].stiffness, 2);
  EXPECT_EQ(joint.displacements[0].target, 0.3);
  ASSERT_EQ(joint.angles.size(), 1u);
  EXPECT_EQ(joint.angles[0].start, -0.1);
  EXPECT_EQ(joint.angles[0].lower, -0.5);
  EXPECT_EQ(joint.angles[0].upper, 0.2);
  EXPECT_EQ(joint.angles[0].force, -3);
}

TEST(JointsOf, TellsNamesThatTheyDoNotKeep) {
  Model model;
  model.bodies = {body("a", 1), body("b", 1)};
  model.joints = {{.place = {"joint 0"}, .name = "a,b", .body = 0},
                  {.place = {"joint 1"}, .name = "a_b", .body = 1},
                  {.place = {"joint 2"}, .body = 1, .to = 0}};
  const std::vector<core::Joint> joints = joints_of(model);
  EXPECT_EQ(joints.at(0).name, "a_b");
  EXPECT_EQ(joints.at(1).name, "");
  ASSERT_EQ(model.losses.size(), 2u);
  EXPECT_EQ(model.losses[0].what + model.losses[0].detail, "name'a_b' here");
  EXPECT_EQ(model.losses[1].what + model.losses[1].detail, "namenone here");
}

TEST(CheckStarts, NamesTheJointThatStartsOutsideOfItsLimits) {
  Model model;
  model.bodies = {body("a", 1)};
  model.joints = {{.place = {"joint 'j'", "part.sdf", 7},
                   .freedoms = {{.kind = "slide", .start = 0.5, .lower = 0.1, .upper = 0.4}}}};
  try {
    check_starts(model, "f");
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "part.sdf:7:0: joint 'j': it starts at 0.5, outside of its limits 0.1 and 0.4");
  }
  model.joints[0].freedoms[0].start = 0.4;
  EXPECT_NO_THROW(check_starts(model, "f"));
}

TEST(JointsOf, FreesTwoBodiesThatSixMotionsLeave) {
  Model model;
  model.bodies = {body("a", 1)};
  model.joints = {{.body = 0,
                   .freedoms = {{.kind = "slide", .axis = {1, 0, 0}},
                                {.kind = "slide", .axis = {0, 1, 0}},
                                {.kind = "slide", .axis = {0, 0, 1}},
                                {.kind = "ball"}}}};
  EXPECT_TRUE(joints_of(model).empty());
  EXPECT_TRUE(model.losses.empty());
}

// Surfaces 0 and 1 touch the floor (2) alone; 1 touches itself too.
TEST(AddContacts, GroupsSurfacesByWhomTheyTouch) {
  Model model;
  for (int i = 0; i < 4; ++i) {
    Body b = body("b" + std::to_string(i), 1, {3.0 * i, 0, 2});
    b.solids = {{.kind = "sphere", .size = {0.1, 0, 0}, .surface = i / 2}};
    model.bodies.push_back(b);
  }
  Body floor = body("floor", 0);
  floor.locked = true;
  floor.solids = {{.kind = "plane", .surface = 2}};
  model.bodies.push_back(floor);
  model.meetings = {{0, 2, 0.3, 0}, {1, 2, 0.7, 0.5}, {1, 1, 0.7, 0}};
  const core::Scene scene = scene_of(model);
  ASSERT_EQ(scene.bodies.size(), 4u);
  ASSERT_EQ(scene.planes.size(), 1u);
  const core::ContactRules rules(scene);
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(rules.body_and_plane(i, 0)) << i;
    for (int k = 0; k < i; ++k) EXPECT_EQ(rules.bodies(i, k), i == 3 && k == 2) << i << k;
    const auto material = core::material_of(scene, {.body = i, .plane = 0});
    ASSERT_TRUE(material);
    EXPECT_EQ(material->friction, i < 2 ? 0.3 : 0.7);
    EXPECT_EQ(material->restitution, i < 2 ? 0 : 0.5);
  }
  EXPECT_EQ(core::material_of(scene, {.body = 2, .other = 3})->restitution, 0);
}

TEST(NameBodies, MakesThemLegalAndUnique) {
  Model model;
  model.bodies = {body("a,b", 1), body("a_b", 1), body("", 1), body("world", 1)};
  name_bodies(model);
  EXPECT_EQ(model.bodies[0].name, "a_b");
  EXPECT_EQ(model.bodies[1].name, "a_b (2)");
  EXPECT_EQ(model.bodies[2].name, "body");
  EXPECT_EQ(model.bodies[3].name, "world (2)");
  EXPECT_EQ(model.losses.size(), 4u);
}

}  // namespace
}  // namespace cylon::imports
