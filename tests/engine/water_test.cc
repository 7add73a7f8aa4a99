// Water: submerged parts against slices, floating at rest and bobbing, waves, and the seed's step water.
#include "tests/engine/fixtures.h"

#include <numbers>

namespace cylon::engine {
namespace {

constexpr Real pi = std::numbers::pi;

struct Slices {
  Real volume = 0;
  Vector3 centroid = Vector3::Zero();
};

// Volume and centroid below y = height by cells: `inside(p)` over a box around the body; error of the order
// of the cell times the surface.
template <class Inside>
Slices sliced(const Vector3& centre, Real reach, Real height, Inside inside) {
  constexpr int n = 120;
  const Real cell = 2 * reach / n;
  Slices result;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const Vector3 p(centre.x() - reach + cell * (i + 0.5), height - cell * (j + 0.5),
                        centre.z() - reach + cell * (k + 0.5));
        if (!inside(p)) continue;
        result.volume += cell * cell * cell;
        result.centroid += cell * cell * cell * p;
      }
    }
  }
  if (result.volume > 0) result.centroid /= result.volume;
  return result;
}

// A tetrahedron without symmetry, faces seen from outside counter-clockwise.
Hull tetrahedron() {
  Hull hull;
  hull.vertices = {{-0.3, -0.2, -0.25}, {0.5, -0.1, -0.2}, {-0.1, -0.15, 0.45}, {0.05, 0.5, 0.1}};
  hull.faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  return hull;
}

bool inside_hull(const Hull& hull, const Vector3& p) {
  for (const auto& face : hull.faces) {
    const auto corner = [&](std::size_t i) -> const Vector3& {
      return hull.vertices[static_cast<std::size_t>(face[i])];
    };
    if ((corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(p - corner(0)) > 0) return false;
  }
  return true;
}

TEST(Submerged, IsThePartBelowTheSurface) {
  const Vector3 position = {0.3, 0.7, -0.4}, half = {0.4, 0.25, 0.3};
  const Matrix3 r = exponential({0.5, -0.8, 0.3}).toRotationMatrix();
  const Hull hull = tetrahedron();
  const auto local = [&](const Vector3& p) -> Vector3 { return r.transpose() * (p - position); };
  for (const Real depth : {-0.3, -0.1, 0.05, 0.2, 0.33}) {
    const Real height = position.y() + depth;
    const auto check = [&](const Shape& shape, Real volume, auto inside) {
      const Submerged part = submerged(shape, position, r, height);
      const Slices cells = sliced(position, 0.65, height, inside);
      // Cells of 1 cm, whose errors over a surface of 2 m^2 cancel like a random walk: 1e-6 sqrt(2e4) m^3
      EXPECT_NEAR(part.volume, cells.volume, 3e-4) << depth;
      EXPECT_NEAR(part.whole, volume, 1e-14) << depth;
      if (part.volume < 0.01) return;
      EXPECT_LT((part.centroid - cells.centroid).norm(), 2e-3) << depth;
    };
    check(Sphere{0.35}, 4 * pi / 3 * 0.35 * 0.35 * 0.35,
          [&](const Vector3& p) { return (p - position).norm() < 0.35; });
    check(Box{half}, 8 * half.prod(),
          [&](const Vector3& p) { return (local(p).cwiseAbs() - half).maxCoeff() < 0; });
    const Vector3 a = hull.vertices[1] - hull.vertices[0], b = hull.vertices[2] - hull.vertices[0];
    const Real whole = std::abs(a.cross(b).dot(hull.vertices[3] - hull.vertices[0])) / 6;
    check(hull, whole, [&](const Vector3& p) { return inside_hull(hull, local(p)); });
  }
}

TEST(Submerged, AllOrNothing) {
  const Vector3 position = {0.3, 0.7, -0.4};
  const Matrix3 r = exponential({0.5, -0.8, 0.3}).toRotationMatrix();
  for (const Shape& shape : {Shape(Sphere{0.35}), Shape(Box{{0.4, 0.25, 0.3}}), Shape(tetrahedron())}) {
    EXPECT_EQ(submerged(shape, position, r, -1).volume, 0);
    const Submerged all = submerged(shape, position, r, 3);
    EXPECT_NEAR(all.volume, all.whole, 1e-15);
    const Vector3 middle = std::holds_alternative<Hull>(shape)
                               ? Vector3(r * Vector3(0.0375, 0.0125, 0.025))  // the mean of the corners
                               : Vector3(Vector3::Zero());
    EXPECT_LT((all.centroid - position - middle).norm(), 1e-14);
  }
  EXPECT_EQ(submerged(std::monostate{}, position, r, 3).volume, 0);  // a point displaces nothing
}

// dV/dh is the area of the cut: the volume is smooth where corners go under.
TEST(Submerged, VolumeGrowsByTheAreaOfTheCut) {
  const Vector3 position = {0.3, 0.7, -0.4};
  const Real radius = 0.35, e = 1e-6;
  for (const Real d : {-0.2, 0.1, 0.3}) {
    const auto volume = [&](Real h) {
      return submerged(Sphere{radius}, position, Matrix3::Identity(), position.y() + h).volume;
    };
    EXPECT_NEAR((volume(d + e) - volume(d - e)) / (2 * e), pi * (radius * radius - d * d), 1e-9);
  }
}

Model floating(const Shape& shape, const Body& body, const Vector3& position, Real density) {
  Model model;
  add_body(model, body, position, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, shape);
  model.forces.gravity = {0, -9.81, 0};
  Water water;
  water.level = 0.5;
  water.buoyancy = density;
  water.shapes = {shape};
  model.forces.waters.push_back(water);
  return model;
}

// Half as dense as the water: the centre of a sphere rests at the surface.
TEST(Floating, RestsWhereItsWeightIsDisplaced) {
  const Real radius = 0.3, density = 1000, mass = density * 2 * pi / 3 * radius * radius * radius;
  const Body ball = make_body(mass, Matrix3::Identity() * (0.4 * mass * radius * radius));
  Model model = floating(Sphere{radius}, ball, {0.2, 0.5, 0.1}, density);
  EXPECT_LT((run(model, "rk4", 2, 200).motions[0].position - model.motions[0].position).norm(), 1e-13);

  const Real a = 0.25, b = 0.4, c = 0.35, heavy = 0.7 * density * 8 * a * b * c;
  const Body brick = make_body(
      heavy, heavy / 3 * Vector3(b * b + c * c, a * a + c * c, a * a + b * b).asDiagonal().toDenseMatrix());
  model = floating(Box{{a, b, c}}, brick, {0.2, 0.5 - 0.4 * b, 0.1}, density);  // 0.7 of 2 b below
  model.forces.waters[0].level = 0.5;
  EXPECT_LT((run(model, "rk4", 0.5, 100).motions[0].position - model.motions[0].position).norm(), 1e-13);
}

// An upright box of width 2a, 2c:  m y'' = -density 4 a c g y,  exactly, while the surface cuts its sides.
TEST(Floating, ABoxBobsHarmonically) {
  const Real a = 0.25, b = 0.4, c = 0.35, density = 1000, mass = 0.6 * density * 8 * a * b * c;
  const Body brick = make_body(
      mass, mass / 3 * Vector3(b * b + c * c, a * a + c * c, a * a + b * b).asDiagonal().toDenseMatrix());
  Model model = floating(Box{{a, b, c}}, brick, {0.2, 0.5 - 0.2 * b + 0.1, 0.1}, density);
  const Real w = std::sqrt(density * 4 * a * c * 9.81 / mass), t = 1.7;
  const Outcome end = run(model, "rk8", t, 340);
  EXPECT_NEAR(end.motions[0].position.y(), 0.5 - 0.2 * b + 0.1 * std::cos(w * t), 1e-12);
  EXPECT_LT(end.motions[0].angular_momentum.norm(), 1e-11);  // a symmetric lift has no torque

  // Drag takes the submerged share of its coefficient; always lost.
  model.forces.waters[0].drag = 60;
  const Outcome damped = run(model, "rk8", t, 340);
  EXPECT_LT(std::abs(damped.motions[0].momentum.y()) + 10, 10 + mass * 0.1 * w);
  EXPECT_GT(std::abs(damped.motions[0].position.y() - end.motions[0].position.y()), 1e-4);
}

// A tilted box is set upright by its lift, and Archimedes' force is that of the displaced water at its
// centroid.
TEST(Floating, ATiltedBoxIsTurnedBack) {
  const Real a = 0.6, b = 0.1, c = 0.5, density = 1000, mass = 0.5 * density * 8 * a * b * c;
  const Body raft = make_body(
      mass, mass / 3 * Vector3(b * b + c * c, a * a + c * c, a * a + b * b).asDiagonal().toDenseMatrix());
  Model model = floating(Box{{a, b, c}}, raft, {0.2, 0.5, 0.1}, density);
  model.motions[0].orientation = exponential({0, 0, 0.1});
  const Outcome end = run(model, "rk4", 0.02, 20);
  EXPECT_LT(end.motions[0].angular_momentum.z(), 0);
}

// h = level + wave sin(x - speed t)
TEST(Wave, RunsAlongX) {
  Water water;
  water.level = 0.4, water.wave = 0.3, water.speed = 1.7;
  for (const Time t : {0.0, 0.8, 3.1}) {
    for (const Real x : {-2.0, 0.3, 1.9}) {
      EXPECT_NEAR(water.surface(t, {x, 9, -7}), 0.4 + 0.3 * std::sin(x - 1.7 * t), 1e-15);
    }
  }
}

// Errata 51: the seed's table, and outside of it its edge.
TEST(Step, SurfaceIsTheSeedsTable) {
  Water water;
  water.level = 1, water.wave = 0.35, water.speed = 1.5, water.mode = WaterMode::step;
  const auto height = [](Real t, int i, int j) {
    return 1 + 0.175 * std::sin(1.5 * t + i) + 0.175 * std::sin(0.5 * i * j);
  };
  for (const Time t : {0.0, 0.7}) {
    EXPECT_NEAR(water.surface(t, {-5.0, 0, -5.0}), height(t, 0, 0), 1e-15);
    EXPECT_NEAR(water.surface(t, {0.3, 0, 2.1}), height(t, 21, 28), 1e-15);
    EXPECT_NEAR(water.surface(t, {5.2, 0, -4.9}), height(t, 40, 0), 1e-15);
    EXPECT_NEAR(water.surface(t, {90, 0, -90}), height(t, 40, 0), 1e-15);
  }
}

// Below the surface  m v' = b up - c v,  L' = -L;  errata 50: without another factor dt.
TEST(Step, LiftsAndDragsSubmergedBodies) {
  Model model;
  add_body(model, make_body(1.4, general_inertia(0.2, 0.3, 0.4)), {0.2, -30, 0.1}, {0.1, 0.2, 0.3},
           {0.5, -0.4, 0.2}, {0.4, 0.3, -0.7});
  Water water;
  water.buoyancy = 3, water.drag = 0.8, water.mode = WaterMode::step;
  model.forces.waters.push_back(water);
  const Real b = 0.8 / 1.4, t = 2;
  const Vector3 u = Vector3::UnitY() * (3 / 0.8), v0 = {0.5, -0.4, 0.2};
  for (const char* integrator : {"rk8", "yoshida6"}) {
    const Outcome end = run(model, integrator, t, 200);
    EXPECT_LT((end.motions[0].momentum / 1.4 - u - (v0 - u) * std::exp(-b * t)).norm(), 1e-11) << integrator;
    EXPECT_LT((end.motions[0].angular_momentum - std::exp(-t) * model.motions[0].angular_momentum).norm(),
              1e-11);
  }
  model.motions[0].position.y() = 30;  // negative control
  EXPECT_EQ(run(model, "rk8", t, 200).motions[0].momentum, model.motions[0].momentum);
}

TEST(Refused, RodInWater) {
  Model model = floating(Capsule{0, 0.3}, make_body(1, Matrix3::Identity()), {0, 0, 0}, 1000);
  EXPECT_NE(unsupported(model, with("rk4", 0.01)).find("rod"), std::string::npos);
}

}  // namespace
}  // namespace cylon::engine
