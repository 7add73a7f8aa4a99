// The gyroscopic torque, for engines that do not have it: where a scene needs it, and by how much.  Knows no engine.
import {Unsupported} from './scene.mjs';
import {cross, norm, world_times} from './vectors.mjs';

/** The sine of the angle between w and I w below which a body turns about a principal axis: what rounding in single
 *  precision leaves of it after a thousand steps (6e-8 each), and not more. */
const about_an_axis = 1e-4;

/** Option of an engine without it. */
export const torque_option = {
  name: 'gyroscopic-torque', setting: 'gyroscopic torque', values: ['refused', 'left-out'], engine_default: 'left-out',
  meaning: 'refused: a scene whose start has such a torque is unsupported, and one that comes to it later says so; left-out: bodies turn without it',
};

/** |w x I w| [N m] of a moving body in a state; 0 where it turns about a principal axis. */
export function gyroscopic_torque(body, {orientation, spin}) {
  const momentum = world_times(body.inertia, orientation, spin), torque = norm(cross(spin, momentum));
  return torque > about_an_axis * norm(spin) * norm(momentum) ? torque : 0;
}

/** What a run without the torque leaves out, by bodies.  Throws Unsupported where the start already has it. */
export class LeftOut {
  constructor(title, scene, path) {
    this.title = title, this.told = new Map();
    for (const body of scene.bodies) {
      const torque = body.locked ? 0 : gyroscopic_torque(body, body);
      if (torque > 0)
        throw new Unsupported(
          `${title} has no gyroscopic torque, and '${body.name}' starts with one of ${torque.toPrecision(4)} N m; path=${path} leaves it out.`);
    }
  }

  see(body, state, step) {
    if (this.told.has(body.name)) return;
    const torque = gyroscopic_torque(body, state);
    if (torque > 0)
      this.told.set(body.name, `'${body.name}', step ${step}: ${this.title} has no gyroscopic torque; one of ${torque.toPrecision(4)} N m is left out here, and others from then on.`);
  }

  remarks() { return [...this.told.values()]; }
}
