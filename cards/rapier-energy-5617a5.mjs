// Rapier 0.21.0 (WebAssembly in Node 20.20.2), energy: 3 bodies, restitution, sphere.
// What should happen: without losses the energy stays; balls that rebound with all of their speed lose none.
// It prints 0.083 J.
// npm install @dimforge/rapier3d-compat && node rapier-energy-5617a5.mjs
import RAPIER from '@dimforge/rapier3d-compat';
const {abs, asin, cos, max, min, sqrt} = Math;
// Vectors [x, y, z] in world axes, quaternions [w, x, y, z] from body to world axes.
const add = (a, b) => a.map((x, i) => x + b[i]);
const mul = (s, a) => a.map((x) => s * x);
const each = (a, b) => a.map((x, i) => x * b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const turn = (q, v) => { const u = q.slice(1), t = mul(2, cross(u, v)); return add(add(v, mul(q[0], t)), cross(u, t)); };
const back = (q, v) => turn([q[0], -q[1], -q[2], -q[3]], v);
const record = (s) => [s], append = (path, s) => path.push(s);

const named = ([m, I]) => ({m, I}), moving = ([x, q, v, w]) => ({x, q, v, w});
const body = [[1.0, [0.1, 0.1, 0.1]], [1.0, [0.1, 0.1, 0.1]], [1.0, [0.1, 0.1, 0.1]]].map(named);  // mass [kg], moments about the axes of the body [kg m^2]
const start = [[[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]], [[2.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]]].map((all) => all.map(moving));  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
const gravity = [[0.0, 0.0, 0.0]];
const dt = 0.1, steps = 1, count = 3;

await RAPIER.init();
const xyz = ([x, y, z]) => ({x, y, z}), wxyz = ([w, x, y, z]) => ({w, x, y, z}), of = ({x, y, z}) => [x, y, z];
let world, id;

function add_shape(shape, to) {
  world.createCollider(shape.setDensity(0).setRestitution(1.0).setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Min)
    .setFriction(0.0).setFrictionCombineRule(RAPIER.CoefficientCombineRule.Min), to);
}

function build(take) {
  world = new RAPIER.World(xyz(gravity[take]));
  world.integrationParameters.dt = dt;
  id = body.map(({m, I}, i) => {
    const s = start[take][i];
    return world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...s.x).setRotation(wxyz(s.q)).setLinvel(...s.v)
      .setAngvel(xyz(s.w)).setAdditionalMassProperties(m, xyz([0, 0, 0]), xyz(I), wxyz([1, 0, 0, 0])).setCanSleep(false));
  });
  add_shape(RAPIER.ColliderDesc.ball(0.5), id[0]);
  add_shape(RAPIER.ColliderDesc.ball(0.5), id[1]);
  add_shape(RAPIER.ColliderDesc.ball(0.5), id[2]);
  const ground = world.createRigidBody(RAPIER.RigidBodyDesc.fixed());
}

let pushed = false;
function push(i, F, T) { id[i].addForce(xyz(F), true), id[i].addTorque(xyz(T), true), pushed = true; }
function step() {
  world.step();
  if (pushed) for (const b of id) b.resetForces(true), b.resetTorques(true);  // else they stay
  pushed = false;
}

function states() {
  return id.map((b) => {
    const q = b.rotation();
    return {x: of(b.translation()), q: [q.w, q.x, q.y, q.z], v: of(b.linvel()), w: of(b.angvel())};
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
  let E = 0.0;
  for (let i = 0; i < count; ++i) {
    let w = back(s[i].q, s[i].w);
    E += 0.5 * body[i].m * dot(s[i].v, s[i].v) + 0.5 * dot(w, each(body[i].I, w)) - body[i].m * dot(gravity[0], s[i].x);
  }
  return E;
}

let path = run(0);
let worst = 0.0;
for (let k = 1; k <= steps; ++k) worst = max(worst, abs(value(path[k]) - value(path[0])));
console.log(worst.toPrecision(9), 'J');
