// The gap between two convex bodies is the largest separation over all directions: attained along its
// normal, and
// exceeded along no other.
#include "harness/core/convex.h"
#include "harness/core/observable.h"
#include "harness/core/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace cylon::core;

struct Random {
  std::mt19937_64 bits;
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(bits); }
  Vector3 vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Vector3 direction() {
    Vector3 v = vector(1);
    while (v.norm() > 1 || v.norm() < 0.1) v = vector(1);
    return v.normalized();
  }
  Quaternion turn() { return Quaternion(Eigen::AngleAxisd(in(0, 3), direction())); }
};

std::vector<std::pair<std::string, Primitive>> shapes() {
  return {
      {"sphere", Sphere{0.4}},
      {"box", Box{{0.3, 0.5, 0.2}}},
      {"capsule", Capsule{0.2, 0.7}},
      {"cylinder", Cylinder{0.3, 0.8}},
      {"cone", Cone{0.35, 0.9}},
      {"rod", Rod{1.1}},
      {"disc", Disc{0.6}},
      {"hull", Hull{{{0.4, 0, -0.1}, {-0.3, 0.5, 0}, {-0.2, -0.4, 0.3}, {0.1, 0.1, 0.6}, {0, -0.2, -0.5}}}}};
}

Shape widened(const Primitive& primitive) {
  return std::visit([](const auto& s) { return Shape(s); }, primitive);
}

// min over the second of d.x - max over the first of d.x
double separation(const Placed& first, const Placed& second, const Vector3& d) {
  const auto reach = [](const Placed& p, const Vector3& along) {
    return along.dot(p.position) + support(widened(*p.shape), p.orientation.conjugate() * along);
  };
  return -reach(second, -d) - reach(first, d);
}

struct Case {
  std::string name;
  Primitive first, second;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& [a, first] : shapes())
    for (const auto& [b, second] : shapes())
      all.push_back({std::string(a).append("_").append(b), first, second});
  return all;
}

class Convex : public testing::TestWithParam<Case> {};

TEST_P(Convex, GapIsTheLargestSeparation) {
  const bool thin =
      std::holds_alternative<Rod>(GetParam().first) || std::holds_alternative<Disc>(GetParam().first);
  const bool both_thin = thin && (std::holds_alternative<Rod>(GetParam().second) ||
                                  std::holds_alternative<Disc>(GetParam().second));
  Random random{std::mt19937_64(7)};
  int inside = 0, outside = 0;
  for (int i = 0; i < 60; ++i) {
    const double far = i % 2 == 0 ? 0.45 : 1.6;
    const Placed first{&GetParam().first, random.vector(3), random.turn()};
    const Placed second{&GetParam().second, first.position + far * random.direction(), random.turn()};
    const Nearest found = nearest(first, second);
    (found.gap < 0 ? inside : outside)++;
    if (both_thin && found.gap <= 0) continue;  // they cross: no depth
    const double exact = found.gap < 0 ? 1e-6 : 1e-9;
    EXPECT_NEAR(found.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(separation(first, second, found.normal), found.gap, exact) << i;
    EXPECT_LT((found.on_second - found.on_first - found.gap * found.normal).norm(), exact) << i;
    for (int k = 0; k < 300; ++k)
      EXPECT_LE(separation(first, second, random.direction()), found.gap + exact) << i;
    const Nearest back = nearest(second, first);
    EXPECT_NEAR(back.gap, found.gap, exact) << i;
  }
  EXPECT_GT(outside, 5);
  if (!thin && !both_thin) {
    EXPECT_GT(inside, 5);
  }
}
INSTANTIATE_TEST_SUITE_P(All, Convex, testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.name; });

// Gottschalk, Lin, Manocha 1996: of two boxes one of 15 axes separates, or has the least overlap.
TEST(ConvexBoxes, DepthIsThatOfTheSeparatingAxes) {
  Random random{std::mt19937_64(11)};
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Primitive a = Box{{random.in(0.1, 0.6), random.in(0.1, 0.6), random.in(0.1, 0.6)}},
                    b = Box{{random.in(0.1, 0.6), random.in(0.1, 0.6), random.in(0.1, 0.6)}};
    const Placed first{&a, random.vector(5), random.turn()};
    const Placed second{&b, first.position + random.vector(0.6), random.turn()};
    std::vector<Vector3> axes;
    for (int j = 0; j < 3; ++j) {
      axes.push_back(first.orientation * Vector3::Unit(j));
      axes.push_back(second.orientation * Vector3::Unit(j));
      for (int k = 0; k < 3; ++k)
        axes.push_back(
            (first.orientation * Vector3::Unit(j)).cross(second.orientation * Vector3::Unit(k)).normalized());
    }
    double most = -1e9;
    for (const Vector3& axis : axes)
      for (const double sense : {1.0, -1.0}) most = std::max(most, separation(first, second, sense * axis));
    const double gap = nearest(first, second).gap;
    EXPECT_EQ(gap > 0, most > 0) << i;
    if (most > 0) continue;
    ++inside;
    EXPECT_NEAR(gap, most, 1e-10) << i;
  }
  EXPECT_GT(inside, 500);
}

// Faces flush, edges parallel, centres on one line: what stacks are made of.
TEST(ConvexBoxes, StackedFlush) {
  const Primitive box = Box{{0.5, 0.25, 0.4}};
  for (const double gap : {0.1, 1e-6, -1e-6, -5e-4, -0.1}) {
    const Placed below{&box, {1, 2, 3}, Quaternion::Identity()};
    const Placed above{&box, {1, 2.5 + gap, 3}, Quaternion::Identity()};
    EXPECT_NEAR(nearest(below, above).gap, gap, 1e-12);
    EXPECT_NEAR(nearest(below, above).normal.y(), 1, 1e-9);
    const Placed aside{&box, {1.2, 2.5 + gap, 2.9}, Quaternion::Identity()};
    EXPECT_NEAR(nearest(below, aside).gap, gap, 1e-12);
  }
  const Placed below{&box, {1, 2, 3}, Quaternion::Identity()},
      above{&box, {1, 2.5, 3}, Quaternion::Identity()};
  EXPECT_NEAR(nearest(below, above).gap, 0, 1e-12) << "touching";
}

// Their axes have a point in common, and the least way out is along the common perpendicular of both.
TEST(Convex, CrossingCapsulesPartAlongTheCommonPerpendicular) {
  Random random{std::mt19937_64(13)};
  const Primitive a = Capsule{0.2, 1.4}, b = Capsule{0.1, 1.0};
  for (int i = 0; i < 200; ++i) {
    const Placed first{&a, random.vector(3), random.turn()};
    Placed second{&b, {}, random.turn()};
    const Vector3 u = first.orientation * Vector3::UnitY(), v = second.orientation * Vector3::UnitY();
    const Vector3 crossing = first.position + random.in(-0.6, 0.6) * u;
    second.position = crossing + random.in(-0.4, 0.4) * v;
    const Nearest found = nearest(first, second);
    EXPECT_NEAR(found.gap, -0.3, 1e-12) << i;
    EXPECT_NEAR(std::abs(found.normal.dot(u.cross(v).normalized())), 1, 1e-9) << i;
    EXPECT_LT((found.on_first - 0.2 * found.normal - crossing).norm(), 1e-9) << i;
  }
}

TEST(Convex, NumbersThatAreNotFiniteStay) {
  const Primitive box = Box{{0.5, 0.25, 0.4}};
  EXPECT_TRUE(std::isnan(nearest({&box, {1, 2, std::nan("")}}, {&box, {1, 2, 4}}).gap));
}

Scene scene_of(const Shape& one, const Shape& other, Random& random, double far) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = one, scene.bodies[1].shape = other;
  for (Body& body : scene.bodies) {
    body.collide = true;
    body.initial.orientation = random.turn();
    body.initial.velocity = random.vector(1), body.initial.angular_velocity = random.vector(2);
  }
  scene.bodies[0].initial.position = random.vector(1);
  scene.bodies[1].initial.position = scene.bodies[0].initial.position + far * random.direction();
  scene.planes = {{"floor", random.direction(), -2}};
  return scene;
}

// The rigid motion at constant velocities.
State after(const State& start, double t) {
  State state = start;
  for (BodyState& s : state) {
    s.position += t * s.velocity;
    const double w = s.angular_velocity.norm();
    s.orientation = Quaternion(Eigen::AngleAxisd(w * t, s.angular_velocity / w)) * s.orientation;
  }
  return state;
}

TEST(GapRate, IsTheSlopeOfTheGap) {
  Random random{std::mt19937_64(3)};
  const std::vector<Shape> all = {Sphere{0.4}, Box{{0.3, 0.5, 0.2}}, Capsule{0.2, 0.7}, Cylinder{0.3, 0.8},
                                  Compound{{{Box{{0.2, 0.2, 0.2}}, 1, {0.5, 0, 0}, Quaternion::Identity()},
                                            {Sphere{0.3}, 1, {-0.5, 0.1, 0}, Quaternion::Identity()}}}};
  int close = 0;
  for (const Shape& one : all)
    for (const Shape& other : all)
      for (const double far : {0.35, 2.0}) {
        const Scene scene = scene_of(one, other, random, far);
        const State start = initial_state(scene);
        for (const Pair& pair : {Pair{0, 1, -1}, Pair{0, world, 0}}) {
          const double h = 1e-6;
          const double slope =
              (gap(scene, pair, after(start, h)) - gap(scene, pair, after(start, -h))) / (2 * h);
          if (std::abs(slope - gap_rate(scene, pair, start)) < 1e-4) ++close;
        }
      }
  EXPECT_GE(close, 96) << "of 100; where another corner or face takes over, there is no slope";
}

TEST(GapUndefined, WithoutAShapeAlone) {
  Random random{std::mt19937_64(5)};
  const Scene boxes = scene_of(Box{{0.3, 0.5, 0.2}}, Cylinder{0.3, 0.8}, random, 1);
  EXPECT_FALSE(gap_undefined(boxes, {0, 1, -1}));
  const Scene point = scene_of(Box{{0.3, 0.5, 0.2}}, std::monostate{}, random, 1);
  EXPECT_TRUE(gap_undefined(point, {0, 1, -1}));
  EXPECT_FALSE(gap_undefined(point, {0, world, 0}));
}

// A cube as twelve triangles, alone and as a part: outside it is as far as the box, and as deep where less than
// half of the other is inside.
TEST(Gap, OfAMeshIsThatOfItsTriangles) {
  Mesh cube;
  for (int i = 0; i < 8; ++i)
    cube.vertices.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
  cube.faces = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  Random random{std::mt19937_64(8)};
  int outside = 0;
  for (const double far : {0.75, 0.9, 1.2, 3.0})
    for (const Shape& surface :
         {Shape(cube), Shape(Compound{{{cube, 1, Vector3::Zero(), Quaternion::Identity()}}})}) {
      Scene scene = scene_of(Sphere{0.3}, Box{{0.5, 0.5, 0.5}}, random, far);
      const double solid = gap(scene, {0, 1, -1}, initial_state(scene));
      scene.bodies[1].shape = surface;
      EXPECT_NEAR(gap(scene, {0, 1, -1}, initial_state(scene)), solid, 1e-9) << far;
      outside += solid > 0;
    }
  EXPECT_GT(outside, 2);
}

TEST(FarthestPoint, IsWhereTheSupportIs) {
  Random random{std::mt19937_64(13)};
  for (const auto& [name, shape] : shapes())
    for (int i = 0; i < 50; ++i) {
      const Vector3 d = random.direction();
      EXPECT_NEAR(d.dot(farthest_point(widened(shape), d)), support(widened(shape), d), 1e-12) << name;
    }
}

// Two boxes half a millimetre in each other are that, whoever says that they rest.
TEST(NormalGap, OfBoxesIsTheirDepth) {
  Scene scene;
  scene.bodies.resize(2);
  for (Body& body : scene.bodies) body.shape = Box{{0.5, 0.5, 0.5}}, body.collide = true;
  scene.bodies[0].initial.position = {0.2, 3.1, -1};
  scene.bodies[1].initial.position = {0.3, 4.0995, -1.1};
  Values values;
  evaluate({.quantity = Quantity::normal_gap}, scene, initial_state(scene), values);
  ASSERT_EQ(values.size(), 1u);
  EXPECT_NEAR(values[0].x(), -5e-4, 1e-12);
  scene.bodies[1].initial.position.y() += 6e-4;
  evaluate({.quantity = Quantity::normal_gap}, scene, initial_state(scene), values);
  EXPECT_TRUE(values.empty());
}

}  // namespace
