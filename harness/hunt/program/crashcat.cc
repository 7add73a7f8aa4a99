// crashcat's API in Node.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
C.registerAll();
const xyzw = ([w, x, y, z]) => [x, y, z, w], put = (to, from) => from.forEach((x, k) => { to[k] = x; });
let world, id, shape, tied, ground, convexRadius = 0.05, turning = false;

function enter(members) {
  const rule = C.MaterialCombineMode.MIN;
  return C.rigidBody.create(world, {restitution: ${restitution}, friction: ${friction}, restitutionCombineMode: rule, frictionCombineMode: rule,
    ...members});
}

function build(take) {
  const settings = C.createWorldSettings(), broad = C.addBroadphaseLayer(settings);
  const [fixed, free, ghost] = [0, 1, 2].map(() => C.addObjectLayer(settings, broad));
  for (const layer of [fixed, free, ghost]) C.disableCollision(settings, ghost, layer);
  C.disableCollision(settings, fixed, fixed), C.enableCollision(settings, fixed, free), C.enableCollision(settings, free, free);
  settings.gravity = gravity[take];
${world_settings}  world = C.createWorld(settings), shape = [], tied = [];
  const plane = (normal, foot) => enter({shape: C.plane.create({plane: {normal, constant: 0}, halfExtent: 1e4}), objectLayer: fixed,
    motionType: C.MotionType.STATIC, position: foot});
${planes}${shapes}  id = body.map(({m, I}, i) => {
    const {x, q, v, w} = start[take][i];
    const made = enter({shape: shape[i] ?? null, objectLayer: shape[i] ? free : ghost, motionType: C.MotionType.DYNAMIC, position: [...x],
      quaternion: xyzw(q), massPropertiesOverride: {mass: 1, inertia: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}${body_settings}});
    const motion = made.motionProperties;
    motion.invMass = 1 / m, put(motion.invInertiaDiagonal, I.map((one) => 1 / one)), put(motion.inertiaRotation, [0, 0, 0, 1]);
    put(motion.linearVelocity, v), put(motion.angularVelocity, w);
    return made;
  });
  ground = enter({shape: null, objectLayer: ghost, motionType: C.MotionType.STATIC});
${joints}}

function join(constraint, a, b, numbers) {
  const ends = {bodyIdA: id[a].id, bodyIdB: (b < 0 ? ground : id[b]).id, space: C.ConstraintSpace.WORLD};
  constraint.create(world, {...ends, ...numbers});
  if (b >= 0) tied.push([id[a], id[b]]);
}

function push(i, F, T) { C.rigidBody.addForce(world, id[i], F, true), C.rigidBody.addTorque(world, id[i], T, true); }
const listener = {onBodyPairValidate: (a, b) => !tied.some((two) => two.includes(a) && two.includes(b))};
function step() {
  if (turning) for (const b of id) C.motionProperties.applyGyroscopicForce(b.motionProperties, b.quaternion, dt);
  C.updateWorld(world, listener, dt);
}

function states() {
  return id.map(({quaternion: [x, y, z, w], centerOfMassPosition: at, motionProperties: motion}) =>
    ({x: [...at], q: [w, x, y, z], v: [...motion.linearVelocity], w: [...motion.angularVelocity]}));
}
)";

constexpr ShapeRow shapes[] = {
    {"sphere", "C.sphere.create({radius: ${radius}})"},
    {"box", "C.box.create({halfExtents: [${x}, ${y}, ${z}], convexRadius})"},
    {"capsule", "C.capsule.create({halfHeightOfCylinder: ${length} / 2, radius: ${radius}})"},
    {"cylinder", "C.cylinder.create({halfHeight: ${length} / 2, radius: ${radius}, convexRadius})"},
};

constexpr JointRow joints[] = {
    {JointType::ball,
     "  join(C.pointConstraint, ${a}, -1, {pointA: ${point_vector}, pointB: ${point_vector}});\n",
     "  join(C.pointConstraint, ${a}, ${b}, {pointA: ${point_vector}, pointB: ${point_vector}});\n"},
    {JointType::hinge,
     "  join(C.hingeConstraint, ${a}, -1, {pointA: ${point_vector}, pointB: ${point_vector}, hingeAxisA: "
     "${axis_vector}, "
     "hingeAxisB: ${axis_vector}, normalAxisA: across(${axis_vector}), normalAxisB: "
     "across(${axis_vector})});\n",
     "  join(C.hingeConstraint, ${a}, ${b}, {pointA: ${point_vector}, pointB: ${point_vector}, hingeAxisA: "
     "${axis_vector}, "
     "hingeAxisB: ${axis_vector}, normalAxisA: across(${axis_vector}), normalAxisB: "
     "across(${axis_vector})});\n"},
};

constexpr SettingRow settings[] = {
    {"build", "", Where::program, ""},
    {"mass, inertia", "", Where::program, ""},
    {"restitution, friction", "", Where::program, ""},
    {"collision filter", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"motionProperties.applyGyroscopicForce", "on", Where::world, "  turning = true;\n"},
    {"convexRadius", "", Where::world, "  convexRadius = ${value};\n"},
    {"linearDamping", "", Where::body, ", linearDamping: ${value}"},
    {"angularDamping", "", Where::body, ", angularDamping: ${value}"},
    {"maxLinearVelocity", "", Where::body, ", maxLinearVelocity: ${value}"},
    {"maxAngularVelocity", "", Where::body, ", maxAngularVelocity: ${value}"},
    {"allowSleeping", "off", Where::world, "  settings.sleeping.allowSleeping = false;\n"},
    {"minVelocityForRestitution", "", Where::world,
     "  settings.solver.minVelocityForRestitution = ${value};\n"},
    {"penetrationSlop", "", Where::world, "  settings.solver.penetrationSlop = ${value};\n"},
    {"baumgarteFactor", "", Where::world, "  settings.solver.baumgarteFactor = ${value};\n"},
    {"velocityIterations", "", Where::world, "  settings.solver.velocityIterations = ${value};\n"},
    {"positionIterations", "", Where::world, "  settings.solver.positionIterations = ${value};\n"},
    {"warmStarting", "off", Where::world, "  settings.solver.warmStarting = false;\n"},
    {"speculativeContactDistance", "", Where::world,
     "  settings.narrowphase.speculativeContactDistance = ${value};\n"},
    {"useBodyPairContactCache", "off", Where::world,
     "  settings.narrowphase.useBodyPairContactCache = false;\n"},
};

}  // namespace

extern const Dialect crashcat;
const Dialect crashcat = {"crashcat",
                          "crashcat",
                          &javascript,
                          "npm install crashcat",
                          "node ${file}",
                          "import * as C from 'crashcat';\n",
                          functions,
                          "  shape[${i}] = ${shape};\n",
                          "",
                          "  plane(${normal_vector}, ${foot});\n",
                          shapes,
                          joints,
                          settings};

}  // namespace cylon::hunt::program
