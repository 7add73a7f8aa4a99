// Havok 1.3.14 (WebAssembly in Node 20.20.2), linear momentum: 2 bodies, sphere.
// What should happen: what nothing holds keeps its momentum.
// It prints 0.00878 kg m/s.
// npm install @babylonjs/havok && node havok-linear-momentum-75c536.mjs
import fs from 'node:fs';
import {createRequire} from 'node:module';
import init from '@babylonjs/havok';

const file = createRequire(import.meta.url).resolve('@babylonjs/havok').replace(/lib\/.*$/, 'lib/esm/HavokPhysics.wasm');
const H = await init({wasmBinary: fs.readFileSync(file)});

const {abs, asin, cos, max, min, sqrt} = Math;
// Vectors [x, y, z] in world axes, quaternions [w, x, y, z] from body to world axes.
const add = (a, b) => a.map((x, i) => x + b[i]);
const sub = (a, b) => a.map((x, i) => x - b[i]);
const mul = (s, a) => a.map((x) => s * x);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const norm = (a) => sqrt(dot(a, a));
const turn = (q, v) => { const u = q.slice(1), t = mul(2, cross(u, v)); return add(add(v, mul(q[0], t)), cross(u, t)); };
const back = (q, v) => turn([q[0], -q[1], -q[2], -q[3]], v);
const record = (s) => [s], append = (path, s) => path.push(s);

const named = ([m, I]) => ({m, I}), moving = ([x, q, v, w]) => ({x, q, v, w});
const body = [[1.0, [0.010758400000000001, 0.010758400000000001, 0.010758400000000001]], [3.0, [0.032275200000000004, 0.032275200000000004, 0.032275200000000004]]].map(named);  // mass [kg], moments about the axes of the body [kg m^2]
const start = [[[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [-6.0, 0.0, 0.0], [0.0, 0.0, 0.0]]]].map((all) => all.map(moving));  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
const gravity = [[0.0, 0.0, 0.0]];
const dt = 0.1, steps = 3, count = 2;

const xyzw = ([w, x, y, z]) => [x, y, z, w];
const of = ([result, value]) => value, least = H.MaterialCombine.MINIMUM;
let world, id, shape, ground, speed = 200, spin = 100;

function make(x, q, type, shape) {
  const made = of(H.HP_Body_Create());
  H.HP_Body_SetMotionType(made, type);
  if (shape) {
    H.HP_Shape_SetMaterial(shape, [0.0, 0.0, 0.0, least, least]), H.HP_Shape_SetFilterInfo(shape, [1, -1]);
    H.HP_Body_SetShape(made, shape);
  }
  H.HP_Body_SetQTransform(made, [x, xyzw(q)]);
  return made;
}

function build(take) {
  world = of(H.HP_World_Create()), shape = [], ground = undefined;
  speed = 1e18;
  spin = 1e18;
  H.HP_World_SetIdealStepTime(world, 0);
  H.HP_World_SetGravity(world, gravity[take]), H.HP_World_SetSpeedLimit(world, speed, spin);
  const plane = (foot, turned) => {  // Havok has none
    const box = of(H.HP_Shape_CreateBox([0, -5, 0], [0, 0, 0, 1], [200, 10, 200]));
    H.HP_World_AddBody(world, make(foot, turned, H.MotionType.STATIC, box), false);
  };
  shape[0] = of(H.HP_Shape_CreateSphere([0, 0, 0], 0.164));
  shape[1] = of(H.HP_Shape_CreateSphere([0, 0, 0], 0.164));
  id = body.map(({m, I}, i) => {
    const {x, q} = start[take][i], made = make(x, q, H.MotionType.DYNAMIC, shape[i]);
    H.HP_Body_SetMassProperties(made, [[0, 0, 0], m, mul(1 / m, I), [0, 0, 0, 1]]);  // the inertia for a mass of 1
    H.HP_Body_SetAngularDamping(made, 0);
    H.HP_Body_SetActivationControl(made, H.ActivationControl.ALWAYS_ACTIVE);
    H.HP_World_AddBody(world, made, false);
    return made;
  });
  start[take].forEach(({v, w}, i) => { H.HP_Body_SetLinearVelocity(id[i], v), H.HP_Body_SetAngularVelocity(id[i], w); });
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

function run(take) {
  build(take);
  let path = record(states());
  for (let k = 1; k <= steps; ++k) {
    step();
    append(path, states());
  }
  return path;
}

function value(s) {
  let P = mul(0.0, s[0].v);
  for (let i = 0; i < count; ++i) P = add(P, mul(body[i].m, s[i].v));
  return P;
}

let path = run(0);
let worst = 0.0;
for (let k = 1; k <= steps; ++k) worst = max(worst, norm(sub(value(path[k]), value(path[0]))));
console.log(worst.toPrecision(9), 'kg m/s');
