// The submerged part of a solid: against the whole of it, against the same solid upside down, and by columns.
#include "reference/applied/immersion.h"

#include "harness/core/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

namespace cylon::applied {
namespace {

using core::Quaternion;
using core::Vector3;

// A wedge-shaped notch makes it not convex.
const core::Mesh notched = {{{0, 0, 0},
                             {3, 0, 0},
                             {3, 2, 0},
                             {1.5, 0.6, 0},
                             {0, 2, 0},
                             {0, 0, 1},
                             {3, 0, 1},
                             {3, 2, 1},
                             {1.5, 0.6, 1},
                             {0, 2, 1}},
                            {{0, 3, 1},
                             {1, 3, 2},
                             {0, 4, 3},
                             {5, 6, 8},
                             {6, 7, 8},
                             {5, 8, 9},
                             {0, 1, 6},
                             {0, 6, 5},
                             {1, 2, 7},
                             {1, 7, 6},
                             {2, 3, 8},
                             {2, 8, 7},
                             {3, 4, 9},
                             {3, 9, 8},
                             {4, 0, 5},
                             {4, 5, 9}}};
const core::Hull hull = {
    {{0.3, 0.1, -0.4}, {-0.5, 0.2, 0.1}, {0.1, 0.7, 0.2}, {0.2, -0.6, 0.3}, {-0.1, 0.1, 0.8}}};

struct Row {
  const char* name;
  core::Shape shape;
};
const Row rows[] = {
    {"sphere", core::Sphere{0.45}},
    {"box", core::Box{{0.4, 0.3, 0.7}}},
    {"hull", hull},
    {"notched mesh", notched},
    {"capsule", core::Capsule{0.3, 0.8}},
    {"cylinder", core::Cylinder{0.4, 0.9}},
    {"cone", core::Cone{0.5, 1.1}},
    {"compound",
     core::Compound{
         {{core::Box{{0.2, 0.4, 0.3}}, 1, {0.5, 0.1, -0.2}, Quaternion(0.8, 0.1, -0.5, 0.3).normalized()},
          {core::Sphere{0.3}, 2, {-0.7, -0.3, 0.4}, Quaternion(1, 2, 3, 4).normalized()},
          {notched, 1, {0, 2, 0}, Quaternion(0.2, 0.7, 0.4, -0.1).normalized()}}}},
};

const Vector3 place(0.7, -1.3, 2.1);
const Quaternion turn = Quaternion(0.5, -0.3, 0.8, 0.2).normalized();

// Whole: volume and centre of the solid itself.
TEST(Immersion, DeepDownIsTheWhole) {
  for (const Row& row : rows) {
    const Immersion solid(row.shape);
    double volume = 0;
    Vector3 centre = Vector3::Zero();
    const auto add = [&](const core::Primitive& p, const Vector3& at, const Quaternion& q) {
      core::Solid s{};
      if (const auto* ball = std::get_if<core::Sphere>(&p))
        s.volume = 4 * M_PI / 3 * std::pow(ball->radius, 3);
      if (const auto* c = std::get_if<core::Capsule>(&p))
        s.volume = M_PI * c->radius * c->radius * (c->length + 4 * c->radius / 3);
      if (const auto* c = std::get_if<core::Cylinder>(&p))
        s.volume = M_PI * c->radius * c->radius * c->length;
      if (const auto* c = std::get_if<core::Cone>(&p))
        s.volume = M_PI / 3 * c->radius * c->radius * c->length;
      if (const auto* box = std::get_if<core::Box>(&p)) s.volume = 8 * box->half_extents.prod();
      if (const auto* of = std::get_if<core::Hull>(&p))
        s = core::solid(of->vertices, core::convex_hull(of->vertices));
      if (const auto* of = std::get_if<core::Mesh>(&p)) s = core::solid(of->vertices, of->faces);
      volume += s.volume, centre += s.volume * (at + q * s.centre);
    };
    std::visit(
        [&](const auto& s) {
          if constexpr (std::is_same_v<std::decay_t<decltype(s)>, core::Compound>)
            for (const core::Part& part : s.parts) add(part.shape, part.position, part.orientation);
          else
            add(s, Vector3::Zero(), Quaternion::Identity());
        },
        row.shape);
    const Submerged all = solid.below(50, place, turn);
    EXPECT_NEAR(solid.whole(), volume, 1e-14 * volume) << row.name;
    EXPECT_NEAR(all.volume, volume, 1e-12 * volume) << row.name;
    EXPECT_LE((all.centroid - (place + turn * (centre / volume))).norm(), 1e-12) << row.name;
    EXPECT_EQ(solid.below(-50, place, turn).volume, 0) << row.name;
  }
}

// What is below and, upside down, what was above make the whole; and dV/dh, the area of the cut, is never
// negative.
TEST(Immersion, BelowAndAboveMakeTheWhole) {
  const Quaternion over(Eigen::AngleAxisd(M_PI, Vector3::UnitX()));
  for (const Row& row : rows) {
    const Immersion solid(row.shape);
    const Submerged all = solid.below(50, place, turn);
    double before = 0;
    int cut = 0;
    for (double height = -5; height < 3; height += 0.13) {
      const Submerged below = solid.below(height, place, turn);
      const Submerged above = solid.below(-height, over * place, over * turn);
      EXPECT_NEAR(below.volume + above.volume, all.volume, 1e-12 * all.volume) << row.name << " " << height;
      EXPECT_LE((below.volume * below.centroid + above.volume * (over.conjugate() * above.centroid) -
                 all.volume * all.centroid)
                    .norm(),
                1e-12 * all.volume * 10)
          << row.name << " " << height;
      EXPECT_GE(below.volume, before - 1e-12) << row.name;
      before = below.volume;
      cut += below.volume > 0 && above.volume > 0 ? 1 : 0;
    }
    EXPECT_GE(cut, 5) << row.name;
  }
}

// Any tilt, nearly upright too, where the surface cuts the mantle alone.  At s* = height/rise on the axis:
//   cylinder  pi r^2 (l/2 + s*),   capsule  2/3 pi r^3 more,   cone  the whole less the tip, which is with k = r/l
//   pi k^2 D^3 / (3 (cos^2 t - k^2 sin^2 t)^(3/2)),   D the distance of its tip from the surface, t the tilt
TEST(Immersion, SolidsOfRevolutionNearlyUpright) {
  const double r = 0.4, l = 0.9, k = r / l;
  for (double tilt = 0.2; tilt > 1e-13; tilt /= 7)
    for (const double height : {-0.12, 0.0, 0.07}) {
      const Quaternion lean(Eigen::AngleAxisd(tilt, Vector3(0.6, 0, 0.8)));
      const auto volume = [&](const core::Shape& shape) {
        return Immersion(shape).below(height, Vector3::Zero(), lean).volume;
      };
      const double rise = std::cos(tilt), side = std::sin(tilt), cut = M_PI * r * r * (l / 2 + height / rise);
      EXPECT_NEAR(volume(core::Cylinder{r, l}), cut, 1e-14) << tilt << " " << height;
      EXPECT_NEAR(volume(core::Capsule{r, l}), cut + 2 * M_PI / 3 * r * r * r, 1e-14)
          << tilt << " " << height;
      const double distance = 0.75 * l * rise - height;
      const double tip =
          M_PI * k * k * std::pow(distance, 3) / (3 * std::pow(rise * rise - k * k * side * side, 1.5));
      EXPECT_NEAR(volume(core::Cone{r, l}), M_PI / 3 * r * r * l - tip, 1e-14) << tilt << " " << height;
    }
}

// Column by column along body y, tilted; half of it is not what the shape has that stands upright.
TEST(Immersion, TiltedShapesAgreeWithColumns) {
  struct Columns {
    const char* name;
    core::Shape shape;
    double width, depth;                                    // half, along x and z
    std::function<std::pair<double, double>(double)> ends;  // of a column at a distance from the axis
    std::function<bool(double)> has;
  };
  const auto always = [](double) { return true; };
  const Columns columns[] = {
      {"box", core::Box{{0.4, 0.3, 0.7}}, 0.4, 0.7, [](double) { return std::pair(-0.3, 0.3); }, always},
      {"cylinder", core::Cylinder{0.4, 0.9}, 0.4, 0.4, [](double) { return std::pair(-0.45, 0.45); },
       [](double r) { return r < 0.4; }},
      {"capsule", core::Capsule{0.3, 0.8}, 0.3, 0.3,
       [](double r) {
         const double h = 0.4 + std::sqrt(0.09 - r * r);
         return std::pair(-h, h);
       },
       [](double r) { return r < 0.3; }},
      {"cone", core::Cone{0.5, 1.1}, 0.5, 0.5,
       [](double r) { return std::pair(-0.275, 0.825 - 1.1 * r / 0.5); }, [](double r) { return r < 0.5; }},
  };
  const Vector3 up = turn.conjugate() * Vector3::UnitY();
  for (const Columns& row : columns) {
    const Immersion solid(row.shape);
    constexpr int n = 2000;
    double volume = 0;
    Vector3 moment = Vector3::Zero();
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const double x = row.width * ((2 * i + 1.0) / n - 1), z = row.depth * ((2 * k + 1.0) / n - 1);
        const double r = std::hypot(x, z);
        if (!row.has(r)) continue;
        const auto [bottom, top] = row.ends(r);
        const double cut = std::clamp((0.15 - up.x() * x - up.z() * z) / up.y(), bottom, top);
        const double low = up.y() > 0 ? bottom : cut, high = up.y() > 0 ? cut : top;
        const double v = (high - low) * 4 * row.width * row.depth / n / n;
        volume += v, moment += v * Vector3(x, (low + high) / 2, z);
      }
    const double height = place.y() + 0.15;
    const Submerged part = solid.below(height, place, turn);
    EXPECT_NEAR(part.volume, volume, 5e-5 * volume) << row.name;  // of columns at the rim
    EXPECT_LE((part.centroid - (place + turn * (moment / volume))).norm(), 5e-5) << row.name;
    EXPECT_GT(std::abs(solid.below(height, place, Quaternion::Identity()).volume - part.volume), 1e-3)
        << row.name;
  }
}

// Lying and standing, where the cut has a formula.
TEST(Immersion, RoundShapesAgreeWithFormulas) {
  const double r = 0.4, l = 0.9, d = 0.13;  // below the axis by -d
  const Quaternion lying(Eigen::AngleAxisd(M_PI / 2, Vector3(1, 0, 2).normalized()));
  const double segment = r * r * (M_PI / 2 + std::asin(d / r)) + d * std::sqrt(r * r - d * d);
  EXPECT_NEAR(Immersion(core::Cylinder{r, l}).below(d, Vector3::Zero(), lying).volume, l * segment, 1e-13);
  const double cap = M_PI * (r + d) * (r + d) * (2 * r - d) / 3;
  EXPECT_NEAR(Immersion(core::Capsule{r, l}).below(d, Vector3::Zero(), lying).volume, l * segment + cap,
              1e-13);
  const Immersion cone(core::Cone{r, l});
  const double tip = (0.75 * l - d) / l;  // what is dry of it, similar to the whole
  const double whole = M_PI / 3 * r * r * l;
  EXPECT_NEAR(cone.below(d, Vector3::Zero(), Quaternion::Identity()).volume, whole * (1 - tip * tip * tip),
              1e-14);
  const Quaternion over(Eigen::AngleAxisd(M_PI, Vector3::UnitX()));
  EXPECT_NEAR(cone.below(-d, Vector3::Zero(), over).volume, whole * tip * tip * tip, 1e-14);
}

TEST(Immersion, RefusesShapesWithoutAFormula) {
  const struct {
    core::Shape shape;
    const char* reason;
  } refused[] = {
      {core::Rod{0.4}, "no volume"},
      {core::Disc{0.4}, "no volume"},
      {core::Hull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, "no volume"},
      {core::Mesh{notched.vertices, {{0, 3, 1}}}, "not closed"},
      {core::Compound{{{core::Sphere{0.2}, 1, {}, Quaternion::Identity()},
                       {core::Rod{0.2}, 1, {}, Quaternion::Identity()}}},
       "a rod"},
  };
  for (const auto& row : refused) {
    const auto reason = Immersion::unmapped(row.shape);
    ASSERT_TRUE(reason) << row.reason;
    EXPECT_NE(reason->find(row.reason), std::string::npos) << *reason;
  }
  for (const Row& row : rows) EXPECT_FALSE(Immersion::unmapped(row.shape)) << row.name;
  EXPECT_FALSE(Immersion::unmapped(core::Shape()));
  EXPECT_EQ(Immersion(core::Shape()).below(9, place, turn).volume, 0);
}

}  // namespace
}  // namespace cylon::applied
