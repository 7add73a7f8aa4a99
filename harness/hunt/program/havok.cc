// Havok's API in Node.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view head = R"(import fs from 'node:fs';
import {createRequire} from 'node:module';
import init from '@babylonjs/havok';

const file = createRequire(import.meta.url).resolve('@babylonjs/havok').replace(/lib\/.*$/, 'lib/esm/HavokPhysics.wasm');
const H = await init({wasmBinary: fs.readFileSync(file)});

)";

constexpr std::string_view functions = R"(
const xyzw = ([w, x, y, z]) => [x, y, z, w];
const of = ([result, value]) => value, minimum = H.MaterialCombine.MINIMUM;
let world, id, shape, ground, speed = 200, spin = 100;

function make(x, q, type, shape) {
  const made = of(H.HP_Body_Create());
  H.HP_Body_SetMotionType(made, type);
  if (shape) {
    H.HP_Shape_SetMaterial(shape, [${friction}, ${friction}, ${restitution}, minimum, minimum]), H.HP_Shape_SetFilterInfo(shape, [1, -1]);
    H.HP_Body_SetShape(made, shape);
  }
  H.HP_Body_SetQTransform(made, [x, xyzw(q)]);
  return made;
}

function build(take) {
  world = of(H.HP_World_Create()), shape = [], ground = undefined;
${world_settings}  H.HP_World_SetGravity(world, gravity[take]), H.HP_World_SetSpeedLimit(world, speed, spin);
  const plane = (foot, turned) => {  // Havok has none
    const box = of(H.HP_Shape_CreateBox([0, -5, 0], [0, 0, 0, 1], [200, 10, 200]));
    H.HP_World_AddBody(world, make(foot, turned, H.MotionType.STATIC, box), false);
  };
${planes}${shapes}  id = body.map(({m, I}, i) => {
    const {x, q} = start[take][i], made = make(x, q, H.MotionType.DYNAMIC, shape[i]);
    H.HP_Body_SetMassProperties(made, [[0, 0, 0], m, mul(1 / m, I), [0, 0, 0, 1]]);  // the inertia for a mass of 1
${body_settings}    H.HP_World_AddBody(world, made, false);
    return made;
  });
${joints}  start[take].forEach(({v, w}, i) => { H.HP_Body_SetLinearVelocity(id[i], v), H.HP_Body_SetAngularVelocity(id[i], w); });
}

function join(a, b, point, along, side, locked) {
  if (b < 0 && !ground) H.HP_World_AddBody(world, ground = make([0, 0, 0], [1, 0, 0, 0], H.MotionType.STATIC), false);
  const made = of(H.HP_Constraint_Create());
  const end = ({x, q}) => [back(q, sub(point, x)), back(q, along), back(q, side)];
  H.HP_Constraint_SetParentBody(made, b < 0 ? ground : id[b]), H.HP_Constraint_SetChildBody(made, id[a]);
  H.HP_Constraint_SetAnchorInParent(made, ...end(b < 0 ? {x: [0, 0, 0], q: [1, 0, 0, 0]} : start[0][b]));
  H.HP_Constraint_SetAnchorInChild(made, ...end(start[0][a]));
  for (const axis of ['LINEAR_X', 'LINEAR_Y', 'LINEAR_Z', ...locked])
    H.HP_Constraint_SetAxisMode(made, H.ConstraintAxis[axis], H.ConstraintAxisLimitMode.LOCKED);
  H.HP_Constraint_SetEnabled(made, 1);
}

function push(i, F, T) {  // Havok has no force
  H.HP_Body_ApplyImpulse(id[i], of(H.HP_Body_GetQTransform(id[i]))[0], mul(dt, F)), H.HP_Body_ApplyAngularImpulse(id[i], mul(dt, T));
}
function step() { H.HP_World_Step(world, dt); }

function states() {
  return id.map((b) => {
    const [at, [x, y, z, w]] = of(H.HP_Body_GetQTransform(b));
    return {x: at, q: [w, x, y, z], v: of(H.HP_Body_GetLinearVelocity(b)), w: of(H.HP_Body_GetAngularVelocity(b))};
  });
}
)";

constexpr ShapeRow shapes[] = {
    {"sphere", "of(H.HP_Shape_CreateSphere([0, 0, 0], ${radius}))"},
    {"box", "of(H.HP_Shape_CreateBox([0, 0, 0], [0, 0, 0, 1], [2 * ${x}, 2 * ${y}, 2 * ${z}]))"},
    {"capsule", "of(H.HP_Shape_CreateCapsule([0, -${length} / 2, 0], [0, ${length} / 2, 0], ${radius}))"},
    {"cylinder", "of(H.HP_Shape_CreateCylinder([0, -${length} / 2, 0], [0, ${length} / 2, 0], ${radius}))"},
};

constexpr JointRow joints[] = {
    {JointType::ball, "  join(${a}, -1, ${point_vector}, [1, 0, 0], [0, 1, 0], []);\n",
     "  join(${a}, ${b}, ${point_vector}, [1, 0, 0], [0, 1, 0], []);\n"},
    {JointType::hinge,
     "  join(${a}, -1, ${point_vector}, ${axis_vector}, across(${axis_vector}), ['ANGULAR_Y', "
     "'ANGULAR_Z']);\n",
     "  join(${a}, ${b}, ${point_vector}, ${axis_vector}, across(${axis_vector}), ['ANGULAR_Y', "
     "'ANGULAR_Z']);\n"},
    {JointType::fixed,
     "  join(${a}, -1, ${point_vector}, [1, 0, 0], [0, 1, 0], ['ANGULAR_X', 'ANGULAR_Y', 'ANGULAR_Z']);\n",
     "  join(${a}, ${b}, ${point_vector}, [1, 0, 0], [0, 1, 0], ['ANGULAR_X', 'ANGULAR_Y', "
     "'ANGULAR_Z']);\n"},
};

constexpr SettingRow settings[] = {
    {"build", "", Where::program, ""},
    {"mass, inertia", "", Where::program, ""},
    {"restitution, friction", "", Where::program, ""},
    {"planes", "", Where::program, ""},
    {"collision filter", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"forces of a scene", "", Where::program, ""},
    {"gyroscopic torque", "", Where::program, ""},
    {"HP_Body_SetLinearDamping", "", Where::body, "    H.HP_Body_SetLinearDamping(made, ${value});\n"},
    {"HP_Body_SetAngularDamping", "", Where::body, "    H.HP_Body_SetAngularDamping(made, ${value});\n"},
    {"HP_World_SetSpeedLimit, linear", "", Where::world, "  speed = ${value};\n"},
    {"HP_World_SetSpeedLimit, angular", "", Where::world, "  spin = ${value};\n"},
    {"HP_World_SetIdealStepTime", "", Where::world, "  H.HP_World_SetIdealStepTime(world, ${value});\n"},
    {"HP_Body_SetActivationControl", "off", Where::body,
     "    H.HP_Body_SetActivationControl(made, H.ActivationControl.ALWAYS_ACTIVE);\n"},
};

}  // namespace

extern const Dialect havok;
const Dialect havok = {"havok",
                       "Havok",
                       &javascript,
                       "npm install @babylonjs/havok",
                       "node ${file}",
                       head,
                       functions,
                       "  shape[${i}] = ${shape};\n",
                       "",
                       "  plane(${foot}, ${turn_of_y});\n",
                       shapes,
                       joints,
                       settings};

}  // namespace cylon::hunt::program
