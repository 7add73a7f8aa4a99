// The laws of a scene that the engines do not have, as forces of the state before a step, constant during it: springs,
// drag, thrust, changing mass, drive, attraction, water's constant lift, a gravity of a body's own, a frame of reference
// that turns or accelerates, and the smooth law along the coordinates of joints.
// The same laws as reference/applied/forces.cc, for engines in JavaScript.  Knows no engine.
import {JointForces, acting, has_force} from './joints.mjs';
import {add, cross, dot, is_zero, norm, rotate, scale, sub, world_times} from './vectors.mjs';

const none = [0, 0, 0];

/** Whether a frame has fictitious forces. */
export const pushes = (frame) => frame !== undefined &&
  !['acceleration', 'angular_velocity', 'angular_acceleration'].every((key) => is_zero(frame[key] ?? none));

/** Why not all forces of a scene can be applied, or nothing. */
export function unmapped(scene) {
  if (scene.water.some((water) => water.mode !== 'step'))
    return "Water by Archimedes' law needs the submerged part of a shape, which this worker does not compute; it has the mode 'step'.";
}

export const settings = (scene_has_any) => scene_has_any ? [{
  name: 'springs, drag, thrust, drive, attraction, water, own gravity, forces along joints, forces of a frame that turns or accelerates', value: 'force of the state before the step',
  reason: 'the engine has no such forces; they are constant during the step, and so is a mass that changes',
}] : [];

/** Of one body: force through the centre of mass [N] and torque about it [N m], world axes. */
class Wrench {
  force = [0, 0, 0];
  torque = [0, 0, 0];
  push(arm, force) {
    this.force = add(this.force, force);
    this.torque = add(this.torque, cross(arm, force));
  }
  turn(torque) { this.torque = add(this.torque, torque); }
}

/** Lists of a scene whose elements are forces; each is a method of Forces. */
export const laws = ['spring', 'drag', 'thrust', 'drive', 'attraction', 'water'];

/** Whether anything of a scene is to be applied before a step. */
export const has_forces = (scene) =>
  pushes(scene.frame) || laws.some((law) => scene[law].length > 0) || scene.bodies.some((body) => body.gravity) ||
  scene.joints.some((joint) => acting(joint).some(({acts}) => has_force(acts)));

export class Forces {
  /** Of a scene as scene.mjs prepares it. */
  constructor(scene) {
    this.scene = scene;
    this.masses = scene.bodies.map((b) => b.mass);
    this.rates = scene.bodies.map(() => 0);
    for (const thrust of scene.thrust)
      if (thrust.mass_rate && !scene.bodies[thrust.body].locked) this.rates[thrust.body] += thrust.mass_rate;
    /** Bodies whose mass changes. */
    this.changing = scene.bodies.map((b) => b.index).filter((i) => this.rates[i] !== 0);
    /** Whether anything is to be applied before a step. */
    this.any = has_forces(scene);
    this.along_joints = new JointForces(scene);
  }

  /** A wrench per body, of the states {position, orientation, velocity, spin} at t [s].  Throws where a mass is used up. */
  at(t, states) {
    for (const i of this.changing) {
      const body = this.scene.bodies[i];
      this.masses[i] = body.mass + t * this.rates[i];
      if (!(this.masses[i] > 0)) throw new Error(`the mass of '${body.name}' is ${this.masses[i]} kg at t = ${t} s`);
    }
    const wrenches = states.map(() => new Wrench());
    for (const law of laws)
      for (const one of this.scene[law]) this[law](one, t, states, wrenches);
    for (const {index, gravity} of this.scene.bodies)
      if (gravity) wrenches[index].push(none, scale(this.masses[index], gravity));
    if (pushes(this.scene.frame)) this.frame(this.scene.frame, t, states, wrenches);
    this.along_joints.add(t, states, wrenches);
    return wrenches;
  }

  // A point of a body, or of the world, and its velocity.
  point(states, body, anchor) {
    if (body < 0) return {arm: none, position: anchor, velocity: none};
    const s = states[body], arm = rotate(s.orientation, anchor);
    return {arm, position: add(s.position, arm), velocity: add(s.velocity, cross(s.spin, arm))};
  }

  // F = (k (|d| - L) + c d|d|/dt) d/|d|, with the share of k alone as k d: a spring without rest length and damping has no
  // other rounding than that.
  spring(spring, t, states, wrenches) {
    const a = this.point(states, spring.body, spring.anchor), b = this.point(states, spring.to, spring.to_anchor);
    const d = sub(b.position, a.position), length = norm(d);
    if (length === 0) return;
    const rate = dot(sub(b.velocity, a.velocity), d) / length;
    const force = scale(spring.stiffness + (spring.damping * rate - spring.stiffness * spring.rest_length) / length, d);
    wrenches[spring.body].push(a.arm, force);
    if (spring.to >= 0) wrenches[spring.to].push(b.arm, scale(-1, force));
  }

  // F = -linear v;  torque = -angular w - momentum I w
  drag(drag, t, states, wrenches) {
    const s = states[drag.body], wrench = wrenches[drag.body];
    wrench.push(none, scale(-drag.linear, s.velocity));
    wrench.turn(scale(-drag.angular, s.spin));
    if (drag.momentum !== 0) wrench.turn(scale(-drag.momentum, this.momentum(drag.body, states)));
  }

  // F = R force + dm/dt c  with c the velocity of the exchanged mass relative to the body:  from
  // d(m v)/dt = dm/dt (v + c).
  thrust(thrust, t, states, wrenches) {
    const s = states[thrust.body];
    let relative = none;
    if (thrust.exhaust_velocity) relative = rotate(s.orientation, thrust.exhaust_velocity);
    if (thrust.exchanged_velocity) relative = sub(thrust.exchanged_velocity, s.velocity);
    const force = add(rotate(s.orientation, thrust.force ?? none), scale(thrust.mass_rate ?? 0, relative));
    wrenches[thrust.body].push(none, force);
  }

  // F = force cos(frequency t)
  drive(drive, t, states, wrenches) {
    wrenches[drive.body].push(none, scale(Math.cos(drive.frequency * t), drive.force));
  }

  // F = strength m_a m_b d/|d|^3
  attraction(attraction, t, states, wrenches) {
    const d = sub(states[attraction.to].position, states[attraction.body].position), length = norm(d);
    const masses = this.masses[attraction.body] * this.masses[attraction.to];
    const force = scale(attraction.strength * masses / (length * length * length), d);
    wrenches[attraction.body].push(none, force);
    wrenches[attraction.to].push(none, scale(-1, force));
  }

  // Below the cell's height:  F = buoyancy up - drag v,  dL/dt = -L  (1/s).
  //   height_ij = level + wave/2 sin(speed t + i) + wave/2 sin(i j/2),  i = trunc((x + 5 m)/0.25 m) in 0 … 40
  water(water, t, states, wrenches) {
    const cell = (x) => Math.min(40, Math.max(0, Math.trunc((x + 5) / 0.25)));
    for (const body of this.scene.bodies) {
      if (body.locked) continue;
      const s = states[body.index], i = cell(s.position[0]), j = cell(s.position[2]);
      const waves = Math.sin(water.speed * t + i) + Math.sin(i * j / 2);
      if (!(s.position[1] < water.level + water.wave / 2 * waves)) continue;
      wrenches[body.index].push(none, sub([0, water.buoyancy, 0], scale(water.drag, s.velocity)));
      wrenches[body.index].turn(scale(-1, this.momentum(body.index, states)));
    }
  }

  // In a frame that turns with W and whose origin has the acceleration a, an element dm at r feels
  // -dm (a + 2 W x dr/dt + W' x r + W x (W x r)).  Summed over a body with spin w, for which
  // sum dm x (x.W) = (tr(I)/2 - I) W  over its arms x:
  //   F      = -m (a + 2 W x v + W' x r + W x (W x r))
  //   torque = (I W) x W + 2 (I W) x w - tr(I) W x w - I W'
  frame(frame, t, states, wrenches) {
    const faster = frame.angular_acceleration ?? none, turn = add(frame.angular_velocity ?? none, scale(t, faster));
    const push = scale(Math.cos((frame.frequency ?? 0) * t), frame.acceleration ?? none);
    for (const {index: i, inertia} of this.scene.bodies) {
      const s = states[i], along = world_times(inertia, s.orientation, turn);
      const trace = inertia[0] + inertia[4] + inertia[8];
      const inward = add(scale(2, cross(turn, s.velocity)), add(cross(faster, s.position), cross(turn, cross(turn, s.position))));
      wrenches[i].push(none, scale(-this.masses[i], add(push, inward)));
      wrenches[i].turn(add(cross(along, turn), sub(scale(2, cross(along, s.spin)), scale(trace, cross(turn, s.spin)))));
      wrenches[i].turn(scale(-1, world_times(inertia, s.orientation, faster)));
    }
  }

  // I w, world axes.
  momentum(i, states) {
    return world_times(this.scene.bodies[i].inertia, states[i].orientation, states[i].spin);
  }
}
