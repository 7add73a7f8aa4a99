// Every reason for which an adapter refuses a scene, provoked once: an honest sentence instead of an
// approximation.
#include "tests/conformance/adapters_refused_scenes.h"
#include "tests/paths.h"

#include <functional>

namespace cylon::conformance {
namespace {

struct Refusal {
  const char* engine;
  const char* reason;  // a part of it
  core::Scene scene;
};

std::vector<Refusal> refusals() {
  const core::Scene unstated = with(resting(), [](core::Scene& s) { s.materials.clear(); });
  const core::Scene half_stated = with(resting(), [](core::Scene& s) {  // two planes, a material for one
    s.planes.push_back({"wall", Vector3::UnitZ(), -60});
  });
  const core::Scene two_hinges = with(jointed(core::JointType::hinge, 0, core::world),
                                      [](core::Scene& s) { s.joints.push_back(s.joints[0]); });
  const core::Hull hull = {tetrahedron.vertices};
  return {
      {"in-house/integrator=bm4", "bm4 cannot integrate joints", jointed(core::JointType::ball, 0, 1)},
      {"in-house-float", "'a' is 1e+07 m from the origin, where single precision knows distances to 0.134 m",
       with(resting(), [](core::Scene& s) { s.bodies[0].initial.position.x() = 1e7; })},
      {"in-house", "'floor' is 1e+16 m from the origin, where double precision knows distances to 1 m",
       with(resting(), [](core::Scene& s) { s.planes[0].offset = -1e16; })},
      {"in-house", "body 'a' may touch, but is a disc", resting(core::Disc{0.3})},
      {"in-house-float", "body 'a' may touch, but is a compound with a disc",
       resting(compound_of(core::Disc{0.1}))},
      {"in-house", "a moving mesh that is not convex", resting(dented)},
      {"in-house/path=events", "cylinders and cones that touch", resting(core::Cylinder{0.1, 0.3})},
      {"in-house", "'a' and 'floor' may touch, but the scene has no material", unstated},
      {"in-house", "'a' and 'wall' may touch, but the scene has no material", half_stated},

      {"bullet", "Body 'b' in water: a rod has no volume.", in_water(core::Rod{0.3})},
      {"bullet-multibody", "Body 'b' in water: a disc has no volume.", in_water(core::Disc{0.3})},
      {"bullet-float", "Body 'b' in water: a disc", in_water(compound_of(core::Disc{0.3}))},
      {"bullet", "Body 'a': Bullet has no shape of a disc without thickness", resting(core::Disc{0.2})},
      {"bullet-float", "Body 'a': Bullet has no shape of a disc", resting(compound_of(core::Disc{0.2}))},
      {"bullet", "Body 'a': This adapter maps no moving mesh: it needs btGImpactMeshShape",
       resting(tetrahedron)},
      {"bullet", "Bullet has no joint that keeps a distance", jointed(core::JointType::distance, 0, 1)},
      {"bullet", "Bullet stops an angle on both sides or on none",
       jointed(core::JointType::hinge, 0, core::world, {.lower = -1})},
      {"bullet-float", "Bullet's stops of an angle lie within half a turn",
       jointed(core::JointType::hinge, 0, 1, {.lower = -1, .upper = 3.2})},
      {"bullet", "pushes each of two moving bodies at its own point",
       jointed(core::JointType::planar, 0, 1, {})},
      {"bullet-float/path=as-shipped", "Bullet's slider between two moving bodies does not bounce",
       jointed(core::JointType::slider, 0, 1, {.lower = -1, .restitution = 0.5})},
      {"bullet-multibody", "btMultiBody's limits have no restitution",
       jointed(core::JointType::slider, 0, core::world, {.lower = -1, .restitution = 0.5})},
      {"bullet-multibody-float", "btMultiBody has no joint of these two freedoms",
       jointed(core::JointType::universal, 0, 1, {})},
      {"bullet-multibody", "btMultiBody's limits and motors are of joints with one freedom",
       jointed(core::JointType::planar, 0, core::world, {.friction = 1})},
      {"bullet", "A pair that may touch has no material.", unstated},
      {"bullet-float", "A pair that may touch has no material.", half_stated},
      {"bullet-multibody", "btMultiBody has no hinge constraint that closes a loop", two_hinges},
      {"bullet-multibody-float", "and this adapter makes none of two balls", two_hinges},
      // Which bodies the rule takes follows from the scene: an option that they lack is no mistake of the run.
      {"bullet/path=as-expert,ccd=0.9", "option ccd belongs to btRigidBody",
       jointed(core::JointType::ball, 0, core::world)},
      {"bullet/path=as-expert,gyro=implicit-body", "btMultiBody has explicit, none",
       jointed(core::JointType::ball, 0, core::world)},
      {"bullet/path=as-expert,damping=0.1", "option damping belongs to btMultiBody", resting()},
      {"bullet/path=as-expert,integrator=semi-implicit-euler", "takes runge-kutta-4 here",
       jointed(core::JointType::ball, 0, core::world)},
      {"bullet-float/path=as-expert,integrator=runge-kutta-4", "takes semi-implicit-euler here", resting()},
      {"bullet/integrator=runge-kutta-4", "btRigidBody has semi-implicit Euler alone", resting()},
      {"ode/path=as-expert,iterations=50", "option iterations belongs to dWorldQuickStep", resting()},

      {"ode", "Body 'b' in water: a rod has no volume.", in_water(core::Rod{0.3})},
      {"ode-quick", "Body 'b' in water: a disc has no volume.", in_water(core::Disc{0.3})},
      {"ode", "ODE needs a mass above zero of what moves; 'a' has 0 kg.",
       with(three_bodies(85), [](core::Scene& s) { s.bodies[0].mass = 0; })},
      {"ode", "ODE needs principal moments above zero of what moves; 'b' has one of 0 kg m^2.",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0, 0.2).asDiagonal(); })},
      {"ode", "ODE's ball has no limits and no friction",
       jointed(core::JointType::gimbal, 0, 1, {.upper = 0.5})},
      {"ode-quick", "as long as the sine of the angle between them",
       jointed(core::JointType::gimbal, 1, core::world, {.friction = 0.3})},
      {"ode-quick", "the joint of 'a' has one at 3.2 rad from its start.",
       jointed(core::JointType::universal, 0, 1, {.upper = 3.2})},
      {"ode",
       "ODE's stops of an angle lie within half a turn (ode/src/joints/joint.cpp, dxJointLimitMotor::set); "
       "the "
       "joint of 'a' has one at 3.5 rad from its start.",
       jointed(core::JointType::hinge, 0, core::world, {.start = -0.5, .upper = 3})},
      {"ode-quick", "the joint of 'b' has one at -4 rad from its start.",
       jointed(core::JointType::hinge, 1, 0, {.lower = -4})},
      {"ode", "Body 'a': ODE has no cone (ode/collision.h:877).", resting(core::Cone{0.1, 0.3})},
      {"ode", "ODE has no solid without thickness, such as a rod", resting(core::Rod{0.3})},
      {"ode", "ODE has no solid without thickness, such as a disc", resting(core::Disc{0.3})},
      {"ode", "this adapter maps no hull", resting(hull)},
      {"ode", "ODE collides a mesh as a surface, not as a solid", resting(tetrahedron)},
      {"ode-quick", "ODE has no cone", resting(compound_of(core::Cone{0.1, 0.3}))},
      {"mujoco", "The joint of 'a' bounces from its limits, and MuJoCo has no coefficient of restitution",
       jointed(core::JointType::slider, 0, core::world, {.lower = -0.3, .restitution = 0.2})},
      {"mujoco", "The cylindrical joint of 'a' closes a loop, which this adapter closes by",
       with(jointed(core::JointType::cylindrical, 0, core::world, {.force = 0.3}),
            [](core::Scene& s) { s.joints.push_back(s.joints[0]); })},
      {"mujoco", "The hinge joint of 'a' closes a loop, which this adapter closes by",
       with(jointed(core::JointType::hinge, 0, core::world, {.friction = 0.3}),
            [](core::Scene& s) { s.joints.push_back(s.joints[0]); })},
      {"mujoco",
       "The planar joint of 'b' hangs 'a' from it, and MuJoCo's displacements are of the parent's axes.",
       with(jointed(core::JointType::planar, 1, 0, {.stiffness = 3}),
            [](core::Scene& s) {
              s.joints.push_back({.type = core::JointType::ball, .body = 1, .point = {1, 2, 3}});
            })},
      {"mujoco", "'a' and 'floor' bounce by 0.4, and MuJoCo has no coefficient of restitution", resting()},
      {"mujoco", "'a' may touch 'floor', but the scene has no material", unstated},
      {"mujoco", "'a' may touch 'wall', but the scene has no material", half_stated},
      {"mujoco", "Body 'a': MuJoCo has no cone (mujoco/mjmodel.h:88).", soft(core::Cone{0.1, 0.3})},
      {"mujoco", "MuJoCo has no solid without thickness, such as a rod", soft(core::Rod{0.3})},
      {"mujoco", "MuJoCo has no solid without thickness, such as a disc", soft(core::Disc{0.3})},
      {"mujoco", "MuJoCo has no cone", soft(compound_of(core::Cone{0.1, 0.3}))},
      {"mujoco", "MuJoCo collides the convex hull of a mesh", soft(tetrahedron)},
      {"mujoco", "MuJoCo needs four vertices", soft(core::Hull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}})},
      {"mujoco", "MuJoCo needs a mass of at least 1e-15 kg; 'a' has 1e-16 kg.",
       with(three_bodies(85), [](core::Scene& s) { s.bodies[0].mass = 1e-16; })},
      {"mujoco", "MuJoCo needs principal moments of at least 1e-15 kg m^2; 'b' has one of 0 kg m^2.",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0, 0.2).asDiagonal(); })},
      {"mujoco", "MuJoCo needs principal moments A + B >= C; 'b' has 0.2, 0.3 and 0.51 kg m^2.",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0.3, 0.51).asDiagonal(); })},
      {"mujoco", "MuJoCo resets what is beyond 1e+10 in a coordinate; 'c' starts there.",
       with(three_bodies(86), [](core::Scene& s) { s.bodies[2].initial.velocity.y() = -2e10; })},
      {"mujoco", "Body 'b' in water: a rod has no volume.", in_water(core::Rod{0.3})},
      {"mujoco", "at most 90 bodies that hang from each other; 'link90' is deeper", chain(91)},
      {"mujoco", "MuJoCo allocates room for all constraints before it starts", crowd(4000)},
      {"simbody", "'a' and 'floor' may touch, and a contact of Simbody is compliant", resting()},
      {"simbody", "'a' and 'floor' may touch", soft(core::Sphere{0.2})},
      {"simbody", "Simbody needs a mass above zero of what moves; 'a' has 0 kg.",
       with(three_bodies(85), [](core::Scene& s) { s.bodies[0].mass = 0; })},
      {"simbody", "Simbody needs principal moments above zero of what moves; 'b' has one of 0 kg m^2.",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0, 0.2).asDiagonal(); })},
      {"simbody", "Simbody needs principal moments A + B >= C; 'b' has 0.2, 0.3 and 0.51 kg m^2.",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0.3, 0.51).asDiagonal(); })},
      {"simbody", "Simbody's rod has a length above zero",
       with(jointed(core::JointType::distance, 0, 1), [](core::Scene& s) { s.joints[0].length = 0; })},
      {"simbody", "Body 'b' in water: a rod has no volume.", in_water(core::Rod{0.3})},
      {"dart", "'a' may touch 'floor', but the scene has no material", unstated},
      {"dart", "'a' may touch 'wall', but the scene has no material", half_stated},
      {"dart", "Body 'a': DART's own detector collides spheres and boxes alone",
       soft(core::Capsule{0.1, 0.3})},
      {"dart", "Body 'a': DART's own detector collides spheres and boxes alone", soft(hull)},
      {"dart", "Body 'a': DART's own detector collides spheres and boxes alone",
       soft(compound_of(core::Cylinder{0.1, 0.3}))},
      {"dart", "DART has no constraint that keeps a distance, such as that of 'a'",
       jointed(core::JointType::distance, 0, 1)},
      {"dart", "The hinge of 'a' closes a loop, for which DART has a ball and a weld alone", two_hinges},
      {"dart", "The joint of 'a' bounces from its limits, and DART has no restitution there",
       jointed(core::JointType::slider, 0, 1, {.lower = -1, .restitution = 0.5})},
      {"dart", "The gimbal of 'a' closes a loop, and DART's ball for that has no limits and no friction",
       with(jointed(core::JointType::gimbal, 0, core::world, {.friction = 0.3}),
            [](core::Scene& s) {
              s.joints.insert(s.joints.begin(), {.type = core::JointType::fixed, .body = 0});
            })},
      {"dart", "DART takes a friction of at most 0.001 for none",
       with(soft(core::Sphere{0.2}), [](core::Scene& s) { s.materials[0].friction = 1e-3; })},
      {"dart", "DART takes a restitution of at most 0.001 for none",
       with(resting(), [](core::Scene& s) { s.materials[0].restitution = 5e-4; })},
      {"dart", "DART needs a mass above zero of what moves; 'a' has 0 kg.",
       with(three_bodies(85), [](core::Scene& s) { s.bodies[0].mass = 0; })},
      {"dart", "DART needs principal moments above zero of what moves; 'b' has one of 0 kg m^2.",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0, 0.2).asDiagonal(); })},
      {"dart", "Body 'b' in water: a rod has no volume.", in_water(core::Rod{0.3})},
      {"siconos", "'a' may touch 'floor', but the scene has no material", unstated},
      {"siconos", "Body 'a': the kernel of Siconos has no shapes", soft(core::Box{{0.1, 0.2, 0.3}})},
      {"siconos", "Body 'a': the kernel of Siconos has no shapes", soft(compound_of(core::Sphere{0.1}))},
      {"siconos", "Siconos has joints in its library of mechanics alone, which this adapter leaves out",
       jointed(core::JointType::ball, 0, core::world)},
      {"siconos", "Siconos needs a mass above zero of what moves; 'a' has 0 kg.",
       with(three_bodies(85), [](core::Scene& s) { s.bodies[0].mass = 0; })},
      {"siconos", "Siconos needs principal moments above zero of what moves; 'b' has one of 0 kg m^2.",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0, 0.2).asDiagonal(); })},
      {"siconos", "Body 'b' in water: a rod has no volume.", in_water(core::Rod{0.3})},
      {"cannon-es", "cannon-es has no gyroscopic torque, and 'a' starts with one of", three_bodies(87)},
      {"cannon-es/gyroscopic-torque=left-out", "cannon-es has no Coulomb friction",
       with(soft(core::Sphere{0.2}), [](core::Scene& s) { s.materials[0].friction = 0.3; })},
      {"cannon-es/path=stand-in", "'a' may touch 'wall', but the scene has no material", half_stated},
      {"cannon-es/path=stand-in", "Body 'a': cannon-es has no disc.", soft(core::Disc{0.3})},
      {"cannon-es/path=stand-in", "Body 'a': cannon-es has no capsule.", soft(core::Capsule{0.1, 0.3})},
      {"cannon-es/path=stand-in", "Body 'a': cannon-es has no cylinder but a prism.",
       soft(core::Cylinder{0.1, 0.3})},
      {"cannon-es/path=stand-in", "cannon-es collides a mesh with spheres and planes alone",
       soft(tetrahedron)},
      {"cannon-es/path=stand-in", "cannon-es needs principal moments above zero",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0, 0.2).asDiagonal(); })},
      {"mujoco3", "The slider joint of 'a' bounces from its limits by 0.2, and MuJoCo has no restitution of",
       jointed(core::JointType::slider, 0, core::world, {.lower = -0.3, .restitution = 0.2})},
      {"mujoco3", "The cylindrical joint of 'a' closes a loop, which this adapter closes by",
       with(jointed(core::JointType::cylindrical, 0, core::world, {.force = 0.3}),
            [](core::Scene& s) { s.joints.push_back(s.joints[0]); })},
      {"mujoco3", "The hinge joint of 'a' closes a loop, which this adapter closes by",
       with(jointed(core::JointType::hinge, 0, core::world, {.friction = 0.3}),
            [](core::Scene& s) { s.joints.push_back(s.joints[0]); })},
      {"mujoco3", "The planar joint of 'b' hangs 'a' from it, and MuJoCo's displacements are of",
       with(jointed(core::JointType::planar, 1, 0, {.stiffness = 3}),
            [](core::Scene& s) {
              s.joints.push_back({.type = core::JointType::ball, .body = 1, .point = {1, 2, 3}});
            })},
      {"mujoco3", "MuJoCo has no coefficient of restitution", resting()},
      {"mujoco3", "'a' may touch 'floor', but the scene has no material", unstated},
      {"mujoco3", "Body 'a': MuJoCo has no cone", soft(core::Cone{0.1, 0.3})},
      {"mujoco3", "MuJoCo collides the convex hull of a mesh", soft(tetrahedron)},
      {"mujoco3", "MuJoCo needs four vertices", soft(core::Hull{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}})},
      {"mujoco3", "MuJoCo needs a mass of at least 1e-15 kg; 'a' has 1e-16 kg.",
       with(three_bodies(85), [](core::Scene& s) { s.bodies[0].mass = 1e-16; })},
      {"mujoco3", "MuJoCo needs principal moments A + B >= C; 'b' has 0.2, 0.3, 0.51 kg m^2.",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0.3, 0.51).asDiagonal(); })},
      {"mujoco3", "at most 90 bodies that hang from each other; 'link90' is deeper", chain(91)},
      {"jolt", "'a' may touch 'floor', but the scene has no material", unstated},
      {"jolt",
       "The hinge joint of 'a' bounces from its limits by 0.5, and Jolt has no restitution of limits.",
       jointed(core::JointType::hinge, 0, 1, {.lower = -1, .upper = 1, .restitution = 0.5})},
      {"jolt", "The hinge joint of 'a' has no limit within half a turn on one side",
       jointed(core::JointType::hinge, 0, 1, {.lower = -1})},
      {"physx", "The hinge joint of 'b' has no limit within half a turn on one side",
       jointed(core::JointType::hinge, 1, core::world, {.lower = -1, .upper = 3.2})},
      {"crashcat", "The universal joint of 'a' has limits, which this adapter gives crashcat for hinge and",
       jointed(core::JointType::universal, 0, 1, {.upper = 0.5})},
      {"rapier", "The cylindrical joint of 'a' has dry friction, which this adapter gives Rapier for hinge",
       jointed(core::JointType::cylindrical, 0, 1, {.friction = 0.5})},
      {"rapier", "'a' may touch 'wall', but the scene has no material", half_stated},
      {"jolt", "Jolt has no solid without thickness, such as a disc", soft(core::Disc{0.3})},
      {"jolt", "Jolt has no solid without thickness, such as a rod", soft(compound_of(core::Rod{0.3}))},
      {"jolt", "Jolt collides a mesh only where it does not move", soft(tetrahedron)},
      {"jolt", "Jolt makes no shape of it", soft(core::Hull{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}})},
      {"jolt", "Jolt needs a mass above zero that float precision holds; 'a' has 1e-46 kg.",
       with(three_bodies(85), [](core::Scene& s) { s.bodies[0].mass = 1e-46; })},
      {"jolt", "Jolt's allocator in this build has room for 20000 contact manifolds", gas(4000)},
      {"jolt", "needs the submerged part of a shape", in_water(core::Sphere{0.3})},
      {"rapier", "gives Rapier no solid without thickness, such as a disc", soft(core::Disc{0.3})},
      {"rapier", "Rapier collides a mesh as a surface", soft(tetrahedron)},
      {"rapier", "Rapier has no rigid joint of type distance", jointed(core::JointType::distance, 0, 1)},
      {"rapier",
       "Rapier needs principal moments above zero that float precision holds; 'b' has one of 0 kg m^2.",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0, 0.2).asDiagonal(); })},
      {"havok/path=stand-in", "'a' may touch 'wall', but the scene has no material", half_stated},
      {"havok", "Havok has no gyroscopic torque, and 'a' starts with one of", three_bodies(87)},
      {"havok/gyroscopic-torque=left-out", "Havok has no call for a force",
       with(resting(),
            [](core::Scene& s) {
              s.forces.emplace_back(core::Drag{0, 0.3, 0, 0});
            })},
      {"havok/path=stand-in", "Body 'a': Havok has no disc.", soft(core::Disc{0.3})},
      {"havok/path=stand-in", "Body 'a': Havok has no cone.", soft(core::Cone{0.1, 0.3})},
      {"havok/path=stand-in", "Havok collides a mesh as a surface", soft(tetrahedron)},
      {"havok/path=stand-in", "Havok needs a mass above zero that float precision holds; 'a' has 1e-46 kg.",
       with(three_bodies(85), [](core::Scene& s) { s.bodies[0].mass = 1e-46; })},
      {"crashcat", "'a' may touch 'floor', but the scene has no material", unstated},
      {"crashcat", "Body 'a': crashcat has no disc.", soft(core::Disc{0.3})},
      {"crashcat", "Body 'a': crashcat has no cone.", soft(core::Cone{0.1, 0.3})},
      {"crashcat", "crashcat collides a mesh only where it does not move", soft(tetrahedron)},
      {"crashcat", "crashcat needs principal moments above zero",
       with(three_bodies(86),
            [](core::Scene& s) { s.bodies[1].inertia = Vector3(0.2, 0, 0.2).asDiagonal(); })},
      {"physx", "'a' may touch 'wall', but the scene has no material", half_stated},
      {"physx", "PhysX has no solid without thickness, such as a disc", soft(core::Disc{0.3})},
      {"physx", "PhysX collides a mesh only where it does not move", soft(tetrahedron)},
      {"physx", "PhysX makes no hull of these vertices", soft(core::Hull{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}})},
      {"physx", "PhysX needs a mass above zero that float precision holds; 'a' has 1e-46 kg.",
       with(three_bodies(85), [](core::Scene& s) { s.bodies[0].mass = 1e-46; })},
      {"ode", "'a' may touch 'floor', but the scene has no material", unstated},
      {"ode", "'a' may touch 'wall', but the scene has no material", half_stated},
  };
}

TEST(Unsupported, EveryReasonIsASentence) {
  const process::KeptWorkers kept;  // those in Node take longer to start than to answer
  for (const Refusal& refusal : refusals()) {
    process::RunRequest request;
    request.scene = &refusal.scene;
    request.setup.dt = 1e-3;
    request.steps = 5;
    const auto engine = process::parse_engine(refusal.engine, process::default_engines(binary_dir));
    if (process::missing(engine.row)) continue;
    const process::RunOutcome outcome = process::run(engine, request, limits);
    EXPECT_EQ(results::name(outcome.status), "unsupported")
        << refusal.engine << " should say: " << refusal.reason << "\n"
        << outcome.reason;
    EXPECT_NE(outcome.reason.find(refusal.reason), std::string::npos)
        << refusal.engine << ": " << outcome.reason;
    EXPECT_FALSE(outcome.recording) << refusal.engine;
  }
}

// The other side: what is refused only where it matters is taken where it does not.
TEST(Unsupported, IgnoresIrrelevantFeatures) {
  const process::KeptWorkers kept;  // those in Node take longer to start than to answer
  const core::Scene untouched = with(resting(core::Box{{0.1, 0.2, 0.3}}), [](core::Scene& s) {
    s.bodies[0].collide = false;    // a box that touches nothing
    s.materials[0].friction = 0.3;  // of a pair that never is
    s.impacts = core::Impacts::simultaneous;
  });
  for (const Subject& subject : subjects_here())
    EXPECT_NO_THROW(last(subject.choice(), untouched, 1e-3, 5)) << subject.id;

  const core::Scene flat = with(three_bodies(88), [](core::Scene& s) {
    s.bodies[0].locked = true;  // a body without inertia that cannot turn
    s.bodies[0].inertia.setZero();
    s.bodies[0].initial.velocity = s.bodies[0].initial.angular_velocity = Vector3::Zero();
  });
  for (const Subject& subject : subjects_here())
    EXPECT_NO_THROW(last(subject.choice(), flat, 1e-3, 5)) << subject.id;

  const core::Scene both_locked = with(jointed(core::JointType::ball, 0, 1), [](core::Scene& s) {
    s.bodies[0].locked = s.bodies[1].locked = true;
  });
  for (const Subject& subject : subjects_here())
    EXPECT_TRUE(last(subject.choice(), both_locked, 1e-3, 5)[2].position.allFinite()) << subject.id;

  const core::Scene sunken = with(in_water(core::Sphere{0.2}), [](core::Scene& s) {
    s.bodies[1].shape = core::Rod{0.3};  // cannot move, whatever the water does
    s.bodies[1].locked = true;
    s.bodies[1].initial.velocity = s.bodies[1].initial.angular_velocity = Vector3::Zero();
  });
  for (const char* id : {"bullet", "bullet-multibody", "ode"}) {
    const auto engine = process::parse_engine(id, process::default_engines(binary_dir));
    EXPECT_NO_THROW(last(engine, sunken, 1e-3, 5)) << id;
  }
}

}  // namespace
}  // namespace cylon::conformance
