// The adapter of MuJoCo 3 (@mujoco/mujoco, WebAssembly, double precision): a prepared scene in, motion out.
// Knows nothing of the protocol.
import load_mujoco from '@mujoco/mujoco';
import {forest_of} from './forest.mjs';
import {has_forces} from './forces.mjs';
import {acting, has_limit, is_ball} from './joints.mjs';
import {axes_of, body_name, model_of, require_expressible} from './mujoco3_model.mjs';
import {Unsupported} from './scene.mjs';
import {add, conjugate, cross, is_zero, rotate, sub} from './vectors.mjs';

const largest = Number.MAX_VALUE;

export const about = {
  name: 'mujoco3', title: 'MuJoCo', build: 'WebAssembly', native: 'native code of C', precision: 'double',
  schemes: [
    {name: 'euler', order: 1, conserves: 'linear momentum', adaptive: false},
    {name: 'implicit', order: 1, conserves: 'linear momentum; velocities implicit, the gyroscopic torque too', adaptive: false},
    {name: 'implicitfast', order: 1, conserves: 'linear momentum; velocities implicit, the gyroscopic torque of a free body too, of a tree without its Coriolis terms', adaptive: false},
    {name: 'rk4', order: 4, conserves: 'nothing in particular; order 2 where a body turns freely, 1 with contacts or applied forces', adaptive: false},
  ],
  gyroscopic: (values) => (values.integrator.startsWith('implicit') ? 'implicit' : 'explicit'),
  joints: {types: ['ball', 'hinge', 'fixed', 'distance', 'slider', 'cylindrical', 'planar', 'universal', 'rectangular', 'offset_universal'],
    limits: ['hinge', 'slider', 'cylindrical', 'planar', 'universal', 'gimbal', 'rectangular', 'offset_universal'],
    friction: ['hinge', 'slider', 'cylindrical', 'planar', 'universal', 'gimbal', 'rectangular', 'offset_universal'], rotors: true, counts_turns: true},
  of_the_scene: [
    {name: 'inertial', value: 'of the scene', engine_default: 'of the geoms and their density', reason: 'diaginertia in principal axes'},
    {name: 'friction, condim', value: 'of the pair', engine_default: "the larger of both geoms', 3",
      reason: 'one coefficient on all geoms, or a <pair> each where pairs differ; condim 1 without friction'},
    {name: 'filterparent', value: 'disable', engine_default: 'enable',
      reason: 'bodies that a joint ties do not touch (<exclude>), all others do, also those that hang on one body'},
    {name: 'autoreset', value: 'disable', engine_default: 'enable',
      reason: 'MuJoCo resets a simulation that diverges to its initial pose; here its states are not finite'},
  ],
  unforceable: [
    'There is no coefficient of restitution: a contact is a damped spring, and a bounce would be a choice of its stiffness.',
    'Contacts and closed loops are soft: what is loaded yields, by an impedance below 1; what should stick creeps.',
    'With euler the gyroscopic torque is explicit.',
    'Runge-Kutta 4 is of order 2 where a body turns freely, and of order 1 with applied forces, which are constant during a step: no callback is in these bindings (mujoco.d.ts has no mjcb_passive).',
    'A position or velocity beyond 1e10 counts as bad.',
    'The vertices of hulls are stored in single precision.',
    'This adapter tells no forces of contacts and joints.',
    'A step runs on one thread.',
  ],
  options: [
    {name: 'cone', setting: 'cone', values: ['pyramidal', 'elliptic'], engine_default: 'pyramidal',
      meaning: "friction within a pyramid of four edges, inside Coulomb's cone, or within the cone itself"},
    {name: 'impratio', setting: 'impratio', least: 0, most: largest, above: true, engine_default: 1,
      meaning: 'how much stiffer friction is than the normal force'},
    {name: 'noslip-iterations', setting: 'noslip_iterations', least: 0, most: 1e6, whole: true, engine_default: 0,
      meaning: 'sweeps after the solver that take the slip out of friction'},
    {name: 'solver', setting: 'solver', values: ['PGS', 'CG', 'Newton'], engine_default: 'Newton', meaning: 'constraint solver'},
    {name: 'iterations', setting: 'iterations', least: 1, most: 1e6, whole: true, engine_default: 100, meaning: 'of the constraint solver per step, at most'},
    {name: 'tolerance', setting: 'tolerance', least: 0, most: largest, engine_default: 1e-8,
      meaning: 'improvement, of the cost, below which the constraint solver ends'},
    {name: 'jacobian', setting: 'jacobian', values: ['dense', 'sparse', 'auto'], engine_default: 'auto', meaning: 'of the constraints'},
    {name: 'warmstart', setting: 'warmstart', values: ['disable', 'enable'], engine_default: 'enable',
      meaning: 'the constraint solver starts from the accelerations of the last step'},
    {name: 'solref-time', setting: 'solref timeconst', least: 0, most: largest, above: true, engine_default: 0.02,
      meaning: 'time in which contacts and constraints correct an error, two steps at least [s]'},
    {name: 'solref-damping', setting: 'solref dampratio', least: 0, most: largest, above: true, engine_default: 1,
      meaning: 'damping of that correction as a ratio to critical damping'},
    {name: 'solimp-least', setting: 'solimp dmin', least: 1e-4, most: 0.9999, engine_default: 0.9, meaning: 'impedance of a constraint without violation'},
    {name: 'solimp-most', setting: 'solimp dmax', least: 1e-4, most: 0.9999, engine_default: 0.95, meaning: 'impedance from solimp-width on'},
    {name: 'solimp-width', setting: 'solimp width', least: 0, most: largest, engine_default: 0.001, meaning: 'violation at which the impedance is solimp-most [m]'},
  ],
  paths: [{name: 'as-shipped', summary: 'every setting as MuJoCo has it by itself', set: {}}],
};

export async function start() {
  const M = await load_mujoco({print: console.error, printErr: console.error});
  return {version: M.mj_versionString(), load: (scene, dt, values) => new World(M, scene, dt, values), defaults: () => defaults(M)};
}

/** The engine's own values of the options, asked of an empty model; null where that does not tell. */
function defaults(M) {
  const model = M.MjModel.from_xml_string('<mujoco><worldbody><geom size="1"/></worldbody></mujoco>'), {opt} = model;
  const values = {
    'cone': ['pyramidal', 'elliptic'][opt.cone], 'impratio': opt.impratio, 'noslip-iterations': opt.noslip_iterations,
    'solver': ['PGS', 'CG', 'Newton'][opt.solver], 'iterations': opt.iterations, 'tolerance': opt.tolerance,
    'jacobian': ['dense', 'sparse', 'auto'][opt.jacobian], 'warmstart': opt.disableflags === 0 ? 'enable' : 'disable',
    'solref-time': model.geom_solref[0], 'solref-damping': model.geom_solref[1],
    'solimp-least': model.geom_solimp[0], 'solimp-most': model.geom_solimp[1], 'solimp-width': model.geom_solimp[2],
  };
  model.delete();
  return values;
}

// ---- A world ------------------------------------------------------------------------------------------

const full = [1, 2], bad = [3, 4, 5];  // mjtWarning: no room for contacts, constraints; position, velocity, acceleration
const free_joint = 0, slide_joint = 2;  // mjtJoint
const at = (array, i, count = 3) => Array.from(array.subarray(i, i + count));
const still = (body) => ({position: body.position, orientation: body.orientation, velocity: [0, 0, 0], spin: [0, 0, 0]});
const lost = {position: [NaN, NaN, NaN], orientation: [NaN, NaN, NaN, NaN], velocity: [NaN, NaN, NaN], spin: [NaN, NaN, NaN]};

class World {
  constructor(M, scene, dt, values) {
    this.M = M, this.scene = scene, this.steps = 0;
    const forest = forest_of(scene);
    require_expressible(scene, forest);
    this.model = compile(M, model_of(scene, forest, values, dt));
    this.data = new M.MjData(this.model);
    this.places = scene.bodies.map((body) => this.place(body, forest));
    this.trees = this.places.some((place) => place.id && !place.free);
    scene.bodies.forEach((body, i) => this.set_speed(body, forest.nodes[i]));
    this.order = values.integrator === 'rk4' ? this.order_of_rk4(forest) : 1;
  }

  // Where a body is in MuJoCo's arrays; id 0: locked.
  place(body, forest) {
    if (body.locked) return {id: 0};
    const m = this.model, id = this.M.mj_name2id(m, 1, body_name(body.index)), joint = m.body_jntadr[id];
    const has = m.body_jntnum[id] > 0;  // a fixed one has none
    return {id, free: forest.nodes[body.index].joint < 0, position: has ? m.jnt_qposadr[joint] : -1, speed: has ? m.jnt_dofadr[joint] : -1};
  }

  // A free body: v of the world, w of the body; a ball joint: w against the parent, in body axes; others: their rates.
  set_speed(body, node) {
    const {speed, free} = this.places[body.index];
    if (!(speed >= 0)) return;
    const back = conjugate(body.orientation), joint = this.scene.joints[node.joint];
    const spin = node.parent >= 0 ? sub(body.spin, this.scene.bodies[node.parent].spin) : body.spin;
    if (free) this.data.qvel.set([...body.velocity, ...rotate(back, spin)], speed);
    else if (is_ball(joint)) this.data.qvel.set(rotate(back, spin), speed);
    else this.data.qvel.set(axes_of(this.scene, joint, joint.body !== body.index).map(({rate}) => rate), speed);
  }

  order_of_rk4(forest) {
    const {scene} = this;
    const stops = scene.joints.some((joint) => acting(joint).some(({acts}) => has_limit(acts) || acts.friction !== 0));
    if (has_forces(scene) || stops || scene.contacts.rows.length > 0 || forest.loops.length > 0) return 1;
    const turning = scene.bodies.some((body, i) => {
      const node = forest.nodes[i];
      if (body.locked) return false;
      return node.joint < 0 ? !is_zero(body.spin) || node.children.length > 0 : ['ball', 'universal', 'gimbal', 'offset_universal'].includes(scene.joints[node.joint].type);
    });
    return turning ? 2 : 4;
  }

  step() {
    ++this.steps;
    this.M.mj_step(this.model, this.data);
    this.fresh = false;
    const {warning} = this.data, warned = (kinds) => kinds.some((kind) => warning.get(kind).number > 0);
    if (warned(full)) throw new Error('MuJoCo has no room for more contacts or constraints');
    if (!this.lost_in && warned(bad)) this.lost_in = this.steps;
  }

  // Of a free body its own coordinates, without the rounding of the way through the tree.
  push(i, force, torque) {
    const {id, free, speed} = this.places[i];
    if (free) this.data.qfrc_applied.set([...force, ...rotate(conjugate(this.read(i).orientation), torque)], speed);
    else this.data.xfrc_applied.set([...force, ...torque], 6 * id);
  }

  // Of a body and of all that it hangs on.  The inertia stays.
  set_mass(i, mass) {
    const m = this.model, {id} = this.places[i], gained = mass - m.body_mass[id];
    m.body_mass[id] = mass;
    // What a simple body resists (its axes are the principal ones) is not summed but taken from here: mj_crb in
    // engine_core_smooth.c.
    for (let k = m.body_jntadr[id]; k < m.body_jntadr[id] + m.body_jntnum[id]; ++k) {
      const ways = {[free_joint]: 3, [slide_joint]: 1}[m.jnt_type[k]] ?? 0;
      for (let way = 0; way < ways; ++way) m.dof_M0[m.jnt_dofadr[k] + way] += gained;
    }
    for (let at_id = id; ; at_id = m.body_parentid[at_id]) {
      m.body_subtreemass[at_id] += gained;
      if (at_id === 0) return;
    }
  }

  read(i) {
    const {id, free, position, speed} = this.places[i], d = this.data;
    if (id === 0) return still(this.scene.bodies[i]);
    if (this.lost_in) return lost;
    if (free) {
      const q = at(d.qpos, position + 3, 4), length = Math.hypot(...q), unit = q.map((c) => c / length);
      return {position: at(d.qpos, position), orientation: unit, velocity: at(d.qvel, speed), spin: rotate(unit, at(d.qvel, speed + 3))};
    }
    this.refresh();
    // cvel: w, then v at the centre of mass of the tree
    const spin = at(d.cvel, 6 * id), centre = at(d.subtree_com, 3 * this.model.body_rootid[id]), place = at(d.xipos, 3 * id);
    const velocity = add(at(d.cvel, 6 * id + 3), cross(spin, sub(place, centre)));
    return {position: place, orientation: at(d.xquat, 4 * id, 4), velocity, spin};
  }

  // Poses follow from coordinates, which stay as they are: mj_kinematics() normalises their quaternions.
  refresh() {
    if (this.fresh) return;
    const {M, model, data} = this, coordinates = data.qpos.slice();
    M.mj_kinematics(model, data);
    M.mj_comPos(model, data);
    M.mj_comVel(model, data);
    data.qpos.set(coordinates);
    this.fresh = true;
  }

  remarks() {
    return this.lost_in ? [`In step ${this.lost_in} a coordinate, velocity or acceleration was not finite or beyond 1e10; all states since then are shown as not finite.`] : [];
  }

  free() {
    this.data.delete();
    this.model.delete();
  }
}

function compile(M, xml) {
  try {
    return M.MjModel.from_xml_string(xml);
  } catch (error) {
    throw new Unsupported(`MuJoCo does not compile the scene: ${String(error.message).split('\n')[0]}`);
  }
}
