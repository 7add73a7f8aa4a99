// The adapter of PhysX 5 (physx-js-webidl, WebAssembly, single precision): a prepared scene in, motion out.
// Knows nothing of the protocol.
import fs from 'node:fs';
import {createRequire} from 'node:module';
import init from 'physx-js-webidl';
import {Shapes, as_it_is, x_to_y} from './physx_shapes.mjs';
import {frame_of, held_coordinate, kept} from './joints.mjs';
import {conjugate, multiply, quaternion_of, rotate, scale, sub, turn_of_y} from './vectors.mjs';

const unlimited = 1e18;      // its square is finite in single precision
const gyroscopic = 1 << 10;  // PxRigidBodyFlag::eENABLE_GYROSCOPIC_FORCES, which the bindings' enum leaves out
const least_threshold = 1e-4;  // [m/s] PhysX takes no threshold of 0

export const about = {
  name: 'physx', title: 'PhysX', build: 'WebAssembly', native: 'native code of C++', precision: 'float',
  schemes: [{name: 'semi-implicit-euler', order: 1, conserves: 'linear momentum', adaptive: false}],
  gyroscopic: (values) => (values.gyro === 'on' ? 'explicit, of constant |L|' : 'none'),
  joints: {types: ['ball', 'hinge', 'fixed', 'distance', 'slider', 'cylindrical', 'planar', 'rectangular', 'universal'], limits: ['hinge', 'slider'],
    friction: ['hinge', 'slider']},
  of_the_scene: [
    {name: 'mass, inertia', value: 'of the scene', engine_default: 'of the shape and its density', reason: 'the scene has its own'},
    {name: 'restitution, friction', value: 'of the pair', engine_default: 'averages',
      reason: 'numbers of shapes whose least or largest is that of each pair (PxCombineMode eMIN or eMAX)'},
    {name: 'PxDistanceJoint tolerance', value: '0', engine_default: '0.025', reason: 'a distance of the scene is exact'},
    {name: 'collision filter', value: 'PassThroughFilterShader', engine_default: 'none',
      reason: 'pairs that groups and masks keep apart do not touch; nor do those that a joint ties'},
  ],
  unforceable: [
    'Contacts and joints are solved by sweeps, and keep an error.',
    'A bounce acts from a gap on that the step would close (at most twice contact-offset), in the step before the touch.',
    'Friction is that of patches: points of contact nearer than 2.5 cm share one (frictionCorrelationDistance), and act from a gap of 4 cm on (frictionOffsetThreshold). Other values of both, from 0 to 1 m, changed no digit of a box that slides (measured).',
    'One number of restitution and one of friction for each shape, combined by a rule: not every table of pairs can be had.',
    'A step runs on one thread; the build has no others.',
    'This adapter tells no forces of contacts and joints.',
  ],
  options: [
    {name: 'gyro', setting: 'eENABLE_GYROSCOPIC_FORCES (bit 10)', values: ['off', 'on'], engine_default: 'off',
      meaning: 'the gyroscopic torque, explicit, after which the size of the angular momentum is restored; the bindings have no name for it'},
    {name: 'solver', setting: 'solverType', values: ['pgs', 'tgs'], engine_default: 'pgs', meaning: 'projected Gauss-Seidel, or with substeps of its own (temporal)'},
    {name: 'linear-damping', setting: 'setLinearDamping', least: 0, most: 1e6, engine_default: 0, meaning: 'of velocities [1/s]'},
    {name: 'angular-damping', setting: 'setAngularDamping', least: 0, most: 1e6, engine_default: 0.05, meaning: 'of angular velocities [1/s]'},
    {name: 'max-speed', setting: 'setMaxLinearVelocity', least: 0, most: unlimited, above: true, engine_default: 1e16, meaning: 'cap of the speed [m/s]'},
    {name: 'max-spin', setting: 'setMaxAngularVelocity', least: 0, most: unlimited, above: true, engine_default: 100, meaning: 'cap of the angular speed [rad/s]'},
    {name: 'sleeping', setting: 'setSleepThreshold, setStabilizationThreshold', values: ['off', 'on'], engine_default: 'on',
      meaning: 'slow bodies are damped and taken out of the simulation; off: both thresholds are 0'},
    {name: 'restitution-threshold', setting: 'bounceThresholdVelocity', least: 0, most: 1e6, above: true, engine_default: 2,
      meaning: 'approach speed below which nothing bounces [m/s]'},
    {name: 'contact-offset', setting: 'setContactOffset', least: 0, most: 1e6, above: true, engine_default: 0.02,
      meaning: 'half the gap up to which contacts are found before they touch [m]'},
    {name: 'position-iterations', setting: 'setSolverIterationCounts, position', least: 1, most: 255, whole: true, engine_default: 4, meaning: 'sweeps of the position solver'},
    {name: 'velocity-iterations', setting: 'setSolverIterationCounts, velocity', least: 0, most: 255, whole: true, engine_default: 1, meaning: 'sweeps of the velocity solver'},
  ],
  paths: [
    {name: 'plain', summary: 'damping, the cap of spins and sleeping are off, the threshold of bounces is next to 0; the gyroscopic torque is on', set: {
      'gyro': ['on', 'bodies turn as they do'],
      'angular-damping': [0, 'the scene has no damping'],
      'max-speed': [unlimited, 'the scene has no cap'],
      'max-spin': [unlimited, 'the scene has no cap'],
      'sleeping': ['off', 'what moves slowly moves'],
      'restitution-threshold': [least_threshold, 'slow impacts bounce too; PhysX takes no 0'],
    }},
    {name: 'as-shipped', summary: 'every setting as PhysX has it by itself', set: {}},
  ],
};

/** Starts the module, which throws where it finds Node: `process` is hidden meanwhile, and there is a `window`. */
async function hidden_from_node(start) {
  const own = Object.getOwnPropertyDescriptor(globalThis, 'process');
  Object.defineProperty(globalThis, 'process', {value: undefined, configurable: true});
  globalThis.window = globalThis;
  try {
    return await start();
  } finally {
    Object.defineProperty(globalThis, 'process', own);
    delete globalThis.window;
  }
}

export async function start() {
  const require = createRequire(import.meta.url), file = require.resolve('physx-js-webidl');
  const {version} = JSON.parse(fs.readFileSync(file.replace(/[^/]*$/, 'package.json'), 'utf8'));
  const wasmBinary = fs.readFileSync(file.replace(/\.mjs$/, '.wasm'));
  const P = await hidden_from_node(() => init({wasmBinary, print: console.error, printErr: console.error}));
  const engine = new Engine(P);
  return {version, load: (scene, dt, values) => new World(engine, scene, dt, values), defaults: () => engine.defaults()};
}

/** What all worlds share. */
class Engine {
  constructor(P) {
    this.P = P;
    this.top = P.PxTopLevelFunctions.prototype;
    this.scale = new P.PxTolerancesScale();
    const foundation = this.top.CreateFoundation(P.PHYSICS_VERSION, new P.PxDefaultAllocator(), new P.PxDefaultErrorCallback());
    this.physics = this.top.CreatePhysics(P.PHYSICS_VERSION, foundation, this.scale);
    this.top.InitExtensions(this.physics);
    this.dispatcher = this.top.DefaultCpuDispatcherCreate(0);  // no threads of its own
    this.cooking = new P.PxCookingParams(this.scale);
  }

  /** A value of an enum of the bindings, which is 0 for names that they do not have. */
  value(type, name) {
    const value = this.P[type]?.[name];
    if (!Number.isInteger(value)) throw new Error(`The bindings have no ${type}.${name}.`);
    return value;
  }

  /** A temporary object of the bindings for `use`. */
  with(Type, numbers, use) {
    const made = new this.P[Type](...numbers);
    try {
      return use(made);
    } finally {
      this.P.destroy(made);
    }
  }

  vec3(v, use) { return this.with('PxVec3', v, use); }
  pose(position, [w, x, y, z], use) {
    return this.vec3(position, (p) => this.with('PxQuat', [x, y, z, w], (q) => this.with('PxTransform', [p, q], use)));
  }

  /** The engine's own values of the options, asked of itself; null where it does not tell. */
  defaults() {
    const {P} = this, desc = new P.PxSceneDesc(this.scale), body = this.pose([0, 0, 0], [1, 0, 0, 0], (at) => this.physics.createRigidDynamic(at));
    const material = this.physics.createMaterial(0, 0, 0), word = (on) => (on ? 'on' : 'off');
    const shape = this.with('PxSphereGeometry', [1], (ball) => this.physics.createShape(ball, material, true));
    const values = {
      'gyro': word(body.getRigidBodyFlags().isSet(gyroscopic)), 'solver': ['pgs', 'tgs'][desc.solverType], 'position-iterations': null, 'velocity-iterations': null,
      'linear-damping': body.getLinearDamping(), 'angular-damping': body.getAngularDamping(),
      'max-speed': body.getMaxLinearVelocity(), 'max-spin': body.getMaxAngularVelocity(),
      'sleeping': word(body.getSleepThreshold() > 0), 'restitution-threshold': desc.bounceThresholdVelocity, 'contact-offset': shape.getContactOffset(),
    };
    for (const made of [shape, body, material]) made.release();
    P.destroy(desc);
    return values;
  }
}

const largest = 1e30;  // of a limit that is none
const rigid = 1e10;    // of a drive's damper [N s/m]
const x_axis = (engine) => engine.value('PxD6AxisEnum', 'eX');
// The twist is about the x of the second end, which is `to`, and a swing about an axis of the first.
const free_axes = {slider: ['eX'], cylindrical: ['eX', 'eTWIST'], planar: ['eY', 'eZ', 'eTWIST'], rectangular: ['eY', 'eZ'], universal: ['eTWIST', 'eSWING2']};
function axes_of(joint) {
  const [x, y, z] = frame_of(joint);
  return joint.type === 'universal' ? [x, scale(-1, z), y] : [x, y, z];  // the swing is about its second axis
}

// ---- A world ------------------------------------------------------------------------------------------

class World {
  constructor(engine, scene, dt, values) {
    this.engine = engine, this.P = engine.P, this.scene = scene, this.dt = dt, this.values = values;
    const {contacts} = scene;
    this.restitution = contacts.of_things('restitution', about.title);
    this.friction = contacts.of_things('friction', about.title);
    this.apart = new Set([...contacts.kept_apart()].map(([a, b]) => contacts.key(a, b)));
    this.materials = new Map(), this.actors = [], this.joints = [];
    this.shapes = new Shapes(engine, values, this.apart.size > 0);
    this.vec = new this.P.PxVec3(0, 0, 0);  // for calls of a step
    this.make_scene();
    for (const plane of scene.planes) this.add_plane(plane);
    this.bodies = scene.bodies.map((body) => this.add_body(body));
    for (const joint of scene.joints) this.add_joint(joint);
  }

  v([x, y, z]) {
    this.vec.x = x, this.vec.y = y, this.vec.z = z;
    return this.vec;
  }

  make_scene() {
    const {engine, values} = this;
    this.px = engine.with('PxSceneDesc', [engine.scale], (desc) => {
      desc.gravity = this.v(this.scene.gravity);
      desc.cpuDispatcher = engine.dispatcher;
      desc.filterShader = engine.top.DefaultFilterShader();
      desc.solverType = engine.value('PxSolverTypeEnum', values.solver === 'tgs' ? 'eTGS' : 'ePGS');
      desc.bounceThresholdVelocity = values['restitution-threshold'];
      if (this.apart.size > 0) this.filter(desc);
      return engine.physics.createScene(desc);
    });
  }

  filter(desc) {
    const {P, engine, apart, scene} = this;
    const touch = engine.value('PxPairFlagEnum', 'eCONTACT_DEFAULT');
    const kill = engine.value('PxFilterFlagEnum', 'eKILL'), pass = engine.value('PxFilterFlagEnum', 'eDEFAULT');
    this.shader = new P.PassThroughFilterShaderImpl();
    this.shader.filterShader = (first, a, a1, a2, a3, second, b) => {
      this.shader.outputPairFlags = touch;
      return apart.has(scene.contacts.key(a, b)) ? kill : pass;
    };
    engine.top.setupPassThroughFilterShader(desc, this.shader);
  }

  material(thing) {
    const {P, engine} = this, numbers = [this.friction.of(thing), this.restitution.of(thing)], key = numbers.join();
    if (!this.materials.has(key)) {
      const made = engine.physics.createMaterial(numbers[0], numbers[0], numbers[1]), rules = {min: 'eMIN', max: 'eMAX'};
      made.setFrictionCombineMode(engine.value('PxCombineModeEnum', rules[this.friction.rule]));
      made.setRestitutionCombineMode(engine.value('PxCombineModeEnum', rules[this.restitution.rule]));
      this.materials.set(key, made);
    }
    return this.materials.get(key);
  }

  enter(actor) {
    this.actors.push(actor);
    this.px.addActor(actor);
  }

  // A plane of PhysX has its normal along x.
  add_plane({normal, offset, index}) {
    const {P, engine} = this, thing = this.scene.bodies.length + index;
    const turn = multiply(turn_of_y(normal), x_to_y);
    const actor = engine.pose(scale(offset, normal), turn, (pose) => engine.physics.createRigidStatic(pose));
    this.shapes.attach_one(actor, new P.PxPlaneGeometry(), as_it_is, this.material(thing), thing);
    this.enter(actor);
  }

  add_body(body) {
    const {engine} = this;
    const actor = engine.pose(body.position, body.orientation, (pose) =>
      (body.locked ? engine.physics.createRigidStatic(pose) : engine.physics.createRigidDynamic(pose)));
    if (body.touches) this.shapes.attach(actor, body, this.material(body.index), body.index);
    if (!body.locked) this.set_up(actor, body);
    this.enter(actor);
    if (!body.locked) {
      actor.setLinearVelocity(this.v(body.velocity));
      actor.setAngularVelocity(this.v(body.spin));
    }
    return actor;
  }

  set_up(actor, body) {
    const {engine, values} = this, {moments, axes} = body.principal;
    actor.setMass(body.mass);
    actor.setMassSpaceInertiaTensor(this.v(moments));
    engine.pose([0, 0, 0], axes, (pose) => actor.setCMassLocalPose(pose));
    actor.setRigidBodyFlag(gyroscopic, values.gyro === 'on');
    if (actor.getRigidBodyFlags().isSet(gyroscopic) !== (values.gyro === 'on')) throw new Error('PhysX does not keep bit 10, the gyroscopic torque.');
    actor.setActorFlag(engine.value('PxActorFlagEnum', 'eDISABLE_GRAVITY'), Boolean(body.gravity));  // its own is a force
    actor.setLinearDamping(values['linear-damping']);
    actor.setAngularDamping(values['angular-damping']);
    actor.setMaxLinearVelocity(values['max-speed']);
    actor.setMaxAngularVelocity(values['max-spin']);
    actor.setSolverIterationCounts(values['position-iterations'], values['velocity-iterations']);
    if (values.sleeping === 'on') return;
    actor.setSleepThreshold(0);
    actor.setStabilizationThreshold(0);
  }

  add_joint(joint) {
    const {engine, scene} = this, {top, physics} = engine, first = scene.bodies[joint.body], second = scene.bodies[joint.to];
    if (first.locked && (!second || second.locked)) return;
    const make = {ball: 'SphericalJointCreate', hinge: 'RevoluteJointCreate', fixed: 'FixedJointCreate', distance: 'DistanceJointCreate'}[kept(joint)] ?? 'D6JointCreate';
    const frame = joint.axis ? quaternion_of(...axes_of(joint)) : [1, 0, 0, 0];  // a hinge turns about x
    const ends = joint.type === 'distance' ? [first.position, second?.position ?? joint.point] : [joint.point, joint.point];
    const local = ({position, orientation}, place, use) =>
      engine.pose(rotate(conjugate(orientation), sub(place, position)), multiply(conjugate(orientation), frame), use);
    const made = local(first, ends[0], (a) => local(second ?? as_it_is, ends[1],
      (b) => top[make](physics, this.bodies[joint.body], a, second ? this.bodies[joint.to] : null, b)));
    if (joint.type === 'distance') this.keep_distance(made, joint.length);
    if (joint.type in free_axes)
      for (const axis of free_axes[joint.type]) made.setMotion(engine.value('PxD6AxisEnum', axis), engine.value('PxD6MotionEnum', 'eFREE'));
    this.hold(made, joint);
    this.joints.push(made);
  }

  // PhysX counts the second body against the first, which is `body`.  Friction is a drive at rest with a largest force.
  hold(made, joint) {
    const held = held_coordinate(joint, true), {engine, P} = this, slides = joint.type === 'slider';
    if (!held) return;
    if (held.limited)
      engine.with('PxSpring', [0, 0], (hard) => engine.with(slides ? 'PxJointLinearLimitPair' : 'PxJointAngularLimitPair',
        [Math.max(held.lower, -largest), Math.min(held.upper, largest), ...(slides ? [hard] : [])], (limits) => {
          if (slides) made.setMotion(x_axis(engine), engine.value('PxD6MotionEnum', 'eLIMITED')), made.setLinearLimit(x_axis(engine), limits);
          else made.setLimit(limits), made.setRevoluteJointFlag(engine.value('PxRevoluteJointFlagEnum', 'eLIMIT_ENABLED'), true);
        }));
    if (held.friction === 0) return;
    made.setConstraintFlag(engine.value('PxConstraintFlagEnum', 'eDRIVE_LIMITS_ARE_FORCES'), true);
    if (slides) engine.with('PxD6JointDrive', [0, rigid, held.friction, false], (drive) => made.setDrive(engine.value('PxD6DriveEnum', 'eX'), drive));
    else {
      made.setDriveVelocity(0);
      made.setDriveForceLimit(held.friction);
      made.setRevoluteJointFlag(engine.value('PxRevoluteJointFlagEnum', 'eDRIVE_ENABLED'), true);
    }
  }

  keep_distance(made, length) {
    made.setMinDistance(length);
    made.setMaxDistance(length);
    made.setTolerance(0);
    for (const flag of ['eMIN_DISTANCE_ENABLED', 'eMAX_DISTANCE_ENABLED']) made.setDistanceJointFlag(this.engine.value('PxDistanceJointFlagEnum', flag), true);
  }

  step() {
    if (!this.px.simulate(this.dt) || !this.px.fetchResults(true)) throw new Error('PhysX did not take the step.');
  }

  push(i, force, torque) {
    this.bodies[i].addForce(this.v(force));
    this.bodies[i].addTorque(this.v(torque));
  }

  set_mass(i, mass) { this.bodies[i].setMass(mass); }

  read(i) {
    const start = this.scene.bodies[i], actor = this.bodies[i];
    if (start.locked) return {position: start.position, orientation: start.orientation, velocity: [0, 0, 0], spin: [0, 0, 0]};
    const three = ({x, y, z}) => [x, y, z], {p, q} = actor.getGlobalPose();
    return {position: three(p), orientation: [q.w, q.x, q.y, q.z], velocity: three(actor.getLinearVelocity()), spin: three(actor.getAngularVelocity())};
  }

  free() {
    for (const made of [...this.joints, ...this.actors, this.px, ...this.materials.values()]) made.release();
    this.shapes.free();
    this.P.destroy(this.vec);
    if (this.shader) this.P.destroy(this.shader);
  }
}
