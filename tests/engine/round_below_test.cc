// Cylinders, cones and capsules under water, which were refused: what they displace against exact cases, against polytopes
// that come nearer with order 2, and by the energy of a cone that bobs and rolls.
#include "tests/engine/fixtures.h"

#include "engine/round_below.h"

#include <numbers>

namespace cylon::engine {
namespace {

constexpr Real pi = std::numbers::pi;

const Frustum can{0.35, 0.35, -0.4, 0.4}, cone{0.4, 0, -0.2, 0.6}, cup{0.2, 0.45, -0.3, 0.5};
const Capsule pill{0.25, 0.35};
const Shape round_shapes[] = {can, cone, cup, pill};

// Rings about y, of corners on the surface: radius and height of each; a radius of 0 is a point.
Hull revolved(const std::vector<std::array<Real, 2>>& rings, int n) {
  Hull hull;
  std::vector<std::vector<int>> corners;
  for (const auto& [radius, y] : rings) {
    corners.emplace_back();
    for (int k = 0; k < (radius > 0 ? n : 1); ++k) {
      const Real angle = 2 * pi * k / n;
      corners.back().push_back(static_cast<int>(hull.vertices.size()));
      hull.vertices.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
    }
  }
  const auto corner = [&](std::size_t ring, int k) {
    const auto& all = corners[ring];
    return all[static_cast<std::size_t>(k) % all.size()];
  };
  for (std::size_t i = 0; i + 1 < rings.size(); ++i)
    for (int k = 0; k < n; ++k) {
      std::vector<int> face = {corner(i, k), corner(i + 1, k)};
      if (corners[i + 1].size() > 1) face.push_back(corner(i + 1, k + 1));
      if (corners[i].size() > 1) face.push_back(corner(i, k + 1));
      hull.faces.push_back(face);
    }
  if (corners.front().size() > 1) hull.faces.push_back(corners.front());
  if (corners.back().size() > 1) hull.faces.emplace_back(corners.back().rbegin(), corners.back().rend());
  return hull;
}

Hull polytope(const Shape& shape, int n) {
  if (const auto* f = std::get_if<Frustum>(&shape))
    return revolved({{f->low_radius, f->low}, {f->high_radius, f->high}}, n);
  const auto& s = std::get<Capsule>(shape);
  std::vector<std::array<Real, 2>> rings;
  for (const int side : {-1, 1})
    for (int k = 0; k <= n / 4; ++k) {
      const Real angle = pi / 2 * (side < 0 ? k - n / 4 : k) / (n / 4);
      const bool pole = k == (side < 0 ? 0 : n / 4);
      rings.push_back(
          {pole ? 0 : s.radius * std::cos(angle), side * s.half_length + s.radius * std::sin(angle)});
    }
  return revolved(rings, n);
}

// The polytope's volume and moment go to those of the shape as 1/n^2, for any orientation and depth.
TEST(RoundBelow, IsTheLimitOfPolytopes) {
  const Vector3 position = {0.3, 0.7, -0.4};
  for (const Shape& shape : round_shapes)
    for (const Vector3& turn :
         {Vector3(0.5, -0.8, 0.3), Vector3(1.6, 0.2, 0.4), Vector3(2.6, 0.1, -0.7), Vector3(0, 0.3, 0)})
      for (const Real depth : {-0.31, -0.1, 0.07, 0.26}) {
        const Matrix3 r = exponential(turn).toRotationMatrix();
        const Submerged part = submerged(shape, position, r, position.y() + depth);
        const auto error = [&](int n) -> Eigen::Vector4d {
          const Submerged of = submerged(polytope(shape, n), position, r, position.y() + depth);
          return Eigen::Vector4d(of.volume - part.volume, 0, 0, 0) +
                 (Eigen::Vector4d() << 0,
                  of.volume * (of.centroid - position) - part.volume * (part.centroid - position))
                     .finished();
        };
        // Extrapolated from two, with the next order of the error left: by 7e-7 at most.
        const Eigen::Vector4d a = error(64), b = error(128), c = error(256);
        EXPECT_LT((4 * c - b).norm() / 3, 2e-6) << shape.index() << ' ' << turn.transpose() << ' ' << depth;
        if (part.volume == 0) continue;  // above the water
        EXPECT_NEAR(std::log2(a.norm() / c.norm()) / 2, 2, 0.1)
            << shape.index() << ' ' << turn.transpose() << ' ' << depth;
      }
}

TEST(RoundBelow, KnownPlacesAreExact) {
  const Vector3 up = {0, 1, 0}, down = {0, -1, 0}, across = {0.6, 0, 0.8};
  const Real r = 0.35, l = 0.8, d = 0.13;
  // Upright, d of it below:  pi r^2 d at d/2 over the lower end.
  for (const Vector3& axis : {up, down}) {
    const RoundBelow part = round_below(can, axis, d - 0.4);
    EXPECT_NEAR(part.volume, pi * r * r * d, 1e-15);
    EXPECT_LT((part.moment - part.volume * Vector3(0, d / 2 - 0.4, 0)).norm(), 1e-15);
  }
  // Lying, the centre d above the surface:  (r^2 acos(d/r) - d sqrt(r^2 - d^2)) l, at 2/3 (r^2 - d^2)^(3/2) of its area.
  const Real half = std::sqrt(r * r - d * d), area = r * r * std::acos(d / r) - d * half;
  const RoundBelow lying = round_below(can, across, -d);
  EXPECT_NEAR(lying.volume, area * l, 1e-15);
  EXPECT_LT((lying.moment - Vector3(0, -2. / 3 * half * half * half * l, 0)).norm(), 1e-15);
  // A tip down: a cone of height d like the whole one; lying, half of it is below its axis.
  const RoundBelow tip = round_below(cone, down, d - 0.6);
  EXPECT_NEAR(tip.volume, pi * 0.25 * d * d * d / 3, 1e-15);
  EXPECT_LT((tip.moment - tip.volume * Vector3(0, 0.75 * d - 0.6, 0)).norm(), 1e-15);
  EXPECT_NEAR(round_below(cone, across, 0).volume, pi * 0.16 * 0.8 / 6, 1e-15);
  // A capsule without a middle is a ball, however it lies; an upright one begins with a cap.
  for (const Vector3& axis : {up, across, Vector3(Vector3(0.3, 0.8, -0.2).normalized())})
    for (const Real height : {-0.2, -0.04, 0.0, 0.11, 0.24}) {
      const RoundBelow ball = round_below(Capsule{0.25, 0}, axis, height);
      const Submerged cap = submerged(Sphere{0.25}, Vector3::Zero(), Matrix3::Identity(), height);
      EXPECT_NEAR(ball.volume, cap.volume, 1e-15);
      EXPECT_LT((ball.moment - cap.volume * cap.centroid).norm(), 1e-15);
    }
  const Submerged cap = submerged(Sphere{0.25}, {0, -0.35, 0}, Matrix3::Identity(), -0.45);
  EXPECT_NEAR(round_below(pill, up, -0.45).volume, cap.volume, 1e-15);
  EXPECT_NEAR(round_below(pill, across, 0).volume, whole_volume(pill) / 2, 1e-15);
}

// What is below and what is above are the whole, whatever is cut: near the rims, near the tip, nearly upright, lying.
TEST(RoundBelow, BothSidesAreTheWhole) {
  for (const Shape& shape : round_shapes)
    for (const Real angle : {0.0, 1e-12, 1e-7, 0.01, 0.463647609, 0.7, 1.2, 1.5707963267948966, 2.1, 3.1415})
      for (const Real depth : {-0.399999, -0.2, -1e-9, 0.0, 1e-4, 0.05, 0.3, 0.45, 0.5999999}) {
        std::visit(
            [&](const auto& s) {
              if constexpr (requires { round_below(s, Vector3(), Real()); }) {
                const Vector3 axis(0.6 * std::sin(angle), std::cos(angle), 0.8 * std::sin(angle));
                const RoundBelow low = round_below(s, axis, depth), all = round_below(s, axis, 9);
                const RoundBelow high = round_below(s, Vector3(-axis), -depth);  // upside down
                EXPECT_NEAR(low.volume + high.volume, all.volume, 4e-15)
                    << shape.index() << ' ' << angle << ' ' << depth;
                EXPECT_LT((low.moment - high.moment - all.moment).norm(), 4e-15)
                    << shape.index() << ' ' << angle << ' ' << depth;
              }
            },
            shape);
      }
}

Model afloat(const Shape& shape, const Body& body, const Quaternion& turn) {
  Model model;
  add_body(model, body, {0.2, 0.45, 0.1}, {0.1, 0.2, -0.1}, {0.3, -0.2, 0.4}, {0, 0, 0}, shape);
  model.motions[0] = make_motion(body, {0.2, 0.45, 0.1}, turn, {0.1, 0.2, -0.1}, {0.3, -0.2, 0.4});
  model.forces.gravity = {0, -9.81, 0};
  Water water;
  water.level = 0.5, water.buoyancy = 1000, water.shapes = {shape};
  model.forces.waters.push_back(water);
  return model;
}

// E = K + m g y + density g V_sub (level - y of its centroid): the water that it displaces is lifted to the surface.
double energy(const Model& model, const Motion& m) {
  const Body& body = model.bodies[0];
  const Water& water = model.forces.waters[0];
  const Submerged part =
      submerged(water.shapes[0], m.position, m.orientation.toRotationMatrix(), water.level);
  return m.momentum.squaredNorm() / (2 * body.mass) + m.angular_momentum.dot(angular_velocity(body, m)) / 2 +
         9.81 * body.mass * m.position.y() +
         water.buoyancy * 9.81 * part.volume * (water.level - part.centroid.y());
}

TEST(RoundBelow, BobbingBodiesKeepTheirEnergy) {
  const Shape two = Compound{{{can, {0.1, -0.3, 0}, exponential({0.4, 0, 0.9}).toRotationMatrix()},
                              {pill, {-0.2, 0.4, 0.3}, exponential({1.4, 0.3, 0}).toRotationMatrix()}}};
  for (const Shape& shape : {Shape(can), Shape(cone), Shape(pill), two}) {
    const Real mass = 500 * submerged(shape, {0, 0, 0}, Matrix3::Identity(), 9).whole;
    const Body body = make_body(mass, mass * Vector3(0.06, 0.05, 0.065).asDiagonal().toDenseMatrix());
    const Model model = afloat(shape, body, exponential({0.7, 0.3, -0.5}));
    EXPECT_EQ(unsupported(model, with("rk8", 0.01)), "");
    const double start = energy(model, model.motions[0]);
    const auto drift = [&](int steps) {
      return std::abs(energy(model, run(model, "rk8", 2, steps).motions[0]) - start) / (mass * 9.81);
    };
    // Of the height [m]; the lift has roots in it where rims go under, which is what is left.
    EXPECT_LT(drift(2000), 1e-9) << shape.index();
    EXPECT_GT(drift(20), drift(2000)) << shape.index();
  }
}

// A cylinder of length l that stands bobs harmonically while the surface cuts its side:  w^2 = density pi r^2 g/m.
TEST(RoundBelow, UprightCylinderBobsHarmonically) {
  const Real mass = 0.6 * 1000 * whole_volume(can), rest = 0.5 + 0.4 - 0.6 * 0.8;
  const Body body = make_body(mass, mass * Vector3(0.06, 0.05, 0.06).asDiagonal().toDenseMatrix());
  Model model = afloat(can, body, Quaternion::Identity());
  model.motions[0] = make_motion(body, {0.2, rest + 0.1, 0.1}, Quaternion::Identity(), {0, 0, 0}, {0, 0, 0});
  const Real w = std::sqrt(1000 * pi * 0.35 * 0.35 * 9.81 / mass), t = 1.7;
  EXPECT_NEAR(run(model, "rk8", t, 340).motions[0].position.y(), rest + 0.1 * std::cos(w * t), 1e-12);
}

}  // namespace
}  // namespace cylon::engine
