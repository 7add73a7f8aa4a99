// Cylinders, cones, compounds and surfaces of triangles in fixed steps, against closed forms.
#include "engine/geometry/hull.h"
#include "engine/geometry/part_boxes.h"
#include "engine/geometry/separation.h"
#include "engine/methods.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace cylon::engine {
namespace {

const Quaternion crooked = Quaternion(Real(0.8), Real(0.2), Real(-0.4), Real(0.4)).normalized();
const Vector3 somewhere(Real(3.7), Real(-1.2), Real(0.6));

Matrix3 inertia_of(const Frustum& s, Real mass) {  // of a cylinder
  const Real r2 = s.low_radius * s.low_radius, h = s.high - s.low, across = (3 * r2 + h * h) / 12;
  return mass * Vector3(across, r2 / 2, across).asDiagonal().toDenseMatrix();
}

// The whole scene turned and moved, its floor too; bodies in the opposite order where asked.
Model moved(Model model, const Quaternion& turn, const Vector3& shift, bool swap = false) {
  model.forces.gravity = turn * model.forces.gravity;
  for (Motion& m : model.motions) {
    m.position = turn * m.position + shift, m.orientation = turn * m.orientation;
    m.momentum = turn * m.momentum, m.angular_momentum = turn * m.angular_momentum;
  }
  for (Plane& plane : model.planes) {
    plane.normal = turn * plane.normal;
    plane.offset += plane.normal.dot(shift);
  }
  if (swap) {
    std::reverse(model.bodies.begin(), model.bodies.end());
    std::reverse(model.motions.begin(), model.motions.end());
    std::reverse(model.shapes.begin(), model.shapes.end());
  }
  return model;
}

// On an incline by `angle`: gravity is turned, and the floor is at y = 0: a plane, a locked box or locked triangles.
enum class Floor { plane, box, triangles };

// Coplanar triangles over 12 x 12 m, in crooked rows.
Compound triangles() {
  Compound surface;
  const auto at = [](int i, int k) {
    return Vector3(Real(i) - 6 + Real(0.1) * static_cast<Real>((i * 7 + k * 3) % 5), 0,
                   Real(k) - 6 + Real(0.07) * static_cast<Real>((i * 2 + k * 5) % 7));
  };
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 12; ++k) {
      const Vector3 p = at(i, k), q = at(i, k + 1), r = at(i + 1, k + 1), s = at(i + 1, k);
      surface.parts.push_back({make_triangle({p, q, r}), Vector3::Zero(), Matrix3::Identity()});
      surface.parts.push_back({make_triangle({p, r, s}), Vector3::Zero(), Matrix3::Identity()});
    }
  return surface;
}

Model incline(Real angle, Real friction, Floor floor) {
  Model model = pile_model(0, friction, floor == Floor::plane);
  model.forces.gravity = g * Vector3(std::sin(angle), -std::cos(angle), 0);
  const Body fixed = make_body(1, Matrix3::Identity(), true);
  if (floor == Floor::box) add_body(model, fixed, Box{{6, Real(0.5), 6}}, Vector3(0, Real(-0.5), 0));
  if (floor == Floor::triangles) add_body(model, fixed, triangles(), Vector3::Zero());
  return model;
}

std::size_t moving(const Model& model) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    if (!model.bodies[i].locked) return i;
  return 0;
}

struct Incline {
  const char* name;
  Floor floor;
  bool turned, swapped;
};
const Incline inclines[] = {
    {"plane", Floor::plane, false, false},
    {"turned plane", Floor::plane, true, false},
    {"box", Floor::box, false, false},
    {"turned box", Floor::box, true, true},
    {"triangles", Floor::triangles, false, false},
    {"turned triangles", Floor::triangles, true, true},
};

// Distance down the incline and the rest of the displacement after 1 s.
std::pair<Real, Real> way(const Model& model, const Incline& c, double dt) {
  const Quaternion turn = c.turned ? crooked : Quaternion(Quaternion::Identity());
  const Model there = moved(model, turn, c.turned ? somewhere : Vector3(Vector3::Zero()), c.swapped);
  const std::size_t i = moving(there);
  const auto end = after(*make_pile(there, dt), static_cast<int>(std::lround(1 / dt)));
  const Vector3 d = turn.conjugate() * (end[i].position - there.motions[i].position);
  return {d.x(), std::hypot(d.y(), d.z())};
}

// What is constant the leapfrog method integrates exactly.
void expect_exact(const Model& model, const Incline& c, Real exact, const std::string& what) {
  for (const double dt : {1. / 100, 1. / 200}) {
    const auto [found, aside] = way(model, c, dt);
    EXPECT_NEAR(found, exact, Real(sizeof(Real) == 8 ? 1e-9 : 1e-4)) << what << ' ' << c.name << ' ' << dt;
    EXPECT_LT(aside, Real(1e-6)) << what << ' ' << c.name << ' ' << dt;
  }
}

// a = g sin/(1 + I/(m r^2)) = 2/3 g sin, and without friction g sin and no turn.
TEST(PileShapes, CylinderRollsAndSlidesDown) {
  const Real angle = Real(0.2);
  const Frustum can{Real(0.3), Real(0.3), Real(-0.4), Real(0.4)};
  const Quaternion lies(Eigen::AngleAxis<Real>(Real(std::acos(-1.) / 2), Vector3::UnitX()));
  for (const Incline& c : inclines)
    for (const Real friction : {Real(0.6), Real(0)}) {
      Model model = incline(angle, friction, c.floor);
      add_body(model, make_body(2, inertia_of(can, 2)), can, {Real(-1.3), Real(0.3), Real(0.21)},
               Vector3::Zero(), Vector3::Zero(), lies);
      const Real a = g * std::sin(angle) * (friction > 0 ? Real(2) / 3 : 1);
      expect_exact(model, c, a / 2, friction > 0 ? "rolls" : "slides");
    }
}

// A thin one turns by more than a quarter of a turn in a step; points ahead of the lowest, taken as fixed to it,
// would have to stop above the floor, and held it at 0.1 m/s.
TEST(PileShapes, ThinCylinderThatRollsFastIsNotBraked) {
  const Quaternion lies(Eigen::AngleAxis<Real>(Real(std::acos(-1.) / 2), Vector3::UnitX()));
  for (const Real radius : {Real(0.03), Real(0.01), Real(0.004)})
    for (const Incline& c : inclines) {
      if (c.floor != Floor::plane) continue;
      const Frustum can{radius, radius, Real(-0.4), Real(0.4)};
      Model model = incline(Real(0.2), Real(0.6), c.floor);
      add_body(model, make_body(2, inertia_of(can, 2)), can, {Real(-1.3), radius, Real(0.21)},
               Vector3::Zero(), Vector3::Zero(), lies);
      const auto [found, aside] =
          way(model, c, 1. / 100);  // in more parts the faster it is: of no order in dt
      const Real exact = g * std::sin(Real(0.2)) / 3;
      EXPECT_NEAR(found, exact, Real(0.01) * exact) << c.name << ' ' << radius;
      EXPECT_LT(aside, Real(1e-6)) << c.name << ' ' << radius;
    }
}

// a = g (sin - mu cos) on a cap, on the base of a cone, and on two blocks made one.
TEST(PileShapes, SlideDownOnFlatFaces) {
  const Real angle = Real(0.3), friction = Real(0.1);
  const Frustum can{Real(0.3), Real(0.3), Real(-0.1), Real(0.1)}, cone{Real(0.3), 0, Real(-0.1), Real(0.3)};
  const Box half{{Real(0.2), Real(0.1), Real(0.3)}};
  const Compound two = {
      {{half, {Real(-0.2), 0, 0}, Matrix3::Identity()}, {half, {Real(0.2), 0, 0}, Matrix3::Identity()}}};
  struct Row {
    const char* name;
    Shape shape;
  };
  for (const Incline& c : inclines)
    for (const Row& row : {Row{"can", can}, Row{"cone", cone}, Row{"two blocks", two}}) {
      Model model = incline(angle, friction, c.floor);
      add_body(model, make_body(2, Matrix3::Identity() * Real(0.05)), row.shape,
               {Real(-1.3), Real(0.1), Real(0.21)}, Vector3::Zero(), Vector3::Zero(),
               Quaternion(Eigen::AngleAxis<Real>(Real(0.4), Vector3::UnitY())));
      expect_exact(model, c, g * (std::sin(angle) - friction * std::cos(angle)) / 2, row.name);
    }
}

// A cylinder of height 2 h stands where tan < r/h, to the corners of an octagon, cos(pi/8) of r; else it tips.  A cone
// of height H has its centre H/4 high.
TEST(PileShapes, StandsUntilItsWeightIsBesideItsBase) {
  const Real r = Real(0.2), h = Real(0.5);
  struct Row {
    const char* name;
    Frustum shape;
    Real centre;
  };
  for (const Row& row : {Row{"can", {r, r, -h, h}, h}, Row{"cone", {r, 0, -h, 3 * h}, h}})
    for (const Floor floor : {Floor::plane, Floor::box})
      for (const Real part : {Real(0.85), Real(1.05)})
        for (const Real heading : {Real(0), Real(0.7)}) {
          Model model = incline(std::atan(part * r / row.centre), 2, floor);
          add_body(model, make_body(1, Matrix3::Identity() * Real(0.05)), row.shape, {0, row.centre, 0},
                   Vector3::Zero(), Vector3::Zero(),
                   Quaternion(Eigen::AngleAxis<Real>(heading, Vector3::UnitY())));
          const auto end = after(*make_pile(model, 1. / 120), 240);
          const Real up = (end[moving(model)].orientation * Vector3::UnitY()).y();
          if (part < 1)
            EXPECT_GT(up, Real(1 - 1e-9)) << row.name << heading;
          else
            EXPECT_LT(up, Real(0.9)) << row.name << heading;
        }
}

// No ghost collisions: what slides without friction keeps its velocity over 24 rows of triangles.
TEST(PileShapes, SlideOverSeamsKeepsItsVelocity) {
  const Frustum can{Real(0.3), Real(0.3), Real(-0.1), Real(0.1)};
  const Compound table = {
      {{Box{{Real(0.4), Real(0.05), Real(0.4)}}, {0, Real(0.25), 0}, Matrix3::Identity()},
       {Box{{Real(0.05), Real(0.2), Real(0.05)}}, {Real(0.3), 0, Real(0.3)}, Matrix3::Identity()},
       {Box{{Real(0.05), Real(0.2), Real(0.05)}}, {Real(-0.3), 0, Real(0.3)}, Matrix3::Identity()},
       {Box{{Real(0.05), Real(0.2), Real(0.05)}}, {Real(0.3), 0, Real(-0.3)}, Matrix3::Identity()},
       {Box{{Real(0.05), Real(0.2), Real(0.05)}}, {Real(-0.3), 0, Real(-0.3)}, Matrix3::Identity()}}};
  struct Row {
    const char* name;
    Shape shape;
    Real height;
  };
  const Row rows[] = {{"box", Box{{Real(0.4), Real(0.2), Real(0.3)}}, Real(0.2)},
                      {"ball", Sphere{Real(0.3)}, Real(0.3)},
                      {"can", can, Real(0.1)},
                      {"table", table, Real(0.2)}};
  for (const Row& row : rows)
    for (const bool turned : {false, true}) {
      Model model = incline(0, 0, Floor::triangles);
      const Vector3 v(3, 0, Real(0.4));
      add_body(model, make_body(2, Matrix3::Identity() * Real(0.05)), row.shape,
               {Real(-4.5), row.height, Real(0.1)}, v);
      const Quaternion turn = turned ? crooked : Quaternion(Quaternion::Identity());
      model = moved(model, turn, turned ? somewhere : Vector3(Vector3::Zero()));
      const auto end = after(*make_pile(model, 1. / 120), 300);
      const Vector3 now = turn.conjugate() * velocity(model.bodies[1], end[1]);
      EXPECT_NEAR((now - v).norm(), 0, Real(1e-9)) << row.name << turned;
      EXPECT_LT(angular_velocity(model.bodies[1], end[1]).norm(), Real(1e-9)) << row.name << turned;
    }
}

// The control: a step of 1 cm in the surface stops the box.
TEST(PileShapes, StepInTrianglesStops) {
  Model model = incline(0, 0, Floor::triangles);
  auto& surface = std::get<Compound>(model.shapes[0]);
  const Real up = Real(0.01);
  const Vector3 p(0, 0, -6), q(0, 0, 6), p_up(0, up, -6), q_up(0, up, 6), far(6, up, 0);
  surface.parts.push_back({make_triangle({p, q, q_up}), Vector3::Zero(), Matrix3::Identity()});
  surface.parts.push_back({make_triangle({p, q_up, p_up}), Vector3::Zero(), Matrix3::Identity()});
  surface.parts.push_back({make_triangle({p_up, q_up, far}), Vector3::Zero(), Matrix3::Identity()});
  add_body(model, make_body(2, Matrix3::Identity() * Real(0.05)), Box{{Real(0.4), Real(0.2), Real(0.3)}},
           {-3, Real(0.2), Real(0.1)}, {3, 0, 0});
  const auto end = after(*make_pile(model, 1. / 120), 300);
  EXPECT_LT(velocity(model.bodies[1], end[1]).x(), Real(1.5));
}

// Parts side by side are as one box: dropped, tumbling, at rest; in either order, and beside a third body.
TEST(PileShapes, TwoHalvesMoveAsTheWhole) {
  const Vector3 half(Real(0.4), Real(0.2), Real(0.3)), quarter(Real(0.2), Real(0.2), Real(0.3));
  const Compound two = {{{Box{quarter}, {Real(-0.2), 0, 0}, Matrix3::Identity()},
                         {Box{quarter}, {Real(0.2), 0, 0}, Matrix3::Identity()}}};
  for (const Floor floor : {Floor::plane, Floor::box}) {
    std::vector<Motion> ends;
    for (const Shape& shape : {Shape(Box{half}), Shape(two)}) {
      Model model = incline(Real(0.1), Real(0.7), floor);
      add_box(model, 2, half, {0, Real(0.6), 0}, {Real(0.5), 0, 0}, {Real(0.3), Real(0.2), 1},
              Quaternion(Eigen::AngleAxis<Real>(Real(0.3), Vector3::UnitZ())));
      model.shapes.back() = shape;
      ends.push_back(after(*make_pile(model, 1. / 240), 120)[moving(model)]);
    }
    EXPECT_NEAR((ends[0].position - ends[1].position).norm(), 0, Real(2e-3)) << int(floor);
  }
}

// A dumbbell of two balls on a bar, thrown: momenta are kept in flight and in collisions with a free box.
TEST(PileShapes, IsolatedCompoundsKeepMomenta) {
  const Compound dumbbell = {
      {{Sphere{Real(0.2)}, {0, Real(0.4), 0}, Matrix3::Identity()},
       {Frustum{Real(0.05), Real(0.05), Real(-0.4), Real(0.4)}, {}, Matrix3::Identity()},
       {Sphere{Real(0.2)}, {0, Real(-0.4), 0}, Matrix3::Identity()}}};
  Model model = pile_model(Real(0.5), Real(0.3), false);
  model.forces.gravity.setZero();
  add_body(model, make_body(2, Vector3(Real(0.3), Real(0.05), Real(0.3)).asDiagonal().toDenseMatrix()),
           dumbbell, {Real(-1.2), Real(0.1), 0}, {2, 0, 0}, {0, Real(0.3), Real(0.7)});
  add_box(model, 3, {Real(0.3), Real(0.4), Real(0.2)}, Vector3::Zero());
  const auto end = after(*make_pile(model, 1. / 240), 480);
  EXPECT_NEAR((momentum(end) - momentum(model.motions)).norm(), 0, Real(1e-12));
  EXPECT_NEAR((angular_momentum(end) - angular_momentum(model.motions)).norm(), 0, Real(1e-11));
  EXPECT_LE(mechanical_energy(model, end), mechanical_energy(model, model.motions) + 1e-12);
  EXPECT_GT(velocity(model.bodies[1], end[1]).x(), Real(0.3));  // they have met
}

// Forty bodies of all kinds into a box of triangles: more than 32, so that contacts are kept.
TEST(PileShapes, MixedShapesSettle) {
  const auto part = [](const Shape& shape, const Vector3& at) {
    return ShapePart{shape, at, Matrix3::Identity()};
  };
  const Shape kinds[] = {
      Frustum{Real(0.2), Real(0.2), Real(-0.25), Real(0.25)},
      Frustum{Real(0.3), 0, Real(-0.1), Real(0.3)},
      Box{{Real(0.2), Real(0.15), Real(0.3)}},
      Compound{{part(Box{{Real(0.3), Real(0.1), Real(0.1)}}, {Real(0.1), Real(-0.1), 0}),
                part(Box{{Real(0.1), Real(0.2), Real(0.1)}}, {Real(-0.1), Real(0.2), 0})}},
      Compound{{part(Sphere{Real(0.15)}, {0, Real(0.25), 0}), part(Sphere{Real(0.15)}, {0, Real(-0.25), 0}),
                part(Frustum{Real(0.06), Real(0.06), Real(-0.25), Real(0.25)}, Vector3::Zero())}},
      Sphere{Real(0.2)}};
  Model model = incline(0, Real(0.5), Floor::triangles);
  for (const Vector3& n : {Vector3(1, 0, 0), Vector3(-1, 0, 0), Vector3(0, 0, 1), Vector3(0, 0, -1)})
    model.planes.push_back({n, Real(-1.2)}), model.plane_surfaces.push_back(0);
  for (int i = 0; i < 40; ++i) {
    const int layer = i / 9;
    add_body(
        model, make_body(1, Matrix3::Identity() * Real(0.02)), kinds[i % 6],
        {Real(-0.7) + Real(0.7) * static_cast<Real>(i % 3), Real(0.5) + Real(0.75) * static_cast<Real>(layer),
         Real(-0.7) + Real(0.7) * static_cast<Real>(i / 3 % 3)},
        Vector3::Zero(), {Real(0.1), Real(0.2), 0},
        Quaternion(Eigen::AngleAxis<Real>(Real(0.3) * static_cast<Real>(i), Vector3(1, 2, 3).normalized())));
  }
  const auto end = after(*make_pile(model, 1. / 60), 240);
  Real fastest = 0, deepest = 0;
  for (std::size_t i = 1; i < end.size(); ++i) {
    if (i < 41) fastest = std::max(fastest, velocity(model.bodies[i], end[i]).norm());
    EXPECT_GT(end[i].position.y(), Real(0.05)) << i;  // none has fallen through
    for (std::size_t k = 0; k < i; ++k)
      deepest =
          std::max(deepest, -separation(model.shapes[i], pose(end[i]), model.shapes[k], pose(end[k])).gap);
  }
  EXPECT_LT(fastest, Real(0.3));
  EXPECT_LT(deepest, Real(0.01));
  RecordProperty("fastest", std::to_string(fastest));
  RecordProperty("deepest", std::to_string(deepest));
  EXPECT_LT(mechanical_energy(model, end), mechanical_energy(model, model.motions));
}

// The parts near a box are those that every part is asked for, whatever their order.
TEST(PileShapes, PartBoxesFindTheParts) {
  const Shape surface = triangles();
  const PartBoxes boxes(surface);
  const int count = static_cast<int>(std::get<Compound>(surface).parts.size());
  std::vector<int> found;
  int some = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3 at(Real(0.1) * static_cast<Real>(i * 37 % 140) - 7,
                     Real(0.1) * static_cast<Real>(i % 3 - 1),
                     Real(0.1) * static_cast<Real>(i * 53 % 140) - 7);
    const Vector3 half(Real(0.3), Real(0.15), Real(0.05) * static_cast<Real>(i % 20));
    const Bounds box = {at - half, at + half};
    boxes.near(box, found);
    std::vector<int> all;
    for (int k = 0; k < count; ++k)
      if ((boxes.of(k).low.array() <= box.high.array()).all() &&
          (box.low.array() <= boxes.of(k).high.array()).all())
        all.push_back(k);
    EXPECT_EQ(found, all) << i;
    some += !found.empty();
  }
  EXPECT_GT(some, 50);
}

TEST(PileShapes, OnlyStepsClaimThem) {
  Model model = incline(0, 0, Floor::plane);
  add_body(model, make_body(1, Matrix3::Identity()), Frustum{1, 1, -1, 1}, {0, 2, 0});
  for (const Method method : {Method::events, Method::ballistic, Method::sphere_steps})
    EXPECT_NE(missing(method, model).find("cylinders"), std::string::npos) << missing(method, model);
  EXPECT_EQ(missing(Method::body_steps, model), "");
  // Of compounds only those that touch nothing but planes are followed event by event.
  model.shapes[0] = Compound{{{Sphere{Real(0.3)}, {1, 0, 0}, Matrix3::Identity()}}};
  EXPECT_EQ(missing(Method::events, model), "");
  add_ball(model, 1, 1, {4, 2, 0});
  EXPECT_EQ(missing(Method::events, model), "compounds that touch other bodies");
  EXPECT_EQ(missing(Method::body_steps, model), "");
}

}  // namespace
}  // namespace cylon::engine
