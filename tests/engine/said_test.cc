// What a run does not keep, it says: iterations that end at their cap, a path that is not taken.
#include "tests/engine/fixtures.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

bool says(const std::vector<std::string>& remarks, const std::string& part) {
  return std::any_of(remarks.begin(), remarks.end(),
                     [&](const std::string& remark) { return remark.find(part) != std::string::npos; });
}

// A point on a rod of 1.3 m, as a constraint.
Model on_rod(Real speed) {
  Model model;
  model.bodies.push_back(make_body(2, Matrix3::Identity() / 10));
  model.motions.push_back(make_motion(model.bodies[0], {0.5, -1.2, 0}, Quaternion::Identity(),
                                      speed * Vector3(1.2, 0.5, 0) / 1.3, Vector3::Zero()));
  model.shapes.resize(1);
  model.surfaces = {no_surface};
  model.forces.gravity = {0, Real(-9.81), 0};
  Joint joint;
  joint.type.place = Joint::Place::at_length;
  joint.length = Real(1.3);
  model.joints.push_back(joint);
  model.reduce_joints = false;
  return model;
}

// In one step the point would go 30 m along the tangent; no impulse along the rod brings it back to 1.3 m.
TEST(Said, WhereShakeDoesNotCloseAJoint) {
  EXPECT_TRUE(says(run(on_rod(30), with("velocity-verlet", 1), 1).remarks, "did not close"));
  EXPECT_FALSE(says(run(on_rod(30), with("velocity-verlet", 1e-3), 200).remarks, "did not close"));
}

// A ball above a floor has contacts; the same ball without the floor has none, whatever path is asked for.
TEST(Said, WhereAPathIsNotTaken) {
  for (const char* path : {"events", "stepping"})
    for (const bool floor : {false, true}) {
      Model model = on_rod(1);
      model.joints.clear();
      model.shapes[0] = Sphere{Real(0.1)};
      model.surfaces = {0};
      model.surface_count = 2;
      model.materials.assign(4, Material{});
      if (floor) model.planes.push_back({Vector3::UnitY(), -3}), model.plane_surfaces.push_back(1);
      Options options = with("auto", 1e-2);
      options.path = path;
      EXPECT_EQ(says(run(model, options, 3).remarks, "not taken"), !floor) << path;
    }
}

Model touching_model(const Material& material) {
  Model model;
  model.surface_count = 2;
  model.materials.assign(4, material);
  model.forces.gravity = {0, Real(-9.81), 0};
  return model;
}

void add_shape(Model& model, const Shape& shape, const Vector3& p, const Vector3& v, bool locked = false) {
  const Body body = make_body(1, Matrix3::Identity() / 20, locked);
  model.bodies.push_back(body);
  model.motions.push_back(make_motion(
      body, p, Quaternion(Eigen::AngleAxis<Real>(Real(M_PI / 2), Vector3::UnitX())), v, Vector3::Zero()));
  model.shapes.push_back(shape);
  model.surfaces.push_back(0);
}

// Two capsules side by side have no face that could bound their distance; a box on a box has.
TEST(Said, WhereASearchForSurfacesThatMeetEnds) {
  const auto sliding = [](const Shape& shape, Real height) {
    Model model = touching_model({0, 0});
    add_shape(model, shape, Vector3::Zero(), Vector3::Zero(), true);
    add_shape(model, shape, {0, height, 0}, {0, 0, Real(0.2)});
    Options options = with("dop853", 5e-3);
    options.path = "events";
    return run(model, options, 40).remarks;
  };
  EXPECT_TRUE(says(sliding(Capsule{Real(0.2), Real(0.5)}, Real(0.4)), "reached their limit of work"));
  EXPECT_FALSE(says(sliding(Box{Vector3::Constant(Real(0.2))}, Real(0.4)), "reached their limit of work"));
}

// A blow runs back along a row of balls that touch, one ball in each round of impacts: 64 rounds are made.
TEST(Said, WhereRoundsOfImpactsEnd) {
  const auto row = [](int count) {
    Model model = touching_model({1, 0});
    model.forces.gravity.setZero();
    for (int i = 0; i < count; ++i)
      add_shape(model, Sphere{Real(0.5)}, {static_cast<Real>(i), 0, 0}, Vector3::Zero());
    add_shape(model, Sphere{Real(0.5)}, {static_cast<Real>(count) + Real(0.001), 0, 0}, {-1, 0, 0});
    Options options = with("auto", 1e-2);
    options.path = "stepping";
    return run(model, options, 2).remarks;
  };
  EXPECT_TRUE(says(row(100), "did not end in"));
  EXPECT_FALSE(says(row(20), "did not end in"));
}

}  // namespace
}  // namespace cylon::engine
