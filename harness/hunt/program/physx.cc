// PhysX' API in Node.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view head = R"(import fs from 'node:fs';
import {createRequire} from 'node:module';
import init from 'physx-js-webidl';

const {process} = globalThis;  // the module throws where it finds Node
const wasmBinary = fs.readFileSync(createRequire(import.meta.url).resolve('physx-js-webidl').replace(/\.mjs$/, '.wasm'));
globalThis.process = undefined, globalThis.window = globalThis;
const P = await init({wasmBinary});
globalThis.process = process, delete globalThis.window;

)";

constexpr std::string_view functions = R"(
const top = P.PxTopLevelFunctions.prototype, tolerances = new P.PxTolerancesScale();
const foundation = top.CreateFoundation(P.PHYSICS_VERSION, new P.PxDefaultAllocator(), new P.PxDefaultErrorCallback());
const physics = top.CreatePhysics(P.PHYSICS_VERSION, foundation, tolerances);
top.InitExtensions(physics);
const vec = (v) => new P.PxVec3(...v), xyz = ({x, y, z}) => [x, y, z];
const pose = (at, [w, x, y, z]) => new P.PxTransform(vec(at), new P.PxQuat(x, y, z, w)), as_it_is = [1, 0, 0, 0];
const along_y = [sqrt(0.5), 0, 0, sqrt(0.5)];  // PhysX has capsules and cylinders along x
let scene, id, shape, material, contact_offset = 0.02, position_iterations = 4, velocity_iterations = 1;

function touch(actor, geometry, turned) {
  const made = physics.createShape(geometry, material, true, new P.PxShapeFlags(P.PxShapeFlagEnum.eSIMULATION_SHAPE));
  made.setContactOffset(contact_offset), made.setLocalPose(pose([0, 0, 0], turned));
  made.setSimulationFilterData(new P.PxFilterData(1, 1, 0, 0));
  actor.attachShape(made);
}

function build(take) {
  const desc = new P.PxSceneDesc(tolerances);
  desc.gravity = vec(gravity[take]), desc.cpuDispatcher = top.DefaultCpuDispatcherCreate(0);
  desc.filterShader = top.DefaultFilterShader();
${world_settings}  scene = physics.createScene(desc), shape = [];
  material = physics.createMaterial(${friction}, ${friction}, ${restitution});
  const plane = (foot, turned) => {
    const actor = physics.createRigidStatic(pose(foot, turned));
    touch(actor, new P.PxPlaneGeometry(), as_it_is), scene.addActor(actor);
  };
${planes}${shapes}  id = body.map(({m, I}, i) => {
    const {x, q, v, w} = start[take][i], actor = physics.createRigidDynamic(pose(x, q));
    if (shape[i]) touch(actor, ...shape[i]);
    actor.setMass(m), actor.setMassSpaceInertiaTensor(vec(I));
    actor.setSolverIterationCounts(position_iterations, velocity_iterations);
${body_settings}    scene.addActor(actor);
    actor.setLinearVelocity(vec(v)), actor.setAngularVelocity(vec(w));
    return actor;
  });
${joints}}

function push(i, F, T) { id[i].addForce(vec(F)), id[i].addTorque(vec(T)); }
function step() { scene.simulate(dt), scene.fetchResults(true); }

function states() {
  return id.map((b) => {
    const {p, q} = b.getGlobalPose();
    return {x: xyz(p), q: [q.w, q.x, q.y, q.z], v: xyz(b.getLinearVelocity()), w: xyz(b.getAngularVelocity())};
  });
}
)";

constexpr ShapeRow shapes[] = {
    {"sphere", "[new P.PxSphereGeometry(${radius}), as_it_is]"},
    {"box", "[new P.PxBoxGeometry(${x}, ${y}, ${z}), as_it_is]"},
    {"capsule", "[new P.PxCapsuleGeometry(${radius}, ${length} / 2), along_y]"},
    {"cylinder",
     "[P.PxConvexCoreGeometryFactory.prototype.createFromCylinder(new P.PxConvexCoreCylinder(${length}, "
     "${radius}), 0), along_y]"},
};

constexpr JointRow joints[] = {
    {JointType::ball,
     "  top.SphericalJointCreate(physics, id[${a}], pose(${local_a}, ${frame_a}), null, "
     "pose(${point_vector}, ${frame}));\n",
     "  top.SphericalJointCreate(physics, id[${a}], pose(${local_a}, ${frame_a}), id[${b}], pose(${local_b}, "
     "${frame_b}));\n"},
    {JointType::hinge,
     "  top.RevoluteJointCreate(physics, id[${a}], pose(${local_a}, ${frame_a}), null, pose(${point_vector}, "
     "${frame}));\n",
     "  top.RevoluteJointCreate(physics, id[${a}], pose(${local_a}, ${frame_a}), id[${b}], pose(${local_b}, "
     "${frame_b}));\n"},
    {JointType::fixed,
     "  top.FixedJointCreate(physics, id[${a}], pose(${local_a}, ${frame_a}), null, pose(${point_vector}, "
     "${frame}));\n",
     "  top.FixedJointCreate(physics, id[${a}], pose(${local_a}, ${frame_a}), id[${b}], pose(${local_b}, "
     "${frame_b}));\n"},
};

constexpr SettingRow settings[] = {
    {"build", "", Where::program, ""},
    {"mass, inertia", "", Where::program, ""},
    {"restitution, friction", "", Where::program, ""},
    {"PxDistanceJoint tolerance", "", Where::program, ""},
    {"collision filter", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"eENABLE_GYROSCOPIC_FORCES (bit 10)", "on", Where::body,
     "    actor.setRigidBodyFlag(1 << 10, true);  // eENABLE_GYROSCOPIC_FORCES, which the bindings do not "
     "name\n"},
    {"solverType", "tgs", Where::world, "  desc.solverType = P.PxSolverTypeEnum.eTGS;\n"},
    {"setLinearDamping", "", Where::body, "    actor.setLinearDamping(${value});\n"},
    {"setAngularDamping", "", Where::body, "    actor.setAngularDamping(${value});\n"},
    {"setMaxLinearVelocity", "", Where::body, "    actor.setMaxLinearVelocity(${value});\n"},
    {"setMaxAngularVelocity", "", Where::body, "    actor.setMaxAngularVelocity(${value});\n"},
    {"setSleepThreshold, setStabilizationThreshold", "off", Where::body,
     "    actor.setSleepThreshold(0), actor.setStabilizationThreshold(0);\n"},
    {"bounceThresholdVelocity", "", Where::world, "  desc.bounceThresholdVelocity = ${value};\n"},
    {"setContactOffset", "", Where::world, "  contact_offset = ${value};\n"},
    {"setSolverIterationCounts, position", "", Where::world, "  position_iterations = ${value};\n"},
    {"setSolverIterationCounts, velocity", "", Where::world, "  velocity_iterations = ${value};\n"},
};

}  // namespace

extern const Dialect physx;
const Dialect physx = {"physx",
                       "PhysX",
                       &javascript,
                       "npm install physx-js-webidl",
                       "node ${file}",
                       head,
                       functions,
                       "  shape[${i}] = ${shape};\n",
                       "",
                       "  plane(${foot}, ${turn_of_x});\n",
                       shapes,
                       joints,
                       settings};

}  // namespace cylon::hunt::program
