// The adapter of crashcat (JavaScript, double precision): a prepared scene in, motion out.
// Knows nothing of the protocol.
import fs from 'node:fs';
import * as C from 'crashcat';
import {frame_of, held_coordinate, kept} from './joints.mjs';
import {Unsupported} from './scene.mjs';
import {across, scale} from './vectors.mjs';

const unlimited = 1e100;  // its square is finite
const plane_extent = 1e4;  // [m]

export const about = {
  name: 'crashcat', title: 'crashcat', build: 'JavaScript', precision: 'double',
  schemes: [{name: 'semi-implicit-euler', order: 1, conserves: 'linear momentum', adaptive: false}],
  gyroscopic: (values) => (values.gyro === 'on' ? 'explicit, of constant |L|' : 'none'),
  joints: {types: ['ball', 'hinge', 'fixed', 'distance', 'slider', 'cylindrical', 'planar', 'rectangular', 'universal'], limits: ['hinge', 'slider'],
    friction: ['hinge', 'slider']},
  of_the_scene: [
    {name: 'mass, inertia', value: 'of the scene', engine_default: 'of the shape and its density',
      reason: 'the scene has its own: invMass, invInertiaDiagonal and inertiaRotation of MotionProperties'},
    {name: 'restitution, friction', value: 'of the pair', engine_default: 'the larger; the geometric mean',
      reason: 'all bodies have the same number where all pairs do; else a listener sets those of the pair'},
    {name: 'collision filter', value: 'onBodyPairValidate', engine_default: 'none',
      reason: 'pairs that a joint ties, or that groups and masks keep apart, do not touch'},
  ],
  unforceable: [
    'updateWorld has no gyroscopic torque: with gyro=on the adapter calls the function that crashcat has for it before each step.',
    'A bounce acts from a gap on that the step would close (at most speculative-distance), in the step before the touch.',
    'A plane is bounded: it ends 10 km from the foot of the normal through the origin.',
    'Joints keep an error that the sweeps of the position solver leave (position-steps, baumgarte).',
    'A body that turns by less than 1e-6 rad in a step keeps its orientation, and so do corrections of joints by less (addRotationStep).',
    'A step runs on one thread.',
    'This adapter tells no forces of contacts and joints.',
  ],
  options: [
    {name: 'gyro', setting: 'motionProperties.applyGyroscopicForce', values: ['off', 'on'], engine_default: 'off',
      meaning: 'the gyroscopic torque, explicit, after which the size of the angular momentum is restored; called before each step'},
    {name: 'convex-radius', setting: 'convexRadius', least: 0, most: 1e6, engine_default: 0.05,
      meaning: 'radius to which edges and corners of boxes, cylinders and hulls are rounded; less of a small shape [m]'},
    {name: 'linear-damping', setting: 'linearDamping', least: 0, most: 1e6, engine_default: 0.05, meaning: 'of velocities [1/s]'},
    {name: 'angular-damping', setting: 'angularDamping', least: 0, most: 1e6, engine_default: 0.05, meaning: 'of angular velocities [1/s]'},
    {name: 'max-speed', setting: 'maxLinearVelocity', least: 0, most: unlimited, above: true, engine_default: 500, meaning: 'cap of the speed [m/s]'},
    {name: 'max-spin', setting: 'maxAngularVelocity', least: 0, most: unlimited, above: true, engine_default: 47.12388980384689,
      meaning: 'cap of the angular speed [rad/s]'},
    {name: 'sleeping', setting: 'allowSleeping', values: ['off', 'on'], engine_default: 'on', meaning: 'slow bodies are taken out of the simulation'},
    {name: 'restitution-threshold', setting: 'minVelocityForRestitution', least: 0, most: 1e6, engine_default: 1,
      meaning: 'approach speed below which nothing bounces [m/s]'},
    {name: 'speculative-distance', setting: 'speculativeContactDistance', least: 0, most: 1e6, engine_default: 0.02,
      meaning: 'gap up to which contacts are found before they touch [m]'},
    {name: 'slop', setting: 'penetrationSlop', least: 0, most: 1e6, engine_default: 0.02, meaning: 'penetration that is left as it is [m]'},
    {name: 'baumgarte', setting: 'baumgarteFactor', least: 0, most: 1, engine_default: 0.2, meaning: 'share of an error of position that a sweep corrects'},
    {name: 'velocity-steps', setting: 'velocityIterations', least: 1, most: 255, whole: true, engine_default: 10, meaning: 'sweeps of the velocity solver'},
    {name: 'position-steps', setting: 'positionIterations', least: 0, most: 255, whole: true, engine_default: 2, meaning: 'sweeps of the position solver'},
    {name: 'pair-cache', setting: 'useBodyPairContactCache', values: ['off', 'on'], engine_default: 'on',
      meaning: 'a pair that moved by less than 1 mm and 2 degrees keeps what was found of it'},
    {name: 'warm-start', setting: 'warmStarting', values: ['off', 'on'], engine_default: 'on', meaning: 'the velocity solver starts from the last impulses'},
  ],
  paths: [
    {name: 'plain', summary: 'damping, caps of speed, thresholds and sleeping are off; the gyroscopic torque is on', set: {
      'gyro': ['on', 'bodies turn as they do'],
      'convex-radius': [0, 'edges and corners of the scene are sharp'],
      'linear-damping': [0, 'the scene has no damping'],
      'angular-damping': [0, 'the scene has no damping'],
      'max-speed': [unlimited, 'the scene has no cap'],
      'max-spin': [unlimited, 'the scene has no cap'],
      'sleeping': ['off', 'what moves slowly moves'],
      'restitution-threshold': [0, 'slow impacts bounce too'],
    }},
    {name: 'as-shipped', summary: 'every setting as crashcat has it by itself', set: {}},
  ],
};

const is_on = (word) => word === 'on';
const xyzw = ([w, x, y, z]) => [x, y, z, w];

export async function start() {
  const {version} = JSON.parse(fs.readFileSync(new URL('node_modules/crashcat/package.json', import.meta.url), 'utf8'));
  C.registerAll();
  return {version, load: (scene, dt, values) => new World(scene, dt, values), defaults};
}

/** The engine's own values of the options, asked of itself; null where it does not tell. */
function defaults() {
  const {narrowphase, solver, sleeping} = C.createWorldSettings(), word = (on) => (on ? 'on' : 'off');
  const world = C.createWorld(layered(C.createWorldSettings()).settings);
  const body = C.rigidBody.create(world, {shape: C.sphere.create({radius: 1}), objectLayer: 0, motionType: C.MotionType.DYNAMIC}).motionProperties;
  return {
    'gyro': null, 'convex-radius': C.box.create({halfExtents: [1, 1, 1]}).convexRadius,
    'linear-damping': body.linearDamping, 'angular-damping': body.angularDamping, 'max-speed': body.maxLinearVelocity, 'max-spin': body.maxAngularVelocity,
    'sleeping': word(sleeping.allowSleeping), 'restitution-threshold': solver.minVelocityForRestitution,
    'speculative-distance': narrowphase.speculativeContactDistance, 'slop': solver.penetrationSlop, 'baumgarte': solver.baumgarteFactor,
    'velocity-steps': solver.velocityIterations, 'position-steps': solver.positionIterations,
    'pair-cache': word(narrowphase.useBodyPairContactCache), 'warm-start': word(solver.warmStarting),
  };
}

/** Layers of what stands still, moves, and touches nothing. */
function layered(settings) {
  const broad = C.addBroadphaseLayer(settings);
  const [still, moving, ghost] = [0, 1, 2].map(() => C.addObjectLayer(settings, broad));
  for (const layer of [still, moving, ghost])
    for (const other of [still, moving, ghost]) C.disableCollision(settings, layer, other);
  C.enableCollision(settings, still, moving);
  C.enableCollision(settings, moving, moving);
  return {settings, still, moving, ghost};
}

// ---- Shapes -------------------------------------------------------------------------------------------

function primitive(shape, {name, locked}, convexRadius) {
  const made = {
    sphere: () => C.sphere.create({radius: shape.radius}),
    box: () => C.box.create({halfExtents: [...shape.half_extents], convexRadius}),
    capsule: () => C.capsule.create({halfHeightOfCylinder: shape.length / 2, radius: shape.radius}),
    cylinder: () => C.cylinder.create({halfHeight: shape.length / 2, radius: shape.radius, convexRadius}),
    hull: () => C.convexHull.create({positions: shape.vertices.flat(), convexRadius, hullTolerance: 0}),
    mesh: () => {
      if (!locked) throw new Unsupported(`Body '${name}': crashcat collides a mesh only where it does not move.`);
      return C.triangleMesh.create({positions: shape.vertices.flat(), indices: shape.faces.flat()});
    },
  }[shape.type];
  if (!made) throw new Unsupported(`Body '${name}': crashcat has no ${shape.type}.`);
  return made();
}

/** Of a body, with its centre of mass where the scene has it: crashcat's is that of the shape. */
function shape_of(body, convex_radius) {
  if (!body.touches) return null;
  const part = (shape) => primitive(shape, body, convex_radius);
  const made = body.shape.type !== 'compound' ? part(body.shape) : C.staticCompound.create({
    children: body.shape.parts.filter((one) => one.shape)
      .map((one) => ({shape: part(one.shape), position: [...one.position], quaternion: xyzw(one.orientation)}))});
  const off = made.centerOfMass.map((x) => -x);
  return body.locked || off.every((x) => x === 0) ? made : C.offsetCenterOfMass.create({shape: made, offset: off});
}

// ---- A world ------------------------------------------------------------------------------------------

// crashcat counts the second body against the first, which is `body`.
function hold(joint, friction) {
  const held = held_coordinate(joint, true);
  return held && {...(held.limited ? {limitsMin: held.lower, limitsMax: held.upper} : {}), [`maxFriction${friction}`]: held.friction};
}

class World {
  constructor(scene, dt, values) {
    this.scene = scene, this.dt = dt, this.values = values;
    this.layers = layered(this.settings());
    this.world = C.createWorld(this.layers.settings);
    const {contacts} = scene;
    this.restitution = contacts.uniform('restitution'), this.friction = contacts.uniform('friction');
    this.listener = this.listen();
    this.planes = scene.planes.map((plane) => this.add_plane(plane));
    this.bodies = scene.bodies.map((body) => this.add_body(body));
    this.turning = is_on(values.gyro) ? this.bodies.filter((_, i) => !scene.bodies[i].locked) : [];
    for (const joint of scene.joints) this.add_joint(joint);
  }

  settings() {
    const settings = C.createWorldSettings(), {values} = this;
    settings.gravity = [...this.scene.gravity];
    Object.assign(settings.narrowphase, {speculativeContactDistance: values['speculative-distance'], useBodyPairContactCache: is_on(values['pair-cache'])});
    Object.assign(settings.solver, {
      minVelocityForRestitution: values['restitution-threshold'], velocityIterations: values['velocity-steps'], positionIterations: values['position-steps'],
      warmStarting: is_on(values['warm-start']), penetrationSlop: values.slop, baumgarteFactor: values.baumgarte});
    settings.sleeping.allowSleeping = is_on(values.sleeping);
    return settings;
  }

  /** Who touches whom and, where pairs differ, with what material. */
  listen() {
    const {contacts} = this.scene, apart = new Set([...contacts.kept_apart()].map(([a, b]) => contacts.key(a, b)));
    const listener = {};
    if (apart.size > 0) listener.onBodyPairValidate = (a, b) => !apart.has(contacts.key(a.userData, b.userData));
    if (this.restitution !== undefined && this.friction !== undefined) return listener;
    const set = (a, b, manifold, settings) => {
      const material = contacts.material(a.userData, b.userData);
      settings.combinedRestitution = material.restitution;
      settings.combinedFriction = material.friction;
    };
    return {...listener, onContactAdded: set, onContactPersisted: set};
  }

  add(members, thing) {
    const {MIN} = C.MaterialCombineMode;
    return C.rigidBody.create(this.world, {
      userData: thing, restitution: this.restitution ?? 0, friction: this.friction ?? 0, restitutionCombineMode: MIN, frictionCombineMode: MIN, ...members});
  }

  add_plane({normal, offset, index}) {
    const shape = C.plane.create({plane: {normal: [...normal], constant: 0}, halfExtent: plane_extent});
    return this.add({shape, objectLayer: this.layers.still, motionType: C.MotionType.STATIC, position: scale(offset, normal)}, this.scene.bodies.length + index);
  }

  add_body(body) {
    const {values, layers} = this, shape = shape_of(body, values['convex-radius']);
    const made = this.add({
      shape, objectLayer: !body.touches ? layers.ghost : body.locked ? layers.still : layers.moving,
      motionType: body.locked ? C.MotionType.STATIC : C.MotionType.DYNAMIC, position: [...body.position], quaternion: xyzw(body.orientation),
      gravityFactor: body.gravity ? 0 : 1,  // its own is a force
      linearDamping: values['linear-damping'], angularDamping: values['angular-damping'],
      maxLinearVelocity: values['max-speed'], maxAngularVelocity: values['max-spin'], allowSleeping: is_on(values.sleeping),
      massPropertiesOverride: {mass: 1, inertia: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},  // the body's own come next
    }, body.index);
    if (!body.locked) this.move(made, body);
    return made;
  }

  // Not through calls that hold a speed to its cap: the state of the scene is what it is.
  move({motionProperties: motion}, body) {
    const set = (to, from) => from.forEach((x, k) => { to[k] = x; });
    motion.invMass = 1 / body.mass;
    set(motion.invInertiaDiagonal, body.principal.moments.map((moment) => 1 / moment));
    set(motion.inertiaRotation, xyzw(body.principal.axes));
    set(motion.linearVelocity, body.velocity);
    set(motion.angularVelocity, body.spin);
  }

  add_joint(joint) {
    const {scene} = this, first = scene.bodies[joint.body], second = scene.bodies[joint.to];
    if (first.locked && (!second || second.locked)) return;
    const at = joint.point && [...joint.point], axis = joint.axis && scale(1 / Math.hypot(...joint.axis), joint.axis);
    const ends = {bodyIdA: this.bodies[joint.body].id, bodyIdB: (second ? this.bodies[joint.to] : this.ground()).id, space: C.ConstraintSpace.WORLD};
    const make = {
      ball: () => C.pointConstraint.create(this.world, {...ends, pointA: at, pointB: at}),
      hinge: () => {
        const normal = across(axis);
        C.hingeConstraint.create(this.world,
          {...ends, pointA: at, pointB: at, hingeAxisA: axis, hingeAxisB: axis, normalAxisA: normal, normalAxisB: normal, ...hold(joint, 'Torque')});
      },
      slider: () => {
        const normal = across(axis);
        C.sliderConstraint.create(this.world,
          {...ends, pointA: at, pointB: at, sliderAxisA: axis, sliderAxisB: axis, normalAxisA: normal, normalAxisB: normal, ...hold(joint, 'Force')});
      },
      cylindrical: () => this.add_six(joint, ends, at, ['TRANSLATION_X', 'ROTATION_X']),
      planar: () => this.add_six(joint, ends, at, ['TRANSLATION_Y', 'TRANSLATION_Z', 'ROTATION_X']),
      rectangular: () => this.add_six(joint, ends, at, ['TRANSLATION_Y', 'TRANSLATION_Z']),
      universal: () => this.add_six(joint, ends, at, ['ROTATION_X', 'ROTATION_Z']),
      fixed: () => C.fixedConstraint.create(this.world,
        {...ends, point1: at, point2: at, axisX1: [1, 0, 0], axisX2: [1, 0, 0], axisY1: [0, 1, 0], axisY2: [0, 1, 0]}),
      distance: () => C.distanceConstraint.create(this.world, {
        ...ends, pointA: [...first.position], pointB: second ? [...second.position] : at, minDistance: joint.length, maxDistance: joint.length}),
    }[kept(joint)];
    make();
  }

  // crashcat turns by  R(z, swing) R(x, twist): of a universal joint z is its axis, and x its second.  The first body's axes
  // carry the directions, as those of `to` do in a scene.
  add_six(joint, {bodyIdA, bodyIdB, space}, at, free) {
    const [first, second, third] = frame_of(joint), [x, y] = joint.type === 'universal' ? [second, third] : [first, second];
    const limitMin = Array(6).fill(1), limitMax = Array(6).fill(-1);  // held where the least exceeds the largest
    for (const name of free) {
      const axis = C.SixDOFAxis[name];
      limitMin[axis] = -Number.MAX_VALUE, limitMax[axis] = Number.MAX_VALUE;
    }
    C.sixDOFConstraint.create(this.world, {
      bodyIdA: bodyIdB, bodyIdB: bodyIdA, space, position1: at, position2: at, axisX1: x, axisX2: x, axisY1: y, axisY2: y,
      limitMin, limitMax, swingType: C.SwingType.PYRAMID});
  }

  /** The world as a body, for joints. */
  ground() {
    this.still ??= this.add({shape: null, objectLayer: this.layers.ghost, motionType: C.MotionType.STATIC}, -1);
    return this.still;
  }

  step() {
    for (const body of this.turning) C.motionProperties.applyGyroscopicForce(body.motionProperties, body.quaternion, this.dt);
    C.updateWorld(this.world, this.listener, this.dt);
  }

  push(i, force, torque) {
    C.rigidBody.addForce(this.world, this.bodies[i], force, true);
    C.rigidBody.addTorque(this.world, this.bodies[i], torque, true);
  }

  set_mass(i, mass) { this.bodies[i].motionProperties.invMass = 1 / mass; }

  read(i) {
    const start = this.scene.bodies[i], body = this.bodies[i];
    if (start.locked) return {position: start.position, orientation: start.orientation, velocity: [0, 0, 0], spin: [0, 0, 0]};
    const [x, y, z, w] = body.quaternion, {linearVelocity, angularVelocity} = body.motionProperties;
    return {position: [...body.centerOfMassPosition], orientation: [w, x, y, z], velocity: [...linearVelocity], spin: [...angularVelocity]};
  }

  free() {}
}
