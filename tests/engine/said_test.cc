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

}  // namespace
}  // namespace cylon::engine
