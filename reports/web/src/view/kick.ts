// Kicks: digits give a body an impulse, upwards and a little sideways.
import type { Scene, Vector } from '../shared/documents';

const direction: Vector = [0.3 / Math.hypot(0.3, 1), 1 / Math.hypot(0.3, 1), 0];
const turn = (2 * Math.PI) ** 2;

/** The impulse [N s] that changes a body's velocity by `change` [m/s]; null where none does. */
export function kick(scene: Scene, body: number, change: number): Vector | null {
  const b = scene.body[body];
  if (!b || b.locked || !(b.mass > 0) || !Number.isFinite(change)) return null;
  return [b.mass * change * direction[0], b.mass * change * direction[1], 0];
}

/** The angular impulse [N m s] about z that turns a ball of the body's mean moment of inertia by `change` [rad/s]; null where
 * there is none. */
export function spin(scene: Scene, body: number, change: number): Vector | null {
  const b = scene.body[body];
  if (!b || b.locked || !Number.isFinite(change) || change === 0) return null;
  return [0, 0, ((b.inertia[0]! + b.inertia[4]! + b.inertia[8]!) / 3) * change];
}

/** Stiffness [N/m] of a spring on which a body of that mass swings `frequency` times a second. */
export const pullStiffness = (mass: number, frequency: number): number =>
  (mass > 0 ? mass : 1) * turn * frequency ** 2;
