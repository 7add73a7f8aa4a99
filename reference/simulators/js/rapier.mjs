// The adapter of Rapier (WebAssembly, single precision): a prepared scene in, motion out.
// Knows nothing of the protocol.
import {frame_of, held_coordinate, kept} from './joints.mjs';
import {Unsupported} from './scene.mjs';
import {conjugate, multiply, quaternion_of, rotate, scale, sub, turn_of_y} from './vectors.mjs';

export const about = {
  name: 'rapier', title: 'Rapier', build: 'WebAssembly', native: 'native code of Rust', precision: 'float',
  schemes: [{name: 'semi-implicit-euler', order: 1, conserves: 'linear momentum', adaptive: false}],
  gyroscopic: () => 'explicit, of constant |L|, in each substep',
  substeps: (values) => values['solver-iterations'],
  joints: {types: ['ball', 'hinge', 'fixed', 'slider', 'cylindrical', 'planar', 'rectangular'], limits: ['hinge', 'slider'],
    friction: ['hinge', 'slider'],
    why: {distance: 'Rapier has no rigid joint of type distance.'}},
  of_the_scene: [
    {name: 'mass, inertia', value: 'of the scene', engine_default: 'of the colliders and their density',
      reason: 'setAdditionalMassProperties in principal axes; colliders have density 0'},
    {name: 'restitution, friction', value: 'of the pair', engine_default: '0; 0.5; averages',
      reason: 'numbers of colliders whose least or largest is that of each pair (CoefficientCombineRule.Min or Max)'},
    {name: 'forces of a step', value: 'resetForces, addForce', engine_default: 'they stay until they are reset',
      reason: 'a force of the scene is that of its step; Rapier holds it over the substeps'},
    {name: 'collision filter', value: 'filterContactPair', engine_default: 'none',
      reason: 'pairs that a joint ties, or that groups and masks keep apart, do not touch'},
  ],
  unforceable: [
    'A step is solver-iterations substeps of the velocity solver, each with gravity and forces; contacts are found once in it.',
    'The gyroscopic torque has no switch (dynamics/rigid_body.d.ts has none).',
    'Angular speeds are held to a quarter of pi in a step (measured; no call sets it), and speeds to 400 m/s times length-unit. A run in which a sample shows it says so.',
    'A body whose state is not finite is put back, stopped and taken out. Here its states are not finite from then on, and a remark says so.',
    'A contact is a damped spring: contact-frequency sets its frequency; its damping ratio is 10, which no call sets (dynamics/integration_parameters.d.ts:88). Joints are springs too, which no call sets.',
    'A restitution target is met where the bodies are within the prediction distance, which can be before they touch.',
    'A rope yields inwards and a spring is soft: there is no rigid joint that keeps a distance (dynamics/impulse_joint.d.ts:285).',
    'One number of restitution and one of friction for each collider, combined by a rule: not every table of pairs can be had.',
    'A step runs on one thread.',
    'This adapter tells no forces of contacts and joints.',
  ],
  options: [
    {name: 'solver-iterations', setting: 'numSolverIterations', least: 1, most: 1000, whole: true, engine_default: 4,
      meaning: 'substeps of the velocity solver in a step; gravity and forces are applied in each'},
    {name: 'pgs-iterations', setting: 'numInternalPgsIterations', least: 1, most: 1000, whole: true, engine_default: 1,
      meaning: 'sweeps of the solver in a substep'},
    {name: 'prediction', setting: 'normalizedPredictionDistance', least: 0, most: 1e6, engine_default: 0.02,
      meaning: 'gap up to which contacts are found before they touch [m]'},
    {name: 'allowed-error', setting: 'normalizedAllowedLinearError', least: 0, most: 1e6, engine_default: 0.005,
      meaning: 'penetration that is left as it is [m]'},
    {name: 'contact-frequency', setting: 'contact_natural_frequency', least: 0, most: 1e9, above: true, engine_default: 30,
      meaning: 'of the spring that a contact is [1/s]'},
    {name: 'length-unit', setting: 'lengthUnit', least: 0, most: 1e6, above: true, engine_default: 1,
      meaning: 'length of what is usual: the cap of speeds is 400 m/s times it, the largest speed at which overlaps are mended 10 m/s times it, and the least speeds of what sleeps go with it; prediction and allowed-error stay in m [m]'},
    {name: 'sleeping', setting: 'canSleep', values: ['off', 'on'], engine_default: 'on', meaning: 'slow bodies are taken out of the simulation'},
  ],
  paths: [
    {name: 'plain', summary: 'sleeping is off; nothing else is on by default that a scene does not have', set: {
      'sleeping': ['off', 'what moves slowly moves'],
    }},
    {name: 'as-shipped', summary: 'every setting as Rapier has it by itself', set: {}},
  ],
};

let RAPIER;  // the package that runs

/** Of one of the packages that have Rapier's interface (rapier-deterministic.mjs). */
export async function start(rapier = '@dimforge/rapier3d-compat') {
  RAPIER = (await import(rapier)).default;
  await RAPIER.init();
  return {version: RAPIER.version(), load: (scene, dt, values) => new World(scene, dt, values), defaults};
}

/** The engine's own values of the options, asked of itself. */
function defaults() {
  const world = new RAPIER.World(xyz([0, 0, 0])), own = world.integrationParameters;
  // Told as contact_erp = dt w/(dt w + 2 ratio), with w = 2 pi frequency, of the damping ratio 10.
  const share = own.contact_erp, frequency = 20 * share / (1 - share) / (2 * Math.PI * own.dt);
  const values = {
    'solver-iterations': own.numSolverIterations, 'pgs-iterations': own.numInternalPgsIterations,
    'prediction': own.normalizedPredictionDistance, 'allowed-error': own.normalizedAllowedLinearError,
    'contact-frequency': frequency, 'length-unit': own.lengthUnit, 'sleeping': RAPIER.RigidBodyDesc.dynamic().canSleep ? 'on' : 'off',
  };
  world.free();
  return values;
}

const xyz = ([x, y, z]) => ({x, y, z});
const wxyz = ([w, x, y, z]) => ({w, x, y, z});
const three = ({x, y, z}) => [x, y, z];
const lost = [NaN, NaN, NaN];
const most_speed = 400, most_turn = Math.PI / 4;  // [m/s] for a unit of 1 m, [rad] in a step: what Rapier holds motions to (measured)

// ---- Colliders ----------------------------------------------------------------------------------------

const colliders = {
  sphere: (s) => RAPIER.ColliderDesc.ball(s.radius),
  box: (s) => RAPIER.ColliderDesc.cuboid(...s.half_extents),
  capsule: (s) => RAPIER.ColliderDesc.capsule(s.length / 2, s.radius),
  cylinder: (s) => RAPIER.ColliderDesc.cylinder(s.length / 2, s.radius),
  cone: (s) => RAPIER.ColliderDesc.cone(s.length / 2, s.radius).setTranslation(0, s.length / 4, 0),  // about mid-height
  hull: (s) => RAPIER.ColliderDesc.convexHull(Float32Array.from(s.vertices.flat())),
  mesh: (s, body) => {
    if (!body.locked)
      throw new Unsupported(`Body '${body.name}': Rapier collides a mesh as a surface, not as a solid; here only where it does not move.`);
    return RAPIER.ColliderDesc.trimesh(Float32Array.from(s.vertices.flat()), Uint32Array.from(s.faces.flat()));
  },
};

function collider(shape, body) {
  if (!(shape.type in colliders))
    throw new Unsupported(`Body '${body.name}': this adapter gives Rapier no solid without thickness, such as a ${shape.type}.`);
  const made = colliders[shape.type](shape, body);
  if (!made) throw new Unsupported(`Body '${body.name}': Rapier makes no hull of these vertices.`);
  return made;
}

function* colliders_of(body) {
  if (body.shape.type !== 'compound') yield collider(body.shape, body);
  else for (const part of body.shape.parts) {
    if (!part.shape) continue;
    const made = collider(part.shape, body), foot = rotate(part.orientation, three(made.translation));
    yield made.setTranslation(...part.position.map((x, k) => x + foot[k])).setRotation(wxyz(part.orientation));
  }
}

// ---- A world ------------------------------------------------------------------------------------------

const largest = 3.4e38;  // of single precision
const rigid = 1e10;      // of a motor's damper [N s/m, N m s/rad]

class World {
  constructor(scene, dt, values) {
    this.scene = scene, this.dt = dt, this.steps = 0;
    this.told = new Map();  // remarks, by what and whom
    const {contacts} = scene;
    this.restitution = contacts.of_things('restitution', about.title);
    this.friction = contacts.of_things('friction', about.title);
    this.apart = new Set([...contacts.kept_apart()].map(([a, b]) => contacts.key(a, b)));
    this.things = new Map();  // handles of colliders: things of scene.contacts
    this.world = new RAPIER.World(xyz(scene.gravity));
    this.set_parameters(dt, values);
    for (const plane of scene.planes) this.add_plane(plane);
    this.bodies = scene.bodies.map((body) => this.add_body(body, values));
    this.ground = this.world.createRigidBody(RAPIER.RigidBodyDesc.fixed());
    for (const joint of scene.joints) this.add_joint(joint);
    if (this.apart.size === 0) return;
    this.events = new RAPIER.EventQueue(true);  // without one Rapier asks no hooks
    this.hooks = {
      filterContactPair: (a, b) => (this.apart.has(contacts.key(this.things.get(a), this.things.get(b))) ? null
        : RAPIER.SolverFlags.COMPUTE_IMPULSE),
      filterIntersectionPair: () => false,
    };
  }

  set_parameters(dt, values) {
    const parameters = this.world.integrationParameters;
    parameters.dt = dt;
    parameters.numSolverIterations = values['solver-iterations'];
    parameters.numInternalPgsIterations = values['pgs-iterations'];
    this.unit = parameters.lengthUnit = values['length-unit'];
    parameters.normalizedPredictionDistance = values.prediction / this.unit;
    parameters.normalizedAllowedLinearError = values['allowed-error'] / this.unit;
    parameters.contact_natural_frequency = values['contact-frequency'];
  }

  add_collider(description, body, thing) {
    const rules = {min: RAPIER.CoefficientCombineRule.Min, max: RAPIER.CoefficientCombineRule.Max};
    description.setDensity(0)
      .setRestitution(this.restitution.of(thing)).setRestitutionCombineRule(rules[this.restitution.rule])
      .setFriction(this.friction.of(thing)).setFrictionCombineRule(rules[this.friction.rule]);
    if (this.apart.size > 0) description.setActiveHooks(RAPIER.ActiveHooks.FILTER_CONTACT_PAIRS);
    this.things.set(this.world.createCollider(description, body).handle, thing);
  }

  add_plane(plane) {
    const q = turn_of_y(plane.normal);
    const body = this.world.createRigidBody(
      RAPIER.RigidBodyDesc.fixed().setTranslation(...scale(plane.offset, plane.normal)).setRotation(wxyz(q)));
    this.add_collider(new RAPIER.ColliderDesc(new RAPIER.HalfSpace({x: 0, y: 1, z: 0})), body, this.scene.bodies.length + plane.index);
  }

  add_body(body, values) {
    const description = body.locked ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic();
    description.setTranslation(...body.position).setRotation(wxyz(body.orientation));
    if (!body.locked) {
      const {moments, axes} = body.principal;
      description.setLinvel(...body.velocity).setAngvel(xyz(body.spin)).setCanSleep(values.sleeping === 'on')
        .setGravityScale(body.gravity ? 0 : 1)  // its own is a force
        .setAdditionalMassProperties(body.mass, {x: 0, y: 0, z: 0}, xyz(moments), wxyz(axes));
    }
    const made = this.world.createRigidBody(description);
    if (body.touches) for (const one of colliders_of(body)) this.add_collider(one, made, body.index);
    return made;
  }

  add_joint(joint) {
    const {scene} = this, first = scene.bodies[joint.body], second = scene.bodies[joint.to];
    if (first.locked && (!second || second.locked)) return;
    const origin = {position: [0, 0, 0], orientation: [1, 0, 0, 0]};
    const local = (body) => xyz(rotate(conjugate(body.orientation), sub(joint.point, body.position)));
    const axis = (body) => xyz(rotate(conjugate(body.orientation), scale(1 / Math.hypot(...joint.axis), joint.axis)));
    const frame = (body) => wxyz(conjugate(body.orientation));
    const a = first, b = second ?? origin, M = RAPIER.JointAxesMask;
    const data = {
      ball: () => RAPIER.JointData.spherical(local(a), local(b)),
      hinge: () => RAPIER.JointData.revoluteWithAxes(local(a), local(b), axis(a), axis(b)),
      fixed: () => RAPIER.JointData.fixed(local(a), frame(a), local(b), frame(b)),
      slider: () => RAPIER.JointData.prismatic(local(a), local(b), {x: 1, y: 0, z: 0}),
      cylindrical: () => RAPIER.JointData.generic(local(a), local(b), {x: 1, y: 0, z: 0}, M.LinY | M.LinZ | M.AngY | M.AngZ),
      planar: () => RAPIER.JointData.generic(local(a), local(b), {x: 1, y: 0, z: 0}, M.LinX | M.AngY | M.AngZ),
      rectangular: () => RAPIER.JointData.generic(local(a), local(b), {x: 1, y: 0, z: 0}, M.LinX | M.AngX | M.AngY | M.AngZ),
    }[kept(joint)];
    const made = this.world.createImpulseJoint(data(), this.bodies[joint.body], second ? this.bodies[joint.to] : this.ground, true);
    // An angle with limits is 0 where the scene starts: the frames are the same then.
    if (['slider', 'cylindrical', 'planar', 'rectangular'].includes(joint.type) || held_coordinate(joint)) {
      const axes = quaternion_of(...frame_of(joint));
      made.setFrameX1(wxyz(multiply(conjugate(a.orientation), axes)));
      made.setFrameX2(wxyz(multiply(conjugate(b.orientation), axes)));
    }
    this.hold(made, joint);
  }

  // Rapier counts the second body against the first, which is `body`.  Friction is a motor at rest with a largest force.
  hold(made, joint) {
    const held = held_coordinate(joint, true);
    if (!held) return;
    if (held.limited) made.setLimits(Math.max(held.lower, -largest), Math.min(held.upper, largest));
    if (held.friction === 0) return;
    made.configureMotorModel(RAPIER.MotorModel.ForceBased);
    made.configureMotorVelocity(0, rigid);
    made.setMotorMaxForce(held.friction);
  }

  step() {
    this.world.step(this.events, this.hooks);
    ++this.steps;
  }

  // Forces stay until they are reset.
  push(i, force, torque) {
    const body = this.bodies[i];
    body.resetForces(true);
    body.resetTorques(true);
    body.addForce(xyz(force), true);
    body.addTorque(xyz(torque), true);
  }

  set_mass(i, mass) {
    const {moments, axes} = this.scene.bodies[i].principal;
    this.bodies[i].setAdditionalMassProperties(mass, {x: 0, y: 0, z: 0}, xyz(moments), wxyz(axes), true);
    this.bodies[i].recomputeMassPropertiesFromColliders();
  }

  read(i) {
    const start = this.scene.bodies[i], body = this.bodies[i];
    if (start.locked) return {position: start.position, orientation: start.orientation, velocity: [0, 0, 0], spin: [0, 0, 0]};
    if (!body.isEnabled()) {  // this adapter disables none
      this.tell('out', start.name, 'took it out and put it where it was a step before, as its state was not finite; here it is not');
      return {position: lost, orientation: [NaN, NaN, NaN, NaN], velocity: lost, spin: lost};
    }
    const q = body.rotation(), velocity = three(body.linvel()), spin = three(body.angvel());
    const near = (of, most) => this.steps > 0 && Math.hypot(...of) > 0.999 * most;
    const most_spin = most_turn / this.dt;
    if (near(velocity, most_speed * this.unit)) this.tell('speed', start.name, `holds speeds to ${most_speed * this.unit} m/s, and it is there`);
    if (near(spin, most_spin)) this.tell('spin', start.name, `holds angular speeds to ${most_spin.toPrecision(6)} rad/s, a quarter of pi in a step, and it is there`);
    return {position: three(body.translation()), orientation: [q.w, q.x, q.y, q.z], velocity, spin};
  }

  tell(what, name, sentence) {
    const key = `${what} ${name}`;
    if (!this.told.has(key)) this.told.set(key, `'${name}', step ${this.steps}: Rapier ${sentence}.`);
  }

  remarks() { return [...this.told.values()]; }

  free() {
    this.events?.free();
    this.world.free();
  }
}
