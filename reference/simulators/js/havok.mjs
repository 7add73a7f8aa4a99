// The adapter of Havok (@babylonjs/havok, WebAssembly, single precision): a prepared scene in, motion out.
// Knows nothing of the protocol.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import init from '@babylonjs/havok';
import {has_forces} from './forces.mjs';
import {frame_of, held_coordinate, kept} from './joints.mjs';
import {Unsupported} from './scene.mjs';
import {LeftOut, torque_option} from './torque.mjs';
import {conjugate, dot, norm, rotate, scale, sub, turn_of_y} from './vectors.mjs';

const unlimited = 1e18;  // its square is finite in single precision
const slow = 0.1;         // [m/s]
const longest_step = 2.58;  // ideal steps, of which more is cut off (measured: sqrt(20/3))
const plane_reach = 100, plane_depth = 10;  // [m]

export const about = {
  name: 'havok', title: 'Havok', build: 'WebAssembly', native: 'native code of C++', precision: 'float',
  schemes: [{name: 'semi-implicit-euler', order: 1, conserves: 'linear momentum', adaptive: false}],
  gyroscopic: () => 'none',
  substeps: ({'ideal-step': ideal}, dt) => (ideal === 0 ? 4 : Math.min(8, Math.ceil(4 * dt / ideal - 1e-6))),
  joints: {types: ['ball', 'hinge', 'fixed', 'distance', 'slider', 'cylindrical', 'planar', 'rectangular', 'universal'], limits: ['hinge', 'slider'],
    friction: ['hinge', 'slider']},
  of_the_scene: [
    {name: 'mass, inertia', value: 'of the scene, rounded', engine_default: 'of the shape and its density',
      reason: 'the scene has its own; the inertia is told for a mass of 1, in principal axes'},
    {name: 'restitution, friction', value: 'of the pair', engine_default: '0, larger; 0.5, smaller',
      reason: 'numbers of shapes whose least or largest is that of each pair (MaterialCombine.MINIMUM or MAXIMUM)'},
    {name: 'planes', value: `boxes ${2 * plane_reach} m wide and ${plane_depth} m deep`, engine_default: 'none', reason: 'Havok has no plane'},
    {name: 'collision filter', value: 'HP_Shape_SetFilterInfo', engine_default: 'all with all',
      reason: 'groups and masks of the scene as bits; bodies that a joint ties do not touch'},
  ],
  unforceable: [
    `A step is four substeps where ideal-step is 0, and else 4 dt/ideal-step, rounded up, at most 8: gravity acts in each (measured; no call sets or tells their number). Of a step longer than ${longest_step} ideal steps the rest is cut off, and a remark says it.`,
    'Inverse masses and inverse moments have about 8 bits: up to 0.4 % of each. HP_Body_GetMassProperties tells what was set, so the adapter measures what is held, by an impulse before the start, and a remark says it.',
    'There is no gyroscopic torque and no switch for it (HavokPhysics.d.ts has none; a free body keeps its angular velocity).',
    `A body slower than ${slow} m/s is braked, also where it never sleeps: at 0.09 m/s and without gravity by 0.3 m/s^2 (measured). No call sets it (HavokPhysics.d.ts).`,
    'There is no call for a force or a torque, but for impulses (HavokPhysics.d.ts).',
    `There is no plane but a box: it ends ${plane_reach} m from the foot of the normal through the origin. A sample that shows a body past its edge says so.`,
    'No call sets iterations, contact margins, convex radii, thresholds of restitution or tolerances.',
    'Joints are solved by sweeps, and keep an error.',
    'One number of restitution and one of friction for each shape, combined by a rule: not every table of pairs can be had.',
    'A step runs on one thread. The module is closed: what it does is known by its interface and by measurement.',
    'This adapter tells no forces of contacts and joints.',
  ],
  options: [
    {name: 'forces', setting: 'forces of a scene', values: ['refused', 'impulses'], engine_default: 'refused',
      meaning: 'refused: springs, drag and the like are unsupported, as Havok has no force; impulses: F dt before each step'},
    torque_option,
    {name: 'linear-damping', setting: 'HP_Body_SetLinearDamping', least: 0, most: 1e6, engine_default: 0, meaning: 'of velocities [1/s]'},
    {name: 'angular-damping', setting: 'HP_Body_SetAngularDamping', least: 0, most: 1e6, engine_default: 0.1, meaning: 'of angular velocities [1/s]'},
    {name: 'max-speed', setting: 'HP_World_SetSpeedLimit, linear', least: 0, most: unlimited, above: true, engine_default: 200, meaning: 'cap of the speed [m/s]'},
    {name: 'max-spin', setting: 'HP_World_SetSpeedLimit, angular', least: 0, most: unlimited, above: true, engine_default: 100,
      meaning: 'cap of the angular speed [rad/s]'},
    {name: 'ideal-step', setting: 'HP_World_SetIdealStepTime', least: 0, most: 1e6, engine_default: 1 / 60,
      meaning: 'step for which the stiffness of the solver is meant; it is changed for others, but not where this is 0 [s]'},
    {name: 'sleeping', setting: 'HP_Body_SetActivationControl', values: ['off', 'on'], engine_default: 'on', meaning: 'slow bodies are taken out of the simulation'},
  ],
  paths: [],
};
const plain = {
  'forces': ['refused', 'Havok has no call for a force'],
  'gyroscopic-torque': ['refused', 'Havok has none'],
  'angular-damping': [0, 'the scene has no damping'],
  'max-speed': [unlimited, 'the scene has no cap'],
  'max-spin': [unlimited, 'the scene has no cap'],
  'ideal-step': [0, 'the solver is the same at every step'],
  'sleeping': ['off', 'what moves slowly moves'],
};
about.paths.push(
  {name: 'plain', summary: 'damping, caps of speed, sleeping and the change of the solver with the step are off; what Havok has no concept of is refused', set: plain},
  {name: 'stand-in', summary: 'as plain; forces are impulses F dt before each step, and the gyroscopic torque is left out', set: {...plain,
    'forces': ['impulses', 'a stand-in: Havok has no call for a force'],
    'gyroscopic-torque': ['left-out', 'a stand-in: Havok has none'],
  }},
  {name: 'as-shipped', summary: 'every setting as Havok has it by itself', set: {}});

export async function start() {
  const require = createRequire(import.meta.url), folder = require.resolve('@babylonjs/havok').replace(/lib\/.*$/, '');
  const {version} = JSON.parse(fs.readFileSync(`${folder}package.json`, 'utf8'));
  const wasmBinary = fs.readFileSync(`${folder}lib/esm/HavokPhysics.wasm`);  // by itself it asks fetch, which has no files
  const H = await init({wasmBinary, print: console.error, printErr: console.error});
  return {version, load: (scene, dt, values) => new World(H, scene, dt, values), defaults: () => defaults(H)};
}

/** What a call gives; throws where it says that it failed. */
function got(H, answer) {
  const [result, value] = Array.isArray(answer) ? answer : [answer];
  if (result !== H.Result.RESULT_OK) throw new Error(`Havok says ${Object.keys(H.Result).find((key) => H.Result[key] === result) ?? 'that a call failed'}.`);
  return value;
}

/** The engine's own values of the options, asked of itself; null where it does not tell. */
function defaults(H) {
  const world = got(H, H.HP_World_Create()), body = got(H, H.HP_Body_Create());
  const [, speed, spin] = H.HP_World_GetSpeedLimit(world);
  const values = {
    'forces': null, 'gyroscopic-torque': null, 'ideal-step': null, 'sleeping': null, 'max-speed': speed, 'max-spin': spin,
    'linear-damping': got(H, H.HP_Body_GetLinearDamping(body)), 'angular-damping': got(H, H.HP_Body_GetAngularDamping(body)),
  };
  H.HP_Body_Release(body);
  H.HP_World_Release(world);
  return values;
}

const xyzw = ([w, x, y, z]) => [x, y, z, w];
const nowhere = [NaN, NaN, NaN];
const origin = {position: [0, 0, 0], orientation: [1, 0, 0, 0]};

// ---- Shapes -------------------------------------------------------------------------------------------

class Shapes {
  constructor(H) { this.H = H, this.made = []; }

  keep(answer, name) {
    const [result, shape] = answer;
    if (result !== this.H.Result.RESULT_OK) throw new Unsupported(`Body '${name}': Havok makes no shape of it.`);
    this.made.push(shape);
    return shape;
  }

  /** Calls `use` with the place in memory of numbers, as floats or as whole numbers. */
  at(numbers, Type, use) {
    const {H} = this, place = H._malloc(4 * numbers.length);
    new Type(H.HEAPU8.buffer, place, numbers.length).set(numbers);
    try {
      return use(place);
    } finally {
      H._free(place);
    }
  }

  primitive(shape, {name, locked}) {
    const {H} = this, half = [0, shape.length / 2, 0];
    const made = {
      sphere: () => H.HP_Shape_CreateSphere([0, 0, 0], shape.radius),
      box: () => H.HP_Shape_CreateBox([0, 0, 0], [0, 0, 0, 1], scale(2, shape.half_extents)),
      capsule: () => H.HP_Shape_CreateCapsule(scale(-1, half), half, shape.radius),
      cylinder: () => H.HP_Shape_CreateCylinder(scale(-1, half), half, shape.radius),
      hull: () => this.at(shape.vertices.flat(), Float32Array, (place) => H.HP_Shape_CreateConvexHull(place, shape.vertices.length)),
      mesh: () => {
        if (!locked) throw new Unsupported(`Body '${name}': Havok collides a mesh as a surface, not as a solid; here only where it does not move.`);
        return this.at(shape.vertices.flat(), Float32Array, (points) => this.at(shape.faces.flat(), Int32Array,
          (faces) => H.HP_Shape_CreateMesh(points, shape.vertices.length, faces, shape.faces.length)));
      },
    }[shape.type];
    if (!made) throw new Unsupported(`Body '${name}': Havok has no ${shape.type}.`);
    return this.keep(made(), name);
  }

  /** Of a body, and all that are to have its material and filter. */
  of(body) {
    if (body.shape.type !== 'compound') return [this.primitive(body.shape, body)];
    const {H} = this, whole = this.keep(H.HP_Shape_CreateContainer(), body.name);
    const parts = body.shape.parts.filter((part) => part.shape);
    const made = parts.map((part) => this.primitive(part.shape, body));
    made.forEach((shape, i) => got(H, H.HP_Shape_AddChild(whole, shape, [parts[i].position, xyzw(parts[i].orientation), [1, 1, 1]])));
    return [whole, ...made];
  }

  free() { for (const shape of this.made.reverse()) this.H.HP_Shape_Release(shape); }
}

/** Groups and masks of a scene as the 32 bits of Havok's filters. */
class Filters {
  constructor(contacts) {
    const names = new Set(contacts.things.flatMap((thing) => [...thing.groups, ...(thing.mask ?? [])]));
    if (names.size > 32) throw new Unsupported(`Havok tells 32 collision groups apart; the scene has ${names.size}.`);
    this.bit = new Map([...names].map((name, k) => [name, k]));
    this.of_thing = new Map(contacts.things.map((thing) => [thing.id, [this.bits(thing.groups), thing.mask ? this.bits(thing.mask) : -1]]));
  }
  bits(names) { return [...names].reduce((bits, name) => bits | (1 << this.bit.get(name)), 0); }
}

// ---- A world ------------------------------------------------------------------------------------------

class World {
  constructor(H, scene, dt, values) {
    this.H = H, this.scene = scene, this.dt = dt, this.values = values, this.steps = 0;
    this.refuse(values);
    const {contacts} = scene;
    this.restitution = contacts.of_things('restitution', about.title);
    this.friction = contacts.of_things('friction', about.title);
    this.filters = new Filters(contacts);
    this.shapes = new Shapes(H);
    this.world = got(H, H.HP_World_Create());
    this.all = [], this.constraints = [], this.past = new Map(), this.lost = new Map();  // remarks, by bodies
    try {
      this.build();
    } catch (error) {
      this.free();
      throw error;
    }
  }

  refuse(values) {
    if (values['gyroscopic-torque'] === 'refused') this.left_out = new LeftOut(about.title, this.scene, 'stand-in');
    if (values.forces === 'impulses' || !has_forces(this.scene)) return;
    throw new Unsupported(
      'Havok has no call for a force, and the scene has springs, drag, thrust, drive, attraction, water, a gravity of a body or a turning frame; path=stand-in gives Havok F dt as an impulse before each step.');
  }

  build() {
    const {H, scene, values} = this;
    got(H, H.HP_World_SetGravity(this.world, scene.gravity));
    got(H, H.HP_World_SetSpeedLimit(this.world, values['max-speed'], values['max-spin']));
    got(H, H.HP_World_SetIdealStepTime(this.world, values['ideal-step']));
    for (const plane of scene.planes) this.add_plane(plane);
    this.bodies = scene.bodies.map((body) => this.add_body(body));
    this.rounded = this.read_back_masses();
    for (const joint of scene.joints) this.add_joint(joint);
    for (const body of scene.bodies) if (!body.locked) this.set_motion(body);
  }

  /** A body at a place, with shapes where it has some, in the world. */
  add(place, type, shapes, thing) {
    const {H} = this, made = got(H, H.HP_Body_Create());
    this.all.push(made);
    got(H, H.HP_Body_SetMotionType(made, type));
    const [restitution, friction] = [this.restitution, this.friction].map((quantity) => quantity.of(thing));
    const rules = {min: H.MaterialCombine.MINIMUM, max: H.MaterialCombine.MAXIMUM};
    for (const shape of shapes) {
      if (shapes.length > 1 && shape === shapes[0]) continue;  // a container has neither: RESULT_NOTIMPLEMENTED
      got(H, H.HP_Shape_SetMaterial(shape, [friction, friction, restitution, rules[this.friction.rule], rules[this.restitution.rule]]));
      got(H, H.HP_Shape_SetFilterInfo(shape, this.filters.of_thing.get(thing)));
    }
    if (shapes.length > 0) got(H, H.HP_Body_SetShape(made, shapes[0]));
    got(H, H.HP_Body_SetQTransform(made, [place.position, xyzw(place.orientation)]));
    return made;
  }

  enter(made) { got(this.H, this.H.HP_World_AddBody(this.world, made, false)); }

  add_plane(plane) {
    const {H} = this;
    const box = this.shapes.keep(H.HP_Shape_CreateBox([0, -plane_depth / 2, 0], [0, 0, 0, 1], [2 * plane_reach, plane_depth, 2 * plane_reach]), plane.name);
    this.enter(this.add({position: scale(plane.offset, plane.normal), orientation: turn_of_y(plane.normal)}, H.MotionType.STATIC, [box],
      this.scene.bodies.length + plane.index));
  }

  add_body(body) {
    const {H, values} = this;
    const made = this.add(body, body.locked ? H.MotionType.STATIC : H.MotionType.DYNAMIC, body.touches ? this.shapes.of(body) : [], body.index);
    if (!body.locked) {
      this.give_mass(made, body, body.mass);
      got(H, H.HP_Body_SetLinearDamping(made, values['linear-damping']));
      got(H, H.HP_Body_SetAngularDamping(made, values['angular-damping']));
      got(H, H.HP_Body_SetGravityFactor(made, body.gravity ? 0 : 1));  // its own is a force
      got(H, H.HP_Body_SetActivationControl(made, values.sleeping === 'off' ? H.ActivationControl.ALWAYS_ACTIVE : H.ActivationControl.SIMULATION_CONTROLLED));
    }
    this.enter(made);
    return made;
  }

  // The inertia is told for a mass of 1.
  give_mass(made, body, mass) {
    const {moments, axes} = body.principal;
    got(this.H, this.H.HP_Body_SetMassProperties(made, [[0, 0, 0], mass, scale(1 / mass, moments), xyzw(axes)]));
  }

  set_motion(body) {
    const {H} = this, made = this.bodies[body.index];
    got(H, H.HP_Body_SetLinearVelocity(made, body.velocity));
    got(H, H.HP_Body_SetAngularVelocity(made, body.spin));
  }

  /** The mass or moment that is held with the largest error, as a remark: by what an impulse m or I does to a body at rest. */
  read_back_masses() {
    const {H, scene} = this;
    let worst = {error: 1e-6};
    const see = (body, what, value, reached) => {
      const error = Math.abs(reached - 1);
      if (error > worst.error) worst = {error, what, value, held: value / reached, name: body.name};
    };
    for (const body of scene.bodies) {
      if (body.locked) continue;
      const made = this.bodies[body.index], {moments, axes} = body.principal;
      this.rest(made);
      got(H, H.HP_Body_ApplyImpulse(made, body.position, [body.mass, 0, 0]));
      see(body, 'mass', body.mass, got(H, H.HP_Body_GetLinearVelocity(made))[0]);
      moments.forEach((moment, k) => {
        const axis = rotate(body.orientation, rotate(axes, [0, 1, 2].map((i) => (i === k ? 1 : 0))));
        this.rest(made);
        got(H, H.HP_Body_ApplyAngularImpulse(made, scale(moment, axis)));
        see(body, 'principal moment', moment, norm(got(H, H.HP_Body_GetAngularVelocity(made))));
      });
      this.rest(made);
    }
    const {name, what, value, held, error} = worst, unit = what === 'mass' ? 'kg' : 'kg m^2';
    return name && `'${name}': Havok rounds inverse masses and moments to about 8 bits; its ${what} of ${value} ${unit} is held as ${held.toPrecision(6)} ${unit}, ${(100 * error).toPrecision(2)} % off.`;
  }

  rest(made) {
    got(this.H, this.H.HP_Body_SetLinearVelocity(made, [0, 0, 0]));
    got(this.H, this.H.HP_Body_SetAngularVelocity(made, [0, 0, 0]));
  }

  add_joint(joint) {
    const {H, scene} = this, first = scene.bodies[joint.body], second = scene.bodies[joint.to];
    if (first.locked && (!second || second.locked)) return;
    const A = H.ConstraintAxis, linear = [A.LINEAR_X, A.LINEAR_Y, A.LINEAR_Z], angular = [A.ANGULAR_X, A.ANGULAR_Y, A.ANGULAR_Z];
    const locked = {
      ball: linear, hinge: [...linear, A.ANGULAR_Y, A.ANGULAR_Z], fixed: [...linear, ...angular],
      slider: [A.LINEAR_Y, A.LINEAR_Z, ...angular], cylindrical: [A.LINEAR_Y, A.LINEAR_Z, A.ANGULAR_Y, A.ANGULAR_Z],
      planar: [A.LINEAR_X, A.ANGULAR_Y, A.ANGULAR_Z], universal: [...linear, A.ANGULAR_Z],
      rectangular: [A.LINEAR_X, ...angular], distance: [],
    }[kept(joint)];
    const made = got(H, H.HP_Constraint_Create());
    this.constraints.push(made);
    const axes = joint.axis ? frame_of(joint) : [[1, 0, 0], [0, 1, 0]];
    const [x, y] = joint.type === 'universal' ? [axes[1], axes[0]] : axes;  // Havok turns about x last (measured)
    const turned = (body, v) => rotate(conjugate(body.orientation), v);
    const anchor = (body, place) => [turned(body, sub(place, body.position)), turned(body, x), turned(body, y)];
    got(H, H.HP_Constraint_SetParentBody(made, second ? this.bodies[joint.to] : this.ground()));
    got(H, H.HP_Constraint_SetChildBody(made, this.bodies[joint.body]));
    const ends = joint.type === 'distance' ? [second?.position ?? joint.point, first.position] : [joint.point, joint.point];
    got(H, H.HP_Constraint_SetAnchorInParent(made, ...anchor(second ?? origin, ends[0])));
    got(H, H.HP_Constraint_SetAnchorInChild(made, ...anchor(first, ends[1])));
    if (joint.type === 'distance') this.keep_distance(made, joint.length);
    for (const axis of locked) got(H, H.HP_Constraint_SetAxisMode(made, axis, H.ConstraintAxisLimitMode.LOCKED));
    this.hold(made, joint);
    got(H, H.HP_Constraint_SetEnabled(made, 1));
  }

  // SetAxisMode answers RESULT_INVALIDARGS to this axis and sets the mode all the same, as GetAxisMode tells.
  keep_distance(made, length) {
    const {H} = this, axis = H.ConstraintAxis.LINEAR_DISTANCE, mode = H.ConstraintAxisLimitMode.LIMITED;
    H.HP_Constraint_SetAxisMode(made, axis, mode);
    if (H.HP_Constraint_GetAxisMode(made, axis)[1] !== mode) throw new Unsupported('Havok takes no limit of LINEAR_DISTANCE: it keeps no distance.');
    got(H, H.HP_Constraint_SetAxisMinLimit(made, axis, length));
    got(H, H.HP_Constraint_SetAxisMaxLimit(made, axis, length));
  }

  // Havok counts the child, which is `body`, against its parent.
  hold(made, joint) {
    const held = held_coordinate(joint), {H} = this;
    if (!held) return;
    const axis = joint.type === 'slider' ? H.ConstraintAxis.LINEAR_X : H.ConstraintAxis.ANGULAR_X;
    if (held.limited) {
      got(H, H.HP_Constraint_SetAxisMode(made, axis, H.ConstraintAxisLimitMode.LIMITED));
      if (held.lower > -Infinity) got(H, H.HP_Constraint_SetAxisMinLimit(made, axis, held.lower));
      if (held.upper < Infinity) got(H, H.HP_Constraint_SetAxisMaxLimit(made, axis, held.upper));
    }
    if (held.friction !== 0) got(H, H.HP_Constraint_SetAxisFriction(made, axis, held.friction));
  }

  /** The world as a body, for joints. */
  ground() {
    if (!this.still) this.enter(this.still = this.add(origin, this.H.MotionType.STATIC, [], -1));
    return this.still;
  }

  step() {
    got(this.H, this.H.HP_World_Step(this.world, this.dt));
    ++this.steps;
  }

  // Havok takes no impulse that is not finite (RESULT_INVALIDARGS): the state that it stands for is not finite either.
  push(i, force, torque) {
    const {H, dt} = this, body = this.bodies[i];
    if (![...force, ...torque].every((x) => Number.isFinite(Math.fround(x)))) return this.lose(i);
    got(H, H.HP_Body_ApplyImpulse(body, got(H, H.HP_Body_GetQTransform(body))[0], scale(dt, force)));
    got(H, H.HP_Body_ApplyAngularImpulse(body, scale(dt, torque)));
  }

  lose(i) {
    const {name} = this.scene.bodies[i];
    if (!this.lost.has(i)) this.lost.set(i, `'${name}', step ${this.steps + 1}: a force on it is not finite, which Havok refuses; its states from then on are shown as not finite.`);
  }

  set_mass(i, mass) { this.give_mass(this.bodies[i], this.scene.bodies[i], mass); }

  read(i) {
    const {H} = this, start = this.scene.bodies[i], body = this.bodies[i];
    if (start.locked) return {position: start.position, orientation: start.orientation, velocity: [0, 0, 0], spin: [0, 0, 0]};
    if (this.lost.has(i)) return {position: nowhere, orientation: [NaN, NaN, NaN, NaN], velocity: nowhere, spin: nowhere};
    const [position, [x, y, z, w]] = got(H, H.HP_Body_GetQTransform(body));
    const state = {position, orientation: [w, x, y, z], velocity: got(H, H.HP_Body_GetLinearVelocity(body)), spin: got(H, H.HP_Body_GetAngularVelocity(body))};
    this.left_out?.see(start, state, this.steps);
    if (start.touches) this.see_edge(start, position);
    return state;
  }

  /** Past the edge of a box that stands for a plane there is no plane. */
  see_edge({name}, position) {
    for (const {normal, name: plane} of this.scene.planes)
      if (!this.past.has(name) && norm(sub(position, scale(dot(position, normal), normal))) > plane_reach)
        this.past.set(name, `'${name}', step ${this.steps}: it is past the edge of the box that stands for '${plane}'.`);
  }

  /** Bodies move for a part of a long step alone. */
  cut() {
    const most = longest_step * this.values['ideal-step'];
    return most > 0 && this.dt > most ? [`In a step of ${this.dt} s Havok moves bodies for ${most.toPrecision(3)} s: what is longer than ${longest_step} ideal steps is cut off.`] : [];
  }

  remarks() { return [...this.cut(), ...this.lost.values(), ...this.past.values(), ...(this.rounded ? [this.rounded] : []), ...(this.left_out?.remarks() ?? [])]; }

  free() {
    const {H} = this;
    for (const made of this.constraints) H.HP_Constraint_Release(made);
    for (const made of this.all) {
      H.HP_World_RemoveBody(this.world, made);
      H.HP_Body_Release(made);
    }
    this.shapes.free();
    H.HP_World_Release(this.world);
  }
}
