// crashcat 0.0.5 (JavaScript in Node 20.20.2), slide: 1 body, box, friction, gravity, plane.
// What should happen: a box that slides is braked by the coefficient of friction times its weight.
// It prints 0.00921 m.
// npm install crashcat && node crashcat-slide-8cb9c1.mjs
import * as C from 'crashcat';
const {abs, asin, ceil, cos, max, min, sin, sqrt} = Math;
// Vectors [x, y, z] in world axes, quaternions [w, x, y, z] from body to world axes.
const add = (a, b) => a.map((x, i) => x + b[i]);
const sub = (a, b) => a.map((x, i) => x - b[i]);
const mul = (s, a) => a.map((x) => s * x);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const norm = (a) => sqrt(dot(a, a));
const record = (s) => [s], append = (path, s) => path.push(s);

const named = ([m, I]) => ({m, I}), moving = ([x, q, v, w]) => ({x, q, v, w});
const body = [[1.0, [0.03475366666666666, 0.10941666666666666, 0.08215366666666667]]].map(named);  // mass [kg], moments about the axes of the body [kg m^2]
const start = [[[[0.0, 0.106, 0.0], [1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 0.0, 0.0]]]].map((all) => all.map(moving));  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
const gravity = [[0.0, -10.0, 0.0]];
const dt = 0.01, steps = 25, count = 1;

C.registerAll();
const xyzw = ([w, x, y, z]) => [x, y, z, w], put = (to, from) => from.forEach((x, k) => { to[k] = x; });
let world, id, shape, tied, ground, convexRadius = 0.05, turning = false;

function enter(members) {
  const rule = C.MaterialCombineMode.MIN;
  return C.rigidBody.create(world, {restitution: 0.0, friction: 0.5, restitutionCombineMode: rule, frictionCombineMode: rule,
    ...members});
}

function build(take) {
  const settings = C.createWorldSettings(), broad = C.addBroadphaseLayer(settings);
  const [fixed, free, ghost] = [0, 1, 2].map(() => C.addObjectLayer(settings, broad));
  for (const layer of [fixed, free, ghost]) C.disableCollision(settings, ghost, layer);
  C.disableCollision(settings, fixed, fixed), C.enableCollision(settings, fixed, free), C.enableCollision(settings, free, free);
  settings.gravity = gravity[take];
  turning = true;
  convexRadius = 0;
  settings.sleeping.allowSleeping = false;
  settings.solver.minVelocityForRestitution = 0;
  world = C.createWorld(settings), shape = [], tied = [];
  const plane = (normal, foot) => enter({shape: C.plane.create({plane: {normal, constant: 0}, halfExtent: 1e4}), objectLayer: fixed,
    motionType: C.MotionType.STATIC, position: foot});
  plane([0.0, 1.0, 0.0], [0.0, 0.0, 0.0]);
  shape[0] = C.box.create({halfExtents: [0.485, 0.106, 0.305], convexRadius});
  id = body.map(({m, I}, i) => {
    const {x, q, v, w} = start[take][i];
    const made = enter({shape: shape[i] ?? null, objectLayer: shape[i] ? free : ghost, motionType: C.MotionType.DYNAMIC, position: [...x],
      quaternion: xyzw(q), massPropertiesOverride: {mass: 1, inertia: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}, linearDamping: 0, angularDamping: 0, maxLinearVelocity: 1e100, maxAngularVelocity: 1e100});
    const motion = made.motionProperties;
    motion.invMass = 1 / m, put(motion.invInertiaDiagonal, I.map((one) => 1 / one)), put(motion.inertiaRotation, [0, 0, 0, 1]);
    put(motion.linearVelocity, v), put(motion.angularVelocity, w);
    return made;
  });
  ground = enter({shape: null, objectLayer: ghost, motionType: C.MotionType.STATIC});
}

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

function run(take) {
  build(take);
  let path = record(states());
  for (let k = 1; k <= steps; ++k) {
    step();
    append(path, states());
  }
  return path;
}

function worst_of(path) {
  let v = start[0][0].v;
  let slowed = 0.5 * norm(gravity[0]) / norm(v);
  let worst = 0.0;
  for (let k = 0; k <= steps; ++k) {
    let t = min(k * dt, 1 / slowed);
    let must = add(start[0][0].x, mul(t - 0.5 * slowed * t * t, v));
    worst = max(worst, norm(sub(path[k][0].x, must)));
  }
  return worst;
}

let path = run(0);
let worst = worst_of(path);
console.log(worst.toPrecision(9), 'm');
