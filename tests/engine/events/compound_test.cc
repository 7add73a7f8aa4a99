// Compounds on planes, followed event by event.
#include "engine/contact/candidate.h"
#include "engine/plan.h"
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

Model on_floor(const Shape& shape, Real restitution, Real friction) {
  Model model;
  add_body(model, make_body(2, Vector3(0.1, 0.3, 0.35).asDiagonal()), {0.1, 0.7, -0.2}, {0.4, 0, 0.1},
           {0.3, 0.2, -0.8}, {0.2, 0.1, 0.4}, shape);
  model.forces.gravity = {0.3, -9.81, 0};
  model.planes = {Plane{{0, 1, 0}, 0}};
  model.plane_surfaces = {0};
  model.surfaces = {0};
  model.surface_count = 1;
  model.materials = {{restitution, friction}};
  return model;
}

ShapePart part(const Shape& shape, const Vector3& at) { return {shape, at, Matrix3::Identity()}; }

// Two halves have the corners of the whole, and so its motion: dropped, turning, bouncing, sliding.
TEST(EventCompound, TwoHalvesMoveAsTheWhole) {
  const Compound two = {{part(Box{{0.2, 0.2, 0.3}}, {-0.2, 0, 0}), part(Box{{0.2, 0.2, 0.3}}, {0.2, 0, 0})}};
  const Model whole = on_floor(Box{{0.4, 0.2, 0.3}}, 0.4, 0.3), halves = on_floor(two, 0.4, 0.3);
  EXPECT_EQ(find_candidates(halves).size(), 8u);
  const Motion a = run(whole, "auto", 0.6, 60).motions[0], b = run(halves, "auto", 0.6, 60).motions[0];
  EXPECT_NEAR((a.position - b.position).norm(), 0, 1e-8);
  EXPECT_GT((a.position - whole.motions[0].position).norm(), 0.3);
}

// A dumbbell on its two balls slides with a = g (sin - mu cos) / cos along the floor.
TEST(EventCompound, DumbbellSlidesOnTwoBalls) {
  const Compound dumbbell = {{part(Sphere{0.2}, {0.4, 0, 0}), part(Sphere{0.2}, {-0.4, 0, 0}),
                              part(Capsule{0.05, 0.4}, {0, 0.1, 0})}};
  Model model = on_floor(dumbbell, 0, 0.02);
  model.motions[0] =
      make_motion(model.bodies[0], {0, 0.2, 0}, Quaternion::Identity(), {0.5, 0, 0}, {0, 0, 0});
  const Plan plan = make_plan(model, Options{});
  EXPECT_EQ(plan.path, Path::events);
  const Motion end = run(model, "auto", 1, 50).motions[0];
  EXPECT_NEAR(end.position.x(), 0.5 + (0.3 - 0.02 * 9.81) / 2, 1e-9);
  EXPECT_NEAR(end.position.y(), 0.2, 1e-9);
}

}  // namespace
}  // namespace cylon::engine
