// The coordinates that joints leave free: what acts along them, their values and rates, and the smooth law as forces on
// bodies.  After harness/core/joint_coordinates.cc and reference/applied/joint_forces.cc.  Knows no engine.
import {Unsupported} from './unsupported.mjs';
import {across, add, conjugate, cross, dot, multiply, norm, rotate, scale, sub} from './vectors.mjs';

/** Displacements and angles that a kind leaves free and on which something may act; a ball's turns are none. */
const free = {
  slider: {displacement: 1, angle: 0}, cylindrical: {displacement: 1, angle: 1}, planar: {displacement: 2, angle: 1},
  universal: {displacement: 0, angle: 2}, gimbal: {displacement: 0, angle: 3},
  offset_universal: {displacement: 0, angle: 2}, rectangular: {displacement: 2, angle: 0}, screw: {displacement: 1, angle: 1}, hinge: {displacement: 0, angle: 1},
};

export const has_limit = (c) => c.lower !== undefined || c.upper !== undefined;
export const has_force = (c) => c.force !== 0 || c.stiffness !== 0 || c.damping !== 0 || c.quadratic_damping !== 0;

/** What a joint keeps from moving: a gimbal's angles are counted, and it turns as a ball does. */
export const kept = ({type}) => (type === 'gimbal' ? 'ball' : type);
/** Kinds that turn about an axis of `to` and one of `body`. */
export const between_axes = ['universal', 'gimbal', 'offset_universal'];
export const ordinals = ['first', 'second', 'third'];

/** {slides, which: 0, 1, 2, acts} of each coordinate that a joint leaves free, displacements first; `acts` is the scene's, or
 *  undefined where nothing acts. */
export function coordinates(joint) {
  const list = [];
  for (const kind of ['displacement', 'angle'])
    for (let k = 0; k < (free[joint.type]?.[kind] ?? 0); ++k)
      list.push({slides: kind === 'displacement', which: k, acts: (joint[kind] ?? []).find((c) => c.which === ordinals[k])});
  return list;
}
/** A ball, or a gimbal on which nothing acts. */
export const is_ball = (joint) => joint.type === 'ball' || (joint.type === 'gimbal' && !joint.angle?.length);
export const acting = (joint) => coordinates(joint).filter(({acts}) => acts);

/** Least and largest displacement or angle since t = 0; infinite where there is no limit. */
export const range = (c) => ({
  lower: c.lower === undefined ? -Infinity : c.lower - c.start, upper: c.upper === undefined ? Infinity : c.upper - c.start});

/** What holds the one coordinate of a hinge or a slider, or undefined: {lower, upper, limited, restitution, friction}; of
 *  `body` against `to`, or with `other_way` of `to` against `body`. */
export function held_coordinate(joint, other_way = false) {
  const [one] = acting(joint);
  if (!one || !(has_limit(one.acts) || one.acts.friction !== 0)) return undefined;
  const acts = other_way ? reversed(one.acts) : one.acts;
  return {...range(acts), limited: has_limit(acts), restitution: acts.restitution, friction: acts.friction};
}

/** Where a joint holds `body` at t = 0, world coordinates: its point, but of one with an offset. */
export function point_of_body(joint) {
  if (joint.type !== 'offset_universal') return joint.point;
  const [, , normal] = frame_of(joint);
  return add(joint.point, scale(joint.length, normal));
}

/** Right-handed axes of a joint: x the stated axis; y its second, of a gimbal the part square to the first, or any across it. */
export function frame_of(joint) {
  const unit = (v) => scale(1 / norm(v), v), x = unit(joint.axis), square = (v) => sub(v, scale(dot(v, x), x));
  const y = joint.axis_2 ? unit(joint.type === 'gimbal' ? square(joint.axis_2) : joint.axis_2) : across(x);
  return [x, y, cross(x, y)];
}

/** The same coordinate counted the other way: q -> -q. */
export function reversed(c) {
  const less = (x) => (x === undefined ? undefined : -x);
  return {...c, start: -c.start, force: -c.force, target: -c.target, target_amplitude: -c.target_amplitude,
    target_values: c.target_values?.map(less), lower: less(c.upper), upper: less(c.lower)};
}

/** The words of the protocol for what an engine has: {types, limits, friction: kinds of joints, rotors: whether it has them,
 *  counts_turns: of limits, why: reasons by kind}. */
export const known_joints = ({types, limits, friction, rotors}) => [
  ...['slider', 'cylindrical', 'planar', 'universal', 'screw', 'gimbal', 'rectangular', 'offset_universal'].filter((type) => types.includes(kept({type}))).map((type) => `${type}_joints`),
  'joint_forces', 'joint_targets', ...(limits.length ? ['joint_limits'] : []), ...(friction.length ? ['joint_friction'] : []), ...(rotors ? ['joint_armature'] : [])];

/** Throws Unsupported where a joint has what the engine has not. */
export function require_joints({title, joints: can}, scene) {
  const moves = (i) => i >= 0 && !scene.bodies[i].locked;
  for (const joint of scene.joints) {
    if (!moves(joint.body) && !moves(joint.to)) continue;  // it holds nothing
    if (!can.types.includes(kept(joint))) throw new Unsupported(can.why?.[joint.type] ?? `This adapter gives ${title} no ${joint.type} joint.`);
    const of = `The ${joint.type} joint of '${scene.bodies[joint.body].name}'`;
    for (const {slides, acts} of acting(joint)) {
      if (has_limit(acts) && acts.restitution > 0)  // none of them has it
        throw new Unsupported(`${of} bounces from its limits by ${acts.restitution}, and ${title} has no restitution of limits.`);
      if (has_limit(acts) && !can.limits.includes(joint.type))
        throw new Unsupported(`${of} has limits, which this adapter gives ${title} for ${can.limits.join(' and ')} joints alone.`);
      if (acts.friction !== 0 && !can.friction.includes(joint.type))
        throw new Unsupported(`${of} has dry friction, which this adapter gives ${title} for ${can.friction.join(' and ')} joints alone.`);
      const {lower, upper} = range(acts);
      if (has_limit(acts) && !slides && !can.counts_turns && !(Math.max(-lower, upper) < Math.PI))
        throw new Unsupported(`${of} has no limit within half a turn on one side, and ${title} counts no whole turns.`);
    }
  }
}

// ---- Where a joint is ---------------------------------------------------------------------------------

/** A joint of a prepared scene as its bodies carry it. */
class Held {
  constructor(scene, joint) {
    const turn = (i) => (i < 0 ? [1, 0, 0, 0] : scene.bodies[i].orientation);
    const in_axes = (i, v) => v && rotate(conjugate(turn(i)), scale(1 / Math.hypot(...v), v));
    const anchor = (i, point) => (i < 0 ? point : rotate(conjugate(turn(i)), sub(point, scene.bodies[i].position)));
    this.joint = joint;
    this.second_axis = joint.axis_2 !== undefined;
    this.anchor = anchor(joint.body, point_of_body(joint)), this.to_anchor = anchor(joint.to, joint.point);
    this.to_axis = in_axes(joint.to, joint.axis), this.to_axis_2 = in_axes(joint.to, joint.axis_2);
    this.axis_2 = in_axes(joint.body, joint.axis_2);
    this.turn = multiply(conjugate(turn(joint.to)), turn(joint.body));
  }

  end(states, i, anchor) {
    if (i < 0) return {orientation: [1, 0, 0, 0], spin: [0, 0, 0], position: anchor, velocity: [0, 0, 0]};
    const {position, orientation, velocity, spin} = states[i], arm = rotate(orientation, anchor);
    return {orientation, spin, position: add(position, arm), velocity: add(velocity, cross(spin, arm))};
  }
  ends(states) { return [this.end(states, this.joint.body, this.anchor), this.end(states, this.joint.to, this.to_anchor)]; }

  /** The direction of a displacement, axes of `to`. */
  direction(which) {
    if (!this.second_axis) return this.to_axis;
    return which === 1 ? cross(this.to_axis, this.to_axis_2) : this.to_axis_2;
  }

  // q = n.d,  q' = n.(d' - w_to x d),  n fixed in `to`
  displacement([a, b], which) {
    const d = sub(a.position, b.position), n = rotate(b.orientation, this.direction(which));
    return {value: dot(d, n), rate: dot(sub(sub(a.velocity, b.velocity), cross(b.spin, d)), n), along: n, at: a.position};
  }

  // About two axes h, u,  R = R(h, a) R(h x u, b) R(u, c):  R u and R^T h tell a and c by their parts square to h and to u,
  // b is what the angle between h and R u has grown; a rate is the spin along what is square to the axes of the others.
  angle([a, b], which) {
    const turn = multiply(multiply(conjugate(b.orientation), a.orientation), conjugate(this.turn));
    const h = this.to_axis, u = this.to_axis_2;
    const along = this.along(rotate(b.orientation, h), u && rotate(a.orientation, this.axis_2), which);
    const rate = dot(sub(a.spin, b.spin), along), square = (v, to) => sub(v, scale(dot(v, to), to));
    if (!between_axes.includes(this.joint.type)) return {value: 2 * Math.atan2(dot(turn.slice(1), h), turn[0]), rate, along};
    const opening = (v) => Math.atan2(norm(cross(h, v)), dot(h, v));
    if (which === 2) return {value: opening(rotate(turn, u)) - opening(u), rate, along};
    const now = which === 1 ? rotate(conjugate(turn), h) : rotate(turn, u);
    return {value: which === 1 ? Math.atan2(-dot(now, cross(u, h)), dot(now, square(h, u)))
      : Math.atan2(dot(now, cross(h, u)), dot(now, square(u, h))), rate, along};
  }
  along(h, u, which) {
    if (this.joint.type !== 'gimbal') return which === 1 ? u : h;
    const n = cross(h, u), sine = norm(n), s = dot(h, u);
    return which === 2 ? scale(1 / sine, n) : scale(1 / sine ** 2, which === 0 ? sub(h, scale(s, u)) : sub(u, scale(s, h)));
  }
}

/** Rates of the coordinates of a joint at t = 0, in the order of coordinates(). */
export function rates_at_start(scene, joint) {
  const held = new Held(scene, joint), ends = held.ends(scene.bodies);
  return coordinates(joint).map(({slides, which}) => (slides ? held.displacement(ends, which) : held.angle(ends, which)).rate);
}

// ---- The smooth law -----------------------------------------------------------------------------------

/** Where the spring of a coordinate is without force at t, and how fast that moves. */
function target(c, t) {
  const {target_times: times, target_values: values} = c;
  if (!times?.length) {
    const phase = c.target_frequency * t + c.target_phase;
    return [c.target + c.target_amplitude * Math.cos(phase), -c.target_amplitude * c.target_frequency * Math.sin(phase)];
  }
  const next = times.findIndex((time) => time > t);
  if (next === 0) return [values[0], 0];
  if (next < 0) return [values.at(-1), 0];
  const slope = (values[next] - values[next - 1]) / (times[next] - times[next - 1]);
  return [values[next - 1] + slope * (t - times[next - 1]), slope];
}

const turn = 2 * Math.PI;

export class JointForces {
  /** Of a prepared scene. */
  constructor(scene) {
    this.joints = [];
    for (const joint of scene.joints) {
      const forced = acting(joint).filter(({acts}) => has_force(acts)).map((one) => ({...one, angle: 0}));
      if (forced.length > 0) this.joints.push({held: new Held(scene, joint), forced});
    }
  }

  /** Q = force - k (q - target(t)) - c (q' - target'(t)) - c2 q' |q'|  along each coordinate.  An angle is counted on from
   *  the state before: between two calls it changes by less than half a turn. */
  add(t, states, wrenches) {
    for (const {held, forced} of this.joints) {
      const ends = held.ends(states), {body, to} = held.joint;
      for (const one of forced) {
        const {value, rate, along, at} = one.slides ? held.displacement(ends, one.which) : held.angle(ends, one.which);
        if (!one.slides) one.angle += value - one.angle - turn * Math.round((value - one.angle) / turn);
        const c = one.acts, q = c.start + (one.slides ? value : one.angle), [rest, moves] = target(c, t);
        const Q = c.force - c.stiffness * (q - rest) - c.damping * (rate - moves) - c.quadratic_damping * rate * Math.abs(rate);
        for (const [i, sign] of [[body, 1], [to, -1]]) {
          if (i < 0) continue;
          const push = scale(sign * Q, along);
          // Both at the point of `body`, so that the power is Q q'.
          if (one.slides) wrenches[i].push(sub(at, states[i].position), push);
          else wrenches[i].turn(push);
        }
      }
    }
  }
}
