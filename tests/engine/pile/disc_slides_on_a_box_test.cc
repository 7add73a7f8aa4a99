// A cylinder that slid and turned on a locked box turned by 0.375 to 0.435 rad, without a limit as the step shrank; on a
// plane by 0.4005.  Which eight of its sixteen corners stayed changed from step to step, and where a corner was new, the
// loads of those that were not stayed as a pattern that turned the body: loads of more than three points are not unique.
#include "engine/geometry/hull.h"
#include "tests/engine/fixtures.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

struct Slide {
  Vector3 place;
  Real angle;
  bool told;  // that points were left out
};

Slide slide(const Shape& shape, bool on_box, bool first, Time dt) {
  Model model = pile_model(0, Real(0.3), !on_box);
  const auto add_floor = [&] {
    if (on_box)
      add_body(model, make_body(1, Matrix3::Identity(), true), Box{{5, Real(0.5), 5}},
               Vector3(0, Real(-0.5), 0));
  };
  if (!first) add_floor();
  const Matrix3 inertia = Vector3(Real(0.0043), Real(0.0065), Real(0.0043)).asDiagonal();
  add_body(model, make_body(Real(1.3), inertia), shape, Vector3(0, Real(0.05), 0),
           Vector3(Real(2.3), 0, Real(0.9)), Vector3(0, Real(1.3), 0));
  if (first) add_floor();
  const auto pile = make_pile(model, dt);
  const std::size_t body = on_box && !first ? 1 : 0;
  const Motion end = after(*pile, static_cast<int>(std::lround(0.4 / dt)))[body];
  const auto told = pile->diagnostics();
  return {end.position, 2 * std::atan2(end.orientation.y(), end.orientation.w()),
          std::ranges::any_of(told,
                              [](const Diagnostic& d) { return d.kind == DiagnosticKind::points_left_out; })};
}

Shape drum(int corners) {
  std::vector<Vector3> points;
  for (int k = 0; k < corners; ++k)
    for (const Real y : {Real(-0.05), Real(0.05)}) {
      const Real angle = 2 * std::acos(Real(-1)) * static_cast<Real>(k) / static_cast<Real>(corners);
      points.emplace_back(Real(0.1) * std::cos(angle), y, Real(0.1) * std::sin(angle));
    }
  return make_hull(points);
}

// Both go with the step to one motion, and are the same at each: the rounding that friction makes of a tilt is left.
TEST(DiscSlidesOnABox, AsOnAPlane) {
  for (const bool first : {true, false})
    for (const Shape& shape : {Shape(Frustum{Real(0.1), Real(0.1), Real(-0.05), Real(0.05)}),
                               Shape(Frustum{Real(0.1), 0, Real(-0.05), Real(0.15)})})
      for (const Time dt : {0.01, 0.005, 0.0025, 0.00125, 0.000625}) {
        const Slide box = slide(shape, true, first, dt), plane = slide(shape, false, first, dt);
        EXPECT_NEAR(box.angle, plane.angle, 1e-7) << dt << first;  // 4e-9 at most
        EXPECT_LT((box.place - plane.place).norm(), 1e-7) << dt << first;
        EXPECT_FALSE(box.told) << dt;
      }
}

TEST(DiscSlidesOnABox, ConvergesWithTheStep) {
  const Shape can = Frustum{Real(0.1), Real(0.1), Real(-0.05), Real(0.05)};
  const auto angle = [&](Time dt) { return slide(can, true, true, dt).angle; };
  const Real a = angle(0.01), b = angle(0.005), c = angle(0.0025), d = angle(0.00125);
  EXPECT_NEAR(std::log2((b - a) / (c - b)), 2, 0.15);
  EXPECT_NEAR(std::log2((c - b) / (d - c)), 2, 0.1);
}

// A face of twelve corners is narrower with eight, which is told; which eight does not change as it turns.
TEST(DiscSlidesOnABox, FaceOfTwelveCornersConverges) {
  for (const bool on_box : {true, false}) {
    const auto angle = [&](Time dt) {
      const Slide end = slide(drum(12), on_box, true, dt);
      EXPECT_TRUE(end.told);
      return end.angle;
    };
    const Real a = angle(0.01), b = angle(0.005), c = angle(0.0025), d = angle(0.00125);
    EXPECT_NEAR(std::log2((b - a) / (c - b)), 2, 0.15) << on_box << ' ' << a << ' ' << b << ' ' << c;
    EXPECT_NEAR(std::log2((c - b) / (d - c)), 2, 0.15) << on_box << ' ' << b << ' ' << c << ' ' << d;
  }
}

}  // namespace
}  // namespace cylon::engine
