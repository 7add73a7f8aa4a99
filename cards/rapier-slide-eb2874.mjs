// Rapier 0.21.0 (WebAssembly in Node 20.20.2), slide: 1 body, box, friction, gravity, plane.
// What should happen: a box that slides is braked by the coefficient of friction times its weight.
// It prints 0.00133 m.
// npm install @dimforge/rapier3d-compat && node rapier-slide-eb2874.mjs
import RAPIER from '@dimforge/rapier3d-compat';
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
const dt = 0.01, steps = 6, count = 1;

await RAPIER.init();
const xyz = ([x, y, z]) => ({x, y, z}), wxyz = ([w, x, y, z]) => ({w, x, y, z}), of = ({x, y, z}) => [x, y, z];
let world, id;

function add_shape(shape, to) {
  world.createCollider(shape.setDensity(0).setRestitution(0.0).setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Min)
    .setFriction(1.0).setFrictionCombineRule(RAPIER.CoefficientCombineRule.Min), to);
}

function build(take) {
  world = new RAPIER.World(xyz(gravity[take]));
  world.integrationParameters.dt = dt;
  add_shape(new RAPIER.ColliderDesc(new RAPIER.HalfSpace({x: 0, y: 1, z: 0})), world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(...[0.0, 0.0, 0.0]).setRotation(wxyz([1.0, 0.0, 0.0, 0.0]))));
  id = body.map(({m, I}, i) => {
    const s = start[take][i];
    return world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...s.x).setRotation(wxyz(s.q)).setLinvel(...s.v)
      .setAngvel(xyz(s.w)).setAdditionalMassProperties(m, xyz([0, 0, 0]), xyz(I), wxyz([1, 0, 0, 0])).setCanSleep(false));
  });
  add_shape(RAPIER.ColliderDesc.cuboid(0.485, 0.106, 0.305), id[0]);
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

function worst_of(path) {
  let v = start[0][0].v;
  let slowed = 1.0 * norm(gravity[0]) / norm(v);
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
