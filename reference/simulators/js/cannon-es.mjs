// The adapter of cannon-es (JavaScript, double precision): a prepared scene in, motion out.
// Knows nothing of the protocol.
import fs from 'node:fs';
import * as C from 'cannon-es';
import {kept} from './joints.mjs';
import {Unsupported} from './scene.mjs';
import {LeftOut, torque_option} from './torque.mjs';
import {conjugate, cross, multiply, norm, quaternion_of, rotate, scale, sub} from './vectors.mjs';

const unlimited = 1e100;

export const about = {
  name: 'cannon-es', title: 'cannon-es', build: 'JavaScript', precision: 'double',
  schemes: [{name: 'semi-implicit-euler', order: 1, conserves: 'linear momentum', adaptive: false}],
  gyroscopic: () => 'none',
  joints: {types: ['ball', 'hinge', 'fixed', 'distance'], limits: [],
    friction: []},
  of_the_scene: [
    {name: 'mass, inertia', value: 'of the scene', engine_default: 'that of the bounding box, a sphere\'s too',
      reason: 'the scene has its own: mass, inertia and their inverses, in principal axes'},
    {name: 'restitution, friction', value: 'of the pair', engine_default: '0.3; 0.3', reason: 'a ContactMaterial for each pair of materials'},
    {name: 'collision filter', value: 'needBroadphaseCollision', engine_default: 'all with all',
      reason: 'pairs that a joint ties, or that groups and masks keep apart, do not touch'},
  ],
  unforceable: [
    'There is no gyroscopic torque and no switch for it: a free body keeps its angular velocity (cannon-es.js:3887, Body.integrate).',
    'There is no Coulomb friction: it is bounded by mu times the weight of the pair, whatever the normal force (cannon-es.js:10459), and the bound is taken as an impulse of each step (cannon-es.js:9948).',
    'A contact is a damped spring (SPOOK), and so is a joint; a bounce depends on the step (cannon-es.js:5993, ContactEquation.computeB).',
    'Restitution multiplies the velocities of the centres, not those of the points that touch (cannon-es.js:6033).',
    'A contact bears at most 1e6 N s in a step (cannon-es.js:5985).',
    'A turn is that of infinitesimal angles, 2 atan(w dt/2) in a step (cannon-es.js:1923).',
    'Every pair of bodies is looked at in each step (NaiveBroadphase).',
    'A step runs on one thread.',
    'This adapter tells no forces of contacts and joints.',
  ],
  options: [
    torque_option,
    {name: 'friction', setting: 'ContactMaterial.friction', values: ['refused', 'times-dt', 'as-it-is'], engine_default: 'as-it-is',
      meaning: 'refused: a pair with friction is unsupported; times-dt: mu dt, so that the bound of an impulse is that of a force; as-it-is: mu'},
    {name: 'linear-damping', setting: 'Body.linearDamping', least: 0, most: 1, engine_default: 0.01, meaning: 'of velocities: what of them is lost in a second'},
    {name: 'angular-damping', setting: 'Body.angularDamping', least: 0, most: 1, engine_default: 0.01, meaning: 'of angular velocities: what of them is lost in a second'},
    {name: 'iterations', setting: 'GSSolver.iterations', least: 1, most: 1e6, whole: true, engine_default: 10, meaning: 'sweeps of the solver at most'},
    {name: 'tolerance', setting: 'GSSolver.tolerance', least: 0, most: 1e6, engine_default: 1e-7, meaning: 'sum of the changes of a sweep below which sweeps end [N s]'},
    {name: 'contact-stiffness', setting: 'contactEquationStiffness', least: 0, most: unlimited, above: true, engine_default: 1e7, meaning: 'of the spring that a contact is [N/m]'},
    {name: 'contact-relaxation', setting: 'contactEquationRelaxation', least: 0, most: 1e6, above: true, engine_default: 3, meaning: 'steps in which an error of a contact goes'},
    {name: 'joint-force', setting: 'Constraint maxForce', least: 0, most: unlimited, above: true, engine_default: 1e6, meaning: 'impulse that a joint bears in a step [N s]'},
    {name: 'joint-step', setting: 'Equation.setSpookParams', values: ['1/60', 'dt'], engine_default: '1/60',
      meaning: 'step for which the spring that a joint is is meant'},
  ],
  paths: [],
};
const plain = {
  'gyroscopic-torque': ['refused', 'cannon-es has none'],
  'friction': ['refused', 'cannon-es has no Coulomb friction'],
  'linear-damping': [0, 'the scene has no damping'],
  'angular-damping': [0, 'the scene has no damping'],
  'joint-force': [unlimited, 'a joint of the scene does not break'],
  'joint-step': ['dt', 'the step is dt'],
};
about.paths.push(
  {name: 'plain', summary: 'damping is off, joints are those of the step; what cannon-es has no concept of is refused', set: plain},
  {name: 'stand-in', summary: 'as plain; friction is bounded by the weight, and the gyroscopic torque is left out', set: {...plain,
    'gyroscopic-torque': ['left-out', 'a stand-in: cannon-es has none'],
    'friction': ['times-dt', 'a stand-in: cannon-es has no Coulomb friction, and takes the bound of a force as that of an impulse'],
  }},
  {name: 'as-shipped', summary: 'every setting as cannon-es has it by itself', set: {}});

export async function start() {
  const {version} = JSON.parse(fs.readFileSync(new URL('node_modules/cannon-es/package.json', import.meta.url), 'utf8'));
  return {version, load: (scene, dt, values) => new World(scene, dt, values), defaults};
}

/** The engine's own values of the options, asked of itself; null where it does not tell. */
function defaults() {
  const world = new C.World(), body = new C.Body({mass: 1}), material = new C.ContactMaterial(new C.Material(), new C.Material());
  const joint = new C.PointToPointConstraint(body, undefined, new C.Body({mass: 1})).equations[0];
  const spook = new C.Equation(body, body, 0, 0);
  spook.setSpookParams(1e7, 4, 1 / 60);
  return {
    'gyroscopic-torque': null, 'friction': null, 'linear-damping': body.linearDamping, 'angular-damping': body.angularDamping,
    'iterations': world.solver.iterations, 'tolerance': world.solver.tolerance,
    'contact-stiffness': material.contactEquationStiffness, 'contact-relaxation': material.contactEquationRelaxation,
    'joint-force': joint.maxForce, 'joint-step': joint.a === spook.a && joint.eps === spook.eps ? '1/60' : 'another',
  };
}

const vec = ([x, y, z]) => new C.Vec3(x, y, z);
const turn = ([w, x, y, z]) => new C.Quaternion(x, y, z, w);
const three = ({x, y, z}) => [x, y, z];
const four = ({x, y, z, w}) => [w, x, y, z];

// ---- Shapes -------------------------------------------------------------------------------------------

function primitive(shape, {name}) {
  const made = {
    sphere: () => new C.Sphere(shape.radius),
    box: () => new C.Box(vec(shape.half_extents)),
  }[shape.type];
  if (made) return made();
  const why = {
    cylinder: 'cannon-es has no cylinder but a prism', hull: 'this adapter gives cannon-es no hull, which it wants with its faces',
    mesh: 'cannon-es collides a mesh with spheres and planes alone',
  }[shape.type] ?? `cannon-es has no ${shape.type}`;
  throw new Unsupported(`Body '${name}': ${why}.`);
}

/** The quaternion that turns +z, the normal of cannon's planes, to the unit vector n. */
function turn_of_z(n) {
  if (n[0] === 0 && n[1] === 0 && n[2] === 1) return [1, 0, 0, 0];
  const least = [0, 1, 2].reduce((k, i) => (Math.abs(n[i]) < Math.abs(n[k]) ? i : k), 0);
  const along = cross(n, [0, 1, 2].map((i) => (i === least ? 1 : 0))), x = scale(1 / norm(along), along);
  return quaternion_of(x, cross(n, x), n);
}

// ---- A world ------------------------------------------------------------------------------------------

class World {
  constructor(scene, dt, values) {
    this.scene = scene, this.dt = dt, this.values = values, this.steps = 0;
    if (values['gyroscopic-torque'] === 'refused') this.left_out = new LeftOut(about.title, scene, 'stand-in');
    this.refuse_friction();
    this.world = new C.World({gravity: vec(scene.gravity), allowSleep: false});
    Object.assign(this.world.solver, {iterations: values.iterations, tolerance: values.tolerance});
    this.materials = this.add_materials();
    for (const plane of scene.planes) this.add_plane(plane);
    this.bodies = scene.bodies.map((body) => this.add_body(body));
    this.filter();
    for (const joint of scene.joints) this.add_joint(joint);
  }

  refuse_friction() {
    if (this.values.friction !== 'refused') return;
    for (const [, , {between, friction}] of this.scene.contacts.rows)
      if (friction > 0)
        throw new Unsupported(
          `cannon-es has no Coulomb friction: it bounds friction by mu times the weight, whatever the normal force, and '${between[0]}' and '${between[1]}' have ${friction}; path=stand-in gives it that.`);
  }

  /** One of cannon's materials for each kind of things that nothing tells apart, and the numbers of their pairs. */
  add_materials() {
    const {contacts} = this.scene, {values} = this, made = new Map([...contacts.kinds.keys()].map((kind) => [kind, new C.Material()]));
    for (const [a, b, {restitution, friction}] of contacts.rows)
      this.world.addContactMaterial(new C.ContactMaterial(made.get(a), made.get(b), {
        restitution, friction: values.friction === 'times-dt' ? friction * this.dt : friction,
        contactEquationStiffness: values['contact-stiffness'], contactEquationRelaxation: values['contact-relaxation'],
      }));
    return made;
  }

  enter(body, thing) {
    body.material = this.materials.get(this.scene.contacts.kind_of.get(thing)) ?? null;
    body.thing = thing;
    this.world.addBody(body);
    return body;
  }

  add_plane({normal, offset, index}) {
    const made = new C.Body({type: C.Body.STATIC, mass: 0, shape: new C.Plane(), position: vec(scale(offset, normal)), quaternion: turn(turn_of_z(normal))});
    this.enter(made, this.scene.bodies.length + index);
  }

  // cannon's inertia is diagonal: its axes are the principal ones, and shapes and orientation are turned by them.
  add_body(body) {
    const {axes, moments} = body.principal, back = conjugate(axes), {values} = this;
    const made = new C.Body({
      type: body.locked ? C.Body.STATIC : C.Body.DYNAMIC, mass: body.locked ? 0 : body.mass, position: vec(body.position),
      quaternion: turn(multiply(body.orientation, axes)), linearDamping: values['linear-damping'], angularDamping: values['angular-damping'],
    });
    if (body.touches) {
      const parts = body.shape.type === 'compound' ? body.shape.parts.filter((one) => one.shape) : [{shape: body.shape, position: [0, 0, 0], orientation: [1, 0, 0, 0]}];
      for (const part of parts)
        made.addShape(primitive(part.shape, body), vec(rotate(back, part.position)), turn(multiply(back, part.orientation)));
    }
    if (!body.locked) {
      made.velocity.copy(vec(body.velocity));
      made.angularVelocity.copy(vec(body.spin));
      made.inertia.copy(vec(moments));
      made.invInertia.copy(vec(moments.map((moment) => 1 / moment)));
      made.updateInertiaWorld(true);
    }
    return this.enter(made, body.index);
  }

  /** Asked for each pair of bodies before their shapes are looked at. */
  filter() {
    const {contacts} = this.scene, {broadphase} = this.world, own = broadphase.needBroadphaseCollision;
    const apart = new Set([...contacts.kept_apart()].map(([a, b]) => contacts.key(a, b)));
    if (apart.size === 0) return;
    broadphase.needBroadphaseCollision = (a, b) => !apart.has(contacts.key(a.thing, b.thing)) && own.call(broadphase, a, b);
  }

  add_joint(joint) {
    const {scene, values} = this, first = scene.bodies[joint.body], second = scene.bodies[joint.to], maxForce = values['joint-force'];
    if (first.locked && (!second || second.locked)) return;
    const a = this.bodies[joint.body], b = second ? this.bodies[joint.to] : this.ground(joint.point);
    const pivot = (body) => body.pointToLocalFrame(vec(joint.point)), axis = (body) => body.vectorToLocalFrame(vec(joint.axis));
    const make = {
      ball: () => new C.PointToPointConstraint(a, pivot(a), b, pivot(b), maxForce),
      hinge: () => new C.HingeConstraint(a, b, {pivotA: pivot(a), pivotB: pivot(b), axisA: axis(a), axisB: axis(b), maxForce}),
      fixed: () => new C.LockConstraint(a, b, {maxForce}),
      distance: () => new C.DistanceConstraint(a, b, joint.length, maxForce),
    }[kept(joint)];
    if (!make) throw new Unsupported(`cannon-es's adapter knows no joint '${joint.type}'.`);
    const made = make();
    if (values['joint-step'] === 'dt') for (const equation of made.equations) equation.setSpookParams(1e7, 4, this.dt);
    this.world.addConstraint(made);
  }

  /** The world as a body at a place, for joints. */
  ground(place) { return this.enter(new C.Body({type: C.Body.STATIC, mass: 0, position: vec(place)}), -1); }

  step() {
    this.world.step(this.dt);
    ++this.steps;
  }

  // The weight of a body that states its own gravity is taken back; its own is among the forces.
  push(i, force, torque) {
    const body = this.bodies[i], weight = this.scene.bodies[i].gravity ? scale(body.mass, this.scene.gravity) : [0, 0, 0];
    body.force.copy(vec(sub(force, weight)));
    body.torque.copy(vec(torque));
  }

  set_mass(i, mass) { Object.assign(this.bodies[i], {mass, invMass: 1 / mass}); }

  read(i) {
    const start = this.scene.bodies[i], body = this.bodies[i];
    if (start.locked) return {position: start.position, orientation: start.orientation, velocity: [0, 0, 0], spin: [0, 0, 0]};
    const state = {
      position: three(body.position), orientation: multiply(four(body.quaternion), conjugate(start.principal.axes)),
      velocity: three(body.velocity), spin: three(body.angularVelocity),
    };
    this.left_out?.see(start, state, this.steps);
    return state;
  }

  remarks() { return this.left_out?.remarks() ?? []; }

  free() {}
}
