// A prepared scene as MuJoCo's XML, with all digits; what MuJoCo cannot hold is refused.  After
// reference/simulators/mujoco/mujoco_model.cc, for MuJoCo 3.
import {between_axes, coordinates, frame_of, has_limit, is_ball, point_of_body, range, rates_at_start, reversed} from './joints.mjs';
import {Unsupported} from './scene.mjs';
import {add, conjugate, multiply, norm, rotate, scale, sub} from './vectors.mjs';

const least = 1e-15, deepest = 90, most_pairs = 20000;  // least mass and moment: mjMINVAL
const far = 1e10;  // mjMAXVAL
const t = (x) => (Array.isArray(x) ? x.join(' ') : String(x));  // the shortest text that is the same number
const z_to_y = [Math.sqrt(0.5), -Math.sqrt(0.5), 0, 0];  // MuJoCo's axis of revolution is z

// The turn from z to a unit normal, of any length: exact for a normal along an axis.
const turn_to = ([x, y, z]) => (z > -0.5 ? [1 + z, -y, x, 0] : [-y, 1 - z, 0, x]);

const missing = {
  cone: 'MuJoCo has no cone', rod: 'MuJoCo has no solid without thickness, such as a rod',
  disc: 'MuJoCo has no solid without thickness, such as a disc',
  mesh: 'MuJoCo collides the convex hull of a mesh, not the mesh; give its convex parts as a compound',
};
const geoms = {
  sphere: (s) => `type="sphere" size="${t(s.radius)}"`, box: (s) => `type="box" size="${t(s.half_extents)}"`,
  capsule: (s) => `type="capsule" size="${t([s.radius, s.length / 2])}"`,
  cylinder: (s) => `type="cylinder" size="${t([s.radius, s.length / 2])}"`,
};

export const body_name = (i) => `b${i}`;
const plane_name = (i) => `p${i}`;
const parts_of = ({shape}) => (shape.type === 'compound' ? shape.parts.filter((part) => part.shape)
  : [{shape, position: [0, 0, 0], orientation: [1, 0, 0, 0]}]);

/** A joint of a tree that is no ball and not fixed as MuJoCo's own, in the order in which they act: {slides, axis: of the
 *  world at t = 0, acts, rate: of the child, which is `body` or, `other_way`, `to`, against its parent}. */
export function axes_of(scene, joint, other_way) {
  // Displacements first: their axes are those of the parent.  Of a universal joint R(axis, first) R(axis_2, second), and
  // from the other side R(axis_2, -second) R(axis, -first); of a gimbal with R(axis x axis_2, third) between the two.
  const [x, y, z] = frame_of(joint), rates = rates_at_start(scene, joint), second = joint.type === 'gimbal' ? joint.axis_2 : y;
  const list = coordinates(joint).map(({slides, which, acts}, k) => ({
    slides, acts: acts && other_way ? reversed(acts) : acts, rate: other_way ? -rates[k] : rates[k],
    axis: (joint.type === 'planar' || joint.type === 'rectangular' ? (slides ? [y, z] : [x]) : [x, second, z])[which],
    point: which === 1 ? point_of_body(joint) : joint.point}));
  if (joint.type === 'gimbal') list.splice(1, 0, list.pop());
  return between_axes.includes(joint.type) && other_way ? list.reverse() : list;
}

// What closes a loop; all kinds hang a body from another.
const closes = ['ball', 'hinge', 'distance', 'fixed'];

function require_joints(scene, forest) {
  scene.joints.forEach((joint, j) => {
    const acts = coordinates(joint).some(({acts}) => acts && (has_limit(acts) || acts.friction !== 0 || acts.armature !== 0));
    const of = `The ${joint.type} joint of '${scene.bodies[joint.body].name}'`;
    if (forest.loops.includes(j) && (!closes.includes(joint.type) || acts))
      throw new Unsupported(`${of} closes a loop, which this adapter closes by balls, hinges and fixed joints without limits, friction and rotors.`);
    if (['planar', 'rectangular'].includes(joint.type) && coordinates(joint).some(({acts}) => acts) && forest.nodes[joint.body].joint !== j)
      throw new Unsupported(`${of} hangs '${scene.bodies[joint.to].name}' from it, and MuJoCo's displacements are of the parent's axes.`);
  });
}

/** Throws Unsupported where MuJoCo cannot hold the scene. */
export function require_expressible(scene, forest) {
  require_joints(scene, forest);
  for (const body of scene.bodies) {
    if (body.locked) continue;
    const {moments} = body.principal, largest = Math.max(...moments);
    if (!(body.mass >= least)) throw new Unsupported(`MuJoCo needs a mass of at least ${least} kg; '${body.name}' has ${body.mass} kg.`);
    if (!(Math.min(...moments) >= least))
      throw new Unsupported(`MuJoCo needs principal moments of at least ${least} kg m^2; '${body.name}' has one of ${Math.min(...moments)} kg m^2.`);
    if (2 * largest > moments[0] + moments[1] + moments[2] + 1e-12 * largest)
      throw new Unsupported(`MuJoCo needs principal moments A + B >= C; '${body.name}' has ${moments.join(', ')} kg m^2.`);
    const {depth} = forest.nodes[body.index];
    if (depth > deepest) throw new Unsupported(`MuJoCo's reader of XML takes at most ${deepest} bodies that hang from each other; '${body.name}' is deeper.`);
  }
  const bounces = scene.contacts.rows.map((row) => row[2].restitution).find((e) => e > 0);
  if (bounces !== undefined)
    throw new Unsupported(`A pair bounces by ${bounces}, and MuJoCo has no coefficient of restitution: its contacts are damped springs, whose stiffness the scene does not state.`);
  for (const body of scene.bodies) if (body.touches) for (const {shape} of parts_of(body)) {
    if (missing[shape.type]) throw new Unsupported(`Body '${body.name}': ${missing[shape.type]}.`);
    if (shape.type === 'hull' && shape.vertices.length < 4) throw new Unsupported(`Body '${body.name}': MuJoCo needs four vertices.`);
  }
}

class Writer {
  constructor(scene, forest, values, dt) { Object.assign(this, {scene, forest, values, dt, out: [], assets: []}); }

  moves(i) { return i >= 0 && i < this.scene.bodies.length && !this.scene.bodies[i].locked; }

  xml() {
    const v = this.values, {scene} = this, {contacts} = scene;
    const friction = contacts.uniform('friction');
    this.listed = friction === undefined || contacts.filtered;
    const soft = `solref="${t([v['solref-time'], v['solref-damping']])}" solimp="${t([v['solimp-least'], v['solimp-most'], v['solimp-width']])}"`;
    const integrator = {'euler': 'Euler', 'implicit': 'implicit', 'implicitfast': 'implicitfast', 'rk4': 'RK4'}[v.integrator];
    this.out.push(
      '<mujoco><compiler angle="radian" inertiafromgeom="false"/>',
      `<option timestep="${t(this.dt)}" gravity="${t(scene.gravity)}" integrator="${integrator}" cone="${v.cone}" impratio="${t(v.impratio)}"`,
      ` noslip_iterations="${v['noslip-iterations']}" solver="${v.solver}" iterations="${v.iterations}" tolerance="${t(v.tolerance)}" jacobian="${v.jacobian}">`,
      `<flag filterparent="disable" autoreset="disable" warmstart="${v.warmstart}"/></option>`,
      `<default><geom ${soft} condim="${friction > 0 ? 3 : 1}" friction="${t([friction ?? 0, 0, 0])}"${this.listed ? ' contype="0" conaffinity="0"' : ''}/>`,
      `<pair ${soft}/><equality ${soft}/></default>`, '<worldbody>');
    for (const plane of scene.planes)
      this.out.push(`<geom name="${plane_name(plane.index)}" type="plane" size="0 0 1" pos="${t(scale(plane.offset, plane.normal))}" quat="${t(turn_to(plane.normal))}"/>`);
    for (const body of scene.bodies) if (body.locked) this.body(body, body.position, body.orientation, () => {});
    for (const root of this.forest.roots) this.moving(root);
    for (const j of this.distances()) if (scene.joints[j].to < 0) this.out.push(`<site name="s${j}_1" pos="${t(scene.joints[j].point)}"/>`);
    this.out.push('</worldbody>');
    if (this.assets.length) this.out.push(`<asset>${this.assets.join('')}</asset>`);
    this.contacts();
    this.loops();
    this.out.push('</mujoco>');
    return this.out.join('\n');
  }

  // In the frame of its parent; the joints are at zero where the scene starts.
  moving(i) {
    const node = this.forest.nodes[i], body = this.scene.bodies[i];
    let {position, orientation} = body;
    if (node.parent >= 0) {
      const parent = this.scene.bodies[node.parent], back = conjugate(parent.orientation);
      position = rotate(back, sub(position, parent.position)), orientation = multiply(back, orientation);
    }
    this.body(body, position, orientation, () => {
      const {axes} = body.principal, moments = [...body.principal.moments];
      const k = moments.indexOf(Math.max(...moments));
      moments[k] = Math.min(moments[k], moments[(k + 1) % 3] + moments[(k + 2) % 3]);  // A + B >= C, in MuJoCo's rounding
      this.out.push(`<inertial pos="0 0 0" mass="${t(body.mass)}" quat="${t(axes)}" diaginertia="${t(moments)}"/>`);
      if (node.joint < 0) this.out.push('<freejoint/>');
      else this.joint(body, this.scene.joints[node.joint], this.scene.joints[node.joint].body !== i);
    }, node.children);
  }

  body(body, position, orientation, inner, children = []) {
    this.out.push(`<body name="${body_name(body.index)}" pos="${t(position)}" quat="${t(orientation)}"${body.gravity ? ' gravcomp="1"' : ''}>`);
    inner();
    if (body.touches) parts_of(body).forEach((part, k) => this.geom(body.index, part, k));
    for (const j of this.distances()) {
      if (this.scene.joints[j].body === body.index) this.out.push(`<site name="s${j}_0"/>`);
      if (this.scene.joints[j].to === body.index) this.out.push(`<site name="s${j}_1"/>`);
    }
    for (const child of children) this.moving(child);
    this.out.push('</body>');
  }

  // A fixed joint is none: the body is part of its parent.
  joint(body, joint, other_way) {
    const back = conjugate(body.orientation), local = (point) => t(rotate(back, sub(point, body.position)));
    if (is_ball(joint)) this.out.push(`<joint type="ball" pos="${local(joint.point)}"/>`);
    if (is_ball(joint) || joint.type === 'fixed') return;
    for (const {slides, axis, acts, point} of axes_of(this.scene, joint, other_way))
      this.out.push(`<joint type="${slides ? 'slide' : 'hinge'}" pos="${local(point)}" axis="${t(rotate(back, axis))}"${acts ? this.stops(acts) : ''}/>`);
  }

  // A limit on one side alone has the other beyond every coordinate that MuJoCo takes.
  stops(acts) {
    const {lower, upper} = range(acts);
    return (has_limit(acts) ? ` limited="true" range="${t([Math.max(lower, -far), Math.min(upper, far)])}"` : '') +
      (acts.friction !== 0 ? ` frictionloss="${t(acts.friction)}"` : '') + (acts.armature ? ` armature="${t(acts.armature)}"` : '');
  }

  geom(i, {shape, position, orientation}, k) {
    const name = `g${i}_${k}`, round = shape.type === 'capsule' || shape.type === 'cylinder';
    if (shape.type === 'hull') this.assets.push(`<mesh name="${name}" vertex="${t(shape.vertices.flat())}"/>`);
    const what = shape.type === 'hull' ? `type="mesh" mesh="${name}"` : geoms[shape.type](shape);
    this.out.push(`<geom name="${name}" ${what} pos="${t(position)}" quat="${t(round ? multiply(orientation, z_to_y) : orientation)}"/>`);
  }

  /** Whether a thing is part of the world: a plane, what is locked, and what is fixed to such. */
  stands(id) {
    if (id < 0 || !this.moves(id)) return true;
    const {joint, parent} = this.forest.nodes[id];
    return joint >= 0 && this.scene.joints[joint].type === 'fixed' && this.stands(parent);
  }

  geoms_of(thing) {
    const {bodies} = this.scene;
    return thing.id < bodies.length ? parts_of(bodies[thing.id]).map((_, k) => `g${thing.id}_${k}`) : [plane_name(thing.id - bodies.length)];
  }

  contacts() {
    const {contacts} = this.scene, lines = [];
    if (!this.listed) {
      for (const [a, b] of [...contacts.tied].map((key) => key.split(',').map(Number)))
        if (this.moves(a) || this.moves(b)) lines.push(`<exclude body1="${body_name(a)}" body2="${body_name(b)}"/>`);
    } else {
      for (const [a, b] of contacts.meeting()) {
        if (this.stands(a.id) && this.stands(b.id)) continue;  // MuJoCo ends at a contact of two that nothing can move
        const {friction} = contacts.material(a.id, b.id);
        for (const mine of this.geoms_of(a)) for (const other of this.geoms_of(b))
          lines.push(`<pair geom1="${mine}" geom2="${other}" condim="${friction > 0 ? 3 : 1}" friction="${t([friction, friction, 0, 0, 0])}"/>`);
        if (lines.length > most_pairs) throw new Unsupported(`Pairs that differ are listed one by one; this adapter lists at most ${most_pairs}.`);
      }
    }
    this.out.push('<contact>', ...lines, '</contact>');
  }

  distances() { return this.forest.loops.filter((j) => this.scene.joints[j].type === 'distance'); }

  loops() {
    const tendons = [], equalities = [], {joints, bodies} = this.scene;
    for (const j of this.forest.loops) {
      const joint = joints[j];
      if (joint.type === 'distance') {
        const end = joint.to < 0 ? joint.point : bodies[joint.to].position;
        const off = joint.length - norm(sub(end, bodies[joint.body].position));
        tendons.push(`<spatial name="t${j}"><site site="s${j}_0"/><site site="s${j}_1"/></spatial>`);
        equalities.push(`<tendon tendon1="t${j}" polycoef="${t([off, 0, 0, 0, 0])}"/>`);
      } else if (joint.type === 'fixed') equalities.push(`<weld ${this.ends(joint)}/>`);
      else {
        equalities.push(this.connect(joint, joint.point));
        if (joint.type === 'hinge') equalities.push(this.connect(joint, add(joint.point, joint.axis)));  // two points of its axis
      }
    }
    if (tendons.length) this.out.push(`<tendon>${tendons.join('')}</tendon>`);
    if (equalities.length) this.out.push(`<equality>${equalities.join('')}</equality>`);
  }

  // The body that moves comes first; the world is left out.
  ends(joint) {
    const first = this.moves(joint.body) ? joint.body : joint.to, second = first === joint.body ? joint.to : joint.body;
    return `body1="${body_name(first)}"` + (this.moves(second) ? ` body2="${body_name(second)}"` : '');
  }

  connect(joint, point) {
    const start = this.scene.bodies[this.moves(joint.body) ? joint.body : joint.to];
    return `<connect ${this.ends(joint)} anchor="${t(rotate(conjugate(start.orientation), sub(point, start.position)))}"/>`;
  }
}

export const model_of = (scene, forest, values, dt) => new Writer(scene, forest, values, dt).xml();
