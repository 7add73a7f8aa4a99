// Scene helpers: who may touch whom, with which material; principal axes.
#include "harness/core/scene.h"

#include "harness/core/near_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace cylon::core;

Body ball(const std::string& name, double radius = 0.5) {
  Body body;
  body.name = name;
  body.shape = Sphere{radius};
  body.collide = true;
  return body;
}

TEST(TouchingPairs, AreBodiesFirstThenPlanesAndLeaveOutWhatCannotTouch) {
  Scene scene;
  scene.bodies = {ball("a"), ball("ghost"), ball("b"), ball("wall"), ball("pillar")};
  scene.bodies[1].collide = false;
  scene.bodies[3].locked = scene.bodies[4].locked = true;
  scene.planes = {{.name = "floor"}};
  const std::vector<Pair> expected = {{0, 2, -1}, {0, 3, -1}, {0, 4, -1},   {0, world, 0},
                                      {2, 3, -1}, {2, 4, -1}, {2, world, 0}};
  EXPECT_EQ(touching_pairs(scene), expected);
}

TEST(TouchingPairs, LeaveOutJointedNeighbours) {
  Scene scene;
  scene.bodies = {ball("a"), ball("b"), ball("c"), ball("post")};
  scene.bodies[3].locked = true;
  for (std::size_t i = 0; i < 4; ++i) scene.bodies[i].initial.position = {0.6 * static_cast<double>(i), 0, 0};
  scene.joints = {{.body = 1, .to = 0}, {.body = 2, .to = 3}, {.body = 0}};
  const std::vector<Pair> expected = {{0, 2, -1}, {0, 3, -1}, {1, 2, -1}, {1, 3, -1}};
  EXPECT_EQ(touching_pairs(scene), expected);
  EXPECT_EQ(touching_pairs(scene, 1), (std::vector<Pair>{{1, 2, -1}, {1, 3, -1}}));
  for (const Pair& pair : near_pairs(scene, initial_state(scene)))
    EXPECT_TRUE(std::find(expected.begin(), expected.end(), pair) != expected.end())
        << pair.body << ' ' << pair.other;
}

TEST(MaterialOf, ExactPairPrecedesWildcards) {
  Scene scene;
  scene.bodies = {ball("a"), ball("b"), ball("c")};
  scene.planes = {{.name = "floor"}};
  const auto row = [](const char* x, const char* y, double e) {
    Material m;
    m.between[0] = x, m.between[1] = y, m.restitution = e;
    return m;
  };
  scene.materials = {row("*", "*", 0.1), row("*", "floor", 0.2), row("floor", "b", 0.3), row("a", "b", 0.4)};
  EXPECT_EQ(material_of(scene, {0, 1, -1})->restitution, 0.4);
  EXPECT_EQ(material_of(scene, {1, world, 0})->restitution, 0.3);
  EXPECT_EQ(material_of(scene, {0, world, 0})->restitution, 0.2);
  EXPECT_EQ(material_of(scene, {1, 2, -1})->restitution, 0.1);
  scene.materials.erase(scene.materials.begin());
  EXPECT_FALSE(material_of(scene, {1, 2, -1}));
}

TEST(PrincipalAxes, RebuildTheTensorAndKeepTheOrderOfTheBodyAxes) {
  const Quaternion tilt(Eigen::AngleAxisd(0.3, Vector3(1, -2, 0.5).normalized()));
  const Vector3 moments(3, 1, 2);
  const Matrix3 r = tilt.toRotationMatrix();
  const Matrix3 inertia = r * moments.asDiagonal() * r.transpose();
  const PrincipalAxes axes = principal_axes(inertia);
  const Matrix3 a = axes.rotation.toRotationMatrix();
  EXPECT_LT((a * axes.moments.asDiagonal() * a.transpose() - inertia).norm(), 1e-14);
  EXPECT_LT((axes.moments - moments).norm(), 1e-14);
  EXPECT_LT(axes.rotation.angularDistance(tilt), 1e-14);
}

TEST(PrincipalAxes, OfADiagonalTensorAreTheBodyAxesExactly) {
  const PrincipalAxes axes = principal_axes(Vector3(3, 1, 2).asDiagonal());
  EXPECT_EQ(axes.moments, Vector3(3, 1, 2));
  EXPECT_EQ(axes.rotation.coeffs(), Quaternion::Identity().coeffs());
}

}  // namespace
