// A mechanism that touches a plane is the same motion at every size.  The rows of joints for lengths and for angles were
// solved in SI units together: of bodies of a micrometre or of a thousand kilometres, digits of one kind were lost, contacts
// chattered, and the allowed work was spent.
#include "tests/engine/joint_scenes.h"

namespace cylon::engine {
namespace {

// A body of a joint scene with the joint to the world, in units of `size` metres: it swings, slides or turns until it
// touches a plane.
Model sized(const JointKind& kind, Real size) {
  const JointScene scene = joint_scene(kind.type, true);
  Model model;
  const Body& body = scene.model.bodies[0];
  const Motion& motion = scene.model.motions[0];
  const Vector3 v = velocity(body, motion), w = angular_velocity(body, motion);
  model.bodies = {make_body(body.mass, body.inertia * size * size)};
  model.motions = {make_motion(model.bodies[0], motion.position * size, motion.orientation, v * size, w)};
  model.shapes = {Sphere{Real(0.2) * size}};
  model.surfaces = {0};
  Joint joint = scene.joint();
  joint.anchor *= size, joint.to_anchor *= size, joint.pitch *= size, joint.length *= size;
  model.joints = {joint};
  model.forces.gravity = size * Vector3(2, -9, 4);
  model.forces.drags.push_back({0, 1, Real(0.1) * size * size, 0});
  const Vector3 normal = -model.forces.gravity.normalized();
  model.planes = {{normal, normal.dot(motion.position) * size - Real(0.25) * size}};
  make_touchable(model, Real(0.3), Real(0.2));
  return model;
}

class SizeOfMechanism : public testing::TestWithParam<JointKind> {};

TEST_P(SizeOfMechanism, ChangesNothing) {
  const auto end = [](Real size) {
    World world(sized(GetParam(), size), with("auto", 0.02));
    for (int k = 0; k < 75; ++k) world.step();
    return std::tuple(Vector3(world.motions()[0].position / size), world.operations(), world.remarks());
  };
  const auto [place, work, remarks] = end(1);
  for (const Real size : {Real(1e-6), Real(1e-3), Real(1e6)}) {
    const auto [sized_place, sized_work, sized_remarks] = end(size);
    EXPECT_LT((sized_place - place).norm(), 1e-8) << size;
    EXPECT_LT(static_cast<double>(sized_work), 1.5 * static_cast<double>(work)) << size;
    EXPECT_EQ(sized_remarks.size(), remarks.size()) << size;
  }
}

INSTANTIATE_TEST_SUITE_P(All, SizeOfMechanism, testing::ValuesIn(joint_kinds),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace cylon::engine
